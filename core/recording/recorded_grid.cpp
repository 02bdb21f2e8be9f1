// Applying the description of a grid to what came out of telegrams.
#include "core/recording/recorded_grid.h"

#include "core/points/description.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

/// Raw counts are what the telegrams carried; the description says what they mean.
void readCounts(Scan& scan, const GridDescription& grid) {
    const auto holds = [](const std::vector<std::uint32_t>& codes, std::uint32_t count) {
        return std::find(codes.begin(), codes.end(), count) != codes.end();
    };
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Lost) continue;
        const double raw = static_cast<double>(scan.rangeMm[k]) / scan.unitMm;
        const auto count = static_cast<std::uint32_t>(std::lround(std::clamp(raw, 0.0, 65535.0)));
        scan.rangeMm[k] = static_cast<float>(count * grid.unitMm);
        scan.state[k] = CellState::Valid;
        if (holds(grid.statusCodes, count)) scan.state[k] = CellState::DeviceStatus;
        if (holds(grid.noReturnCodes, count)) scan.state[k] = CellState::NoReturn;
    }
    for (const StateRun& run : grid.stateRuns) {
        const auto end = std::min<std::uint64_t>(run.firstCell + run.cells, scan.cells());
        for (std::uint64_t k = run.firstCell; k < end; ++k) scan.state[k] = run.state;
    }
}

} // namespace

Result<Scan> withRecordedGrid(Scan scan, const SweepMetadata& metadata, const std::string& where) {
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
    scan.unitMm = grid->unitMm;
    scan.noReturnCodes = grid->noReturnCodes;
    scan.statusCodes = grid->statusCodes;
    scan.note = grid->note;
    if (grid->placement && grid->lines == lines) scan.placement = grid->placement;
    scan.acquisition = grid->acquisition;
    return scan;
}

} // namespace edgescan
