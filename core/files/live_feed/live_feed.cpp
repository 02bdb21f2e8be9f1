// A scanner from its socket to a growing scan.
#include "core/files/live_feed/live_feed.h"

#include "core/files/live_feed/bridge_topics.h"

#include <algorithm>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::size_t kLinesOfRate = 64;         // that the rate is taken from
constexpr std::size_t kLeastOfRate = 10;         // fewer lines say little about the rate
constexpr std::int64_t kKeptNs = 60'000'000'000; // "keep what just happened"
constexpr std::size_t kMostStanding = 64;
constexpr auto kLive = scanner::ConnectionPhase::Live;

std::optional<containers::RosTopic> topicOf(const scanner::BridgeChannel& channel) {
    return containers::rosTopic(channel.topic, channel.encoding, channel.type, channel.definitionEncoding, channel.definition);
}

/// A cloud has its angles: nothing of its mounting is assumed.
scanner::SweepSettings settingsOf(const Scan* cloud) {
    scanner::SweepSettings settings;
    settings.degPerLine.reset();
    const auto* polar = cloud != nullptr ? std::get_if<PolarGeometry>(&cloud->geometry) : nullptr;
    if (polar != nullptr) settings.axis = polar->axis;
    return settings;
}

} // namespace

LiveFeed::LiveFeed(scanner::ConnectionSettings scanner, const scanner::SweepSettings& sweep, std::function<void()> changed,
                   const LiveLimits& limits)
    : changed_(std::move(changed)), mostLines_(limits.lines), sweepSettings_(sweep), recent_(kKeptNs, limits.keptBytes), feed_(sweep),
      joint_(scanner.joint), laser_(sweep, joint_), connection_(connect(std::move(scanner))) {}

