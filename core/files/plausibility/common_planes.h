// Whether angles and mounting can be right: pieces of a wall or a floor are on one plane only then.
#pragma once

#include "core/scan/grid/scan.h"

namespace edgescan::files {

/// Flat pieces of the sweep, about 5 degrees wide each way, and how many of them lie on the three planes that hold most.
struct CommonPlanes {
    int pieces = 0;
    int onPlanes = 0;
    bool operator==(const CommonPlanes&) const = default;
};

/// As the points lie with these angles; `geometry` has as many lines and beams as the scan. The pieces are those of the scan's own angles.
/// Some tens of milliseconds.
[[nodiscard]] CommonPlanes commonPlanes(const Scan& scan, const PolarGeometry& geometry);

/// So many more that chance and rough ground cannot be the reason.
[[nodiscard]] bool clearlyFlatter(const CommonPlanes& other, const CommonPlanes& now);

} // namespace edgescan::files
