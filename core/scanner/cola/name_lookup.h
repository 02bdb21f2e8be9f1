// From a host name to addresses, without being held up by a name server that does not answer.
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace edgescan {

/// The addresses of a host; an IPv4 or IPv6 address is its own. A name is looked up on a thread of its own that is left behind when the
/// deadline passes or `wait` gives false; `wait` is called with how long to sleep.
[[nodiscard]] Result<std::vector<std::string>> lookUp(const std::string& host, std::chrono::steady_clock::time_point deadline,
                                                      const std::function<bool(std::chrono::steady_clock::duration)>& wait);

} // namespace edgescan
