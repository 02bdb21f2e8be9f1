// The changes between two scans, as a table, as JSON and as a picture.
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/inspect/change_detection/scene_change.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace edgescan::inspect {

/// People with red-green blindness can distinguish sky blue and orange, and words and signs give the same information. Contrast to the
/// dimmed cloud (84) is at least 3 : 1.
inline constexpr Rgb kGainedColour{86, 180, 233}, kLostColour{230, 159, 0}, kUnchangedColour{0, 190, 0};

/// "lined up by their poses": one line about the registration.
[[nodiscard]] std::string registrationText(const RegistrationResult& how);

/// Counts, the quality of the registration, and the largest regions that are nearer or farther than before.
[[nodiscard]] std::string changeText(const Scan& later, const SceneChange& change);
[[nodiscard]] nlohmann::ordered_json changeReport(const Scan& later, const SceneChange& change);

/// Lines x beams: ranges in gray; nearer and farther cells tinted in the colours of gained and lost; edges gained, lost and unchanged.
[[nodiscard]] Grid<Rgb> changePicture(const Scan& later, const SceneChange& change);

} // namespace edgescan::inspect
