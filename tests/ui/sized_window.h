// Windows of a given size, and their scan.
#pragma once

#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"

#include <QtTest>

namespace edgescan::ui {

/// Waits until the desktop has set the size.
inline void resizeTo(MainWindow& window, QSize size) {
    window.resize(size);
    QTRY_COMPARE(window.size(), size);
    QApplication::processEvents();
}

/// Boxes in front of a wall, 300 lines x 340 beams, some cells without a range.
inline Scan boxesToShow() { return test::boxesScan(300, 340, 3, 0.05); }

} // namespace edgescan::ui
