// From points to a scan: organised clouds as they are, lists by recovering their grid, or by projection.
#include "core/files/open_save/points_on_grid.h"
#include "core/base/translated_text.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/order_statistic.h"
#include "core/base/physical_limits.h"
#include "core/files/grid_recovery/recover_grid.h"
#include "core/files/grid_recovery/regrid.h"
#include "core/files/grid_recovery/unit.h"
#include "core/files/open_save/cells_of_points.h"
#include "core/files/open_save/column_grid.h"
#include "core/files/open_save/find_grid.h"
#include "core/files/open_save/table_numbers.h"
#include "core/files/open_save/written_place.h"
#include "core/files/point_tables/repeated_values.h"
#include "core/files/point_tables/text_layout.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

namespace edgescan::files {
namespace {

// Ranges of whole millimetres behind coordinates that were rounded: once the direction of a beam is known, few ranges along it give just
// these coordinates.

/// Points along known directions.
struct DirectedPoints {
    std::vector<Eigen::Vector3d> pointMm;
    std::vector<Eigen::Vector3d> direction; ///< unit vectors, one per point
    Precision precision;                    ///< of the coordinates, mm
};

constexpr double kOfOthers = 0.25; // of the points that have a whole number in reach only by chance: at most so many do not have one
constexpr double kByChance = 0.9;  // where more have one anyway, nothing is shown
constexpr std::size_t kFewest = 60;
constexpr double kSlack = 0.02; // of the rounding: directions are known this well

struct Interval {
    double low = 0.0, high = 0.0;
};
Interval allowed(const Eigen::Vector3d& point, const Eigen::Vector3d& direction, const Precision& precision) {
    Interval reach{0.0, 1e12};
    for (int axis = 0; axis < 3; ++axis) {
        const double error = (precision.absolute + precision.relative * std::abs(point[axis])) * (1 + kSlack);
        const double along = std::abs(direction[axis]);
        if (along < 1e-3) continue; // nearly at right angles: shows the direction, not the range
        const double middle = point[axis] / direction[axis];
        reach.low = std::max(reach.low, middle - error / along);
        reach.high = std::min(reach.high, middle + error / along);
    }
    return reach;
}

/// The whole millimetres that the points were computed from, one per point; where a point allows none its own range. Empty unless nearly
/// all points allow one, and clearly more of them than would by chance.
std::vector<float> wholeRangesMm(const DirectedPoints& points) {
    std::vector<float> whole;
    if (points.pointMm.size() < kFewest) return whole;
    whole.reserve(points.pointMm.size());
    std::size_t may = 0;
    double chance = 0;
    for (std::size_t k = 0; k < points.pointMm.size(); ++k) {
        const Interval reach = allowed(points.pointMm[k], points.direction[k], points.precision);
        const double measured = points.pointMm[k].dot(points.direction[k]);
        const double first = std::ceil(reach.low);
        const double last = std::floor(reach.high);
        may += first <= last ? 1 : 0;
        chance += std::clamp(reach.high - reach.low, 0.0, 1.0);
        whole.push_back(static_cast<float>(first <= last ? std::clamp(std::round(measured), first, last) : measured));
    }
    const auto all = static_cast<double>(points.pointMm.size());
    if (all - static_cast<double>(may) > kOfOthers * (all - chance) || chance > kByChance * all) return {};
    return whole;
}

constexpr std::uint64_t kBytesPerPoint = 320; // while the grid is being found

void markStatusCodes(Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return;
    scan.statusCodes = lms2xxStatusCodes(scan.rangeMm, scan.state, *polar);
    if (scan.statusCodes.empty()) return;
    const std::set<std::uint32_t> codes(scan.statusCodes.begin(), scan.statusCodes.end());
    std::size_t cells = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const bool code = scan.state[k] == CellState::Valid && codes.contains(static_cast<std::uint32_t>(scan.rangeMm[k]));
        if (!code) continue;
        scan.state[k] = CellState::DeviceStatus;
        ++cells;
    }
    if (cells > 0) {
        scan.warnings.push_back(withValues("%1 cells hold status codes of an LMS2xx from %2 on instead of a range and were taken as such.",
                                           {cells, scan.statusCodes.front()}));
    }
}

/// All the cells without a point are at the end of the last line: a text that was cut off, not points that were left out.
bool endsInMidLine(const Grid<std::uint32_t>& pointOf) {
    std::size_t firstEmpty = pointOf.size();
    while (firstEmpty > 0 && pointOf[firstEmpty - 1] == RecoveredGrid::kNoPoint) --firstEmpty;
    const bool elsewhere = std::find(pointOf.cells.begin(), pointOf.cells.begin() + static_cast<std::ptrdiff_t>(firstEmpty),
                                     RecoveredGrid::kNoPoint) != pointOf.cells.begin() + static_cast<std::ptrdiff_t>(firstEmpty);
    return firstEmpty < pointOf.size() && !elsewhere && pointOf.size() - firstEmpty < static_cast<std::size_t>(pointOf.beams);
}

/// From the ideal scanner's axes to those in which the numbers were rounded, for one line.
Eigen::Matrix3d axesOfNumbers(const FreeAxis* moved, const PolarGeometry& polar, int line) {
    if (moved == nullptr) return Eigen::Matrix3d::Identity();
    const double angle = radians(polar.lineDeg[static_cast<std::size_t>(line)] * polar.lineDirection);
    const Eigen::Matrix3d turn = polar.axis == Axis::Sweep ? rotationX(angle) : rotationZ(angle);
    return moved->turn.transpose() * turn * moved->tilt * turn.transpose();
}

/// Coordinates that were rounded more coarsely than the scanner measures: their ranges as whole millimetres, where that is what they were.
/// `moved`: null, or how the points were taken into the scanner's frame.
void roundRanges(Scan& scan, const PointTable& table, const RecoveredGrid& grid, const RangeUnit& unit, const FreeAxis* moved) {
    DirectedPoints rounded;
    std::vector<std::size_t> cells;
    const CartesianTables tables(scan);
    for (int line = 0; line < scan.lines(); ++line) {
        const Eigen::Matrix3d axes = axesOfNumbers(moved, grid.geometry, line);
        for (int beam = 0; beam < scan.beams(); ++beam) {
            const std::size_t k = scan.state.index(line, beam);
            if (scan.state[k] != CellState::Valid) continue;
            Eigen::Vector3d p = grid.turn * ((table.points[grid.pointOf[k]] - table.sensor) * unit.mmPerUnit);
            if (table.leftHanded) p.y() = -p.y();
            cells.push_back(k);
            rounded.pointMm.push_back(axes * p);
            rounded.direction.push_back(axes * tables.direction(line, beam));
        }
    }
    rounded.precision = {table.precision.absolute * unit.mmPerUnit, table.precision.relative};
    const std::vector<float> whole = wholeRangesMm(rounded);
    if (whole.empty()) return;
    for (std::size_t n = 0; n < cells.size(); ++n) scan.rangeMm[cells[n]] = whole[n];
    scan.warnings.emplace_back(
        "The coordinates are rounded, and every point fits a whole number of millimetres along its beam: these were taken as ranges.");
}

/// `inFrameOfFile`: the lines turn about an axis of the file's frame; else the points stay where they are, as they do about another sensor.
/// `moved`: null, or how the points were taken into that frame.
Scan recoveredScan(const PointTable& table, RecoveredGrid grid, const Source& source, bool inFrameOfFile, const FreeAxis* moved) {
    Scan scan;
    scan.format = table.format;
    const std::vector<double> ranges = rangesOf(table);
    const RangeUnit unit = unitOf(table, ranges, source);
    fillCells(scan, table, ranges, unit, grid.pointOf, true);
    storeStates(scan, table, grid.pointOf);
    if (table.leftHanded) {
        grid.geometry.lineDirection = -1.0;
        scan.warnings.emplace_back("The file's coordinates are left-handed and were turned right-handed: y is mirrored.");
    }
    scan.geometry = grid.geometry;
    if (!unit.wholeMm && table.rangeMm.empty()) roundRanges(scan, table, grid, unit, moved);
    if (inFrameOfFile && table.sensor.isZero(0.0)) {
        if (unit.wholeMm && table.state.empty()) markStatusCodes(scan);
    } else {
        PointGeometry points = pointGeometry(table, grid.pointOf, unit);
        points.angles = std::move(grid.geometry);
        scan.geometry = std::move(points);
    }
    std::move(grid.remarks.begin(), grid.remarks.end(), std::back_inserter(scan.warnings));
    const std::size_t empty = countCells(scan)[static_cast<std::size_t>(CellState::NoReturn)];
    if (!grid.complete && empty > 0) {
        scan.warnings.push_back(
            withValues("%1 of %2 cells of the grid that was found have no point and count as no return.", {empty, scan.cells()}));
    }
    if (moved != nullptr) placeAsFound(scan, *moved, unit.mmPerUnit * kMetresPerMm);
    return scan;
}

Scan organisedScan(const PointTable& table, const Source& source) {
    Scan scan;
    scan.format = table.format;
    const std::vector<double> ranges = rangesOf(table);
    RangeUnit unit = unitOf(table, ranges, source);
    unit.wholeMm = false; // the points stay as they are, so the ranges follow them
    Grid<std::uint32_t> inOrder(static_cast<int>(table.height), static_cast<int>(table.width));
    for (std::size_t k = 0; k < inOrder.size(); ++k) inOrder[k] = static_cast<std::uint32_t>(k);
    fillCells(scan, table, ranges, unit, inOrder, true);
    storeStates(scan, table, inOrder);
    scan.geometry = pointGeometry(table, inOrder, unit);
    return scan;
}

/// Points of a left-handed file as they are in space; lines that are recognised say it by their direction instead.
void mirror(PointTable& table) {
    for (Eigen::Vector3d& p : table.points) p.y() = -p.y();
    table.sensor.y() = -table.sensor.y();
    table.leftHanded = false;
    table.remarks.emplace_back("The file's coordinates are left-handed and were turned right-handed: y is mirrored.");
}

std::string aboutSensor(const PointTable& table, const Source& source, double metres) {
    if (!source.options->sensorM && table.sensor.isZero(0.0))
        return "the origin, because no sensor position is known (--sensor X,Y,Z gives it)";
    const auto at = [&](int axis) { return significantText(table.sensor[axis] * metres, 10); };
    return withValues(source.options->sensorM ? "the sensor position given, (%1, %2, %3) m"
                                              : "the sensor position in the file, (%1, %2, %3) m",
                      {at(0), at(1), at(2)});
}

/// What was done to the points, in numbers.
void reportProjection(Scan& scan, const Regridded& grid, const std::string& about, bool gridLookedFor, bool stepGiven) {
    scan.warnings.push_back(withValues(gridLookedFor ? "The points lie on no scanner grid and were projected about %1: %2."
                                                     : "The points were projected about %1: %2.",
                                       {about, accountOf(grid)}));
    const std::string degrees = significantText(grid.beamStepDeg, 4);
    const std::string step = withValues(
        stepGiven ? "The cells have the given %1 degrees" : "The cells have %1 degrees, from the spacing of the points", {degrees});
    scan.warnings.push_back(step + (grid.fan ? ", along lines that were recognised in the cloud." : "."));
    if (gridLookedFor)
        scan.warnings.emplace_back(
            "Edges of a projected cloud differ from those of its scan: a file with the points in the order of the scanner, "
            "or with its record, has the grid of the scan.");
}

/// A cloud without a grid, as seen from its sensor.
Result<Scan> projectedScan(PointTable& table, const Source& source, const Error& noGrid) {
    if (table.leftHanded) mirror(table);
    LooseCloud cloud{table.points, table.sensor, source.options->gridStepDeg, {}};
    cloud.progress = [&source](const char* stage, double fraction) { return source.goOn(stage, 0.5 + 0.5 * fraction); };
    const auto grid = regrid(cloud);
    const std::vector<double> ranges = rangesOf(table);
    RangeUnit unit = unitOf(table, ranges, source);
    unit.wholeMm = false; // the points stay as they are, so the ranges follow them
    const double metres = unit.mmPerUnit * kMetresPerMm;
    const std::string about = aboutSensor(table, source, metres);
    if (!grid) {
        if (grid.error().what == "cancelled") return source.cancelled();
        if (noGrid.hint == grid.error().hint) return source.refused(grid.error().what, noGrid.hint); // too few points for either
        const std::string text =
            (noGrid.what.empty() ? "" : noGrid.what + "; ") + withValues("projected about %1: %2", {about, grid.error().what});
        return source.refused(withCoarseStep(text, table), grid.error().hint);
    }
    Scan scan;
    scan.format = table.format;
    fillCells(scan, table, ranges, unit, grid->pointOf, false);
    scan.geometry = pointGeometry(table, grid->pointOf, unit);
    scan.attached.reserve(grid->hidden.size());
    for (const auto& hidden : grid->hidden) scan.attached.push_back({hidden.cell, table.points[hidden.point] * metres});
    reportProjection(scan, *grid, about, !noGrid.what.empty(), source.options->gridStepDeg.has_value());
    return scan;
}

/// What the file or the user says of the sensor's place, against what the scan lines show.
void compareWithSensor(const FreeAxis& moved, PointTable& table) {
    if (table.sensor.isZero(0.0)) return;
    const double apart = (table.sensor - moved.place).norm();
    table.remarks.push_back(
        withValues("The axis of the scan lines is %1 (in the numbers of the file) from the sensor position that was known.",
                   {significantText(apart, 3)}));
}

/// The points in the frame of the scanner, as if it were mounted without any error; their numbers are as precise as before.
void storeMovedPoints(FreeAxis& moved, PointTable& table) {
    table.precision = moved.precision;
    table.points = std::move(moved.points);
    table.sensor = Eigen::Vector3d::Zero();
}

/// Points behind the nearest of their cell, where the file says the cell.
void attach(Scan& scan, const std::vector<AttachedPoint>& behind, const PointTable& table, const Source& source) {
    if (behind.empty()) return;
    const double metres = unitOf(table, rangesOf(table), source).mmPerUnit * kMetresPerMm;
    for (const AttachedPoint& point : behind) scan.attached.push_back({point.cell, point.pointM * metres});
}

/// A later return of a pulse, and the point of the table that is the first one.
struct LaterReturn {
    std::size_t first = 0; ///< index into the table without later returns
    Eigen::Vector3d point;
};

/// Removes the later returns of each pulse from the table: the first ones make the grid. A return belongs to the pulse of the point before
/// it if its number is higher. Empty, with the table as before: the file does not number them, or not one behind the other.
std::vector<LaterReturn> removeLaterReturns(PointTable& table) {
    std::vector<LaterReturn> later;
    std::vector<std::uint8_t> numbers = std::move(table.returnNumber);
    table.returnNumber.clear();
    if (std::ranges::find(numbers, 0) != numbers.end()) { // counted from 0
        for (std::uint8_t& number : numbers) number = static_cast<std::uint8_t>(std::min(number + 1, 255));
    }
    const bool plain = table.height == 1 && table.line.empty() && table.state.empty() && table.rangeMm.empty();
    if (numbers.size() != table.points.size() || !plain) return later;
    const auto follows = [&](std::size_t n) { return n > 0 && numbers[n] > 1 && numbers[n] > numbers[n - 1]; };
    std::size_t others = 0, following = 0;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        others += numbers[n] > 1 ? 1 : 0;
        following += follows(n) ? 1 : 0;
    }
    if (others == 0) return later;
    const bool interleaved = 2 * following >= others;
    const bool someFirst = others < numbers.size();
    std::size_t kept = 0;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        if (interleaved ? follows(n) : someFirst && numbers[n] > 1) {
            later.push_back({interleaved ? kept - 1 : RecoveredGrid::kNoPoint, table.points[n]});
            continue;
        }
        table.points[kept] = table.points[n];
        if (!table.intensity.empty()) table.intensity[kept] = table.intensity[n];
        ++kept;
    }
    table.points.resize(kept);
    if (!table.intensity.empty()) table.intensity.resize(kept);
    table.width = kept;
    return later;
}

