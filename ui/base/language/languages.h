// Which languages the window speaks.
#pragma once

#include <QString>
#include <QStringList>

#include <array>

namespace edgescan::ui {

struct Language {
    const char* code; ///< ISO 639-1
    const char* name; ///< in itself
};
/// English first: it is what stands in the sources.
inline constexpr std::array<Language, 4> kLanguages{{{"en", "English"}, {"fr", "Français"}, {"es", "Español"}, {"pt", "Português"}}};

/// The first of the languages of the system ("fr-CA", "en-US" ...) that the window speaks; "en" when it speaks none of them.
[[nodiscard]] QString languageOfSystem(const QStringList& spoken);

/// Installs the texts of a language, and Qt's own where they are installed, before the first widget is made. Empty: that of the system.
/// False: it is not spoken, and the window is in English. `folder`: where the .ts files are.
bool useLanguage(const QString& code, const QString& folder = ":/languages");

/// What useLanguage() chose last.
[[nodiscard]] QString languageInUse();

} // namespace edgescan::ui
