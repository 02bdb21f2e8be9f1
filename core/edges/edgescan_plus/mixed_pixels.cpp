// Mixed pixels.
#include "core/edges/edgescan_plus/mixed_pixels.h"

#include "core/base/simd.h"
#include "core/scan/grid/beam_width.h"
#include "core/scan/grid/marked_cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

namespace edgescan::edges {
namespace {

using RunValues = std::array<float, kLongestRun>;
constexpr auto kSpotM = static_cast<float>(BeamWidth{}.atExitM);
constexpr auto kSpotRad = static_cast<float>(BeamWidth{}.growthRad);
constexpr float kSurfacesApart = 1.6F; // jump thresholds, ...
constexpr float kFartherApart = 2.0F;  // ... and where the spot does not grow
constexpr float kBend = 0.25F;         // share of the least distance between the surfaces
constexpr float kLeastOfSpot = 0.5F;   // least width of a run of more than two cells
constexpr float kOffSurface = 0.5F;    // jump thresholds, for at least one cell of a run

// The first pass avoids divisions. Its limits are slightly wider, so that rounding never drops a cell that the exact check would accept.
constexpr float kLenient = 0.999F;   // of the required distance
constexpr float kRounding = 1e-6F;   // of u
constexpr float kWiderSpot = 1.001F; // times the spot

float gapMm(float u, float v) { return std::abs(1000.0F / u - 1000.0F / v); }

bool solidAll(const float* solid, std::ptrdiff_t step, int from, int to) {
    for (int n = from; n <= to; ++n) {
        if (solid[n * step] == 0) return false;
    }
    return true;
}

/// A position on a line: pointers to u and to the solid flags at the cell.
struct Place {
    const float* u;
    const float* solid;
    std::ptrdiff_t step;
};

// Checks a single cell.
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

// Longer runs have longer lines on both sides: those of three cells are too noisy to be continued so far.
constexpr int cellsOfLine(int run) { return run > 3 ? kMixedLine : 3; }
EDGESCAN_INLINE float slopeOfFive(float u0, float u1, float u3, float u4) { return 0.1F * (2 * (u4 - u0) + u3 - u1); }

// Slope of u per step away from a run, over as many cells as are solid: five, three or two. `s`: the step away from it.
template <int kCells>
EDGESCAN_INLINE float slopeAway(const float* u, const float* solid, std::ptrdiff_t s) {
    const float slope = solid[2 * s] != 0 ? 0.5F * (u[2 * s] - u[0]) : u[s] - u[0];
    if constexpr (kCells <= 3) return slope;
    return solid[2 * s] * solid[3 * s] * solid[4 * s] != 0 ? slopeOfFive(u[0], u[s], u[3 * s], u[4 * s]) : slope;
}

// The continuations of both sides at the cells of a run.
struct RunLines {
    RunValues before, after;
};

// Compares two surfaces at a cell without divisions: a distance in metres is the difference of two u divided by their product. If rounding
// could decide, the answer is yes.
struct TwoSurfaces {
    float farther, nearer; // u
    float allowed;         // jump threshold, as a difference of u divided by the u of the farther surface
    float rounding;
    float apart; // jump thresholds
};
EDGESCAN_INLINE float apartOf(const DepthLimits& limits) { return limits.spotGrows ? kSurfacesApart : kFartherApart; }
EDGESCAN_INLINE TwoSurfaces surfacesAt(float before, float after, const DepthLimits& limits) {
    const float nearer = std::max(before, after);
    return {std::min(before, after), nearer, kLenient * (0.001F * limits.jumpMm * nearer + limits.growth), kRounding * nearer,
            apartOf(limits)};
}
EDGESCAN_INLINE bool areApart(const TwoSurfaces& at) { return at.nearer - at.farther + at.rounding >= at.apart * at.farther * at.allowed; }
EDGESCAN_INLINE bool canBeBetween(float u, const TwoSurfaces& at) {
    return (at.farther > 0) & (u > at.farther) & (u < at.nearer) & areApart(at);
}
EDGESCAN_INLINE bool canBeOff(float u, const TwoSurfaces& at, float thresholds) {
    const float least = thresholds * u * at.allowed;
    return (at.nearer - u + at.rounding >= least) & ((u - at.farther + at.rounding) * at.nearer >= least * at.farther);
}

bool canBeRun(const Place& at, int run, const RunLines& lines, const DepthLimits& limits) {
    bool off = false;
    for (int n = 0; n < run; ++n) {
        const float u = at.u[n * at.step];
        const TwoSurfaces surfaces =
            surfacesAt(lines.before[static_cast<std::size_t>(n)], lines.after[static_cast<std::size_t>(n)], limits);
        if (!canBeBetween(u, surfaces)) return false;
        off = off || canBeOff(u, surfaces, kOffSurface);
    }
    return off;
}

// Checks a run of cells that begins here.
bool snapRun(const Place& at, int run, const DepthLimits& limits, RunValues& result) {
    if (!solidAll(at.solid, at.step, -2, run + 1)) return false;
    const float first = at.u[-at.step];
    const float last = at.u[run * at.step];
    const auto slopeFrom = [&](int end, std::ptrdiff_t step) {
        const float *u = at.u + end * at.step, *solid = at.solid + end * at.step;
        return cellsOfLine(run) > 3 ? slopeAway<kMixedLine>(u, solid, step) : slopeAway<3>(u, solid, step);
    };
    const float slopeBefore = slopeFrom(-1, -at.step), slopeAfter = slopeFrom(run, at.step);
    RunLines lines{};
    for (int n = 0; n < run; ++n) {
        lines.before[static_cast<std::size_t>(n)] = first - static_cast<float>(n + 1) * slopeBefore;
        lines.after[static_cast<std::size_t>(n)] = last - static_cast<float>(run - n) * slopeAfter;
    }
    if (!canBeRun(at, run, lines, limits)) return false;
    float farthest = 0;
    for (int n = 0; n < run; ++n) {
        const float u = at.u[n * at.step];
        const float before = lines.before[static_cast<std::size_t>(n)];
        const float after = lines.after[static_cast<std::size_t>(n)];
        const float allowed = limits.jumpAt(1000.0F / std::max(before, after));
        if (std::min(gapMm(before, after), gapMm(first, last)) < apartOf(limits) * allowed) return false;
        const float toBefore = gapMm(before, u);
        const float toAfter = gapMm(after, u);
        farthest = std::max(farthest, std::min(toBefore, toAfter) / allowed);
        result[static_cast<std::size_t>(n)] = toBefore <= toAfter ? before : after;
    }
    return farthest >= kOffSurface;
}

// Whether the surfaces on both sides of a cell can be two thresholds apart. On a smooth surface they cannot.
bool isWorthwhile(const Place& at, const DepthLimits& limits) {
    const auto u = [&](int n) { return at.u[n * at.step]; };
    const float apart = 0.001F * apartOf(limits) * limits.jumpMm;
    const float before = 2 * u(-1) - u(-2);
    const float after = 2 * u(1) - u(2);
    if (std::abs(before - after) > apart * before * after) return true;
    // The ends of a run must be far enough apart, and its first cell must be off a line through them.
    return std::abs(u(-1) - u(2)) > apart * u(-1) * u(2) &&
           std::abs(u(-2) - 2 * u(-1) + u(0)) + std::abs(u(1) - 2 * u(0) + u(-1)) > kBend * apart * u(0) * u(0);
}

// The continuations of the lines of both sides at the first and at the last cell of a run.
struct RunLook {
    TwoSurfaces first, last;
};
template <int kRun>
EDGESCAN_INLINE RunLook lookAtRun(const float* u, const float* solid, std::ptrdiff_t s, const DepthLimits& limits) {
    constexpr auto kCells = static_cast<float>(kRun);
    const float b1 = u[-s], a1 = u[kRun * s];
    const float slopeBefore = slopeAway<cellsOfLine(kRun)>(u - s, solid - s, -s);
    const float slopeAfter = slopeAway<cellsOfLine(kRun)>(u + kRun * s, solid + kRun * s, s);
    return {surfacesAt(b1 - slopeBefore, a1 - kCells * slopeAfter, limits), surfacesAt(b1 - kCells * slopeBefore, a1 - slopeAfter, limits)};
}

// Width of the spot as a share of the range; slightly more.
EDGESCAN_INLINE float spotAt(float u) { return kWiderSpot * (kSpotM * u + kSpotRad); }

// The neighbours of a cell, and the continuations of the lines of both sides: at the cell itself if it may be a single mixed pixel, and at
// it and the next one if these may be a run.
struct FirstLook {
    float here, next;
    float spot;
    TwoSurfaces alone;
    RunLook two;
};
EDGESCAN_INLINE FirstLook lookAt(const float* u, const float* solid, std::ptrdiff_t s, const DepthLimits& limits) {
    return {u[0], u[s], spotAt(u[0]), surfacesAt(2 * u[-s] - u[-2 * s], 2 * u[s] - u[2 * s], limits), lookAtRun<2>(u, solid, s, limits)};
}

constexpr int kLookBlock = 32;

// How far the lines of both sides are apart at the first cell of a run, if all cells of them are solid.
template <int kRun>
EDGESCAN_INLINE float gapOfLines(const float* at, std::ptrdiff_t s) {
    const float *before = at - s, *after = at + kRun * s;
    if constexpr (cellsOfLine(kRun) > 3) {
        const float slopeBefore = slopeOfFive(before[0], before[-s], before[-3 * s], before[-4 * s]);
        return std::abs(before[0] - slopeBefore - (after[0] - kRun * slopeOfFive(after[0], after[s], after[3 * s], after[4 * s])));
    }
    return std::abs((before[0] - 0.5F * (before[-2 * s] - before[0])) - (after[0] - 0.5F * kRun * (after[2 * s] - after[0])));
}

// A cheaper look at cells of which none can begin a run, or be mixed alone: a cell between two surfaces is at most as far from each as they
// are from each other, so that its own u serves in place of theirs. The factors leave room for rounding. False where a line runs through
// cells that are not solid.
template <int kRun, class Count>
EDGESCAN_INLINE bool noneCanBeMixed(const float* u, const float* solid, std::ptrdiff_t s, Count cells, const DepthLimits& limits) {
    constexpr float kMore = 1.00001F, kLess = 0.99999F;
    const float perMetre = apartOf(limits) * kLenient * 0.001F * limits.jumpMm;
    const float growth = apartOf(limits) * kLenient * limits.growth;
    std::int32_t any = 0, all = -1;
    for (int j = 0; j < cells; ++j) {
        const float* at = u + j;
        float apart = gapOfLines<kRun>(at, s);
        if constexpr (kRun == 2) apart = std::max(apart, std::abs((2 * at[-s] - at[-2 * s]) - (2 * at[s] - at[2 * s])));
        const float allowed = perMetre * at[0] + growth;
        any |= apart * (kMore + allowed) >= at[0] * (kLess * allowed - 2 * kRounding) ? -1 : 0;
    }
    if (any != 0) return false;
    for (int n = 3; n <= cellsOfLine(kRun); ++n) {
        for (int j = 0; j < cells; ++j)
            all &= std::bit_cast<std::int32_t>(solid[j - n * s]) & std::bit_cast<std::int32_t>(solid[j + (kRun + n - 1) * s]);
    }
    return all == std::bit_cast<std::int32_t>(1.0F);
}

template <class Count>
EDGESCAN_INLINE void lookAtBlock(const float* u, const float* solid, const float* angle, std::ptrdiff_t s, Count cells,
                                 const DepthLimits& limits, std::uint8_t* __restrict marked) {
    std::array<float, kLookBlock> worth;
    for (int j = 0; j < cells; ++j) {
        const FirstLook at = lookAt(u + j, solid + j, s, limits);
        const bool one = canBeBetween(at.here, at.alone) & canBeOff(at.here, at.alone, 1);
        const bool two = canBeBetween(at.here, at.two.first) & canBeBetween(at.next, at.two.last) &
                         (canBeOff(at.here, at.two.first, kOffSurface) | canBeOff(at.next, at.two.last, kOffSurface)) &
                         (2 * angle[j] <= at.spot);
        worth[j] = (one | two) & (solid[j] != 0) ? 1.0F : 0.0F;
    }
    for (int j = 0; j < cells; ++j) marked[j] = worth[j] != 0 ? 1 : 0;
}

// Whether a run of this many cells is between half and the whole of the spot; `inSpot`: the cells that fill the spot, slightly more.
EDGESCAN_INLINE bool canFill(float mostInSpot, float leastInSpot, float cells) {
    return (cells <= mostInSpot) & (kLeastOfSpot * leastInSpot <= kWiderSpot * kWiderSpot * cells);
}

// Marks the cells at which a run of kRun cells or more may begin: bit n - 2 is for a run of n cells.
template <int kRun, class Count>
EDGESCAN_INLINE void markRuns(const float* u, const float* solid, std::ptrdiff_t s, Count cells, const DepthLimits& limits,
                              const float* inSpot, float most, float least, std::uint8_t* __restrict marked) {
    if constexpr (kRun <= kLongestRun) {
        if (most < kRun) return;
        const bool none = !canFill(most, least, kRun) || noneCanBeMixed<kRun>(u, solid, s, cells, limits);
        for (int j = 0; !none && j < cells; ++j) {
            const RunLook look = lookAtRun<kRun>(u + j, solid + j, s, limits);
            const bool run = canBeBetween(u[j], look.first) & canBeBetween(u[j + (kRun - 1) * s], look.last) &
                             canFill(inSpot[j], inSpot[j], kRun) & (solid[j] != 0);
            marked[j] |= run ? 1U << (kRun - 2) : 0U;
        }
        markRuns<kRun + 1>(u, solid, s, cells, limits, inSpot, most, least, marked);
    }
}

// The same for runs of more than two cells. As integers, positive floats have the same order, and loops of them are vectorised.
template <class Count>
EDGESCAN_INLINE void markRunsOfBlock(const float* u, const float* solid, const float* angle, std::ptrdiff_t s, Count cells,
                                     const DepthLimits& limits, std::uint8_t* __restrict marked) {
    std::array<float, kLookBlock> inSpot;
    std::int32_t most = 0, least = std::numeric_limits<std::int32_t>::max();
    for (int j = 0; j < cells; ++j) inSpot[j] = spotAt(u[j]) / angle[j];
    for (int j = 0; j < cells; ++j) most = std::max(most, std::bit_cast<std::int32_t>(inSpot[j]));
    for (int j = 0; j < cells; ++j) least = std::min(least, std::bit_cast<std::int32_t>(inSpot[j]));
    markRuns<3>(u, solid, s, cells, limits, inSpot.data(), std::bit_cast<float>(most), std::bit_cast<float>(least), marked);
}

// First pass over some cells: 1 at every cell that the full check could move, and at a few more.
EDGESCAN_INLINE void markCandidates(const float* u, const float* solid, const float* angle, std::ptrdiff_t s, int cells,
                                    const DepthLimits& limits, std::uint8_t* __restrict marked) {
    constexpr auto kCount = std::integral_constant<int, kLookBlock>();
    std::memset(marked, 0, static_cast<std::size_t>(cells));
    int j = 0;
    for (; j + kLookBlock <= cells; j += kLookBlock) {
        if (!noneCanBeMixed<2>(u + j, solid + j, s, kCount, limits))
            lookAtBlock(u + j, solid + j, angle + j, s, kCount, limits, marked + j);
    }
    lookAtBlock(u + j, solid + j, angle + j, s, cells - j, limits, marked + j);
}

// Runs of more than two cells that may begin in a line. The last block overlaps the one before.
EDGESCAN_INLINE void markLongRuns(const float* u, const float* solid, const float* angle, std::ptrdiff_t s, int cells,
                                  const DepthLimits& limits, std::uint8_t* __restrict marked) {
    if (cells < kLookBlock) return markRunsOfBlock(u, solid, angle, s, cells, limits, marked);
    for (int from = 0; from < cells; from += kLookBlock) {
        const int j = std::min(from, cells - kLookBlock);
        markRunsOfBlock(u + j, solid + j, angle + j, s, std::integral_constant<int, kLookBlock>(), limits, marked + j);
    }
}

// The full check of one cell; `angle` of an index step, radians; `marks` of the first pass.
void snapAt(const Place& at, unsigned marks, float angle, const DepthLimits& limits, float* out) {
    const bool worthwhile = (marks & 1U) != 0 && isWorthwhile(at, limits);
    if (worthwhile && snapOne(at, limits, *out)) return;
    const float rangeM = 1.0F / at.u[0];
    const float cell = rangeM * angle;
    const float spot = kSpotM + kSpotRad * rangeM;
    const int longest = limits.spotGrows ? kLongestRun : 2;
    RunValues values{};
    for (int run = worthwhile ? 2 : 3; run <= longest && static_cast<float>(run) * cell <= spot; ++run) {
        const bool narrow = run > 2 && static_cast<float>(run) * cell < kLeastOfSpot * spot;
        if (narrow || (marks >> (run - 2) & 1U) == 0 || !snapRun(at, run, limits, values)) continue;
        for (int n = 0; n < run; ++n) out[n * at.step] = values[static_cast<std::size_t>(n)];
        return;
    }
}

} // namespace

void snapMixedPixels(const DepthField& field, Along along, int line, const float* angle, const DepthLimits& limits, Lines& snapped) {
    const std::ptrdiff_t step = field.step(along);
    const float* u = field.u.line(line);
    const float* solid = field.solid.line(line);
    float* out = snapped.line(line);
    constexpr int kTogether = 1024; // cells checked in a first pass before the first of them gets the full check
    std::array<std::uint8_t, kTogether> marked;
    for (int from = 0; from < field.u.beams; from += kTogether) {
        const int cells = std::min(kTogether, field.u.beams - from);
        vectorised<markCandidates>(u + from, solid + from, angle + from, step, cells, limits, marked.data());
        if (limits.spotGrows) vectorised<markLongRuns>(u + from, solid + from, angle + from, step, cells, limits, marked.data());
        forEachNotZero(std::span<const std::uint8_t>(marked.data(), static_cast<std::size_t>(cells)), [&](std::size_t place) {
            const std::size_t j = static_cast<std::size_t>(from) + place;
            snapAt({u + j, solid + j, step}, marked[place], angle[j], limits, out + j);
        });
    }
}

} // namespace edgescan::edges
