// Collects the rocks of known scans, and whether each is right.
#include "app/lab/learning/learn_confidence.h"

#include "core/rocks/selection/confidence.h"

namespace edgescan::lab {

void addConfidenceSamples(const RockLesson& lesson, const rocks::MergeTree& tree, float weight, TreeSamples& samples) {
    samples.features = rocks::kConfidenceInputs;
    const rocks::RegionMap map = rocks::rocksAt(lesson.segments, tree, {});
    const std::vector<rocks::ConfidenceInputs> inputs = rocks::confidenceInputs(map);
    std::vector<std::uint8_t> isRock;
    for (const rocks::Region& region : map.regions) isRock.push_back(rocks::looksLikeRock(region, map.settings) ? 1 : 0);
    const RockMatch match =
        matchRocks(overlapsOf(lesson.counts, lesson.rock, rocks::regionLabels(lesson.segments, map)), isRock, {.strict = true});
    for (const RockVerdict& rock : match.rocks) {
        if (rock.found) samples.add(inputs[rock.region], true, weight);
    }
    for (const std::uint32_t region : match.falseRegions) samples.add(inputs[region], false, weight);
}

} // namespace edgescan::lab
