// Ranges, states and intensities of cells by the points in them.
#include "core/files/open_save/cells_of_points.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/grid_recovery/regrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::files {
namespace {

std::string sizeOfReach() { return significantText(physical::kRangeMm.limits.most * 1e-6, 6) + " km"; }

/// NaN where a cell has no point; empty where no point has an intensity.
void storeIntensity(Scan& scan, const std::vector<float>& intensity, const Grid<std::uint32_t>& pointOf) {
    if (std::ranges::none_of(intensity, [](float value) { return std::isfinite(value); })) return;
    scan.intensity = Grid<float>(pointOf.lines, pointOf.beams, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t k = 0; k < pointOf.size(); ++k) {
        if (scan.state[k] == CellState::Valid) scan.intensity[k] = intensity[pointOf[k]];
    }
}

} // namespace

void fillCells(Scan& scan, const PointTable& table, const std::vector<double>& ranges, const RangeUnit& unit,
               const Grid<std::uint32_t>& pointOf, bool useGiven) {
    const std::vector<float> none;
    const std::vector<float>& given = useGiven ? table.rangeMm : none;
    scan.rangeMm = Grid<float>(pointOf.lines, pointOf.beams);
    scan.state = Grid<CellState>(pointOf.lines, pointOf.beams, CellState::NoReturn);
    std::size_t tooFar = 0;
    for (std::size_t k = 0; k < pointOf.size(); ++k) {
        if (pointOf[k] == RecoveredGrid::kNoPoint || !(ranges[pointOf[k]] > 0)) continue;
        const double mm = given.empty() ? ranges[pointOf[k]] * unit.mmPerUnit : static_cast<double>(given[pointOf[k]]);
        if (!physical::kRangeMm.hold(mm)) { // no scanner reaches as far: as good as no return
            ++tooFar;
            continue;
        }
        scan.rangeMm[k] = static_cast<float>(unit.wholeMm && given.empty() ? std::round(mm) : mm);
        scan.state[k] = CellState::Valid;
    }
    storeIntensity(scan, table.intensity, pointOf);
    if (!unit.remark.empty()) scan.warnings.push_back(unit.remark);
    if (tooFar == 0) return;
    scan.warnings.push_back(
        withValues("%1 points lie farther than %2 from the sensor and were taken as no return: --sensor X,Y,Z says where it stood.",
                   {tooFar, sizeOfReach()}));
}

void storeStates(Scan& scan, const PointTable& table, const Grid<std::uint32_t>& pointOf) {
    if (table.state.empty()) return;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::NoReturn || pointOf[k] == RecoveredGrid::kNoPoint) continue;
        const std::uint8_t state = table.state[pointOf[k]];
        if (state >= kCellStates || state == static_cast<std::uint8_t>(CellState::Valid)) continue;
        scan.state[k] = static_cast<CellState>(state);
        if (!table.rangeMm.empty()) scan.rangeMm[k] = table.rangeMm[pointOf[k]];
    }
}

PointGeometry pointGeometry(const PointTable& table, const Grid<std::uint32_t>& pointOf, const RangeUnit& unit) {
    const double metres = unit.mmPerUnit * kMetresPerMm;
    const Eigen::Vector3d missing = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    PointGeometry geometry{Grid<Eigen::Vector3d>(pointOf.lines, pointOf.beams, missing), table.sensor * metres};
    for (std::size_t k = 0; k < pointOf.size(); ++k) {
        if (pointOf[k] == RecoveredGrid::kNoPoint || !isReturn(table.points[pointOf[k]])) continue;
        geometry.pointsM[k] = metres == 1.0 ? table.points[pointOf[k]] : Eigen::Vector3d(table.points[pointOf[k]] * metres);
    }
    return geometry;
}

} // namespace edgescan::files
