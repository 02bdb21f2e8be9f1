// Estimates the errors of the scanner's assembly from surfaces that one over-rotated sweep (more than 180 degrees) sees twice
// (docs/reference/calibration.md).
#pragma once

#include "app/lab/calibration/residuals.h"
#include "core/base/result.h"

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace edgescan::inspect {

struct SelfCalibration {
    AssemblyErrors errors; ///< mean of both directions
    AssemblyErrors sd;     ///< one standard deviation, increased to a realistic value (docs/reference/calibration.md, "Uncertainty")
    Axis axis = Axis::Spin;
    bool turnIsEstimated = true; ///< false: a sweep mounting cannot estimate the turn error; it is 0 without an sd
    double overlapDeg = 0;       ///< overlap of the turn, degrees
    std::size_t cells = 0;       ///< number of cells compared, in both directions and all scans
    double medianBeforeMm = 0;   ///< median of the absolute distance of the two views with the nominal assembly, mm
    double medianAfterMm = 0;
    double noiseMm = 0; ///< median of the distance that noise and the misfit of the fits explain, mm
};

/// Called with the stage and the share of it that is done (0..1); false cancels.
using CalibrationProgress = std::function<bool(const char* stage, double fraction)>;

/// Uses one scan, or several with the same assembly. Error: "cancelled"; an organised cloud; scans of both mountings; a turn that sees too
/// little twice (at least 185 degrees for spin, 300 for sweep); a fan that does not reach beyond a sweep's axis; views that still disagree
/// afterwards; an error that stays as uncertain as before. The sentence names the reason and the remedy.
Result<SelfCalibration> calibrateFromSweeps(std::span<const std::shared_ptr<const Scan>> scans, const CalibrationProgress& goOn = {});

/// A picture with which a person can check the result: the distance of the two views with `errors`, mm, for the cells of the late view.
/// Lines x beams of the scan; NaN elsewhere.
[[nodiscard]] Grid<float> viewDistanceMm(const Scan& scan, const AssemblyErrors& errors);

} // namespace edgescan::inspect
