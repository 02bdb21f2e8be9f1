// Texts that the core makes, on their way into the window: in its language, with the names of its fields instead of flags of the command
// line.
#pragma once

#include "core/scan/grid/scan.h"

#include <QString>

#include <string>

namespace edgescan::ui {

/// For the texts of the core that take their language: a Translated.
[[nodiscard]] std::string inLanguage(const char* text);

/// A short text of a live scanner, such as "LOST 12 s" or "no return 4.2 %", in the language of the window.
[[nodiscard]] QString coreWords(const std::string& text);

/// "no return", "out of window", in the language of the window.
[[nodiscard]] QString cellStateText(CellState state);

/// Name of a scan: that of a live sweep or of the demo in the language of the window, any other as it is.
[[nodiscard]] QString scanName(const std::string& name, int mostCharacters = 120);

/// Sentences: an error, a warning, a remark. Their known parts are translated, and "--unit m" becomes the place in the window where it is
/// set: for a scan that is read, or for a scanner. Other text stays.
enum class SetFor : std::uint8_t { Scan, Scanner };
[[nodiscard]] QString coreSentence(const QString& text, SetFor what = SetFor::Scan);
[[nodiscard]] QString coreSentence(const std::string& text, SetFor what = SetFor::Scan);

/// "▲ mounting assumed", "▲ step assumed"; empty: neither is.
[[nodiscard]] QString assumedText(const Scan& scan);

} // namespace edgescan::ui
