// Converts edits to constraints on segments.
#include "core/rocks/selection/edits.h"

#include <algorithm>
#include <numeric>

namespace edgescan {
namespace {

constexpr double kLeastZ = -13.0; // less than any evidence: the level at which a segment appears

std::uint32_t leafAt(const RockLeaves& leaves, std::uint32_t k) { return k < leaves.leaf.size() ? leaves.leaf[k] : kOpen; }

} // namespace

std::vector<CutLine> cutsOf(std::span<const RockEdit> edits) {
    std::vector<CutLine> cuts;
    for (const RockEdit& edit : edits) {
        if (edit.kind == RockEditKind::Cut) cuts.push_back(edit.cells);
    }
    return cuts;
}

std::vector<LeafPair> pairsOf(const RockLeaves& leaves, std::span<const RockEdit> edits) {
    std::vector<LeafPair> pairs;
    for (const RockEdit& edit : edits) {
        if (edit.kind == RockEditKind::Cut) {
            const std::vector<LeafPair> across = leavesAcross(leaves.leaf, leaves.borders, std::span(&edit.cells, 1));
            pairs.insert(pairs.end(), across.begin(), across.end());
        }
        if (edit.kind != RockEditKind::Join && edit.kind != RockEditKind::Part) continue;
        for (std::size_t n = 1; n < edit.cells.size(); ++n) {
            const LeafPair pair{leafAt(leaves, edit.cells[0]), leafAt(leaves, edit.cells[n]), edit.kind == RockEditKind::Join};
            if (pair.a != kOpen && pair.b != kOpen && pair.a != pair.b) pairs.push_back(pair);
        }
    }
    return pairs;
}

std::vector<CalledLeaf> calledOf(const RockLeaves& leaves, std::span<const RockEdit> edits) {
    std::vector<CalledLeaf> called;
    for (const RockEdit& edit : edits) {
        if (edit.kind != RockEditKind::Rock && edit.kind != RockEditKind::NotRock) continue;
        for (const std::uint32_t k : edit.cells) {
            if (leafAt(leaves, k) != kOpen) called.push_back({leafAt(leaves, k), edit.kind == RockEditKind::Rock});
        }
    }
    return called;
}

RockLine rockLine(const RockLeaves& leaves, const MergeTree& tree, double level, std::uint32_t k, std::size_t mostLarger) {
    RockLine line;
    const std::uint32_t leaf = leafAt(leaves, k);
    if (leaf == kOpen) return line;
    std::vector<std::uint32_t> firstCell(leaves.sums.size(), UINT32_MAX);
    for (std::uint32_t n = 0; n < leaves.leaf.size(); ++n) firstCell[leaves.leaf[n]] = std::min(firstCell[leaves.leaf[n]], n);
    std::vector<std::vector<std::uint32_t>> members(leaves.sums.size());
    for (std::uint32_t n = 1; n < members.size(); ++n) members[n] = {n};
    const auto cellsOf = [&](const std::vector<std::uint32_t>& group) {
        return std::accumulate(group.begin(), group.end(), 0U,
                               [&](std::uint32_t sum, std::uint32_t n) { return sum + leaves.sums[n].cells; });
    };
    std::uint32_t own = leaf;
    double made = kLeastZ;
    bool isLarger = false; // larger than the region
    RockEdit join{RockEditKind::Join, {k}};
    const auto add = [&](double until, RockEdit edit) {
        std::vector<std::uint32_t> sorted = members[own];
        std::ranges::sort(sorted);
        line.pieces.push_back({sorted, cellsOf(sorted), until - made, std::move(edit)});
    };
    const auto endRegion = [&](double until) {
        isLarger = true;
        line.region = line.pieces.size();
        add(until, {});
    };
    for (const Merge& merge : tree.merges) {
        if (merge.height > level && !isLarger && (merge.kept == own || merge.gone == own)) endRegion(merge.height);
        if (isLarger && line.pieces.size() > line.region + mostLarger) break;
        if (merge.kept == own || merge.gone == own) {
            const std::vector<std::uint32_t>& other = members[merge.kept == own ? merge.gone : merge.kept];
            const auto seen = std::ranges::find_if(other, [&](std::uint32_t n) { return firstCell[n] != UINT32_MAX; });
            if (seen != other.end() && merge.height >= kLeastZ && !isLarger) add(merge.height, {RockEditKind::Part, {k, firstCell[*seen]}});
            if (seen != other.end() && isLarger) join.cells.push_back(firstCell[*seen]);
            own = merge.kept;
            made = std::max(made, merge.height);
        }
        std::vector<std::uint32_t>& kept = members[merge.kept];
        kept.insert(kept.end(), members[merge.gone].begin(), members[merge.gone].end());
        members[merge.gone].clear();
        if (isLarger && merge.kept == own && join.cells.size() > line.pieces.size() - line.region) add(merge.height, join);
    }
    if (!isLarger) endRegion(made);
    return line;
}

std::size_t bestSplit(const RockLine& line) {
    std::size_t best = line.region;
    for (std::size_t n = 0; n < line.region; ++n) {
        if (line.pieces[n].cells >= kFewestSplit && (best == line.region || line.pieces[n].life > line.pieces[best].life)) best = n;
    }
    return best;
}

std::optional<RockEdit> splitAt(const RockLeaves& leaves, const MergeTree& tree, double level, std::uint32_t k) {
    const RockLine line = rockLine(leaves, tree, level, k, 0);
    const std::size_t best = bestSplit(line);
    return best == line.region ? std::nullopt : std::optional(line.pieces[best].part);
}

} // namespace edgescan
