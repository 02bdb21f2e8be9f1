// A panel that scrolls vertically if it does not fit, and is never narrower than its contents.
#pragma once

class QScrollArea;
class QWidget;

namespace edgescan::ui {

/// The area owns the panel. The panel's height is at least that of its texts at its width; otherwise wrapped labels would overlap.
[[nodiscard]] QScrollArea* scrolled(QWidget& panel);

/// Each area that the widget is in scrolls to it. `top`: so that it is the first thing in sight.
void scrollTo(QWidget& widget, bool top = false);

} // namespace edgescan::ui
