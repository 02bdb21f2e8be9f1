// Rocks found in a simulated scene as a picture: which true rocks were found, and what was found in place of the others.
#pragma once

#include "app/lab/reports/titled_tiles.h"
#include "app/lab/score/rock_evaluation.h"

namespace edgescan::lab {

/// Two parts of the scene: the one with the most missed rocks, and the one with the most found and without missed rocks. Above: the
/// outlines of the true rocks by result (strict). Below: the outlines of the detected regions; those classified as not a rock are
/// distinguished. Rocks of fewer than 100 cells have no outline.
[[nodiscard]] Grid<Rgb> rockSheet(const Scan& scan, const RockScene& scene, const RockDetection& answer, const RockSceneScore& score);

} // namespace edgescan::lab
