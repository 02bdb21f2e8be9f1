// Which leaves are one rock at one level, and which regions are none (docs/rocks-method.md, "Step 7"). What a move of the slider costs.
#pragma once

#include "core/rocks/segmentation/merge_tree.h"
#include "core/rocks/segmentation/segments.h"
#include "core/rocks/selection/rock_settings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

enum class RegionKind : std::uint8_t {
    Rock,    ///< candidate: geometry only, one viewpoint
    NotRock, ///< wall, floor, or too far away
    Fines,   ///< fewer cells than a rock must have
    Outside, ///< mostly outside the region of interest
};

/// "rock", "not_rock", "fines", "outside".
[[nodiscard]] const char* regionKindName(RegionKind kind);

/// A group of leaves at the level chosen.
struct RockRegion {
    std::uint32_t group = 0; ///< its smallest leaf
    RegionKind kind = RegionKind::Fines;
    bool byHand = false; ///< a person said that it is a rock, or that it is none
    LeafSums sums;
    std::uint32_t outlineCracks = 0; ///< cracks to other regions
    double bulge = 0.0;              ///< -0.3 .. 0.3: how far it lies before its chords, as a share of them
    double near = 0.0;               ///< 0..1: share of the outline where it is the nearer side of a jump
    double edges = 0.0;              ///< 0..1: how far the outline is covered by edges, mean of e2
    double depth = 0.0;              ///< 0..1: standard deviation along the shortest principal axis over that along the longest
    double fill = 0.0;               ///< visible area over that of a box of 4 standard deviations along the two longer axes
    double evidence = 0.0;           ///< E: mean log odds of the outline, each border counted with 6 at most
    double longM = 0.0;              ///< s1: 4 standard deviations along the first principal axis
    double score = 0.0;              ///< R: log odds of being a rock and no wall
    double confidence = 0.0;         ///< p, 0..1: chance that its outline is right to IoU 0.5
};

/// The border of two regions.
using RegionBorder = LeafBorder;

struct RockMap {
    RockSettings settings;
    std::vector<RockRegion> regions;         ///< place 0 is empty; rocks first, the largest visible area first; then the others likewise
    std::uint32_t rocks = 0;                 ///< regions 1 .. rocks are rocks
    std::vector<std::uint32_t> regionOfLeaf; ///< by leaf: a place in `regions`, or 0
    std::vector<RegionBorder> borders;       ///< a, b: places in `regions`, a < b; ascending
};

/// A region that a person called a rock, or none, by a leaf of it.
struct CalledLeaf {
    std::uint32_t leaf = 0;
    bool rock = false;
};

/// Steps 5 at one level and 7. The last word on a region holds.
[[nodiscard]] RockMap rocksAt(const RockLeaves& leaves, const MergeTree& tree, const RockSettings& settings,
                              std::span<const CalledLeaf> called = {});

/// Whether enough clear valleys run along the border for its two sides to touch.
[[nodiscard]] bool touch(const RegionBorder& border);

/// The side that lies in front, border.a or border.b; 0 where there are too few jumps, or where they go both ways.
[[nodiscard]] std::uint32_t nearerSide(const RegionBorder& border);

/// Lines x beams: 0 none, then the rocks 1 .. map.rocks, the largest visible area first.
[[nodiscard]] Grid<std::uint32_t> rockLabels(const RockLeaves& leaves, const RockMap& map);

/// Lines x beams: places in map.regions, whatever their kind; 0 where a cell belongs to none.
[[nodiscard]] Grid<std::uint32_t> regionLabels(const RockLeaves& leaves, const RockMap& map);

} // namespace edgescan
