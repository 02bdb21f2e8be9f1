// Compares the two views near the axis. A look-up by beam and line is singular on the axis. Seen along the axis, a plane is a linear
// function of y / |x| and z / |x| in 1 / |x|.
#include "app/lab/calibration/axis_ends.h"

#include "app/lab/calibration/plane_buckets.h"
#include "core/base/angles.h"
#include "core/scan/georef/rotations.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan::inspect {
namespace {

constexpr double kEndMisfitMm = 30.0, kEndMisfitShare = 0.02; // mm, and share of the range
constexpr double kEndNearestM = 0.5;
constexpr double kOneSided = 2.5;   // largest leverage, as a multiple of that in the middle of the neighbours
constexpr double kMostConeDeg = 20; // farther from the axis, looking along it has no advantage
constexpr double kEndAngleSdDeg = 0.015;
// tiles per unit of y / |x| and z / |x|: about a degree; fits with common neighbours have correlated errors
constexpr double kTilesPerUnit = 60;
constexpr std::array<double, AssemblyErrors::kCount> kEndSteps{0.5, 0.5, 0.01, 0.01, 0.01}; // mm and degrees

using Slopes = Eigen::Matrix<double, 3, AssemblyErrors::kCount>;

/// A point as seen along the axis, and the effect of each assembly error on it.
struct EndPoint {
    Eigen::Vector3d yzu = Eigen::Vector3d::Zero(); ///< y / |x|, z / |x|, 1 / |x|
    Slopes slopes = Slopes::Zero();
    double rangeM = 0;
    std::size_t cell = 0; ///< index of the SeenCell
};

/// The mounting with given errors, and with each error a step larger and smaller.
class EndViews {
public:
    EndViews(const PolarGeometry& polar, const AssemblyErrors& errors)
        : errors_(errors), direction_(polar.lineDirection), middleDeg_(0.5 * (polar.lineDeg.front() + polar.lineDeg.back())),
          mount_(sensorInMover(Axis::Sweep, errors)) {
        for (std::size_t q = 0; q < AssemblyErrors::kCount; ++q) {
            AssemblyErrors more = errors, less = errors;
            more.values[q] += kEndSteps[q];
            less.values[q] -= kEndSteps[q];
            greater_[q] = sensorInMover(Axis::Sweep, more);
            smaller_[q] = sensorInMover(Axis::Sweep, less);
        }
    }

    [[nodiscard]] EndPoint of(const SeenCell& cell, std::size_t index) const {
        EndPoint point;
        point.cell = index;
        point.rangeM = cell.inSensorM.norm();
        const Eigen::Matrix3d rotation = turn(cell.lineDeg, errors_.turnFactor());
        point.yzu = alongAxis(rotation * (mount_ * cell.inSensorM));
        for (std::size_t q = 0; q + 1 < AssemblyErrors::kCount; ++q)
            point.slopes.col(static_cast<Eigen::Index>(q)) =
                (alongAxis(rotation * (greater_[q] * cell.inSensorM)) - alongAxis(rotation * (smaller_[q] * cell.inSensorM))) /
                (2 * kEndSteps[q]);
        // The turn error only rotates the point about the axis.
        const double perTurnDeg = radians(direction_ * (cell.lineDeg - middleDeg_) / 180.0);
        point.slopes.col(AssemblyErrors::kCount - 1) = Eigen::Vector3d(-point.yzu.y(), point.yzu.x(), 0) * perTurnDeg;
        return point;
    }

private:
    [[nodiscard]] Eigen::Matrix3d turn(double lineDeg, double factor) const {
        return rotationX(radians(direction_ * factor * (lineDeg - middleDeg_)));
    }
    static Eigen::Vector3d alongAxis(const Eigen::Vector3d& p) {
        const double u = 1.0 / std::abs(p.x());
        return {p.y() * u, p.z() * u, u};
    }

