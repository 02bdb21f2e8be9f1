// Compares regions with true rocks.
#include "app/lab/score/rock_score.h"

#include <algorithm>
#include <span>

namespace edgescan::lab {
namespace {

constexpr double kSame = 0.5; // a larger intersection over union means the same rock, so at most one region can match a rock

/// The true labels below a region's cells.
struct Ground {
    std::size_t background = 0, smallRocks = 0;
    bool isSmallRock = false; ///< it matches a rock that is too small to be required
};

double shareOf(std::size_t part, std::size_t whole) { return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole); }

std::vector<Ground> groundOf(const Overlaps& overlaps, std::size_t leastCells) {
    std::vector<Ground> ground(overlaps.regionCells.size());
    for (const Overlaps::Shared& one : overlaps.shared) {
        if (one.region == 0) continue;
        Ground& under = ground[one.region];
        if (one.rock == 0) {
            under.background += one.cells;
        } else if (overlaps.rockCells[one.rock] < leastCells) {
            under.smallRocks += one.cells;
            under.isSmallRock = under.isSmallRock || overlaps.iou(one) > kSame;
        }
    }
    return ground;
}

struct Judged {
    const Overlaps& overlaps;
    const std::vector<Ground>& ground;
    const std::vector<std::uint8_t>& isRock;
    bool strict;

    [[nodiscard]] bool isThere(std::uint32_t region) const {
        return region != 0 && !(strict && region < isRock.size() && isRock[region] == 0);
    }
};

/// `of`: the overlaps of the rock with every region, including removed ones.
RockVerdict verdictOf(const Judged& judged, std::uint32_t rock, std::span<const Overlaps::Shared> of) {
    const Overlaps& overlaps = judged.overlaps;
    RockVerdict verdict{.rock = rock, .cells = overlaps.rockCells[rock]};
    std::size_t most = 0;
    std::size_t inside = 0;
    bool dropped = false;
    for (const Overlaps::Shared& one : of) {
        if (one.region == 0) continue;
        const double iou = overlaps.iou(one);
        if (!judged.isThere(one.region)) {
            dropped = dropped || iou > kSame;
            continue;
        }
        if (2 * one.cells >= overlaps.regionCells[one.region]) inside += one.cells;
        if (iou <= kSame && (verdict.found || one.cells <= most)) continue;
        most = one.cells;
        verdict.region = one.region;
        verdict.iou = iou;
        verdict.found = iou > kSame;
    }
    const bool held = 2 * most >= verdict.cells;
    const std::size_t rest = overlaps.regionCells[verdict.region] - most;
    verdict.miss = dropped                                                       ? RockMiss::Dropped
                   : held && 2 * judged.ground[verdict.region].background > rest ? RockMiss::Wall
                   : held                                                        ? RockMiss::Merged
                   : 2 * inside >= verdict.cells                                 ? RockMiss::Split
                                                                                 : RockMiss::Other;
    return verdict;
}

} // namespace

RockCounts& RockCounts::operator+=(const RockCounts& other) {
    found += other.found;
    missed += other.missed;
    falseRegions += other.falseRegions;
    iou += other.iou;
    for (std::size_t n = 0; n < kMisses; ++n) missedBy[n] += other.missedBy[n];
    return *this;
}

double RockCounts::pq() const { return sq() * f1(); }
double RockCounts::sq() const { return found == 0 ? 0.0 : iou / static_cast<double>(found); }
double RockCounts::f1() const { return shareOf(2 * found, 2 * found + falseRegions + missed); }

double Overlaps::iou(const Shared& one) const { return shareOf(one.cells, rockCells[one.rock] + regionCells[one.region] - one.cells); }

Overlaps overlapsOf(const Grid<std::uint8_t>& counts, const Grid<std::uint32_t>& rock, const Grid<std::uint32_t>& region) {
    const auto tableOf = [](const Grid<std::uint32_t>& labels) {
        const auto largest = std::ranges::max_element(labels.cells);
        return std::vector<std::size_t>(1 + (largest == labels.cells.end() ? 0 : std::size_t{*largest}));
    };
    Overlaps overlaps{{}, tableOf(rock), tableOf(region)};
    std::vector<std::uint64_t> pairs;
    pairs.reserve(counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] == 0) continue;
        ++overlaps.rockCells[rock[k]];
        ++overlaps.regionCells[region[k]];
        pairs.push_back(std::uint64_t{rock[k]} << 32U | region[k]);
    }
    std::ranges::sort(pairs);
    for (const std::uint64_t pair : pairs) {
        const auto rockNumber = static_cast<std::uint32_t>(pair >> 32U);
        const auto regionNumber = static_cast<std::uint32_t>(pair);
        if (overlaps.shared.empty() || overlaps.shared.back().rock != rockNumber || overlaps.shared.back().region != regionNumber)
            overlaps.shared.push_back({rockNumber, regionNumber, 0});
        ++overlaps.shared.back().cells;
    }
    return overlaps;
}

RockMatch matchRocks(const Overlaps& overlaps, const std::vector<std::uint8_t>& isRock, const RockRules& rules) {
    const std::vector<Ground> ground = groundOf(overlaps, rules.leastCells);
    const Judged judged{overlaps, ground, isRock, rules.strict};
    RockMatch match;
    std::vector<std::uint8_t> taken(overlaps.regionCells.size());
    for (std::size_t from = 0; from < overlaps.shared.size();) {
        std::size_t to = from;
        const std::uint32_t rock = overlaps.shared[from].rock;
        while (to < overlaps.shared.size() && overlaps.shared[to].rock == rock) ++to;
        const std::span<const Overlaps::Shared> of(&overlaps.shared[from], to - from);
        from = to;
        if (rock == 0 || overlaps.rockCells[rock] < rules.leastCells) continue;
        const RockVerdict verdict = verdictOf(judged, rock, of);
        match.rocks.push_back(verdict);
        if (verdict.found) {
            taken[verdict.region] = 1;
            ++match.counts.found;
            match.counts.iou += verdict.iou;
        } else {
            ++match.counts.missed;
            ++match.counts.missedBy[static_cast<std::size_t>(verdict.miss)];
        }
    }
    for (std::uint32_t region = 1; region < overlaps.regionCells.size(); ++region) {
        const std::size_t cells = overlaps.regionCells[region];
        const Ground& under = ground[region];
        if (cells < rules.leastCells || taken[region] != 0 || !judged.isThere(region)) continue;
        if (2 * under.smallRocks >= cells || under.isSmallRock) continue;
        if (!rules.strict && 2 * under.background >= cells) continue;
        match.falseRegions.push_back(region);
    }
    match.counts.falseRegions = match.falseRegions.size();
    return match;
}

std::array<CellClass, 4> byCells(const RockMatch& match) {
    std::array<CellClass, 4> classes;
    for (std::size_t n = 0; n < classes.size(); ++n) classes[n].fromCells = kCellClasses[n];
    for (const RockVerdict& rock : match.rocks) {
        const auto above = std::ranges::upper_bound(kCellClasses, rock.cells);
        if (above == kCellClasses.begin()) continue;
        CellClass& own = classes[static_cast<std::size_t>(above - kCellClasses.begin()) - 1];
        ++own.rocks;
        own.found += rock.found ? 1 : 0;
    }
    return classes;
}

} // namespace edgescan::lab
