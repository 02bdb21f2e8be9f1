// Bytes at the end of a file that grows: whole, or not at all.
#pragma once

#include <string>

namespace edgescan {

/// What is written stands at the end of the open file wholly, or not at all. Gives 0 or the system's error number.
[[nodiscard]] int appendWhole(int file, const std::string& bytes);

} // namespace edgescan
