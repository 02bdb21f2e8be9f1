// The command line that computes the same edges: "Copy as command".
#pragma once

#include "core/edges/settings/settings.h"

#include <string>

namespace edgescan::edges {

/// "--preset NAME --lower 12 ...": the nearest built-in preset and the differences from it.
[[nodiscard]] std::string settingsFlags(const Settings& settings);

/// PROGRAM detect 'PATH' READFLAGS and settingsFlags(). The path is quoted for a POSIX shell; `program` and `readFlags` ("--axis spin ...",
/// may be empty) are inserted unchanged.
[[nodiscard]] std::string detectCommand(const std::string& program, const std::string& path, const std::string& readFlags,
                                        const Settings& settings);

} // namespace edgescan::edges
