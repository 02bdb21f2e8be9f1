// HOST[:PORT] as typed: a name, an IPv4 address, or an IPv6 address (in brackets if a port follows); ws:// in front of a robot's
// bridge.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>

namespace edgescan::scanner {

struct HostPort {
    std::string host;
    std::uint16_t port = 2112; ///< SICK's second CoLa port, the default of sick_scan_xd; 8765 of a bridge
    bool portTyped = false;
    bool bridge = false; ///< ws://HOST
};

/// Error: the host is missing or the port is invalid.
[[nodiscard]] Result<HostPort> hostPort(const std::string& typed);

} // namespace edgescan::scanner
