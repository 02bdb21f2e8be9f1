// Jumps between neighbouring cells. Rows of plain arithmetic without branches, so that the compiler makes vectors of them.
#include "core/edges/depth_jump.h"

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

std::ptrdiff_t stepOf(const PaddedGrid<float>& grid, Along along) { return along == Along::Beams ? 1 : grid.stride; }

} // namespace

PaddedGrid<float> crackJumps(const DepthField& field, Along along, const SweepSlips& slips, const DepthLimits& limits) {
    const std::ptrdiff_t s = field.step(along);
    const LineWeights w = limits.noisy ? kThreeCells : kTwoCells;
    PaddedGrid<float> jumps(field.u.lines, field.u.beams);
    for (int i = -1; i <= field.u.lines; ++i) {
        const float* u = field.u.line(i);
        const float* solid = field.solid.line(i);
        float* out = jumps.line(i);
        const float even = extraAt(slips, along, i, 0);
        const float odd = extraAt(slips, along, i, 1);
        for (int j = -1; j <= field.u.beams; ++j) {
            const float slant = 0.25F * (even + static_cast<float>(j & 1) * (odd - even)) *
                                (solid[j - s] * (u[j] - u[j - s]) + solid[j + 2 * s] * (u[j + 2 * s] - u[j + s]));
            const float a = u[j] + slant;
            const float b = u[j + s] - slant;
            const float a1 = a + solid[j - s] * (u[j - s] - u[j]);
            const float a2 = a1 + solid[j - s] * solid[j - 2 * s] * (u[j - 2 * s] - u[j - s]);
            const float b1 = b + solid[j + 2 * s] * (u[j + 2 * s] - u[j + s]);
            const float b2 = b1 + solid[j + 2 * s] * solid[j + 3 * s] * (u[j + 3 * s] - u[j + 2 * s]);
            const float left = std::max(w.first * a + w.second * a1 + w.third * a2, 1e-6F);
            const float right = std::max(w.first * b + w.second * b1 + w.third * b2, 1e-6F);
            const float rangeA = 1000.0F / std::max(a, 1e-6F);
            const float rangeB = 1000.0F / std::max(b, 1e-6F);
            const float step = std::min(std::abs(rangeA - rangeB), std::abs(1000.0F / left - 1000.0F / right));
            const float slope =
                0.5F * (std::abs(rangeA - 1000.0F / std::max(a1, 1e-6F)) + std::abs(1000.0F / std::max(b1, 1e-6F) - rangeB));
            const float allowed = limits.jumpMm + limits.growth * std::min(rangeA, rangeB) + limits.grazing * slope;
            out[j] = step / allowed * solid[j] * solid[j + s];
        }
    }
    return jumps;
}

PaddedGrid<float> surfaceLinks(const DepthField& field, const PaddedGrid<float>& jumps, Along along, const SweepSlips& slips) {
    const std::ptrdiff_t s = field.step(along);
    PaddedGrid<float> links(jumps.lines, jumps.beams);
    for (int i = -1; i <= jumps.lines; ++i) {
        const float* solid = field.solid.line(i);
        const float* jump = jumps.line(i);
        float* out = links.line(i);
        const float even = extraAt(slips, along, i, 0) == 0 ? 1.0F : 0.0F;
        const float odd = extraAt(slips, along, i, 1) == 0 ? 1.0F : 0.0F;
        for (int j = -1; j <= jumps.beams; ++j)
            out[j] = jump[j] <= 1.0F ? solid[j] * solid[j + s] * (even + static_cast<float>(j & 1) * (odd - even)) : 0.0F;
    }
    return links;
}

PaddedGrid<float> onNearerCells(const DepthField& field, const PaddedGrid<float>& jumps, Along along) {
    const std::ptrdiff_t s = field.step(along);
    PaddedGrid<float> cells(jumps.lines, jumps.beams);
    for (int i = 0; i < jumps.lines; ++i) {
        const float* u = field.u.line(i);
        const float* jump = jumps.line(i);
        float* out = cells.line(i);
        for (int j = 0; j < jumps.beams; ++j) {
            const float behind = u[j] >= u[j + s] ? jump[j] : 0.0F;
            const float before = u[j] > u[j - s] ? jump[j - s] : 0.0F;
            out[j] = std::max(behind, before);
        }
    }
    return cells;
}

void smoothSurfaces(PaddedGrid<float>& u, const PaddedGrid<float>& links, Along along) {
    const std::ptrdiff_t s = stepOf(u, along);
    // The line before, as it was; along the beams the line itself.
    const auto beams = static_cast<std::size_t>(u.beams);
    std::vector<float> before(u.line(-1), u.line(-1) + u.beams);
    std::vector<float> smooth(beams);
    for (int i = 0; i < u.lines; ++i) {
        float* line = u.line(i);
        const float* link = links.line(i);
        const float* previous = along == Along::Beams ? line - 1 : before.data();
        for (std::size_t j = 0; j < beams; ++j) {
            const auto k = static_cast<std::ptrdiff_t>(j);
            smooth[j] = line[k] + 0.25F * link[k] * link[k - s] * (previous[k] + line[k + s] - 2 * line[k]);
        }
        if (along == Along::Lines) std::copy(line, line + u.beams, before.begin());
        std::copy(smooth.begin(), smooth.end(), line);
    }
}

} // namespace edgescan
