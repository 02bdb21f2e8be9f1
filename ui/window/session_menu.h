// Sessions in the window: their commands, and the stored parts of the layout.
#pragma once

#include "ui/panels/keys/commands.h"

#include <memory>
#include <vector>

namespace edgescan::ui {

class MainWindow;
class Sessions;

[[nodiscard]] std::unique_ptr<Sessions> sessionsOf(MainWindow& window, Preferences& preferences);
[[nodiscard]] std::vector<Command> sessionCommands(MainWindow& window);

} // namespace edgescan::ui
