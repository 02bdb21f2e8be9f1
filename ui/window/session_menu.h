// Sessions in the window: their commands, and what of the window they keep.
#pragma once

#include "ui/panels/keys/commands.h"

#include <memory>
#include <vector>

namespace edgescan::ui {

class MainWindow;
class Sittings;

[[nodiscard]] std::unique_ptr<Sittings> sittingsOf(MainWindow& window, Memory& memory);
[[nodiscard]] std::vector<Command> sittingCommands(MainWindow& window);

} // namespace edgescan::ui
