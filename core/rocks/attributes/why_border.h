// Explains why two pieces are two rocks, or one.
#pragma once

#include "core/rocks/attributes/study.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace edgescan::rocks {

struct BorderWhy {
    std::array<std::uint32_t, 2> cells{};
    std::array<std::uint32_t, 2> regions{}; ///< indices of map.regions; 0: the cell is not in a region
    /// border of the two regions, with the first region as a; empty if they are the same region or do not touch
    std::optional<RegionBorder> border;
    std::optional<double> joinedFrom; ///< from this level on the two cells are in one region; empty: at no level, or at every level
    bool alwaysOne = false;           ///< they are in one segment, or were joined by the user
    std::string verdict;              ///< one sentence

    [[nodiscard]] bool sameRegion() const { return regions[0] != 0 && regions[0] == regions[1]; }
};

/// Both must be cells of the scan.
[[nodiscard]] BorderWhy whyTwoRocks(const Study& study, std::uint32_t one, std::uint32_t other);

} // namespace edgescan::rocks
