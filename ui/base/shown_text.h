// Text on its way into the window. Code with a std::string decides here between text for display and bytes that must not change. No other
// file of ui/ converts a std::string to a QString (tests/cli/exits_test.cpp).
#pragma once

#include <QString>

#include <string>

namespace edgescan::ui {

/// For a label, a title, a note: printable line by line (core/base/foreign_text.h), at most 20 lines.
[[nodiscard]] QString shownText(const std::string& text);
[[nodiscard]] QString shownText(const QString& text);

/// The same on one line with at most so many characters: the middle of a longer name is left out (…).
[[nodiscard]] QString shownName(const QString& name, int mostCharacters = 120);
/// The name of one of two scans: where it is too long, what both names have in common is left out first.
[[nodiscard]] QString shownApart(const QString& name, const QString& other, int mostCharacters);

/// Millimetres below 0.1 m, else metres with three digits: "53 mm", "0.532 m", "12.3 m".
[[nodiscard]] QString shortLength(double metres);

/// For paths, settings and the clipboard: unchanged. A byte that is not UTF-8, as a file name may hold it, is one character
/// (core/base/foreign_text.h, escapedBytes()).
[[nodiscard]] QString exactText(const std::string& text);

/// The bytes that exactText() was given: for each path on its way out of the window.
[[nodiscard]] std::string exactBytes(const QString& text);

/// Qt's functions of files do not know these names. Each of the following does.
[[nodiscard]] bool isFile(const QString& path);
[[nodiscard]] QString absolutePath(const QString& path);

} // namespace edgescan::ui
