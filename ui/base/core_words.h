// Texts that the core makes, on their way into the window: in its language, with the names of its fields instead of flags of the command
// line.
#pragma once

#include "core/scan/grid/scan.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>

#include <string>
#include <utility>
#include <vector>

namespace edgescan::ui {

/// For the texts of the core that take their language: a Translated.
[[nodiscard]] std::string inLanguage(const char* text);

/// A short text of a live scanner, such as "LOST 12 s" or "no return 4.2 %", in the language of the window.
[[nodiscard]] QString coreWords(const std::string& text);

/// Texts of the core, in which %1 to %9 are any text and %n is a number.
class CoreTexts {
public:
    /// `whole`: each is a text of its own; otherwise they are parts of longer ones.
    CoreTexts(const QStringList& sources, bool whole);
    /// What is one of them in the language of the window; the rest as it is. `inner` translates the values; null: nothing.
    [[nodiscard]] QString translated(QString text, QString (*inner)(const QString&) = nullptr) const;

private:
    struct Text {
        QByteArray source;
        QString words;      ///< the longest part without values: a cheap look whether it can be there at all
        QStringList places; ///< "%n", "%1" ..., as they follow each other in the source
        QRegularExpression match;
    };
    [[nodiscard]] static QRegularExpressionMatch found(const Text& text, const QString& in, int from);
    [[nodiscard]] static QString filled(const Text& text, const QRegularExpressionMatch& found, QString (*inner)(const QString&));

    bool whole_;
    std::vector<Text> texts_;
};

/// "no return", "out of window", in the language of the window.
[[nodiscard]] QString cellStateText(CellState state);

/// Name of a scan: that of a live sweep or of the demo in the language of the window, any other as it is.
[[nodiscard]] QString scanName(const std::string& name, int mostCharacters = 120);

/// Sentences: an error, a warning, a remark. Their known parts are translated, and "--unit m" becomes the place in the window where it is
/// set. Other text stays.
[[nodiscard]] QString coreSentence(const QString& text);
[[nodiscard]] QString coreSentence(const std::string& text);

/// A warning about a sweep of a scanner: what is assumed is given in Scan > Sweep, and not where a file is read.
[[nodiscard]] QString scannersWarning(QString warning);

/// "▲ mounting assumed", "▲ step assumed"; empty: neither is.
[[nodiscard]] QString assumedText(const Scan& scan);

} // namespace edgescan::ui
