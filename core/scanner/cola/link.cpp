// One TCP connection to a scanner (Boost.Asio). This file never listens, and connects only to the address given to connect().
#include "core/scanner/cola/link.h"

#include "core/scanner/cola/name_lookup.h"

#include <boost/asio.hpp>

#include <array>
#include <atomic>
#include <mutex>

namespace edgescan::scanner {

namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using tcp = asio::ip::tcp;

constexpr int kReceiveBuffer = 1 << 20; ///< bytes; ten seconds of data from a scanner that sends text

/// At least 1 MiB, if the system allows it. A smaller fixed buffer would be worse than the one that the system grows by itself.
void widenReceiveBuffer(tcp::socket& socket, const tcp& protocol) {
#ifdef SO_RCVBUFFORCE
    const int wanted = kReceiveBuffer;
    if (::setsockopt(socket.native_handle(), SOL_SOCKET, SO_RCVBUFFORCE, &wanted, sizeof wanted) == 0) return;
#endif
    error_code ignored;
    tcp::socket trial(socket.get_executor());
    asio::socket_base::receive_buffer_size size(kReceiveBuffer);
    trial.open(protocol, ignored);
    trial.set_option(size, ignored);
    trial.get_option(size, ignored);
    if (size.value() >= kReceiveBuffer) socket.set_option(asio::socket_base::receive_buffer_size(kReceiveBuffer), ignored);
}

Error connectError(const error_code& problem, bool late, const std::string& where) {
    if (late || problem == asio::error::timed_out)
        return {"nothing answers there", where, "check power, cable and the address, and that this computer is in the scanner's network"};
    if (problem == asio::error::connection_refused)
        return {"the connection is refused", where, "check the port (2111 or 2112) and that no other program holds the scanner"};
    if (problem == asio::error::host_unreachable || problem == asio::error::network_unreachable || problem == asio::error::network_down)
        return {"there is no way to this address", where, "check the cable and the network settings of this computer"};
    return {"cannot connect (" + problem.message() + ")", where, "check the address and the network settings of this computer"};
}

} // namespace

struct ColaLink::Socket {
    explicit Socket(Hooks given) : hooks(std::move(given)) {}

    /// Runs until `done`, the deadline or an interruption. Returns false if not done.
    bool run(const bool& done, Clock::time_point deadline) {
        while (!done && !stop && Clock::now() < deadline) {
            context.restart();
            context.run_one_until(deadline);
        }
        return done;
    }
    /// After a cancellation: waits until the handler has returned, because it refers to variables on the stack.
    void drain(const bool& done) {
        while (!done) {
            context.restart();
            context.run_one();
        }
    }
    void close() {
        error_code ignored;
        socket.shutdown(tcp::socket::shutdown_both, ignored);
        socket.close(ignored);
    }

    Result<Done> connect(const tcp::endpoint& endpoint, Clock::time_point deadline);
    void count();

    Hooks hooks;
    std::atomic<bool> stop{false};
    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> work{context.get_executor()};
    tcp::socket socket{context};
    std::string where;
    ColaStream stream;
    std::array<std::uint8_t, 65536> piece{};
    mutable std::mutex mutex;
    ColaCounts earlier; ///< counts of closed connections
    ColaCounts all;
};

Result<Done> ColaLink::Socket::connect(const tcp::endpoint& endpoint, Clock::time_point deadline) {
    error_code problem;
    socket.open(endpoint.protocol(), problem);
    if (problem) return connectError(problem, false, where);
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    widenReceiveBuffer(socket, endpoint.protocol());
    bool done = false;
    socket.async_connect(endpoint, [&](const error_code& outcome) {
        problem = outcome;
        done = true;
    });
    const bool inTime = run(done, deadline);
    if (!inTime) {
        socket.close(ignored);
        drain(done);
    }
    if (inTime && !problem) {
        socket.non_blocking(true, ignored);
        return Done{};
    }
    socket.close(ignored);
    return connectError(problem, !inTime, where);
}

void ColaLink::Socket::count() {
    const std::lock_guard lock(mutex);
    const ColaCounts& now = stream.counts();
    all = earlier;
    all.bytes += now.bytes;
    all.frames += now.frames;
    all.skipped += now.skipped;
    all.badChecksum += now.badChecksum;
    all.tooLong += now.tooLong;
    all.notCola += now.notCola;
    all.torn += now.torn;
}

