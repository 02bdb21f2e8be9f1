// Fits a window with its frame into a screen.
#include "ui/base/window_room.h"

#include <QScreen>
#include <QWidget>
#include <QWindow>

#include <algorithm>

namespace edgescan::ui {

QRect fittedInScreen(QRect window, const QMargins& frame, const QRect& room) {
    const QRect most = room.marginsRemoved(frame);
    window.setSize(window.size().boundedTo(most.size()));
    window.moveLeft(std::clamp(window.left(), most.left(), most.left() + most.width() - window.width()));
    window.moveTop(std::clamp(window.top(), most.top(), most.top() + most.height() - window.height()));
    return window;
}

void fitIntoScreen(QWidget& window) {
    if (!window.isVisible() || window.isMaximized() || window.isFullScreen() || window.windowHandle() == nullptr) return;
    const QRect fits = fittedInScreen(window.geometry(), window.windowHandle()->frameMargins(), window.screen()->availableGeometry());
    if (fits != window.geometry()) window.setGeometry(fits);
}

QSize roomForDialog(const QWidget& widget) {
    const QScreen* at = widget.screen();
    return at != nullptr ? at->availableSize() - QSize(20, 60) : QSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
}

} // namespace edgescan::ui
