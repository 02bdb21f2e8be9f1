// One WebSocket to a bridge (Boost.Beast). This file never listens, and connects only to the address given to connect().
#include "core/scanner/foxglove/web_socket.h"

#include "core/scanner/cola/link.h"
#include "core/scanner/cola/name_lookup.h"

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include <atomic>

namespace edgescan::scanner {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;
using tcp = asio::ip::tcp;

constexpr std::size_t kLongestMessage = std::size_t{64} << 20U;
constexpr const char* kProtocols = "foxglove.sdk.v1, foxglove.websocket.v1";

Error connectError(const error_code& problem, bool late, const std::string& where) {
    if (late || problem == asio::error::timed_out)
        return {"nothing answers there", where, "check power, cable and the address, and that this computer is in the robot's network"};
    if (problem == asio::error::connection_refused)
        return {"the connection is refused", where, "check the port (8765) and that foxglove_bridge runs on the robot"};
    if (problem == asio::error::host_unreachable || problem == asio::error::network_unreachable || problem == asio::error::network_down)
        return {"there is no way to this address", where, "check the cable and the network settings of this computer"};
    return {"cannot connect (" + problem.message() + ")", where, "check the address and the network settings of this computer"};
}

Error brokenError(const error_code& problem, const std::string& where) {
    if (problem == asio::error::eof || problem == websocket::error::closed) return {"the bridge closed the connection", where, {}};
    if (problem == websocket::error::message_too_big || problem == websocket::error::buffer_overflow)
        return {"the bridge sends a message of more than 64 MB", where, "choose another topic"};
    return {"the connection broke (" + problem.message() + ")", where, {}};
}

} // namespace

struct WebSocket::Socket {
    using Stream = websocket::stream<tcp::socket>;

    /// Runs until `done`, the deadline or an interruption; after the deadline what is ready.
    bool run(const bool& done, Clock::time_point deadline) {
        while (!done && !stop && Clock::now() < deadline) {
            context.restart();
            context.run_one_until(deadline);
        }
        if (!done && !stop) {
            context.restart();
            context.poll();
        }
        return done;
    }
    /// After closing: waits until a handler has returned that refers to variables of this object or of the stack.
    void drain(const bool& done) {
        while (!done) {
            context.restart();
            context.run_one();
        }
    }
    void close() {
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

    Result<Done> connect(const tcp::endpoint& endpoint, Clock::time_point deadline);

    std::atomic<bool> stop{false};
    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> work{context.get_executor()};
    std::optional<Stream> stream;
    std::string where;
    beast::flat_buffer buffer{kLongestMessage};
    bool read = true; ///< no reading is under way
    error_code readProblem;
};

Result<Done> WebSocket::Socket::connect(const tcp::endpoint& endpoint, Clock::time_point deadline) {
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
        return connectError(problem, !inTime, where);
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
        return Error{"what answers there is not a Foxglove bridge", where, "check the port (8765) and that foxglove_bridge runs there"};
    }
    return Done{};
}

WebSocket::WebSocket() : socket_(std::make_unique<Socket>()) {}
WebSocket::~WebSocket() { close(); }

Result<Done> WebSocket::connect(const std::string& host, std::uint16_t port, Clock::duration timeout) {
    Socket& s = *socket_;
    close();
    s.where = addressText(host, port);
    const auto deadline = Clock::now() + timeout;
    const auto addresses = lookUp(host, deadline, [&](Clock::duration duration) {
        pause(duration);
        return !s.stop;
    });
    if (!addresses) return Error{addresses.error().what, s.where, addresses.error().hint};
    Result<Done> outcome = Error{"the name has no address", s.where, "use the robot's IP address"};
    for (const std::string& address : *addresses) {
        error_code problem;
        const auto literal = asio::ip::make_address(address, problem);
        if (problem) continue;
        outcome = s.connect({literal, port}, std::max(deadline, Clock::now() + timeout / 2));
        if (outcome || s.stop) return outcome;
    }
    return outcome;
}

Result<Done> WebSocket::send(const std::string& text, Clock::duration timeout) {
    Socket& s = *socket_;
    if (!s.stream) return Error{"the connection is closed", s.where, {}};
    error_code problem;
    bool done = false;
    s.stream->text(true);
    s.stream->async_write(asio::buffer(text), [&](const error_code& outcome, std::size_t) {
        problem = outcome;
        done = true;
    });
    if (!s.finished(done, Clock::now() + timeout)) problem = asio::error::timed_out;
    if (problem) return Error{"the subscription cannot be sent (" + problem.message() + ")", s.where, "check the network"};
    return Done{};
}

Result<std::optional<WebSocketMessage>> WebSocket::receive(Clock::time_point deadline) {
    Socket& s = *socket_;
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
    WebSocketMessage message{s.stream->got_text(), Bytes(first, first + s.buffer.size()), hostNow()};
    s.buffer.consume(s.buffer.size());
    if (s.buffer.capacity() > kLongestMessage / 8) s.buffer.shrink_to_fit();
    return std::optional(std::move(message));
}

void WebSocket::close() { socket_->close(); }

void WebSocket::pause(Clock::duration duration) {
    const bool never = false;
    socket_->run(never, Clock::now() + duration);
}

void WebSocket::interrupt() {
    socket_->stop = true;
    asio::post(socket_->context, [] {});
}

bool WebSocket::interrupted() const { return socket_->stop; }

} // namespace edgescan::scanner
