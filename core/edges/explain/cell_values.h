// All values of one cell, for the status bar and for copying.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "core/scan/grid/scan.h"

#include <optional>

namespace edgescan::edges {

struct Probe {
    std::uint32_t cell = 0; ///< k = line * beams + beam
    int line = 0;
    int beam = 0;
    double beamDeg = kAutomatic; ///< NaN for an organised cloud
    double lineDeg = kAutomatic;
    CellState state = CellState::NoReturn;
    double rangeMm = 0.0; ///< raw value times unit; a range only if state is Valid
    int gray = 0;
    std::optional<FilledCell> filled{};   ///< the value that fills its gap; not measured
    Eigen::Vector3d pointM;               ///< scanner frame, metres; NaN where not valid
    std::optional<Eigen::Vector3d> mineM; ///< Easting, Northing, Elevation; empty if the scan has no pose
    bool edge = false;
    DepthEdge kind = DepthEdge::None; ///< class of an edge, if the method distinguishes classes
};

/// `k` must be a cell of the detection's scan.
[[nodiscard]] Probe probeCell(const Detection& detection, std::size_t k);

} // namespace edgescan::edges
