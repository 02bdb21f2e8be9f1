// From columns line and beam to rows and columns of a cloud.
#include "core/files/open_save/column_grid.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::files {
namespace {

constexpr double kMostCellsPerPoint = 64; // fewer points are cells picked from a grid
constexpr double kFewCells = 4e6;         // of which any number may be empty
constexpr std::size_t kFewestRanges = 12;
constexpr double kShareThatFits = 0.99;

struct Extent {
    std::uint32_t first = kNoIndex, last = 0;
    void add(std::uint32_t index) {
        first = std::min(first, index);
        last = std::max(last, index);
    }
};

/// What is counted from 1 begins at 1; what begins elsewhere is a part of a larger grid and keeps its numbers, unless these are absurdly
/// large or another program's rows and columns.
struct Shape {
    std::uint32_t firstLine = 0, firstBeam = 0;
    std::uint64_t lines = 0, beams = 0;
};
std::optional<Shape> shapeOf(const PointTable& table) {
    Extent lines, beams;
    std::size_t cells = 0;
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (table.line[n] == kNoIndex || table.beam[n] == kNoIndex) continue;
        lines.add(table.line[n]);
        beams.add(table.beam[n]);
        ++cells;
    }
    if (cells == 0) return std::nullopt;
    const auto most = std::max(kFewCells, kMostCellsPerPoint * static_cast<double>(table.points.size()));
    const bool fromOne = lines.first == 1 && beams.first == 1;
    for (const bool asNumbered : {true, false}) {
        if (asNumbered && table.mayBeTurned) continue; // a part that another program cut out
        Shape shape;
        shape.firstLine = asNumbered ? (fromOne ? 1 : 0) : lines.first;
        shape.firstBeam = asNumbered ? (fromOne ? 1 : 0) : beams.first;
        shape.lines = std::uint64_t{lines.last} - shape.firstLine + 1;
        shape.beams = std::uint64_t{beams.last} - shape.firstBeam + 1;
        if (static_cast<double>(shape.lines) * static_cast<double>(shape.beams) <= most) return shape;
    }
    return std::nullopt;
}

/// Where so many ranges meet: |p - s|^2 = r^2 is linear in s and |s|^2. Numbers of the file; `unitMm` of the ranges.
std::optional<Eigen::Vector3d> placeOfRanges(const PointTable& table, double unitMm) {
    std::vector<std::size_t> withRange;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (!table.points[n].allFinite() || !(table.rangeMm[n] > 0)) continue;
        withRange.push_back(n);
        middle += table.points[n];
    }
    if (withRange.size() < kFewestRanges) return std::nullopt;
    middle /= static_cast<double>(withRange.size());
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const std::size_t n : withRange) {
        const Eigen::Vector3d p = table.points[n] - middle;
        const double range = static_cast<double>(table.rangeMm[n]) / unitMm;
        const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1.0);
        normal += row * row.transpose();
        right += row * (p.squaredNorm() - range * range);
    }
    const Eigen::Vector3d sensor = normal.ldlt().solve(right).head<3>() + middle;
    if (!sensor.allFinite()) return std::nullopt;
    return sensor;
}

bool fits(const PointTable& table, const Eigen::Vector3d& sensor, double unitMm) {
    std::size_t withRange = 0;
    std::size_t good = 0;
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (!table.points[n].allFinite() || !(table.rangeMm[n] > 0)) continue;
        const double range = static_cast<double>(table.rangeMm[n]) / unitMm;
        const double rounding = 3 * (table.precision.absolute + table.precision.relative * table.points[n].norm());
        ++withRange;
        good += std::abs((table.points[n] - sensor).norm() - range) <= rounding + 0.002 * range + 1.0 / unitMm ? 1 : 0;
    }
    return withRange >= kFewestRanges && static_cast<double>(good) >= kShareThatFits * static_cast<double>(withRange);
}

/// Ranges of the file show unit and sensor; ranges that fit no place are not used.
void findSensorFromRanges(PointTable& table, bool sensorGiven) {
    if (table.rangeMm.size() != table.points.size()) return table.rangeMm.clear();
    for (const double unitMm : {1000.0, 1.0, 10.0}) {
        if (table.unitMm && *table.unitMm != unitMm) continue;
        for (const Eigen::Vector3d& sensor : {Eigen::Vector3d(table.sensor), Eigen::Vector3d(Eigen::Vector3d::Zero())}) {
            if ((sensorGiven && sensor != table.sensor) || !fits(table, sensor, unitMm)) continue;
            table.sensor = sensor;
            table.unitMm = unitMm;
            return;
        }
    }
    if (sensorGiven) return table.rangeMm.clear();
    for (const double unitMm : {1000.0, 1.0, 10.0}) {
        if (table.unitMm && *table.unitMm != unitMm) continue;
        const auto sensor = placeOfRanges(table, unitMm);
        if (!sensor || !fits(table, *sensor, unitMm)) continue;
        table.sensor = *sensor;
        table.unitMm = unitMm;
        table.remarks.emplace_back("The sensor's place was found from the ranges that the file holds with its points.");
        return;
    }
    table.rangeMm.clear();
}

} // namespace

bool layOutByColumns(PointTable& table, bool sensorGiven, std::vector<AttachedPoint>& behind) {
    if (table.line.size() != table.points.size() || table.beam.size() != table.points.size()) return false;
    const auto shape = shapeOf(table);
    if (!shape || shape->lines * shape->beams < 4) {
        table.remarks.emplace_back("The columns of lines and beams hold no grid and were not used.");
        return false;
    }
    findSensorFromRanges(table, sensorGiven);
    const std::size_t cells = shape->lines * shape->beams;
    std::vector<Eigen::Vector3d> points(cells, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    std::vector<float> ranges(table.rangeMm.empty() ? 0 : cells, 0.0F);
    std::vector<std::uint8_t> states(table.state.size() == table.points.size() ? cells : 0, static_cast<std::uint8_t>(CellState::NoReturn));
    std::vector<float> intensities(table.intensity.empty() ? 0 : cells, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        const Eigen::Vector3d& p = table.points[n];
        if (table.line[n] == kNoIndex || table.beam[n] == kNoIndex) continue;
        const std::size_t k = std::size_t{table.line[n] - shape->firstLine} * shape->beams + (table.beam[n] - shape->firstBeam);
        if (!isReturn(p)) {
            if (!states.empty()) states[k] = table.state[n];
            if (!ranges.empty() && !(ranges[k] > 0)) ranges[k] = table.rangeMm[n];
            continue;
        }
        const bool taken = points[k].allFinite();
        const bool nearer = !taken || (p - table.sensor).squaredNorm() < (points[k] - table.sensor).squaredNorm();
        if (taken && p != points[k]) behind.push_back({static_cast<std::uint32_t>(k), nearer ? points[k] : p});
        if (!nearer) continue;
        points[k] = p;
        if (!ranges.empty()) ranges[k] = table.rangeMm[n];
        if (!intensities.empty()) intensities[k] = table.intensity[n];
    }
    table.intensity = std::move(intensities);
    table.points = std::move(points);
    table.rangeMm = std::move(ranges);
    table.state = std::move(states);
    table.height = shape->lines;
    table.width = shape->beams;
    std::stable_sort(behind.begin(), behind.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
    return true;
}

} // namespace edgescan::files
