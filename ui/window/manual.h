// The HTML manual (docs/make-manual) from the window: Help > Manual, and F1 on every dock, dialog and mode.
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace edgescan::ui {

class CabMode;
class MainWindow;

/// The page that explains a widget, such as "guide/tune": that of the nearest of its parents that has one. "index" if there is none.
[[nodiscard]] QString manualPageOf(const QWidget* widget);

/// The pages to look for, the best first: French, Spanish and Portuguese ones come first where the window's language has them.
[[nodiscard]] QStringList manualNames(const QString& page);

/// The page as a file: of the installed manual, or of the one that the build made, by manualNames(). Empty if there is no manual.
[[nodiscard]] QString manualFile(const QString& page);

/// Opens the page of `at` in the browser, without it that of the focused widget; without a manual a notice says where the texts are.
void openManual(MainWindow& window, const QWidget* at = nullptr);

/// F1 opens the manual in every dialog of the program, too.
void addManualKey(MainWindow& window);

} // namespace edgescan::ui
