// What an edit of rocks changed besides the rocks that were meant, in words.
#pragma once

#include "core/rocks/selection/region_changes.h"
#include "ui/panels/rocks/rock_picture.h"

#include <QString>

namespace edgescan::ui {

/// Parts that are not rocks, with the control that shows them; rocks with another number. `picture`: after the edit. Empty: nothing to say.
[[nodiscard]] QString changeWords(const rocks::RegionChanges& changes, const RockPicture& picture);

} // namespace edgescan::ui
