// View > Theme.
#pragma once

#include "ui/control/commands.h"

namespace edgescan::ui {

class MainWindow;
class Memory;

/// One entry per theme; what was chosen is remembered, and used at once.
[[nodiscard]] Command themeMenu(MainWindow& window, Memory& memory);

} // namespace edgescan::ui
