// One TCP connection, used by one thread. Waits have a deadline, and end at once if another thread interrupts.
#pragma once

#include "core/base/result.h"
#include "core/scanner/cola/frames.h"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// What every connection has, whatever protocol it speaks.
class Link {
public:
    using Clock = std::chrono::steady_clock;

    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    /// Host name, IPv4 or IPv6 address. Closes an earlier connection and starts a new byte stream.
    Result<Done> connect(const std::string& host, std::uint16_t port, Clock::duration timeout);
    void close();

    /// Sleeps; ends early when interrupted.
    void pause(Clock::duration duration);

    /// From any thread, permanently: the current wait ends now, and every later one at once.
    void interrupt();
    [[nodiscard]] bool interrupted() const;

protected:
    struct Socket; // so that this header does not include Boost.Asio
    explicit Link(std::unique_ptr<Socket> socket);
    ~Link();

    const std::unique_ptr<Socket> socket_;
};

/// To a scanner.
class ColaLink : public Link {
public:
    /// Called on the thread that uses the link: `received` for every frame before it is parsed, `sent` for every frame that was written.
    /// Either may be empty.
    struct Hooks {
        std::function<void(const ColaFrame&)> received;
        std::function<void(const ColaFrame&)> sent;
    };

    explicit ColaLink(Hooks hooks);

    Result<Done> send(ByteView payload, Dialect dialect, Clock::duration timeout);
    /// The frames of the next bytes that arrive; empty if the deadline passes or another thread interrupts. Error: the connection is gone.
    Result<std::vector<ColaFrame>> receive(Clock::time_point deadline);

    /// Counts of all connections of this link together. Any thread.
    [[nodiscard]] ColaCounts counts() const;

private:
    struct Frames;
    [[nodiscard]] Frames& frames() const;
};

/// "192.168.0.1:2112", "[fe80::1]:2112".
[[nodiscard]] std::string addressText(const std::string& host, std::uint16_t port);

} // namespace edgescan::scanner
