// Plays the laser that openScan() takes.
#include "core/robots/opening/recorded_bag.h"

#include "core/base/utc_time.h"
#include "core/robots/sweeps/live_laser.h"
#include "core/robots/sweeps/turned_first.h"

#include <algorithm>

namespace edgescan::robots {
namespace {

using files::RecordedMessage;

class LaserPlayer final : public files::LinePlayer {
public:
    LaserPlayer(const std::vector<RosTopic>& topics, std::uint32_t laser, const scanner::SweepSettings& settings, std::string joint)
        : topics_(topics), laserTopic_(laser), settings_(settings), joint_(std::move(joint)), laser_(settings_, joint_) {}

    [[nodiscard]] bool isLine(const RecordedMessage& message) const override { return message.sourceTopic == laserTopic_; }
    void play(const RecordedMessage& message, scanner::SweepAssembler& to) override {
        const RosTopic& topic = topics_[message.sourceTopic];
        if (isLine(message) || givesAngles(topic.type)) laser_.take(topic, message.payload, to);
    }
    void restart() override { laser_ = LiveLaser(settings_, joint_); }

private:
    const std::vector<RosTopic>& topics_;
    const std::uint32_t laserTopic_;
    const scanner::SweepSettings settings_;
    const std::string joint_;
    LiveLaser laser_;
};

class RecordedBag final : public files::RecordedSource {
public:
    explicit RecordedBag(RosBag bag) : bag_(std::move(bag)) {}

    [[nodiscard]] const std::string& kind() const override { return bag_.kind; }
    [[nodiscard]] std::vector<RecordedMessage> messages() const override {
        std::vector<RecordedMessage> messages;
        for (const RosBagMessage& message : bag_.messages) {
            const std::int64_t ns = std::clamp(message.logNs, std::int64_t{0}, kLatestNs);
            messages.push_back({files::RecordingTopic::Bridge, ns, ns, message.bytes, message.topic});
        }
        std::ranges::stable_sort(messages, {}, &RecordedMessage::logNs); // some bags are by topic
        return messages;
    }
    [[nodiscard]] std::unique_ptr<files::LinePlayer> player(const scanner::SweepSettings& settings,
                                                            const ReadingOptions& options) const override {
        auto topics = topicsToTry(bag_, options.topic, "");
        if (!topics) return nullptr;
        turnedFirst(bag_, options.joint, *topics, [&] { return !options.progress || options.progress("reading", 1.0); });
        if (topics->front().gives != TopicGives::Lines) return nullptr;
        return std::make_unique<LaserPlayer>(bag_.topics, topics->front().topic, settings, options.joint);
    }

private:
    const RosBag bag_;
};

} // namespace

Result<std::unique_ptr<files::RecordedSource>> recordedBag(const containers::McapContent& content, const std::string& where,
                                                           const std::function<bool()>& goOn) {
    auto bag = rosBagOf(content, where, goOn);
    if (!bag) return bag.error();
    if (bag->topics.empty()) return std::unique_ptr<files::RecordedSource>();
    return std::unique_ptr<files::RecordedSource>(std::make_unique<RecordedBag>(std::move(*bag)));
}

} // namespace edgescan::robots
