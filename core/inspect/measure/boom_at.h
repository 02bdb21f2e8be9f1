// The position of a cell relative to the boom that carries the head.
#pragma once

#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace edgescan::inspect {

/// The boom is that of the moment when the cell's line was measured; it may have moved since.
struct BoomAtCell {
    double distanceM = 0.0; ///< to the nearest point of the straight line from pivot to head; the thickness of the boom is not subtracted
    /// 0..90 between the surface's normal and the boom: 0 = the boom meets the surface at a right angle; empty without a normal
    std::optional<double> angleDeg;
};

/// Empty if the scan has no placement with a boom. `k` must be a valid cell; `normal`: of its surface, frame of the scan.
[[nodiscard]] std::optional<BoomAtCell> boomAt(const Scan& scan, std::size_t k, const std::optional<Eigen::Vector3d>& normal);

} // namespace edgescan::inspect
