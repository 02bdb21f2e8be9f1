// Which measured cells belong to which rock.
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace edgescan {

/// Measured cells, one rock after the other, each one's ascending.
struct CellsOfRocks {
    std::vector<std::uint32_t> cells;
    std::vector<std::size_t> first; ///< by label; one more at the end

    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t label) const {
        return std::span(cells).subspan(first[label], first[label + 1] - first[label]);
    }
};

/// Of all rocks but those that `skipped` (by label) says yes to: nobody will ask for their cells.
[[nodiscard]] CellsOfRocks cellsOfRocks(const RockLeaves& leaves, const RockMap& map,
                                        const std::function<bool(std::uint32_t label)>& skipped = {});

} // namespace edgescan
