// Leaves out lines and beams.
#include "core/scan/grid/every_nth.h"

#include "core/scan/grid/placement.h"

#include <memory>
#include <utility>

namespace edgescan {
namespace {

int partOf(int count, int n) { return (count + n - 1) / n; }

template <class T>
Grid<T> everyNth(const Grid<T>& grid, int n) {
    std::vector<T> some;
    some.reserve(static_cast<std::size_t>(partOf(grid.lines, n)) * static_cast<std::size_t>(partOf(grid.beams, n)));
    for (int i = 0; i < grid.lines; i += n) {
        for (int j = 0; j < grid.beams; j += n) some.push_back(grid.at(i, j));
    }
    return {partOf(grid.lines, n), partOf(grid.beams, n), std::move(some)};
}

std::vector<double> everyNth(const std::vector<double>& values, int n) {
    std::vector<double> some;
    for (std::size_t k = 0; k < values.size(); k += static_cast<std::size_t>(n)) some.push_back(values[k]);
    return some;
}

PolarGeometry everyNth(const PolarGeometry& polar, int n) {
    return {everyNth(polar.beamDeg, n), everyNth(polar.lineDeg, n), polar.axis, polar.lineDirection, everyNth(polar.lineSkewDeg, n)};
}

PointGeometry everyNth(const PointGeometry& points, int n) {
    PointGeometry some{everyNth(points.pointsM, n), points.sensorM};
    if (points.angles) some.angles = everyNth(*points.angles, n);
    return some;
}

/// The poses of the lines that remain.
std::shared_ptr<const Placement> everyNth(const std::shared_ptr<const Placement>& placement, int n) {
    if (!placement || placement->poses.size() <= 1) return placement;
    auto some = std::make_shared<Placement>(*placement);
    some->poses.clear();
    for (std::size_t i = 0; i < placement->poses.size(); i += static_cast<std::size_t>(n)) some->poses.push_back(placement->poses[i]);
    return some;
}

} // namespace

Scan everyNth(const Scan& scan, int n) {
    Scan some;
    some.rangeMm = everyNth(scan.rangeMm, n);
    some.state = everyNth(scan.state, n);
    some.intensity = everyNth(scan.intensity, n);
    some.geometry = std::visit([n](const auto& geometry) -> Geometry { return everyNth(geometry, n); }, scan.geometry);
    some.unitMm = scan.unitMm;
    some.placement = everyNth(scan.placement, n);
    return some;
}

} // namespace edgescan
