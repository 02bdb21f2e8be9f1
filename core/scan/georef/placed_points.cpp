// Scanner frame -> axis base -> pose -> grid scale -> origin, in this order and in double.
#include "core/scan/georef/placed_points.h"

#include "core/scan/georef/rotations.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan {

namespace {

/// The rotation of the ideal stepper for a line angle of the scan.
Eigen::Matrix3d idealTurn(const PolarGeometry* polar, double deg) {
    if (polar == nullptr) return Eigen::Matrix3d::Identity(); // points without angles: the stepper was at its zero position
    return polar->axis == Axis::Sweep ? rotationX(radians(deg)) : rotationZ(radians(deg));
}

double skewOfBeam(const PolarGeometry* polar, std::size_t beam) {
    return polar == nullptr || polar->lineSkewDeg.empty() ? 0.0 : polar->lineSkewDeg[beam] * polar->lineDirection;
}

double turnOfLine(const PolarGeometry* polar, int line) {
    return polar == nullptr ? 0.0 : polar->lineDeg[static_cast<std::size_t>(line)] * polar->lineDirection;
}

/// Fan -> mover. While the stepper moves on by `skewDeg`, the fan is rotated back by this angle about the ideal axis and forward about the
/// mounted axis.
RigidTransform mountAfter(const Placement& placement, const PolarGeometry* polar, double skewDeg) {
    const StepperMount& mount = placement.mount;
    const RigidTransform turn{rotationAbout(mount.axis, radians(mount.direction * skewDeg)), Eigen::Vector3d::Zero()};
    return turn * mount.sensorInMover * RigidTransform{idealTurn(polar, skewDeg).transpose(), Eigen::Vector3d::Zero()};
}

const RigidTransform& poseOfLine(const Placement& placement, int line) {
    return placement.poses[placement.poses.size() == 1 ? 0 : static_cast<std::size_t>(line)];
}

Eigen::Matrix3d stepperTurn(const StepperMount& mount, double lineDeg) {
    return rotationAbout(mount.axis, radians(mount.zeroDeg + mount.direction * lineDeg));
}

Eigen::Vector3d scaleOf(const Placement& placement) { return {placement.gridScale, placement.gridScale, 1.0}; }

} // namespace

PlacedPoints::PlacedPoints(const Scan& scan) : scale_(scaleOf(*scan.placement)), origin_(scan.placement->originEnhM) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    const auto lines = static_cast<std::size_t>(scan.lines());
    withoutStepper_.reserve(lines);
    lines_.reserve(lines);
    for (int line = 0; line < scan.lines(); ++line) {
        const double lineDeg = turnOfLine(polar, line);
        const RigidTransform& pose = poseOfLine(*scan.placement, line);
        withoutStepper_.push_back(idealTurn(polar, lineDeg).transpose());
        lines_.push_back({pose.rotation * stepperTurn(scan.placement->mount, lineDeg), pose.translationM});
    }
    const std::size_t mounts = polar == nullptr || polar->lineSkewDeg.empty() ? 1 : polar->lineSkewDeg.size();
    for (std::size_t beam = 0; beam < mounts; ++beam) mounts_.push_back(mountAfter(*scan.placement, polar, skewOfBeam(polar, beam)));
}

Eigen::Vector3d PlacedPoints::local(int line, int beam, const Eigen::Vector3d& scannerPointM) const {
    const auto i = static_cast<std::size_t>(line);
    const Eigen::Vector3d inMover = mountOf(beam) * (withoutStepper_[i] * scannerPointM);
    return lines_[i].translationM + scale_.cwiseProduct(lines_[i].rotation * inMover);
}

Eigen::Vector3d PlacedPoints::mine(int line, int beam, const Eigen::Vector3d& scannerPointM) const {
    return origin_ + local(line, beam, scannerPointM);
}

Eigen::Vector3d PlacedPoints::inFrame(CoordinateFrame frame, int line, int beam, const Eigen::Vector3d& scannerPointM) const {
    if (frame == CoordinateFrame::Scanner) return scannerPointM;
    return frame == CoordinateFrame::Mine ? mine(line, beam, scannerPointM) : local(line, beam, scannerPointM);
}

Eigen::Vector3d PlacedPoints::scanner(int line, int beam, const Eigen::Vector3d& localPointM) const {
    const auto i = static_cast<std::size_t>(line);
    const Eigen::Vector3d inMover = lines_[i].rotation.transpose() * (localPointM - lines_[i].translationM).cwiseQuotient(scale_);
    return withoutStepper_[i].transpose() * (inverse(mountOf(beam)) * inMover);
}

Eigen::Vector3d axisBasePoint(const Scan& scan, int line, int beam, const Eigen::Vector3d& scannerPointM) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    const Placement& placement = *scan.placement;
    const double lineDeg = turnOfLine(polar, line);
    const double skewDeg = skewOfBeam(polar, static_cast<std::size_t>(beam));
    const Eigen::Vector3d inMover = mountAfter(placement, polar, skewDeg) * (idealTurn(polar, lineDeg).transpose() * scannerPointM);
    return stepperTurn(placement.mount, lineDeg) * inMover;
}

Eigen::Vector3d localMinePoint(const Scan& scan, int line, int beam, const Eigen::Vector3d& scannerPointM) {
    const RigidTransform& pose = poseOfLine(*scan.placement, line);
    return pose.translationM + scaleOf(*scan.placement).cwiseProduct(pose.rotation * axisBasePoint(scan, line, beam, scannerPointM));
}

Eigen::Matrix3d mineAxes(const Scan& scan) {
    const PlacedPoints placed(scan);
    const int line = scan.lines() / 2, beam = scan.beams() / 2;
    const Eigen::Vector3d zero = placed.scanner(line, beam, Eigen::Vector3d::Zero());
    Eigen::Matrix3d axes;
    for (int n = 0; n < 3; ++n) axes.col(n) = (placed.scanner(line, beam, Eigen::Vector3d::Unit(n)) - zero).normalized();
    return axes;
}

MinePoint minePoint(const Scan& scan, std::size_t k) {
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams()));
    const int beam = static_cast<int>(k % static_cast<std::size_t>(scan.beams()));
    const Eigen::Vector3d local = localMinePoint(scan, line, beam, pointOfCell(scan, k));
    return {scan.placement->originEnhM + local, local};
}

const char* frameTail(CoordinateFrame frame) {
    return frame == CoordinateFrame::Scanner ? "_LOCAL" : frame == CoordinateFrame::MineLocal ? "_OFFSET" : "";
}

std::array<const char*, 3> coordinateNames(CoordinateFrame frame) {
    if (frame == CoordinateFrame::Mine) return {"easting_m", "northing_m", "elevation_m"};
    if (frame == CoordinateFrame::MineLocal) return {"east_m", "north_m", "up_m"};
    return {"x_m", "y_m", "z_m"};
}

const char* frameName(CoordinateFrame frame) {
    return frame == CoordinateFrame::Scanner ? "scanner"
           : frame == CoordinateFrame::Mine  ? "mine grid"
                                             : "local metres from the mine grid origin";
}

std::optional<CoordinateFrame> frameNamed(std::string_view name) {
    for (const CoordinateFrame frame : {CoordinateFrame::Scanner, CoordinateFrame::MineLocal, CoordinateFrame::Mine}) {
        if (name == frameName(frame)) return frame;
    }
    return std::nullopt;
}

} // namespace edgescan
