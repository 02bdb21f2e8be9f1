// A grid shows itself by its neighbours.
#include "core/files/point_tables/unnamed_cells.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <limits>

namespace edgescan::files {
namespace {

constexpr std::size_t kFewestPoints = 12;
constexpr double kMostShared = 0.01;  // of the points, in a cell with another one: second returns
constexpr double kNeighboursAre = 5;  // times nearer than any two points
constexpr std::size_t kPairs = 20011; // looked at, enough for a median

struct PlacedCell {
    std::uint64_t cell = 0;
    std::size_t point = 0;
};

/// Cells in order, of all points that have a place.
std::vector<PlacedCell> cellsInOrder(const PointTable& table) {
    std::vector<PlacedCell> cells;
    cells.reserve(table.points.size());
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (!isReturn(table.points[n])) continue;
        cells.push_back({(std::uint64_t{table.line[n]} << 32U) | table.beam[n], n});
    }
    std::ranges::sort(cells, {}, [](const PlacedCell& c) { return std::pair(c.cell, c.point); });
    return cells;
}

std::size_t extent(const std::vector<std::uint32_t>& indexes) {
    const auto [least, most] = std::ranges::minmax(indexes);
    return std::size_t{most} - least + 1;
}

} // namespace

bool areCells(const PointTable& table) {
    const std::size_t points = table.points.size();
    if (points < kFewestPoints || table.line.size() != points || table.beam.size() != points) return false;
    const auto missing = [](const auto& indexes) { return std::ranges::find(indexes, kNoIndex) != indexes.end(); };
    if (missing(table.line) || missing(table.beam)) return false;
    const std::size_t lines = extent(table.line);
    const std::size_t beams = extent(table.beam);
    if (lines < 2 || beams < 2 || points < 2 * std::max(lines, beams)) return false;
    const std::vector<PlacedCell> cells = cellsInOrder(table);
    if (cells.size() < kFewestPoints) return false;
    std::size_t shared = 0;
    std::size_t neighbours = 0;
    std::vector<double> beside, apart;
    const std::size_t stride = std::max<std::size_t>(1, cells.size() / kPairs);
    for (std::size_t n = 1; n < cells.size(); ++n) {
        shared += cells[n].cell == cells[n - 1].cell ? 1 : 0;
        if (cells[n].cell != cells[n - 1].cell + 1) continue;
        if (neighbours++ % stride != 0) continue;
        const Eigen::Vector3d& here = table.points[cells[n].point];
        beside.push_back((here - table.points[cells[n - 1].point]).norm());
        apart.push_back((here - table.points[cells[(n + cells.size() / 2) % cells.size()].point]).norm());
    }
    if (static_cast<double>(shared) > kMostShared * static_cast<double>(cells.size()) || 4 * neighbours < cells.size()) return false;
    return valueInOrder(beside, beside.size() / 2) * kNeighboursAre < valueInOrder(apart, apart.size() / 2);
}

} // namespace edgescan::files
