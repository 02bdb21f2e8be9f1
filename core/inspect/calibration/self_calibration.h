// The errors of the scanner's assembly from surfaces that one turn sees twice (docs/calibration.md).
#pragma once

#include "core/base/result.h"
#include "core/inspect/calibration/residuals.h"

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace edgescan {

struct SelfCalibration {
    AssemblyErrors errors; ///< mean of both ways
    AssemblyErrors sd;     ///< one standard deviation, made honest (docs/calibration.md, "Uncertainty")
    Axis axis = Axis::Spin;
    bool turnTold = true;      ///< false: a sweep mounting tells nothing of the turn, whose error stays 0 and has no sd
    double overlapDeg = 0;     ///< of the turn, seen twice
    std::size_t cells = 0;     ///< that were compared, both ways and all scans
    double medianBeforeMm = 0; ///< median of |the two views' distance| with the nominal assembly
    double medianAfterMm = 0;
    double noiseMm = 0; ///< median of what noise and misfit of the fits explain
};

/// Told the stage and how much of it is done (0..1); false gives up.
using CalibrationProgress = std::function<bool(const char* stage, double fraction)>;

/// From one scan or several of the same assembly. Error: "cancelled", an organised cloud, both mountings at once, a turn that shows too
/// little twice (185 degrees for spin, 300 for sweep), a fan that does not reach beyond a sweep's axis, views that do not agree afterwards,
/// an error that stays as unknown as it was; the sentence says which and what to do.
Result<SelfCalibration> calibrateFromTurn(std::span<const std::shared_ptr<const Scan>> scans, const CalibrationProgress& goOn = {});

/// One picture of a scan's surfaces seen twice, for a person to judge: the distance of the two views with `errors`, for the cells of the
/// late view. Lines x beams of the scan; NaN elsewhere.
[[nodiscard]] Grid<float> viewsApartMm(const Scan& scan, const AssemblyErrors& errors);

} // namespace edgescan