/// Puts later returns back among the points where no grid can hold them.
void putBack(PointTable& table, const std::vector<LaterReturn>& later) {
    for (const LaterReturn& one : later) {
        table.points.push_back(one.point);
        if (!table.intensity.empty()) table.intensity.push_back(std::numeric_limits<float>::quiet_NaN());
    }
    table.width = table.points.size();
}

/// How far along their pulses later returns are behind the first ones, before the points are moved into the scanner's frame.
class FirstReturns {
public:
    FirstReturns(const std::vector<LaterReturn>& later, const PointTable& table, const Eigen::Vector3d& place) : later_(later) {
        for (const LaterReturn& one : later) {
            const double away = one.first < table.points.size() ? (table.points[one.first] - place).norm() : 0;
            times_.push_back(away > 0 ? (one.point - place).norm() / away : 0);
        }
    }
    /// By cell: a pulse has one direction.
    [[nodiscard]] std::vector<AttachedPoint> behindCells(const PointTable& table, const Grid<std::uint32_t>& pointOf) const {
        std::vector<std::uint32_t> cellOf(table.points.size(), RecoveredGrid::kNoPoint);
        for (std::size_t k = 0; k < pointOf.size(); ++k) {
            if (pointOf[k] != RecoveredGrid::kNoPoint) cellOf[pointOf[k]] = static_cast<std::uint32_t>(k);
        }
        std::vector<AttachedPoint> behind;
        for (std::size_t n = 0; n < later_.size(); ++n) {
            const std::size_t first = later_[n].first;
            if (first >= cellOf.size() || cellOf[first] == RecoveredGrid::kNoPoint || !isReturn(table.points[first])) continue;
            if (times_[n] > 0) behind.push_back({cellOf[first], table.points[first] * times_[n]});
        }
        std::ranges::stable_sort(behind, {}, &AttachedPoint::cell);
        return behind;
    }

private:
    const std::vector<LaterReturn>& later_;
    std::vector<double> times_; ///< as far as the first return
};

