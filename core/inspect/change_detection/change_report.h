// What changed, as a table, as JSON and as a picture.
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/inspect/change_detection/scene_change.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace edgescan {

/// Sky and orange are told apart by those who see no difference between red and green, and words and signs say the same; contrast to the
/// dimmed cloud (84) 3 : 1 and more.
inline constexpr Rgb kGainedColour{86, 180, 233}, kLostColour{230, 159, 0}, kKeptColour{0, 190, 0};

/// "lined up by their poses": how the two came together, in one line.
[[nodiscard]] std::string lineUpText(const LinedUp& how);

/// Counts, how the scans lie on each other, and the largest regions that came nearer or went farther.
[[nodiscard]] std::string changeText(const Scan& later, const SceneChange& change);
[[nodiscard]] nlohmann::ordered_json changeReport(const Scan& later, const SceneChange& change);

/// Lines x beams: ranges in gray, what came nearer or went farther tinted in the colours of gained and lost, edges gained, lost and kept.
[[nodiscard]] Grid<Rgb> changePicture(const Scan& later, const SceneChange& change);

} // namespace edgescan
