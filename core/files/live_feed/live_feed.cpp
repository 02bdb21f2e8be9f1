// A scanner from its socket to a growing scan.
#include "core/files/live_feed/live_feed.h"

#include "core/files/addons/addon.h"

#include <algorithm>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kLinesOfRate = 64;         // that the rate is taken from
constexpr std::size_t kLeastOfRate = 10;         // fewer lines say little about the rate
constexpr std::int64_t kKeptNs = 60'000'000'000; // "keep what just happened"

} // namespace

LiveFeed::LiveFeed(scanner::ConnectionSettings scanner, const scanner::SweepSettings& sweep, std::function<void()> changed,
                   const LiveLimits& limits)
    : changed_(std::move(changed)), mostLines_(limits.lines), sweepSettings_(sweep), recent_(kKeptNs, limits.keptBytes), feed_(sweep),
      connection_(connect(std::move(scanner))) {}

std::unique_ptr<scanner::LiveConnection> LiveFeed::connect(scanner::ConnectionSettings settings) {
    const auto stateChanged = [this](const scanner::ConnectionState& state) { changedTo(state); };
    if (settings.bridge && addon().live == nullptr) {
        const Error none{kNoRobots, scanner::addressText(settings.host, settings.port), kBuildWithRobots};
        state_ = {scanner::ConnectionPhase::Lost, none.sentence(), scanner::hostNow(), none};
        return nullptr;
    }
    if (settings.bridge) {
        source_ = addon().live(settings, sweepSettings_, changed_, mutex_);
        return source_->connect(std::move(settings), {stateChanged, [this](RecordingMessage message, const auto& time, bool isLine) {
                                                          received(std::move(message), time, isLine);
                                                      }});
    }
    scanner::ConnectionEvents events;
    events.stateChanged = stateChanged;
    events.identified = [this](const scanner::ScannerIdentity& identity) {
        {
            const std::lock_guard lock(mutex_);
            identity_ = identity;
        }
        changed_();
    };
    events.frameReceived = [this](const scanner::ColaFrame& frame) { received(frame); };
    events.frameSent = [this](const scanner::ColaFrame& frame) { record(sentMessage(frame, clock_)); };
    return std::make_unique<scanner::ScannerConnection>(std::move(settings), std::move(events));
}

void LiveFeed::changedTo(const scanner::ConnectionState& state) {
    {
        const std::lock_guard lock(mutex_);
        state_ = state;
        if (state.phase == scanner::ConnectionPhase::Lost) feed_.assembler().reconnected();
    }
    changed_();
}

LiveFeed::~LiveFeed() {
    if (connection_) connection_->stop();
}

void LiveFeed::record(RecordingMessagePtr message) {
    const std::lock_guard lock(mutex_);
    recent_.push(message);
    if (recorder_) recorder_->post(std::move(message));
}

bool LiveFeed::comesAfterTheLast(bool isLine) {
    const std::lock_guard lock(mutex_);
    if (mostLines_ == 0 || lines_ < mostLines_) return false;
    if (isLine) ++linesAfter_;
    return true;
}

/// Records a message before anything looks into it, and takes the lines that it gives.
template <class AddLines>
void LiveFeed::addMessage(const RecordingMessagePtr& message, const scanner::HostTime& time, const AddLines& addLines) {
    record(message);
    int lines = 0;
    {
        const std::lock_guard lock(mutex_);
        const int before = feed_.assembler().sweepNumber();
        lines = addLines();
        // At a reversal some of the new sweep came before; they are few, and the recording is cut into the same sweeps.
        if (feed_.assembler().sweepNumber() != before || (lines > 0 && source_ && source_->newest())) sweepFirst_ = message;
        lines_ += lines;
        for (int line = 0; line < lines; ++line) lineNs_.push_back(time.monotonicNs);
        while (lineNs_.size() > kLinesOfRate) lineNs_.pop_front();
    }
    if (lines > 0) changed_();
}

void LiveFeed::received(const scanner::ColaFrame& frame) {
    if (comesAfterTheLast(scanner::isScanTelegram(frame.payload()))) return;
    addMessage(receivedMessage(frame, clock_), frame.received, [&] { return feed_.frame(frame, clock_.ns(frame.received)) ? 1 : 0; });
}

