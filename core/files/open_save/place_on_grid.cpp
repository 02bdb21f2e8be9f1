// The grids that points can have, in the order in which they are tried.
#include "core/files/open_save/place_on_grid.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include "core/base/checked_size.h"
#include "core/base/physical_limits.h"
#include "core/files/open_save/points_on_grid.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/files/open_save/written_place.h"
#include "core/files/point_tables/description.h"
#include "core/files/point_tables/point_table.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace edgescan::files {
namespace {

Result<std::vector<CellState>> statesOf(const PointTable& table, const Source& source) {
    bool known = true; // without a way out of the loop it takes many at once
    for (const std::uint8_t state : table.state) known &= state < kCellStates;
    if (!known) {
        const auto unknown = std::ranges::find_if(table.state, [](std::uint8_t state) { return state >= kCellStates; });
        return source.refused(withValues("a cell has the state %1, which does not exist", {*unknown}), "save the scan again");
    }
    std::vector<CellState> states(table.state.size());
    std::ranges::transform(table.state, states.begin(), [](std::uint8_t state) { return static_cast<CellState>(state); });
    return states;
}

/// The table's description, ranges and states as the scan they were: every cell in order, bit-exact. Error: they do not fit each other.
Result<Scan> ownScan(PointTable table, const Source& source) {
    const auto grid = parseDescription(table.description, source.path.string());
    if (!grid) return grid.error();
    const std::size_t cells = std::max(table.points.size(), table.rangeMm.size());
    const std::string shape = withValues("%1 lines x %2 beams", {grid->lines, grid->beams});
    if (productOf({grid->lines, grid->beams}) != cells)
        return source.refused(withValues("describes %1 and holds %2", {shape, counted(cells, "point")}), "copy the file again");
    if (table.rangeMm.size() != cells || table.state.size() != cells) {
        return source.refused(withValues("describes %1 but has no columns range_mm and state", {shape}),
                              "save the scan again, or remove the comment lines");
    }
    auto states = statesOf(table, source);
    if (!states) return states.error();
    const int lines = static_cast<int>(grid->lines);
    const int beams = static_cast<int>(grid->beams);
    if (source.options->unitMm && *source.options->unitMm != 1000.0)
        return source.refused("--unit does not apply: this program saved the file, in metres", "leave --unit out");
    Scan scan;
    scan.format = table.format;
    scan.rangeMm = Grid<float>(lines, beams, std::move(table.rangeMm));
    scan.state = Grid<CellState>(lines, beams, std::move(*states));
    if (table.intensity.size() == cells) scan.intensity = Grid<float>(lines, beams, std::move(table.intensity));
    for (std::size_t k = 0; k < cells; ++k) {
        if (scan.state[k] == CellState::Valid && !physical::kRangeMm.hold(scan.rangeMm[k]))
            return source.refused("a valid cell has a number that is not a range", "save the scan again");
    }
    applyDescription(scan, *grid);
    scan.warnings = std::move(table.remarks);
    if (table.scannerPoints.size() == cells) table.points = std::move(table.scannerPoints);
    std::optional<PolarGeometry> polar = polarOf(*grid);
    if (grid->sensorM) {
        scan.geometry = PointGeometry{Grid<Eigen::Vector3d>(lines, beams, std::move(table.points)), *grid->sensorM, std::move(polar)};
    } else if (polar) {
        scan.geometry = std::move(*polar);
    } else {
        return source.refused("the description in the comment lines has no angles", "save the scan again, or remove the comment lines");
    }
    return scan;
}

/// Cells that an export of ours had filled were never measured: they become no returns, and a remark says so.
void removeFilledCells(PointTable& table) {
    if (table.filledSdMm.size() != table.points.size()) return;
    std::size_t filled = 0;
    for (std::size_t n = 0; n < table.points.size(); ++n) {
        if (!(table.filledSdMm[n] > 0)) continue;
        ++filled;
        table.points[n].setConstant(std::numeric_limits<double>::quiet_NaN());
        if (n < table.rangeMm.size()) table.rangeMm[n] = 0;
        if (n < table.state.size() && table.state[n] == static_cast<std::uint8_t>(CellState::Valid))
            table.state[n] = static_cast<std::uint8_t>(CellState::NoReturn);
    }
    if (filled > 0)
        table.remarks.push_back(counted(filled, "point was filled and not measured, as filled_sd_mm says: it was taken as no return.",
                                        "points were filled and not measured, as filled_sd_mm says: they were taken as no return."));
    table.filledSdMm.clear();
}

/// Of options that place points, for a scan whose cells the file gives.
void warnOfIdle(Scan& scan, const Source& source) {
    constexpr std::array<std::string_view, 3> kPlacing{"sensor", "grid-step", "project"};
    std::ranges::copy(idleOptions(*source.options, kPlacing, "the file gives the grid of its cells"), std::back_inserter(scan.warnings));
}

/// What the file states of the whole scan, beyond its points.
void applyStatements(Scan& scan, Reading& reading, const Source& source) {
    if (reading.place) placeAsWritten(scan, *reading.place, source);
    if (reading.acquisition) scan.acquisition = std::move(reading.acquisition);
    if (!reading.note.empty()) scan.note = std::move(reading.note);
    std::move(reading.warnings.begin(), reading.warnings.end(), std::back_inserter(scan.warnings));
}

} // namespace

Result<Scan> placeOnGrid(Reading reading, const Source& source) {
    if (auto* table = std::get_if<PointTable>(&reading.content)) {
        removeFilledCells(*table);
        if (auto scan = scanOfSidecar(*table, reading.place, source)) {
            warnOfIdle(*scan, source);
            return std::move(*scan);
        }
        const bool own = !table->description.empty();
        auto scan = own ? ownScan(std::move(*table), source) : scanOfPoints(std::move(*table), source);
        if (!scan) return scan;
        if (own) warnOfIdle(*scan, source);
        if (!own && scan->placement && reading.place && (!reading.place->place.isZero(0.0) || !reading.place->turn.isIdentity(0.0)))
            scan->warnings.push_back(withValues(
                "The matrix of the %1 file was not used: its points are in another frame than the scanner's.", {reading.place->format}));
        reading.content = std::move(*scan);
    } else {
        warnOfIdle(std::get<Scan>(reading.content), source);
    }
    Scan& scan = std::get<Scan>(reading.content);
    applyStatements(scan, reading, source);
    return std::move(scan);
}

} // namespace edgescan::files
