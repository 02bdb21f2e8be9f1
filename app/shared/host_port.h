// HOST[:PORT] as typed: a name, an IPv4 address, or an IPv6 address in brackets when a port follows.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>

namespace edgescan::cli {

struct HostPort {
    std::string host;
    std::uint16_t port = 2112; ///< SICK's second CoLa port, as sick_scan_xd uses it
};

/// Error: no host, or a port that is none.
[[nodiscard]] Result<HostPort> hostPort(const std::string& typed);

} // namespace edgescan::cli
