// A panel that scrolls up and down where there is no room for it, and is never narrower than its contents.
#pragma once

class QScrollArea;
class QWidget;

namespace edgescan::ui {

/// The panel belongs to the area. Its height is at least what its texts take at its width: labels whose words wrap would lie on each other
/// otherwise.
[[nodiscard]] QScrollArea* scrolled(QWidget& panel);

} // namespace edgescan::ui