std::string laterReturnsSentence(std::size_t later, std::size_t attached) {
    std::string text = counted(later, "point is a later return of a pulse, as the file says: the first returns make the grid",
                               "points are later returns of a pulse, as the file says: the first returns make the grid");
    if (attached > 0)
        text += withValues(", and %1", {counted(attached, "other was attached to its cell", "others were attached to their cells")});
    if (attached < later)
        text += "; " + counted(later - attached, "other has no cell of its own and was left out",
                               "others have no cell of their own and were left out");
    return text + ".";
}

/// Nothing in the file says that its points have a grid.
std::string gridFoundSentence(const Scan& scan) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) polar = &*std::get<PointGeometry>(scan.geometry).angles;
    return kListsOnlyPoints + withValues("%1 lines, %2 beams and mounting %3 were found from them.",
                                         {scan.lines(), scan.beams(), polar->axis == Axis::Spin ? "spin" : "sweep"});
}

Result<Scan> scanOf(PointTable& table, const Source& source) {
    const Projection projection = source.options->projection;
    const bool sensorUnknown = dropImpossibleSensor(table, source);
    if (projection == Projection::Always) return projectedScan(table, source, {});
    const std::vector<LaterReturn> later = removeLaterReturns(table);
    std::vector<AttachedPoint> behind;
    const bool laidOut = !table.line.empty() && layOutByColumns(table, source.options->sensorM.has_value(), behind);
    if (!laidOut) {
        table.rangeMm.clear();
        table.state.clear();
    }
    if (!table.rangeMm.empty() && table.unitMm && source.options->unitMm.value_or(*table.unitMm) != *table.unitMm)
        return source.refused("--unit does not apply: the file holds ranges that give the unit of its points", "leave --unit out");
    const bool organised = table.height > 1 || laidOut;
    if (table.leftHanded && (organised || !table.sensor.isZero(0.0))) mirror(table);
    const auto afar = organised ? wrongOrigin(table, source) : std::nullopt;
    FoundGrid found = laidOut || table.gridIsGiven ? findGridEitherWay(table, source, behind, afar.has_value())
                      : afar                       ? findMovedGrid(table, source, organised, false)
                                                   : findGrid(table, source, organised, false);
    if (organised && !laidOut && !table.gridIsGiven && !found.grid && !found.cancelled()) {
        if (auto other = findGridInOtherOrder(table, source, afar.has_value())) found = std::move(*other);
    }
    auto& grid = found.grid;
    if (afar && !grid && !found.cancelled())
        return Error{withValues("%1, and %2", {afar->what, grid.error().what}), afar->where, afar->hint};
    const bool text = table.format == "point list";
    if (grid && text && !laidOut && !source.text().ends_with('\n') && endsInMidLine(grid->pointOf)) {
        return source.refused("the last scan line is not complete and the last row has no line end: the file was cut off", "copy it again");
    }
    if (found.cancelled()) return source.cancelled();
    if (found.moved && !behind.empty()) // which point of a cell is the nearest depends on the scanner's place
        return source.refused(
            withValues("the file is in another frame than the scanner's, and %1 of its points share their line and beam with another",
                       {behind.size()}),
            kGiveSensor);
    if (grid || organised) {
        const bool returnsOnly = !organised && std::ranges::all_of(table.points, isReturn);
        const FirstReturns firsts{later, table, found.moved ? found.moved->place : Eigen::Vector3d(table.sensor)};
        if (found.moved) {
            compareWithSensor(*found.moved, table);
            storeMovedPoints(*found.moved, table);
        }
        if (grid && !later.empty()) {
            behind = firsts.behindCells(table, grid->pointOf);
            table.remarks.push_back(laterReturnsSentence(later.size(), behind.size()));
        }
        const FreeAxis* moved = found.moved ? &*found.moved : nullptr;
        Scan scan = grid ? recoveredScan(table, std::move(*grid), source, found.inFrameOfFile, moved) : organisedScan(table, source);
        attach(scan, behind, table, source);
        if (!organised) scan.warnings.push_back(gridFoundSentence(scan));
        if (laidOut)
            scan.warnings.push_back(withValues("The grid has as many lines and beams as the points name, %1 x %2: a line or beam behind "
                                               "the last point is not in the file.",
                                               {scan.lines(), scan.beams()}));
        constexpr std::array<std::string_view, 1> kStep{"grid-step"};
        std::ranges::copy(idleOptions(*source.options, kStep, "the points have a grid"), std::back_inserter(scan.warnings));
        if (returnsOnly)
            scan.warnings.emplace_back("The list holds returns only: a line or beam at the border without any return is not in it.");
        return scan;
    }
    // An operator who names the axis expects a grid; to project the points then would hide that it was not found.
    const bool gridExpected = source.options->axis && !source.options->sensorM && !source.options->gridStepDeg;
    if (projection == Projection::Never || gridExpected || sensorUnknown)
        return source.refused(withCoarseStep(grid.error().what, table), sensorUnknown ? kGiveSensor : grid.error().hint);
    putBack(table, later);
    return projectedScan(table, source, grid.error());
}

