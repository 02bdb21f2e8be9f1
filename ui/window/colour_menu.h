// What the points of the cloud are coloured by, as a menu.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class ScanLook;

/// `parent`: of the group of its actions.
[[nodiscard]] Command colourMenu(QObject& parent, ScanLook& look);

} // namespace edgescan::ui
