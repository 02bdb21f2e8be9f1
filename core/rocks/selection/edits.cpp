// Converts edits to constraints on segments.
#include "core/rocks/selection/edits.h"

#include "core/rocks/selection/region_changes.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace edgescan::rocks {
namespace {

constexpr double kLeastZ = -13.0; // less than any evidence: the level at which a segment appears

std::uint32_t segmentAt(const Segmentation& segments, std::uint32_t k) {
    return k < segments.segment.size() ? segments.segment[k] : kNoSegment;
}

// By segment; UINT32_MAX: it has no cell.
std::vector<std::uint32_t> firstCells(const Segmentation& segments) {
    std::vector<std::uint32_t> first(segments.sums.size(), UINT32_MAX);
    for (std::uint32_t k = 0; k < segments.segment.size(); ++k) first[segments.segment[k]] = std::min(first[segments.segment[k]], k);
    return first;
}

void addFirstCells(std::span<const std::uint32_t> group, const std::vector<std::uint32_t>& firstCell, Edit& join) {
    for (const std::uint32_t n : group) {
        if (firstCell[n] != UINT32_MAX) join.cells.push_back(firstCell[n]);
    }
}

// By rock of `map`: the number of the rock of `plain` with which it shares the most cells, and no other rock more; 0: there is none.
std::vector<std::uint32_t> sharedNumbers(const RegionMap& map, const RegionMap& plain, const SharedCells& shared) {
    std::vector<std::pair<SharedCells::key_type, std::uint64_t>> ordered;
    for (const auto& each : shared) {
        const auto& [before, now] = each.first;
        if (before != 0 && before <= plain.rocks && now != 0 && now <= map.rocks) ordered.push_back(each);
    }
    std::ranges::stable_sort(ordered, std::greater(), [](const auto& each) { return each.second; });
    std::vector<std::uint32_t> numbers(static_cast<std::size_t>(map.rocks) + 1, 0);
    std::vector<std::uint8_t> isGiven(static_cast<std::size_t>(plain.rocks) + 1, 0);
    for (const auto& [both, cells] : ordered) {
        if (isGiven[both.first] != 0 || numbers[both.second] != 0) continue;
        numbers[both.second] = both.first;
        isGiven[both.first] = 1;
    }
    return numbers;
}

// By edit: the rocks at its cells, and along a stroke those on both sides; ascending.
std::vector<std::vector<std::uint32_t>> rocksTouched(const RegionMap& map, const Segmentation& segments, std::span<const Edit> edits) {
    std::vector<std::vector<std::uint32_t>> touched(edits.size());
    const auto width = static_cast<std::uint32_t>(segments.segment.beams);
    for (std::size_t n = 0; n < edits.size(); ++n) {
        const auto add = [&](std::uint32_t k) {
            const std::uint32_t region = map.regionOfSegment[segmentAt(segments, k)];
            if (region != 0 && region <= map.rocks) touched[n].push_back(region);
        };
        if (edits[n].kind == EditKind::Cut) {
            for (const std::uint32_t k : strokeCells(edits[n].cells, segments.segment.lines, segments.segment.beams)) {
                for (const std::uint32_t near : {k, k - 1, k + 1, k - width, k + width}) add(near);
            }
        } else {
            for (const std::uint32_t k : edits[n].cells) add(k);
        }
        std::ranges::sort(touched[n]);
        touched[n].erase(std::ranges::unique(touched[n]).begin(), touched[n].end());
    }
    return touched;
}

} // namespace

std::size_t changesByHand(std::span<const Edit> edits) {
    return static_cast<std::size_t>(std::ranges::count_if(edits, [](const Edit& edit) { return edit.kind != EditKind::Whole; }));
}

std::vector<Edit> mergedEdits(std::span<const Edit> base, std::span<const Edit> mine, std::span<const Edit> theirs) {
    if (std::ranges::equal(base, theirs)) return {mine.begin(), mine.end()};
    // Of edits that occur several times each is one.
    const auto without = [](std::span<const Edit> edits, std::span<const Edit> gone) {
        std::vector<Edit> left;
        std::vector<Edit> rest(gone.begin(), gone.end());
        for (const Edit& edit : edits) {
            if (const auto found = std::ranges::find(rest, edit); found != rest.end())
                rest.erase(found);
            else
                left.push_back(edit);
        }
        return left;
    };
    std::vector<Edit> merged = without(theirs, without(base, mine));
    const std::vector<Edit> theirNew = without(theirs, base);
    std::ranges::move(without(without(mine, base), theirNew), std::back_inserter(merged));
    return merged;
}

std::vector<CutLine> cutsOf(std::span<const Edit> edits) {
    std::vector<CutLine> cuts;
    for (const Edit& edit : edits) {
        if (edit.kind == EditKind::Cut) cuts.push_back(edit.cells);
    }
    return cuts;
}

