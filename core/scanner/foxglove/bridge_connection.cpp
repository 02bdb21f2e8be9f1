// Connects to a bridge and reconnects after a loss.
#include "core/scanner/foxglove/bridge_connection.h"

#include "core/base/number_text.h"

#include <algorithm>

namespace edgescan::scanner {
namespace {

std::string seconds(std::chrono::duration<double> duration) { return fixedText(duration.count(), 1) + " s"; }

} // namespace

BridgeConnection::BridgeConnection(ConnectionSettings settings, BridgeEvents events)
    : settings_(std::move(settings)), events_(std::move(events)), thread_([this] { run(); }) {}

BridgeConnection::~BridgeConnection() {
    BridgeConnection::stop();
    if (thread_.joinable()) thread_.join();
}

void BridgeConnection::stop() {
    socket_.interrupt();
    if (thread_.joinable() && std::this_thread::get_id() != thread_.get_id()) thread_.join();
}

ConnectionState BridgeConnection::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

ConnectionStatistics BridgeConnection::statistics() const {
    const std::uint64_t connections = connections_;
    ConnectionStatistics all{{}, scans_, connections, connections > 0 ? connections - 1 : 0};
    all.stream.bytes = bytes_;
    all.stream.skipped = skipped_;
    return all;
}

void BridgeConnection::enter(ConnectionPhase phase, std::string sentence, std::optional<Error> problem) {
    ConnectionState state{phase, std::move(sentence), hostNow(), std::move(problem)};
    {
        const std::lock_guard lock(mutex_);
        if (!state.problem && phase != ConnectionPhase::Live) state.problem = state_.problem;
        state_ = state;
    }
    if (events_.stateChanged) events_.stateChanged(state);
}

void BridgeConnection::run() {
    std::size_t failures = 0;
    while (true) {
        scansHere_ = 0;
        Error end = connection();
        socket_.close();
        if (socket_.interrupted()) return enter(ConnectionPhase::Stopped, where() + ": disconnected.");
        if (end.where.empty()) end.where = where();
        if (scansHere_ > 0) failures = 0;
        const auto& rests = settings_.timeouts.rests;
        const auto rest = rests.empty() ? std::chrono::milliseconds(0) : rests[std::min(failures, rests.size() - 1)];
        ++failures;
        enter(ConnectionPhase::Lost, end.sentence() + " Trying again in " + seconds(rest) + ".", end);
        socket_.pause(rest);
    }
}

Error BridgeConnection::connection() {
    offered_.clear();
    subscribed_.clear();
    lines_.reset();
    noChoice_.reset();
    said_.clear();
    enter(ConnectionPhase::Connecting, "Connecting to " + where() + ".");
    if (const auto connected = socket_.connect(settings_.host, settings_.port, settings_.timeouts.connect); !connected)
        return connected.error();
    ++connections_;
    enter(ConnectionPhase::Identifying, where() + " accepts the connection; asking for its topics.");
    return watch();
}

BridgeConnection::Clock::duration BridgeConnection::watchdog() const {
    const auto tenPeriods = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(10.0 * periodS_));
    return std::max<Clock::duration>(settings_.timeouts.silence, tenPeriods);
}

/// Receives until the connection ends or no more lines arrive.
Error BridgeConnection::watch() {
    const Clock::time_point connected = Clock::now();
    while (!socket_.interrupted()) {
        const bool begun = scansHere_ > 0;
        const auto timeout = begun ? watchdog() : Clock::duration(settings_.timeouts.firstScan);
        const auto silentSince = begun ? lastScan_ : connected;
        const auto phase = state().phase;
        const bool live = phase == ConnectionPhase::Live;
        const auto message = socket_.receive(silentSince + (live ? timeout / 2 : timeout));
        if (!message) return message.error();
        const std::uint64_t before = scansHere_;
        if (*message) {
            if (const auto taken = take(**message); !taken) return taken.error();
        }
        if (scansHere_ > before) {
            if (!live)
                enter(ConnectionPhase::Live, where() + (phase == ConnectionPhase::Stale ? " is sending again." : " is sending.") +
                                                 (note_.empty() ? "" : " " + note_));
            continue;
        }
        const auto silence = Clock::now() - silentSince;
        if (silence >= timeout) {
            if (noChoice_) return *noChoice_;
            if (!said_.empty()) return {"the bridge says: " + said_, where(), "check foxglove_bridge on the robot"};
            if (!lines_) return {"the bridge offers no topics", where(), "check that the robot's programs run"};
            return {"no scan line of " + lines_->topic + " for " + seconds(timeout), where(),
                    "check whether the laser runs and publishes this topic"};
        }
        if (live && silence >= timeout / 2) enter(ConnectionPhase::Stale, where() + ": no scan for " + seconds(silence) + ".");
    }
    return {"interrupted", where(), {}};
}

Result<Done> BridgeConnection::take(const WebSocketMessage& message) {
    bytes_ += message.bytes.size();
    if (message.isText) return takeText({reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()});
    takeData(message);
    return Done{};
}

Result<Done> BridgeConnection::takeText(std::string_view json) {
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

void BridgeConnection::takeData(const WebSocketMessage& message) {
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

} // namespace edgescan::scanner
