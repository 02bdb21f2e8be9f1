// Every cell in order with range and state, as the description says.
#include "core/files/open_save/own_scan.h"

#include "core/base/checked_size.h"
#include "core/base/physical_limits.h"
#include "core/files/point_tables/description.h"

#include <algorithm>

namespace edgescan::files {
namespace {

Result<std::vector<CellState>> statesOf(const PointTable& table, const Source& source) {
    bool known = true; // without a way out of the loop it takes many at once
    for (const std::uint8_t state : table.state) known &= state < kCellStates;
    if (!known) {
        const auto unknown = std::ranges::find_if(table.state, [](std::uint8_t state) { return state >= kCellStates; });
        return source.refused("a cell has the state " + std::to_string(*unknown) + ", which does not exist", "save the scan again");
    }
    std::vector<CellState> states(table.state.size());
    std::ranges::transform(table.state, states.begin(), [](std::uint8_t state) { return static_cast<CellState>(state); });
    return states;
}

} // namespace

Result<Scan> ownScan(PointTable table, const Source& source) {
    const auto grid = parseDescription(table.description, source.path.string());
    if (!grid) return grid.error();
    const std::size_t cells = std::max(table.points.size(), table.rangeMm.size());
    const std::string shape = std::to_string(grid->lines) + " lines x " + std::to_string(grid->beams) + " beams";
    if (productOf({grid->lines, grid->beams}) != cells)
        return source.refused("describes " + shape + " and holds " + std::to_string(cells) + " points", "copy the file again");
    if (table.rangeMm.size() != cells || table.state.size() != cells) {
        return source.refused("describes " + shape + " but has no columns range_mm and state",
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
    takeDescription(scan, *grid);
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

} // namespace edgescan::files
