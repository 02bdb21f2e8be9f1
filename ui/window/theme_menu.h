// View > Theme, View > Images First and View > Cab Mode.
#pragma once

#include "ui/panels/keys/commands.h"

namespace edgescan::ui {

class CabMode;
class PanePlaces;
class Preferences;

/// One entry per theme; the choice is remembered and applied at once.
[[nodiscard]] Command themeMenu(QObject& parent, Preferences& preferences);

/// View > Images First.
[[nodiscard]] Command imagesFirstCommand(PanePlaces& places);

/// View > Cab Mode: this command switches it on; only holding Locked switches it off.
[[nodiscard]] Command cabCommand(CabMode& cab, Preferences& preferences);

} // namespace edgescan::ui
