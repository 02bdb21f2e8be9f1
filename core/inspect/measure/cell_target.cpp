// Collects the values of one cell.
#include "core/inspect/measure/cell_target.h"

#include "core/base/angles.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/methods.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr int kFirstReach = 2; // cells: five by five at first
constexpr int kMostReach = 12; // cells
constexpr std::size_t kFewestOnPlane = 8;
constexpr double kWiden = 1.5;         // times the resolution, to each side
constexpr double kOnPlane = 4.0;       // standard deviations within which a cell belongs to the plane
constexpr double kEdgeOnCosine = 0.02; // 89 degrees: the beam is parallel to the surface

struct FittedPlane {
    Eigen::Vector3d m = Eigen::Vector3d::Zero(); // m p = 1 on the plane, 1/m, from the sensor
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double reliefM = HUGE_VAL;
    std::size_t cells = 0;
};

class PlaneSeeker {
public:
    PlaneSeeker(const Scan& scan, const CartesianTables& tables, double sigmaM)
        : scan_(scan), tables_(tables), sensor_(tables.sensor()), sigmaM_(std::max(sigmaM, 1e-4)) {}

    /// The cells within `reach` that are on the plane `on`; all of them if it is null.
    [[nodiscard]] std::vector<Eigen::Vector3d> around(int line, int beam, int reach, const FittedPlane* on) const {
        std::vector<Eigen::Vector3d> points;
        const double allowed = on == nullptr ? 0.0 : kOnPlane * std::max(sigmaM_, on->reliefM);
        for (int i = line - reach; i <= line + reach; ++i) {
            for (int j = beam - reach; j <= beam + reach; ++j) {
                if (!scan_.rangeMm.contains(i, j) || scan_.state.at(i, j) != CellState::Valid) continue;
                const Eigen::Vector3d p = tables_.point(i, j) - sensor_;
                if (on != nullptr && std::abs(offPlane(*on, p)) > allowed) continue;
                points.push_back(p);
            }
        }
        return points;
    }

    [[nodiscard]] std::optional<FittedPlane> fitted(const std::vector<Eigen::Vector3d>& points) const {
        if (points.size() < kFewestOnPlane) return std::nullopt;
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& p : points) { // r (m p - 1) has the standard deviation of r
            const double weight = p.squaredNorm();
            normal += weight * p * p.transpose();
            right += weight * p;
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(normal);
        if (!(parts.eigenvalues().x() > 1e-12 * parts.eigenvalues().z())) return std::nullopt; // all on one straight line
        FittedPlane plane;
        const Eigen::Matrix3d inverse = normal.inverse();
        plane.m = inverse * right;
        plane.cells = points.size();
        double sum = 0.0;
        for (const Eigen::Vector3d& p : points) {
            const double off = offPlane(plane, p);
            sum += off * off;
        }
        plane.reliefM = std::sqrt(sum / static_cast<double>(points.size()));
        const double spread = std::max(sigmaM_ * sigmaM_, sum / static_cast<double>(points.size() - 3));
        plane.covariance = spread * inverse;
        return plane;
    }

private:
    /// Distance from the plane along the beam; infinite if the beam never meets the plane.
    [[nodiscard]] static double offPlane(const FittedPlane& plane, const Eigen::Vector3d& p) {
        const double meets = plane.m.dot(p);
        return meets > 0.0 ? p.norm() * (1.0 - 1.0 / meets) : HUGE_VAL;
    }

    const Scan& scan_;
    const CartesianTables& tables_;
    Eigen::Vector3d sensor_;
    double sigmaM_;
};

/// The flattest of nine patches that contain the cell: at the foot of a step only patches on one side are flat.
std::optional<FittedPlane> firstPlane(const PlaneSeeker& seeker, int line, int beam) {
    std::optional<FittedPlane> best;
    for (const int down : {0, -kFirstReach, kFirstReach}) {
        for (const int across : {0, -kFirstReach, kFirstReach}) {
            const auto plane = seeker.fitted(seeker.around(line + down, beam + across, kFirstReach, nullptr));
            if (plane && (!best || plane->reliefM < best->reliefM)) best = plane;
        }
    }
    return best;
}

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

// Fits a plane m p = 1 by least squares: with the unknown m, only the ranges contribute errors.

std::optional<SurfaceAtCell> surfaceAt(const Scan& scan, const CartesianTables& tables, std::size_t k, double sigmaM) {
    const auto resolution = resolutionAt(scan, tables, k);
    if (!resolution) return std::nullopt;
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams()));
    const int beam = static_cast<int>(k % static_cast<std::size_t>(scan.beams()));
    const PlaneSeeker seeker(scan, tables, sigmaM);
    std::optional<FittedPlane> plane = firstPlane(seeker, line, beam);
    const int reach =
        std::clamp(static_cast<int>(std::ceil(kWiden * resolution->smallestM() / resolution->spacingM)), kFirstReach, kMostReach);
    for (const int wider : {(kFirstReach + reach + 1) / 2, reach, reach}) {
        if (!plane) return std::nullopt;
        const FittedPlane before = *plane;
        plane = seeker.fitted(seeker.around(line, beam, wider, &before));
    }
    if (!plane) return std::nullopt;
    const Eigen::Vector3d away = tables.direction(line, beam);
    const double length = plane->m.norm();
    const Eigen::Vector3d normal = -plane->m / length; // m points away from the sensor
    const double cosine = -normal.dot(away);
    if (!(cosine > kEdgeOnCosine)) return std::nullopt;
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - normal * normal.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(across * plane->covariance * across, Eigen::EigenvaluesOnly);
    return SurfaceAtCell{normal, degrees(std::acos(std::min(1.0, cosine))),
                         degrees(std::sqrt(std::max(0.0, spread.eigenvalues().z())) / length), plane->reliefM,
                         static_cast<int>(plane->cells)};
}

Dip dipOf(const Eigen::Vector3d& normalEnu) {
    const Eigen::Vector3d up = normalEnu.z() < 0.0 ? Eigen::Vector3d(-normalEnu) : normalEnu; // of the two normals the one that points up
    const double level = std::hypot(up.x(), up.y());
    Dip dip{degrees(std::atan2(level, up.z())), 0.0};
    if (level > 0.0) dip.directionDeg = std::fmod(degrees(std::atan2(up.x(), up.y())) + 360.0, 360.0);
    return dip;
}

// The boom as a straight line, in the axis base's frame.

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
