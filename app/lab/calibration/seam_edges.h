// The edges of both views of a sweep, drawn over each other (docs/reference/calibration.md, "The seam").
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/scan/georef/assembly.h"

#include <vector>

namespace edgescan::inspect {

/// The part of the late view of a sweep that the early view saw before.
struct SeamEdges {
    int firstLine = 0; ///< line of the scan that is row 0 of both grids
    /// beams of the scan that are the columns of both grids; for a sweep mounting those at the ends of its axis
    std::vector<int> beams;
    /// lines of the late view x beams, 1 = edge; edges of the early view are at the cells in which the late view would see them
    Grid<std::uint8_t> late, early;
    std::size_t lateEdges = 0; ///< number of edges that the early view could have seen, too
    std::size_t matched = 0;   ///< number of these with an edge of the early view at most one cell away in either direction

    [[nodiscard]] double matchedShare() const {
        return lateEdges == 0 ? 0.0 : static_cast<double>(matched) / static_cast<double>(lateEdges);
    }
};

/// `edges`: lines x beams of the scan, not 0 = edge. Cells without a range, and cells nearer than 4 degrees to the axis (sweep: 0.5), are
/// left out. Empty grids if nothing is seen twice: no angles, a turn of 180 degrees, or a sweep whose fan ends at the axis.
[[nodiscard]] SeamEdges seamEdges(const Scan& scan, const Grid<std::uint8_t>& edges, const AssemblyErrors& errors);

/// Three pixels per cell: a horizontal orange bar is an edge of the late view, a vertical blue bar one of the early view, a white cross one
/// of both.
[[nodiscard]] Grid<Rgb> seamPicture(const SeamEdges& seam);

} // namespace edgescan::inspect
