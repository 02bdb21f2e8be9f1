// Fits the confidence of rocks on simulated scans (docs/method/rocks.md, "Confidence").
#pragma once

#include "core/base/result.h"
#include "core/rocks/selection/confidence.h"
#include "core/sim/simulate.h"

#include <string>
#include <vector>

namespace edgescan::lab {

struct ConfidenceLesson {
    rocks::ConfidenceInputs inputs{};
    bool right = false; ///< the region is a rock to an IoU above one half
};

/// Adds every region that is called a rock and is either found or false. `simulation`: with its truth.
Result<Done> addConfidenceSamples(const sim::Simulation& simulation, std::vector<ConfidenceLesson>& samples);

/// Logistic regression. The same samples give the same weights.
[[nodiscard]] rocks::ConfidenceWeights fittedConfidence(const std::vector<ConfidenceLesson>& samples);

/// The text of core/rocks/selection/confidence_weights.inc.
[[nodiscard]] std::string confidenceWeightsText(const rocks::ConfidenceWeights& weights, const std::string& madeBy);

} // namespace edgescan::lab
