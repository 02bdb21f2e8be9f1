// The edges of both views of a turn, drawn over each other (docs/calibration.md, "The seam").
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/scan/georef/assembly.h"

#include <vector>

namespace edgescan {

/// Where the late view of a turn looks at what the early one saw before.
struct SeamEdges {
    int firstLine = 0;              ///< of the scan: row 0 of both grids
    std::vector<int> beams;         ///< of the scan: the columns of both grids; of a sweep those at the ends of its axis
    Grid<std::uint8_t> late, early; ///< lines of the late view x beams, 1 = edge; the early view's lie where the late one would see them
    std::size_t lateEdges = 0;      ///< that the early view could have seen too
    std::size_t met = 0;            ///< of these, with an edge of the early view not more than a cell away in either direction

    [[nodiscard]] double metShare() const { return lateEdges == 0 ? 0.0 : static_cast<double>(met) / static_cast<double>(lateEdges); }
};

/// `edges`: lines x beams of the scan, not 0 = edge; cells without a range and nearer than 4 degrees to the axis (sweep: .5) are left out.
/// Empty grids where nothing is seen twice: no angles, a turn of 180 degrees, a sweep whose fan ends at the axis.
[[nodiscard]] SeamEdges seamEdges(const Scan& scan, const Grid<std::uint8_t>& edges, const AssemblyErrors& errors);

/// Three pixels a cell: a lying orange bar is an edge of the late view, a standing blue one of the early view, a white cross of both.
[[nodiscard]] Grid<Rgb> seamPicture(const SeamEdges& seam);

} // namespace edgescan
