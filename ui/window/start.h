// The start page and the tour in the window.
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

class MainWindow;
class Preferences;
class StartPage;

/// Covers views and panels until a picture is shown or a scanner is connected. The window owns it.
StartPage* showStart(MainWindow& window, Preferences& preferences);

} // namespace edgescan::ui
