// Leaves: the basins of the distance to the barriers, shallow ones joined (docs/rocks-method.md, "Step 3").
#pragma once

#include "core/rocks/segmentation/barrier.h"

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

/// A saddle that is less than so many cells below the lower peak of two basins joins them.
inline constexpr float kShallow = 0.7F;

/// Lines x beams: kOpen where nothing was measured, else the leaf, numbered from 1 by first cells. `distance`: cells, to the barrier. Each
/// cell goes to its linked neighbour of greatest distance, on a plateau to the one above or left of it.
[[nodiscard]] Grid<std::uint32_t> leafBasins(const Grid<float>& distance, const CellLinks& links);

/// Numbers the groups of cells by their first cells, from 1; kOpen stays. `group`: any number per cell below lines x beams + 1. `joined`:
/// where groups were joined, the one that each belongs to, by number. Gives the count.
std::uint32_t numberByFirstCell(Grid<std::uint32_t>& group, std::span<const std::uint32_t> joined = {});

/// The largest number of a cell, which is the number of leaves where they are numbered from 1; 0 without cells.
[[nodiscard]] std::uint32_t lastLeaf(const Grid<std::uint32_t>& leaf);

/// Groups of numbers that are joined one after the other.
class JoinedGroups {
public:
    explicit JoinedGroups(std::size_t count);
    [[nodiscard]] std::uint32_t of(std::uint32_t n);
    /// The group of `into` takes in that of `from`.
    void join(std::uint32_t into, std::uint32_t from) { parent_[of(from)] = of(into); }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace edgescan
