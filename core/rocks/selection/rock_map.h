// Groups segments to regions at one level, and decides which regions are rocks (docs/method/rocks.md, "Step 7"). This is the work when the
// level slider moves.
#pragma once

#include "core/rocks/segmentation/merge_tree.h"
#include "core/rocks/segmentation/segments.h"
#include "core/rocks/selection/rock_settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::rocks {

enum class RegionKind : std::uint8_t {
    Rock,    ///< candidate: geometry only, one viewpoint
    NotRock, ///< wall, floor, or too far away
    Fines,   ///< fewer cells than RockSettings::minimumCells
    Outside, ///< mostly outside the region of interest
};

/// "rock", "not_rock", "fines", "outside".
[[nodiscard]] const char* regionKindName(RegionKind kind);

/// More levels say nothing more of a region.
inline constexpr double kMostLevels = 4.0;

/// A group of segments at the chosen level. The letters E, R, s1, e2 and p are those of docs/method/rocks.md, "Step 7".
struct Region {
    std::uint32_t firstSegment = 0; ///< its smallest segment
    RegionKind kind = RegionKind::Fines;
    bool byHand = false; ///< the user marked it as a rock, or as not a rock
    SegmentSums sums;
    std::uint32_t outlineCracks = 0; ///< number of cracks to other regions; a crack is the side between two neighbouring cells
    int sweepSides = 0;              ///< 0..4: number of sides of the sweep that it reaches
    double bulge = 0.0;              ///< -0.3 .. 0.3: distance of the surface in front of its chords, as a share of their length
    double nearShare = 0.0;          ///< 0..1: share of the outline at which it is the nearer side of a jump
    double edgeShare = 0.0;          ///< 0..1: mean of the evidence e2 (an edge is near) over the outline
    /// 0..1: standard deviation of the points along the shortest principal axis divided by that along the longest
    double depthRatio = 0.0;
    double boxShare = 0.0;            ///< visible area divided by that of a box of 4 standard deviations along the two longer axes
    double evidence = 0.0;            ///< E: mean log odds "two rocks" along the outline; each border counts with 6 at most
    double longM = 0.0;               ///< s1, m: 4 standard deviations of the points along the first principal axis
    double score = 0.0;               ///< R: log odds that it is a rock and not a wall
    double confidence = 0.0;          ///< p, 0..1: probability that its outline is right (IoU of 0.5 or more)
    double levelsBelow = kMostLevels; ///< 0..4: how far the level may fall until it is split
    double levelsAbove = kMostLevels; ///< 0..4: how far the level may rise until it is merged with another
};

/// The border of two regions.
using RegionBorder = SegmentBorder;

struct RegionMap {
    RockSettings settings;
    /// index 0 is empty; rocks first, the largest visible area first; then the other regions in the same order. After edits a rock keeps
    /// its number (withKeptNumbers()), and a number without a rock has a region without cells.
    std::vector<Region> regions;
    std::uint32_t rocks = 0;                    ///< the highest number of a rock
    std::vector<std::uint32_t> regionOfSegment; ///< by segment: an index of `regions`, or 0
    std::vector<RegionBorder> borders;          ///< a, b: indices of `regions`, a < b; ascending
};

/// The user's decision whether a region is a rock; the region is given by one of its segments.
struct RockCall {
    std::uint32_t segment = 0;
    bool rock = false;
    /// Not 0: the call of a join. It counts while this segment is in the same region and the scan alone shows no rock there.
    std::uint32_t joined = 0;
};

/// Step 5 at one level and step 7. Of several decisions about a region the last one is valid.
/// @param plain null, or the map without edits of the segments before any cut: a region that edits leave as it is has the same confidence
[[nodiscard]] RegionMap rocksAt(const Segmentation& segments, const MergeTree& tree, const RockSettings& settings,
                                std::span<const RockCall> called = {}, const RegionMap* plain = nullptr);

/// Region order[n] gets the number n, from 1 on; 0: no region gets it.
void renumber(RegionMap& map, std::span<const std::uint32_t> order);

/// What R weighs: bulge, near share, metres above the largest expected size, edge share, depth ratio, flatness, box share.
inline constexpr std::size_t kScoreInputs = 7;
[[nodiscard]] std::array<double, kScoreInputs> scoreInputs(const Region& region, const RockSettings& settings);

/// What rocksAt() asks of the confidence of a rock; docs/developer/lab-notebook.md has the trials.
inline constexpr double kLeastConfidence = 0.4;

/// Whether the centre of the region is behind RockSettings::farthestM.
[[nodiscard]] bool isTooFar(const Region& region, const RockSettings& settings);

/// Whether the region alone looks like a rock: R > 0, its centre is near enough, and it is not the surroundings of the other regions.
[[nodiscard]] bool looksLikeRock(const Region& region, const RockSettings& settings);

/// Whether there are enough clear valleys along the border to say that its two sides touch.
[[nodiscard]] bool touch(const RegionBorder& border);

/// The side in front, border.a or border.b; 0 if there are too few jumps, or if both sides are nearer in places.
[[nodiscard]] std::uint32_t nearerSide(const RegionBorder& border);

/// Lines x beams: 0 = not a rock, otherwise the number of a rock, 1 .. map.rocks.
[[nodiscard]] Grid<std::uint32_t> rockLabels(const Segmentation& segments, const RegionMap& map);

/// Lines x beams: indices of map.regions of any kind; 0 where a cell does not belong to a region.
[[nodiscard]] Grid<std::uint32_t> regionLabels(const Segmentation& segments, const RegionMap& map);

} // namespace edgescan::rocks
