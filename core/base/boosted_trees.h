// Boosted trees of decisions: the sum of their leaves is the logarithm of the odds, in fixed point, so that every machine gives the same.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

inline constexpr std::int32_t kLogOddsUnit = 4096; ///< log odds are stored as multiples of 1 / kLogOddsUnit

/// A tree in which every way has four questions. Question n leads to question 2n + 1 if the feature is at most the limit, and to 2n + 2
/// otherwise; the last ones lead to the leaves in this order.
struct BoostedTree {
    static constexpr int kDepth = 4;
    static constexpr std::size_t kQuestions = (1U << kDepth) - 1, kLeaves = 1U << kDepth;

    std::array<std::uint8_t, kQuestions> feature{};
    std::array<float, kQuestions> limit{};
    std::array<std::int32_t, kLeaves> leaf{}; ///< log odds
};

/// The log odds that trees give `features`: `start` and a leaf of each tree.
[[nodiscard]] inline std::int32_t logOdds(std::span<const BoostedTree> trees, std::int32_t start, const float* features) {
    for (const BoostedTree& tree : trees) {
        std::size_t at = 0;
        for (int step = 0; step < BoostedTree::kDepth; ++step)
            at = 2 * at + 1 + static_cast<std::size_t>(features[tree.feature[at]] > tree.limit[at]);
        start += tree.leaf[at - BoostedTree::kQuestions];
    }
    return start;
}

/// Log odds as a probability in per cent, rounded, 0 to 100.
[[nodiscard]] int percentOf(std::int32_t logOdds);

/// What the answer to each feature's questions added to the log odds, as many as `features`. A question is worth the mean of the leaves
/// below it.
[[nodiscard]] std::vector<std::int32_t> addedByFeature(std::span<const BoostedTree> trees, std::span<const float> features);

} // namespace edgescan
