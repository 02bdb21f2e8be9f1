// Gauss-Newton on distances to planes, with Tukey's weights.
#include "core/inspect/registration/scan_alignment.h"
#include "core/base/number_text.h"

#include "core/base/order_statistic.h"
#include "core/inspect/registration/placed_scan.h"
#include "core/inspect/registration/point_index.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Median distance, metres, of `points` from the surface of `fixed` as its sensor saw it: from the plane through the 24 cells measured
/// closest to the point's direction. Cells are chosen by direction only, because the cells closest in space are those whose noise happens
/// to agree with the point's, and planes chosen for their flatness are those whose noise happens to be small. Points farther than `reachM`
/// from the surface, and points where the surface is much rougher than elsewhere, do not count. Empty if fewer than 200 points count.
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

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kPointsTaken = 8000;
constexpr unsigned kNeighbours = 12;
constexpr double kFlattest = 0.15; // spread of a plane: third principal axis divided by second
constexpr std::size_t kFewestPairs = 200;
constexpr int kMostRounds = 40;
constexpr double kStillM = 1e-6;
constexpr double kTukey = 4.685;
constexpr double kLeastScaleM = 0.003;
constexpr double kLeastInformation = 1e-4; // smallest eigenvalue divided by largest, with lengths in units of the scene's size

struct Plane {
    Eigen::Vector3d pointM, normal;
};

std::optional<Plane> planeAt(const PointIndex& index, const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& p, double reachM) {
    const auto near = index.nearest(p, kNeighbours);
    if (near.size() < kNeighbours || (points[near.front()] - p).norm() > reachM) return std::nullopt;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t n : near) middle += points[n] / kNeighbours;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::uint32_t n : near) spread += (points[n] - middle) * (points[n] - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    if (!(axes.eigenvalues()[0] < kFlattest * kFlattest * axes.eigenvalues()[1])) return std::nullopt;
    return Plane{middle, axes.eigenvectors().col(0)};
}

struct Pairs {
    std::vector<Vector6> rows;
    std::vector<double> offs; // metres
};

/// Rotations are about `about`, so that rotation and translation are as independent as possible.
Pairs pairsOf(const std::vector<Eigen::Vector3d>& moved, const Eigen::Vector3d& about, const PointIndex& index,
              const std::vector<Eigen::Vector3d>& fixed, double reachM) {
    Pairs pairs;
    for (const Eigen::Vector3d& p : moved) {
        const auto plane = planeAt(index, fixed, p, reachM);
        if (!plane) continue;
        Vector6 row;
        row << (p - about).cross(plane->normal), plane->normal;
        pairs.rows.push_back(row);
        pairs.offs.push_back(plane->normal.dot(p - plane->pointM));
    }
    return pairs;
}

double medianOff(const Pairs& pairs) {
    std::vector<double> offs;
    for (const double off : pairs.offs) offs.push_back(std::abs(off));
    return median(std::move(offs));
}

/// Rotation in radians and translation in metres; empty if the surfaces do not determine them.
std::optional<Vector6> step(const Pairs& pairs, double sceneM) {
    const double scale = kTukey * std::max(kLeastScaleM, 1.4826 * medianOff(pairs));
    Matrix6 information = Matrix6::Zero();
    Vector6 gradient = Vector6::Zero();
    for (std::size_t n = 0; n < pairs.rows.size(); ++n) {
        const double t = pairs.offs[n] / scale;
        if (std::abs(t) >= 1) continue;
        const double weight = (1 - t * t) * (1 - t * t);
        information += weight * pairs.rows[n] * pairs.rows[n].transpose();
        gradient -= weight * pairs.offs[n] * pairs.rows[n];
    }
    Vector6 unit;
    unit << Eigen::Vector3d::Constant(1 / sceneM), Eigen::Vector3d::Ones();
    const Eigen::SelfAdjointEigenSolver<Matrix6> axes(unit.asDiagonal() * information * unit.asDiagonal());
    if (!(axes.eigenvalues()[0] > kLeastInformation * axes.eigenvalues()[5])) return std::nullopt;
    return information.ldlt().solve(gradient);
}

std::vector<Eigen::Vector3d> someOf(const PlacedScan& placed) {
    std::vector<Eigen::Vector3d> valid;
    for (const Eigen::Vector3d& p : placed.pointsM) {
        if (p.allFinite()) valid.push_back(p);
    }
    std::vector<Eigen::Vector3d> some;
    const std::size_t stride = std::max<std::size_t>(1, valid.size() / kPointsTaken);
    for (std::size_t n = stride / 2; n < valid.size(); n += stride) some.push_back(valid[n]);
    return some;
}

} // namespace

Result<ScanAlignment> alignScans(const PlacedScan& fixed, const PlacedScan& moved, double reachM) {
    const PointIndex index(fixed.pointsM);
    const std::vector<Eigen::Vector3d> start = someOf(moved);
    Eigen::Vector3d about = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : start) about += p / static_cast<double>(start.size());
    double sceneM = 0;
    for (const Eigen::Vector3d& p : start) sceneM += (p - about).norm() / static_cast<double>(start.size());
    ScanAlignment result;
    for (int round = 0;; ++round) {
        std::vector<Eigen::Vector3d> now;
        for (const Eigen::Vector3d& p : start) now.push_back(result.correction * p);
        const Pairs pairs = pairsOf(now, result.correction * about, index, fixed.pointsM, reachM);
        if (pairs.rows.size() < kFewestPairs)
            return Error{"only " + counted(pairs.rows.size(), "point of the two scans is", "points of the two scans are") +
                             " close enough to each other",
                         "", "give poses that bring them together, or a larger reach"};
        result.pairs = pairs.rows.size();
        const auto apart = [&] { return surfaceDistanceM(fixed, now, reachM).value_or(medianOff(pairs)); };
        if (round == 0) result.residualBeforeM = apart();
        const auto move = step(pairs, sceneM);
        if (!move)
            return Error{"the surfaces that both scans see do not hold the one against the other in every direction", "",
                         "give exact poses and leave the refinement out"};
        const Eigen::Vector3d turn = move->head<3>();
        const Eigen::Vector3d middle = result.correction * about;
        const Eigen::Matrix3d rotation =
            turn.norm() > 0 ? Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() : Eigen::Matrix3d::Identity();
        result.correction = RigidTransform{rotation, middle - rotation * middle + move->tail<3>()} * result.correction;
        if (round + 1 >= kMostRounds || turn.norm() * sceneM + move->tail<3>().norm() < kStillM) {
            result.residualM = apart();
            return result;
        }
    }
}

PlacedScan corrected(PlacedScan placed, const RigidTransform& correction) {
    for (Eigen::Vector3d& p : placed.pointsM) p = correction * p;
    placed.sensorM = correction * placed.sensorM;
    return placed;
}

} // namespace edgescan::inspect
