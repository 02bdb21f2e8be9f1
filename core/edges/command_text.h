// The command line that computes the same edges: "Copy as command".
#pragma once

#include "core/edges/settings.h"

#include <string>

namespace edgescan {

/// edgescan-cli detect 'PATH' --preset NAME --lower 12 ...: the nearest built-in preset and what differs from it. The path is
/// quoted for a POSIX shell.
[[nodiscard]] std::string detectCommand(const std::string& path, const Settings& settings);

} // namespace edgescan
