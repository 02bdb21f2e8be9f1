// The socket of a link (Boost.Asio). It never listens, and connects only to the address given to connect().
#pragma once

#include "core/scanner/cola/link.h"

#include <boost/asio.hpp>

#include <atomic>

namespace edgescan::scanner {

struct Link::Socket {
    using error_code = boost::system::error_code;
    using tcp = boost::asio::ip::tcp;

    /// What the operator can do if a connection fails.
    struct Hints {
        std::string silent, refused;
    };

    explicit Socket(Hints given) : hints(std::move(given)) {}
    virtual ~Socket() = default;
    virtual Result<Done> connect(const tcp::endpoint& endpoint, Clock::time_point deadline) = 0;
    virtual void close() = 0;

    /// Runs until `done`, the deadline or an interruption. Returns false if not done. After the deadline it takes what is ready: a computer
    /// that was busy or asleep for longer than a timeout reads what arrived meanwhile, before it calls the scanner silent.
    bool run(const bool& done, Clock::time_point deadline);
    /// After a cancellation: waits until the handler has returned, because it refers to variables on the stack.
    void drain(const bool& done);
    /// The addresses of a host; an IPv4 or IPv6 address is returned as it is. A name is looked up on a separate thread, which is abandoned
    /// if the deadline passes or another thread interrupts: a name server that does not answer cannot block the caller.
    Result<std::vector<boost::asio::ip::address>> lookUp(const std::string& host, Clock::time_point deadline);
    [[nodiscard]] Error connectError(const error_code& problem, bool late) const;

    const Hints hints;
    std::atomic<bool> stop{false};
    boost::asio::io_context context{1};
    boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work{context.get_executor()};
    std::string where;
};

} // namespace edgescan::scanner
