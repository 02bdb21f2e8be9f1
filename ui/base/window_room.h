// Where a window may be placed.
#pragma once

#include <QMargins>
#include <QRect>
#include <QSize>

class QWidget;

namespace edgescan::ui {

/// Shrinks `window` (without its frame) and moves it until it and its frame are inside `room`, as little as possible. Pixels of the
/// desktop.
[[nodiscard]] QRect fittedInScreen(QRect window, const QMargins& frame, const QRect& room);

/// The same for a visible window, on its own screen; a maximised window does not change.
void fitIntoScreen(QWidget& window);

/// The largest size of a dialog on the screen of `widget`, px: its frame has room too.
[[nodiscard]] QSize roomForDialog(const QWidget& widget);

} // namespace edgescan::ui
