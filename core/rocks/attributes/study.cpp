// Runs the stages of rock detection, and skips those whose inputs are unchanged.
#include "core/rocks/attributes/study.h"

#include "core/rocks/attributes/attributes.h"
#include "core/rocks/attributes/cells.h"
#include "core/rocks/selection/edits.h"
#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace edgescan::rocks {
namespace {

/// The measured cells of a part, and its outline: those with a neighbour of another part.
struct Part {
    std::vector<std::uint32_t> cells, rim;
};

/// Labels of the rocks with two or more segments that one join names.
std::vector<std::uint8_t> joinedRocks(const Segmentation& segments, const RegionMap& map, std::span<const Edit> edits) {
    std::vector<std::uint8_t> joined(map.regions.size(), 0);
    for (const SegmentPair& pair : pairsOf(segments, edits)) {
        const std::uint32_t region = map.regionOfSegment[pair.a];
        if (pair.joined && region <= map.rocks && region == map.regionOfSegment[pair.b]) joined[region] = 1;
    }
    joined[0] = 0;
    return joined;
}

class PartDistances {
public:
    PartDistances(const Segmentation& segments, std::vector<std::uint32_t> partOfSegment)
        : segments_(segments), partOfSegment_(std::move(partOfSegment)), points_(*segments.inputs.scan) {}

    /// The distances larger than `touchingM`, along the shortest connections of all parts.
    [[nodiscard]] std::vector<PartDistance> between(std::span<const std::uint32_t> cells, double touchingM) const {
        const std::vector<Part> parts = partsOf(cells);
        std::vector<PartDistance> apart, nearest; // nearest: by part that is not connected yet, to those that are
        std::vector<std::size_t> left;
        for (std::size_t n = 1; n < parts.size(); ++n) {
            left.push_back(n);
            nearest.push_back(distanceOf(parts.front(), parts[n]));
        }
        while (!left.empty()) {
            const auto next = std::ranges::min_element(nearest, {}, &PartDistance::distanceM);
            const std::size_t part = left[static_cast<std::size_t>(next - nearest.begin())];
            if (next->distanceM > touchingM) apart.push_back(*next);
            left.erase(left.begin() + (next - nearest.begin()));
            nearest.erase(next);
            for (std::size_t n = 0; n < left.size(); ++n) {
                const PartDistance other = distanceOf(parts[part], parts[left[n]]);
                if (other.distanceM < nearest[n].distanceM) nearest[n] = other;
            }
        }
        return apart;
    }

private:
    [[nodiscard]] std::uint32_t partAt(std::uint32_t k) const { return partOfSegment_[segments_.segment[k]]; }

