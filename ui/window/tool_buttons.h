// Which commands have a button in the bar of tools.
#pragma once

namespace edgescan::ui {

class MainWindow;

/// Once the menus are there.
void addToolButtons(MainWindow& window);

} // namespace edgescan::ui
