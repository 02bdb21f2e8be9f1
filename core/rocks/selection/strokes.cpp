// Converts strokes and wheel turns to edits.
#include "core/rocks/selection/strokes.h"

#include "core/rocks/segmentation/basins.h"
#include "core/rocks/segmentation/equal_runs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

namespace edgescan::rocks {
namespace {

// Region of each cell of the line, in order; 0 without a region.
std::vector<std::uint32_t> regionsAlong(const Segmentation& segments, const RegionMap& map, const std::vector<std::uint32_t>& cells) {
    std::vector<std::uint32_t> regions;
    for (const std::uint32_t k : cells) regions.push_back(map.regionOfSegment[segments.segment[k]]);
    return regions;
}

} // namespace

std::optional<Edit> joinAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke) {
    const std::vector<std::uint32_t> cells = strokeCells(stroke, segments.segment.lines, segments.segment.beams);
    const std::vector<std::uint32_t> regions = regionsAlong(segments, map, cells);
    struct Run {
        std::uint32_t region;
        std::size_t begin, end;
    };
    std::vector<Run> longest; // the longest run in each region, in the order in which the regions are met
    eachEqualRun(regions, [&](std::uint32_t region, std::size_t begin, std::size_t end) {
        if (region == 0) return;
        const auto met = std::ranges::find(longest, region, &Run::region);
        if (met == longest.end())
            longest.push_back({region, begin, end});
        else if (end - begin > met->end - met->begin)
            *met = {region, begin, end};
    });
    std::vector<std::uint32_t> middles;
    for (const Run& run : longest) middles.push_back(cells[(run.begin + run.end) / 2]);
    return joinOf(segments, map, middles);
}

namespace {

/// The cells of the line in the region, each run of them with up to `reach` cells of the line before and behind it.
std::vector<CutLine> runsIn(std::uint32_t region, std::span<const std::uint32_t> regions, std::span<const std::uint32_t> cells,
                            std::size_t reach) {
    std::vector<CutLine> runs;
    eachEqualRun(regions, [&](std::uint32_t of, std::size_t begin, std::size_t end) {
        if (of != region) return;
        const auto from = static_cast<std::ptrdiff_t>(begin - std::min(begin, reach));
        CutLine run(cells.begin() + from, cells.begin() + static_cast<std::ptrdiff_t>(std::min(end + reach, cells.size())));
        if (run.size() == 1) run.push_back(run.front());
        runs.push_back(std::move(run));
    });
    return runs;
}

struct Middle {
    double lines = 0.0, beams = 0.0, cells = 0.0; // sums
    void add(std::size_t k, int width) {
        lines += static_cast<double>(k / static_cast<std::size_t>(width));
        beams += static_cast<double>(k % static_cast<std::size_t>(width));
        cells += 1.0;
    }
    [[nodiscard]] double apart(const Middle& other) const {
        return std::hypot(lines / cells - other.lines / other.cells, beams / cells - other.beams / other.cells);
    }
};

/// A region on the sides of runs of a line.
class DividedRegion {
public:
    DividedRegion(const Segmentation& segments, const RegionMap& map, std::uint32_t region, std::span<const CutLine> runs)
        : after_(segments.segment), inside_(after_.lines, after_.beams), onLine_(inside_), parts_(after_.size()), count_(segments.count()) {
        const CellLinks links{segments.inputs.surface->inverse.support, *segments.inputs.cracks};
        for (const CutLine& run : runs) {
            count_ = cutSegments(links, run, count_, after_);
            for (const std::uint32_t k : run) onLine_[k] = 1;
        }
        for (std::size_t k = 0; k < after_.size(); ++k) {
            inside_[k] = map.regionOfSegment[segments.segment[k]] == region ? 1 : 0;
            cutsOthers_ = cutsOthers_ || (inside_[k] == 0 && after_[k] != segments.segment[k]);
        }
    }

    [[nodiscard]] bool cutsOthers() const { return cutsOthers_; }

