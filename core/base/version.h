// The program's version, as CMake's project() says it.
#pragma once

namespace edgescan {

/// "0.1.0".
[[nodiscard]] const char* version();

} // namespace edgescan
