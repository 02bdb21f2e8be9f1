// The languages of the window.
#pragma once

#include <QString>
#include <QStringList>

#include <array>

namespace edgescan::ui {

struct Language {
    const char* code; ///< ISO 639-1
    const char* name; ///< in its own language
};
/// English first: the sources are in English.
inline constexpr std::array<Language, 4> kLanguages{{{"en", "English"}, {"fr", "Français"}, {"es", "Español"}, {"pt", "Português"}}};

/// The first of the system's languages ("fr-CA", "en-US" ...) that the window has; "en" if it has no translation for any of them.
[[nodiscard]] QString languageOfSystem(const QStringList& spoken);

/// Installs the texts of a language, and Qt's own translations if the system has them, before the first widget is made. Empty: the language
/// of the system. Returns false if the window has no such language; the window is then in English. `folder`: the folder of the .ts files.
bool useLanguage(const QString& code, const QString& folder = ":/languages");

/// The language that useLanguage() chose last.
[[nodiscard]] QString languageInUse();

/// Patterns of the core's sentences that have a translation; empty in English.
[[nodiscard]] const QStringList& sentencesOfTheCore();

} // namespace edgescan::ui
