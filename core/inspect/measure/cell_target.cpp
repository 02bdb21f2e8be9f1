// Collects the values of one cell.
#include "core/inspect/measure/cell_target.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/methods.h"
#include "core/scan/georef/placed_points.h"

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

/// Without a placement the horizon is unknown.
std::optional<Dip> dipAt(const Scan& scan, const edges::Probe& probe, const Eigen::Vector3d& normal) {
    if (!scan.placement) return std::nullopt;
    const Eigen::Vector3d tip = localMinePoint(scan, probe.line, probe.beam, probe.pointM + normal);
    return dipOf(tip - localMinePoint(scan, probe.line, probe.beam, probe.pointM));
}

std::optional<double> strengthAt(const edges::Detection& detection, const edges::Probe& probe) {
    if (!detection.responses) return std::nullopt;
    const double jump = static_cast<double>((*detection.responses->jump)[probe.cell]);
    const double fold = std::abs(static_cast<double>(detection.responses->crease[probe.cell]));
    // The class of such a cell comes from the end of the data or from the surface behind a void, not from a response of the cell.
    if (probe.kind == edges::DepthEdge::Border || probe.kind == edges::DepthEdge::Silhouette || probe.kind == edges::DepthEdge::VoidRim)
        return std::nullopt;
    if (probe.kind == edges::DepthEdge::Jump) return jump;
    if (probe.kind != edges::DepthEdge::None) return fold;
    // Of a cell that is not an edge the stored responses are those after suppression; Why reports the one before.
    const double strongest = edges::rowOf(detection.settings.method).decision.judge(detection, probe.cell).strength;
    return strongest > 0 ? std::optional(strongest) : std::nullopt;
}

} // namespace

RangeNoise noiseOf(const edges::Detection& detection) {
    return detection.surface ? detection.surface->noise : edges::depthSurface(*detection.scan, {}).noise;
}

CellTarget targetAt(const edges::Detection& detection, const RangeNoise& noise, std::size_t k) {
    const Scan& scan = *detection.scan;
    CellTarget target;
    target.probe = edges::probeCell(detection, k);
    target.strength = strengthAt(detection, target.probe);
    if (target.probe.state != CellState::Valid) return target;
    const CartesianTables tables(scan);
    target.distanceM = target.probe.rangeMm / 1000.0;
    const double sigmaM = noise.at(target.distanceM) / 1000.0;
    target.toleranceM = kReportedSigmas * sigmaM;
    target.resolution = resolutionAt(scan, tables, k);
    target.surface = surfaceAt(scan, tables, k, sigmaM);
    if (target.surface) target.dip = dipAt(scan, target.probe, target.surface->normal);
    target.boom = boomAt(scan, k, target.surface ? std::optional(target.surface->normal) : std::nullopt);
    return target;
}

} // namespace edgescan::inspect
