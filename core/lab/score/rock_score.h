// How well labelled regions are the true rocks of a scene: regions and rocks whose intersection over union is above a half are one
// (docs/method.md, "Truth and score").
#pragma once

#include "core/base/grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan {

/// Why a rock was not found; the first that holds.
enum class Miss : std::uint8_t {
    Dropped, ///< strict only: a region matches it and was called no rock
    Wall,    ///< one region holds at least half of it, and the rest of that region is mostly background
    Merged,  ///< one region holds at least half of it and more besides
    Split,   ///< regions that lie at least half in it hold at least half of it together
    Other,
};
inline constexpr std::size_t kMisses = 5;

/// Counts that can be added over scenes.
struct RockCounts {
    std::size_t found = 0, missed = 0, falseRegions = 0;
    double iou = 0.0; ///< sum over those found
    std::array<std::size_t, kMisses> missedBy{};

    RockCounts& operator+=(const RockCounts& other);
    [[nodiscard]] double pq() const; ///< sum of IoU / (found + false / 2 + missed / 2); 0 where there is nothing
    [[nodiscard]] double sq() const; ///< mean IoU of those found
    [[nodiscard]] double f1() const; ///< found / (found + false / 2 + missed / 2)
};

/// Which cells two labellings share. 0 is background in the truth and no region in the labels.
struct Overlaps {
    struct Shared {
        std::uint32_t rock = 0, region = 0;
        std::size_t cells = 0;
    };
    std::vector<Shared> shared;                        ///< by rock, then region; both 0 included
    std::vector<std::size_t> rockCells, regionCells;   ///< by number, 0 included
    [[nodiscard]] double iou(const Shared& one) const; ///< of a rock and a region
};

/// `counts`: lines x beams, not 0 where a cell takes part. Labels may be any numbers; the tables reach up to the largest.
[[nodiscard]] Overlaps overlapsOf(const Grid<std::uint8_t>& counts, const Grid<std::uint32_t>& rock, const Grid<std::uint32_t>& region);

struct RockRules {
    std::size_t leastCells = 100; ///< smaller rocks need not be found, and smaller regions are not false
    bool strict = false;          ///< regions called no rock are gone, and those on background are false; else background is no matter
};

/// What became of a rock that had to be found.
struct RockVerdict {
    std::uint32_t rock = 0;
    std::size_t cells = 0;
    bool found = false;
    std::uint32_t region = 0; ///< found: that one; else the region that holds most of it, 0 for none
    double iou = 0.0;         ///< with that region
    Miss miss = Miss::Other;  ///< where it was not found
};

struct RockMatch {
    RockCounts counts;
    std::vector<RockVerdict> rocks;          ///< in the order of their numbers
    std::vector<std::uint32_t> falseRegions; ///< ascending
};

/// `isRock` by region's number; all are rocks where it is empty.
[[nodiscard]] RockMatch matchRocks(const Overlaps& overlaps, const std::vector<std::uint8_t>& isRock, const RockRules& rules);

/// Rocks found, by their size in cells.
struct CellClass {
    std::size_t fromCells = 0; ///< up to the next class
    std::size_t rocks = 0, found = 0;
};
inline constexpr std::array<std::size_t, 4> kCellClasses{100, 200, 400, 1000};
[[nodiscard]] std::array<CellClass, 4> byCells(const RockMatch& match);

} // namespace edgescan
