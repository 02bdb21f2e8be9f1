// The commands that have a button in the tool bar.
#pragma once

namespace edgescan::ui {

class MainWindow;

/// Call it after the menus are made.
void addToolButtons(MainWindow& window);

} // namespace edgescan::ui
