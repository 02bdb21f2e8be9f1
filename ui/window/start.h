// The start page in the window.
#pragma once

namespace edgescan::ui {

class MainWindow;
class Memory;
class StartPage;

/// Over the views and panels until there is a picture or a scanner is asked for. It belongs to the window.
StartPage* showStart(MainWindow& window, Memory& memory);

} // namespace edgescan::ui
