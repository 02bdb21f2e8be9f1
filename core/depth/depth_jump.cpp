// Jumps between neighbouring cells. Rows of plain arithmetic without branches, so that the compiler makes vectors of them.
#include "core/depth/depth_jump.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

// Weights of the cells at a crack, nearest first: where their line meets the crack, half a cell on.
struct LineWeights {
    float first, second, third;
};
constexpr LineWeights kTwoCells{1.5F, -0.5F, 0.0F};
constexpr LineWeights kThreeCells{1.083F, 0.333F, -0.417F}; // least squares through three: calmer

float extraAt(const SweepSlips& slips, Along along, int line, std::size_t parity) {
    const std::vector<float>& extra = slips.extra[parity];
    const bool inside = line >= 0 && line < static_cast<int>(extra.size());
    return along == Along::Lines && inside ? extra[static_cast<std::size_t>(line)] : 0.0F;
}

// By how much the step to the next line is too long, for even and for odd beams.
struct Extra {
    float even, odd;
    [[nodiscard]] float of(int beam) const { return even + static_cast<float>(beam & 1) * (odd - even); }
};

// `out` goes from beam -1 to `beams`; at these two there is never a jump.
EDGESCAN_SIMD void jumpsOfLine(const float* u, const float* solid, std::ptrdiff_t s, int beams, Extra extra, const float* angle,
                               const DepthLimits& limits, float* __restrict out) {
    const LineWeights w = limits.noisy ? kThreeCells : kTwoCells;
    const float least = limits.jumpMm;
    const float growth = limits.growth;
    const float grazing = limits.grazing;
    const float relief = limits.reliefMm;
    for (int j = 0; j < beams; ++j) {
        // A side of one cell has the slope of the other side.
        const float hasAway = solid[j - s];
        const float hasOn = solid[j + 2 * s];
        const float ownAway = hasAway * (u[j] - u[j - s]);
        const float ownOn = hasOn * (u[j + 2 * s] - u[j + s]);
        const float away = ownAway + (1.0F - hasAway) * ownOn;
        const float on = ownOn + (1.0F - hasOn) * ownAway;
        const float slant = 0.25F * extra.of(j) * (away + on);
        const float a = std::max(u[j] + slant, 1e-6F);
        const float b = std::max(u[j + s] - slant, 1e-6F);
        const float a1 = std::max(a - away, 1e-6F);
        const float a2 = a1 + solid[j - s] * solid[j - 2 * s] * (u[j - 2 * s] - u[j - s]);
        const float b1 = std::max(b + on, 1e-6F);
        const float b2 = b1 + solid[j + 2 * s] * solid[j + 3 * s] * (u[j + 3 * s] - u[j + 2 * s]);
        const float left = std::max(w.first * a + w.second * a1 + w.third * a2, 1e-6F);
        const float right = std::max(w.first * b + w.second * b1 + w.third * b2, 1e-6F);
        const float rangeA = 1000.0F / a;
        const float rangeB = 1000.0F / b;
        const float step = std::min(std::abs(rangeA - rangeB), std::abs(1000.0F / left - 1000.0F / right));
        const float slope = 0.5F * (std::abs(rangeA - 1000.0F / a1) + std::abs(1000.0F / b1 - rangeB));
        const float near = std::min(rangeA, rangeB);
        const float allowed = least + growth * near + grazing * slope + relief * slope / (near * angle[j]);
        out[j] = step / allowed * solid[j] * solid[j + s];
    }
    out[-1] = out[beams] = 0;
}

EDGESCAN_SIMD void linksOfLine(const float* jump, const float* solid, std::ptrdiff_t s, int beams, Extra extra, float* __restrict out) {
    for (int j = -1; j <= beams; ++j) out[j] = (jump[j] <= 1.0F && extra.of(j) == 0.0F ? solid[j] : 0.0F) * solid[j + s];
}

EDGESCAN_SIMD void nearerOfLine(const float* u, const float* jump, std::ptrdiff_t s, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float behind = u[j] >= u[j + s] ? jump[j] : 0.0F;
        const float before = u[j] > u[j - s] ? jump[j - s] : 0.0F;
        out[j] = std::max(behind, before);
    }
}

EDGESCAN_SIMD void smoothLine(const float* u, const float* link, std::ptrdiff_t s, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) out[j] = u[j] + 0.25F * link[j] * link[j - s] * (u[j - s] + u[j + s] - 2 * u[j]);
}

} // namespace

void crackJumps(const DepthField& field, Along along, int line, const float* angle, const SweepSlips& slips, const DepthLimits& limits,
                Lines& jumps) {
    const Extra extra{extraAt(slips, along, line, 0), extraAt(slips, along, line, 1)};
    jumpsOfLine(field.u.line(line), field.solid.line(line), field.step(along), field.u.beams, extra, angle, limits, jumps.next());
}

void surfaceLinks(const DepthField& field, const Lines& jumps, Along along, int line, const SweepSlips& slips, Lines& links) {
    const Extra extra{extraAt(slips, along, line, 0), extraAt(slips, along, line, 1)};
    linksOfLine(jumps.line(line), field.solid.line(line), field.step(along), field.u.beams, extra, links.next());
}

void onNearerCells(const DepthField& field, const Lines& jumps, Along along, int line, Lines& cells) {
    nearerOfLine(field.u.line(line), jumps.line(line), field.step(along), field.u.beams, cells.next());
}

void smoothSurfaces(const Lines& u, const Lines& links, Along along, int line, Lines& smooth) {
    smoothLine(u.line(line), links.line(line), stepOf(u, along), u.beams, smooth.next());
}

} // namespace edgescan
