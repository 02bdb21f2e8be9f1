// The measured cells of each rock.
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace edgescan::rocks {

/// Measured cells of one rock after the other, ascending within each rock.
struct CellsByRock {
    std::vector<std::uint32_t> cells;
    std::vector<std::size_t> first; ///< by label: index of the first cell; one more entry at the end

    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t label) const {
        return std::span(cells).subspan(first[label], first[label + 1] - first[label]);
    }
};

/// The cells of all rocks except those for which `skipped(label)` is true.
[[nodiscard]] CellsByRock cellsByRock(const Segmentation& segments, const RegionMap& map,
                                      const std::function<bool(std::uint32_t label)>& skipped = {});

} // namespace edgescan::rocks
