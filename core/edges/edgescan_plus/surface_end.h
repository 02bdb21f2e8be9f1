// Where a surface ends before missing data, along a line or along a beam.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

#include <cstddef>

namespace edgescan::edges {

/// The cells of one line in beam order, or of one beam in line order.
struct Way {
    const InverseRange& inverse;
    const AngularSteps& steps;
    Along along;
    int at;               ///< line or beam
    int count;            ///< number of cells
    bool bridged = false; ///< filled gaps are examined, too: a surface may end at them

    [[nodiscard]] std::size_t cell(int n) const { return along == Along::Beams ? inverse.u.index(at, n) : inverse.u.index(n, at); }
    [[nodiscard]] bool isVoid(int n) const {
        const Support support = inverse.support[cell(n)];
        return support == Support::Void || (bridged && support == Support::Filled);
    }
    [[nodiscard]] float u(int n) const { return inverse.u[cell(n)]; }
    [[nodiscard]] float angle(int n) const { return along == Along::Beams ? steps.beam[static_cast<std::size_t>(n)] : steps.lineAt(n, at); }
};

/// The surface that ends at a cell: its slope of u per cell towards the void; unknown if there are too few cells or a break.
struct SurfaceEnd {
    float u = 0, slope = 0;
    bool known = false;

    /// Whether the surface slants by more than this tangent. `angle`: of one index step.
    [[nodiscard]] bool slants(float angle, float tangent) const;
};

/// `awayFromVoid`: 1 or -1, the direction of the surface's cells; up to five of them, up to a jump.
[[nodiscard]] SurfaceEnd surfaceEnd(const Way& way, int n, int awayFromVoid, const DepthLimits& limits);

} // namespace edgescan::edges
