// A scanner from its socket to a growing scan.
#include "core/files/live_feed/live_feed.h"

#include <algorithm>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kLinesOfRate = 64;         // that the rate is taken from
constexpr std::int64_t kKeptNs = 60'000'000'000; // "keep what just happened"

} // namespace

LiveFeed::LiveFeed(scanner::ConnectionSettings scanner, const scanner::SweepSettings& sweep, std::function<void()> changed,
                   const LiveLimits& limits)
    : changed_(std::move(changed)), mostLines_(limits.lines), sweepSettings_(sweep), recent_(kKeptNs, limits.keptBytes), feed_(sweep) {
    scanner::ConnectionEvents events;
    events.stateChanged = [this](const scanner::ConnectionState& state) {
        {
            const std::lock_guard lock(mutex_);
            state_ = state;
            if (state.phase == scanner::ConnectionPhase::Lost) feed_.assembler().reconnected();
        }
        changed_();
    };
    events.identified = [this](const scanner::ScannerIdentity& identity) {
        {
            const std::lock_guard lock(mutex_);
            identity_ = identity;
        }
        changed_();
    };
    events.frameReceived = [this](const scanner::ColaFrame& frame) { received(frame); };
    events.frameSent = [this](const scanner::ColaFrame& frame) { record(sentMessage(frame, clock_)); };
    connection_ = std::make_unique<scanner::ScannerConnection>(std::move(scanner), std::move(events));
}

LiveFeed::~LiveFeed() { connection_->stop(); }

void LiveFeed::record(RecordingMessagePtr message) {
    const std::lock_guard lock(mutex_);
    recent_.push(message);
    if (recorder_) recorder_->post(std::move(message));
}

bool LiveFeed::comesAfterTheLast(const scanner::ColaFrame& frame) {
    const std::lock_guard lock(mutex_);
    if (mostLines_ == 0 || lines_ < mostLines_) return false;
    if (scanner::isScanTelegram(frame.payload())) ++linesAfter_;
    return true;
}

void LiveFeed::received(const scanner::ColaFrame& frame) {
    if (comesAfterTheLast(frame)) return;
    const RecordingMessagePtr message = receivedMessage(frame, clock_);
    record(message); // before anything looks into it
    bool line = false;
    {
        const std::lock_guard lock(mutex_);
        const int before = feed_.assembler().sweepNumber();
        line = feed_.frame(frame, clock_.ns(frame.received));
        // At a reversal some of the new sweep came before; they are few, and the recording is cut into the same sweeps.
        if (feed_.assembler().sweepNumber() != before) sweepFirst_ = message;
        if (line) {
            ++lines_;
            lineNs_.push_back(frame.received.monotonicNs);
            if (lineNs_.size() > kLinesOfRate) lineNs_.pop_front();
        }
    }
    if (line) changed_();
}

std::shared_ptr<const Scan> LiveFeed::snapshot() {
    const std::lock_guard lock(mutex_);
    return feed_.assembler().snapshot();
}

scanner::SweepState LiveFeed::sweep() {
    const std::lock_guard lock(mutex_);
    return {feed_.assembler().snapshot(), feed_.assembler().progress()};
}

LiveStatus LiveFeed::status() const {
    LiveStatus status;
    status.statistics = connection_->statistics();
    const std::lock_guard lock(mutex_);
    status.connection = state_;
    status.scanner = identity_;
    status.sweep = feed_.assembler().progress();
    status.lines = lines_;
    status.linesAfter = linesAfter_;
    status.undecodable = feed_.undecodable();
    if (!lineNs_.empty()) {
        status.secondsSinceLine = static_cast<double>(scanner::hostNow().monotonicNs - lineNs_.back()) * 1e-9;
        const double seconds = static_cast<double>(lineNs_.back() - lineNs_.front()) * 1e-9;
        if (seconds > 0.0) status.linesPerSecond = static_cast<double>(lineNs_.size() - 1) / seconds;
    }
    if (recorder_) status.recording = recorder_->state();
    return status;
}

std::vector<scanner::FinishedSweep> LiveFeed::takeFinished() {
    const std::lock_guard lock(mutex_);
    return feed_.assembler().takeFinished();
}

Result<Done> LiveFeed::startRecording(const std::filesystem::path& path) {
    {
        const std::lock_guard lock(mutex_);
        if (recorder_ || starting_) return Error{"a recording is being written already", path.string(), "stop it first"};
        starting_ = true;
    }
    auto writer =
        RecordingWriter::start(path, scanner::metadataOf(sweepSettings())); // waits for the disk: what arrives must not wait with it
    const std::lock_guard lock(mutex_);
    starting_ = false;
    if (!writer) return writer.error();
    recorder_ = std::move(*writer);
    for (RecordingMessagePtr& message : messagesOfSweep()) recorder_->post(std::move(message));
    return Done{};
}

std::vector<RecordingMessagePtr> LiveFeed::messagesOfSweep() const {
    // By the message itself: telegrams that arrived together share their time.
    std::vector<RecordingMessagePtr> messages = recent_.messages();
    const auto first = std::find(messages.begin(), messages.end(), sweepFirst_);
    // The first sweep, or one that began before what is remembered: all.
    if (first != messages.end()) messages.erase(messages.begin(), first);
    return messages;
}

scanner::SweepSettings LiveFeed::sweepSettings() const {
    const std::lock_guard lock(mutex_);
    return sweepSettings_;
}

std::optional<int> LiveFeed::useSweep(const scanner::SweepSettings& sweep) {
    int gone = 0;
    {
        const std::lock_guard lock(mutex_);
        if (sweep == sweepSettings_) return std::nullopt;
        sweepSettings_ = sweep;
        gone = feed_.assembler().progress().received;
        feed_ = scanner::SweepFeed(sweep);
        for (const RecordingMessagePtr& message : messagesOfSweep())
            static_cast<void>(feedMessage(feed_, {message->topic, message->hostNs, message->hostNs, message->payload}));
        gone = std::max(0, gone - feed_.assembler().progress().received);
    }
    changed_();
    return gone;
}

Result<RecordingState> LiveFeed::stopRecording() {
    std::unique_ptr<RecordingWriter> recorder;
    {
        const std::lock_guard lock(mutex_);
        recorder = std::move(recorder_);
    }
    if (!recorder) return RecordingState{};
    if (const Result<Done> closed = recorder->close(); !closed) return closed.error();
    return recorder->state();
}

void LiveFeed::discardRecording() {
    const std::lock_guard lock(mutex_);
    if (recorder_) recorder_->closeAndRemove();
    recorder_.reset();
}

Result<Done> LiveFeed::keepRecent(const std::filesystem::path& path) const {
    return saveMessages(path, scanner::metadataOf(sweepSettings()), recent_.messages());
}

void LiveFeed::stop() {
    connection_->stop();
    const std::lock_guard lock(mutex_);
    feed_.assembler().finish();
}

} // namespace edgescan::files
