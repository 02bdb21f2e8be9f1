// Collects the rocks of known scans, and fits the chance that one is right.
#include "core/lab/learning/learn_confidence.h"

#include "core/base/number_text.h"

#include <Eigen/Dense>

#include <algorithm>

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
    constexpr int kSteps = 30;
    constexpr double kRidge = 1e-3;
    constexpr Eigen::Index kSize = 1 + rocks::kConfidenceInputs;
    using Vector = Eigen::Matrix<double, kSize, 1>;
    using Matrix = Eigen::Matrix<double, kSize, kSize>;
    rocks::ConfidenceWeights weights{};
    for (int step = 0; step < kSteps; ++step) {
        Eigen::Map<Vector> now(weights.data());
        Vector slope = -kRidge * now;
        Matrix curvature = kRidge * Matrix::Identity();
        for (const ConfidenceLesson& sample : samples) {
            Vector x;
            x << 1.0, Eigen::Map<const Eigen::Matrix<double, kSize - 1, 1>>(sample.inputs.data());
            const double said = rocks::confidenceOf(sample.inputs, weights);
            slope += sample.weight * ((sample.right ? 1.0 : 0.0) - said) * x;
            curvature += sample.weight * std::max(said * (1.0 - said), 1e-6) * x * x.transpose();
        }
        now += curvature.ldlt().solve(slope);
    }
    return weights;
}

std::string confidenceWeightsText(const rocks::ConfidenceWeights& weights, const std::string& madeBy) {
    std::string text = "// Made by `" + madeBy + "`; do not edit.\n";
    for (const double weight : weights) text += (text.back() == '\n' ? "" : " ") + fixedText(weight, 3) + ",";
    return text + "\n";
}

} // namespace edgescan::lab
