// Why two pieces are two rocks, or one.
#pragma once

#include "core/rocks/attributes/study.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace edgescan {

struct BorderWhy {
    std::array<std::uint32_t, 2> cells{};
    std::array<std::uint32_t, 2> regions{}; ///< places in map.regions; 0: the cell belongs to none
    std::optional<RegionBorder> border;     ///< of the two regions, the first one as a; empty where they are one or do not touch
    std::optional<double> joinedFrom;       ///< level from which on the two cells are in one region; empty: at none, or always
    bool alwaysOne = false;                 ///< they are in one leaf, or were joined by hand
    std::string verdict;                    ///< one sentence

    [[nodiscard]] bool sameRegion() const { return regions[0] != 0 && regions[0] == regions[1]; }
};

/// Both must be cells of the scan.
[[nodiscard]] BorderWhy whyTwoRocks(const RockStudy& study, std::uint32_t one, std::uint32_t other);

} // namespace edgescan
