// The beam angles of a telegram's grid in order: tests compare the sweep's angles with them.
#pragma once

#include "core/scanner/sick_lms/scan_telegram.h"

#include <algorithm>
#include <vector>

namespace edgescan {

inline std::vector<double> beamAnglesDeg(const scanner::BeamGrid& grid) {
    std::vector<double> angles;
    angles.reserve(static_cast<std::size_t>(std::max(grid.beams, 0)));
    for (int beam = 0; beam < grid.beams; ++beam) angles.push_back(grid.startDeg + beam * grid.stepDeg);
    return angles;
}

} // namespace edgescan
