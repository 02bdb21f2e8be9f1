// A region alone says too little: on a wall without rocks, what looks like a rock is background. So the other regions count, too.
#include "core/rocks/selection/confidence.h"

#include "core/base/boosted_trees.h"
#include "core/base/portable_math.h"

#include <algorithm>

namespace edgescan::rocks {
namespace {

#include "core/rocks/selection/confidence_trees.inc" // kStart, kTrees and kBase

constexpr double kLeastScore = -6.0;
constexpr double kMostScore = 12.0;

// By its own E and R alone, fitted on scans that are full of rocks.
constexpr double kOwnOffset = -1.39;
constexpr double kOwnPerEvidence = 0.19;
constexpr double kOwnPerScore = 1.0;

double chance(double logOdds) { return 1.0 / (1.0 + portable::exp(-logOdds)); }

double clippedScore(const Region& region) { return std::clamp(region.score, kLeastScore, kMostScore); }

/// Log odds of the mean over all rocks, within 0 and 2; 0 without rocks.
double ofAllRocks(const RegionMap& map) {
    constexpr double kMostChance = 0.8808; // log odds of 2
    double sum = 0.0;
    double rocks = 0.0;
    for (const Region& region : map.regions) {
        if (!looksLikeRock(region, map.settings)) continue;
        sum += chance(kOwnOffset + kOwnPerEvidence * region.evidence + kOwnPerScore * clippedScore(region));
        rocks += 1.0;
    }
    if (rocks == 0.0) return 0.0;
    const double mean = std::clamp(sum / rocks, 0.5, kMostChance);
    return portable::log(mean / (1.0 - mean));
}

} // namespace

std::vector<ConfidenceInputs> confidenceInputs(const RegionMap& map) {
    const double all = ofAllRocks(map);
    std::vector<double> around(map.regions.size());
    for (const RegionBorder& border : map.borders) {
        around[border.a] += border.cracks * clippedScore(map.regions[border.b]);
        around[border.b] += border.cracks * clippedScore(map.regions[border.a]);
    }
    std::vector<ConfidenceInputs> inputs(map.regions.size());
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        const Region& region = map.regions[n];
        const double rangeM = (region.sums.sumM / std::max(1.0, static_cast<double>(region.sums.cells))).norm();
        const std::array<double, kConfidenceInputs> numbers{region.nearShare,
                                                            clippedScore(region),
                                                            around[n] / std::max(1.0, static_cast<double>(region.outlineCracks)),
                                                            region.levelsBelow,
                                                            region.levelsAbove,
                                                            region.evidence,
                                                            region.bulge,
                                                            region.edgeShare,
                                                            region.depthRatio,
                                                            region.boxShare,
                                                            static_cast<double>(region.sweepSides),
                                                            rangeM > 0 ? region.sums.areaM2 / (rangeM * rangeM) : 0.0,
                                                            all};
        std::ranges::transform(numbers, inputs[n].begin(), [](double number) { return static_cast<float>(number); });
    }
    return inputs;
}

double baseOdds(const std::array<double, kConfidenceBase>& base, const float* inputs) {
    double odds = base[0];
    for (std::size_t n = 0; n < kConfidenceBaseInputs.size(); ++n)
        odds += base[n + 1] * static_cast<double>(inputs[kConfidenceBaseInputs[n]]);
    return odds;
}

double confidenceOf(const ConfidenceInputs& inputs) {
    return chance(baseOdds(kBase, inputs.data()) + static_cast<double>(logOdds(kTrees, kStart, inputs.data())) / kLogOddsUnit);
}

} // namespace edgescan::rocks
