// Jumps between neighbouring cells. Loops of plain arithmetic without branches, so that the compiler can vectorise them.
#include "core/edges/edgescan_plus/jump.h"

#include "core/base/simd.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace edgescan::edges {
namespace {

// Weights of the cells at a crack, nearest first: they give the value of their straight line at the crack, half a cell beyond the nearest
// cell.
struct LineWeights {
    float first, second, third;
};
constexpr LineWeights kTwoCells{1.5F, -0.5F, 0.0F};
constexpr LineWeights kThreeCells{1.083F, 0.333F, -0.417F}; // least squares through three cells: less noise

LineWeights weightsAt(float noisy) {
    if (noisy <= 0 || noisy >= 1) return noisy <= 0 ? kTwoCells : kThreeCells;
    const auto between = [noisy](float two, float three) { return two + noisy * (three - two); };
    return {between(kTwoCells.first, kThreeCells.first), between(kTwoCells.second, kThreeCells.second),
            between(kTwoCells.third, kThreeCells.third)};
}

float extraAt(const SweepSlips& slips, Along along, int line, std::size_t parity) {
    const std::vector<float>& extra = slips.remaining[parity];
    const bool inside = line >= 0 && line < static_cast<int>(extra.size());
    return along == Along::Lines && inside ? extra[static_cast<std::size_t>(line)] : 0.0F;
}

// As integers, non-negative floats have the same order, compared in one instruction; negative ones are less than all others.
EDGESCAN_INLINE float atLeast(float value) {
    constexpr float kLeast = 1e-6F;
    return std::bit_cast<float>(std::max(std::bit_cast<std::int32_t>(value), std::bit_cast<std::int32_t>(kLeast)));
}
EDGESCAN_INLINE float lesser(float a, float b) {
    return std::bit_cast<float>(std::min(std::bit_cast<std::int32_t>(a), std::bit_cast<std::int32_t>(b)));
}
EDGESCAN_INLINE float greater(float a, float b) {
    return std::bit_cast<float>(std::max(std::bit_cast<std::int32_t>(a), std::bit_cast<std::int32_t>(b)));
}

// The excess of the step to the next line, for even and for odd beams.
struct Extra {
    float even, odd;
    [[nodiscard]] float of(int beam) const { return even + static_cast<float>(beam & 1) * (odd - even); }
};

// A line of cells, and the direction in which they are processed.
struct CrackCells {
    const float* u;
    const float* solid;
    const float* angle;
    std::ptrdiff_t step;
};

// Cracks of some cells. kWhole: all cells around are solid and the stepper did not slip; the same arithmetic without the factors that are
// then 1 or 0.
template <bool kWhole, class Count>
EDGESCAN_INLINE void jumpsOfCells(const CrackCells& at, Count count, Extra extra, const DepthLimits& limits, const LineWeights& w,
                                  float* __restrict out) {
    const float* u = at.u;
    const float* solid = at.solid;
    const float* angle = at.angle;
    const std::ptrdiff_t s = at.step;
    const float least = limits.jumpMm;
    const float growth = 1000.0F * limits.growth; // the nearer range is 1000 divided by the larger u
    const float grazing = limits.grazing;
    const float relief = 0.001F * limits.reliefMm;
    for (int j = 0; j < count; ++j) {
        // A side of only one cell gets the slope of the other side.
        float away = u[j] - u[j - s];
        float on = u[j + 2 * s] - u[j + s];
        float a = u[j];
        float b = u[j + s];
        if constexpr (!kWhole) {
            const float ownAway = solid[j - s] * away;
            const float ownOn = solid[j + 2 * s] * on;
            away = ownAway + (1.0F - solid[j - s]) * ownOn;
            on = ownOn + (1.0F - solid[j + 2 * s]) * ownAway;
            const float slant = 0.25F * extra.of(j) * (away + on);
            a += slant;
            b -= slant;
        }
        float a2 = u[j - 2 * s] - u[j - s];
        float b2 = u[j + 3 * s] - u[j + 2 * s];
        if constexpr (!kWhole) {
            a2 *= solid[j - s] * solid[j - 2 * s];
            b2 *= solid[j + 2 * s] * solid[j + 3 * s];
        }
        a = atLeast(a);
        b = atLeast(b);
        const float a1 = atLeast(a - away);
        const float b1 = atLeast(b + on);
        const float left = atLeast(w.first * a + w.second * a1 + w.third * (a1 + a2));
        const float right = atLeast(w.first * b + w.second * b1 + w.third * (b1 + b2));
        // Ranges are 1000 / u. With common denominators two divisions remain of eight.
        const float ends = a * b;
        const float meeting = left * right;
        const float step = 1000.0F * lesser(std::abs(b - a) * meeting, std::abs(right - left) * ends) / (ends * meeting);
        const float others = a1 * b1;
        const float slope = 500.0F * (std::abs(a1 - a) * (b * b1) + std::abs(b1 - b) * (a * a1)); // multiplied by `ends` and by `others`
        const float allowed =
            (least * ends + growth * lesser(a, b)) * (others * angle[j]) + slope * (grazing * angle[j] + relief * greater(a, b));
        const float jump = step * (ends * others * angle[j]) / allowed;
        out[j] = kWhole ? jump : jump * solid[j] * solid[j + s];
    }
}

constexpr int kCrackBlock = 64;

// Whether all cells that the cracks of a block read are solid.
EDGESCAN_INLINE bool isWhole(const CrackCells& at) {
    std::int32_t all = -1;
    for (int n = -2; n <= 3; ++n) {
        const float* solid = at.solid + n * at.step;
        for (int j = 0; j < kCrackBlock; ++j) all &= std::bit_cast<std::int32_t>(solid[j]);
    }
    return all == std::bit_cast<std::int32_t>(1.0F);
}

// `out` covers beams -1 to `beams`; at these two there is never a jump. Works in blocks; the last block overlaps the one before.
EDGESCAN_INLINE void jumpsOfLine(const CrackCells& at, int beams, Extra extra, const DepthLimits& limits, const LineWeights& w,
                                 float* out) {
    out[-1] = out[beams] = 0;
    if (beams < kCrackBlock) return jumpsOfCells<false>(at, beams, extra, limits, w, out);
    constexpr auto kCount = std::integral_constant<int, kCrackBlock>();
    const bool straight = extra.even == 0 && extra.odd == 0;
    for (int next = 0; next < beams; next += kCrackBlock) {
        // At an even beam, because even and odd beams differ.
        const int first = std::min(next, (beams - kCrackBlock) & ~1);
        const CrackCells block{at.u + first, at.solid + first, at.angle + first, at.step};
        if (straight && isWhole(block))
            jumpsOfCells<true>(block, kCount, extra, limits, w, out + first);
        else
            jumpsOfCells<false>(block, kCount, extra, limits, w, out + first);
    }
    // An odd beam remains.
    const int last = beams - 1;
    if (beams % 2 != 0) jumpsOfCells<false>({at.u + last, at.solid + last, at.angle + last, at.step}, 1, extra, limits, w, out + last);
}

EDGESCAN_INLINE void linksOfLine(const float* jump, const float* solid, std::ptrdiff_t s, int beams, std::uint8_t* __restrict out) {
    for (int j = -1; j <= beams; ++j) out[j] = (jump[j] <= 1.0F) & (solid[j] * solid[j + s] > 0) ? 1 : 0;
}

// Lines with a longer or shorter step between them are not linked.
void unlink(Extra extra, int beams, std::uint8_t* links) {
    for (int j = -1; j <= beams; ++j) links[j] = extra.of(j) == 0.0F ? links[j] : 0;
}

EDGESCAN_INLINE void nearerOfLine(const float* u, const float* jump, std::ptrdiff_t s, int beams, float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float behind = u[j] >= u[j + s] ? jump[j] : 0.0F;
        const float before = u[j] > u[j - s] ? jump[j - s] : 0.0F;
        out[j] = std::max(behind, before);
    }
}

