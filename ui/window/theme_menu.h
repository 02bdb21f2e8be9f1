// View > Theme and View > Cab Mode.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class CabMode;
class Memory;

/// One entry per theme; what was chosen is remembered, and used at once.
[[nodiscard]] Command themeMenu(QObject& parent, Memory& memory);

/// View > Cab Mode: on here, off only where Locked is held.
[[nodiscard]] Command cabCommand(CabMode& cab, Memory& memory);

} // namespace edgescan::ui
