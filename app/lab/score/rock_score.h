// Compares labelled regions with the true rocks of a scene: a region and a rock match if their intersection over union is above one half
// (docs/method/edges.md, "Truth and score").
#pragma once

#include "core/base/grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::lab {

/// The reason why a rock was not found; the first that applies.
enum class RockMiss : std::uint8_t {
    Dropped, ///< strict only: a region matches it but was classified as not a rock
    Wall,    ///< one region covers at least half of it, and the rest of that region is mostly background
    Merged,  ///< one region covers at least half of it, and also other rocks
    Split,   ///< regions with at least half of their cells in it cover at least half of it together
    Other,
};
inline constexpr std::size_t kMisses = 5;

/// Counts that can be added over scenes.
struct RockCounts {
    std::size_t found = 0, missed = 0, falseRegions = 0;
    double iou = 0.0; ///< sum over those found
    std::array<std::size_t, kMisses> missedBy{};

    RockCounts& operator+=(const RockCounts& other);
    [[nodiscard]] double pq() const; ///< sum of IoU / (found + false / 2 + missed / 2); 0 without rocks and regions
    [[nodiscard]] double sq() const; ///< mean IoU of those found
    [[nodiscard]] double f1() const; ///< found / (found + false / 2 + missed / 2)
};

/// The cells that two labellings share. 0 is background in the truth, and no region in the labels.
struct Overlaps {
    struct Shared {
        std::uint32_t rock = 0, region = 0;
        std::size_t cells = 0;
    };
    std::vector<Shared> shared;                        ///< by rock, then region; both including 0
    std::vector<std::size_t> rockCells, regionCells;   ///< by number, including 0
    [[nodiscard]] double iou(const Shared& one) const; ///< of a rock and a region
};

/// `counts`: lines x beams, not 0 where a cell is scored. Labels may be any numbers; the tables extend to the largest.
[[nodiscard]] Overlaps overlapsOf(const Grid<std::uint8_t>& counts, const Grid<std::uint32_t>& rock, const Grid<std::uint32_t>& region);

struct RockRules {
    std::size_t leastCells = 100; ///< smaller rocks are not required, and smaller regions are not false
    /// true: regions classified as not a rock are removed, and regions on background are false; false: background is ignored
    bool strict = false;
};

/// The result for a rock that is required.
struct RockVerdict {
    std::uint32_t rock = 0;
    std::size_t cells = 0;
    bool found = false;
    std::uint32_t region = 0;        ///< found: its region; otherwise the region that covers most of it, 0 if none does
    double iou = 0.0;                ///< with that region
    RockMiss miss = RockMiss::Other; ///< if it was not found
};

struct RockMatch {
    RockCounts counts;
    std::vector<RockVerdict> rocks;          ///< in the order of their numbers
    std::vector<std::uint32_t> falseRegions; ///< ascending
};

/// `isRock` by the region's number; if it is empty all regions are rocks.
[[nodiscard]] RockMatch matchRocks(const Overlaps& overlaps, const std::vector<std::uint8_t>& isRock, const RockRules& rules);

/// Numbers of rocks by their size in cells.
struct CellClass {
    std::size_t fromCells = 0; ///< up to the next class
    std::size_t rocks = 0, found = 0;
};
inline constexpr std::array<std::size_t, 4> kCellClasses{100, 200, 400, 1000};
[[nodiscard]] std::array<CellClass, 4> byCells(const RockMatch& match);

} // namespace edgescan::lab
