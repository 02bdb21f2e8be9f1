// Fits planes in inverse range to neighbours in direction.
#include "core/inspect/registration/surfaces_apart.h"

#include "core/base/order_statistic.h"
#include "core/inspect/registration/point_index.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr unsigned kCellsOfPlane = 24;
constexpr double kMostStepsOff = 2.0; // largest angle between the point's direction and that of the nearest cell, in steps
constexpr double kRougher = 3.0;      // times the median misfit: the plane contains a jump or a fold
constexpr std::size_t kFewestOffs = 200;

struct Off {
    double m, misfitM;
};

// The plane is 1 / depth = c0 + c1 x + c2 y over directions (x, y, 1) around the point's own, so that only ranges are noisy.
std::optional<Off> offAt(const PlacedScan& fixed, const std::vector<std::uint32_t>& cells, const Eigen::Vector3d& ray) {
    const Eigen::Vector3d ahead = ray.normalized();
    const Eigen::Vector3d right = ahead.unitOrthogonal();
    const Eigen::Vector3d up = ahead.cross(right);
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
    Eigen::Vector3d with = Eigen::Vector3d::Zero();
    double square = 0;
    for (const std::uint32_t k : cells) {
        const Eigen::Vector3d q = fixed.pointsM[k] - fixed.sensorM;
        const double depth = q.dot(ahead);
        if (!(depth > 0)) return std::nullopt;
        // Angles in steps of the grid: numbers near 1 keep more digits.
        const Eigen::Vector3d row(1, q.dot(right) / depth / fixed.stepRad, q.dot(up) / depth / fixed.stepRad);
        sums += row * row.transpose();
        with += row / depth;
        square += 1 / (depth * depth);
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(sums);
    const Eigen::Vector3d c = solver.solve(with);
    if (solver.info() != Eigen::Success || !c.allFinite() || !(c[0] > 0)) return std::nullopt;
    const double rangeM = 1 / c[0];
    const double slant = std::hypot(c[1], c[2]) / fixed.stepRad * rangeM;
    const double across = 1 / std::sqrt(1 + slant * slant);
    const double left = std::max(0.0, square - c.dot(with)) / static_cast<double>(cells.size() - 3);
    return Off{std::abs(rangeM - ray.norm()) * across, std::sqrt(left) * rangeM * rangeM * across};
}

} // namespace

std::optional<double> surfaceDistanceM(const PlacedScan& fixed, const std::vector<Eigen::Vector3d>& points, double reachM) {
    std::vector<Eigen::Vector3d> directions;
    for (const Eigen::Vector3d& p : fixed.pointsM) directions.push_back((p - fixed.sensorM).normalized());
    const PointIndex index(directions);
    std::vector<Off> offs;
    std::vector<double> misfits;
    for (const Eigen::Vector3d& p : points) {
        const Eigen::Vector3d ray = p - fixed.sensorM;
        if (!ray.allFinite() || ray.isZero(0.0)) continue;
        const auto cells = index.nearest(ray.normalized(), kCellsOfPlane);
        if (cells.size() < kCellsOfPlane || (directions[cells.front()] - ray.normalized()).norm() > kMostStepsOff * fixed.stepRad) continue;
        const auto off = offAt(fixed, cells, ray);
        if (!off || off->m > reachM) continue;
        offs.push_back(*off);
        misfits.push_back(off->misfitM);
    }
    const double most = kRougher * median(std::move(misfits));
    std::vector<double> sizes;
    for (const Off& off : offs) {
        if (off.misfitM <= most) sizes.push_back(off.m);
    }
    if (sizes.size() < kFewestOffs) return std::nullopt;
    return median(std::move(sizes));
}

} // namespace edgescan::inspect
