// Collects the rocks of known scans, and whether each is right.
#include "app/lab/learning/learn_confidence.h"

#include "app/lab/learning/logistic.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

constexpr int kDecimals = 4; // of the base

void setBefore(TreeSamples& samples, const std::array<double, rocks::kConfidenceBase>& base) {
    samples.before.resize(samples.count());
    for (std::size_t n = 0; n < samples.count(); ++n)
        samples.before[n] = static_cast<std::int32_t>(std::lround(rocks::baseOdds(base, samples.of(n)) * kLogOddsUnit));
}

// The weight of the rocks of the scan is chosen: a fitted one (4.4) makes rocks of full grids doubtful, too.
std::array<double, rocks::kConfidenceBase> fittedBase(const TreeSamples& samples) {
    constexpr double kOfScan = 2.5, kUsual = 2.0;      // per log odds, and what they are in a scan of rocks
    const auto& inputs = rocks::kConfidenceBaseInputs; // the last one is that of the scan
    std::vector<LogisticSample<rocks::kConfidenceBase - 2>> answers(samples.count());
    for (std::size_t n = 0; n < samples.count(); ++n) {
        const auto input = [&](std::size_t which) { return static_cast<double>(samples.of(n)[which]); };
        std::transform(inputs.begin(), inputs.end() - 1, answers[n].inputs.begin(), input);
        answers[n].before = kOfScan * (input(inputs.back()) - kUsual);
        answers[n].right = samples.yes[n] != 0;
        answers[n].weight = static_cast<double>(samples.weight[n]);
    }
    const auto fitted = fittedLogistic(answers, {});
    std::array<double, rocks::kConfidenceBase> base{};
    const double unit = std::pow(10.0, kDecimals);
    std::ranges::transform(fitted, base.begin(), [unit](double weight) { return std::round(weight * unit) / unit; });
    base.front() -= kOfScan * kUsual;
    base.back() = kOfScan;
    return base;
}

} // namespace

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

LearntConfidence learntConfidence(TreeSamples samples, BoostingChoices choices, int threads) {
    LearntConfidence learnt{fittedBase(samples), {}};
    setBefore(samples, learnt.base);
    choices.features = rocks::kConfidenceInputs - 1; // what says of which scan a region is must not decide by limits
    learnt.trees = learntTrees(samples, choices, threads);
    return learnt;
}

AnswerQuality qualityOf(TreeSamples samples, const LearntConfidence& learnt) {
    setBefore(samples, learnt.base);
    return qualityOf(samples, learnt.trees);
}

std::string confidenceText(const LearntConfidence& learnt, const std::string& madeBy) {
    std::string base;
    for (const double weight : learnt.base) base += (base.empty() ? "" : ", ") + fixedText(weight, kDecimals);
    return treesText(learnt.trees, madeBy) + "constexpr std::array<double, kConfidenceBase> kBase{" + base + "};\n";
}

} // namespace edgescan::lab
