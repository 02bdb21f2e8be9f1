// Displacements of beams and lines.
#include "core/edges/interlace.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

constexpr float kLeastSlant = 0.005F; // change of u per line, share of u
constexpr float kMostSlant = 0.1F;    // steeper is an edge rather than a slant
constexpr std::size_t kFewestCells = 16;
constexpr float kLeastParity = 0.15F; // index steps
constexpr float kLeastExtra = 0.5F;
constexpr float kAgree = 0.35F; // spread of the values of a line, index steps or share of the slip
constexpr int kFewestLines = 10;
constexpr int kSampledLines = 64;
constexpr float kExplained = 0.5F; // of the deviations on a line

struct Slip {
    float steps;
    float weight;
    float slant = 0; // of u per line
};

// How much smaller the deviations from straight get when the slip is taken out, 0..1: noise does not shrink.
float explained(const std::vector<Slip>& slips, float steps) {
    double with = 0;
    double without = 0;
    for (const Slip& slip : slips) {
        with += static_cast<double>(std::abs((slip.steps - steps) * slip.slant));
        without += static_cast<double>(std::abs(slip.steps * slip.slant));
    }
    return without > 0 ? static_cast<float>(1 - with / without) : 0.0F;
}

struct Median {
    float value = 0;
    float spread = 0; // weighted median distance from it
    std::size_t count = 0;
};

float weightedMiddle(std::vector<Slip>& slips) {
    std::sort(slips.begin(), slips.end(), [](const Slip& a, const Slip& b) { return a.steps < b.steps; });
    double total = 0;
    for (const Slip& slip : slips) total += static_cast<double>(slip.weight);
    double sum = 0;
    for (const Slip& slip : slips) {
        sum += static_cast<double>(slip.weight);
        if (2 * sum >= total) return slip.steps;
    }
    return 0;
}

Median medianOf(std::vector<Slip>& slips) {
    Median median;
    median.count = slips.size();
    if (slips.empty()) return median;
    median.value = weightedMiddle(slips);
    for (Slip& slip : slips) slip.steps = std::abs(slip.steps - median.value);
    median.spread = weightedMiddle(slips);
    return median;
}

bool measured(const InverseRange& inverse, int line, int beam) { return inverse.support.at(line, beam) == Support::Measured; }

bool measuredAround(const InverseRange& inverse, int line, int beam) {
    for (int i = line - 1; i <= line + 1; ++i) {
        for (int j = beam - 1; j <= beam + 1; ++j) {
            if (!measured(inverse, i, j)) return false;
        }
    }
    return true;
}

// Odd beams against even ones on one line.
void addParity(const InverseRange& inverse, int line, std::vector<Slip>& slips) {
    const Grid<float>& u = inverse.u;
    for (int j = 1; j + 1 < u.beams; ++j) {
        if (!measuredAround(inverse, line, j)) continue;
        float slant = 0;
        for (int n = j - 1; n <= j + 1; ++n) slant += (u.at(line + 1, n) - u.at(line - 1, n)) / 6.0F;
        const float share = std::abs(slant) / u.at(line, j);
        if (share < kLeastSlant || share > kMostSlant) continue;
        const float off = (u.at(line, j) - 0.5F * (u.at(line, j - 1) + u.at(line, j + 1))) / slant;
        slips.push_back({j % 2 == 1 ? off : -off, share});
    }
}

// The step from a line to the next, against the slants before and after it; the lines at the step itself are not in the slants, for
// their noise would tell against it.
void addExtra(const InverseRange& inverse, int line, int parity, std::vector<Slip>& slips) {
    const Grid<float>& u = inverse.u;
    for (int j = parity; j < u.beams; j += 2) {
        const float before = 0.5F * (u.at(line - 1, j) - u.at(line - 3, j));
        const float after = 0.5F * (u.at(line + 4, j) - u.at(line + 2, j));
        const float slant = 0.5F * (before + after);
        const float share = std::abs(slant) / u.at(line, j);
        if (share < kLeastSlant || share > kMostSlant || std::abs(before - after) > std::abs(slant)) continue;
        bool all = true;
        for (int i = line - 3; i <= line + 4; ++i) all = all && measured(inverse, i, j);
        if (!all) continue;
        slips.push_back({(u.at(line + 1, j) - u.at(line, j)) / slant - 1, share, slant});
    }
}