    AssemblyErrors errors_;
    double direction_, middleDeg_;
    RigidTransform mount_;
    std::array<RigidTransform, AssemblyErrors::kCount> greater_, smaller_;
};

int endOf(const SeenCell& cell) { return cell.inSensorM.x() > 0 ? 0 : 1; }

std::vector<EndPoint> pointsAtEnd(const std::vector<SeenCell>& cells, const EndViews& views, int end) {
    std::vector<EndPoint> points;
    for (std::size_t n = 0; n < cells.size(); ++n) {
        if (endOf(cells[n]) == end) points.push_back(views.of(cells[n], n));
    }
    return points;
}

/// The plane u = c . (1, y - y0, z - z0) through neighbours, the weights of the neighbours in its value, and its misfit.
struct EndFit {
    Eigen::Vector3d c = Eigen::Vector3d::Zero();
    double misfitU = 0, leverage = 0;
    std::vector<double> weights; ///< weight of each neighbour in c[0]
    bool usable = false;
};

EndFit fitAround(const std::vector<EndPoint>& surface, const std::vector<std::size_t>& neighbours, const Eigen::Vector3d& at) {
    EndFit fit;
    double reach = 0;
    for (const std::size_t n : neighbours) reach = std::max(reach, (surface[n].yzu.head<2>() - at.head<2>()).norm());
    if (!(reach > 0)) return fit;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double squares = 0;
    const auto rowOf = [&](std::size_t n) {
        const Eigen::Vector2d off = (surface[n].yzu.head<2>() - at.head<2>()) / reach;
        return Eigen::Vector3d(1.0, off.x(), off.y());
    };
    for (const std::size_t n : neighbours) {
        const Eigen::Vector3d x = rowOf(n);
        const double u = surface[n].yzu.z() - at.z(); // small numbers keep more digits
        normal += x * x.transpose();
        right += u * x;
        squares += u * u;
    }
    bool invertible = false;
    Eigen::Matrix3d inverse;
    normal.computeInverseWithCheck(inverse, invertible);
    if (!invertible) return fit;
    const Eigen::Vector3d c = inverse * right;
    const auto count = static_cast<double>(neighbours.size());
    fit.misfitU = std::sqrt(std::max(0.0, squares - c.dot(right)) / (count - 3));
    fit.leverage = inverse(0, 0);
    for (const std::size_t n : neighbours) fit.weights.push_back(inverse.row(0).dot(rowOf(n)));
    fit.c = {c[0] + at.z(), c[1] / reach, c[2] / reach};
    fit.usable = fit.leverage * count < kOneSided;
    return fit;
}

std::optional<Residual> residualAt(const EndPoint& point, const std::vector<EndPoint>& surface, const std::vector<std::size_t>& neighbours,
                                   const RangeNoise& noise) {
    const EndFit fit = fitAround(surface, neighbours, point.yzu);
    if (!fit.usable) return std::nullopt;
    const double mmPerU = 1000.0 / (point.yzu.z() * point.yzu.z());
    const double misfitMm = fit.misfitU * mmPerU;
    if (misfitMm > kEndMisfitMm + 1000 * kEndMisfitShare * point.rangeM) return std::nullopt;
    Residual residual;
    residual.apartMm = (fit.c[0] - point.yzu.z()) * mmPerU;
    const double perDegree = radians(fit.c.tail<2>().norm()) * mmPerU;
    residual.sigmaMm = std::sqrt(std::pow(std::max(1.0, noise.at(point.rangeM)), 2) + misfitMm * misfitMm * (1.0 + fit.leverage) +
                                 std::pow(perDegree * kEndAngleSdDeg, 2));
    // The change of a point's u relative to a plane with these slopes.
    const Eigen::RowVector3d against(-fit.c[1], -fit.c[2], 1.0);
    AssemblyVector ofSurface = AssemblyVector::Zero();
    for (std::size_t n = 0; n < neighbours.size(); ++n) ofSurface += fit.weights[n] * (against * surface[neighbours[n]].slopes).transpose();
    residual.slope = (ofSurface - (against * point.slopes).transpose()) * mmPerU;
    return residual;
}

/// Degrees from the nearer end of the axis, and that end.
std::pair<double, int> offEnd(double beamDeg) {
    const double off = beamDeg < 90.0 ? beamDeg : 180.0 - beamDeg;
    return {std::abs(off), beamDeg < 90.0 ? 0 : 1};
}

} // namespace