std::vector<SegmentPair> pairsOf(const Segmentation& segments, std::span<const Edit> edits) {
    std::vector<SegmentPair> pairs;
    std::vector<std::uint8_t> whole(segments.sums.size(), 0);
    for (const Edit& edit : edits) {
        if (edit.kind != EditKind::Whole) continue;
        for (const std::uint32_t k : edit.cells) whole[segmentAt(segments, k)] = 1;
    }
    whole[kNoSegment] = 0;
    // The sides of such a cut are separate, and next to its ends nothing is.
    const auto isInWhole = [&](const CutLine& cut) {
        const std::vector<std::uint32_t> cells = strokeCells(cut, segments.segment.lines, segments.segment.beams);
        return std::ranges::any_of(cells, [&](std::uint32_t k) { return whole[segments.segment[k]] != 0; });
    };
    for (const Edit& edit : edits) {
        if (edit.kind == EditKind::Cut && !isInWhole(edit.cells)) {
            const std::vector<SegmentPair> across = segmentsAcross(segments.segment, segments.borders, std::span(&edit.cells, 1));
            pairs.insert(pairs.end(), across.begin(), across.end());
        }
        // Older joins are refused only after the pieces of the rock are joined: the last pair comes first.
        if (edit.kind == EditKind::Whole && segmentAt(segments, edit.cells[0]) != kNoSegment)
            pairs.push_back({segmentAt(segments, edit.cells[0]), kNoSegment, false});
        if (edit.kind != EditKind::Join && edit.kind != EditKind::Part && edit.kind != EditKind::Whole) continue;
        for (std::size_t n = 1; n < edit.cells.size(); ++n) {
            const SegmentPair pair{segmentAt(segments, edit.cells[0]), segmentAt(segments, edit.cells[n]), edit.kind != EditKind::Part};
            if (pair.a != kNoSegment && pair.b != kNoSegment && pair.a != pair.b) pairs.push_back(pair);
        }
    }
    return pairs;
}

std::vector<RockCall> rockCallsOf(const Segmentation& segments, std::span<const Edit> edits) {
    std::vector<RockCall> called;
    for (const Edit& edit : edits) {
        if (edit.kind == EditKind::Join) {
            const std::uint32_t first = segmentAt(segments, edit.cells.front()), last = segmentAt(segments, edit.cells.back());
            if (first != kNoSegment && last != kNoSegment && first != last) called.push_back({first, true, last});
        }
        if (edit.kind != EditKind::Rock && edit.kind != EditKind::NotRock && edit.kind != EditKind::Whole) continue;
        const std::uint32_t segment = segmentAt(segments, edit.cells.front());
        if (segment != kNoSegment) called.push_back({segment, edit.kind != EditKind::NotRock});
    }
    return called;
}

RegionMap withKeptNumbers(RegionMap map, const Segmentation& segments, const RegionMap& plain, const Segmentation& uncut,
                          std::span<const Edit> edits) {
    std::vector<std::uint32_t> numbers = sharedNumbers(map, plain, sharedCells(uncut, plain, segments, map));
    std::uint32_t next = plain.rocks;
    const std::vector<std::vector<std::uint32_t>> touched = rocksTouched(map, segments, edits);
    std::vector<std::size_t> last(numbers.size(), 0), lastJoin(numbers.size(), 0); // edits that touch the rock
    for (std::size_t n = 0; n < touched.size(); ++n) {
        for (const std::uint32_t rock : touched[n]) {
            last[rock] = n;
            if (edits[n].kind == EditKind::Join) lastJoin[rock] = n;
        }
    }
    // A later edit made the other pieces that it touches, too. The number of a piece that is joined again stays free.
    for (std::size_t n = 0; n < touched.size(); ++n) {
        bool isFirst = true;
        const std::uint32_t before = next;
        for (const std::uint32_t rock : touched[n]) {
            if (numbers[rock] == 0 && (std::exchange(isFirst, false) || last[rock] == n)) numbers[rock] = ++next;
        }
        const bool divides =
            edits[n].kind == EditKind::Part || (edits[n].kind == EditKind::Cut && (n == 0 || edits[n - 1].kind != EditKind::Cut));
        if (divides && next == before && std::ranges::any_of(touched[n], [&](std::uint32_t rock) { return lastJoin[rock] > n; })) ++next;
    }
    for (std::uint32_t rock = 1; rock <= map.rocks; ++rock) {
        if (numbers[rock] == 0) numbers[rock] = ++next;
    }
    const std::uint32_t highest = *std::ranges::max_element(numbers);
    std::vector<std::uint32_t> order(static_cast<std::size_t>(highest) + 1, 0);
    for (std::uint32_t rock = 1; rock <= map.rocks; ++rock) order[numbers[rock]] = rock;
    for (auto region = map.rocks + 1; region < map.regions.size(); ++region) order.push_back(region);
    renumber(map, order);
    map.rocks = highest;
    return map;
}

