// Finds stalls and leaps of the stepper.
#include "core/scan/angle_correction/line_slips.h"

#include "core/base/bands.h"
#include "core/base/order_statistic.h"
#include "core/base/simd.h"
#include "core/scan/angle_correction/slip_votes.h"
#include "core/scan/angle_correction/step_unevenness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <type_traits>

namespace edgescan {
namespace {

constexpr int kFarthest = 8; // lines to each side from which the slope is measured
constexpr int kNearest = 3;
constexpr float kAlike = 0.4F;      // largest difference between slopes, as a share of the steeper one
constexpr float kLeastExtra = 0.5F; // index steps, in the first pass
constexpr float kSureExtra = 0.7F;
constexpr float kMostExtra = 20;   // index steps; a larger displacement is an edge
constexpr float kExplained = 0.5F; // share of the deviations on a line that a slip must explain
constexpr int kPause = 3;          // number of lines without a slip that ends a stall
constexpr float kMadeUp = 1.0F;    // index steps from the stepper's intended position

// The number of lines on each side from which the slope at the step from `line` to the next is measured; fewer at both ends of the sweep.
int reachAt(int line, int lines) { return std::min({kFarthest, line, lines - 2 - line}); }

// The slant at the step to the next line, from the lines before and after it. The steeper of the two slopes counts, because the stepper may
// have stalled on one side.
EDGESCAN_INLINE void slantsRoundStep(const float* u, std::ptrdiff_t stride, int reach, int beams, float* __restrict slants,
                                     std::uint8_t* __restrict slanted) {
    const std::ptrdiff_t far = reach * stride;
    const auto steps = static_cast<float>(reach);
    for (int j = 0; j < beams; ++j) {
        const float before = (u[j] - u[j - far]) / steps;
        const float after = (u[j + stride + far] - u[j + stride]) / steps;
        const float slant = std::abs(before) > std::abs(after) ? before : after;
        const float smaller = std::min(std::abs(before), std::abs(after));
        const float share = std::abs(slant) / u[j];
        slants[j] = slant;
        slanted[j] = static_cast<std::uint8_t>((share >= kLeastSlant) & (share <= kMostSlant) & (before * after > 0) &
                                               (smaller >= kAlike * std::abs(slant)));
    }
}

// Sums the votes of a line quickly: cells whose distance is a multiple of the number of lanes share a sum, so each lane holds beams of one
// parity.
constexpr int kVoteLanes = 64;
struct QuickVotes {
    std::array<float, kVoteLanes> weight{}, below{}, upTo{};
};

// For kFarthest lines the division becomes a multiplication, with the same bits.
template <bool kFar, class Count>
EDGESCAN_INLINE void addQuickly(const float* u, const Support* support, std::ptrdiff_t stride, int reach, Count cells, float limit,
                                float* __restrict weights, float* __restrict below, float* __restrict upTo) {
    static_assert(kFarthest == 8);
    const std::ptrdiff_t far = reach * stride;
    const auto steps = static_cast<float>(reach);
    constexpr float kShare = 1.0F / kFarthest;
    for (int j = 0; j < cells; ++j) {
        const float changeBefore = u[j] - u[j - far];
        const float changeAfter = u[j + stride + far] - u[j + stride];
        const float before = kFar ? changeBefore * kShare : changeBefore / steps;
        const float after = kFar ? changeAfter * kShare : changeAfter / steps;
        const float slant = std::abs(before) > std::abs(after) ? before : after;
        const float smaller = std::min(std::abs(before), std::abs(after));
        const float share = std::abs(slant) / u[j];
        const bool slanted = (share >= kLeastSlant) & (share <= kMostSlant) & (before * after > 0) & (smaller >= kAlike * std::abs(slant));
        const bool measured = (support[j - far] == Support::Measured) & (support[j] == Support::Measured) &
                              (support[j + stride] == Support::Measured) & (support[j + stride + far] == Support::Measured);
        const float extra = (u[j + stride] - u[j]) / slant - 1;
        const float weight = slanted & measured ? share : 0.0F;
        weights[j] += weight;
        below[j] += extra <= -limit ? weight : 0.0F;
        upTo[j] += extra < limit ? weight : 0.0F;
    }
}

EDGESCAN_INLINE void voteQuickly(const float* u, const Support* support, std::ptrdiff_t stride, int reach, int beams, float limit,
                                 QuickVotes& votes) {
    float *const weight = votes.weight.data(), *const below = votes.below.data(), *const upTo = votes.upTo.data();
    constexpr auto kAll = std::integral_constant<int, kVoteLanes>();
    int j = 0;
    if (reach == kFarthest) {
        for (; j + kVoteLanes <= beams; j += kVoteLanes)
            addQuickly<true>(u + j, support + j, stride, kFarthest, kAll, limit, weight, below, upTo);
    }
    for (; j < beams; j += kVoteLanes)
        addQuickly<false>(u + j, support + j, stride, reach, std::min(beams - j, kVoteLanes), limit, weight, below, upTo);
}

// Whether the weighted median of both parities is so far within the limit that rounding errors of the quick sums cannot matter. This is so
// on most lines, and then the votes need no second pass.
bool isSurelyNoSlip(const InverseRange& inverse, int line, int reach, float limit) {
    constexpr float kClear = 0.01F; // share of the weight; the sums are exact to a ten-thousandth
    QuickVotes votes;
    vectorised<voteQuickly>(inverse.u.line(line), inverse.support.line(line), inverse.u.beams, reach, inverse.u.beams, limit, votes);
    for (std::size_t parity = 0; parity < 2; ++parity) {
        float weight = 0, below = 0, upTo = 0;
        for (std::size_t lane = parity; lane < kVoteLanes; lane += 2) {
            weight += votes.weight[lane];
            below += votes.below[lane];
            upTo += votes.upTo[lane];
        }
        if (weight > 0 && (2 * below > (1 - kClear) * weight || 2 * upTo < (1 + kClear) * weight)) return false;
    }
    return true;
}

// Shares of u between kLeastSlant and kMostSlant are whole multiples of this value. As whole numbers they give the same sum in any order.
constexpr float kUnitOfWeight = 0x1p-31F;
static_assert(kLeastSlant >= 0x1p-8F && kMostSlant < 1);

// The votes of a line, as weights for the weighted median.
struct StepVotes {
    explicit StepVotes(int beams)
        : weight(static_cast<std::size_t>(beams)), below(static_cast<std::size_t>(beams)), upTo(static_cast<std::size_t>(beams)) {}
    std::vector<std::int32_t> weight; // in units of kUnitOfWeight; 0 if the cell has no vote
    std::vector<std::int32_t> below;  // weight of votes for a step of -limit or less ...
    std::vector<std::int32_t> upTo;   // ... and of votes for less than limit
};

EDGESCAN_INLINE void weigh(const float* u, const Support* support, const LineSlants& slants, std::ptrdiff_t stride, int reach, float limit,
                           StepVotes& votes) {
    const std::ptrdiff_t far = reach * stride;
    const auto beams = static_cast<std::ptrdiff_t>(votes.weight.size());
    const float* slant = slants.slant.data();
    const std::uint8_t* slanted = slants.slanted.data();
    std::int32_t* __restrict weights = votes.weight.data();
    std::int32_t* __restrict below = votes.below.data();
    std::int32_t* __restrict upTo = votes.upTo.data();
    for (std::ptrdiff_t j = 0; j < beams; ++j) {
        const bool measured = (support[j - far] == Support::Measured) & (support[j] == Support::Measured) &
                              (support[j + stride] == Support::Measured) & (support[j + stride + far] == Support::Measured);
        const float share = (slanted[j] != 0) & measured ? std::abs(slant[j]) / u[j] : 0.0F;
        const float steps = (u[j + stride] - u[j]) / slant[j] - 1;
        const auto weight = static_cast<std::int32_t>(share / kUnitOfWeight);
        weights[j] = weight;
        below[j] = steps <= -limit ? weight : 0;
        upTo[j] = steps < limit ? weight : 0;
    }
}

struct Sum {
    std::int64_t votes = 0, weight = 0, below = 0, upTo = 0;
};
EDGESCAN_INLINE Sum sumOfParity(const StepVotes& votes, std::size_t parity) {
    Sum sum;
    for (std::size_t j = parity; j < votes.weight.size(); j += 2) {
        sum.votes += votes.weight[j] != 0 ? 1 : 0;
        sum.weight += votes.weight[j];
        sum.below += votes.below[j];
        sum.upTo += votes.upTo[j];
    }
    return sum;
}

bool areEnough(std::size_t votes, int beams) { return votes >= std::max<std::size_t>(kFewestCells, static_cast<std::size_t>(beams) / 25); }

// Whether the weighted median of either parity may exceed the limit.
bool canBeSlip(const StepVotes& votes, int beams) {
    for (std::size_t parity = 0; parity < 2; ++parity) {
        const Sum sum = vectorised<sumOfParity>(votes, parity);
        if (areEnough(static_cast<std::size_t>(sum.votes), beams) && (2 * sum.below >= sum.weight || 2 * sum.upTo < sum.weight))
            return true;
    }
    return false;
}

using StepSlips = std::array<std::vector<SlipVote>, 2>;

void addStep(const InverseRange& inverse, int line, int beam, float slant, StepSlips& slips) {
    const float u = inverse.u.at(line, beam);
    const float next = inverse.u.at(line + 1, beam);
    slips[static_cast<std::size_t>(beam % 2)].push_back({(next - u) / slant - 1, std::abs(slant) / u, slant});
}

void addSteps(const InverseRange& inverse, int line, const LineSlants& slants, StepSlips& slips) {
    const int reach = reachAt(line, inverse.u.lines);
    slants.forEach([&](int j, float slant) {
        for (const int i : {line - reach, line, line + 1, line + 1 + reach}) {
            if (!inverse.isMeasured(i, j)) return;
        }
        addStep(inverse, line, j, slant, slips);
    });
}

// The change of u from line to line: the mean of the middle half over several lines. A stall, a leap, one jump, or ranges rounded to
// centimetres do not disturb it. 0 where a range is missing, and where the surface is too steep or slants by less than `least`, a share
// of u.
float middleSlant(const InverseRange& inverse, int first, int last, int beam, float least = kLeastSlant) {
    std::array<float, 2 * kFarthest + 1> changes{};
    for (int i = first; i <= last; ++i) {
        if (!inverse.isMeasured(i, beam)) return 0;
        if (i > first) changes[static_cast<std::size_t>(i - first - 1)] = inverse.u.at(i, beam) - inverse.u.at(i - 1, beam);
    }
    const int count = last - first;
    std::sort(changes.begin(), changes.begin() + count);
    const auto from = changes.begin() + count / 4;
    const auto to = changes.begin() + (count - count / 4);
    const float slant = std::accumulate(from, to, 0.0F) / static_cast<float>(to - from);
    const float share = std::abs(slant) / inverse.u.at(first, beam);
    return share >= least && share <= kMostSlant ? slant : 0;
}

// Measures the same cells again, with the slants of middleSlant().
void addStepsAgain(const InverseRange& inverse, int line, const LineSlants& slants, StepSlips& slips) {
    for (std::vector<SlipVote>& ofParity : slips) ofParity.clear();
    const int reach = reachAt(line, inverse.u.lines);
    slants.forEach([&](int j, float) {
        const float slant = middleSlant(inverse, line - reach, line + 1 + reach, j);
        if (slant != 0) addStep(inverse, line, j, slant, slips);
    });
}

// The slip that the beams of one parity show; 0 if a slip does not explain the deviations.
float extraStep(const std::vector<SlipVote>& slips, int beams, float least) {
    if (!areEnough(slips.size(), beams)) return 0;
    if (isMedianWithin(least, slips)) return 0;
    const float steps = weightedMedian(slips);
    if (spreadAround(steps, slips) > kLargestSpread * std::max(1.0F, std::abs(steps))) return 0;
    return explainedShare(slips, steps) < kExplained ? 0 : steps;
}

// Whether surfaces that slant less show the same slip: a slip of ten steps shows on a tenth of the slant. The outline of one object next to
// slanted surfaces looks like a large slip, and the other surfaces of the line do not show it.
bool isOnAllSurfaces(const InverseRange& inverse, int line, std::size_t parity, float extra) {
    const float size = std::abs(extra);
    if (size <= 1) return true;
    const int reach = reachAt(line, inverse.u.lines);
    std::vector<SlipVote> votes;
    for (int j = static_cast<int>(parity); j < inverse.u.beams; j += 2) {
        const float slant = middleSlant(inverse, line - reach, line + 1 + reach, j, kLeastSlant / size);
        if (slant != 0) votes.push_back({(inverse.u.at(line + 1, j) - inverse.u.at(line, j)) / slant - 1, 1, slant});
    }
    return std::abs(weightedMedian(std::move(votes)) - extra) <= kLargestSpread * size;
}

// Buffers for the work on one line.
struct LineWork {
    explicit LineWork(int beams) : slants(beams), votes(beams) {}
    LineSlants slants;
    StepVotes votes;
    StepSlips slips;
};

// The slip from this line to the next, as the beams of both parities show it.
void findSlip(const InverseRange& inverse, int line, LineWork& work, LineSteps& steps) {
    const int reach = reachAt(line, inverse.u.lines);
    const int beams = inverse.u.beams;
    if (isSurelyNoSlip(inverse, line, reach, kLeastExtra)) return;
    vectorised<slantsRoundStep>(inverse.u.line(line), beams, reach, beams, work.slants.slant.data(), work.slants.slanted.data());
    vectorised<weigh>(inverse.u.line(line), inverse.support.line(line), work.slants, beams, reach, kLeastExtra, work.votes);
    if (!canBeSlip(work.votes, beams)) return;
    StepSlips& slips = work.slips;
    for (std::vector<SlipVote>& ofParity : slips) ofParity.clear();
    addSteps(inverse, line, work.slants, slips);
    if (extraStep(slips[0], beams, kLeastExtra) == 0 && extraStep(slips[1], beams, kLeastExtra) == 0) return;
    addStepsAgain(inverse, line, work.slants, slips);
    for (std::size_t parity = 0; parity < 2; ++parity) {
        const float extra = extraStep(slips[parity], beams, kSureExtra);
        const bool isSlip = std::abs(extra) <= kMostExtra && isOnAllSurfaces(inverse, line, parity, extra);
        steps[parity][static_cast<std::size_t>(line)] = isSlip ? extra : 0;
    }
}

// Slips of even or odd beams that follow each other closely.
struct Stall {
    int first, last; // the first and the last step
    int leap;        // the step of the largest slip
};

float sizeAt(const LineSteps& extra, int step) {
    return std::abs(extra[0][static_cast<std::size_t>(step)]) + std::abs(extra[1][static_cast<std::size_t>(step)]);
}

Stall stallFrom(const LineSteps& extra, int first) {
    Stall stall{first, first, first};
    for (int i = first; i < static_cast<int>(extra[0].size()) && i - stall.last <= kPause; ++i) {
        if (sizeAt(extra, i) == 0) continue;
        stall.last = i;
        if (sizeAt(extra, i) > sizeAt(extra, stall.leap)) stall.leap = i;
    }
    return stall;
}

// Computes how far the lines of a stall are ahead of their places, in index steps. The slips are added from both ends. What the stepper did
// not make up for remains as one longer step, the same for even and odd beams. If it made up for everything, nothing remains.
void straightenStall(const Stall& stall, std::vector<float>& extra, std::vector<float>& ahead) {
    const auto at = [](std::vector<float>& steps, int i) -> float& { return steps[static_cast<std::size_t>(i)]; };
    float total = 0;
    for (int i = stall.first; i <= stall.last; ++i) total += at(extra, i);
    const bool madeUp = std::abs(total) < kMadeUp;
    const float over = madeUp ? total / static_cast<float>(stall.last + 1 - stall.first) : 0; // divided evenly among the lines
    float sum = 0;
    for (int i = stall.first; i <= stall.last; ++i) {
        sum += at(extra, i) - over;
        at(ahead, i + 1) = madeUp || i < stall.leap ? sum : sum - total;
        at(extra, i) = 0;
    }
    if (!madeUp) at(extra, stall.leap) = total;
}

LineSteps straightenStalls(LineSteps& extra) {
    LineSteps ahead;
    ahead.fill(std::vector<float>(extra[0].size()));
    for (int i = 0; i < static_cast<int>(extra[0].size()); ++i) {
        if (sizeAt(extra, i) == 0) continue;
        const Stall stall = stallFrom(extra, i);
        if (stall.last > stall.first) {
            for (std::size_t parity = 0; parity < 2; ++parity) straightenStall(stall, extra[parity], ahead[parity]);
        }
        i = stall.last;
    }
    return ahead;
}

// The rest of a slip, measured with the slopes next to it: crackJumps() removes it with the same slopes.
float leftOver(const InverseRange& inverse, int line, int parity, float otherwise) {
    std::vector<SlipVote> slips;
    for (int j = parity; j < inverse.u.beams; j += 2) {
        bool solid = true;
        for (int i = line - 1; i <= line + 2; ++i) solid = solid && inverse.isMeasured(i, j);
        if (!solid) continue;
        const float u = inverse.u.at(line, j);
        const float next = inverse.u.at(line + 1, j);
        const float slant = 0.5F * (u - inverse.u.at(line - 1, j) + inverse.u.at(line + 2, j) - next);
        const float share = std::abs(slant) / u;
        if (share >= kLeastSlant && share <= kMostSlant) slips.push_back({(next - u) / slant - 1, share, slant});
    }
    return slips.size() < kFewestCells ? otherwise : weightedMedian(slips);
}

} // namespace

LineSteps lineSlips(const InverseRange& inverse, int threads) {
    const int lines = inverse.u.lines;
    LineSteps steps;
    steps.fill(std::vector<float>(static_cast<std::size_t>(lines)));
    runInBands(std::max(0, lines - 1 - 2 * kNearest), bandsFor(inverse.u.size(), threads), [&](int first, int last) {
        LineWork work(inverse.u.beams);
        for (int i = first; i < last; ++i) findSlip(inverse, i + kNearest, work, steps);
    });
    return steps;
}

float stepUnevenness(const InverseRange& inverse) {
    constexpr int kLooks = 60;
    const int lines = inverse.u.lines, beams = inverse.u.beams;
    LineWork work(beams);
    std::vector<float> sizes;
    for (int i = kNearest; i + 1 + kNearest < lines; i += std::max(1, lines / kLooks)) {
        vectorised<slantsRoundStep>(inverse.u.line(i), beams, reachAt(i, lines), beams, work.slants.slant.data(),
                                    work.slants.slanted.data());
        addStepsAgain(inverse, i, work.slants, work.slips);
        for (const std::vector<SlipVote>& votes : work.slips) {
            if (!areEnough(votes.size(), beams)) continue;
            const float middle = weightedMedian(votes);
            if (spreadAround(middle, votes) <= kLargestSpread) sizes.push_back(std::abs(middle));
        }
    }
    return 1.48F * median(std::move(sizes));
}

LineSteps moveToRecordedAngles(InverseRange& inverse, const LineSteps& slips) {
    const bool anything = std::any_of(slips.begin(), slips.end(), [](const std::vector<float>& steps) {
        return std::any_of(steps.begin(), steps.end(), [](float extra) { return extra != 0; });
    });
    if (!anything) return slips;
    LineSteps left = slips;
    const LineSteps ahead = straightenStalls(left);
    const InverseRange from = inverse;
    for (int i = 0; i < inverse.u.lines; ++i) {
        for (int parity = 0; parity < 2; ++parity) {
            const float steps = ahead[static_cast<std::size_t>(parity)][static_cast<std::size_t>(i)];
            if (steps == 0) continue;
            const int reach = std::min({kFarthest, i, inverse.u.lines - 1 - i});
            for (int j = parity; j < inverse.u.beams; j += 2)
                inverse.u.at(i, j) = std::max(from.u.at(i, j) - steps * middleSlant(from, i - reach, i + reach, j), 1e-4F);
        }
    }
    for (int i = 1; i + 2 < inverse.u.lines; ++i) {
        for (int parity = 0; parity < 2; ++parity) {
            float& extra = left[static_cast<std::size_t>(parity)][static_cast<std::size_t>(i)];
            if (extra != 0) extra = leftOver(inverse, i, parity, extra);
        }
    }
    return left;
}

} // namespace edgescan
