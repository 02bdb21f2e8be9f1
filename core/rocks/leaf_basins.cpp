// Basins by steepest ascent, and their joining.
#include "core/rocks/leaf_basins.h"

#include "core/rocks/rock_leaves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgescan {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

// The cell that each cell goes to; itself at a peak, kNone where nothing was measured.
std::vector<std::uint32_t> ascents(const Grid<float>& distance, const CellLinks& links) {
    const auto beams = static_cast<std::size_t>(distance.beams);
    std::vector<std::uint32_t> to(distance.size(), kNone);
    for (int i = 0; i < distance.lines; ++i) {
        for (int j = 0; j < distance.beams; ++j) {
            const std::size_t k = distance.index(i, j);
            if (!links.solid(k)) continue;
            const bool above = i > 0 && links.toNextLine(k - beams);
            const bool left = j > 0 && links.toNextBeam(k - 1);
            std::size_t best = k;
            const auto climb = [&](bool linked, std::size_t there) {
                if (linked && distance[there] > distance[best]) best = there;
            };
            climb(above, k - beams);
            climb(left, k - 1);
            climb(j + 1 < distance.beams && links.toNextBeam(k), k + 1);
            climb(i + 1 < distance.lines && links.toNextLine(k), k + beams);
            if (best == k && above && distance[k - beams] == distance[k])
                best = k - beams;
            else if (best == k && left && distance[k - 1] == distance[k])
                best = k - 1;
            to[k] = static_cast<std::uint32_t>(best);
        }
    }
    return to;
}

// Every cell goes to its peak at once.
void climbToPeaks(std::vector<std::uint32_t>& to) {
    std::vector<std::uint32_t> way;
    for (std::uint32_t k = 0; k < to.size(); ++k) {
        if (to[k] == kNone) continue;
        std::uint32_t at = k;
        while (to[at] != at && to[to[at]] != to[at]) {
            way.push_back(at);
            at = to[at];
        }
        const std::uint32_t peak = to[at];
        for (const std::uint32_t passed : way) to[passed] = peak;
        way.clear();
    }
}

// A place where two basins meet.
struct Saddle {
    std::uint32_t p, q;
    std::uint32_t squared; // of the distance, a whole number of cells
};

std::uint32_t squaredOf(float distance) {
    return static_cast<std::uint32_t>(std::lround(static_cast<double>(distance) * static_cast<double>(distance)));
}

std::vector<Saddle> saddles(const Grid<float>& distance, const CellLinks& links, const std::vector<std::uint32_t>& peak) {
    const auto beams = static_cast<std::uint32_t>(distance.beams);
    std::vector<Saddle> found;
    const auto look = [&](std::uint32_t p, std::uint32_t q) {
        if (peak[p] != peak[q]) found.push_back({p, q, squaredOf(std::min(distance[p], distance[q]))});
    };
    for (int i = 0; i < distance.lines; ++i) {
        for (int j = 0; j < distance.beams; ++j) {
            const auto k = static_cast<std::uint32_t>(distance.index(i, j));
            if (j + 1 < distance.beams && links.toNextBeam(k)) look(k, k + 1);
            if (i + 1 < distance.lines && links.toNextLine(k)) look(k, k + beams);
        }
    }
    return found;
}

// Highest first; those of one height stay in the order of their cells.
std::vector<Saddle> highestFirst(const std::vector<Saddle>& saddles) {
    std::uint32_t highest = 0;
    for (const Saddle& saddle : saddles) highest = std::max(highest, saddle.squared);
    std::vector<std::uint32_t> place(static_cast<std::size_t>(highest) + 2);
    for (const Saddle& saddle : saddles) ++place[highest - saddle.squared + 1];
    std::partial_sum(place.begin(), place.end(), place.begin());
    std::vector<Saddle> sorted(saddles.size());
    for (const Saddle& saddle : saddles) sorted[place[highest - saddle.squared]++] = saddle;
    return sorted;
}

} // namespace

JoinedGroups::JoinedGroups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

std::uint32_t JoinedGroups::of(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
}

std::uint32_t numberByFirstCell(Grid<std::uint32_t>& group) {
    std::vector<std::uint32_t> number(group.size() + 1, kOpen);
    std::uint32_t count = 0;
    for (std::uint32_t& g : group.cells) {
        if (g == kOpen) continue;
        if (number[g] == kOpen) number[g] = ++count;
        g = number[g];
    }
    return count;
}

Grid<std::uint32_t> leafBasins(const Grid<float>& distance, const CellLinks& links) {
    std::vector<std::uint32_t> peak = ascents(distance, links);
    climbToPeaks(peak);
    // A basin is named by its peak, and so is a group of them by the highest.
    JoinedGroups groups(peak.size());
    for (const Saddle& saddle : highestFirst(saddles(distance, links, peak))) {
        std::uint32_t a = groups.of(peak[saddle.p]);
        std::uint32_t b = groups.of(peak[saddle.q]);
        if (a == b) continue;
        if (distance[a] < distance[b]) std::swap(a, b);
        if (distance[b] - std::min(distance[saddle.p], distance[saddle.q]) < kShallow) groups.join(a, b);
    }
    Grid<std::uint32_t> leaf(distance.lines, distance.beams);
    for (std::size_t k = 0; k < leaf.size(); ++k) {
        if (peak[k] != kNone) leaf[k] = groups.of(peak[k]) + 1;
    }
    numberByFirstCell(leaf);
    return leaf;
}

} // namespace edgescan
