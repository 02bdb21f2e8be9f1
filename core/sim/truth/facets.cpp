// Angles between the sides of each pair of neighbouring cells.
#include "core/sim/truth/facets.h"

#include "core/scan/grid/cartesian.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace edgescan::sim {
namespace {

constexpr double kSideMm = 100.0;
constexpr double kTearMm = 50.0;
constexpr float kUnsureDeg = 30.0F;
constexpr int kFewest = 2, kMost = 16; // cells of a side

// The cells of one line in beam order, or of one beam in line order.
struct Row {
    const SimulationTruth& truth;
    const std::vector<Eigen::Vector3d>& points; // mm, of all cells
    const Grid<Seam>& seams;                    // from a cell to the next one
    std::size_t first, step;
    int count;

    [[nodiscard]] std::size_t cell(int n) const { return first + static_cast<std::size_t>(n) * step; }
    [[nodiscard]] Eigen::Vector3d normal(int n) const { return truth.normal[cell(n)].cast<double>(); }
    // Whether one surface goes on from a cell to the next one.
    [[nodiscard]] bool goesOn(int n) const {
        const std::size_t a = cell(n), b = cell(n + 1);
        return truth.object[a] != 0 && truth.object[a] == truth.object[b] && truth.face[a] == truth.face[b] && seams[a].tearMm <= kTearMm;
    }
};

struct Side {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    int cells = 0;
};

// From a cell on, one way, over so much of the surface.
Side sideFrom(const Row& row, int from, int way) {
    Side side;
    double length = 0;
    for (int n = from; side.cells < kMost; n += way) {
        side.normal += row.normal(n);
        ++side.cells;
        const int next = n + way;
        if (next < 0 || next >= row.count || !row.goesOn(std::min(n, next))) break;
        length += (row.points[row.cell(next)] - row.points[row.cell(n)]).norm();
        if (length >= kSideMm && side.cells >= kFewest) break;
    }
    return side;
}

// The fold from each cell of the row to the next one; 0 where the surface ends.
std::vector<float> foldsOf(const Row& row) {
    std::vector<float> folds(static_cast<std::size_t>(std::max(0, row.count - 1)), 0.0F);
    for (int n = 0; n + 1 < row.count; ++n) {
        if (!row.goesOn(n)) continue;
        const Side before = sideFrom(row, n, -1), after = sideFrom(row, n + 1, 1);
        if (before.cells < kFewest || after.cells < kFewest) continue;
        const double cosine = std::clamp(before.normal.normalized().dot(after.normal.normalized()), -1.0, 1.0);
        folds[static_cast<std::size_t>(n)] = static_cast<float>(std::acos(cosine) * 180.0 / std::numbers::pi);
    }
    return folds;
}

void takeFolds(const Row& row, Grid<Seam>& seams) {
    const std::vector<float> folds = foldsOf(row);
    const auto at = [&folds](int n) { return n < 0 || n >= static_cast<int>(folds.size()) ? 0.0F : folds[static_cast<std::size_t>(n)]; };
    for (int n = 0; n < static_cast<int>(folds.size()); ++n) {
        const bool largest = at(n) >= std::max(at(n - 1), at(n - 2)) && at(n) > std::max(at(n + 1), at(n + 2));
        seams[row.cell(n)].foldDeg = largest ? at(n) : std::min(at(n), kUnsureDeg);
    }
}

} // namespace

SimulationTruth withFacetFolds(const Simulation& simulation) {
    const SimulationTruth& from = *simulation.truth;
    SimulationTruth truth = from;
    const int lines = from.object.lines, beams = from.object.beams;
    const CartesianTables tables(simulation.scan);
    std::vector<Eigen::Vector3d> points;
    points.reserve(from.object.size());
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) points.push_back(tables.direction(i, j) * static_cast<double>(from.cleanMm.at(i, j)));
    }
    for (int i = 0; i < lines; ++i) takeFolds({from, points, from.toNextBeam, from.object.index(i, 0), 1, beams}, truth.toNextBeam);
    for (int j = 0; j < beams; ++j)
        takeFolds({from, points, from.toNextLine, static_cast<std::size_t>(j), static_cast<std::size_t>(beams), lines}, truth.toNextLine);
    return truth;
}

} // namespace edgescan::sim
