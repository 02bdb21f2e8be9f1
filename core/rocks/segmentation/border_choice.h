// Decides once more to which segment the cells on a border belong, by what a network learned from simulated borders
// (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/border_network.h"
#include "core/rocks/segmentation/segments.h"

#include <functional>
#include <span>

namespace edgescan::rocks {

/// Whether a cell of the segment `own` belongs to `other`.
struct BorderQuestion {
    std::size_t cell = 0;
    std::uint32_t own = 0, other = 0;
    std::array<float, kBorderFeatures> features{};
};
/// Gets each question that is asked.
using BorderWatch = std::function<void(const BorderQuestion&)>;

/// The groups of segments that are one region at every level that is used: a border inside of one matters nowhere.
[[nodiscard]] std::vector<std::uint32_t> settledGroups(const std::vector<SegmentBorder>& borders, std::uint32_t segments);

inline constexpr int kBorderPasses = 2;
/// Each cell next to a segment of another group moves there if the network says so; of several, to the most likely one. From the second
/// pass on only cells near a move are asked again. Cells without a segment stay without. The same result with any number of threads (0:
/// as many as make it faster): a pass reads what the pass before left. `watch` is called on this thread.
void chooseBorders(const Inputs& inputs, std::span<const std::uint32_t> groups, const BorderNetwork& network, int passes,
                   Grid<std::uint32_t>& segment, int threads = 0, const BorderWatch& watch = {});

} // namespace edgescan::rocks
