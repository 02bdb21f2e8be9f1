// What an edit changed in the regions of a scan.
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace edgescan::rocks {

/// Measured cells in a region of one map and a region of another; region 0 is none.
using SharedCells = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t>;
/// Both maps of one scan. Where both have the same segmentation, segments are compared in place of cells.
[[nodiscard]] SharedCells sharedCells(const Segmentation& segmentsBefore, const RegionMap& before, const Segmentation& segmentsAfter,
                                      const RegionMap& after);

struct RegionChanges {
    struct Lost {
        std::uint32_t rock = 0;   ///< of the map before
        std::uint32_t region = 0; ///< of the map after: its largest part that is not a rock
    };
    bool any = false;         ///< a region has other cells, is another kind, or was marked by hand
    std::vector<Lost> lost{}; ///< rocks in several parts of which at most one is a rock
};

/// Both maps of one scan.
[[nodiscard]] RegionChanges regionChanges(const Segmentation& segmentsBefore, const RegionMap& before, const Segmentation& segmentsAfter,
                                          const RegionMap& after);

} // namespace edgescan::rocks
