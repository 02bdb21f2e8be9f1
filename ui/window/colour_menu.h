// A menu of the colour scales of the cloud.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class MainWindow;

[[nodiscard]] Command colourMenu(MainWindow& window);

} // namespace edgescan::ui
