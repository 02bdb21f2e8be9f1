// Chooses topics of a bridge, subscribes to them and passes their messages on.
#include "core/robots/bridge/bridge_connection.h"
#include "core/base/translated_text.h"

namespace edgescan::robots {

BridgeConnection::BridgeConnection(scanner::ConnectionSettings settings, BridgeEvents events)
    : scanner::LiveConnection(std::move(settings), events.stateChanged), events_(std::move(events)) {
    begin();
}

scanner::ColaCounts BridgeConnection::counts() const {
    scanner::ColaCounts counts;
    counts.bytes = bytes_;
    counts.skipped = skipped_;
    return counts;
}

Result<Done> BridgeConnection::start() {
    offered_.clear();
    subscribed_.clear();
    lines_.reset();
    noChoice_.reset();
    said_.clear();
    enter(scanner::ConnectionPhase::Identifying, withValues("%1 accepts the connection; asking for its topics.", {where()}));
    return Done{};
}

Result<Done> BridgeConnection::receive(Clock::time_point deadline) {
    const auto received = socket_.receive(deadline);
    if (!received) return received.error();
    if (!*received) return Done{};
    const WebSocketMessage& message = **received;
    bytes_ += message.bytes.size();
    if (message.isText) return receiveText({reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()});
    receiveData(message);
    return Done{};
}

Error BridgeConnection::silent(const std::string& time) const {
    if (noChoice_) return *noChoice_;
    if (!said_.empty()) return {withValues("the bridge says: %1", {said_}), where(), "check foxglove_bridge on the robot"};
    if (!lines_) return {"the bridge offers no topics", where(), "check that the robot's programs run"};
    return {withValues("no scan line of %1 for %2", {lines_->topic, time}), where(),
            "check whether the laser runs and publishes this topic"};
}

Result<Done> BridgeConnection::receiveText(std::string_view json) {
    constexpr std::size_t kMostTopics = 100'000;
    auto text = bridgeText(json, where());
    if (!text) return text.error();
    if (!text->problem.empty()) said_ = text->problem.substr(0, 200);
    for (const std::uint32_t id : text->gone) {
        offered_.erase(id);
        subscribed_.erase(id);
        if (lines_ && lines_->id == id) lines_.reset();
    }
    if (text->offered.empty()) return Done{};
    for (BridgeChannel& channel : text->offered) {
        if (offered_.size() >= kMostTopics) break;
        const std::uint32_t id = channel.id;
        offered_[id] = std::make_shared<const BridgeChannel>(std::move(channel));
    }
    return chooseAgain();
}

/// Subscribes to what is wanted of all that is offered by now, and to nothing else.
Result<Done> BridgeConnection::chooseAgain() {
    std::vector<BridgeChannelPtr> all;
    all.reserve(offered_.size());
    for (const auto& [id, channel] : offered_) all.push_back(channel);
    auto choice = events_.choose(all);
    if (!choice) {
        noChoice_ = choice.error();
        return Done{}; // topics may follow
    }
    noChoice_.reset();
    if (!lines_) lines_ = choice->lines; // a topic that was chosen stays
    note_ = choice->note;
    std::vector<BridgeChannelPtr> wanted;
    for (const BridgeChannelPtr& channel : choice->channels) {
        if (channel == choice->lines && channel != lines_) continue;
        if (subscribed_.emplace(channel->id, channel).second) wanted.push_back(channel);
    }
    if (wanted.empty()) return Done{};
    return socket_.send(subscribeText(wanted), settings_.timeouts.answer);
}

void BridgeConnection::receiveData(const WebSocketMessage& message) {
    const auto data = bridgeData(message.bytes);
    const auto channel = data ? subscribed_.find(data->subscription) : subscribed_.end();
    if (channel == subscribed_.end()) {
        if (!data) skipped_ += message.bytes.size();
        return;
    }
    if (channel->second == lines_) {
        const Clock::time_point now = Clock::now();
        const double since = std::chrono::duration<double>(now - lastScan_).count();
        constexpr double kOfNew = 0.1, kLongestS = 60.0;
        if (scansHere_ > 0) periodS_ += (periodS_ == 0 ? 1.0 : kOfNew) * (std::min(since, kLongestS) - periodS_);
        ++scans_;
        ++scansHere_;
        lastScan_ = now;
    }
    events_.received(channel->second, *data, message.received);
}

} // namespace edgescan::robots
