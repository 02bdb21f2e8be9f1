// Chooses topics of a bridge, subscribes to them and passes their messages on.
#include "core/robots/bridge/bridge_connection.h"
#include "core/base/translated_text.h"

#include "core/scanner/cola/link_socket.h"

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

namespace edgescan::robots {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;
using tcp = asio::ip::tcp;

constexpr std::size_t kLongestMessage = std::size_t{64} << 20U;
constexpr const char* kProtocols = "foxglove.sdk.v1, foxglove.websocket.v1";

Error brokenError(const error_code& problem, const std::string& where) {
    if (problem == asio::error::eof || problem == websocket::error::closed) return {"the bridge closed the connection", where, {}};
    if (problem == websocket::error::message_too_big || problem == websocket::error::buffer_overflow)
        return {"the bridge sends a message of more than 64 MB", where, "choose another topic"};
    return {withValues("the connection broke (%1)", {problem.message()}), where, {}};
}

} // namespace

struct WebSocket::Messages : scanner::Link::Socket {
    using Stream = websocket::stream<tcp::socket>;

    Messages()
        : Socket({"check power, cable and the address, and that this computer is in the robot's network",
                  "check the port (8765) and that foxglove_bridge runs on the robot"}) {}

    Result<Done> connect(const tcp::endpoint& endpoint, Clock::time_point deadline) override;
    void close() override {
        if (!stream) return;
        error_code ignored;
        stream->next_layer().shutdown(tcp::socket::shutdown_both, ignored);
        stream->next_layer().close(ignored);
        drain(read);
        stream.reset();
        buffer.clear();
    }
    /// Waits for one operation of the stream; where it takes too long the connection is closed.
    bool finished(const bool& done, Clock::time_point deadline) {
        if (run(done, deadline)) return true;
        error_code ignored;
        stream->next_layer().close(ignored);
        drain(done);
        return false;
    }

    std::optional<Stream> stream;
    beast::flat_buffer buffer{kLongestMessage};
    bool read = true; ///< no reading is under way
    error_code readProblem;
};

Result<Done> WebSocket::Messages::connect(const tcp::endpoint& endpoint, Clock::time_point deadline) {
    stream.emplace(context);
    error_code problem;
    bool done = false;
    const auto noted = [&](const error_code& outcome) {
        problem = outcome;
        done = true;
    };
    stream->next_layer().async_connect(endpoint, noted);
    const bool inTime = finished(done, deadline);
    if (!inTime || problem) {
        stream.reset();
        return connectError(problem, !inTime);
    }
    error_code ignored;
    stream->next_layer().set_option(tcp::no_delay(true), ignored);
    stream->read_message_max(kLongestMessage);
    stream->set_option(websocket::stream_base::decorator(
        [](websocket::request_type& request) { request.set(beast::http::field::sec_websocket_protocol, kProtocols); }));
    done = false;
    stream->async_handshake(where, "/", noted);
    if (!finished(done, deadline) || problem) {
        stream.reset();
        return Error{"what answers there is not a Foxglove bridge", where,
                     "check the port (8765) and that foxglove_bridge runs there; a scanner of SICK is HOST without ws://"};
    }
    return Done{};
}

WebSocket::WebSocket() : scanner::Link(std::make_unique<Messages>()) {}

WebSocket::Messages& WebSocket::messages() const { return static_cast<Messages&>(*socket_); }

Result<Done> WebSocket::send(const std::string& text, Clock::duration timeout) {
    Messages& s = messages();
    if (!s.stream) return Error{"the connection is closed", s.where, {}};
    error_code problem;
    bool done = false;
    s.stream->text(true);
    s.stream->async_write(asio::buffer(text), [&](const error_code& outcome, std::size_t) {
        problem = outcome;
        done = true;
    });
    if (!s.finished(done, Clock::now() + timeout)) problem = asio::error::timed_out;
    if (problem) return Error{withValues("the subscription cannot be sent (%1)", {problem.message()}), s.where, "check the network"};
    return Done{};
}

Result<std::optional<WebSocketMessage>> WebSocket::receive(Clock::time_point deadline) {
    Messages& s = messages();
    if (!s.stream) return Error{"the connection is closed", s.where, {}};
    if (s.read) { // a reading that a deadline has left goes on
        s.read = false;
        s.stream->async_read(s.buffer, [&s](const error_code& outcome, std::size_t) {
            s.readProblem = outcome;
            s.read = true;
        });
    }
    if (!s.run(s.read, deadline)) return std::optional<WebSocketMessage>();
    if (s.readProblem) return brokenError(s.readProblem, s.where);
    const auto* first = static_cast<const std::uint8_t*>(s.buffer.data().data());
    WebSocketMessage message{s.stream->got_text(), Bytes(first, first + s.buffer.size()), scanner::hostNow()};
    s.buffer.consume(s.buffer.size());
    if (s.buffer.capacity() > kLongestMessage / 8) s.buffer.shrink_to_fit();
    return std::optional(std::move(message));
}

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
