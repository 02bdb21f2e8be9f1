// Appends bytes to a growing file: either all of them are written, or the file stays as it was.
#pragma once

#include <string>

namespace edgescan {

/// Appends all of `bytes` to the open file, or leaves the file as it was. Returns 0 or the system's error number (errno).
[[nodiscard]] int appendWhole(int file, const std::string& bytes);

} // namespace edgescan