/// Points that mean "no return" become not finite: the same point many times, or points all as far from the sensor.
void removeRepeated(PointTable& table, const Source& source) {
    if (source.options->keepRepeated) return;
    for (const RepeatedPoint& one : repeatedPoints(table.points)) {
        std::string place;
        for (int axis = 0; axis < 3; ++axis) place += " " + shortestText(one.point[axis]);
        for (Eigen::Vector3d& p : table.points) {
            if (p == one.point) p.setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        table.remarks.push_back(repeatedSentence(one.count, withValues("points are one and the same,%1", {place})));
    }
    const std::vector<double> ranges = rangesOf(table);
    RangesToJudge given{ranges, table.precision.absolute * 2, table.precision.relative * 2};
    given.direction = [&](std::size_t n) { return Eigen::Vector3d((table.points[n] - table.sensor).normalized()); };
    const auto far = repeatedRange(given);
    if (!far) return;
    for (std::size_t n = 0; n < ranges.size(); ++n) {
        if (ranges[n] >= far->least) table.points[n].setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    table.remarks.push_back(repeatedSentence(
        far->count, withValues("points are %1 (in the numbers of the file) from the sensor", {significantText(far->least, 6)})));
}

/// "its numbers are rounded to 1, ..." where this is `share` or more of the size of what was scanned. Else empty.
std::string roundingOf(const PointTable& table, double share) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : table.points) {
        if (isReturn(p)) box.extend(p);
    }
    const double step = 2 * table.precision.absolute;
    if (box.isEmpty() || box.diagonal().norm() <= 0 || step < share * box.diagonal().norm()) return {};
    return withValues("its numbers are rounded to %1, and its points are within %2 of each other",
                      {significantText(step, 3), significantText(box.diagonal().norm(), 3)});
}

