// Mixed pixels.
#include "core/edges/veil.h"

#include "core/edges/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr int kLongestRun = 3;
constexpr float kSpotM = 0.013F;
constexpr float kSpotRad = 0.0046F;
constexpr float kSurfacesApart = 2.0F; // jump thresholds
constexpr float kBend = 0.25F;         // of the least distance of the surfaces
constexpr float kOffSurface = 0.5F;    // jump thresholds, for one cell of a run at least

float gapMm(float u, float v) { return std::abs(1000.0F / u - 1000.0F / v); }

bool solidAll(const float* solid, std::ptrdiff_t step, int from, int to) {
    for (int n = from; n <= to; ++n) {
        if (solid[n * step] == 0) return false;
    }
    return true;
}

/// One place of a line: u and solid point at the cell.
struct Place {
    const float* u;
    const float* solid;
    std::ptrdiff_t step;
};

// The cell alone.
bool snapOne(const Place& at, const DepthLimits& limits, float& result) {
    if (!solidAll(at.solid, at.step, -2, 2)) return false;
    const float before = 2 * at.u[-at.step] - at.u[-2 * at.step];
    const float after = 2 * at.u[at.step] - at.u[2 * at.step];
    const float u = *at.u;
    if (before <= 0 || after <= 0 || u <= std::min(before, after) || u >= std::max(before, after)) return false;
    const float allowed = limits.jumpAt(1000.0F / u);
    const float toBefore = gapMm(before, u);
    const float toAfter = gapMm(after, u);
    if (toBefore <= allowed || toAfter <= allowed) return false;
    result = toBefore < toAfter ? before : after;
    return true;
}

// Slope of u per step away from the run, over two steps where there are two.
float slopeAway(const Place& at, int end, int sign) {
    const auto u = [&](int n) { return at.u[(end + sign * n) * at.step]; };
    return at.solid[(end + 2 * sign) * at.step] != 0 ? 0.5F * (u(2) - u(0)) : u(1) - u(0);
}

// `count` cells from here on.
bool snapRun(const Place& at, int count, const DepthLimits& limits, std::array<float, kLongestRun>& result) {
    if (!solidAll(at.solid, at.step, -2, count + 1)) return false;
    const float first = at.u[-at.step];
    const float last = at.u[count * at.step];
    const float slopeBefore = slopeAway(at, -1, -1);
    const float slopeAfter = slopeAway(at, count, 1);
    float farthest = 0;
    for (int n = 0; n < count; ++n) {
        const float u = at.u[n * at.step];
        const float before = first - static_cast<float>(n + 1) * slopeBefore;
        const float after = last - static_cast<float>(count - n) * slopeAfter;
        if (before <= 0 || after <= 0 || u <= std::min(before, after) || u >= std::max(before, after)) return false;
        const float allowed = limits.jumpAt(1000.0F / std::max(before, after));
        if (std::min(gapMm(before, after), gapMm(first, last)) < kSurfacesApart * allowed) return false;
        const float toBefore = gapMm(before, u);
        const float toAfter = gapMm(after, u);
        farthest = std::max(farthest, std::min(toBefore, toAfter) / allowed);
        result[static_cast<std::size_t>(n)] = toBefore <= toAfter ? before : after;
    }
    return farthest >= kOffSurface;
}

// 1 where the surfaces on both sides can be two thresholds apart at all; on a smooth surface they are not, and that is most cells.
EDGESCAN_VECTORS void markWorthwhile(const float* u, std::ptrdiff_t step, const DepthLimits& limits, std::vector<std::uint8_t>& worth) {
    const float apart = 0.001F * kSurfacesApart * limits.jumpMm;
    const int count = static_cast<int>(worth.size());
    std::uint8_t* out = worth.data();
    for (int j = 0; j < count; ++j) {
        const float before = 2 * u[j - step] - u[j - 2 * step];
        const float after = 2 * u[j + step] - u[j + 2 * step];
        const float first = u[j - step];
        const float second = u[j + 2 * step];
        const float third = u[j + 3 * step];
        const bool one = std::abs(before - after) > apart * before * after;
        // The ends of a run must be apart, and its first cell off a line through them.
        const bool bent =
            std::abs(u[j - 2 * step] - 2 * first + u[j]) + std::abs(u[j + step] - 2 * u[j] + first) > kBend * apart * u[j] * u[j];
        const bool two = (std::abs(first - second) > apart * first * second) & bent;
        const bool three = (std::abs(first - third) > apart * first * third) & bent;
        out[j] = static_cast<std::uint8_t>(one | two | three);
    }
}

} // namespace

void snapVeils(DepthField& field, const InverseRange& inverse, const AngularSteps& steps, Along along, const DepthLimits& limits) {
    const std::ptrdiff_t step = field.step(along);
    const PaddedGrid<float> from = field.u;
    std::vector<std::uint8_t> worth(static_cast<std::size_t>(from.beams));
    for (int i = 0; i < from.lines; ++i) {
        markWorthwhile(from.line(i), step, limits, worth);
        const float* angle = anglesOf(steps, along, i);
        const Support* support = inverse.support.line(i);
        float* out = field.u.line(i);
        for (int j = 0; j < from.beams; ++j) {
            if (worth[static_cast<std::size_t>(j)] == 0 || support[j] == Support::Void) continue;
            const Place at{from.line(i) + j, field.solid.line(i) + j, step};
            if (snapOne(at, limits, out[j])) continue;
            const float rangeM = 1.0F / at.u[0];
            const float cell = rangeM * angle[j];
            const float spot = kSpotM + kSpotRad * rangeM;
            std::array<float, kLongestRun> run{};
            for (int count = 2; count <= kLongestRun && static_cast<float>(count) * cell <= spot; ++count) {
                if (!snapRun(at, count, limits, run)) continue;
                for (int n = 0; n < count; ++n) out[j + n * step] = run[static_cast<std::size_t>(n)];
                break;
            }
        }
    }
}

} // namespace edgescan
