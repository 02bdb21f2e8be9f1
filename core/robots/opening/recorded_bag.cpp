// Plays the laser that openScan() takes.
#include "core/robots/opening/recorded_bag.h"

#include "core/base/utc_time.h"
#include "core/robots/sweeps/live_laser.h"
#include "core/robots/sweeps/turned_first.h"

#include <algorithm>

namespace edgescan::robots {
namespace {

using files::RecordedMessage;

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
    [[nodiscard]] std::optional<files::LinePlayer> player(const scanner::SweepSettings& settings,
                                                          const ReadingOptions& options) const override {
        auto topics = topicsToTry(bag_, options.topic, "");
        if (!topics) return std::nullopt;
        turnedFirst(bag_, options.joint, *topics, [&] { return !options.progress || options.progress("reading", 1.0); });
        if (topics->front().gives != TopicGives::Lines) return std::nullopt;
        const std::uint32_t lines = topics->front().topic;
        return files::LinePlayer{
            [lines](const RecordedMessage& message) { return message.sourceTopic == lines; },
            [this, lines, laser = LiveLaser(settings, options.joint)](const RecordedMessage& message, scanner::SweepAssembler& to) mutable {
                const RosTopic& topic = bag_.topics[message.sourceTopic];
                if (message.sourceTopic == lines || givesAngles(topic.type)) laser.receive(topic, message.payload, to);
            }};
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
