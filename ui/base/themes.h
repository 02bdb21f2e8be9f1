// The colours of the window: one table of colour tokens with three themes. The views stay dark in all themes.
#pragma once

#include <QColor>
#include <QObject>
#include <QPalette>
#include <QPixmap>

#include <array>
#include <functional>
#include <vector>

class QWidget;

class QAbstractButton;

namespace edgescan::ui {

/// One theme. Each colour is named after its purpose.
struct Theme {
    const char* key;                    ///< in the settings and on the command line
    const char* label;                  ///< in the menu, with its access key; to be translated
    QColor window, panel, base, button; ///< backgrounds
    QColor line;                        ///< decoration only: carries no meaning
    QColor edge;                        ///< borders of fields, axes
    QColor text, quietText;
    QColor unusable;  ///< text of disabled items
    QColor accent;    ///< handles, focus, marks on a curve
    QColor chosen;    ///< background of the selected item, under white text
    QColor warn, bad; ///< text and icons of warnings and errors, always with an icon
};

inline constexpr int kThemes = 3;
/// Night, day, control-room gray.
[[nodiscard]] const std::array<Theme, kThemes>& themes();
/// The theme with this key; the first theme if the key is unknown.
[[nodiscard]] const Theme& themeOf(const QString& key);
/// The theme of the last useColours(); the first theme before that.
[[nodiscard]] const Theme& themeInUse();

/// Two colours that appear on each other, and the contrast that they need: 4.5 for text, 3 for graphics.
struct ColourPair {
    const char* what;
    QColor Theme::*front;
    QColor Theme::*ground;
    double least;
};
[[nodiscard]] const std::vector<ColourPair>& pairsInUse();

/// The theme's colours in the roles of Qt's widgets. Mid: borders. Link: accent.
[[nodiscard]] QPalette paletteOf(const Theme& theme);
/// The sign of a legend on a piece of the views' dark ground, in every theme: it looks as in the views.
[[nodiscard]] QPixmap onViewGround(const QPixmap& sign);
/// The same as the icon of a row, in its size.
void setSign(QAbstractButton& row, const QPixmap& sign);
/// Sets the theme's colours for the whole application. GUI thread only.
void useColours(const Theme& theme);
/// Calls `paint` now and after every change of theme while `widget` exists: for colours without a palette role.
void followColours(QWidget& widget, const std::function<void(const Theme&)>& paint);

/// Signals a change of theme.
class ThemeNews : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] static ThemeNews& self();

signals:
    void changed(const edgescan::ui::Theme& theme);
};

} // namespace edgescan::ui