std::unique_ptr<scanner::LiveConnection> LiveFeed::connect(scanner::ConnectionSettings settings) {
    const auto stateChanged = [this](const scanner::ConnectionState& state) { changedTo(state); };
    if (settings.bridge) {
        scanner::BridgeEvents events;
        events.stateChanged = stateChanged;
        events.choose = [this, topic = settings.topic, where = scanner::addressText(settings.host, settings.port)](const auto& offered) {
            auto choice = chooseTopics(offered, topic, where);
            const std::lock_guard lock(mutex_);
            offered_ = offered;
            if (!choice) return choice;
            if (linesTopic_.empty()) {
                linesTopic_ = choice->lines->topic;
                if (isCloud(*choice->lines)) cloud_ = std::make_unique<LiveCloud>(changed_);
            }
            return choice;
        };
        events.received = [this](const auto& channel, const auto& data, const auto& time) { received(channel, data, time); };
        return std::make_unique<scanner::BridgeConnection>(std::move(settings), std::move(events));
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

LiveFeed::~LiveFeed() { connection_->stop(); }

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
template <class TakeLines>
void LiveFeed::take(const RecordingMessagePtr& message, const scanner::HostTime& time, const TakeLines& takeLines) {
    record(message);
    int lines = 0;
    {
        const std::lock_guard lock(mutex_);
        const int before = feed_.assembler().sweepNumber();
        lines = takeLines();
        // At a reversal some of the new sweep came before; they are few, and the recording is cut into the same sweeps.
        if (feed_.assembler().sweepNumber() != before || (cloud_ && lines > 0)) sweepFirst_ = message;
        lines_ += lines;
        for (int line = 0; line < lines; ++line) lineNs_.push_back(time.monotonicNs);
        while (lineNs_.size() > kLinesOfRate) lineNs_.pop_front();
    }
    if (lines > 0) changed_();
}

void LiveFeed::received(const scanner::ColaFrame& frame) {
    if (comesAfterTheLast(scanner::isScanTelegram(frame.payload()))) return;
    take(receivedMessage(frame, clock_), frame.received, [&] { return feed_.frame(frame, clock_.ns(frame.received)) ? 1 : 0; });
}

void LiveFeed::received(const scanner::BridgeChannelPtr& channel, const scanner::BridgeData& data, const scanner::HostTime& time) {
    if (comesAfterTheLast(channel->topic == linesTopic_)) return;
    const auto message = std::make_shared<const RecordingMessage>(
        RecordingMessage{RecordingTopic::Bridge, clock_.ns(time), Bytes(data.payload.begin(), data.payload.end()), channel, data.bridgeNs});
    take(message, time, [&] {
        Heard& heard = heard_[channel->topic];
        if (heard.messages++ == 0) heard = {1, time.monotonicNs, 0, message};
        heard.lastNs = time.monotonicNs;
        if (channel->topic.ends_with("tf_static") && standing_.size() < kMostStanding) standing_.push_back(message);
        return takeBridge(message);
    });
}

int LiveFeed::takeBridge(const RecordingMessagePtr& message) {
    const auto topic = topicOf(*message->channel);
    if (!topic) return 0;
    if (!cloud_) return laser_.take(*topic, message->payload, feed_.assembler());
    if (topic->name != linesTopic_) return 0;
    cloud_->take(*topic, message);
    return 1;
}

std::shared_ptr<const Scan> LiveFeed::snapshot() {
    const std::lock_guard lock(mutex_);
    return cloud_ ? cloud_->newest().scan : feed_.assembler().snapshot();
}

scanner::SweepState LiveFeed::sweep() {
    const std::lock_guard lock(mutex_);
    if (cloud_) return cloud_->newest();
    return {feed_.assembler().snapshot(), feed_.assembler().progress()};
}

LiveStatus LiveFeed::status() const {
    LiveStatus status;
    status.statistics = connection_->statistics();
    const std::lock_guard lock(mutex_);
    status.connection = state_;
    status.scanner = identity_;
    status.sweep = cloud_ ? cloud_->progress() : feed_.assembler().progress();
    status.settings = feed_.assembler().settings();
    status.lines = lines_;
    status.wholeClouds = cloud_ != nullptr;
    status.linesAfter = linesAfter_;
    status.undecodable = feed_.undecodable() + laser_.leftOut() + (cloud_ ? cloud_->unusable() : 0);
    status.whyUndecodable = !feed_.whyUndecodable().empty() ? feed_.whyUndecodable() : laser_.whyLeftOut();
    if (const auto problem = cloud_ ? cloud_->whyUnusable() : std::nullopt) status.whyUndecodable = problem->what;
    status.sweep.duplicates += laser_.repeated();
    status.noReturns = laser_.noReturns();
    if (cloud_) status.settings = settingsOf(cloud_->newest().scan.get());
    if (const std::string wait = laser_.waitsFor(); !wait.empty() && lines_ == 0 && status.connection.phase == kLive) {
        const Error unknown{"lines come, but their angle is not known: " + wait, linesTopic_,
                            "give the joint that turns the laser (--joint), or the step from line to line (--line-step)"};
        status.connection.sentence = unknown.sentence();
        status.connection.problem = unknown;
    }
    if (cloud_ && !cloud_->newest().scan && status.connection.phase == kLive) {
        status.connection.problem = cloud_->whyUnusable();
        if (status.connection.problem) status.connection.sentence = status.connection.problem->sentence();
    }
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
    std::vector<OfferedTopic> all;
    for (const scanner::BridgeChannelPtr& channel : offered_) {
        const auto topic = topicOf(*channel);
        if (!topic) continue;
        OfferedTopic row;
        const auto heard = heard_.find(channel->topic);
        row.subscribed = heard != heard_.end();
        row.lines = channel->topic == linesTopic_;
        row.topic = listedTopic(*topic, row.subscribed ? ByteView(heard->second.first->payload) : ByteView());
        if (row.subscribed) {
            row.topic.messages = static_cast<std::size_t>(heard->second.messages);
            const double seconds = static_cast<double>(heard->second.lastNs - heard->second.firstNs) * 1e-9;
            if (seconds > 0) row.topic.hertz = static_cast<double>(heard->second.messages - 1) / seconds;
        }
        all.push_back(std::move(row));
    }
    std::ranges::sort(all, {}, [](const OfferedTopic& row) { return row.topic.name; });
    return all;
}

std::vector<scanner::FinishedSweep> LiveFeed::takeFinished() {
    const std::lock_guard lock(mutex_);
    return feed_.assembler().takeFinished();
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
    std::vector<RecordingMessagePtr> all = standing_;
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
        laser_ = LiveLaser(sweep, joint_);
        if (cloud_) return 0; // its points have their places
        for (const RecordingMessagePtr& message : messagesOfSweep()) {
            if (message->topic == RecordingTopic::Bridge)
                takeBridge(message);
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
        std::vector<RecordingMessagePtr> earlier = standing_;
        std::erase_if(earlier, [&](const RecordingMessagePtr& message) { return std::ranges::find(messages, message) != messages.end(); });
        messages.insert(messages.begin(), earlier.begin(), earlier.end());
    }
    return saveMessages(path, scanner::metadataOf(sweepSettings()), messages);
}

void LiveFeed::stop() {
    connection_->stop();
    if (cloud_) cloud_->finish(); // without the lock: a cloud takes its time, and no other thread makes another one any more
    const std::lock_guard lock(mutex_);
    feed_.assembler().finish();
}

} // namespace edgescan::files
