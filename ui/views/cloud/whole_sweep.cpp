// Extends the line angles of a sweep.
#include "ui/views/cloud/whole_sweep.h"

#include "core/base/order_statistic.h"
#include "core/scan/grid/mean_step.h"
#include "core/scan/grid/scan.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr int kCoarseSide = 33;     // lines and beams of the coarse cloud
constexpr double kHalfTurn = 180.0; // degrees

float medianRange(const Scan& scan) {
    std::vector<float> ranges;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state.cells[k] == CellState::Valid) ranges.push_back(scan.rangeMm.cells[k]);
    }
    return median(std::move(ranges));
}

} // namespace

std::shared_ptr<const CloudGeometry> wholeSweep(const Scan& scan, int expectedLines) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || scan.placement || polar->lineDeg.size() < 2 || polar->beamDeg.size() < 2) return nullptr;
    const double step = meanStepDeg(polar->lineDeg);
    const float range = medianRange(scan);
    if (!std::isfinite(step) || step == 0.0 || range <= 0.0F) return nullptr;
    const double lines = expectedLines > 0 ? expectedLines : std::max<double>(scan.lines(), 1.0 + kHalfTurn / std::abs(step));
    PolarGeometry coarse{{}, {}, polar->axis, polar->lineDirection};
    for (int n = 0; n < kCoarseSide; ++n) {
        const double share = n / (kCoarseSide - 1.0);
        coarse.lineDeg.push_back(polar->lineDeg.front() + share * step * (lines - 1.0));
        coarse.beamDeg.push_back(std::lerp(polar->beamDeg.front(), polar->beamDeg.back(), share));
    }
    Scan whole;
    whole.rangeMm = Grid<float>(kCoarseSide, kCoarseSide, range);
    whole.state = Grid<CellState>(kCoarseSide, kCoarseSide, CellState::Valid);
    whole.geometry = std::move(coarse);
    return makeCloudGeometry(whole);
}

} // namespace edgescan::ui
