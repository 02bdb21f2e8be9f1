// The tour in the window: its strip, its steps, and when it is shown.
#pragma once

class QBoxLayout;

namespace edgescan::ui {

class MainWindow;
class Preferences;

/// Puts the strip, hidden, at the end of the column.
void addTour(MainWindow& window, QBoxLayout& column);

void startTour(MainWindow& window);
/// False: it was not shown.
bool endTour(MainWindow& window);

/// Once, on the first start with stored settings.
void offerTour(MainWindow& window, Preferences& preferences);

} // namespace edgescan::ui
