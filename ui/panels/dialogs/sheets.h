// Dialogs that only show information: keys and mouse, the properties of a scan, the program.
#pragma once

#include <QList>

class QAction;
class QWidget;

namespace edgescan {
struct Scan;
}

namespace edgescan::ui {

/// The keys are read from the actions, so that the sheet always equals the real keys. Property of an action with a changing text: its fixed
/// name in lists, in the language of the window.
inline constexpr const char* kPlainName = "plainName";

void showShortcuts(QWidget* parent, const QList<QAction*>& actions);
void showScanProperties(QWidget* parent, const Scan& scan);
/// `renderer`: the program that draws the cloud.
void showAbout(QWidget* parent, const QString& renderer);

} // namespace edgescan::ui