EDGESCAN_INLINE void smoothLine(const float* u, const std::uint8_t* link, std::ptrdiff_t s, int beams, float quarter,
                                float* __restrict out) {
    for (int j = 0; j < beams; ++j) {
        const float linked = (link[j] & link[j - s]) != 0 ? quarter : 0.0F;
        out[j] = u[j] + linked * (u[j - s] + u[j + s] - 2 * u[j]);
    }
}

} // namespace

void crackJumps(const DepthField& field, Along along, int line, const float* angle, const SweepSlips& slips, const DepthLimits& limits,
                Lines& jumps) {
    const Extra extra{extraAt(slips, along, line, 0), extraAt(slips, along, line, 1)};
    vectorised<jumpsOfLine>({field.u.line(line), field.solid.line(line), angle, field.step(along)}, field.u.beams, extra, limits,
                            weightsAt(limits.noisy), jumps.next());
}

void surfaceLinks(const DepthField& field, const Lines& jumps, Along along, int line, const SweepSlips& slips, Links& links) {
    const Extra extra{extraAt(slips, along, line, 0), extraAt(slips, along, line, 1)};
    std::uint8_t* out = links.next();
    vectorised<linksOfLine>(jumps.line(line), field.solid.line(line), field.step(along), field.u.beams, out);
    if (extra.even != 0 || extra.odd != 0) unlink(extra, field.u.beams, out);
}

void jumpsOnNearerCells(const DepthField& field, const Lines& jumps, Along along, int line, Lines& cells) {
    vectorised<nearerOfLine>(field.u.line(line), jumps.line(line), field.step(along), field.u.beams, cells.next());
}

void smoothSurfaces(const Lines& u, const Links& links, Along along, int line, float share, Lines& smooth) {
    vectorised<smoothLine>(u.line(line), links.line(line), stepOf(u, along), u.beams, 0.25F * share, smooth.next());
}

} // namespace edgescan::edges
