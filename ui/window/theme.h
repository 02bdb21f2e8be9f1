// Drawing of widgets: the theme and the widget size that the operator chose.
#pragma once

class QApplication;

namespace edgescan::ui {

/// The style of the window, in the colours of themeInUse(). `forGloves`: every clickable widget is at least 48 px, text is larger. A scroll
/// bar is not: a swipe scrolls.
void useTheme(QApplication& application, bool forGloves = false);

/// Smallest side of a widget for gloves, logical px.
inline constexpr int kGlovePx = 48;

} // namespace edgescan::ui