/// Numbers that were printed with so few digits that they step by a good part of what was scanned, as spreadsheets write large ones.
Result<Done> checkDigits(const PointTable& table, const Source& source) {
    constexpr double kOfTheirSize = 0.01, kPrinted = 2 * kFloatError;
    const bool isList = table.height == 1 && table.line.empty() && table.rangeMm.empty();
    const std::string rounding = isList ? roundingOf(table, kOfTheirSize) : std::string();
    if (!rounding.empty()) return source.refused(rounding, "write the coordinates again with all their decimals");
    if (table.precision.relative < kPrinted) return Done{};
    Eigen::AlignedBox3d box;
    double largest = 0;
    for (const Eigen::Vector3d& p : table.points) {
        if (!isReturn(p)) continue;
        box.extend(p);
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    const int digits = static_cast<int>(std::lround(1 - std::log10(2 * table.precision.relative)));
    const double step = std::pow(10.0, std::floor(std::log10(largest)) + 1 - digits);
    if (step < kOfTheirSize * box.diagonal().norm()) return Done{};
    return source.refused(
        withValues("its numbers were rounded to %1 digits, so that those near %2 step by %3: the digits that place the points are lost",
                   {digits, std::llround(largest), significantText(step, 3)}),
        "write the coordinates again with all their decimals, as numbers and not in the form 1.23E+06");
}

/// Of a list of points that makes no scan: whether it may be a table of ranges, which only its angles make one.
std::optional<Error> rangesWithoutAngles(const Error& problem, const PointTable& table, const Source& source) {
    constexpr std::size_t kFewestColumns = 7; // points with colours have six
    if (table.format != "point list" || source.extension() != ".csv" || problem.what == "cancelled") return std::nullopt;
    const auto layout = textLayoutOf(source);
    if (!layout || !layout->names.empty() || layout->columns < kFewestColumns) return std::nullopt;
    return Error{withValues("%1 numbers per line without names are a table of ranges only with its angles; as points, %2",
                            {layout->columns, problem.what.substr(0, problem.what.find(':'))}),
                 problem.where, "give --beam-start --beam-step --line-start --line-step --axis, or name the columns x, y and z"};
}

} // namespace

