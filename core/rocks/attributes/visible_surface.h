// The cells of each rock that are on its visible surface, without those behind it.
#pragma once

#include "core/rocks/selection/rock_map.h"

namespace edgescan::rocks {

/// Lines x beams: the labels of rocks without the cells of their rims that were not measured, that a depth jump separates from a nearer
/// cell of the rock, or that are between two surfaces. Along outlinesOf() of them no two cells that follow each other are across a jump. A
/// part that this cuts off is left out if it has less than a quarter of the cells of the largest.
[[nodiscard]] Grid<std::uint32_t> visibleSurfaces(const Segmentation& segments, const RegionMap& map);

} // namespace edgescan::rocks
