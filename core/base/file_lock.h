// A lock on an open file between programs (flock). It ends when the file is closed.
#pragma once

#include <chrono>

namespace edgescan {

enum class Lock {
    Acquired,
    Busy,   ///< another program holds it
    Unknown ///< a file system without locks
};

/// Tries until `within` has passed.
[[nodiscard]] Lock lockFile(int file, std::chrono::milliseconds within = std::chrono::milliseconds(0));

/// Whether another program has locked the file; false if it cannot be opened.
[[nodiscard]] bool isLocked(const char* path);

} // namespace edgescan
