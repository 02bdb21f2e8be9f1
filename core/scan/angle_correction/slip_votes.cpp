// Weighted medians.
#include "core/scan/angle_correction/slip_votes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace edgescan {

bool measuredAround(const InverseRange& inverse, int line, int beam) {
    for (int i = line - 1; i <= line + 1; ++i) {
        for (int j = beam - 1; j <= beam + 1; ++j) {
            if (!inverse.isMeasured(i, j)) return false;
        }
    }
    return true;
}

float explainedShare(const std::vector<SlipVote>& slips, float steps) {
    double with = 0;
    double without = 0;
    for (const SlipVote& slip : slips) {
        with += static_cast<double>(std::abs((slip.steps - steps) * slip.slant));
        without += static_cast<double>(std::abs(slip.steps * slip.slant));
    }
    return without > 0 ? static_cast<float>(1 - with / without) : 0.0F;
}

bool isMedianWithin(float limit, const std::vector<SlipVote>& slips) {
    double total = 0;
    double below = 0;
    double upTo = 0;
    for (const SlipVote& slip : slips) {
        const auto weight = static_cast<double>(slip.weight);
        total += weight;
        below += slip.steps <= -limit ? weight : 0.0;
        upTo += slip.steps < limit ? weight : 0.0;
    }
    return 2 * below < total && 2 * upTo >= total;
}

// Sums of numbers with so few bits are exact in double, so their order does not matter.
float weightedMedian(std::vector<SlipVote> slips) {
    const auto add = [](double sum, const SlipVote& slip) { return sum + static_cast<double>(slip.weight); };
    const double total = std::accumulate(slips.begin(), slips.end(), 0.0, add);
    double below = 0;
    auto first = slips.begin();
    auto end = slips.end();
    while (first != end) {
        const auto middle = first + (end - first) / 2;
        std::nth_element(first, middle, end, [](const SlipVote& a, const SlipVote& b) { return a.steps < b.steps; });
        const double before = std::accumulate(first, middle, below, add);
        const double upTo = add(before, *middle);
        if (2 * before >= total) {
            end = middle;
        } else if (2 * upTo >= total) {
            return middle->steps;
        } else {
            below = upTo;
            first = middle + 1;
        }
    }
    return 0;
}

float spreadAround(float value, std::vector<SlipVote> slips) {
    for (SlipVote& slip : slips) slip.steps = std::abs(slip.steps - value);
    return weightedMedian(std::move(slips));
}

} // namespace edgescan
