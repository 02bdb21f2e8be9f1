// Text on its way into the window. Whoever has a std::string decides here what it is: words to be looked at, or bytes to be kept as they
// are. Nothing else in ui/ turns one into a QString (tests/cli/exits_test.cpp).
#pragma once

#include <QString>

#include <string>

namespace edgescan::ui {

/// For a label, a title, a note: printable line by line (core/base/foreign_text.h), 20 lines at most.
[[nodiscard]] QString shownText(const std::string& text);
[[nodiscard]] QString shownText(const QString& text);

/// The same on one line, where there is room for so many characters: of a longer name the middle is left out (…).
[[nodiscard]] QString shownName(const QString& name, int mostCharacters = 120);

/// Millimetres below a tenth of a metre, else metres in three digits: "53 mm", "0.532 m", "12.3 m".
[[nodiscard]] QString shortLength(double metres);

/// For paths, settings and the clipboard: as it is.
[[nodiscard]] QString exactText(const std::string& text);

} // namespace edgescan::ui
