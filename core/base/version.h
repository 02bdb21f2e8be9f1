// The program's version, from CMake's project().
#pragma once

namespace edgescan {

/// "0.1.0".
[[nodiscard]] const char* version();

/// The commit of the sources, or "unknown" if the build did not set it.
[[nodiscard]] const char* commit();

} // namespace edgescan