std::optional<Edit> joinOf(const Segmentation& segments, const RegionMap& map, std::span<const std::uint32_t> cells) {
    Edit join{EditKind::Join, {}};
    std::vector<std::uint32_t> regions, others; // others: segments without one of the cells
    for (const std::uint32_t k : cells) {
        const std::uint32_t region = map.regionOfSegment[segmentAt(segments, k)];
        if (region == 0 || std::ranges::find(regions, region) != regions.end()) continue;
        regions.push_back(region);
        join.cells.push_back(k);
    }
    if (regions.size() < 2) return std::nullopt;
    for (std::uint32_t n = 1; n < map.regionOfSegment.size(); ++n) {
        const auto region = std::ranges::find(regions, map.regionOfSegment[n]);
        if (region != regions.end() && segmentAt(segments, join.cells[static_cast<std::size_t>(region - regions.begin())]) != n)
            others.push_back(n);
    }
    const std::uint32_t last = join.cells.back(); // the first cell and the last are in two of the regions
    join.cells.pop_back();
    addFirstCells(others, firstCells(segments), join);
    join.cells.push_back(last);
    return join;
}

std::vector<std::uint32_t> middleCells(const Grid<std::uint32_t>& segment, std::size_t segments) {
    std::vector<std::uint32_t> cells(segments, 0), middle(segments, UINT32_MAX);
    for (const std::uint32_t n : segment.cells) ++cells[n];
    for (std::uint32_t& left : cells) left = left / 2 + 1;
    for (std::uint32_t k = 0; k < segment.size(); ++k) {
        if (segment[k] != kNoSegment && --cells[segment[k]] == 0) middle[segment[k]] = k;
    }
    return middle;
}

std::optional<Edit> joinOfSegments(const Segmentation& segments, std::span<const std::uint32_t> group) {
    Edit join{EditKind::Join, {}};
    addFirstCells(group, firstCells(segments), join);
    return join.cells.size() < 2 ? std::nullopt : std::optional(std::move(join));
}

NestedPieces nestedPieces(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k, std::size_t mostLarger) {
    NestedPieces line;
    const std::uint32_t segment = segmentAt(segments, k);
    if (segment == kNoSegment) return line;
    const std::vector<std::uint32_t> firstCell = firstCells(segments);
    std::vector<std::vector<std::uint32_t>> members(segments.sums.size());
    for (std::uint32_t n = 1; n < members.size(); ++n) members[n] = {n};
    const auto cellsOf = [&](const std::vector<std::uint32_t>& group) {
        return std::accumulate(group.begin(), group.end(), 0U,
                               [&](std::uint32_t sum, std::uint32_t n) { return sum + segments.sums[n].cells; });
    };
    std::uint32_t own = segment;
    double made = kLeastZ;
    bool isLarger = false; // larger than the region
    Edit join{EditKind::Join, {k}};
    const auto add = [&](double until, Edit edit) {
        std::vector<std::uint32_t> sorted = members[own];
        std::ranges::sort(sorted);
        line.pieces.push_back({sorted, cellsOf(sorted), until - made, std::move(edit)});
    };
    const auto endRegion = [&](double until) {
        isLarger = true;
        line.region = line.pieces.size();
        add(until, {});
        addFirstCells(members[own], firstCell, join);
    };
    for (const Merge& merge : tree.merges) {
        if (merge.height > level && !isLarger && (merge.remaining == own || merge.gone == own)) endRegion(merge.height);
        if (isLarger && line.pieces.size() > line.region + mostLarger) break;
        bool grows = false;
        if (merge.remaining == own || merge.gone == own) {
            const std::vector<std::uint32_t>& other = members[merge.remaining == own ? merge.gone : merge.remaining];
            const auto seen = std::ranges::find_if(other, [&](std::uint32_t n) { return firstCell[n] != UINT32_MAX; });
            if (seen != other.end() && merge.height >= kLeastZ && !isLarger) add(merge.height, {EditKind::Part, {k, firstCell[*seen]}});
            grows = seen != other.end() && isLarger;
            if (grows) addFirstCells(other, firstCell, join);
            own = merge.remaining;
            made = std::max(made, merge.height);
        }
        std::vector<std::uint32_t>& kept = members[merge.remaining];
        kept.insert(kept.end(), members[merge.gone].begin(), members[merge.gone].end());
        members[merge.gone].clear();
        if (grows) add(merge.height, join);
    }
    if (!isLarger) endRegion(made);
    return line;
}

std::size_t bestSplit(const NestedPieces& line) {
    std::size_t best = line.region;
    for (std::size_t n = 0; n < line.region; ++n) {
        if (line.pieces[n].cells >= kFewestSplit && (best == line.region || line.pieces[n].life > line.pieces[best].life)) best = n;
    }
    return best;
}

std::optional<Edit> splitAt(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k) {
    const NestedPieces line = nestedPieces(segments, tree, level, k, 0);
    const std::size_t best = bestSplit(line);
    return best == line.region ? std::nullopt : std::optional(line.pieces[best].edit);
}

} // namespace edgescan::rocks
