// Columns of a scan's cells.
#include "core/files/point_tables/cloud_columns.h"

#include "core/base/number_text.h"
#include "core/files/point_tables/description.h"
#include "core/files/point_tables/edge_colours.h"
#include "core/files/point_tables/text_layout.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/marked_cells.h"
#include "core/scan/grid/scan_time.h"

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace edgescan::files {
namespace {

constexpr std::size_t kMostHeaderLines = 4096;
constexpr double kLargestInFloat = 1e4; // metres; beyond it a 4-byte float steps by a millimetre and more
constexpr std::size_t kFewOneIn = 8;    // of a line: fewer cells cost less one by one

/// Polar points are computed and are within the scanner's reach: 4-byte floats hold them to a thousandth of a millimetre. Points
/// that were read keep every bit, which may take 8 bytes. Large numbers always do: they are mine coordinates.
bool floatsSuffice(const std::vector<Eigen::Vector3d>& points, bool computed) {
    for (const Eigen::Vector3d& p : points) {
        for (int axis = 0; axis < 3; ++axis) {
            const bool exact = computed || static_cast<double>(static_cast<float>(p[axis])) == p[axis];
            if (!(std::abs(p[axis]) <= kLargestInFloat && exact) && std::isfinite(p[axis])) return false;
        }
    }
    return true;
}

/// Whether 4-byte floats hold all coordinates of polar cells: none is larger than its range.
bool areWithinFloats(const std::vector<float>& rangesMm) {
    constexpr auto kLargestMm = static_cast<float>(0.99 * kLargestInFloat * 1000.0);
    return std::ranges::all_of(rangesMm, [](float range) { return std::abs(range) < kLargestMm; });
}

template <class T>
void addCoordinates(CloudColumns& cloud, const std::vector<Eigen::Vector3d>& points, const char* prefix) {
    std::array<std::vector<T>, 3> values;
    for (std::vector<T>& ofAxis : values) ofAxis.reserve(points.size());
    for (const Eigen::Vector3d& p : points) {
        for (std::size_t axis = 0; axis < 3; ++axis) values[axis].push_back(static_cast<T>(p[static_cast<Eigen::Index>(axis)]));
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        cloud.columns.push_back({prefix + std::string(1, static_cast<char>('x' + axis)), std::move(values[axis])});
}

void addPoints(CloudColumns& cloud, const std::vector<Eigen::Vector3d>& points, bool computed, const char* prefix = "") {
    if (cloud.frame != CoordinateFrame::Mine && floatsSuffice(points, computed))
        addCoordinates<float>(cloud, points, prefix);
    else
        addCoordinates<double>(cloud, points, prefix);
}

/// The cell of a point.
struct CellOfPoint {
    std::uint32_t line, beam;
};

template <class T, class Value>
void addColumn(CloudColumns& cloud, const char* name, const std::vector<CellOfPoint>& cells, Value value) {
    std::vector<T> values;
    values.reserve(cells.size());
    for (const CellOfPoint& cell : cells) values.push_back(static_cast<T>(value(cell)));
    cloud.columns.push_back({name, std::move(values)});
}

/// Turns the points of the cells from the scanner's frame into the one asked for.
void placePoints(CloudColumns& cloud, const Scan& scan, const std::vector<CellOfPoint>& cells, std::vector<Eigen::Vector3d>& points) {
    const PlacedPoints placed(scan);
    for (std::size_t n = 0; n < cells.size(); ++n)
        points[n] = placed.inFrame(cloud.frame, static_cast<int>(cells[n].line), static_cast<int>(cells[n].beam), points[n]);
    cloud.sensorM = placed.inFrame(cloud.frame, 0, 0, cloud.sensorM);
    cloud.originM = placed.originEnhM();
    cloud.grid = scan.placement->grid;
    const Eigen::Vector3d zero = placed.local(0, 0, Eigen::Vector3d::Zero());
    Eigen::Matrix3d axes;
    for (int axis = 0; axis < 3; ++axis) axes.col(axis) = placed.local(0, 0, Eigen::Vector3d::Unit(axis)) - zero;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
    cloud.turn = svd.matrixU() * svd.matrixV().transpose(); // without the grid's scale, which is not a rotation
}

/// The cells of a cloud, one per point; the last `attached.size()` are those of the points attached to them.
struct Chosen {
    std::vector<CellOfPoint> cells;
    std::vector<const AttachedPoint*> attached;
};

/// Of the cells as they are, and of attached points from their own places.
std::vector<float> rangesOfChosen(const Scan& scan, const Chosen& chosen, const CartesianTables& tables) {
    const std::size_t ownPoints = chosen.cells.size() - chosen.attached.size();
    if (ownPoints == scan.cells() && chosen.attached.empty()) return scan.rangeMm.cells; // all of them, in order
    std::vector<float> ranges;
    ranges.reserve(chosen.cells.size());
    for (std::size_t n = 0; n < ownPoints; ++n)
        ranges.push_back(scan.rangeMm.at(static_cast<int>(chosen.cells[n].line), static_cast<int>(chosen.cells[n].beam)));
    for (const AttachedPoint* extra : chosen.attached)
        ranges.push_back(static_cast<float>((extra->pointM - tables.sensor()).norm() * 1000.0));
    return ranges;
}

/// x y z of polar cells in the scanner's frame as 4-byte floats, line by line; false where that is not all there is.
bool addComputedPoints(CloudColumns& cloud, const Scan& scan, const Chosen& chosen, const CartesianTables& tables,
                       const std::vector<float>& ranges) {
    if (!std::holds_alternative<PolarGeometry>(scan.geometry) || cloud.frame != CoordinateFrame::Scanner || !chosen.attached.empty())
        return false;
    if (!areWithinFloats(ranges)) return false;
    const std::vector<CellOfPoint>& cells = chosen.cells;
    const auto beams = static_cast<std::size_t>(scan.beams());
    std::array<std::vector<float>, 3> line, values;
    for (std::vector<float>& ofAxis : line) ofAxis.resize(beams);
    for (std::vector<float>& ofAxis : values) ofAxis.reserve(cells.size());
    for (std::size_t first = 0, next = 0; first < cells.size(); first = next) {
        while (next < cells.size() && cells[next].line == cells[first].line) ++next;
        if ((next - first) * kFewOneIn < beams) { // the same numbers, one by one
            for (std::size_t n = first; n < next; ++n) {
                const Eigen::Vector3d p = tables.point(static_cast<int>(cells[n].line), static_cast<int>(cells[n].beam));
                for (std::size_t axis = 0; axis < 3; ++axis) values[axis].push_back(static_cast<float>(p[static_cast<Eigen::Index>(axis)]));
            }
            continue;
        }
        tables.pointsOfLine(static_cast<int>(cells[first].line), line[0].data(), line[1].data(), line[2].data());
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (next - first == beams) {
                values[axis].insert(values[axis].end(), line[axis].begin(), line[axis].end());
                continue;
            }
            for (std::size_t n = first; n < next; ++n) values[axis].push_back(line[axis][cells[n].beam]);
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        cloud.columns.push_back({std::string(1, static_cast<char>('x' + axis)), std::move(values[axis])});
    return true;
}

/// Line, beam, range and intensity.
void addCells(CloudColumns& cloud, const Scan& scan, const Chosen& chosen, std::vector<float> ranges) {
    const std::vector<CellOfPoint>& cells = chosen.cells;
    addColumn<std::uint32_t>(cloud, "line", cells, [](const CellOfPoint& cell) { return cell.line; });
    addColumn<std::uint32_t>(cloud, "beam", cells, [](const CellOfPoint& cell) { return cell.beam; });
    cloud.columns.push_back({"range_mm", std::move(ranges)});
    if (scan.intensity.size() == 0) return;
    std::vector<float> intensity;
    intensity.reserve(cells.size());
    for (std::size_t n = 0; n < cells.size() - chosen.attached.size(); ++n)
        intensity.push_back(scan.intensity.at(static_cast<int>(cells[n].line), static_cast<int>(cells[n].beam)));
    intensity.resize(cells.size(), std::numeric_limits<float>::quiet_NaN()); // attached points have no intensity
    cloud.columns.push_back({"intensity", std::move(intensity)});
}

enum class Columns : std::uint8_t { Places, PlacesAndCells };

CloudColumns columnsFor(const Scan& scan, const CartesianTables& tables, const Chosen& chosen, bool every, CoordinateFrame frame,
                        Columns columns = Columns::PlacesAndCells) {
    const std::vector<CellOfPoint>& cells = chosen.cells;
    const std::size_t ownPoints = cells.size() - chosen.attached.size();
    CloudColumns cloud;
    cloud.width = cells.size();
    cloud.lines = static_cast<std::size_t>(scan.lines());
    cloud.beams = static_cast<std::size_t>(scan.beams());
    cloud.frame = frame;
    if (scan.acquisition) cloud.lineTimesS = scan.acquisition->lineTimesS;
    cloud.startS = startOfScan(scan);
    cloud.sensorM = tables.sensor();
    const auto* given = std::get_if<PointGeometry>(&scan.geometry);
    std::vector<float> ranges = rangesOfChosen(scan, chosen, tables);
    if (addComputedPoints(cloud, scan, chosen, tables, ranges)) {
        if (columns == Columns::PlacesAndCells) addCells(cloud, scan, chosen, std::move(ranges));
        return cloud;
    }
    std::vector<Eigen::Vector3d> points;
    points.reserve(cells.size());
    for (std::size_t n = 0; n < ownPoints; ++n) {
        const int line = static_cast<int>(cells[n].line);
        const int beam = static_cast<int>(cells[n].beam);
        points.push_back(every && given != nullptr ? given->pointsM.at(line, beam) : tables.point(line, beam));
    }
    for (const AttachedPoint* extra : chosen.attached) points.push_back(extra->pointM);
    const bool placed = frame != CoordinateFrame::Scanner;
    std::vector<Eigen::Vector3d> asRead;
    if (placed && every && given != nullptr) asRead = points;
    if (placed) placePoints(cloud, scan, cells, points);
    addPoints(cloud, points, given == nullptr || placed);
    if (columns == Columns::Places) return cloud;
    addCells(cloud, scan, chosen, std::move(ranges));
    if (!asRead.empty()) addPoints(cloud, asRead, false, "scanner_");
    if (!chosen.attached.empty()) {
        std::vector<std::uint8_t> attached(cells.size(), 0);
        std::fill(attached.begin() + static_cast<std::ptrdiff_t>(ownPoints), attached.end(), std::uint8_t{1});
        cloud.columns.push_back({"attached", std::move(attached)});
    }
    return cloud;
}

template <class T>
T valueAt(const Grid<T>& grid, const CellOfPoint& cell) {
    return grid.at(static_cast<int>(cell.line), static_cast<int>(cell.beam));
}

void addClasses(CloudColumns& cloud, const std::vector<CellOfPoint>& cells, const Grid<std::uint8_t>* edgeMask,
                const Grid<edges::DepthEdge>* classes) {
    if (classes != nullptr)
        addColumn<std::uint8_t>(cloud, "class", cells, [&](const CellOfPoint& cell) { return valueAt(*classes, cell); });
    const auto colour = [&](const CellOfPoint& cell) {
        if (edgeMask == nullptr || valueAt(*edgeMask, cell) == 0) return kNoEdgeColour;
        return kEdgeColours[classes != nullptr ? static_cast<std::size_t>(valueAt(*classes, cell)) : 0];
    };
    addColumn<std::uint8_t>(cloud, "red", cells, [&](const CellOfPoint& cell) { return colour(cell).red; });
    addColumn<std::uint8_t>(cloud, "green", cells, [&](const CellOfPoint& cell) { return colour(cell).green; });
    addColumn<std::uint8_t>(cloud, "blue", cells, [&](const CellOfPoint& cell) { return colour(cell).blue; });
}

void addGiven(CloudColumns& cloud, const std::vector<CellOfPoint>& cells, std::span<const CellColumn> given) {
    for (const CellColumn& column : given) {
        const auto add = [&]<class T>(const Grid<T>& values) {
            addColumn<T>(cloud, column.name, cells, [&](const CellOfPoint& cell) { return valueAt(values, cell); });
        };
        std::visit(add, column.values);
    }
}

/// `mask`: cells where it is 0 are left out; null: all cells.
template <class Wanted>
Chosen cellsWhere(const Scan& scan, bool withAttached, const Grid<std::uint8_t>* mask, Wanted wanted) {
    Chosen chosen;
    if (mask == nullptr) chosen.cells.reserve(scan.cells());
    for (int i = 0; i < scan.lines(); ++i) {
        const std::size_t first = scan.rangeMm.index(i, 0);
        const auto look = [&](std::size_t j) {
            if (wanted(first + j)) chosen.cells.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
        };
        if (mask != nullptr) {
            forEachNotZero(std::span(mask->line(i), static_cast<std::size_t>(scan.beams())), look);
            continue;
        }
        for (std::size_t j = 0; j < static_cast<std::size_t>(scan.beams()); ++j) look(j);
    }
    if (!withAttached) return chosen;
    const auto beams = static_cast<std::uint32_t>(scan.beams());
    for (const AttachedPoint& point : scan.attached) {
        if (!wanted(point.cell)) continue;
        chosen.cells.push_back({point.cell / beams, point.cell % beams});
        chosen.attached.push_back(&point);
    }
    return chosen;
}

Chosen validCells(const Scan& scan, bool withAttached) {
    return cellsWhere(scan, withAttached, nullptr, [&](std::size_t k) { return scan.state[k] == CellState::Valid; });
}

Chosen edgeCellsOf(const Scan& scan, const Grid<std::uint8_t>& edgeMask, bool withAttached) {
    return cellsWhere(scan, withAttached, &edgeMask, [&](std::size_t k) { return edgeMask[k] != 0 && scan.state[k] == CellState::Valid; });
}

} // namespace

CloudColumns everyCellByLines(const Scan& scan, CoordinateFrame frame) {
    const auto ofLines = [&scan, frame, tables = std::make_shared<const CartesianTables>(scan)](std::size_t first, std::size_t last) {
        Chosen every;
        every.cells.reserve((last - first) * static_cast<std::size_t>(scan.beams()));
        for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
            for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(scan.beams()); ++j) every.cells.push_back({i, j});
        }
        CloudColumns cloud = columnsFor(scan, *tables, every, true, frame);
        addColumn<std::uint8_t>(cloud, "state", every.cells, [&](const CellOfPoint& cell) { return valueAt(scan.state, cell); });
        return cloud;
    };
    // The columns of all cells together take more memory than the file; those of some lines stay in the cache.
    const bool later =
        frame == CoordinateFrame::Scanner && std::holds_alternative<PolarGeometry>(scan.geometry) && areWithinFloats(scan.rangeMm.cells);
    CloudColumns cloud = ofLines(0, later ? 0 : static_cast<std::size_t>(scan.lines()));
    cloud.width = static_cast<std::size_t>(scan.beams());
    cloud.height = static_cast<std::size_t>(scan.lines());
    cloud.description = descriptionText(scan, "", -1);
    if (later) {
        cloud.linesLater = [ofLines](std::size_t first, std::size_t last, std::vector<CloudColumn>& columns) {
            columns = ofLines(first, last).columns;
        };
    }
    return cloud;
}

void makeAll(CloudColumns& cloud) {
    if (!cloud.linesLater) return;
    cloud.linesLater(0, cloud.height, cloud.columns);
    cloud.linesLater = nullptr;
}

CloudColumns everyCell(const Scan& scan, CoordinateFrame frame) {
    CloudColumns cloud = everyCellByLines(scan, frame);
    makeAll(cloud);
    return cloud;
}

CloudColumns validPoints(const Scan& scan, const Grid<std::uint8_t>* edgeMask, CoordinateFrame frame, bool withAttached,
                         const Grid<edges::DepthEdge>* classes, std::span<const CellColumn> given) {
    const Chosen valid = validCells(scan, withAttached);
    CloudColumns cloud = columnsFor(scan, CartesianTables(scan), valid, false, frame);
    addColumn<std::uint8_t>(cloud, "edge", valid.cells,
                            [&](const CellOfPoint& cell) { return edgeMask != nullptr && valueAt(*edgeMask, cell) != 0 ? 255 : 0; });
    addGiven(cloud, valid.cells, given);
    addClasses(cloud, valid.cells, edgeMask, classes);
    return cloud;
}

CloudColumns edgePoints(const Scan& scan, const Grid<std::uint8_t>& edgeMask, CoordinateFrame frame, bool withAttached,
                        const Grid<edges::DepthEdge>* classes, std::span<const CellColumn> given) {
    const Chosen edges = edgeCellsOf(scan, edgeMask, withAttached);
    CloudColumns cloud = columnsFor(scan, CartesianTables(scan), edges, false, frame);
    addGiven(cloud, edges.cells, given);
    addClasses(cloud, edges.cells, &edgeMask, classes);
    return cloud;
}

CloudColumns placesOfPoints(const Scan& scan, const Grid<std::uint8_t>* edgeMask, CoordinateFrame frame, bool withAttached) {
    const Chosen chosen = edgeMask != nullptr ? edgeCellsOf(scan, *edgeMask, withAttached) : validCells(scan, withAttached);
    return columnsFor(scan, CartesianTables(scan), chosen, false, frame, Columns::Places);
}

void dropColumns(CloudColumns& cloud, bool (*dropped)(std::string_view name)) {
    std::erase_if(cloud.columns, [&](const CloudColumn& column) { return dropped(column.name); });
}

std::string frameText(const CloudColumns& cloud) {
    switch (cloud.frame) {
    case CoordinateFrame::Scanner:
        break;
    case CoordinateFrame::Mine:
        return "EdgeScan, mine grid in metres: x Easting, y Northing, z Elevation";
    case CoordinateFrame::MineLocal:
        return "EdgeScan, metres from the mine grid origin: x east, y north, z up; origin E " + fixedText(cloud.originM.x(), 3) + " N " +
               fixedText(cloud.originM.y(), 3) + " El " + fixedText(cloud.originM.z(), 3);
    }
    return "EdgeScan, coordinates in metres";
}

std::vector<std::string> commentLines(const std::string& json, const std::string& mark) {
    constexpr std::size_t kLength = 200;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < json.size();) {
        std::size_t end = std::min(at + kLength, json.size());
        // A blank at a cut would be lost with the line's end.
        while (end < json.size() && end > at + 1 && (json[end] == ' ' || json[end - 1] == ' ')) --end;
        lines.push_back(mark + json.substr(at, end - at));
        at = end;
    }
    return lines;
}

std::string recordInComments(std::string_view bytes) {
    std::string record;
    const std::string_view mark = kRecordMark;
    std::size_t at = 0;
    for (std::size_t line = 0; at < bytes.size() && (line < kMostHeaderLines || !record.empty()); ++line) {
        const TextLine text = textLineAt(bytes, at);
        at = text.next;
        const bool atStart = text.text.substr(0, 16).find(mark.substr(0, 8)) != std::string_view::npos;
        const std::size_t found = atStart ? text.text.find(mark) : std::string_view::npos;
        if (found != std::string_view::npos)
            record += text.text.substr(found + mark.size());
        else if (!record.empty() && text.text != "999") // DXF begins each comment so
            break;
    }
    return record;
}

} // namespace edgescan::files
