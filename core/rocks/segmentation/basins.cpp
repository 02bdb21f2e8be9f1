// Basins by steepest ascent, and the joining of basins.
#include "core/rocks/segmentation/basins.h"

#include "core/base/bands.h"
#include "core/base/simd.h"
#include "core/rocks/segmentation/segments.h"

#include <algorithm>
#include <numeric>

namespace edgescan::rocks {
namespace {

// 1 where a cell and the one `step` cells further are on one surface (CellLinks).
EDGESCAN_INLINE void markLinks(const Support* support, const float* jump, std::size_t step, std::size_t cells,
                               std::uint8_t* __restrict linked) {
    for (std::size_t k = 0; k < cells; ++k)
        linked[k] = static_cast<std::uint8_t>((support[k] != Support::Void) & (support[k + step] != Support::Void) & (jump[k] <= 1.0F));
}

struct LinkMarks {
    Grid<std::uint8_t> toNextBeam, toNextLine;

    explicit LinkMarks(const CellLinks& links)
        : toNextBeam(links.support.lines, links.support.beams), toNextLine(links.support.lines, links.support.beams) {
        const auto beams = static_cast<std::size_t>(toNextBeam.beams);
        runInBands(toNextBeam.lines, bandsFor(toNextBeam.size(), 0), [&](int from, int end) {
            for (int i = from; i < end; ++i) {
                const std::size_t first = toNextBeam.index(i, 0);
                vectorised<markLinks>(&links.support[first], &links.cracks.jumpBeams[first], 1, beams - 1, &toNextBeam[first]);
                if (i + 1 < toNextBeam.lines)
                    vectorised<markLinks>(&links.support[first], &links.cracks.jumpLines[first], beams, beams, &toNextLine[first]);
            }
        });
    }
};

// The neighbour to which cell k moves, from the distances of the cell and its neighbours; -1 for those that are not linked.
EDGESCAN_INLINE std::uint32_t ascent(std::uint32_t k, std::uint32_t beams, float here, float above, float left, float right, float below) {
    float highest = here;
    std::uint32_t to = k;
    to = above > highest ? k - beams : to;
    highest = std::max(highest, above);
    to = left > highest ? k - 1 : to;
    highest = std::max(highest, left);
    to = right > highest ? k + 1 : to;
    highest = std::max(highest, right);
    to = below > highest ? k + beams : to;
    to = to == k && above == here ? k - beams : to;
    return to == k && left == here ? k - 1 : to;
}

// Distances and links of a line and of its two neighbouring lines; links at the border of the sweep are 0.
struct AscentLine {
    const float *above, *here, *below;
    const std::uint8_t *toAbove, *toNext, *toBelow;
};

// The moves of the cells between the ends of a line; `first`: its first cell.
EDGESCAN_INLINE void ascentsInside(const AscentLine& at, std::uint32_t first, std::uint32_t beams, std::uint32_t* __restrict to) {
    const auto [above, here, below, toAbove, toNext, toBelow] = at;
    for (std::uint32_t j = 1; j + 1 < beams; ++j) {
        to[j] = ascent(first + j, beams, here[j], toAbove[j] != 0 ? above[j] : -1.0F, toNext[j - 1] != 0 ? here[j - 1] : -1.0F,
                       toNext[j] != 0 ? here[j + 1] : -1.0F, toBelow[j] != 0 ? below[j] : -1.0F);
    }
}

// The cell to which each cell moves; the cell itself at a peak, and where the cell was not measured.
std::vector<std::uint32_t> ascents(const Grid<float>& distance, const LinkMarks& links) {
    const auto beams = static_cast<std::uint32_t>(distance.beams);
    std::vector<std::uint32_t> to(distance.size());
    const std::vector<std::uint8_t> none(beams);
    const auto ascend = [&](int i) {
        const bool isFirst = i == 0;
        const bool isLast = i + 1 == distance.lines;
        const AscentLine at{distance.line(isFirst ? i : i - 1), distance.line(i),
                            distance.line(isLast ? i : i + 1),  isFirst ? none.data() : links.toNextLine.line(i - 1),
                            links.toNextBeam.line(i),           links.toNextLine.line(i)};
        const auto first = static_cast<std::uint32_t>(distance.index(i, 0));
        vectorised<ascentsInside>(at, first, beams, &to[first]);
        for (const std::uint32_t j : {0U, beams - 1}) {
            to[first + j] = ascent(first + j, beams, at.here[j], at.toAbove[j] != 0 ? at.above[j] : -1.0F,
                                   j > 0 && at.toNext[j - 1] != 0 ? at.here[j - 1] : -1.0F, at.toNext[j] != 0 ? at.here[j + 1] : -1.0F,
                                   at.toBelow[j] != 0 ? at.below[j] : -1.0F);
        }
    };
    runInBands(distance.lines, bandsFor(distance.size(), 0), [&](int from, int end) {
        for (int i = from; i < end; ++i) ascend(i);
    });
    return to;
}

// Replaces each cell's next cell by its peak.
void climbToPeaks(std::vector<std::uint32_t>& to) {
    std::vector<std::uint32_t> way;
    for (std::uint32_t k = 0; k < to.size(); ++k) {
        std::uint32_t at = to[k];
        if (to[at] == at) continue;
        way.assign(1, k);
        while (to[to[at]] != to[at]) {
            way.push_back(at);
            at = to[at];
        }
        const std::uint32_t peak = to[at];
        for (const std::uint32_t passed : way) to[passed] = peak;
    }
}

// Peaks in the order of their cells, and for each cell with a range the number of its peak, from 1; kOpen without a range.
struct Basins {
    std::vector<std::uint32_t> peaks; // by number; index 0 is unused
    Grid<std::uint32_t> of;
};

Basins basinsOf(const Grid<float>& distance, const CellLinks& links, const LinkMarks& marks) {
    std::vector<std::uint32_t> to = ascents(distance, marks);
    climbToPeaks(to);
    Basins basins{{0}, Grid<std::uint32_t>(distance.lines, distance.beams)};
    for (std::uint32_t k = 0; k < to.size(); ++k) {
        if (to[k] != k || !links.solid(k)) continue;
        basins.of[k] = static_cast<std::uint32_t>(basins.peaks.size());
        basins.peaks.push_back(k);
    }
    for (std::uint32_t k = 0; k < to.size(); ++k) basins.of[k] = basins.of[to[k]];
    return basins;
}

// A place where two basins meet.
struct Saddle {
    std::uint32_t a, b;
    float distance;
    std::uint32_t squared; // squared distance to the barrier, a whole number
};

// 1 where the link to the next beam leads to another basin, 2 where that to the next line does.
EDGESCAN_INLINE void markSaddles(const std::uint32_t* basin, const std::uint8_t* toNextBeam, const std::uint8_t* toNextLine,
                                 std::size_t beams, std::size_t below, std::uint8_t* __restrict mark) {
    mark[beams - 1] = 0;
    for (std::size_t j = 0; j + 1 < beams; ++j) mark[j] = static_cast<std::uint8_t>((basin[j] != basin[j + 1] ? 1 : 0) & toNextBeam[j]);
    for (std::size_t j = 0; j < beams; ++j)
        mark[j] = static_cast<std::uint8_t>(mark[j] | ((basin[j] != basin[j + below] ? 2 : 0) & (toNextLine[j] << 1U)));
}

std::vector<Saddle> saddles(const Grid<float>& distance, const LinkMarks& links, const Basins& basins) {
    const auto beams = static_cast<std::size_t>(distance.beams);
    std::vector<Saddle> found;
    const auto add = [&](std::size_t p, std::size_t q) {
        const float lower = std::min(distance[p], distance[q]);
        found.push_back({basins.of[p], basins.of[q], lower, static_cast<std::uint32_t>(static_cast<double>(lower) * lower + 0.5)});
    };
    std::vector<std::uint8_t> marks(beams);
    for (int i = 0; i < distance.lines; ++i) {
        const std::size_t below = i + 1 < distance.lines ? beams : 0;
        vectorised<markSaddles>(basins.of.line(i), links.toNextBeam.line(i), links.toNextLine.line(i), beams, below, marks.data());
        for (std::size_t j = 0; j < beams; ++j) {
            if (marks[j] == 0) continue;
            const std::size_t k = distance.index(i, static_cast<int>(j));
            if ((marks[j] & 1U) != 0) add(k, k + 1);
            if ((marks[j] & 2U) != 0) add(k, k + beams);
        }
    }
    return found;
}

// Highest first; saddles of equal height in the order of their cells.
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

EDGESCAN_INLINE std::uint32_t largestOf(const std::uint32_t* numbers, std::size_t count) {
    std::uint32_t largest = 0;
    for (std::size_t k = 0; k < count; ++k) largest = std::max(largest, numbers[k]);
    return largest;
}

} // namespace

std::uint32_t lastSegment(const Grid<std::uint32_t>& segment) { return vectorised<largestOf>(segment.cells.data(), segment.size()); }

JoinedGroups::JoinedGroups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

std::uint32_t JoinedGroups::of(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
}

std::uint32_t numberByFirstCell(Grid<std::uint32_t>& group, std::span<const std::uint32_t> joined) {
    std::vector<std::uint32_t> number(joined.empty() ? lastSegment(group) + std::size_t{1} : joined.size(), kNoSegment);
    std::uint32_t count = 0;
    for (std::uint32_t& g : group.cells) {
        const std::uint32_t in = joined.empty() ? g : joined[g];
        if (in != kNoSegment && number[in] == kNoSegment) number[in] = ++count;
        g = number[in];
    }
    return count;
}

Grid<std::uint32_t> segmentBasins(const Grid<float>& distance, const CellLinks& links) {
    if (distance.size() == 0) return Grid<std::uint32_t>(distance.lines, distance.beams);
    const LinkMarks marks(links);
    Basins basins = basinsOf(distance, links, marks);
    // A group of basins has the number of the basin with the highest peak.
    const auto heightOf = [&](std::uint32_t basin) { return distance[basins.peaks[basin]]; };
    JoinedGroups groups(basins.peaks.size());
    for (const Saddle& saddle : highestFirst(saddles(distance, marks, basins))) {
        std::uint32_t a = groups.of(saddle.a);
        std::uint32_t b = groups.of(saddle.b);
        if (a == b) continue;
        if (heightOf(a) < heightOf(b)) std::swap(a, b);
        if (heightOf(b) - saddle.distance < kShallow) groups.join(a, b);
    }
    std::vector<std::uint32_t> group(basins.peaks.size());
    for (std::uint32_t n = 0; n < group.size(); ++n) group[n] = groups.of(n);
    numberByFirstCell(basins.of, group);
    return std::move(basins.of);
}

} // namespace edgescan::rocks
