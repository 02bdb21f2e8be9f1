// Text as one word of a shell.
#pragma once

#include "core/base/foreign_text.h"

#include <string>

namespace edgescan {

/// In single quotes, as a POSIX shell takes it for one word. With characters in it that are not printable() as $'...' with octal numbers,
/// which bash, zsh and ksh know: pasted as they are they would be keys to the terminal.
[[nodiscard]] inline std::string shellQuoted(const std::string& text) {
    const bool controls = printable(text, text.size() + 1) != text;
    std::string result = controls ? "$'" : "'";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (controls && (byte < 0x20 || byte >= 0x7F || c == '\'' || c == '\\'))
            result += {'\\', static_cast<char>('0' + (byte >> 6U)), static_cast<char>('0' + (byte >> 3U & 7U)),
                       static_cast<char>('0' + (byte & 7U))};
        else
            result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result + "'";
}

} // namespace edgescan
