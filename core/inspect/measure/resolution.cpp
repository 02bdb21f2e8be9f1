// Computes the resolution of the sampling at a cell.
#include "core/inspect/measure/resolution.h"

#include "core/inspect/measure/jumps_along.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::inspect {
namespace {

/// Mean angle to the neighbours one step before and behind; 0 if neither has a direction.
double angleToNeighbours(const Scan& scan, const CartesianTables& tables, int line, int beam, int lineStep, int beamStep) {
    const Eigen::Vector3d here = tables.direction(line, beam);
    double sum = 0.0;
    int known = 0;
    for (const int sign : {-1, 1}) {
        const int i = line + sign * lineStep;
        const int j = beam + sign * beamStep;
        if (!scan.rangeMm.contains(i, j)) continue;
        const Eigen::Vector3d there = tables.direction(i, j);
        if (!there.allFinite()) continue;
        sum += std::atan2(here.cross(there).norm(), here.dot(there));
        ++known;
    }
    return known == 0 ? 0.0 : sum / known;
}

} // namespace

std::optional<Resolution> resolutionAt(const Scan& scan, const CartesianTables& tables, std::size_t k, const BeamWidth& beam) {
    if (scan.state[k] != CellState::Valid) return std::nullopt;
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams()));
    const int at = static_cast<int>(k % static_cast<std::size_t>(scan.beams()));
    const double angle = std::max(angleToNeighbours(scan, tables, line, at, 0, 1), angleToNeighbours(scan, tables, line, at, 1, 0));
    if (!(angle > 0.0)) return std::nullopt;
    const double rangeM = static_cast<double>(scan.rangeMm[k]) / 1000.0;
    return Resolution{rangeM * angle, beam.at(rangeM)};
}

double clippedBeamM(const Scan& scan, const CartesianTables& tables, std::size_t k, const Resolution& resolution) {
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams()));
    const int beam = static_cast<int>(k % static_cast<std::size_t>(scan.beams()));
    const auto goesOn = [&](int i, int j, int lines, int beams) {
        return scan.rangeMm.contains(i + lines, j + beams) && isOneSurface(scan, i, j, lines, beams);
    };
    double slope = 0.0; // m of range per m across the beam
    for (const auto& [lines, beams] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
        const int i = line - lines, j = beam - beams; // the next cell of the surface, away from its end
        if (!scan.rangeMm.contains(line + lines, beam + beams) || goesOn(line, beam, lines, beams) || !goesOn(line, beam, -lines, -beams))
            continue;
        const double here = scan.rangeMm[k], inward = scan.rangeMm.at(i, j);
        const double across = std::min(here, inward) / 1000.0 * tables.direction(line, beam).cross(tables.direction(i, j)).norm();
        if (across > 0.0) slope = std::max(slope, std::abs(here - inward) / 1000.0 / across);
    }
    return slope * resolution.beamM / 4.0;
}

} // namespace edgescan::inspect
