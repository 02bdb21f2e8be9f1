// Scanner frame -> axis base -> pose -> grid scale -> origin, in that order and in double.
#include "core/frames/placed_points.h"

#include "core/frames/rotations.h"
#include "core/scan/cartesian.h"

namespace edgescan {

RigidTransform axisBaseFromScanner(const StepperMount& mount, const Geometry& geometry, int line) {
    const auto* polar = std::get_if<PolarGeometry>(&geometry);
    // Points without angles are those of the sensor standing at the stepper's zero.
    const double lineDeg = polar != nullptr ? polar->lineDeg[static_cast<std::size_t>(line)] * polar->lineDirection : 0.0;
    const bool sweep = polar != nullptr && polar->axis == Axis::Sweep;
    const Eigen::Matrix3d ideal = sweep ? rotationX(radians(lineDeg)) : rotationZ(radians(lineDeg));
    const double phi = radians(mount.zeroDeg + mount.direction * lineDeg);
    const RigidTransform turn{rotationAbout(mount.axis, phi), Eigen::Vector3d::Zero()};
    return turn * mount.sensorInMover * RigidTransform{ideal.transpose(), Eigen::Vector3d::Zero()};
}

PlacedPoints::PlacedPoints(const Scan& scan)
    : scale_(scan.placement->gridScale, scan.placement->gridScale, 1.0), origin_(scan.placement->originEnhM) {
    const Placement& placement = *scan.placement;
    lines_.reserve(static_cast<std::size_t>(scan.lines()));
    for (int line = 0; line < scan.lines(); ++line) {
        const RigidTransform& pose =
            placement.poses.size() == 1 ? placement.poses.front() : placement.poses[static_cast<std::size_t>(line)];
        const RigidTransform base = axisBaseFromScanner(placement.mount, scan.geometry, line);
        // The pose's translation is in grid metres already; only what is added to it here is scaled.
        lines_.push_back({pose.rotation * base.rotation, pose.translationM + scale_.cwiseProduct(pose.rotation * base.translationM)});
    }
}

Eigen::Vector3d PlacedPoints::local(int line, const Eigen::Vector3d& scannerPointM) const {
    const RigidTransform& t = lines_[static_cast<std::size_t>(line)];
    return t.translationM + scale_.cwiseProduct(t.rotation * scannerPointM);
}

Eigen::Vector3d PlacedPoints::mine(int line, const Eigen::Vector3d& scannerPointM) const { return origin_ + local(line, scannerPointM); }

Eigen::Vector3d PlacedPoints::inFrame(CoordinateFrame frame, int line, const Eigen::Vector3d& scannerPointM) const {
    if (frame == CoordinateFrame::Scanner) return scannerPointM;
    return frame == CoordinateFrame::Mine ? mine(line, scannerPointM) : local(line, scannerPointM);
}

Eigen::Vector3d PlacedPoints::scanner(int line, const Eigen::Vector3d& localPointM) const {
    const RigidTransform& t = lines_[static_cast<std::size_t>(line)];
    return t.rotation.transpose() * (localPointM - t.translationM).cwiseQuotient(scale_);
}

MinePoint minePoint(const Scan& scan, std::size_t k) {
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams()));
    const Placement& placement = *scan.placement;
    const RigidTransform& pose = placement.poses.size() == 1 ? placement.poses.front() : placement.poses[static_cast<std::size_t>(line)];
    const Eigen::Vector3d inBase = axisBaseFromScanner(placement.mount, scan.geometry, line) * pointOfCell(scan, k);
    const Eigen::Vector3d scale(placement.gridScale, placement.gridScale, 1.0);
    const Eigen::Vector3d local = pose.translationM + scale.cwiseProduct(pose.rotation * inBase);
    return {placement.originEnhM + local, local};
}

std::string suggestedExportName(const Scan& scan, const std::string& content, const std::string& extension, CoordinateFrame frame) {
    const char* tail = frame == CoordinateFrame::Scanner ? "_LOCAL" : frame == CoordinateFrame::MineLocal ? "_OFFSET" : "";
    return scan.name + "_" + content + tail + extension;
}

} // namespace edgescan
