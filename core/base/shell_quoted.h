// Text as one word of a shell.
#pragma once

#include <string>

namespace edgescan {

/// In single quotes, as a POSIX shell takes it for one word.
[[nodiscard]] inline std::string shellQuoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

} // namespace edgescan
