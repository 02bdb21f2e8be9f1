// The recording thread and the ring buffer.
#include "core/files/recording/writer.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/whole_file.h"

#include <condition_variable>
#include <tuple>
#include <utility>

namespace edgescan::files {
namespace {

using SteadyClock = std::chrono::steady_clock;
constexpr auto kWakesEvery = std::chrono::milliseconds(50); // while a chunk is open
constexpr std::size_t kMessageOverhead = 112;               // of a message in memory, besides its payload

std::size_t sizeOf(const RecordingMessage& message) { return message.payload.size() + kMessageOverhead; }

RecordingMessagePtr frameMessage(RecordingTopic topic, const scanner::ColaFrame& frame, const RecordingClock& clock) {
    return std::make_shared<const RecordingMessage>(RecordingMessage{topic, clock.ns(frame.received), frame.bytes});
}

} // namespace

RecordingMessagePtr receivedMessage(const scanner::ColaFrame& frame, const RecordingClock& clock) {
    return frameMessage(RecordingTopic::ColaRx, frame, clock);
}

RecordingMessagePtr sentMessage(const scanner::ColaFrame& frame, const RecordingClock& clock) {
    return frameMessage(RecordingTopic::ColaTx, frame, clock);
}

RecordingMessagePtr stepperMessage(const scanner::StepperReading& reading) {
    return std::make_shared<const RecordingMessage>(RecordingMessage{RecordingTopic::Stepper, reading.hostNs, stepperJson(reading)});
}

std::string lagText(const RecordingState& state) {
    constexpr double kTold = 2.0; // seconds
    if (state.lagSeconds < kTold) return {};
    const double behind = static_cast<double>(state.waiting + state.unsynced()) / 1e6;
    return withValues("the disk is %1 s behind (%2 MB)", {fixedText(state.lagSeconds, 0), fixedText(behind, 1)});
}

struct RecordingWriter::Work {
    Work(containers::GrowingFile opened, const scanner::SweepMetadata& metadata, Options given)
        : file(std::move(opened)), encoder(metadata, given.limits), options(std::move(given)) {}

    void writeLoop();
    void syncLoop();
    void encode(const std::vector<RecordingMessagePtr>& messages);
    bool write();
    void fail(const Error& problem, bool end);
    [[nodiscard]] double lagAt(SteadyClock::time_point now) const;

    // Used by the writing thread alone; the file's sync() by the other one.
    containers::GrowingFile file;
    RecordingEncoder encoder;
    std::optional<SteadyClock::time_point> chunkSince;
    std::uint64_t encoded = 0;

    const Options options;
    mutable std::mutex mutex;
    std::condition_variable wake;    // something to write, or closing
    std::condition_variable written; // something to sync, or an end
    std::vector<RecordingMessagePtr> queue;
    RecordingState state;
    std::uint64_t taken = 0;                                // messages from the queue: written, or lost with a disk that ended
    std::optional<SteadyClock::time_point> postedSince;     // of the oldest message that is not written
    std::optional<SteadyClock::time_point> unsyncedSince;   // when the oldest byte was written that is not synced
    std::optional<SteadyClock::time_point> writtenSinceAsk; // the same of those written since the last sync began
    bool closing = false;
    bool abandoned = false; // no thread waits for the disk any more
    bool allWritten = false, allSynced = false;
};

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::start(const std::filesystem::path& path, const scanner::SweepMetadata& metadata,
                                                                Options options) {
    auto file = containers::GrowingFile::create(path, options.disk);
    if (!file) return file.error();
    const auto work = std::make_shared<Work>(std::move(*file), metadata, std::move(options));
    // The head is there before anybody relies on it.
    if (!work->write()) {
        work->file.removeName();
        return *work->state.problem;
    }
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(work));
    writer->writing_ = std::thread([work] { work->writeLoop(); });
    writer->syncing_ = std::thread([work] { work->syncLoop(); });
    return writer;
}

RecordingWriter::~RecordingWriter() { static_cast<void>(close()); }

void RecordingWriter::post(RecordingMessagePtr message) {
    const std::size_t size = sizeOf(*message);
    Work& work = *work_;
    {
        const std::lock_guard lock(work.mutex);
        if (work.closing || work.state.ended || work.state.waiting + size > work.options.queueBytes) {
            ++work.state.dropped;
            if (!work.closing && !work.state.ended)
                work.fail({"the disk is slower than the scanner, telegrams are missing in the recording", work.file.path().string(),
                           "record on another disk"},
                          false);
        } else {
            if (!work.postedSince) work.postedSince = SteadyClock::now();
            work.state.waiting += size;
            work.queue.push_back(std::move(message));
        }
    }
    work.wake.notify_one();
}

/// Under the lock.
void RecordingWriter::Work::fail(const Error& problem, bool end) {
    if (!state.problem) state.problem = problem;
    state.ended = state.ended || end;
}

double RecordingWriter::Work::lagAt(SteadyClock::time_point now) const {
    auto since = now;
    if (postedSince) since = std::min(since, *postedSince);
    if (unsyncedSince) since = std::min(since, *unsyncedSince);
    return std::chrono::duration<double>(now - since).count();
}

RecordingState RecordingWriter::state() const {
    const std::lock_guard lock(work_->mutex);
    RecordingState now = work_->state;
    if (now.ended) now.dropped += work_->taken - now.messages;
    now.lagSeconds = work_->lagAt(SteadyClock::now());
    now.worstLagSeconds = std::max(now.worstLagSeconds, now.lagSeconds);
    return now;
}

