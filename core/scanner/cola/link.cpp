// One TCP connection, and the frames of a scanner on it.
#include "core/base/translated_text.h"
#include "core/scanner/cola/link_socket.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <thread>

namespace edgescan::scanner {

namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using tcp = asio::ip::tcp;

/// Shared with the thread that looks up a name. That thread may outlive the link.
struct Lookup {
    std::mutex mutex;
    std::vector<asio::ip::address> addresses; ///< without one the name is not known
    bool done = false;
};

void resolve(const std::shared_ptr<Lookup>& lookup, const std::string& host) {
    asio::io_context context;
    error_code unknown;
    const auto found = tcp::resolver(context).resolve(host, "", unknown);
    const std::lock_guard lock(lookup->mutex);
    for (const auto& entry : found) {
        const asio::ip::address address = entry.endpoint().address();
        if (std::ranges::find(lookup->addresses, address) == lookup->addresses.end()) lookup->addresses.push_back(address);
    }
    lookup->done = true;
}

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

} // namespace

bool Link::Socket::run(const bool& done, Clock::time_point deadline) {
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

void Link::Socket::drain(const bool& done) {
    while (!done) {
        context.restart();
        context.run_one();
    }
}

Result<std::vector<asio::ip::address>> Link::Socket::lookUp(const std::string& host, Clock::time_point deadline) {
    if (host.empty()) return Error{"no scanner is given", where, "give its IP address or host name"};
    const bool bracketed = host.starts_with('[') && host.ends_with(']');
    const std::string bare = bracketed ? host.substr(1, host.size() - 2) : host;
    error_code isName;
    const auto literal = asio::ip::make_address(bare, isName);
    if (!isName) return std::vector{literal};
    const auto lookup = std::make_shared<Lookup>();
    std::thread([lookup, bare] { resolve(lookup, bare); }).detach();
    while (true) {
        {
            const std::lock_guard lock(lookup->mutex);
            if (!lookup->addresses.empty()) return lookup->addresses;
            if (lookup->done) return Error{"the host name is not known", where, "check its spelling or use the scanner's IP address"};
        }
        if (Clock::now() >= deadline) return Error{"the name server does not answer", where, "use the scanner's IP address"};
        run(false, Clock::now() + std::chrono::milliseconds(5));
        if (stop) return Error{"interrupted", where, {}};
    }
}

Error Link::Socket::connectError(const error_code& problem, bool late) const {
    if (late || problem == asio::error::timed_out) return {"nothing answers there", where, hints.silent};
    if (problem == asio::error::connection_refused) return {"the connection is refused", where, hints.refused};
    if (problem == asio::error::host_unreachable || problem == asio::error::network_unreachable || problem == asio::error::network_down)
        return {"there is no way to this address", where, "check the cable and the network settings of this computer"};
    return {withValues("cannot connect (%1)", {problem.message()}), where, "check the address and the network settings of this computer"};
}

Link::Link(std::unique_ptr<Socket> socket) : socket_(std::move(socket)) {}
Link::~Link() { close(); }

Result<Done> Link::connect(const std::string& host, std::uint16_t port, Clock::duration timeout) {
    Socket& s = *socket_;
    close();
    s.where = addressText(host, port);
    const auto deadline = Clock::now() + timeout;
    const auto addresses = s.lookUp(host, deadline);
    if (!addresses) return addresses.error();
    Result<Done> outcome = Done{};
    for (const asio::ip::address& address : *addresses) {
        // Each address is tried for its own time; a host has one or two.
        outcome = s.connect({address, port}, std::max(deadline, Clock::now() + timeout / 2));
        if (outcome || s.stop) return outcome;
    }
    return outcome;
}

void Link::close() { socket_->close(); }

void Link::pause(Clock::duration duration) { socket_->run(false, Clock::now() + duration); }

void Link::interrupt() {
    socket_->stop = true;
    asio::post(socket_->context, [] {});
}

bool Link::interrupted() const { return socket_->stop; }

struct ColaLink::Frames : Link::Socket {
    explicit Frames(Hooks given)
        : Socket({"check power, cable and the address, and that this computer is in the scanner's network",
                  "check the port (2111 or 2112) and that no other program holds the scanner"}),
          hooks(std::move(given)) {}

    Result<Done> connect(const tcp::endpoint& endpoint, Clock::time_point deadline) override;
    void close() override {
        error_code ignored;
        socket.shutdown(tcp::socket::shutdown_both, ignored);
        socket.close(ignored);
        earlier = all;
        stream = ColaStream();
    }
    void count();

    Hooks hooks;
    tcp::socket socket{context};
    ColaStream stream;
    std::array<std::uint8_t, 65536> piece{};
    mutable std::mutex mutex; ///< protects `all`, which only the thread of the link changes
    ColaCounts earlier;       ///< counts of closed connections
    ColaCounts all;
};

Result<Done> ColaLink::Frames::connect(const tcp::endpoint& endpoint, Clock::time_point deadline) {
    error_code problem;
    socket.open(endpoint.protocol(), problem);
    if (problem) return connectError(problem, false);
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
    return connectError(problem, !inTime);
}

void ColaLink::Frames::count() {
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

ColaLink::ColaLink(Hooks hooks) : Link(std::make_unique<Frames>(std::move(hooks))) {}

ColaLink::Frames& ColaLink::frames() const { return static_cast<Frames&>(*socket_); }

Result<Done> ColaLink::send(ByteView payload, Dialect dialect, Clock::duration timeout) {
    Frames& s = frames();
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
    if (problem) return Error{withValues("a command cannot be sent (%1)", {problem.message()}), s.where, "check the cable"};
    if (s.hooks.sent) s.hooks.sent(frame);
    return Done{};
}

Result<std::vector<ColaFrame>> ColaLink::receive(Clock::time_point deadline) {
    Frames& s = frames();
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
    if (problem == asio::error::eof) {
        const bool speaks = counts().frames > 0;
        return Error{"the scanner closed the connection", s.where,
                     speaks ? std::string() : "check that a scanner of SICK answers there; a robot's Foxglove bridge is ws://HOST"};
    }
    if (problem) return Error{withValues("the connection broke (%1)", {problem.message()}), s.where, {}};
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

ColaCounts ColaLink::counts() const {
    const std::lock_guard lock(frames().mutex);
    return frames().all;
}

std::string addressText(const std::string& host, std::uint16_t port) {
    const bool bare6 = host.find(':') != std::string::npos && !host.starts_with('[');
    return (bare6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

} // namespace edgescan::scanner
