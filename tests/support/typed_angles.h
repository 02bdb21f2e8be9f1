// The flags that give a reader the angles of a grid without angles.
#pragma once

#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/scan.h"

#include <variant>

namespace edgescan::test {

/// The angles of a scan whose lines and beams are evenly spaced.
inline ReadingOptions typedAngles(const Scan& scan) {
    const auto& polar = std::get<PolarGeometry>(scan.geometry);
    ReadingOptions options;
    options.beamStartDeg = polar.beamDeg[0];
    options.beamStepDeg = polar.beamDeg[1] - polar.beamDeg[0];
    options.lineStartDeg = polar.lineDeg[0];
    options.lineStepDeg = polar.lineDeg[1] - polar.lineDeg[0];
    options.axis = polar.axis;
    return options;
}

} // namespace edgescan::test
