// The colours of the window: one table of tokens, three themes of it. The views stay dark in all of them.
#pragma once

#include <QColor>
#include <QObject>
#include <QPalette>

#include <array>
#include <functional>
#include <vector>

class QWidget;

namespace edgescan::ui {

/// One theme: what a colour is for, not where it is used.
struct Theme {
    const char* key;                    ///< in the memory and on the command line
    const char* label;                  ///< in the menu, with its letter; to be translated
    QColor window, panel, base, button; ///< grounds
    QColor line;                        ///< decoration only: no meaning hangs on it
    QColor edge;                        ///< borders of fields, axes
    QColor text, quietText;
    QColor unusable;  ///< words of what cannot be used now
    QColor accent;    ///< handles, focus, marks of a curve
    QColor chosen;    ///< ground of what is chosen; white words stand on it
    QColor warn, bad; ///< words and signs of what is abnormal, always with a sign as well
};

inline constexpr int kThemes = 3;
/// Night, day, control-room gray.
[[nodiscard]] const std::array<Theme, kThemes>& themes();
/// That with the key; the first one where there is none.
[[nodiscard]] const Theme& themeOf(const QString& key);
/// The one that useColours() was told last; the first one before.
[[nodiscard]] const Theme& themeInUse();

/// Two colours that stand on one another somewhere, and the contrast that they need: 4.5 for text, 3 for graphics.
struct ColourPair {
    const char* what;
    QColor Theme::*front;
    QColor Theme::*ground;
    double least;
};
[[nodiscard]] const std::vector<ColourPair>& pairsInUse();

/// The theme's colours where Qt's widgets look for them. Mid: borders. Link: accent.
[[nodiscard]] QPalette paletteOf(const Theme& theme);
/// Of what lies over the views, in every theme: that of the night.
[[nodiscard]] QPalette viewPalette();
/// From now on the whole application has the theme's colours. GUI thread only.
void useColours(const Theme& theme);
/// Calls `paint` now and whenever another theme is used, as long as `widget` lives: for colours that no palette has.
void followColours(QWidget& widget, const std::function<void(const Theme&)>& paint);

/// Says that another theme is used.
class ThemeNews : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] static ThemeNews& self();

signals:
    void changed(const edgescan::ui::Theme& theme);
};

} // namespace edgescan::ui
