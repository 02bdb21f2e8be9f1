// What an edit of rocks changed besides the rocks that were meant, in words.
#pragma once

#include "core/rocks/selection/region_changes.h"
#include "ui/panels/rocks/rock_picture.h"

#include <QString>

namespace edgescan::ui {

/// Parts that are not rocks, with the control that shows them; rocks with another number. `picture`: after the edit. Empty: nothing to say.
[[nodiscard]] QString changeWords(const rocks::RegionChanges& changes, const RockPicture& picture);

/// Which rocks a join made one, or a cut or part divided, by their numbers before and after. Empty for other edits.
[[nodiscard]] QString editWords(rocks::EditKind kind, const RockPicture& before, const RockPicture& after);

/// Rocks that were merged by a join with these cells although they do not touch, by their numbers before it. Empty: all of them touch.
[[nodiscard]] QString apartWords(const std::vector<std::uint32_t>& cells, const RockPicture& before, const RockPicture& after);

} // namespace edgescan::ui
