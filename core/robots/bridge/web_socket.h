// One WebSocket to a bridge, used by one thread.
#pragma once

#include "core/base/bytes.h"
#include "core/scanner/cola/link.h"

#include <optional>
#include <string>

namespace edgescan::robots {

struct WebSocketMessage {
    bool isText = false;
    Bytes bytes;
    scanner::HostTime received;
};

class WebSocket : public scanner::Link {
public:
    WebSocket();

    Result<Done> send(const std::string& text, Clock::duration timeout);
    /// Empty if the deadline passes or another thread interrupts. Error: the connection is gone, or a message is longer than 64 MB.
    Result<std::optional<WebSocketMessage>> receive(Clock::time_point deadline);

private:
    struct Messages;
    [[nodiscard]] Messages& messages() const;
};

} // namespace edgescan::robots