    [[nodiscard]] bool onRim(std::uint32_t k) const {
        constexpr std::array<std::array<int, 2>, 4> kSides{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
        const Grid<std::uint32_t>& grid = segments_.segment;
        const int line = static_cast<int>(k) / grid.beams, beam = static_cast<int>(k) % grid.beams;
        return std::ranges::any_of(kSides, [&](const auto& side) {
            const int i = line + side[0], j = beam + side[1];
            return !grid.contains(i, j) || partAt(static_cast<std::uint32_t>(grid.index(i, j))) != partAt(k);
        });
    }

    [[nodiscard]] std::vector<Part> partsOf(std::span<const std::uint32_t> cells) const {
        std::map<std::uint32_t, Part> parts;
        for (const std::uint32_t k : cells) {
            Part& part = parts[partAt(k)];
            part.cells.push_back(k);
            if (onRim(k)) part.rim.push_back(k);
        }
        std::vector<Part> all;
        for (auto& [name, part] : parts) all.push_back(std::move(part));
        return all;
    }

    [[nodiscard]] PartDistance nearestTo(std::uint32_t from, std::span<const std::uint32_t> cells) const {
        const Eigen::Vector3d here = points_.point(from);
        PartDistance best{from, from, std::numeric_limits<double>::infinity()};
        for (const std::uint32_t k : cells) {
            const double squared = (points_.point(k) - here).squaredNorm();
            if (squared < best.distanceM) best = {from, k, squared};
        }
        best.distanceM = std::sqrt(best.distanceM);
        return best;
    }

    /// The nearest cells of both outlines, then of all cells for as long as a nearer one is found.
    [[nodiscard]] PartDistance distanceOf(const Part& a, const Part& b) const {
        PartDistance best{a.cells.front(), b.cells.front(), std::numeric_limits<double>::infinity()};
        for (const std::uint32_t k : a.rim) {
            const PartDistance one = nearestTo(k, b.rim);
            if (one.distanceM < best.distanceM) best = one;
        }
        for (bool nearer = true; nearer;) {
            const PartDistance there = nearestTo(best.a, b.cells);
            const PartDistance back = nearestTo(there.b, a.cells);
            nearer = back.distanceM < best.distanceM;
            if (nearer) best = {back.b, back.a, back.distanceM};
        }
        return best;
    }

    const Segmentation& segments_;
    std::vector<std::uint32_t> partOfSegment_;
    CartesianTables points_;
};

/// Fills Rock::apart of the rocks that joins of `edits` made of several parts. The parts are the regions at the level of the map without
/// the joins. Two parts touch if the distance of their nearest cells is within Rock::toleranceM.
void addPartDistances(const Segmentation& segments, const MergeTree& tree, const RegionMap& map, std::span<const Edit> edits,
                      std::vector<Rock>& rocks) {
    std::vector<Edit> joins, others;
    for (const Edit& edit : edits) (edit.kind == EditKind::Join ? joins : others).push_back(edit);
    const std::vector<std::uint8_t> joined = joinedRocks(segments, map, joins);
    if (std::ranges::find(joined, 1) == joined.end()) return;
    const MergeTree apart = withPairs(tree, segments, pairsOf(segments, others));
    const PartDistances finder(segments, groupsAt(apart, segments.count(), map.settings.level));
    const CellsByRock cells = cellsByRock(segments, map, [&](std::uint32_t label) { return joined[label] == 0; });
    for (Rock& rock : rocks) {
        if (joined[rock.label] != 0 && rock.cells > 0) rock.apart = finder.between(cells.of(rock.label), rock.toleranceM);
    }
}

bool sameInputs(const Inputs& a, const Inputs& b) { return a.cracks == b.cracks && a.responses == b.responses && a.scan == b.scan; }

// Edits change the tree of the uncut segments; that is made once.
std::shared_ptr<const MergeTree> treeOf(const Study& study, const std::vector<Edit>& edits, const Study* before) {
    const auto tree = before != nullptr ? before->tree : std::make_shared<const MergeTree>(mergeTree(*study.uncut));
    if (edits.empty() && !tree->plain) return tree;
    return std::make_shared<const MergeTree>(withPairs(*tree, *study.segmentation, pairsOf(*study.segmentation, edits)));
}

} // namespace

double Rock::apartM() const { return apart.empty() ? 0.0 : std::ranges::max(apart, {}, &PartDistance::distanceM).distanceM; }

std::vector<const Rock*> rocksToList(const Study& study) {
    std::vector<const Rock*> rocks;
    if (!study.listed) {
        for (const Rock& rock : study.rocks) rocks.push_back(&rock);
        return rocks;
    }
    for (const std::uint32_t label : *study.listed) {
        if (const Rock* rock = rockOf(study.rocks, label)) rocks.push_back(rock);
    }
    return rocks;
}

Study studyRocks(const Inputs& inputs, const RockSettings& settings, const std::vector<Edit>& edits, const Study* before) {
    Study study;
    study.settings = settings;
    study.edits = edits;
    if (before != nullptr && !sameInputs(before->segmentation->inputs, inputs)) before = nullptr;
    if (before != nullptr && before->settings == settings && before->edits == edits) {
        study = *before;
        study.listed.reset();
        return study;
    }
    const std::vector<CutLine> cuts = cutsOf(edits);
    const bool sameSegments = before != nullptr && cutsOf(before->edits) == cuts;
    study.uncut = before != nullptr ? before->uncut : std::make_shared<const Segmentation>(segmentRocks(inputs));
    study.segmentation = sameSegments   ? before->segmentation
                         : cuts.empty() ? study.uncut
                                        : std::make_shared<const Segmentation>(segmentRocks(inputs, cuts));
    const Segmentation& segments = *study.segmentation;
    study.tree = sameSegments && before->edits == edits ? before->tree : treeOf(study, edits, before);
    if (edits.empty()) {
        study.map = rocksAt(segments, *study.tree, settings);
    } else {
        const RegionMap plain = rocksAt(*study.uncut, {*study.tree->plain}, settings);
        study.map = rocksAt(segments, *study.tree, settings, rockCallsOf(segments, edits), &plain);
        study.map = withKeptNumbers(std::move(study.map), segments, plain, *study.uncut, edits);
    }
    const std::optional<EarlierRows> rows = sameSegments ? std::optional(EarlierRows{before->map, before->rocks}) : std::nullopt;
    study.rocks = rockRows(segments, study.map, rows ? &*rows : nullptr);
    addLikelyJoins(*study.tree, study.map, study.rocks);
    addPartDistances(segments, *study.tree, study.map, edits, study.rocks);
    return study;
}

} // namespace edgescan::rocks