ColaLink::ColaLink(Hooks hooks) : socket_(std::make_unique<Socket>(std::move(hooks))) {}
ColaLink::~ColaLink() { close(); }

Result<Done> ColaLink::connect(const std::string& host, std::uint16_t port, Clock::duration timeout) {
    Socket& s = *socket_;
    close();
    s.earlier = counts();
    s.stream = ColaStream();
    s.where = addressText(host, port);
    const auto deadline = Clock::now() + timeout;
    const auto addresses = lookUp(host, deadline, [&](Clock::duration duration) {
        pause(duration);
        return !s.stop;
    });
    if (!addresses) return Error{addresses.error().what, s.where, addresses.error().hint};
    Result<Done> outcome = Error{"the name has no address", s.where, "use the scanner's IP address"};
    for (const std::string& address : *addresses) {
        error_code problem;
        const auto literal = asio::ip::make_address(address, problem);
        if (problem) continue;
        // Each address is tried for its own time; a host has one or two.
        outcome = s.connect({literal, port}, std::max(deadline, Clock::now() + timeout / 2));
        if (outcome || s.stop) return outcome;
    }
    return outcome;
}

Result<Done> ColaLink::send(ByteView payload, Dialect dialect, Clock::duration timeout) {
    Socket& s = *socket_;
    const ColaFrame frame{dialect, framed(payload, dialect), hostNow(), 0, 0};
    error_code problem;
    bool done = false;
    asio::async_write(s.socket, asio::buffer(frame.bytes), [&](const error_code& outcome, std::size_t) {
        problem = outcome;
        done = true;
    });
    if (!s.run(done, Clock::now() + timeout)) {
        error_code ignored;
        s.socket.cancel(ignored);
        s.drain(done);
        if (!problem || problem == asio::error::operation_aborted) problem = asio::error::timed_out;
    }
    if (problem) return Error{"a command cannot be sent (" + problem.message() + ")", s.where, "check the cable"};
    if (s.hooks.sent) s.hooks.sent(frame);
    return Done{};
}

Result<std::vector<ColaFrame>> ColaLink::receive(Clock::time_point deadline) {
    Socket& s = *socket_;
    error_code problem;
    bool done = false;
    s.socket.async_wait(tcp::socket::wait_read, [&](const error_code& outcome) {
        problem = outcome;
        done = true;
    });
    if (!s.run(done, deadline)) {
        error_code ignored;
        s.socket.cancel(ignored);
        s.drain(done);
        return std::vector<ColaFrame>{};
    }
    const std::size_t count = problem ? 0 : s.socket.read_some(asio::buffer(s.piece), problem);
    const HostTime now = hostNow();
    if (problem == asio::error::would_block || problem == asio::error::interrupted) return std::vector<ColaFrame>{};
    if (problem == asio::error::eof) return Error{"the scanner closed the connection", s.where, {}};
    if (problem) return Error{"the connection broke (" + problem.message() + ")", s.where, {}};
    std::vector<ColaFrame> frames = s.stream.push(ByteView(s.piece).first(count), now);
    s.count();
    // An interruption counts between two frames, too: a peer may send thousands at once.
    std::size_t seen = 0;
    for (; seen < frames.size() && !s.stop; ++seen) {
        if (s.hooks.received) s.hooks.received(frames[seen]);
    }
    frames.resize(seen);
    return frames;
}

void ColaLink::close() { socket_->close(); }

void ColaLink::pause(Clock::duration duration) {
    const bool never = false;
    socket_->run(never, Clock::now() + duration);
}

void ColaLink::interrupt() {
    socket_->stop = true;
    asio::post(socket_->context, [] {});
}

bool ColaLink::interrupted() const { return socket_->stop; }

ColaCounts ColaLink::counts() const {
    const std::lock_guard lock(socket_->mutex);
    return socket_->all;
}

std::string addressText(const std::string& host, std::uint16_t port) {
    const bool bare6 = host.find(':') != std::string::npos && !host.starts_with('[');
    return (bare6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

} // namespace edgescan::scanner
