// Collects the rocks of known scans, and fits the chance that one is right.
#include "app/lab/learning/learn_confidence.h"

#include "core/base/number_text.h"

namespace edgescan::lab {

void addConfidenceSamples(const RockLesson& lesson, const rocks::MergeTree& tree, double weight, std::vector<ConfidenceLesson>& samples) {
    const rocks::RegionMap map = rocks::rocksAt(lesson.segments, tree, {});
    const std::vector<rocks::ConfidenceInputs> inputs = rocks::confidenceInputs(map);
    std::vector<std::uint8_t> isRock;
    for (const rocks::Region& region : map.regions) isRock.push_back(rocks::looksLikeRock(region, map.settings) ? 1 : 0);
    const RockMatch match =
        matchRocks(overlapsOf(lesson.counts, lesson.rock, rocks::regionLabels(lesson.segments, map)), isRock, {.strict = true});
    for (const RockVerdict& rock : match.rocks) {
        if (rock.found) samples.push_back({inputs[rock.region], true, weight});
    }
    for (const std::uint32_t region : match.falseRegions) samples.push_back({inputs[region], false, weight});
}

rocks::ConfidenceWeights fittedConfidence(const std::vector<ConfidenceLesson>& samples) {
    return fittedLogistic(samples, {.steps = 30, .ridge = 1e-3, .leastVariance = 1e-6});
}

std::string confidenceWeightsText(const rocks::ConfidenceWeights& weights, const std::string& madeBy) {
    std::string text = "// Made by `" + madeBy + "`; do not edit.\n";
    for (const double weight : weights) text += (text.back() == '\n' ? "" : " ") + fixedText(weight, 3) + ",";
    return text + "\n";
}

} // namespace edgescan::lab
