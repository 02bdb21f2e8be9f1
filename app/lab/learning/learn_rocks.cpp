// Follows the merges of segments and asks the truth about each pair.
#include "app/lab/learning/learn_rocks.h"

#include "app/lab/sim/scene.h"
#include "core/edges/pipeline/pipeline.h"

#include <algorithm>
#include <map>

namespace edgescan::lab {
namespace {

constexpr double kLevel = 0.0;
constexpr double kBackgroundWeight = 0.3; // of a pair of pieces of the background: how they lie to each other hardly matters
constexpr double kFullCells = 40;         // of a body with the whole weight
constexpr std::size_t kRegionCells = 100;
constexpr double kMostly = 0.5;

/// Measured cells of a group by true rock.
class Content {
public:
    explicit Content(const RockLesson& lesson) : cells_(lesson.cells.size()) {
        for (std::size_t n = 0; n < cells_.size(); ++n) cells_[n] = {lesson.cells[n].begin(), lesson.cells[n].end()};
    }
    void merge(std::uint32_t remaining, std::uint32_t gone) {
        for (const auto& [rock, count] : cells_[gone]) cells_[remaining][rock] += count;
        cells_[gone].clear();
    }
    struct Mostly {
        std::uint32_t rock = 0, cells = 0, all = 0;
        [[nodiscard]] double purity() const { return all == 0 ? 0.0 : static_cast<double>(cells) / all; }
    };
    [[nodiscard]] Mostly of(std::uint32_t group) const {
        Mostly most;
        for (const auto& [rock, count] : cells_[group]) {
            most.all += count;
            if (count > most.cells) most.rock = rock, most.cells = count;
        }
        return most;
    }

private:
    std::vector<std::map<std::uint32_t, std::uint32_t>> cells_;
};

double priceOf(const rocks::PairFeatures& features, const LearntTrees* trees) {
    return trees == nullptr ? static_cast<double>(features[0]) : static_cast<double>(trees->logOddsOf(features.data())) / kLogOddsUnit;
}

} // namespace

RockLesson rockLesson(const std::shared_ptr<const Scan>& scan, const Grid<std::uint16_t>& object) {
    RockLesson lesson{rocks::segmentRocks(rocks::rockInputs(*edges::detectEdges(scan, edges::Settings{}, edges::KeepFor::Rocks))),
                      Grid<std::uint8_t>(object.lines, object.beams),
                      Grid<std::uint32_t>(object.lines, object.beams),
                      {}};
    std::vector<std::map<std::uint32_t, std::uint32_t>> cells(lesson.segments.sums.size());
    for (std::size_t k = 0; k < object.size(); ++k) {
        lesson.rock[k] = object[k] >= sim::kFirstRock ? object[k] - sim::kFirstRock + 1U : 0U;
        if (lesson.segments.inputs.surface->inverse.support[k] != Support::Measured) continue;
        lesson.counts[k] = 1;
        ++cells[lesson.segments.segment[k]][lesson.rock[k]];
    }
    for (const auto& each : cells) lesson.cells.emplace_back(each.begin(), each.end());
    return lesson;
}

rocks::MergeTree treeBy(const RockLesson& lesson, const LearntTrees* trees) {
    const rocks::MergeRules rules{
        [&](const rocks::PairFeatures& features, std::uint32_t, std::uint32_t) { return priceOf(features, trees); }};
    return rocks::mergeTree(lesson.segments, rules);
}

void addPairSamples(const RockLesson& lesson, const LearntTrees* trees, double share, TreeSamples& samples) {
    samples.features = rocks::kPairFeatures;
    Content content(lesson);
    double owed = 0;
    rocks::MergeRules rules;
    rules.price = [&](const rocks::PairFeatures& features, std::uint32_t a, std::uint32_t b) {
        owed += share;
        const Content::Mostly one = content.of(a), other = content.of(b);
        if (owed >= 1 && one.all > 0 && other.all > 0) {
            owed -= 1;
            const double pure = std::min(one.purity(), other.purity()) * std::min(1.0, std::min(one.all, other.all) / kFullCells);
            const bool background = one.rock == 0 && other.rock == 0;
            samples.add(features, one.rock != other.rock, static_cast<float>(pure * (background ? kBackgroundWeight : 1.0)));
        }
        return priceOf(features, trees);
    };
    rules.merged = [&](const rocks::Merge& merge) { content.merge(merge.remaining, merge.gone); };
    static_cast<void>(rocks::mergeTree(lesson.segments, rules));
}

void addRegionSamples(const RockLesson& lesson, const rocks::MergeTree& tree, double weight, std::vector<RegionSample>& samples) {
    const rocks::RegionMap map = rocks::rocksAt(lesson.segments, tree, {});
    const Overlaps overlaps = overlapsOf(lesson.counts, lesson.rock, rocks::regionLabels(lesson.segments, map));
    std::vector<std::uint8_t> isRock(map.regions.size()), isWall(map.regions.size());
    for (const Overlaps::Shared& shared : overlaps.shared) {
        if (shared.region == 0) continue;
        if (shared.rock == 0)
            isWall[shared.region] = static_cast<double>(shared.cells) > kMostly * static_cast<double>(overlaps.regionCells[shared.region]);
        else if (overlaps.iou(shared) > kMostly)
            isRock[shared.region] = 1;
    }
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        if (map.regions[n].sums.cells < kRegionCells || isRock[n] == isWall[n]) continue;
        samples.push_back({rocks::scoreInputs(map.regions[n], map.settings), isRock[n] != 0, weight});
    }
}

std::array<double, 1 + rocks::kScoreInputs> fittedScore(const std::vector<RegionSample>& samples) {
    return fittedLogistic(samples, {.steps = 60, .ridge = 0.01, .leastVariance = 1e-4});
}

RockCounts scoreByTruth(const RockLesson& lesson, const rocks::MergeTree& tree, double level) {
    const std::vector<std::uint32_t> group = rocks::groupsAt(tree, lesson.segments.count(), level);
    Content content(lesson);
    for (std::uint32_t n = 1; n < group.size(); ++n) {
        if (group[n] != n) content.merge(group[n], n);
    }
    std::vector<std::uint8_t> isRock(group.size());
    for (std::uint32_t n = 1; n < group.size(); ++n) isRock[n] = content.of(n).rock != 0 ? 1 : 0;
    Grid<std::uint32_t> region = lesson.segments.segment;
    for (std::size_t k = 0; k < region.size(); ++k) region[k] = group[region[k]];
    return matchRocks(overlapsOf(lesson.counts, lesson.rock, region), isRock, {.strict = true}).counts;
}

RockCounts scoreAsSet(const RockLesson& lesson, const rocks::MergeTree& tree) {
    const rocks::RegionMap map = rocks::rocksAt(lesson.segments, tree, {});
    std::vector<std::uint8_t> isRock;
    for (const rocks::Region& region : map.regions) isRock.push_back(region.kind == rocks::RegionKind::Rock ? 1 : 0);
    return matchRocks(overlapsOf(lesson.counts, lesson.rock, rocks::regionLabels(lesson.segments, map)), isRock, {.strict = true}).counts;
}

} // namespace edgescan::lab
