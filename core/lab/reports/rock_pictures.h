// Rocks found in a simulated scene as a picture: what became of the true ones, and what was found in their place.
#pragma once

#include "core/exports/provenance/contact_sheet.h"
#include "core/lab/score/rock_evaluation.h"

namespace edgescan {

/// Two parts of the scene, that with the most rocks missed and that with the most found and none missed: above, the outlines of the true
/// rocks by what became of them (strict); below, the outlines of the regions told, those called no rock apart. A rock below 100 cells has
/// no outline.
[[nodiscard]] Grid<Rgb> rockSheet(const Scan& scan, const RockScene& scene, const RockAnswer& answer, const RockSceneScore& score);

} // namespace edgescan
