// A plane for each piece, and the three planes that hold most of the others.
#include "core/files/plausibility/common_planes.h"

#include "core/base/order_statistic.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan::files {
namespace {

constexpr double kMetresPerMm = 0.001;
constexpr double kPieceDeg = 5.0;
constexpr int kAcross = 6;           // points across a piece, at most
constexpr int kMostPieces = 900;     // of a sweep
constexpr double kFilled = 0.8;      // of the points of a piece, at least
constexpr double kFlatShare = 0.004; // of the range: half of a piece's points are as near to its plane
constexpr double kOnShare = 0.006;   // of the range: a piece on a plane is as near to it
constexpr double kLeastMm = 12.0;    // either, at least
constexpr double kSameDeg = 6.0;     // between normals
constexpr int kPlanes = 3;
constexpr int kClearlyMore = 10;  // pieces
constexpr int kLeastPieces = 150; // a few flat things are not a room
constexpr int kWallsOneIn = 3;    // pieces on planes, of all; where there are fewer there is no wall to go by
constexpr double kClearTimes = 1.4;

struct Piece {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::UnitZ();
    double nearM = 0.0; ///< what counts as on its plane
};

double toleranceM(double rangeM, double share) { return std::max(kLeastMm / 1000.0, share * rangeM); }

bool fits(const std::vector<Eigen::Vector3d>& points, Piece& piece) {
    for (const Eigen::Vector3d& point : points) piece.middle += point;
    piece.middle /= static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : points) spread += (point - piece.middle) * (point - piece.middle).transpose();
    piece.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : points) distances.push_back(std::abs(piece.normal.dot(point - piece.middle)));
    piece.nearM = toleranceM(piece.middle.norm(), kOnShare);
    return valueInOrder(distances, distances.size() / 2) <= toleranceM(piece.middle.norm(), kFlatShare);
}

/// Lines or beams of a piece.
int acrossOf(const std::vector<double>& deg) {
    const double step = std::abs(deg.back() - deg.front()) / static_cast<double>(deg.size() - 1);
    return std::clamp(static_cast<int>(std::lround(kPieceDeg / std::max(step, 1e-6))), 3, static_cast<int>(deg.size()));
}

std::vector<Piece> piecesOf(const Scan& scan, const PolarGeometry& cut, const CartesianTables& tables) {
    const int high = acrossOf(cut.lineDeg), wide = acrossOf(cut.beamDeg);
    const int down = std::max(1, high / kAcross), right = std::max(1, wide / kAcross);
    const int all = std::max(1, (scan.lines() / high) * (scan.beams() / wide));
    const int apart = (all + kMostPieces - 1) / kMostPieces; // every so many of a row
    std::vector<Piece> pieces;
    for (int line = 0; line + high <= scan.lines(); line += high) {
        for (int beam = 0; beam + wide <= scan.beams(); beam += wide * apart) {
            std::vector<Eigen::Vector3d> points;
            std::size_t looked = 0;
            for (int i = line; i < line + high; i += down) {
                for (int j = beam; j < beam + wide; j += right) {
                    ++looked;
                    if (scan.state.at(i, j) != CellState::Valid) continue;
                    points.emplace_back(tables.direction(i, j) * (static_cast<double>(scan.rangeMm.at(i, j)) * kMetresPerMm));
                }
            }
            if (points.size() < 6 || static_cast<double>(points.size()) < kFilled * static_cast<double>(looked)) continue;
            if (Piece piece; fits(points, piece)) pieces.push_back(piece);
        }
    }
    return pieces;
}

} // namespace

CommonPlanes commonPlanes(const Scan& scan, const PolarGeometry& geometry) {
    const auto* own = std::get_if<PolarGeometry>(&scan.geometry);
    const PolarGeometry& cut = own != nullptr ? *own : geometry;
    if (cut.lineDeg.size() < 2 || cut.beamDeg.size() < 2) return {};
    Scan turned; // only these angles: a copy of all cells would cost more than the few that are looked at
    turned.geometry = geometry;
    const std::vector<Piece> pieces = piecesOf(scan, cut, CartesianTables(turned));
    const double same = std::cos(kSameDeg * 3.14159265358979323846 / 180.0);
    std::vector<bool> taken(pieces.size(), false);
    CommonPlanes found{static_cast<int>(pieces.size()), 0};
    for (int plane = 0; plane < kPlanes; ++plane) {
        std::vector<std::size_t> most;
        for (const Piece& seed : pieces) {
            std::vector<std::size_t> on;
            for (std::size_t n = 0; n < pieces.size(); ++n) {
                if (!taken[n] && std::abs(seed.normal.dot(pieces[n].normal)) >= same &&
                    std::abs(seed.normal.dot(pieces[n].middle - seed.middle)) <= std::max(seed.nearM, pieces[n].nearM))
                    on.push_back(n);
            }
            if (on.size() > most.size()) most = std::move(on);
        }
        for (const std::size_t n : most) taken[n] = true;
        found.onPlanes += static_cast<int>(most.size());
    }
    return found;
}

bool clearlyFlatter(const CommonPlanes& other, const CommonPlanes& now) {
    const bool hasWalls = std::min(other.pieces, now.pieces) >= kLeastPieces && other.onPlanes * kWallsOneIn >= other.pieces;
    return hasWalls && other.onPlanes >= now.onPlanes + kClearlyMore &&
           static_cast<double>(other.onPlanes) >= kClearTimes * static_cast<double>(now.onPlanes);
}

} // namespace edgescan::files
