// Windows of a given size, and their scan.
#pragma once

#include "tests/support/folders.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"

#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

namespace edgescan::ui {

/// The texts of the sources in this language.
inline bool useTexts(const char* code) { return useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"); }

/// Waits until the desktop has set the size.
inline void resizeTo(MainWindow& window, QSize size) {
    QTRY_VERIFY((window.resize(size), window.size() == size)); // what folds on the way makes room for a smaller window
    QApplication::processEvents();
}

/// Taps an entry of the menu of this button in a cab; entry 0 closes it. False: the menu has fewer entries.
inline bool tapEntry(MainWindow& window, const char* button, int entry) {
    QTest::mouseClick(tool(window, button), Qt::LeftButton);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QList<QAction*> entries = menu == nullptr ? QList<QAction*>() : menu->actions();
    entries.erase(std::remove_if(entries.begin(), entries.end(), [](const QAction* each) { return each->isSeparator(); }), entries.end());
    if (entry >= entries.size()) return false;
    QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(entries[entry]).center());
    return true;
}

/// Of the menu of Images in a cab.
enum ViewEntry { CloudEntry = 1, RangeEntry, EdgesEntry, SmallEntry };

/// Boxes in front of a wall, 300 lines x 340 beams, some cells without a range.
inline Scan boxesToShow() { return test::boxesScan(300, 340, 3, 0.05); }

} // namespace edgescan::ui
