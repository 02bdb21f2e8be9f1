// Text quoted as one word of a shell.
#pragma once

#include "core/base/foreign_text.h"

#include <filesystem>
#include <string>

namespace edgescan {

/// In single quotes, so that a POSIX shell reads it as one word. Text with unprintable characters (see printable()) is written as $'...'
/// with octal numbers, which bash, zsh and ksh read: pasted unquoted, such characters would act as key presses in the terminal.
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

/// The name of a file or a folder without the folders above it. What leaves the house names no home and no user.
[[nodiscard]] inline std::string fileName(const std::filesystem::path& path) {
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

} // namespace edgescan
