// Tool tips of several lines.
#pragma once

#include <QString>

class QAbstractButton;
class QApplication;
class QFontMetrics;

namespace edgescan::ui {

/// Breaks each line that is wider than this, px, between two words.
[[nodiscard]] QString brokenText(const QString& text, const QFontMetrics& letters, int width);

/// Gives a switch these words, broken where it is wider than this, px: it does not do so by itself.
void setBrokenText(QAbstractButton& box, const QString& text, int width);

/// Qt shows a plain text as wide as its longest line, wider than the screen if need be. From now on the program breaks it. A second call
/// changes nothing.
void breakToolTips(QApplication& application);

} // namespace edgescan::ui