    /// A cell of each segment of each part; fewer than two parts: it is not divided.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> parts() {
        findSides();
        if (sides_.size() < 2) return {};
        // A segment belongs to the side with most of its cells.
        std::vector<std::vector<std::uint32_t>> votes(sides_.size(), std::vector<std::uint32_t>(static_cast<std::size_t>(count_) + 1));
        std::vector<Middle> middleOf(votes.front().size());
        Grid<std::uint32_t> offLine(after_.lines, after_.beams);
        for (std::size_t k = 0; k < after_.size(); ++k) {
            if (inside_[k] == 0 || after_[k] == kNoSegment) continue;
            middleOf[after_[k]].add(k, after_.beams);
            if (onLine_[k] != 0) continue;
            offLine[k] = after_[k];
            ++votes[sideOf(k)][after_[k]];
        }
        const std::vector<std::uint32_t> clear = middleCells(offLine, middleOf.size()), any = middleCells(after_, middleOf.size());
        std::vector<std::vector<std::uint32_t>> cells(sides_.size());
        for (std::uint32_t n = 1; n < middleOf.size(); ++n) {
            if (middleOf[n].cells == 0.0) continue;
            const auto most = std::ranges::max_element(votes, {}, [&](const auto& of) { return of[n]; });
            const std::size_t side = (*most)[n] > 0 ? static_cast<std::size_t>(most - votes.begin()) : nearestSide(middleOf[n]);
            cells[side].push_back(clear[n] != UINT32_MAX ? clear[n] : any[n]);
        }
        std::erase_if(cells, [](const auto& side) { return side.empty(); });
        return cells;
    }

private:
    /// Connected cells next to the line, 50 or more of them.
    void findSides() {
        const auto beams = static_cast<std::size_t>(after_.beams);
        const auto counts = [&](std::size_t k) { return inside_[k] != 0 && onLine_[k] == 0; };
        for (std::size_t k = 0; k < after_.size(); ++k) {
            if (!counts(k)) continue;
            if (k % beams + 1 < beams && counts(k + 1)) parts_.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k + 1));
            if (k + beams < after_.size() && counts(k + beams))
                parts_.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k + beams));
        }
        std::map<std::uint32_t, bool> atLine;
        for (std::size_t k = 0; k < after_.size(); ++k) {
            if (!counts(k)) continue;
            const std::uint32_t of = parts_.of(static_cast<std::uint32_t>(k));
            middles_[of].add(k, after_.beams);
            atLine[of] = atLine[of] || isAtLine(k);
        }
        for (const auto& [of, middle] : middles_) {
            if (!atLine[of] || middle.cells < kFewestSplit) continue;
            sides_.push_back(middle);
            names_.push_back(of);
        }
    }

    [[nodiscard]] bool isAtLine(std::size_t k) const {
        const int line = static_cast<int>(k) / after_.beams, beam = static_cast<int>(k) % after_.beams;
        for (int i = line - 1; i <= line + 1; ++i) {
            for (int j = beam - 1; j <= beam + 1; ++j) {
                if (after_.contains(i, j) && onLine_.at(i, j) != 0 && inside_.at(i, j) != 0) return true;
            }
        }
        return false;
    }

    [[nodiscard]] std::size_t nearestSide(const Middle& middle) const {
        return static_cast<std::size_t>(std::ranges::min_element(sides_, {}, [&](const Middle& side) { return side.apart(middle); }) -
                                        sides_.begin());
    }

    [[nodiscard]] std::size_t sideOf(std::size_t k) {
        const std::uint32_t of = parts_.of(static_cast<std::uint32_t>(k));
        const auto name = std::ranges::find(names_, of);
        return name != names_.end() ? static_cast<std::size_t>(name - names_.begin()) : nearestSide(middles_[of]);
    }

    Grid<std::uint32_t> after_;
    Grid<std::uint8_t> inside_, onLine_;
    JoinedGroups parts_;
    std::map<std::uint32_t, Middle> middles_; // of connected cells
    std::vector<Middle> sides_;
    std::vector<std::uint32_t> names_;
    std::uint32_t count_;
    bool cutsOthers_ = false;
};

} // namespace

std::vector<Edit> cutAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke, std::optional<std::uint32_t> chosen) {
    constexpr std::size_t kReach = 4; // past the outline, which other settings move by a cell or two
    const std::vector<std::uint32_t> cells = strokeCells(stroke, segments.segment.lines, segments.segment.beams);
    const std::vector<std::uint32_t> regions = regionsAlong(segments, map, cells);
    std::map<std::uint32_t, std::size_t> crossed; // and how many cells of the line are in each
    for (const std::uint32_t region : regions) ++crossed[region];
    crossed.erase(0);
    if (crossed.empty()) return {};
    if (crossed.begin()->first > map.rocks) return {Edit{EditKind::Cut, stroke}};
    const std::uint32_t first = chosen ? map.regionOfSegment[segments.segment[*chosen]] : 0;
    std::vector<std::uint32_t> inOrder;
    for (const auto& [region, count] : crossed) {
        if (region <= map.rocks) inOrder.push_back(region);
    }
    std::ranges::stable_sort(inOrder, std::greater(), [&](std::uint32_t region) { return std::pair(region == first, crossed[region]); });
    for (const std::uint32_t region : inOrder) {
        for (const std::size_t reach : {kReach, std::size_t{0}}) {
            const std::vector<CutLine> runs = runsIn(region, regions, cells, reach);
            DividedRegion divided(segments, map, region, runs);
            if (divided.cutsOthers()) continue;
            std::vector<std::vector<std::uint32_t>> sides = divided.parts();
            if (sides.size() < 2) break;
            std::vector<Edit> edits;
            for (const CutLine& run : runs) edits.push_back({EditKind::Cut, run});
            for (std::vector<std::uint32_t>& side : sides) edits.push_back({EditKind::Whole, std::move(side)});
            return edits;
        }
    }
    return {};
}