std::array<double, 2> beyondAxisDeg(const PolarGeometry& polar) {
    if (polar.beamDeg.empty()) return {-1, -1};
    const auto [least, most] = std::minmax_element(polar.beamDeg.begin(), polar.beamDeg.end());
    return {-*least, *most - 180.0};
}

std::vector<int> beamsSeenTwice(const PolarGeometry& polar) {
    std::vector<int> beams;
    const std::array<double, 2> beyond = beyondAxisDeg(polar);
    for (std::size_t j = 0; j < polar.beamDeg.size(); ++j) {
        const auto [off, end] = offEnd(polar.beamDeg[j]);
        const double coneDeg = std::min(kMostConeDeg, beyond[static_cast<std::size_t>(end)]);
        if (polar.axis == Axis::Spin || off <= coneDeg) beams.push_back(static_cast<int>(j));
    }
    return beams;
}

std::vector<SeenCell> cellsAtEnds(const PolarGeometry& polar, const InverseRange& inverse, View view, std::size_t most) {
    constexpr double kHalfTurnDeg = 180.0;
    const double first = *std::min_element(polar.lineDeg.begin(), polar.lineDeg.end());
    const std::vector<int> beams = beamsSeenTwice(polar);
    std::vector<SeenCell> all;
    std::vector<double> solid; // solid angle of each cell
    double whole = 0;
    for (int i = 0; i < inverse.u.lines; ++i) {
        const double at = polar.lineDeg[static_cast<std::size_t>(i)] - first;
        if (at > 2 * kHalfTurnDeg || (at >= kHalfTurnDeg) != (view == View::Late)) continue;
        for (const int j : beams) {
            if (!inverse.isMeasured(i, j)) continue;
            const double rangeM = 1.0 / static_cast<double>(inverse.u.at(i, j));
            if (rangeM < kEndNearestM) continue;
            all.push_back(seenCell(polar, i, j, rangeM));
            solid.push_back(std::abs(std::sin(radians(polar.beamDeg[static_cast<std::size_t>(j)]))));
            whole += solid.back();
        }
    }
    // Draws cells in the order of lines: each time an equal share of the solid angle is reached, one cell is taken.
    std::vector<SeenCell> cells;
    const double share = whole / static_cast<double>(std::max<std::size_t>(1, most));
    double filled = 0.5 * share;
    for (std::size_t n = 0; n < all.size(); ++n) {
        filled += solid[n];
        if (filled < share) continue;
        filled = std::min(filled - share, share);
        cells.push_back(all[n]);
    }
    return cells;
}

std::vector<Residual> residualsAtEnds(const PreparedSweep& sweep, const std::vector<SeenCell>& cells, const std::vector<SeenCell>& surface,
                                      const AssemblyErrors& errors, const EndScale& scale) {
    const auto [neighbours, every] = scale;
    std::vector<Residual> residuals;
    const EndViews views(sweep.polar, errors);
    for (const int end : {0, 1}) {
        const std::vector<EndPoint> base = pointsAtEnd(surface, views, end);
        if (base.size() < static_cast<std::size_t>(2 * neighbours)) continue;
        std::vector<Eigen::Vector2d> places;
        for (const EndPoint& point : base) places.emplace_back(point.yzu.head<2>());
        const PlaneBuckets buckets(places);
        const std::vector<EndPoint> asked = pointsAtEnd(cells, views, end);
        for (std::size_t n = 0; n < asked.size(); n += static_cast<std::size_t>(every)) {
            const EndPoint& point = asked[n];
            const Eigen::Vector2d at = point.yzu.head<2>();
            auto residual = residualAt(point, base, buckets.nearest(at, static_cast<std::size_t>(neighbours)), sweep.noise);
            if (!residual) continue;
            const SeenCell& cell = cells[point.cell];
            residual->line = cell.line;
            residual->beam = cell.beam;
            const auto tile = [](double x) { return static_cast<int>(std::floor(x * kTilesPerUnit)) + 100; };
            residual->shares = (end * 200 + std::clamp(tile(at.x()), 0, 199)) * 200 + std::clamp(tile(at.y()), 0, 199);
            residuals.push_back(*residual);
        }
    }
    return residuals;
}

} // namespace edgescan::inspect
