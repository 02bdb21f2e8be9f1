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

// A first look without divisions, which lets all pass that the closer look could snap; most cells it does not.
constexpr float kLenient = 0.999F;     // of what a difference of ranges must be: rounding differs here and there
constexpr float kRounding = 1e-6F;     // of the values themselves
constexpr float kLenientSpot = 1.001F; // times the spot

/// Jump threshold as a difference of inverse ranges: for a surface at u, times the other surface's u.
struct FirstLook {
    float jumpM;
    float growth;
    [[nodiscard]] float allowed(float u) const { return jumpM * u + growth; }
};

// The lines of two surfaces, continued to the cell: it is strictly between them, and they are two thresholds apart there.
inline __attribute__((always_inline)) bool canBeBetween(float u, float before, float after, const FirstLook& look) {
    const float least = std::min(before, after);
    const float most = std::max(before, after);
    const float apart = kLenient * kSurfacesApart * least * look.allowed(most);
    return (least > 0) & (u > least) & (u < most) & (most - least + kRounding * (most + least) >= apart);
}

// 1 where a snap is worth a closer look: the surfaces on both sides are apart, and the cell is between them.
EDGESCAN_VECTORS void markWorthwhile(const float* u, const float* solid, const float* angle, std::ptrdiff_t s, int beams,
                                     const DepthLimits& limits, std::uint8_t* __restrict out) {
    const float apart = 0.001F * kSurfacesApart * limits.jumpMm;
    const FirstLook look{0.001F * limits.jumpMm, limits.growth};
    for (int j = 0; j < beams; ++j) {
        const float here = u[j];
        const float before = 2 * u[j - s] - u[j - 2 * s];
        const float after = 2 * u[j + s] - u[j + 2 * s];
        const float first = u[j - s];
        const float second = u[j + 2 * s];
        const float third = u[j + 3 * s];
        // The ends of a run must be apart, and its first cell off a line through them.
        const bool bent = std::abs(u[j - 2 * s] - 2 * first + here) + std::abs(u[j + s] - 2 * here + first) > kBend * apart * here * here;
        const bool oneApart = std::abs(before - after) > apart * before * after;
        const bool twoApart = (std::abs(first - second) > apart * first * second) & bent;
        const bool threeApart = (std::abs(first - third) > apart * first * third) & bent;
        // And so are their lines.
        const float awayBefore = solid[j - 3 * s] != 0 ? 0.5F * (u[j - 3 * s] - first) : u[j - 2 * s] - first;
        const float awaySecond = solid[j + 4 * s] != 0 ? 0.5F * (u[j + 4 * s] - second) : third - second;
        const float awayThird = solid[j + 5 * s] != 0 ? 0.5F * (u[j + 5 * s] - third) : u[j + 4 * s] - third;
        const float spot = kLenientSpot * (kSpotM * here + kSpotRad);
        const bool one = canBeBetween(here, before, after, look);
        const bool two = canBeBetween(here, first - awayBefore, second - 2 * awaySecond, look) & (2 * angle[j] <= spot);
        const bool three = canBeBetween(here, first - awayBefore, third - 3 * awayThird, look) & (3 * angle[j] <= spot);
        const bool solids = solid[j - 2 * s] * solid[j - s] * solid[j] * solid[j + s] * solid[j + 2 * s] != 0;
        out[j] = static_cast<std::uint8_t>((oneApart | twoApart | threeApart) & (one | two | three) & solids);
    }
}

} // namespace

void snapVeils(const DepthField& field, Along along, int line, const float* angle, const DepthLimits& limits, Lines& snapped) {
    const std::ptrdiff_t step = field.step(along);
    const float* u = field.u.line(line);
    const float* solid = field.solid.line(line);
    float* out = snapped.line(line);
    std::vector<std::uint8_t> worth(static_cast<std::size_t>(field.u.beams));
    markWorthwhile(u, solid, angle, step, field.u.beams, limits, worth.data());
    for (auto next = worth.begin(); (next = std::find(next, worth.end(), 1)) != worth.end(); ++next) {
        const auto j = next - worth.begin();
        const Place at{u + j, solid + j, step};
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

} // namespace edgescan
