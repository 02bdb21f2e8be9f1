// Collects the rocks of simulated scans, and fits the chance that one is right.
#include "core/lab/learning/learn_confidence.h"

#include "core/base/number_text.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/lab/score/rock_evaluation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <memory>

namespace edgescan::lab {

Result<Done> addConfidenceSamples(const sim::Simulation& simulation, std::vector<ConfidenceLesson>& samples) {
    const auto scan = std::make_shared<const Scan>(simulation.scan);
    const Result<RockScene> scene = rockScene(*scan, trueRocksOf(simulation), scan->name);
    if (!scene) return scene.error();
    const rocks::Segmentation segments =
        rocks::segmentRocks(rocks::rockInputs(*edges::detectEdges(scan, edges::Settings{}, edges::KeepFor::Rocks)));
    const rocks::RegionMap map = rocks::rocksAt(segments, rocks::mergeTree(segments.count(), segments.borders), {});
    const std::vector<rocks::ConfidenceInputs> inputs = rocks::confidenceInputs(map);
    std::vector<std::uint8_t> isRock;
    for (const rocks::Region& region : map.regions) isRock.push_back(rocks::looksLikeRock(region, map.settings) ? 1 : 0);
    const RockMatch match =
        matchRocks(overlapsOf(scene->counts, scene->truth.rock, rocks::regionLabels(segments, map)), isRock, {.strict = true});
    for (const RockVerdict& rock : match.rocks) {
        if (rock.found) samples.push_back({inputs[rock.region], true});
    }
    for (const std::uint32_t region : match.falseRegions) samples.push_back({inputs[region], false});
    return Done{};
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
            slope += ((sample.right ? 1.0 : 0.0) - said) * x;
            curvature += std::max(said * (1.0 - said), 1e-6) * x * x.transpose();
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
