// Looks up the addresses of a host name. A name server that does not answer cannot block the caller.
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// The addresses of a host; an IPv4 or IPv6 address is returned as it is. A name is looked up on a separate thread, which is abandoned if
/// the deadline passes or `wait` returns false. `wait` is called with the time to sleep.
[[nodiscard]] Result<std::vector<std::string>> lookUp(const std::string& host, std::chrono::steady_clock::time_point deadline,
                                                      const std::function<bool(std::chrono::steady_clock::duration)>& wait);

} // namespace edgescan::scanner
