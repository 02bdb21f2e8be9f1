// The boom as a straight line, in the axis base's frame.
#include "core/inspect/measure/boom_at.h"

#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {

std::optional<BoomAtCell> boomAt(const Scan& scan, std::size_t k, const std::optional<Eigen::Vector3d>& normal) {
    if (!scan.placement || !scan.placement->boom) return std::nullopt;
    const Boom& boom = *scan.placement->boom;
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams()));
    const int beam = static_cast<int>(k % static_cast<std::size_t>(scan.beams()));
    const Eigen::Vector3d point = pointOfCell(scan, k);
    const Eigen::Vector3d there = axisBasePoint(scan, line, beam, point);
    const Eigen::Vector3d along = boom.headM - boom.pivotM;
    const double share = std::clamp((there - boom.pivotM).dot(along) / along.squaredNorm(), 0.0, 1.0);
    BoomAtCell at;
    at.distanceM = (there - boom.pivotM - share * along).norm();
    if (normal) {
        const Eigen::Vector3d rotated = axisBasePoint(scan, line, beam, point + *normal) - there;
        at.angleDeg = degrees(std::atan2(rotated.cross(along).norm(), std::abs(rotated.dot(along))));
    }
    return at;
}

} // namespace edgescan::inspect
