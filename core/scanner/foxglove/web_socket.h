// One WebSocket to a bridge, used by one thread. Waits have a deadline, and end at once if another thread interrupts.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/scanner/cola/host_time.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace edgescan::scanner {

struct WebSocketMessage {
    bool isText = false;
    Bytes bytes;
    HostTime received;
};

class WebSocket {
public:
    using Clock = std::chrono::steady_clock;

    WebSocket();
    ~WebSocket();
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;

    /// Host name, IPv4 or IPv6 address. Closes an earlier connection.
    Result<Done> connect(const std::string& host, std::uint16_t port, Clock::duration timeout);
    Result<Done> send(const std::string& text, Clock::duration timeout);
    /// Empty if the deadline passes or another thread interrupts. Error: the connection is gone, or a message is longer than 64 MB.
    Result<std::optional<WebSocketMessage>> receive(Clock::time_point deadline);
    void close();

    /// Sleeps; ends early when interrupted.
    void pause(Clock::duration duration);

    /// From any thread, permanently: the current wait ends now, and every later one at once.
    void interrupt();
    [[nodiscard]] bool interrupted() const;

private:
    struct Socket; // so that this header does not include Boost.Beast
    std::unique_ptr<Socket> socket_;
};

} // namespace edgescan::scanner
