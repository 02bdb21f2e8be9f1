// What the points of the cloud are coloured by, as a menu.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class MainWindow;

[[nodiscard]] Command colourMenu(MainWindow& window);

} // namespace edgescan::ui
