// Corrects the borders of segments by the measured ranges (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/inverse_range.h"

namespace edgescan::rocks {

/// Smaller segments are dissolved; neighbouring segments take their cells.
inline constexpr std::uint32_t kSmallestSegment = 12;

/// 5 to 30: deviation from a plane, in standard deviations, above which a larger deviation costs hardly more. If the beams of neighbouring
/// cells hardly overlap, only single cells have a range between two surfaces, and their neighbours decide better where they belong. If the
/// beams overlap, whole strips have such ranges.
[[nodiscard]] double mostDeviations(const AngularSteps& steps);

/// Each cell next to another segment moves to the segment, among those of its neighbours, whose plane fits its range best; an open cell
/// only if a plane fits well. Four passes. Deterministic: a pass reads the result of the pass before. `most`: from mostDeviations().
void refineSegments(const InverseRange& inverse, const edges::DepthCracks& cracks, const RangeNoise& noise, double most,
                    Grid<std::uint32_t>& segment, std::uint32_t count);

} // namespace edgescan::rocks
