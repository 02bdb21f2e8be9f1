// Rocks that were merged by hand: distances between their parts.
#pragma once

#include "core/rocks/attributes/attributes.h"
#include "core/rocks/selection/edits.h"

#include <span>
#include <vector>

namespace edgescan::rocks {

/// Fills Rock::apart of the rocks that joins of `edits` made of several parts. The parts are the regions at the level of the map without
/// the joins. Two parts touch if the distance of their nearest cells is within Rock::toleranceM.
void addPartDistances(const Segmentation& segments, const MergeTree& tree, const RegionMap& map, std::span<const Edit> edits,
                      std::vector<Rock>& rocks);

} // namespace edgescan::rocks
