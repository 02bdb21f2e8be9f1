// The start page in the window.
#pragma once

namespace edgescan::ui {

class MainWindow;
class Preferences;
class StartPage;

/// Covers views and panels until a picture is shown or a scanner is connected. The window owns it.
StartPage* showStart(MainWindow& window, Preferences& preferences);

} // namespace edgescan::ui
