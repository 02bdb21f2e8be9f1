// Where a window may stand.
#pragma once

#include <QMargins>
#include <QRect>

class QWidget;

namespace edgescan::ui {

/// `window` (without its frame) made smaller and moved until it and its frame lie in `room`, as little as that takes. Pixels of the
/// desktop.
[[nodiscard]] QRect insideScreen(QRect window, const QMargins& frame, const QRect& room);

/// The same for a window that is shown, on the screen where it stands; one that is maximised stays.
void keepInsideScreen(QWidget& window);

} // namespace edgescan::ui
