// The menus of the window as a table of commands.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class MainWindow;
class Memory;

/// One entry per menu of the menu bar. Window and memory must outlive everything made from them.
[[nodiscard]] std::vector<Command> menusOf(MainWindow& window, Memory& memory);

} // namespace edgescan::ui