std::optional<std::string> leftOutSentence(const Scan& scan) {
    if (scan.pointsLeftOut == 0) return std::nullopt;
    return withValues("%1 of the %2 of the file have no cell of their own.", {scan.pointsLeftOut, counted(scan.pointsRead, "point")});
}

Result<Scan> scanOfPoints(PointTable table, const Source& source) {
    if (auto enough = checkMemory(table.points.size() * kBytesPerPoint, source.path.string()); !enough) return enough.error();
    if (!table.sensor.allFinite()) table.sensor = Eigen::Vector3d::Zero();
    removeRepeated(table, source);
    ReadingOptions file;
    file.unitMm = table.unitMm;
    std::ranges::copy(replacedByOptions(*source.options, file), std::back_inserter(table.remarks));
    std::size_t infinite = 0;
    for (const Eigen::Vector3d& p : table.points)
        infinite += p.array().isNaN().any() || p.cwiseAbs().maxCoeff() < physical::kCoordinate.limits.most ? 0 : 1;
    if (std::ranges::none_of(table.points, isReturn)) {
        return source.refused(withValues("the file holds 0 points with a return, out of %1", {table.points.size()}),
                              "choose another file, or copy it again");
    }
    if (const auto fine = checkDigits(table, source); !fine) return rangesWithoutAngles(fine.error(), table, source).value_or(fine.error());
    table.precision = withDecimals(table.precision, table.points);
    applyGivenSensor(table, source);
    const auto returns = static_cast<std::size_t>(std::count_if(table.points.begin(), table.points.end(), isReturn));
    auto scan = scanOf(table, source);
    if (!scan) {
        if (auto ranges = rangesWithoutAngles(scan.error(), table, source)) return *ranges;
    }
    // What was wrong with the file may be why its points make no scan.
    if (!scan && !table.remarks.empty() && scan.error().what != "cancelled")
        return Error{scan.error().what + "; " + table.remarks.front().substr(0, table.remarks.front().rfind('.')), scan.error().where,
                     scan.error().hint};
    constexpr double kCoarse = 0.002;
    const std::string rounding = scan || scan.error().what == "cancelled" ? std::string() : roundingOf(table, kCoarse);
    if (!rounding.empty()) return Error{scan.error().what + "; " + rounding, scan.error().where, scan.error().hint};
    if (!scan) return scan;
    scan->pointsRead = returns;
    scan->pointsLeftOut = returns - std::min(returns, countCells(*scan)[static_cast<std::size_t>(CellState::Valid)]);
    if (const auto sentence = leftOutSentence(*scan)) scan->warnings.push_back(*sentence);
    const std::string coarse =
        coarseStep(table, "Numbers up to %1 in this file have a resolution of about %2: it was written with 4-byte floats.");
    if (!coarse.empty()) scan->warnings.push_back(coarse);
    std::move(table.remarks.begin(), table.remarks.end(), std::back_inserter(scan->warnings));
    if (infinite > 0)
        scan->warnings.push_back(counted(infinite, "point with infinite or absurdly large coordinates was taken as no return.",
                                         "points with infinite or absurdly large coordinates were taken as no return."));
    return scan;
}

} // namespace edgescan::files
