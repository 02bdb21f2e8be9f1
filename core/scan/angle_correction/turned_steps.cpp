// Measures the first and the last steps of a sweep by the slopes of the lines behind them.
#include "core/scan/angle_correction/turned_steps.h"

#include "core/scan/angle_correction/slip_votes.h"
#include "core/scan/angle_correction/sureness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace edgescan {
namespace {

constexpr int kSteps = 12;           // at each end, in which a stepper may turn
constexpr int kFrom = 6;             // lines from the end of the sweep: from here on ...
constexpr int kReference = 18;       // ... so many steps give the slopes of the surfaces
constexpr float kBack = -0.5F;       // index steps: surely the other way
constexpr float kMostSpread = 0.8F;  // of the votes of a step
constexpr float kSdOfMedian = 1.86F; // times the median distance from it, over the root of the number
constexpr float kSlow = 0.5F;        // index steps: not yet at its speed
constexpr float kProved = 0.4F;      // share of the deviations from slopes as usual that a turn must explain
constexpr std::size_t kOneOf = 10;   // beams, of which at least one must have a vote
constexpr int kSampled = 512;        // beams that are looked at, two neighbours at a time: one even, one odd

// One end of a sweep: place 0 is its first or its last line.
struct SweepEnd {
    const InverseRange& inverse;
    bool last;

    [[nodiscard]] int line(int place) const { return last ? inverse.u.lines - 1 - place : place; }
    [[nodiscard]] float u(int place, int beam) const { return inverse.u.at(line(place), beam); }
    [[nodiscard]] bool isMeasured(int place, int beam) const { return inverse.isMeasured(line(place), beam); }
};

// The change of u per step as a share of u: the mean of the middle half. 0 where a range is missing or the surface is not slanted.
float usualChange(const SweepEnd& end, int beam) {
    std::array<float, kReference> changes{};
    for (int n = 0; n <= kReference; ++n) {
        if (!end.isMeasured(kFrom + n, beam)) return 0;
        if (n > 0)
            changes[static_cast<std::size_t>(n - 1)] = (end.u(kFrom + n, beam) - end.u(kFrom + n - 1, beam)) / end.u(kFrom + n - 1, beam);
    }
    std::sort(changes.begin(), changes.end());
    const auto from = changes.begin() + kReference / 4, to = changes.end() - kReference / 4;
    const float change = std::accumulate(from, to, 0.0F) / static_cast<float>(to - from);
    return std::abs(change) >= kLeastSlant && std::abs(change) <= kMostSlant ? change : 0;
}

// What the cells say of the step from a place to the next one, in index steps.
std::vector<SlipVote> votesOn(const SweepEnd& end, int step, const std::vector<float>& usual) {
    std::vector<SlipVote> votes;
    for (int j = 0; j < static_cast<int>(usual.size()); ++j) {
        const float change = usual[static_cast<std::size_t>(j)];
        if (change == 0 || !end.isMeasured(step, j) || !end.isMeasured(step + 1, j)) continue;
        const float own = (end.u(step + 1, j) - end.u(step, j)) / end.u(step, j);
        votes.push_back({own / change, std::abs(change), change});
    }
    return votes;
}

// Whether the votes agree that the stepper went back.
bool isBack(std::vector<SlipVote> votes, float steps) {
    const float spread = spreadAround(steps, votes);
    // Ranges rounded to centimetres spread the votes of one step; their median is sure all the same.
    const float sd = kSdOfMedian * spread / std::sqrt(static_cast<float>(votes.size()));
    if (steps > kBack || spread > kMostSpread || steps > -static_cast<float>(kSignificantSds) * sd) return false;
    for (SlipVote& vote : votes) vote.steps -= 1; // the deviation from a step as usual
    return explainedShare(votes, steps - 1) >= kProved;
}

// The number of steps from this end on at which the stepper turned.
int turnedAt(const SweepEnd& end) {
    const int beams = end.inverse.u.beams;
    if (end.inverse.u.lines < 2 * (kFrom + kReference + 1)) return 0;
    std::vector<float> usual(static_cast<std::size_t>(beams));
    std::size_t slanted = 0;
    const int apart = std::max(1, beams / kSampled);
    for (int j = 0; j < beams; ++j) {
        if (j / 2 % apart != 0) continue;
        usual[static_cast<std::size_t>(j)] = usualChange(end, j);
        slanted += usual[static_cast<std::size_t>(j)] != 0 ? 1 : 0;
    }
    const std::size_t enough = std::max<std::size_t>(kFewestCells, usual.size() / static_cast<std::size_t>(apart) / kOneOf);
    if (slanted < enough) return 0;
    bool back = false;
    int turned = 0;
    for (int step = 0; step < kSteps; ++step) {
        const std::vector<SlipVote> votes = votesOn(end, step, usual);
        if (votes.size() < enough) continue;
        const float steps = weightedMedian(votes);
        if (isBack(votes, steps)) back = true;
        if (steps < kSlow) turned = step + 1;
        if (back && steps >= kSlow) break;
    }
    return back ? turned : 0;
}

} // namespace

std::vector<std::uint8_t> turnedSteps(const InverseRange& inverse) {
    const int atFirst = turnedAt({inverse, false}), atLast = turnedAt({inverse, true});
    if (atFirst == 0 && atLast == 0) return {};
    std::vector<std::uint8_t> turned(static_cast<std::size_t>(inverse.u.lines), 0);
    std::fill_n(turned.begin(), atFirst, std::uint8_t{1});
    std::fill(turned.end() - 1 - atLast, turned.end() - 1, std::uint8_t{1}); // the step from a line to the next has the number of the line
    return turned;
}

} // namespace edgescan
