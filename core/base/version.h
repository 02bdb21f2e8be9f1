// The program's version, as CMake's project() says it.
#pragma once

namespace edgescan {

/// "0.1.0".
[[nodiscard]] const char* version();

/// The commit it was built from, "unknown" where nobody said.
[[nodiscard]] const char* commit();

} // namespace edgescan
