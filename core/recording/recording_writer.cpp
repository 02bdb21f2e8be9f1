// The recording thread and the ring buffer.
#include "core/recording/recording_writer.h"

#include "core/base/whole_file.h"

#include <utility>

namespace edgescan {
namespace {

using SteadyClock = std::chrono::steady_clock;
constexpr auto kWakesEvery = std::chrono::milliseconds(50); // while a chunk is open
constexpr std::size_t kMessageOverhead = 64;

std::size_t sizeOf(const RecordingMessage& message) { return message.payload.size() + kMessageOverhead; }

RecordingMessagePtr frameMessage(RecordingTopic topic, const ColaFrame& frame, const RecordingClock& clock) {
    return std::make_shared<const RecordingMessage>(RecordingMessage{topic, clock.ns(frame.received), frame.bytes});
}

} // namespace

RecordingMessagePtr receivedMessage(const ColaFrame& frame, const RecordingClock& clock) {
    return frameMessage(RecordingTopic::ColaRx, frame, clock);
}

RecordingMessagePtr sentMessage(const ColaFrame& frame, const RecordingClock& clock) {
    return frameMessage(RecordingTopic::ColaTx, frame, clock);
}

RecordingMessagePtr stepperMessage(const StepperReading& reading) {
    return std::make_shared<const RecordingMessage>(RecordingMessage{RecordingTopic::Stepper, reading.hostNs, stepperJson(reading)});
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::start(const std::filesystem::path& path, const SweepMetadata& metadata,
                                                                Options options) {
    auto file = GrowingFile::create(path);
    if (!file) return file.error();
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(std::move(*file), metadata, std::move(options)));
    // The head goes to the disk before anybody relies on it.
    if (!writer->write()) {
        Error problem = *writer->state_.problem;
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        return problem;
    }
    writer->thread_ = std::thread([w = writer.get()] { w->loop(); });
    return writer;
}

RecordingWriter::RecordingWriter(GrowingFile file, const SweepMetadata& metadata, Options options)
    : file_(std::move(file)), encoder_(metadata, options.limits), options_(std::move(options)) {}

RecordingWriter::~RecordingWriter() {
    if (thread_.joinable()) static_cast<void>(close());
}

void RecordingWriter::post(RecordingMessagePtr message) {
    const std::size_t size = sizeOf(*message);
    {
        const std::lock_guard lock(mutex_);
        if (closing_ || state_.ended || state_.waiting + size > options_.queueBytes) {
            ++state_.dropped;
            if (!closing_ && !state_.ended && !state_.problem) {
                state_.problem = Error{"the disk is slower than the scanner, telegrams are missing in the recording", file_.path().string(),
                                       "record on another disk"};
            }
        } else {
            state_.waiting += size;
            queue_.push_back(std::move(message));
        }
    }
    wake_.notify_one();
}

RecordingState RecordingWriter::state() const {
    const std::lock_guard lock(mutex_);
    RecordingState now = state_;
    now.dropped += unwritten_;
    return now;
}

void RecordingWriter::loop() {
    for (bool last = false; !last;) {
        std::vector<RecordingMessagePtr> messages;
        {
            std::unique_lock lock(mutex_);
            const auto something = [&] { return closing_ || !queue_.empty(); };
            if (chunkSince_)
                wake_.wait_for(lock, kWakesEvery, something);
            else
                wake_.wait(lock, something);
            messages.swap(queue_);
            last = closing_;
        }
        encode(messages);
        const auto longest = std::chrono::nanoseconds(options_.limits.chunkNs);
        if (chunkSince_ && SteadyClock::now() - *chunkSince_ >= longest) encoder_.endChunk();
        if (last) encoder_.finish();
        static_cast<void>(write()); // a failure is in the state
        if (encoder_.openMessages() == 0) chunkSince_.reset();
    }
}

void RecordingWriter::encode(const std::vector<RecordingMessagePtr>& messages) {
    std::uint64_t size = 0;
    for (const RecordingMessagePtr& message : messages) {
        encoder_.message(*message);
        size += sizeOf(*message);
        ++encoded_;
        if (!chunkSince_ || encoder_.openMessages() == 1) chunkSince_ = SteadyClock::now();
        if (encoder_.openMessages() == 1) static_cast<void>(write()); // the chunk before this message; a failure is in the state
    }
    const std::lock_guard lock(mutex_);
    state_.waiting -= size;
    if (state_.ended) unwritten_ = encoded_ - state_.messages;
}

/// What the encoder has ready goes to the disk. False: it cannot.
bool RecordingWriter::write() {
    const Bytes bytes = encoder_.take();
    if (bytes.empty()) return true;
    {
        const std::lock_guard lock(mutex_);
        if (state_.ended) return false;
    }
    const Result<Done> written = file_.append(bytes);
    const std::lock_guard lock(mutex_);
    if (!written) {
        if (!state_.problem) state_.problem = written.error();
        state_.ended = true;
        unwritten_ = encoded_ - state_.messages;
        return false;
    }
    state_.bytes = file_.size();
    state_.messages = encoded_ - encoder_.openMessages();
    return true;
}

Result<Done> RecordingWriter::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
    const std::lock_guard lock(mutex_);
    if (state_.problem) return *state_.problem;
    return Done{};
}

void RecentMessages::push(RecordingMessagePtr message) {
    const std::lock_guard lock(mutex_);
    const std::int64_t now = message->hostNs;
    bytes_ += sizeOf(*message);
    messages_.push_back(std::move(message));
    while (!messages_.empty() && (bytes_ > keptBytes_ || messages_.front()->hostNs < now - keptNs_)) {
        bytes_ -= sizeOf(*messages_.front());
        messages_.pop_front();
    }
}

std::vector<RecordingMessagePtr> RecentMessages::messages() const {
    const std::lock_guard lock(mutex_);
    return {messages_.begin(), messages_.end()};
}

std::size_t RecentMessages::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

Bytes recordingBytes(const SweepMetadata& metadata, const std::vector<RecordingMessagePtr>& messages) {
    RecordingEncoder encoder(metadata);
    for (const RecordingMessagePtr& message : messages) encoder.message(*message);
    encoder.finish();
    return encoder.take();
}

Result<Done> saveMessages(const std::filesystem::path& path, const SweepMetadata& metadata,
                          const std::vector<RecordingMessagePtr>& messages) {
    const Bytes bytes = recordingBytes(metadata, messages);
    return writeWholeFile(path, std::as_bytes(std::span(bytes)));
}

} // namespace edgescan
