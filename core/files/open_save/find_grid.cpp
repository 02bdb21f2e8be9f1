// The grid of a table's points, by the directions in which they lie from the sensor.
#include "core/files/open_save/find_grid.h"
#include "core/base/translated_text.h"

#include "core/base/grid.h"
#include "core/files/grid_recovery/recover_grid.h"
#include "core/files/grid_recovery/regrid.h"
#include "core/files/open_save/table_numbers.h"

#include <Eigen/Core>
#include <Eigen/Dense>

#include <algorithm>
#include <optional>

namespace edgescan::files {
namespace {

// Directions of one beam differ only across the axis.

/// `points`: lines x beams about the sensor, any unit; not finite or (0, 0, 0) = missing. A turn that makes the axis the z axis: all points
/// of a beam have the same angle from it. Empty when too few show it.
std::optional<Eigen::Matrix3d> turnToAxis(const Grid<Eigen::Vector3d>& points) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    std::size_t beamsWithReturns = 0;
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
        ++beamsWithReturns;
        spread += squares - sum * sum.transpose() / count;
    }
    if (beamsWithReturns < 2) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    if (solver.info() != Eigen::Success || solver.eigenvalues()[1] < 1e-12 * static_cast<double>(points.size())) return std::nullopt;
    Eigen::Vector3d axis = solver.eigenvectors().col(0);
    if (axis.cwiseAbs().maxCoeff() == -axis.minCoeff()) axis = -axis; // along the positive side of the nearest axis of the frame
    const Eigen::Vector3d across = axis.unitOrthogonal();
    Eigen::Matrix3d turn;
    turn << across.transpose(), axis.cross(across).transpose(), axis.transpose();
    return turn;
}

/// Progress from one half on: the first half is reading.
std::function<bool(const char*, double)> secondHalf(const Source& source) {
    return [&source](const char* stage, double fraction) { return source.goOn(stage, 0.5 + 0.5 * fraction); };
}

/// The grid in the file's own frame, about the sensor.
Result<RecoveredGrid> recoverInFileFrame(const PointTable& table, const Source& source, std::size_t rowLength) {
    std::vector<Eigen::Vector3d> shifted;
    std::span<const Eigen::Vector3d> points = table.points;
    if (!table.sensor.isZero(0.0)) {
        for (const Eigen::Vector3d& p : table.points)
            shifted.push_back(isReturn(p) ? Eigen::Vector3d(p - table.sensor) : Eigen::Vector3d(Eigen::Vector3d::Zero()));
        points = shifted;
    }
    PointList list{points, precisionAboutSensor(table), rowLength, source.options->axis, secondHalf(source)};
    return recoverGrid(list);
}

/// The grid of an organised cloud about whatever axis its lines turn.
Result<RecoveredGrid> recoverTurned(const PointTable& table, const Source& source) {
    Grid<Eigen::Vector3d> points(static_cast<int>(table.height), static_cast<int>(table.width), table.points);
    for (Eigen::Vector3d& p : points.cells) p = isReturn(p) ? Eigen::Vector3d(p - table.sensor) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    const auto turn = turnToAxis(points);
    if (!turn) return Error{"too few points", "", ""};
    for (Eigen::Vector3d& p : points.cells) p = *turn * p;
    PointList list{points.cells, precisionAboutSensor(table), table.width, Axis::Spin, secondHalf(source)};
    auto grid = recoverGrid(list);
    if (grid) grid->turn = grid->turn * *turn;
    return grid;
}

bool isOfAnotherShape(const RecoveredGrid& grid, const PointTable& table) {
    return grid.pointOf.size() != table.width * table.height || static_cast<std::size_t>(grid.pointOf.beams) != table.width ||
           grid.unplaced > 0 || grid.doubled > 0 || grid.copied > 0;
}

/// The angles of a scanner's fan, where the beams that were measured are all of it.
void applyFan(PolarGeometry& geometry, double fanDeg) {
    constexpr double kSameBeam = 0.01; // of the step
    if (fanDeg == 0.0 || geometry.beamDeg.size() < 2) return;
    const double step = fanDeg / static_cast<double>(geometry.beamDeg.size() - 1);
    std::vector<double> beams;
    for (std::size_t j = 0; j < geometry.beamDeg.size(); ++j) {
        beams.push_back(90.0 - fanDeg / 2 + static_cast<double>(j) * step);
        if (std::abs(beams.back() - geometry.beamDeg[j]) > kSameBeam * step) return;
    }
    geometry.beamDeg = std::move(beams);
}

/// The points are in a scanner's frame already: its axes are those of the file.
bool isAtOrigin(const FreeAxis& moved) {
    constexpr double kSamePlace = 1e-3; // of the farthest point
    double farthest = 0;
    for (const Eigen::Vector3d& p : moved.points) farthest = isReturn(p) ? std::max(farthest, p.norm()) : farthest;
    return moved.place.norm() < kSamePlace * farthest;
}

