// Dialogs that only tell something: keys and mouse, the properties of a scan, the program.
#pragma once

#include <QList>

class QAction;
class QWidget;

namespace edgescan {
struct Scan;
}

namespace edgescan::ui {

/// The keys are read from the actions, so that the sheet cannot differ from what the keys do.
/// Property of an action whose text changes: what it is called in lists, in the words of the window.
inline constexpr const char* kPlainName = "plainName";

void showShortcuts(QWidget* parent, const QList<QAction*>& actions);
void showScanProperties(QWidget* parent, const Scan& scan);
void showAbout(QWidget* parent);

} // namespace edgescan::ui
