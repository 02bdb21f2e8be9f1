// Prepares scans for the PCL methods.
#include "app/lab/peers/peers.h"

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/inverse_range.h"

#include <limits>

namespace edgescan::lab {

PclScan pclScan(const Scan& scan) {
    const Eigen::Vector3f nowhere = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    const CartesianTables tables(scan);
    const AngularSteps steps = angularSteps(scan);
    PclScan result{Grid<Eigen::Vector3f>(scan.lines(), scan.beams(), nowhere), Grid<Eigen::Vector3f>(scan.lines(), scan.beams(), nowhere),
                   Grid<Eigen::Vector3f>(scan.lines(), scan.beams(), nowhere)};
    std::vector<float> across(static_cast<std::size_t>(scan.beams()));
    for (std::size_t j = 1; j < across.size(); ++j) across[j] = across[j - 1] + steps.beam[j];
    const float middle = across.empty() ? 0.0F : across[across.size() / 2];
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            const std::size_t k = scan.rangeMm.index(i, j);
            result.directions[k] = tables.direction(i, j).cast<float>();
            if (scan.state[k] != CellState::Valid) continue;
            result.pointsM[k] = (tables.point(k) - tables.sensor()).cast<float>();
            const float range = scan.rangeMm[k] * 0.001F;
            const float down = static_cast<float>(i - scan.lines() / 2) * steps.lineAt(i, j);
            result.unrolledM[k] = {(across[static_cast<std::size_t>(j)] - middle) * range, down * range, range};
        }
    }
    return result;
}

} // namespace edgescan::lab
