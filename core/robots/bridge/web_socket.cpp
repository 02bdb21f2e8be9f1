// One WebSocket to a bridge (Boost.Beast).
#include "core/robots/bridge/web_socket.h"
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

} // namespace edgescan::robots