// The smaller one where the slants on both sides agree in sign; 0 at an edge.
float slantAt(const InverseRange& inverse, int line, int beam) {
    const Grid<float>& u = inverse.u;
    const bool hasBefore = line > 0 && measured(inverse, line - 1, beam);
    const bool hasAfter = line + 1 < u.lines && measured(inverse, line + 1, beam);
    const float before = hasBefore ? u.at(line, beam) - u.at(line - 1, beam) : 0;
    const float after = hasAfter ? u.at(line + 1, beam) - u.at(line, beam) : 0;
    if (!hasBefore || !hasAfter) return 0;
    if (before * after <= 0) return 0;
    // Much unlike: one of them crosses a jump.
    const float smaller = std::abs(before) < std::abs(after) ? before : after;
    const float larger = std::abs(before) < std::abs(after) ? after : before;
    return std::abs(larger) > 3 * std::abs(smaller) ? smaller : 0.5F * (before + after);
}

// How far odd beams are ahead on every so many lines; all 0 unless most of these tell of it.
std::vector<float> parities(const InverseRange& inverse, int every) {
    std::vector<float> parity(static_cast<std::size_t>(inverse.u.lines));
    int told = 0;
    int shifted = 0;
    std::vector<Slip> slips;
    for (int i = 1; i + 1 < inverse.u.lines; i += every) {
        slips.clear();
        addParity(inverse, i, slips);
        const Median median = medianOf(slips);
        if (median.count < kFewestCells) continue;
        ++told;
        if (std::abs(median.value) < kLeastParity || median.spread > kAgree) continue;
        ++shifted;
        parity[static_cast<std::size_t>(i)] = median.value;
    }
    if (told < kFewestLines || 2 * shifted <= told) std::fill(parity.begin(), parity.end(), 0.0F);
    return parity;
}

// The slip after a line for the beams of one parity; 0 when there is none that explains what is seen.
float extraStep(const InverseRange& inverse, int line, int parity) {
    std::vector<Slip> slips;
    addExtra(inverse, line, parity, slips);
    if (slips.size() < std::max<std::size_t>(kFewestCells, static_cast<std::size_t>(inverse.u.beams) / 25)) return 0;
    const std::vector<Slip> all = slips;
    const Median median = medianOf(slips);
    if (std::abs(median.value) < kLeastExtra || median.spread > kAgree * std::max(1.0F, std::abs(median.value))) return 0;
    return explained(all, median.value) < kExplained ? 0 : median.value;
}

void moveBeams(InverseRange& inverse, const std::vector<float>& parity) {
    Grid<float> straight = inverse.u;
    for (int i = 0; i < straight.lines; ++i) {
        const float half = 0.5F * parity[static_cast<std::size_t>(i)];
        if (half == 0) continue;
        for (int j = 0; j < straight.beams; ++j) {
            if (!measured(inverse, i, j)) continue;
            const float ahead = j % 2 == 1 ? half : -half;
            straight.at(i, j) = std::max(inverse.u.at(i, j) - ahead * slantAt(inverse, i, j), 1e-4F);
        }
    }
    inverse.u = std::move(straight);
}

} // namespace

SweepSlips noSlips(int lines) {
    const std::vector<float> none(static_cast<std::size_t>(lines));
    return {none, {none, none}, false, 0};
}

SweepSlips straighten(InverseRange& inverse) {
    const int lines = inverse.u.lines;
    // A sample of the lines tells whether it is worth looking at all of them.
    SweepSlips result{parities(inverse, std::max(1, lines / kSampledLines)), {}, false, 0};
    result.extra.fill(std::vector<float>(static_cast<std::size_t>(lines)));
    result.interlaced = std::any_of(result.parity.begin(), result.parity.end(), [](float steps) { return steps != 0; });
    if (result.interlaced) {
        result.parity = parities(inverse, 1);
        moveBeams(inverse, result.parity);
    }
    for (int i = 3; i + 4 < lines; ++i) {
        for (int parity = 0; parity < 2; ++parity) {
            const float steps = extraStep(inverse, i, parity);
            result.extra[static_cast<std::size_t>(parity)][static_cast<std::size_t>(i)] = steps;
            result.slips += steps != 0 ? 1 : 0;
        }
    }
    return result;
}

} // namespace edgescan
