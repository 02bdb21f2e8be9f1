// Displacements of beams and lines.
#include "core/scan/angle_correction/interlace.h"

#include "core/base/simd.h"
#include "core/scan/angle_correction/line_slips.h"
#include "core/scan/angle_correction/slip_votes.h"
#include "core/scan/angle_correction/turned_steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan {
namespace {

constexpr float kLeastParity = 0.15F; // smallest displacement that is reported, index steps
constexpr int kFewestLines = 10;
constexpr int kSampledLines = 64;

// Slants at each beam, from the lines before and after.
EDGESCAN_INLINE void slantsAround(const float* u, std::ptrdiff_t stride, int beams, float* __restrict slants,
                                  std::uint8_t* __restrict slanted) {
    for (int j = 1; j < beams - 1; ++j) {
        const auto change = [&](int n) { return (u[n + stride] - u[n - stride]) / 6.0F; };
        const float slant = change(j - 1) + change(j) + change(j + 1);
        const float share = std::abs(slant) / u[j];
        slants[j] = slant;
        slanted[j] = static_cast<std::uint8_t>((share >= kLeastSlant) & (share <= kMostSlant));
    }
}

// Compares odd beams with even beams on one line.
void addParity(const InverseRange& inverse, int line, LineSlants& slants, std::vector<SlipVote>& slips) {
    const float* u = inverse.u.line(line);
    vectorised<slantsAround>(u, inverse.u.beams, inverse.u.beams, slants.slant.data(), slants.slanted.data());
    slants.forEach([&](int j, float slant) {
        if (!measuredAround(inverse, line, j)) return;
        const float off = (u[j] - 0.5F * (u[j - 1] + u[j + 1])) / slant;
        slips.push_back({j % 2 == 1 ? off : -off, std::abs(slant) / u[j]});
    });
}

// The slant with the smaller size if those on both sides agree in sign; 0 at an edge.
float slantAt(const InverseRange& inverse, int line, int beam) {
    const Grid<float>& u = inverse.u;
    if (line == 0 || line + 1 == u.lines || !inverse.isMeasured(line - 1, beam) || !inverse.isMeasured(line + 1, beam)) return 0;
    const float before = u.at(line, beam) - u.at(line - 1, beam);
    const float after = u.at(line + 1, beam) - u.at(line, beam);
    if (before * after <= 0) return 0;
    // If they differ much, one of them crosses a jump.
    const float smaller = std::abs(before) < std::abs(after) ? before : after;
    const float larger = std::abs(before) < std::abs(after) ? after : before;
    return std::abs(larger) > 3 * std::abs(smaller) ? smaller : 0.5F * (before + after);
}

// How far odd beams are ahead, measured on every `every`-th line; all 0 unless most of these lines show it.
std::vector<float> parities(const InverseRange& inverse, int every) {
    std::vector<float> parity(static_cast<std::size_t>(inverse.u.lines));
    int measuredLines = 0;
    int shifted = 0;
    std::vector<SlipVote> slips;
    LineSlants slants(inverse.u.beams);
    for (int i = 1; i + 1 < inverse.u.lines; i += every) {
        slips.clear();
        addParity(inverse, i, slants, slips);
        if (slips.size() < kFewestCells) continue;
        ++measuredLines;
        if (isMedianWithin(kLeastParity, slips)) continue;
        const float steps = weightedMedian(slips);
        if (spreadAround(steps, slips) > kLargestSpread) continue;
        ++shifted;
        parity[static_cast<std::size_t>(i)] = steps;
    }
    if (measuredLines < kFewestLines || 2 * shifted <= measuredLines) std::fill(parity.begin(), parity.end(), 0.0F);
    return parity;
}

void moveBeams(InverseRange& inverse, const std::vector<float>& parity) {
    Grid<float> straight = inverse.u;
    for (int i = 0; i < straight.lines; ++i) {
        const float half = 0.5F * parity[static_cast<std::size_t>(i)];
        if (half == 0) continue;
        for (int j = 0; j < straight.beams; ++j) {
            if (!inverse.isMeasured(i, j)) continue;
            const float ahead = j % 2 == 1 ? half : -half;
            straight.at(i, j) = std::max(inverse.u.at(i, j) - ahead * slantAt(inverse, i, j), 1e-4F);
        }
    }
    inverse.u = std::move(straight);
}

} // namespace

SweepSlips noSlips(int lines) {
    const std::vector<float> none(static_cast<std::size_t>(lines));
    return {none, {none, none}, {none, none}, false, 0, {}};
}

SweepSlips straighten(InverseRange& inverse, int threads) {
    const int lines = inverse.u.lines;
    // A sample of the lines shows whether measuring all of them is worth the time.
    SweepSlips result{parities(inverse, std::max(1, lines / kSampledLines)), {}, {}, false, 0, turnedSteps(inverse)};
    result.interlaced = std::any_of(result.parity.begin(), result.parity.end(), [](float steps) { return steps != 0; });
    if (result.interlaced) {
        result.parity = parities(inverse, 1);
        moveBeams(inverse, result.parity);
    }
    result.measured = lineSlips(inverse, threads);
    result.remaining = moveToRecordedAngles(inverse, result.measured);
    for (const std::vector<float>& steps : result.measured)
        result.slipCount += static_cast<int>(std::count_if(steps.begin(), steps.end(), [](float extra) { return extra != 0; }));
    return result;
}

} // namespace edgescan
