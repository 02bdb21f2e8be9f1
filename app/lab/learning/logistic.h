// Logistic regression on few inputs, by Newton's method.
#pragma once

#include "core/base/portable_math.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace edgescan::lab {

template <std::size_t kInputs>
struct LogisticSample {
    std::array<double, kInputs> inputs{};
    bool right = false; ///< the answer is yes
    double weight = 1.0;
    double before = 0.0; ///< log odds to which the weights add
};

struct LogisticChoices {
    int steps = 30;
    double ridge = 1e-3;
    double leastVariance = 1e-6; ///< of one answer, so that a step stays finite
};

/// The constant, then one weight per input. The same samples give the same weights.
template <std::size_t kInputs>
[[nodiscard]] std::array<double, 1 + kInputs> fittedLogistic(const std::vector<LogisticSample<kInputs>>& samples,
                                                             const LogisticChoices& choices) {
    constexpr Eigen::Index kSize = 1 + static_cast<Eigen::Index>(kInputs);
    using Vector = Eigen::Matrix<double, kSize, 1>;
    using Matrix = Eigen::Matrix<double, kSize, kSize>;
    std::array<double, 1 + kInputs> weights{};
    Eigen::Map<Vector> now(weights.data());
    for (int step = 0; step < choices.steps; ++step) {
        Vector slope = -choices.ridge * now;
        Matrix curvature = choices.ridge * Matrix::Identity();
        for (const LogisticSample<kInputs>& sample : samples) {
            Vector x;
            x << 1.0, Eigen::Map<const Eigen::Matrix<double, kSize - 1, 1>>(sample.inputs.data());
            const double said = 1.0 / (1.0 + portable::exp(-now.dot(x) - sample.before));
            slope += sample.weight * ((sample.right ? 1.0 : 0.0) - said) * x;
            curvature += sample.weight * std::max(said * (1.0 - said), choices.leastVariance) * x * x.transpose();
        }
        now += curvature.ldlt().solve(slope);
    }
    return weights;
}

} // namespace edgescan::lab
