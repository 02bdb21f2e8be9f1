// Chooses topics, counts messages, and passes them to the laser or to the clouds.
#include "core/robots/live/robot_source.h"
#include "core/base/translated_text.h"

#include "core/files/formats/reading.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/open_save/open_scan.h"
#include "core/robots/bags/definition.h"
#include "core/robots/bridge/bridge_connection.h"
#include "core/robots/sweeps/bag_sweep.h"
#include "core/robots/sweeps/bag_topics.h"
#include "core/robots/sweeps/live_laser.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgescan::robots {
namespace {

/// The name of a laser that a motor turns often says so; which one turns is known only when its lines come.
bool namesATurn(const std::string& topic) {
    constexpr std::array<std::string_view, 6> kWords{"tilt", "nod", "spin", "turn", "rotat", "sweep"};
    return std::ranges::any_of(kWords, [&](std::string_view word) { return topic.find(word) != std::string::npos; });
}

std::string namesOf(const std::vector<BridgeChannelPtr>& channels) {
    constexpr std::size_t kLongest = 300;
    std::string names;
    for (const BridgeChannelPtr& channel : channels) {
        if (names.size() > kLongest) return withValues("%1 and others", {names});
        names += (names.empty() ? "" : ", ") + channel->topic;
    }
    return names;
}

constexpr std::size_t kMostStanding = 64;
constexpr auto kLive = scanner::ConnectionPhase::Live;

std::optional<RosTopic> topicOf(const BridgeChannel& channel) {
    return rosTopic(channel.topic, channel.encoding, channel.type, channel.definitionEncoding, channel.definition);
}

/// A cloud has its angles: nothing of its mounting is assumed.
scanner::SweepSettings settingsOf(const Scan* cloud) {
    scanner::SweepSettings settings;
    settings.degPerLine.reset();
    const auto* polar = cloud != nullptr ? std::get_if<PolarGeometry>(&cloud->geometry) : nullptr;
    if (polar != nullptr) settings.axis = polar->axis;
    return settings;
}

class RobotSource final : public files::LiveSource {
public:
    /// `mutex`: the lock with which the feed calls the source.
    RobotSource(const scanner::ConnectionSettings& asked, const scanner::SweepSettings& sweep, std::function<void()> changed,
                std::mutex& mutex)
        : topic_(asked.topic), joint_(asked.joint), keepRepeated_(asked.keepRepeated), changed_(std::move(changed)), mutex_(mutex),
          laser_(sweep, joint_, keepRepeated_) {}

