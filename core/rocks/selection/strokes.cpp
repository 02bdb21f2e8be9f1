// Converts strokes and wheel turns to edits.
#include "core/rocks/selection/strokes.h"

#include "core/rocks/segmentation/equal_runs.h"

#include <algorithm>
#include <iterator>

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

std::optional<Edit> cutAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke) {
    const std::vector<std::uint32_t> regions =
        regionsAlong(segments, map, strokeCells(stroke, segments.segment.lines, segments.segment.beams));
    if (std::ranges::all_of(regions, [](std::uint32_t region) { return region == 0; })) return std::nullopt;
    return Edit{EditKind::Cut, stroke};
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
std::optional<JoinedPart> joinedPartAt(const Segmentation& segments, const std::vector<std::uint32_t>& region, double level,
                                       std::uint32_t k, std::span<const Edit> edits) {
    std::vector<Edit> others;
    for (const Edit& edit : edits) {
        if (!joins(edit, segments, region)) others.push_back(edit);
    }
    if (others.size() == edits.size()) return std::nullopt;
    const MergeTree before = mergeTree(segments.count(), segments.borders, pairsOf(segments, others));
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
    if (auto joined = joinedPartAt(segments, all.pieces[all.region].segments, level, k, edits)) {
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
