// Log odds in per cent, and the features that gave them.
#include "core/base/boosted_trees.h"

#include "core/base/portable_math.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

constexpr int kMostPercent = 100;

// By per cent p: the least log odds that round to p.
std::array<std::int32_t, kMostPercent + 1> leastLogOdds() {
    std::array<std::int32_t, kMostPercent + 1> least{};
    for (int p = 1; p <= kMostPercent; ++p) {
        const double share = (p - 0.5) / kMostPercent;
        least[static_cast<std::size_t>(p)] = static_cast<std::int32_t>(std::floor(portable::log(share / (1 - share)) * kLogOddsUnit));
    }
    return least;
}

} // namespace

int percentOf(std::int32_t logOdds) {
    static const std::array<std::int32_t, kMostPercent + 1> least = leastLogOdds();
    int percent = 0;
    for (int half = 64; half > 0; half /= 2) {
        if (percent + half <= kMostPercent && logOdds >= least[static_cast<std::size_t>(percent + half)]) percent += half;
    }
    return percent;
}

std::vector<std::int32_t> addedByFeature(std::span<const BoostedTree> trees, std::span<const float> features) {
    std::vector<std::int32_t> added(features.size());
    std::array<std::int32_t, BoostedTree::kQuestions + BoostedTree::kLeaves> worth{};
    for (const BoostedTree& tree : trees) {
        std::copy(tree.leaf.begin(), tree.leaf.end(), worth.begin() + BoostedTree::kQuestions);
        for (std::size_t n = BoostedTree::kQuestions; n-- > 0;) worth[n] = (worth[2 * n + 1] + worth[2 * n + 2]) / 2;
        for (std::size_t at = 0; at < BoostedTree::kQuestions;) {
            const std::size_t feature = tree.feature[at];
            const std::size_t next = 2 * at + 1 + static_cast<std::size_t>(features[feature] > tree.limit[at]);
            added[feature] += worth[next] - worth[at];
            at = next;
        }
    }
    return added;
}

} // namespace edgescan
