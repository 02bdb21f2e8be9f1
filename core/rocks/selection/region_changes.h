// What an edit changed in the regions of a scan.
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <cstdint>
#include <vector>

namespace edgescan::rocks {

struct RegionChanges {
    struct Renumbered {
        std::uint32_t before = 0, after = 0;
        bool operator==(const Renumbered&) const = default;
    };
    struct Lost {
        std::uint32_t rock = 0;   ///< of the map before
        std::uint32_t region = 0; ///< of the map after: its largest part that is not a rock
    };
    bool any = false;                     ///< a region has other cells, is another kind, or was marked by hand
    std::vector<Renumbered> renumbered{}; ///< rocks with the same cells under another number, ascending
    std::vector<Lost> lost{};             ///< rocks in several parts of which at most one is a rock
};

/// Both maps of one scan. Where both have the same segmentation, segments are compared in place of cells.
[[nodiscard]] RegionChanges regionChanges(const Segmentation& segmentsBefore, const RegionMap& before, const Segmentation& segmentsAfter,
                                          const RegionMap& after);

} // namespace edgescan::rocks
