// Examines voids along every line and every beam: which end is nearer, and whether its surface ends there.
#include "core/edges/edgescan_plus/silhouettes.h"

#include "core/base/simd.h"
#include "core/edges/edgescan_plus/surface_end.h"
#include "core/scan/grid/marked_cells.h"

#include <algorithm>

namespace edgescan::edges {
namespace {

constexpr float kSure = 1;      // jump thresholds
constexpr float kSteep = 2.75F; // tangent of 70 degrees
constexpr float kBend = 0.25F;  // tangent of the angle by which a surface may bend across the void
constexpr int kBridged = 4;     // longest gap that step 1 may have filled, cells

// The least distance in mm from the near to the far end of a void of `cells` at an outline.
float leastBehindMm(float farMm, int cells, float angle, const DepthLimits& limits) {
    return kSure * limits.jumpAt(farMm) + kBend * static_cast<float>(cells + 1) * angle * farMm;
}

// Whether the surface of `near` ends before the void of `cells` and the other surface is behind it.
bool isOutline(const SurfaceEnd& near, const SurfaceEnd& far, int cells, float angle, const DepthLimits& limits) {
    if (!near.known || !far.known || near.slants(angle, kSteep)) return false;
    const auto steps = static_cast<float>(cells + 1);
    const float continued = near.u + steps * near.slope; // next to the far end
    const float backwards = far.u + steps * far.slope;   // next to the near end
    if (continued <= 0) return false;
    const float farMm = 1000 / far.u;
    const float least = leastBehindMm(farMm, cells, angle, limits);
    const bool behind = farMm - 1000 / near.u > least && farMm - 1000 / continued > least;
    return behind && (backwards <= 0 || 1000 / backwards - 1000 / near.u > least);
}

// Examines a void between two cells of a way.
void lookAtVoid(const Way& way, int before, int after, const DepthLimits& limits, Grid<std::uint8_t>& marked) {
    const bool first = way.u(before) >= way.u(after);
    const int at = first ? before : after;
    if (way.inverse.support[way.cell(at)] != Support::Measured) return;
    // Most gaps are on one surface: what isOutline() asks of the two ranges alone comes before the lines are fitted.
    const int behind = first ? after : before;
    const float farMm = 1000 / way.u(behind);
    if (!(farMm - 1000 / way.u(at) > leastBehindMm(farMm, after - before - 1, way.angle(at), limits))) return;
    const SurfaceEnd near = surfaceEnd(way, at, first ? -1 : 1, limits);
    const SurfaceEnd far = surfaceEnd(way, behind, first ? 1 : -1, limits);
    if (isOutline(near, far, after - before - 1, way.angle(at), limits)) marked[way.cell(at)] = 1;
}

// Examines a filled gap that ends before cell `after`: it may contain a jump, distributed over so many cells that no single cell shows it.
void lookAtBridge(const Way& way, int after, const DepthLimits& limits, Grid<std::uint8_t>& marked) {
    int before = after - 1;
    while (before >= std::max(0, after - 1 - kBridged) && way.inverse.support[way.cell(before)] == Support::Filled) --before;
    if (before >= std::max(0, after - 1 - kBridged) && way.inverse.support[way.cell(before)] == Support::Measured)
        lookAtVoid(way, before, after, limits, marked);
}

// 1 where a void ends.
EDGESCAN_INLINE void markVoidEnds(const Support* before, const Support* here, int cells, std::uint8_t* __restrict ends) {
    for (int n = 0; n < cells; ++n) ends[n] = static_cast<std::uint8_t>((before[n] == Support::Void) & (here[n] != Support::Void));
}

// 1 where a filled gap ends.
EDGESCAN_INLINE void markBridgeEnds(const Support* before, const Support* here, int cells, std::uint8_t* __restrict ends) {
    for (int n = 0; n < cells; ++n) ends[n] = static_cast<std::uint8_t>((before[n] == Support::Filled) & (here[n] == Support::Measured));
}

EDGESCAN_INLINE void updateLastSolid(const Support* support, int line, int beams, std::int32_t* __restrict last) {
    for (int j = 0; j < beams; ++j) last[j] = support[j] != Support::Void ? line : last[j];
}

void markAlongBeams(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits, Grid<std::uint8_t>& marked) {
    const int beams = inverse.u.beams;
    std::vector<std::uint8_t> ends(static_cast<std::size_t>(std::max(0, beams - 1)));
    for (int i = 0; i < inverse.u.lines; ++i) {
        const Support* support = inverse.support.line(i);
        vectorised<markVoidEnds>(support, support + 1, beams - 1, ends.data());
        forEachMarked(ends, [&](std::size_t n) {
            int before = static_cast<int>(n);
            while (before >= 0 && support[before] == Support::Void) --before;
            // The surface beyond the border of the grid is unknown.
            if (before >= 0) lookAtVoid({inverse, steps, Along::Beams, i, beams}, before, static_cast<int>(n) + 1, limits, marked);
        });
        vectorised<markBridgeEnds>(support, support + 1, beams - 1, ends.data());
        forEachMarked(ends, [&](std::size_t n) {
            lookAtBridge({inverse, steps, Along::Beams, i, beams, true}, static_cast<int>(n) + 1, limits, marked);
        });
    }
}

void markAlongLines(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits, Grid<std::uint8_t>& marked) {
    const int beams = inverse.u.beams;
    std::vector<std::uint8_t> ends(static_cast<std::size_t>(beams));
    std::vector<std::int32_t> last(ends.size(), -1);
    for (int i = 0; i < inverse.u.lines; ++i) {
        const Support* support = inverse.support.line(i);
        if (i > 0) {
            vectorised<markVoidEnds>(inverse.support.line(i - 1), support, beams, ends.data());
            forEachMarked(ends, [&](std::size_t n) {
                if (last[n] >= 0)
                    lookAtVoid({inverse, steps, Along::Lines, static_cast<int>(n), inverse.u.lines}, last[n], i, limits, marked);
            });
            vectorised<markBridgeEnds>(inverse.support.line(i - 1), support, beams, ends.data());
            forEachMarked(ends, [&](std::size_t n) {
                lookAtBridge({inverse, steps, Along::Lines, static_cast<int>(n), inverse.u.lines, true}, i, limits, marked);
            });
        }
        vectorised<updateLastSolid>(support, i, beams, last.data());
    }
}

} // namespace

std::vector<std::uint32_t> silhouetteCells(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits) {
    Grid<std::uint8_t> marked(inverse.u.lines, inverse.u.beams);
    markAlongBeams(inverse, steps, limits, marked);
    markAlongLines(inverse, steps, limits, marked);
    std::vector<std::uint32_t> cells;
    forEachMarked(marked.cells, [&cells](std::size_t k) { cells.push_back(static_cast<std::uint32_t>(k)); });
    return cells;
}

} // namespace edgescan::edges