void RecordingWriter::Work::writeLoop() {
    for (bool last = false; !last;) {
        std::vector<RecordingMessagePtr> messages;
        {
            std::unique_lock lock(mutex);
            const auto something = [&] { return closing || !queue.empty(); };
            if (chunkSince)
                wake.wait_for(lock, kWakesEvery, something);
            else
                wake.wait(lock, something);
            messages.swap(queue);
            taken += messages.size();
            last = closing;
        }
        encode(messages);
        const auto longest = std::chrono::nanoseconds(options.limits.chunkNs);
        if (chunkSince && SteadyClock::now() - *chunkSince >= longest) encoder.endChunk();
        if (last) encoder.finish();
        static_cast<void>(write()); // a failure is in the state
        if (encoder.openMessages() == 0) chunkSince.reset();
        const std::lock_guard lock(mutex);
        postedSince = chunkSince;
        if (!postedSince && !queue.empty()) postedSince = SteadyClock::now();
        allWritten = last;
    }
    written.notify_all();
}

/// Whatever was written while the disk was busy is one request to it.
void RecordingWriter::Work::syncLoop() {
    file.syncFolder();
    for (bool failed = false; !failed;) {
        std::uint64_t asked = 0;
        {
            std::unique_lock lock(mutex);
            written.wait(lock, [&] { return abandoned || allWritten || state.bytes > state.syncedBytes; });
            if (abandoned || state.bytes == state.syncedBytes) break;
            asked = state.bytes;
            writtenSinceAsk.reset();
        }
        const Result<Done> synced = file.sync();
        const std::lock_guard lock(mutex);
        state.worstLagSeconds = std::max(state.worstLagSeconds, lagAt(SteadyClock::now()));
        if (synced) {
            state.syncedBytes = asked;
            unsyncedSince = writtenSinceAsk;
        } else {
            fail(synced.error(), true);
            failed = true;
        }
    }
    {
        const std::lock_guard lock(mutex);
        allSynced = true;
    }
    written.notify_all();
}

void RecordingWriter::Work::encode(const std::vector<RecordingMessagePtr>& messages) {
    std::uint64_t size = 0;
    for (const RecordingMessagePtr& message : messages) {
        encoder.message(*message);
        size += sizeOf(*message);
        ++encoded;
        if (!chunkSince || encoder.openMessages() == 1) chunkSince = SteadyClock::now();
        if (encoder.openMessages() == 1) static_cast<void>(write()); // the chunk before this message; a failure is in the state
    }
    const std::lock_guard lock(mutex);
    state.waiting -= size;
}

/// What the encoder has ready goes to the file. False: it cannot.
bool RecordingWriter::Work::write() {
    const Bytes bytes = encoder.popBytes();
    if (bytes.empty()) return true;
    {
        const std::lock_guard lock(mutex);
        if (state.ended || abandoned) return false;
    }
    const Result<Done> appended = file.append(bytes);
    {
        const std::lock_guard lock(mutex);
        if (!appended) {
            fail(appended.error(), true);
        } else {
            state.bytes = file.size();
            state.messages = encoded - encoder.openMessages();
            const auto now = SteadyClock::now();
            if (!unsyncedSince) unsyncedSince = now;
            if (!writtenSinceAsk) writtenSinceAsk = now;
        }
    }
    written.notify_all();
    return static_cast<bool>(appended);
}

Result<Done> RecordingWriter::close() {
    Work& work = *work_;
    std::unique_lock lock(work.mutex);
    work.closing = true;
    work.wake.notify_one();
    const auto latest = SteadyClock::now() + (work.abandoned ? std::chrono::milliseconds(0) : work.options.closeWithin);
    const bool written = work.written.wait_until(lock, latest, [&] { return work.allWritten; });
    const bool synced = work.written.wait_until(lock, latest, [&] { return work.allSynced; });
    if (!written && !work.abandoned) {
        work.fail({"the disk did not take the end of the recording, what it has is cut off", work.file.path().string(),
                   "check the disk; the file opens with what was written"},
                  true);
        work.state.dropped += work.queue.size();
        work.queue.clear();
    }
    work.abandoned = work.abandoned || !synced;
    lock.unlock();
    work.written.notify_all();
    // A disk that hangs keeps its thread; what the thread uses stays with it.
    for (auto& [thread, done] : {std::tuple(&writing_, written), std::tuple(&syncing_, synced)}) {
        if (!thread->joinable()) continue;
        if (done)
            thread->join();
        else
            thread->detach();
    }
    lock.lock();
    if (work.state.problem) return *work.state.problem;
    return Done{};
}

void RecordingWriter::closeAndRemove() {
    static_cast<void>(close());
    work_->file.removeName();
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

Bytes recordingBytes(const scanner::SweepMetadata& metadata, const std::vector<RecordingMessagePtr>& messages) {
    RecordingEncoder encoder(metadata);
    for (const RecordingMessagePtr& message : messages) encoder.message(*message);
    encoder.finish();
    return encoder.popBytes();
}

Result<Done> saveMessages(const std::filesystem::path& path, const scanner::SweepMetadata& metadata,
                          const std::vector<RecordingMessagePtr>& messages) {
    const Bytes bytes = recordingBytes(metadata, messages);
    return writeWholeFile(path, std::as_bytes(std::span(bytes)));
}

} // namespace edgescan::files