/// Lines for beams and beams for lines.
void exchangeLinesAndBeams(PointTable& table, std::vector<AttachedPoint>& behind) {
    const auto exchanged = [&](const auto& cells) {
        auto turned = cells;
        for (std::size_t k = 0; k < cells.size(); ++k) turned[k % table.width * table.height + k / table.width] = cells[k];
        return turned;
    };
    table.points = exchanged(table.points);
    if (!table.rangeMm.empty()) table.rangeMm = exchanged(table.rangeMm);
    if (!table.state.empty()) table.state = exchanged(table.state);
    if (!table.intensity.empty()) table.intensity = exchanged(table.intensity);
    for (AttachedPoint& point : behind)
        point.cell = static_cast<std::uint32_t>(point.cell % table.width * table.height + point.cell / table.width);
    std::swap(table.width, table.height);
}

} // namespace

FoundGrid findMovedGrid(const PointTable& table, const Source& source, bool organised, bool named) {
    if (table.leftHanded) return {Error{"left-handed points", "", ""}};
    PointList list{table.points, precisionAnywhere(table), organised ? table.width : 0, source.options->axis, secondHalf(source)};
    auto moved = findFreeAxis(list);
    if (!moved) return {moved.error()};
    if (source.options->axis && isAtOrigin(*moved)) return {Error{"their scan lines turn about another axis than --axis says", "", ""}};
    if (organised && isAtOrigin(*moved))
        return {Error{"their scan lines turn about an axis through the origin", "", ""}}; // recoverTurned()
    list.points = moved->points;
    list.precision = moved->precision;
    list.axis = moved->axis;
    FoundGrid found{recoverGrid(list)};
    if (found.grid && named && isOfAnotherShape(*found.grid, table)) found.grid = Error{"another grid", "", ""};
    found.inFrameOfFile = static_cast<bool>(found.grid);
    if (found.grid) {
        applyFan(found.grid->geometry, moved->fanDeg);
        found.moved = std::move(*moved);
    } else if (!found.cancelled()) {
        found.grid = Error{"about the axis of their scan lines they are on no common beams", "", found.grid.error().hint};
    }
    return found;
}

FoundGrid findGridAboutAxis(const PointTable& table, const Source& source, bool organised, bool named) {
    FoundGrid found{recoverInFileFrame(table, source, organised ? table.width : 0)};
    if (found.grid && named && isOfAnotherShape(*found.grid, table)) found.grid = Error{"another grid", "", ""};
    found.inFrameOfFile = static_cast<bool>(found.grid);
    if (found.inFrameOfFile || found.cancelled()) return found;
    FoundGrid elsewhere = findMovedGrid(table, source, organised, named);
    if (elsewhere.cancelled() || elsewhere.grid) return elsewhere;
    found.grid = Error{withValues("%1, and %2", {found.grid.error().what, elsewhere.grid.error().what}), "", found.grid.error().hint};
    return found;
}

FoundGrid findGrid(const PointTable& table, const Source& source, bool organised, bool named) {
    FoundGrid found = findGridAboutAxis(table, source, organised, named);
    if (found.grid || found.cancelled() || !named || table.gridIsGiven) return found;
    auto turned = recoverTurned(table, source);
    if ((!turned && turned.error().what == "cancelled") || (turned && !isOfAnotherShape(*turned, table))) found.grid = std::move(turned);
    return found;
}

FoundGrid findGridEitherWay(PointTable& table, const Source& source, std::vector<AttachedPoint>& behind, bool fromAfar) {
    const auto find = [&] { return fromAfar ? findMovedGrid(table, source, true, true) : findGrid(table, source, true, true); };
    FoundGrid found = find();
    if (found.grid || found.cancelled() || !table.mayBeTurned || table.height < 2 || table.width < 2) return found;
    exchangeLinesAndBeams(table, behind);
    FoundGrid other = find();
    if (other.grid) table.remarks.emplace_back("Lines and beams were exchanged: only that way the lines make fans about one axis.");
    if (other.grid || other.cancelled()) return other;
    exchangeLinesAndBeams(table, behind);
    return found;
}

std::optional<FoundGrid> findGridInOtherOrder(PointTable& table, const Source& source, bool fromAfar) {
    if (table.height < 2 || table.width < 2 || table.leftHanded) return std::nullopt;
    std::vector<AttachedPoint> none;
    const auto find = [&] { return fromAfar ? findMovedGrid(table, source, true, true) : findGridAboutAxis(table, source, true, true); };
    const auto accepted = [&](FoundGrid found, const char* order) -> std::optional<FoundGrid> {
        if (found.grid)
            table.remarks.push_back(withValues(
                "The rows of the file make no fans about one axis as they are stored: %1, and only that way the lines make fans.",
                {order}));
        return found.grid || found.cancelled() ? std::optional(std::move(found)) : std::nullopt;
    };
    exchangeLinesAndBeams(table, none);
    if (auto found = accepted(find(), "they were taken as beams, and the columns as lines")) return found;
    exchangeLinesAndBeams(table, none);
    std::swap(table.width, table.height);
    if (auto found = accepted(find(), "its counts of rows and columns were exchanged")) return found;
    exchangeLinesAndBeams(table, none);
    if (auto found = accepted(find(), "its points were taken row by row, where the header says column by column")) return found;
    exchangeLinesAndBeams(table, none);
    std::swap(table.width, table.height);
    return std::nullopt;
}

} // namespace edgescan::files
