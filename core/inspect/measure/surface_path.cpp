// Averages cells along a line and propagates their errors to the length.
#include "core/inspect/measure/surface_path.h"

#include "core/inspect/measure/lengths.h"
#include "core/rocks/segmentation/cuts.h"

#include <cmath>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr double kLeap = 3.0; // times the resolution: neighbours farther apart than this are not on one visible surface

struct Node {
    Eigen::Vector3d pointM = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    int cells = 0;
};

/// Cells with a range along the straight line between the two.
std::vector<std::uint32_t> cellsUnder(const Scan& scan, std::uint32_t from, std::uint32_t to) {
    std::vector<std::uint32_t> valid;
    for (const std::uint32_t k : rocks::strokeCells({from, to}, scan.lines(), scan.beams())) {
        if (scan.state[k] == CellState::Valid) valid.push_back(k);
    }
    return valid;
}

class Tape {
public:
    Tape(const Scan& scan, const CartesianTables& tables, const RangeNoise& noise) : scan_(scan), tables_(tables), noise_(noise) {}

    /// Adds a picked end: one cell, with the full uncertainty of the intended place.
    bool pin(std::uint32_t k) {
        const auto resolved = resolutionAt(scan_, tables_, k);
        if (!resolved) return false;
        const Eigen::Vector3d p = tables_.point(k);
        nodes.push_back({p, placeCovariance(direction(p), sigmaM(k), *resolved), 1});
        last_ = p;
        return true;
    }
    void lay(std::uint32_t k) {
        const auto resolved = resolutionAt(scan_, tables_, k);
        if (!resolved) return;
        const Eigen::Vector3d p = tables_.point(k);
        const bool leaps = (p - last_).norm() > kLeap * resolved->smallestM();
        if (leaps) {
            close();
            ++leapsMade;
        }
        if (open_.cells > 0 && (p - first_).norm() >= resolved->smallestM()) close();
        if (open_.cells == 0) first_ = p;
        open_.pointM += p;
        open_.covariance += placeCovariance(direction(p), sigmaM(k), {0.0, resolved->beamM});
        ++open_.cells;
        last_ = p;
    }
    /// Merges the cells since the last node into one.
    void close() {
        if (open_.cells == 0) return;
        const double n = open_.cells;
        nodes.push_back({open_.pointM / n, open_.covariance / (n * n), open_.cells});
        open_ = {};
    }

    std::vector<Node> nodes;
    int leapsMade = 0;

private:
    [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& p) const { return (p - tables_.sensor()).normalized(); }
    [[nodiscard]] double sigmaM(std::uint32_t k) const { return noise_.at(static_cast<double>(scan_.rangeMm[k]) / 1000.0) / 1000.0; }

    const Scan& scan_;
    const CartesianTables& tables_;
    const RangeNoise& noise_;
    Node open_;
    Eigen::Vector3d first_ = Eigen::Vector3d::Zero(), last_ = Eigen::Vector3d::Zero();
};

/// First-order errors, plus the second-order part that can only lengthen the path: the scatter of the nodes across it.
void measure(const std::vector<Node>& nodes, SurfacePath& path) {
    double variance = 0.0, longer = 0.0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        if (n > 0) gradient += (nodes[n].pointM - nodes[n - 1].pointM).normalized();
        if (n + 1 < nodes.size()) gradient += (nodes[n].pointM - nodes[n + 1].pointM).normalized();
        variance += gradient.dot(nodes[n].covariance * gradient);
        if (n == 0) continue;
        const Eigen::Vector3d way = nodes[n].pointM - nodes[n - 1].pointM;
        path.lengthM += way.norm();
        if (way.isZero(0.0)) continue;
        const Eigen::Matrix3d both = nodes[n].covariance + nodes[n - 1].covariance;
        const Eigen::Vector3d along = way.normalized();
        longer += std::max(0.0, both.trace() - along.dot(both * along)) / (2.0 * way.norm());
    }
    path.toleranceM = kReportedSigmas * std::sqrt(variance) + longer;
}

} // namespace

std::optional<SurfacePath> surfacePath(const Scan& scan, const CartesianTables& tables, const RangeNoise& noise, std::uint32_t from,
                                       std::uint32_t to) {
    if (from >= scan.cells() || to >= scan.cells() || scan.state[from] != CellState::Valid || scan.state[to] != CellState::Valid)
        return std::nullopt;
    const std::vector<std::uint32_t> cells = cellsUnder(scan, from, to);
    Tape tape(scan, tables, noise);
    if (!tape.pin(from)) return std::nullopt;
    // A node next to an end would be closer to it than the resolution, so the end replaces the cells around it.
    const Eigen::Vector3d first = tables.point(from), last = tables.point(to);
    for (const std::uint32_t k : cells) {
        if (k == from || k == to) continue;
        const Eigen::Vector3d p = tables.point(k);
        const auto resolved = resolutionAt(scan, tables, k);
        if (!resolved || (p - first).norm() < resolved->smallestM() / 2 || (p - last).norm() < resolved->smallestM() / 2) continue;
        tape.lay(k);
    }
    tape.close();
    const auto end = resolutionAt(scan, tables, to);
    if (!end) return std::nullopt;
    if ((last - tape.nodes.back().pointM).norm() > kLeap * end->smallestM() && from != to) ++tape.leapsMade;
    if (!tape.pin(to)) return std::nullopt;
    SurfacePath path;
    measure(tape.nodes, path);
    path.straightM = (last - first).norm();
    path.nodes = static_cast<int>(tape.nodes.size());
    path.leaps = tape.leapsMade;
    return path;
}

} // namespace edgescan::inspect
