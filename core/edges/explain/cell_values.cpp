// All values of one cell.
#include "core/edges/explain/cell_values.h"

#include "core/edges/gray/gray.h"
#include "core/scan/gap_filling/gap_filling.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan::edges {

Probe probeCell(const Detection& detection, std::size_t k) {
    const Scan& scan = *detection.scan;
    const auto beams = static_cast<std::size_t>(scan.beams());
    Probe probe;
    probe.cell = static_cast<std::uint32_t>(k);
    probe.line = static_cast<int>(k / beams);
    probe.beam = static_cast<int>(k % beams);
    if (const auto* polar = std::get_if<PolarGeometry>(&scan.geometry)) {
        probe.lineDeg = polar->lineDeg[k / beams];
        probe.beamDeg = polar->beamDeg[k % beams];
    }
    probe.state = scan.state[k];
    probe.rangeMm = scan.rangeMm[k];
    if (const FilledCell* filled = detection.filled ? detection.filled->at(k) : nullptr) probe.filled = *filled;
    probe.gray = detection.gray->levels[k];
    probe.pointM = pointOfCell(scan, k);
    if (scan.placement && probe.state == CellState::Valid) probe.mineM = minePoint(scan, k).enhM;
    probe.edge = (*detection.mask)[k] != 0;
    if (detection.classes) probe.kind = (*detection.classes)[k];
    return probe;
}

} // namespace edgescan::edges