void LiveFeed::received(RecordingMessage received, const scanner::HostTime& time, bool isLine) {
    if (comesAfterTheLast(isLine)) return;
    received.hostNs = clock_.ns(time);
    const auto message = std::make_shared<const RecordingMessage>(std::move(received));
    addMessage(message, time, [&] {
        source_->heard(message, time.monotonicNs);
        return source_->play(message, feed_.assembler());
    });
}

std::shared_ptr<const Scan> LiveFeed::snapshot() { return sweep().scan; }

scanner::SweepState LiveFeed::sweep() {
    const std::lock_guard lock(mutex_);
    if (auto whole = source_ ? source_->newest() : std::nullopt) return std::move(*whole);
    return {feed_.assembler().snapshot(), feed_.assembler().progress()};
}

LiveStatus LiveFeed::status() const {
    LiveStatus status;
    if (connection_) status.statistics = connection_->statistics();
    const std::lock_guard lock(mutex_);
    status.connection = state_;
    status.scanner = identity_;
    status.sweep = feed_.assembler().progress();
    status.settings = feed_.assembler().settings();
    status.lines = lines_;
    status.linesAfter = linesAfter_;
    status.undecodable = feed_.undecodable();
    status.whyUndecodable = feed_.whyUndecodable();
    if (source_) source_->complete(status);
    if (!lineNs_.empty()) {
        status.secondsSinceLine = static_cast<double>(scanner::hostNow().monotonicNs - lineNs_.back()) * 1e-9;
        const double seconds = static_cast<double>(lineNs_.back() - lineNs_.front()) * 1e-9;
        if (seconds > 0.0 && lineNs_.size() >= kLeastOfRate) status.linesPerSecond = static_cast<double>(lineNs_.size() - 1) / seconds;
    }
    if (recorder_) status.recording = recorder_->state();
    return status;
}

std::vector<OfferedTopic> LiveFeed::offered() const {
    const std::lock_guard lock(mutex_);
    return source_ ? source_->offered() : std::vector<OfferedTopic>();
}

std::vector<scanner::FinishedSweep> LiveFeed::popFinished() {
    const std::lock_guard lock(mutex_);
    return feed_.assembler().popFinished();
}

Result<int> LiveFeed::startRecording(const std::filesystem::path& path) {
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
    std::vector<RecordingMessagePtr> before = messagesOfSweep();
    // Of a sweep that began before what is remembered, the first lines are gone.
    const int lines = std::min(feed_.assembler().progress().received, static_cast<int>(before.size()));
    for (RecordingMessagePtr& message : before) recorder_->post(std::move(message));
    return lines;
}

std::vector<RecordingMessagePtr> LiveFeed::messagesOfSweep() const {
    // By the message itself: telegrams that arrived together share their time.
    std::vector<RecordingMessagePtr> messages = recent_.messages();
    const auto first = std::find(messages.begin(), messages.end(), sweepFirst_);
    // The first sweep, or one that began before what is remembered: all.
    if (first != messages.end()) messages.erase(messages.begin(), first);
    std::vector<RecordingMessagePtr> all = source_ ? source_->standing() : std::vector<RecordingMessagePtr>();
    std::erase_if(all, [&](const RecordingMessagePtr& message) { return std::ranges::find(messages, message) != messages.end(); });
    all.insert(all.end(), messages.begin(), messages.end());
    return all;
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
        if (source_) source_->useSweep(sweep);
        if (source_ && source_->newest()) return 0; // its points have their places
        for (const RecordingMessagePtr& message : messagesOfSweep()) {
            if (message->topic == RecordingTopic::Bridge)
                source_->play(message, feed_.assembler());
            else
                feedMessage(feed_, {message->topic, message->hostNs, message->hostNs, message->payload});
        }
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
    std::vector<RecordingMessagePtr> messages = recent_.messages();
    {
        const std::lock_guard lock(mutex_);
        std::vector<RecordingMessagePtr> earlier = source_ ? source_->standing() : std::vector<RecordingMessagePtr>();
        std::erase_if(earlier, [&](const RecordingMessagePtr& message) { return std::ranges::find(messages, message) != messages.end(); });
        messages.insert(messages.begin(), earlier.begin(), earlier.end());
    }
    return saveMessages(path, scanner::metadataOf(sweepSettings()), messages);
}

void LiveFeed::stop() {
    if (!connection_) return;
    connection_->stop();
    if (source_) source_->finish(); // without the lock: a cloud takes its time, and no other thread makes another one any more
    const std::lock_guard lock(mutex_);
    feed_.assembler().finish();
}

} // namespace edgescan::files
