// The grids that points can have, in the order in which they are tried.
#include "core/files/open_save/place_on_grid.h"

#include "core/files/open_save/own_scan.h"
#include "core/files/open_save/points_on_grid.h"
#include "core/files/open_save/sidecar_grid.h"
#include "core/files/open_save/written_place.h"

#include <limits>

namespace edgescan::files {
namespace {

/// Cells that an export of ours had filled were never measured: they become no returns, and a remark says so.
void takeFilledOut(PointTable& table) {
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
        table.remarks.push_back(std::to_string(filled) +
                                " points were filled and not measured, as filled_sd_mm says: they were taken as no return.");
    table.filledSdMm.clear();
}

/// What the file states of the whole scan, beyond its points.
void takeStatements(Scan& scan, Reading& reading, const Source& source) {
    if (reading.place) placeAsWritten(scan, *reading.place, source);
    if (reading.acquisition) scan.acquisition = std::move(reading.acquisition);
    if (!reading.note.empty()) scan.note = std::move(reading.note);
    std::move(reading.warnings.begin(), reading.warnings.end(), std::back_inserter(scan.warnings));
}

} // namespace

Result<Scan> placeOnGrid(Reading reading, const Source& source) {
    if (auto* table = std::get_if<PointTable>(&reading.content)) {
        takeFilledOut(*table);
        if (auto scan = scanOfSidecar(*table, reading.place, source)) return std::move(*scan);
        const bool own = !table->description.empty();
        auto scan = own ? ownScan(std::move(*table), source) : scanOfPoints(std::move(*table), source);
        if (!scan) return scan;
        if (!own && scan->placement && reading.place && (!reading.place->place.isZero(0.0) || !reading.place->turn.isIdentity(0.0)))
            scan->warnings.push_back(std::string("The matrix of the ") + reading.place->format +
                                     " file was not used: its points are in another frame than the scanner's.");
        reading.content = std::move(*scan);
    }
    Scan& scan = std::get<Scan>(reading.content);
    takeStatements(scan, reading, source);
    return std::move(scan);
}

} // namespace edgescan::files
