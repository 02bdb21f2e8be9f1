// Applying the description of a grid to what came out of telegrams.
#include "core/files/recording/recorded_grid.h"

#include "core/files/point_tables/description.h"
#include "core/scan/grid/count_states.h"

#include <algorithm>
#include <cmath>

namespace edgescan::files {
namespace {

/// Raw counts are what the telegrams carried; the description says what they mean.
void readCounts(Scan& scan, const GridDescription& grid) {
    const CountStates states = countStates(grid.noReturnCodes, grid.statusCodes);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Lost) continue;
        const double raw = static_cast<double>(scan.rangeMm[k]) / scan.unitMm;
        const auto count = static_cast<std::uint32_t>(std::lround(std::clamp(raw, 0.0, 65535.0)));
        scan.rangeMm[k] = static_cast<float>(count * grid.unitMm);
        scan.state[k] = states[count];
    }
    applyStateRuns(scan, grid);
}

} // namespace

Result<Scan> withRecordedGrid(Scan scan, const scanner::SweepMetadata& metadata, const std::string& where) {
    const auto found = metadata.find(kRecordedGridKey);
    if (found == metadata.end()) return scan;
    const auto grid = parseDescription(found->second, where);
    if (!grid) return grid.error();
    const auto lines = static_cast<std::uint64_t>(scan.lines());
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    if (grid->beams != static_cast<std::uint64_t>(scan.beams()) || grid->lines < lines || !grid->beamDeg || !grid->lineDeg) {
        scan.warnings.emplace_back("The recording describes another grid than its telegrams make: the telegrams count.");
        return scan;
    }
    readCounts(scan, *grid);
    polar.beamDeg = anglesOf(*grid->beamDeg, grid->beams);
    const std::vector<double> lineDeg = anglesOf(*grid->lineDeg, std::holds_alternative<AngleSteps>(*grid->lineDeg) ? lines : grid->lines);
    polar.lineDeg.assign(lineDeg.begin(), lineDeg.begin() + static_cast<std::ptrdiff_t>(lines));
    polar.lineSkewDeg = grid->lineSkewDeg ? anglesOf(*grid->lineSkewDeg, grid->beams) : std::vector<double>{};
    if (grid->axis) polar.axis = *grid->axis;
    polar.lineDirection = grid->lineDirection;
    const auto readings = scan.placement; // a place per line needs all the lines
    applyDescription(scan, *grid);
    if (!grid->placement || grid->lines != lines) scan.placement = readings;
    return scan;
}

} // namespace edgescan::files
