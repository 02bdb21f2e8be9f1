// Fits planes to neighbouring cells.
#include "app/lab/stones/smooth_normals.h"

#include "core/base/bands.h"

#include <Eigen/Eigenvalues>

namespace edgescan::lab {
namespace {

constexpr int kReach = 2;         // cells
constexpr double kFarthest = 2.6; // of a cell's size and the reach: farther points are behind a jump
constexpr int kFewestPoints = 6;

Eigen::Vector3f planeAt(const TrueCells& cells, int line, int beam) {
    const std::uint32_t body = cells.body.at(line, beam);
    if (body == 0) return Eigen::Vector3f::Zero();
    const Eigen::Vector3d& centre = cells.pointM.at(line, beam);
    const int reach = kReach * cells.finer;
    const double farthest = kFarthest * reach * centre.norm() * cells.cellRad;
    int count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (int i = std::max(0, line - reach); i <= std::min(cells.body.lines - 1, line + reach); ++i) {
        for (int j = std::max(0, beam - reach); j <= std::min(cells.body.beams - 1, beam + reach); ++j) {
            if (cells.body.at(i, j) != body) continue;
            const Eigen::Vector3d offset = cells.pointM.at(i, j) - centre;
            if (offset.squaredNorm() >= farthest * farthest) continue;
            ++count;
            sum += offset;
            squares += offset * offset.transpose();
        }
    }
    if (count < kFewestPoints) return Eigen::Vector3f::Zero();
    const Eigen::Vector3d mean = sum / count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares / count - mean * mean.transpose());
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    return (normal.dot(centre) > 0 ? -normal : normal).cast<float>();
}

} // namespace

Grid<Eigen::Vector3f> smoothNormals(const TrueCells& cells, int threads) {
    Grid<Eigen::Vector3f> normals(cells.body.lines, cells.body.beams, Eigen::Vector3f::Zero().eval());
    runInBands(normals.lines, bandsFor(normals.size(), threads), [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            for (int j = 0; j < normals.beams; ++j) normals.at(i, j) = planeAt(cells, i, j);
        }
    });
    return normals;
}

} // namespace edgescan::lab
