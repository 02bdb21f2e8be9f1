// A menu of the colour scales of the cloud.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class ScanLook;

/// `parent`: of the group of its actions.
[[nodiscard]] Command colourMenu(QObject& parent, ScanLook& look);

} // namespace edgescan::ui