    std::unique_ptr<scanner::LiveConnection> connect(scanner::ConnectionSettings settings, Events events) override;
    void heard(const files::RecordingMessagePtr& message, std::int64_t monotonicNs) override;
    int play(const files::RecordingMessagePtr& message, scanner::SweepAssembler& to) override;
    void useSweep(const scanner::SweepSettings& settings) override { laser_ = LiveLaser(settings, joint_, keepRepeated_); }
    [[nodiscard]] std::optional<scanner::SweepState> newest() const override;
    void complete(files::LiveStatus& status) const override;
    [[nodiscard]] std::vector<files::OfferedTopic> offered() const override;
    [[nodiscard]] const std::vector<files::RecordingMessagePtr>& standing() const override { return standing_; }
    void finish() override;

private:
    const std::string topic_, joint_; // as asked for
    const bool keepRepeated_;
    const std::function<void()> changed_;
    std::mutex& mutex_; // of all that follows
    LiveLaser laser_;
    std::vector<files::RecordingMessagePtr> standing_; // fixed transforms, which come only once
    std::string linesTopic_;
    std::unique_ptr<LiveCloud> cloud_; // if that topic gives clouds
    struct Heard {
        std::int64_t messages = 0, firstNs = 0, lastNs = 0;
        files::RecordingMessagePtr first;
    };
    std::vector<BridgeChannelPtr> offered_;
    std::map<std::string, Heard> heard_; // by topic
};

std::unique_ptr<scanner::LiveConnection> RobotSource::connect(scanner::ConnectionSettings settings, Events feed) {
    BridgeEvents events;
    events.stateChanged = std::move(feed.stateChanged);
    events.choose = [this, where = scanner::addressText(settings.host, settings.port)](const auto& offered) {
        auto choice = chooseTopics(offered, topic_, where);
        const std::lock_guard lock(mutex_);
        offered_ = offered;
        if (!choice) return choice;
        if (linesTopic_.empty()) {
            linesTopic_ = choice->lines->topic;
            if (isCloud(*choice->lines)) cloud_ = std::make_unique<LiveCloud>(changed_, keepRepeated_);
        }
        return choice;
    };
    events.received = [this, received = std::move(feed.received)](const auto& channel, const auto& data, const auto& time) {
        received({files::RecordingTopic::Bridge, 0, Bytes(data.payload.begin(), data.payload.end()), channel, data.bridgeNs}, time,
                 channel->topic == linesTopic_);
    };
    return std::make_unique<BridgeConnection>(std::move(settings), std::move(events));
}

void RobotSource::heard(const files::RecordingMessagePtr& message, std::int64_t monotonicNs) {
    const std::string& topic = message->channel->topic;
    Heard& heard = heard_[topic];
    if (heard.messages++ == 0) heard = {1, monotonicNs, 0, message};
    heard.lastNs = monotonicNs;
    if (topic.ends_with("tf_static") && standing_.size() < kMostStanding) standing_.push_back(message);
}

int RobotSource::play(const files::RecordingMessagePtr& message, scanner::SweepAssembler& to) {
    const auto topic = topicOf(*message->channel);
    if (!topic) return 0;
    if (!cloud_) return laser_.receive(*topic, message->payload, to);
    if (topic->name != linesTopic_) return 0;
    cloud_->receive(*topic, message);
    return 1;
}

std::optional<scanner::SweepState> RobotSource::newest() const { return cloud_ ? std::optional(cloud_->newest()) : std::nullopt; }

void RobotSource::complete(files::LiveStatus& status) const {
    status.undecodable += laser_.leftOut();
    if (status.whyUndecodable.empty()) status.whyUndecodable = laser_.whyLeftOut();
    status.sweep.duplicates += laser_.repeated();
    status.noReturns = laser_.noReturns();
    status.wholeClouds = cloud_ != nullptr;
    const bool live = status.connection.phase == kLive;
    if (const std::string wait = laser_.waitsFor(); !wait.empty() && status.lines == 0 && live) {
        const Error unknown{withValues("lines come, but their angle is not known: %1", {wait}), linesTopic_,
                            "give the joint that turns the laser (--joint), or the step from line to line (--line-step)"};
        status.connection.sentence = unknown.sentence();
        status.connection.problem = unknown;
    }
    if (!cloud_) return;
    const std::shared_ptr<const Scan> newest = cloud_->newest().scan;
    const std::optional<Error> problem = cloud_->whyUnusable();
    status.sweep = cloud_->progress();
    status.settings = settingsOf(newest.get());
    status.undecodable += cloud_->unusable();
    if (problem) status.whyUndecodable = problem->what;
    if (newest || !live) return;
    status.connection.problem = problem;
    if (problem) status.connection.sentence = problem->sentence();
}

std::vector<files::OfferedTopic> RobotSource::offered() const {
    std::vector<files::OfferedTopic> all;
    for (const BridgeChannelPtr& channel : offered_) {
        const auto topic = topicOf(*channel);
        if (!topic) continue;
        files::OfferedTopic row;
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
    std::ranges::sort(all, {}, [](const files::OfferedTopic& row) { return row.topic.name; });
    return all;
}

void RobotSource::finish() {
    if (cloud_) cloud_->finish();
}

} // namespace

LiveCloud::~LiveCloud() { ending_ = true; }

void LiveCloud::receive(RosTopic topic, files::RecordingMessagePtr message) {
    {
        const std::lock_guard lock(mutex_);
        ++messages_;
        arrivedNs_ = message->hostNs;
        waiting_ = Waiting{std::move(topic), std::move(message)};
    }
    lane_.post([this] { makeScan(); });
}

void LiveCloud::finish() {
    lane_.end();
    makeScan();
    const std::lock_guard lock(mutex_);
    growing_ = false;
}

Result<Scan> LiveCloud::scanOf(const Waiting& newest) const {
    RosBag bag;
    bag.topics.push_back(newest.topic);
    bag.messages.push_back({0, newest.message->hostNs, newest.message->payload});
    ReadingOptions options;
    options.topic = newest.topic.name;
    options.keepRepeated = keepRepeated_;
    options.progress = [this](const char*, double) { return !ending_; };
    const files::Source source{newest.topic.name, {}, &options, true};
    try {
        auto table = cloudOfBag(bag, {0, TopicGives::Clouds, 1, 0, newest.message->payload.size()}, source);
        if (!table) return table.error();
        return files::scanOfReading(files::Reading(std::move(*table)), source, false);
    } catch (const std::bad_alloc&) {
        return Error{"there is not enough memory for this cloud", newest.topic.name, "close other programs"};
    }
}

void LiveCloud::makeScan() {
    std::optional<Waiting> newest;
    {
        const std::lock_guard lock(mutex_);
        newest = std::exchange(waiting_, std::nullopt);
    }
    if (!newest) return;
    auto scan = scanOf(*newest);
    {
        const std::lock_guard lock(mutex_);
        if (!scan) {
            ++unusable_;
            why_ = scan.error();
        } else {
            scan->name = newest->topic.name;
            scanner::SweepProgress& progress = newest_.progress;
            progress.lines = progress.received = progress.expected = scan->lines();
            progress.cells = countCells(*scan);
            progress.newestNs = newest->message->hostNs;
            ++progress.account.sweeps;
            progress.account.lines += scan->lines();
            progress.account.cells += static_cast<std::int64_t>(scan->cells());
            newest_.scan = std::make_shared<const Scan>(std::move(*scan));
        }
    }
    changed_();
}

scanner::SweepState LiveCloud::newest() const {
    const std::lock_guard lock(mutex_);
    scanner::SweepState state = newest_;
    state.progress.growing = growing_;
    return state;
}

scanner::SweepProgress LiveCloud::progress() const {
    const std::lock_guard lock(mutex_);
    scanner::SweepProgress progress = newest_.progress;
    progress.growing = growing_;
    progress.newestNs = arrivedNs_;
    progress.account.telegrams = messages_;
    progress.account.unusable = unusable_;
    progress.account.placed = messages_ - unusable_;
    return progress;
}

std::int64_t LiveCloud::unusable() const {
    const std::lock_guard lock(mutex_);
    return unusable_;
}

std::optional<Error> LiveCloud::whyUnusable() const {
    const std::lock_guard lock(mutex_);
    return why_;
}

bool isCloud(const BridgeChannel& channel) { return givenBy(rosTypeName(channel.type)) == TopicGives::Clouds; }

Result<BridgeChoice> chooseTopics(const std::vector<BridgeChannelPtr>& offered, const std::string& topic, const std::string& where) {
    BridgeChoice choice;
    std::vector<BridgeChannelPtr> lasers, clouds;
    for (const BridgeChannelPtr& channel : offered) {
        const std::string type = rosTypeName(channel->type);
        const bool readable = channel->encoding == "cdr" || channel->encoding == "ros1";
        if (readable && givenBy(type) == TopicGives::Lines) lasers.push_back(channel);
        if (readable && givenBy(type) == TopicGives::Clouds) clouds.push_back(channel);
        if (readable && givesAngles(type)) choice.channels.push_back(channel);
    }
    const auto byName = [](const BridgeChannelPtr& channel) { return std::pair(!namesATurn(channel->topic), channel->topic); };
    std::ranges::stable_sort(lasers, {}, byName);
    std::ranges::stable_sort(clouds, {}, byName);
    lasers.insert(lasers.end(), clouds.begin(), clouds.end());
    if (lasers.empty())
        return Error{withValues("the bridge offers no topic of a laser (sensor_msgs/LaserScan or PointCloud2)%1",
                                {offered.empty() ? std::string() : ": " + namesOf(offered)}),
                     where, "check that the laser's driver runs"};
    const auto taken =
        topic.empty() ? lasers.begin() : std::ranges::find(lasers, topic, [](const auto& channel) { return channel->topic; });
    if (taken == lasers.end())
        return Error{withValues("the bridge offers no topic of a laser called \"%1\"", {topic}), where,
                     withValues("choose one of %1", {namesOf(lasers)})};
    choice.lines = *taken;
    if (isCloud(**taken)) choice.channels.clear(); // its points need no angles
    choice.channels.push_back(*taken);
    lasers.erase(taken);
    if (topic.empty() && !lasers.empty())
        choice.note = withValues("GUESS: the topic %1 was taken; --topic chooses another: %2.", {choice.lines->topic, namesOf(lasers)});
    return choice;
}

std::unique_ptr<files::LiveSource> liveRobot(const scanner::ConnectionSettings& asked, const scanner::SweepSettings& sweep,
                                             std::function<void()> changed, std::mutex& mutex) {
    return std::make_unique<RobotSource>(asked, sweep, std::move(changed), mutex);
}

} // namespace edgescan::robots
