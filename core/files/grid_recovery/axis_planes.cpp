// Axis, centre and roll by least squares over the planes of all lines.
#include "core/base/order_statistic.h"
#include "core/files/grid_recovery/free_axis_parts.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan::files::turning {
namespace {

using Moments = Eigen::Matrix4d;              // sum of (q, 1) (q, 1)^T over the returns of a line
using Rows = Eigen::Matrix<double, 7, 4>;     // change of the distance per change of each unknown, as factors of (q, 1)
using Unknowns = Eigen::Matrix<double, 6, 1>; // turns about x and y, roll, x and y of the centre, mirror.y()
constexpr int kRounds = 12;
constexpr double kOutlier = 3.0;  // of the usual misfit of a line
constexpr double kSoluble = 1e-7; // of the largest singular value: what the lines do not show stays as it is
constexpr std::size_t kFewestOfLine = 6;

Eigen::Vector3d normalAt(double angle, double roll) {
    return {-std::sin(angle) * std::cos(roll), std::cos(angle) * std::cos(roll), std::sin(roll)};
}

Eigen::Matrix3d turnAboutXY(double x, double y) {
    const double angle = std::hypot(x, y);
    if (angle < 1e-300) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, Eigen::Vector3d(x / angle, y / angle, 0.0)).toRotationMatrix();
}

class PlaneFit {
public:
    PlaneFit(const AxisFrame& frame, const std::vector<ScanLine>& lines, const FanModel& fan, std::span<const Eigen::Vector3d> returns)
        : frame_(frame), lines_(lines), fan_(fan), weights_(lines.size(), 0.0), squares_(lines.size(), 0.0) {
        for (const ScanLine& line : lines) {
            Moments sum = Moments::Zero();
            for (std::size_t m = line.from; m < line.to; ++m) {
                const Eigen::Vector4d q = frame(returns[m]).homogeneous();
                sum.noalias() += q * q.transpose();
            }
            moments_.push_back(sum);
        }
    }

    void run() {
        judge();
        for (int round = 0; round < kRounds; ++round) {
            apply(step());
            judge();
        }
    }
    [[nodiscard]] const AxisFrame& frame() const { return frame_; }
    [[nodiscard]] const std::vector<ScanLine>& lines() const { return lines_; }
    [[nodiscard]] const FanModel& fan() const { return fan_; }

private:
    [[nodiscard]] Rows rowsOf(double angle) const {
        const Eigen::Vector3d n = normalAt(angle, fan_.roll);
        const double s = std::sin(angle), c = std::cos(angle);
        Rows rows = Rows::Zero();
        rows.row(0).head<3>() = Eigen::Vector3d(-c, -s, 0.0) * std::cos(fan_.roll);
        rows.row(1).head<3>() = n.cross(Eigen::Vector3d::UnitX());
        rows.row(2).head<3>() = n.cross(Eigen::Vector3d::UnitY());
        rows.row(3).head<3>() = Eigen::Vector3d(s * std::sin(fan_.roll), -c * std::sin(fan_.roll), std::cos(fan_.roll));
        rows(4, 3) = -n.x();
        rows(5, 3) = -n.y();
        rows(6, 3) = -1.0;
        return rows;
    }
    [[nodiscard]] Eigen::Vector4d planeOf(double angle) const {
        const Eigen::Vector3d n = normalAt(angle, fan_.roll);
        return {n.x(), n.y(), n.z(), -fan_.mirror.y()};
    }
    /// One step of Gauss and Newton; the angle of each line is eliminated.
    Unknowns step() {
        Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
        Unknowns right = Unknowns::Zero();
        turns_.assign(lines_.size(), {});
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const Rows rows = rowsOf(lines_[i].angle);
            const Eigen::Matrix<double, 7, 7> square = rows * moments_[i] * rows.transpose();
            const Eigen::Matrix<double, 7, 1> pull = rows * (moments_[i] * planeOf(lines_[i].angle));
            if (!(square(0, 0) > 0)) continue;
            const Unknowns mixed = square.block<6, 1>(1, 0);
            turns_[i] = {-pull(0) / square(0, 0), -mixed / square(0, 0)};
            normal += weights_[i] * (square.block<6, 6>(1, 1) - mixed * mixed.transpose() / square(0, 0));
            right -= weights_[i] * (pull.tail<6>() - mixed * pull(0) / square(0, 0));
        }
        Eigen::JacobiSVD<Eigen::MatrixXd> solver(normal, Eigen::ComputeThinU | Eigen::ComputeThinV);
        solver.setThreshold(kSoluble * kSoluble);
        return solver.solve(right);
    }
    void apply(const Unknowns& change) {
        for (std::size_t i = 0; i < lines_.size(); ++i) lines_[i].angle += turns_[i].own + turns_[i].shared.dot(change);
        const Eigen::Matrix3d turn = turnAboutXY(change[0], change[1]);
        const Eigen::Vector3d shift(change[3], change[4], 0.0);
        Eigen::Matrix4d moved = Eigen::Matrix4d::Identity();
        moved.topLeftCorner<3, 3>() = turn;
        moved.topRightCorner<3, 1>() = -shift;
        for (Moments& moments : moments_) moments = (moved * moments * moved.transpose()).eval();
        frame_.turn = turn * frame_.turn;
        frame_.centre += frame_.turn.transpose() * shift;
        fan_.roll += change[2];
        fan_.mirror.y() += change[5];
    }
    /// Lines that are not planes weigh little.
    void judge() {
        std::vector<double> usual;
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const Eigen::Vector4d plane = planeOf(lines_[i].angle);
            const double points = std::max(moments_[i](3, 3), 1.0);
            squares_[i] = std::max(0.0, plane.dot(moments_[i] * plane)) / points;
            if (points >= kFewestOfLine) usual.push_back(squares_[i]);
        }
        const double middle = median(std::move(usual), 0.0) * kOutlier * kOutlier + 1e-24;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const bool known = moments_[i](3, 3) >= kFewestOfLine;
            weights_[i] = known ? 1 / (1 + squares_[i] * squares_[i] / (middle * middle)) : 0.0;
            sum += weights_[i] * squares_[i] * moments_[i](3, 3);
            count += weights_[i] * moments_[i](3, 3);
        }
        fan_.misfit = count > 0 ? std::sqrt(sum / count) : 0.0;
    }

    struct Turn {
        double own = 0.0;
        Unknowns shared = Unknowns::Zero();
    };
    AxisFrame frame_;
    std::vector<ScanLine> lines_;
    FanModel fan_;
    std::vector<Moments> moments_;
    std::vector<double> weights_, squares_;
    std::vector<Turn> turns_;
};

} // namespace

void fitPlanes(AxisFrame& frame, std::vector<ScanLine>& lines, FanModel& fan, std::span<const Eigen::Vector3d> returns) {
    PlaneFit fit(frame, lines, fan, returns);
    fit.run();
    frame = fit.frame();
    lines = fit.lines();
    fan = fit.fan();
}

} // namespace edgescan::files::turning
