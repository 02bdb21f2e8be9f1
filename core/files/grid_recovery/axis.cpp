// Directions of one beam differ only across the axis.
#include "core/files/grid_recovery/axis.h"

#include "core/files/grid_recovery/recover_grid.h"

#include <Eigen/Dense>

namespace edgescan::files {

std::optional<Eigen::Matrix3d> turnToAxis(const Grid<Eigen::Vector3d>& points) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    std::size_t told = 0;
    for (int j = 0; j < points.beams; ++j) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        double count = 0;
        for (int i = 0; i < points.lines; ++i) {
            const Eigen::Vector3d& p = points.at(i, j);
            if (!isReturn(p)) continue;
            const Eigen::Vector3d direction = p.normalized();
            sum += direction;
            squares += direction * direction.transpose();
            ++count;
        }
        if (count < 3) continue;
        ++told;
        spread += squares - sum * sum.transpose() / count;
    }
    if (told < 2) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    if (solver.info() != Eigen::Success || solver.eigenvalues()[1] < 1e-12 * static_cast<double>(points.size())) return std::nullopt;
    Eigen::Vector3d axis = solver.eigenvectors().col(0);
    if (axis.cwiseAbs().maxCoeff() == -axis.minCoeff()) axis = -axis; // along the positive side of the nearest axis of the frame
    const Eigen::Vector3d across = axis.unitOrthogonal();
    Eigen::Matrix3d turn;
    turn << across.transpose(), axis.cross(across).transpose(), axis.transpose();
    return turn;
}

} // namespace edgescan::files
