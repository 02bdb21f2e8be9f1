// Columns of a scan's cells.
#include "core/files/cloud_columns.h"

#include "core/files/description.h"
#include "core/scan/cartesian.h"

#include <cmath>
#include <limits>

namespace edgescan {
namespace {

/// Polar points are computed and lie within the scanner's reach: 4-byte floats hold them to a thousandth of a millimetre. Points
/// that were read keep every bit, which may take 8 bytes (mine coordinates do).
bool floatsSuffice(const Scan& scan) {
    const auto* points = std::get_if<PointGeometry>(&scan.geometry);
    if (points == nullptr) return true;
    for (const Eigen::Vector3d& p : points->pointsM.cells) {
        for (int axis = 0; axis < 3; ++axis) {
            if (std::isfinite(p[axis]) && static_cast<double>(static_cast<float>(p[axis])) != p[axis]) return false;
        }
    }
    return true;
}

template <class T>
void addCoordinates(CloudColumns& cloud, const std::vector<Eigen::Vector3d>& points) {
    static constexpr const char* kNames[3] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<T> values;
        values.reserve(points.size());
        for (const Eigen::Vector3d& p : points) values.push_back(static_cast<T>(p[axis]));
        cloud.columns.push_back({kNames[axis], std::move(values)});
    }
}

template <class T, class Value>
void addColumn(CloudColumns& cloud, const char* name, const std::vector<std::size_t>& cells, Value value) {
    std::vector<T> values;
    values.reserve(cells.size());
    for (const std::size_t k : cells) values.push_back(static_cast<T>(value(k)));
    cloud.columns.push_back({name, std::move(values)});
}

CloudColumns columnsFor(const Scan& scan, const std::vector<std::size_t>& cells, bool every) {
    CloudColumns cloud;
    cloud.width = cells.size();
    const CartesianTables tables(scan);
    cloud.sensorM = tables.sensor();
    std::vector<Eigen::Vector3d> points;
    points.reserve(cells.size());
    const auto* given = std::get_if<PointGeometry>(&scan.geometry);
    for (const std::size_t k : cells) points.push_back(every && given != nullptr ? given->pointsM[k] : tables.point(k));
    if (floatsSuffice(scan))
        addCoordinates<float>(cloud, points);
    else
        addCoordinates<double>(cloud, points);
    const auto beams = static_cast<std::size_t>(scan.beams());
    addColumn<std::uint32_t>(cloud, "line", cells, [&](std::size_t k) { return k / beams; });
    addColumn<std::uint32_t>(cloud, "beam", cells, [&](std::size_t k) { return k % beams; });
    addColumn<float>(cloud, "range_mm", cells, [&](std::size_t k) { return scan.rangeMm[k]; });
    return cloud;
}

template <class Chosen>
std::vector<std::size_t> cellsWhere(const Scan& scan, Chosen chosen) {
    std::vector<std::size_t> cells;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (chosen(k)) cells.push_back(k);
    }
    return cells;
}

} // namespace

CloudColumns everyCell(const Scan& scan) {
    const auto cells = cellsWhere(scan, [](std::size_t) { return true; });
    CloudColumns cloud = columnsFor(scan, cells, true);
    addColumn<std::uint8_t>(cloud, "state", cells, [&](std::size_t k) { return scan.state[k]; });
    cloud.width = static_cast<std::size_t>(scan.beams());
    cloud.height = static_cast<std::size_t>(scan.lines());
    cloud.description = descriptionText(scan, "", -1);
    return cloud;
}

CloudColumns validPoints(const Scan& scan, const Grid<std::uint8_t>* edgeMask) {
    const auto cells = cellsWhere(scan, [&](std::size_t k) { return scan.state[k] == CellState::Valid; });
    CloudColumns cloud = columnsFor(scan, cells, false);
    addColumn<std::uint8_t>(cloud, "edge", cells, [&](std::size_t k) { return edgeMask != nullptr && (*edgeMask)[k] != 0 ? 255 : 0; });
    return cloud;
}

CloudColumns edgePoints(const Scan& scan, const Grid<std::uint8_t>& edgeMask) {
    return columnsFor(scan, cellsWhere(scan, [&](std::size_t k) { return scan.state[k] == CellState::Valid && edgeMask[k] != 0; }), false);
}

std::vector<std::string> commentLines(const std::string& description) {
    constexpr std::size_t kLength = 200;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < description.size();) {
        std::size_t end = std::min(at + kLength, description.size());
        // A blank at a cut would be lost with the line's end.
        while (end < description.size() && end > at + 1 && (description[end] == ' ' || description[end - 1] == ' ')) --end;
        lines.push_back("edgescan " + description.substr(at, end - at));
        at = end;
    }
    return lines;
}

} // namespace edgescan
