// How widgets are drawn, and the theme and the size for hands that the operator chose.
#pragma once

class QApplication;

namespace edgescan::ui {

/// The style of the window, with the colours of themeInUse(). `forGloves`: nothing that is pressed is below 48 px, words are larger.
void useTheme(QApplication& application, bool forGloves = false);

/// Smallest side of what is pressed with gloves on, logical px.
inline constexpr int kGlovePx = 48;

} // namespace edgescan::ui
