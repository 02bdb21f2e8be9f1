// How far regions are in front of their own chords (docs/method/rocks.md, "Step 7").
#pragma once

#include "core/rocks/segmentation/segments.h"

#include <span>
#include <vector>

namespace edgescan::rocks {

/// The bulge of each region as a share of its chord, -0.3 .. 0.3; positive: convex towards the scanner. `regionOfSegment`: by segment,
/// below `regions`; 0 means no region.
[[nodiscard]] std::vector<double> regionBulges(const Segmentation& segments, std::span<const std::uint32_t> regionOfSegment,
                                               std::size_t regions);

} // namespace edgescan::rocks