namespace {

/// Whether at least two cells of a join are in the region.
bool joins(const Edit& edit, const Segmentation& segments, const std::vector<std::uint32_t>& region) {
    if (edit.kind != EditKind::Join) return false;
    return std::ranges::count_if(edit.cells, [&](std::uint32_t k) {
               return k < segments.segment.size() && std::ranges::binary_search(region, segments.segment[k]);
           }) >= 2;
}

/// The pieces of the part at `k` as it was before edits joined it, the part itself last. Empty: no edit joined anything to it.
struct JoinedPart {
    std::vector<NestedPiece> pieces;
    std::vector<Edit> unjoined, others;
};
std::optional<JoinedPart> joinedPartAt(const Segmentation& segments, const MergeTree& tree, const std::vector<std::uint32_t>& region,
                                       double level, std::uint32_t k, std::span<const Edit> edits) {
    std::vector<Edit> others;
    for (const Edit& edit : edits) {
        if (!joins(edit, segments, region)) others.push_back(edit);
    }
    if (others.size() == edits.size()) return std::nullopt;
    const MergeTree before = withPairs(tree, segments, pairsOf(segments, others));
    NestedPieces all = nestedPieces(segments, before, level, k, 0);
    JoinedPart part;
    part.pieces.assign(all.pieces.begin(), all.pieces.begin() + static_cast<std::ptrdiff_t>(all.region) + 1);
    const std::vector<std::uint32_t>& own = part.pieces.back().segments;
    if (std::ranges::includes(own, region)) return std::nullopt;
    const std::vector<std::uint32_t> group = groupsAt(before, segments.count(), level);
    const auto groupAt = [&](std::uint32_t cell) { return cell < segments.segment.size() ? group[segments.segment[cell]] : 0; };
    for (Edit edit : edits) {
        const bool loses = joins(edit, segments, region) && std::erase_if(edit.cells, [&](std::uint32_t cell) {
                                                                return cell < segments.segment.size() &&
                                                                       std::ranges::binary_search(own, segments.segment[cell]);
                                                            }) > 0;
        // What remains of it may be the pieces of one region, as it was before.
        const auto isOther = [&](std::uint32_t cell) { return groupAt(cell) != groupAt(edit.cells.front()); };
        if (!loses || std::ranges::any_of(edit.cells, isOther)) part.unjoined.push_back(std::move(edit));
    }
    part.others = std::move(others);
    return part;
}

} // namespace

WheelPieces wheelPiecesAt(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k, std::span<const Edit> edits,
                          std::size_t mostLarger) {
    WheelPieces family;
    NestedPieces all = nestedPieces(segments, tree, level, k, mostLarger);
    if (all.pieces.empty()) return family;
    std::size_t split = bestSplit(all);
    if (auto joined = joinedPartAt(segments, tree, all.pieces[all.region].segments, level, k, edits)) {
        split = joined->pieces.size() - 1;
        family.unjoined = std::move(joined->unjoined);
        family.others = std::move(joined->others);
        joined->pieces.insert(joined->pieces.end(), all.pieces.begin() + static_cast<std::ptrdiff_t>(all.region), all.pieces.end());
        all = {std::move(joined->pieces), split + 1};
    }
    for (std::size_t n = 0; n < all.pieces.size(); ++n) {
        if (n < all.region && n != split && all.pieces[n].cells < kFewestSplit) continue;
        if (n == all.region) family.nested.region = family.nested.pieces.size();
        if (n == split) family.split = family.nested.pieces.size();
        family.nested.pieces.push_back(std::move(all.pieces[n]));
    }
    return family;
}

std::optional<std::vector<Edit>> editsOfSplit(const Segmentation& segments, const WheelPieces& wheel, std::size_t piece) {
    if (piece > wheel.split || !wheel.unjoined) return std::nullopt;
    if (piece == wheel.split) return wheel.unjoined;
    const NestedPiece& split = wheel.nested.pieces[piece];
    std::vector<std::uint32_t> rest;
    std::ranges::set_difference(wheel.nested.pieces[wheel.nested.region].segments, split.segments, std::back_inserter(rest));
    std::vector<Edit> edits = wheel.others;
    for (const auto& join : {joinOfSegments(segments, rest), joinOfSegments(segments, split.segments)}) {
        if (join) edits.push_back(*join);
    }
    edits.push_back(split.edit); // the two are apart: the later edit is valid
    return edits;
}

} // namespace edgescan::rocks
