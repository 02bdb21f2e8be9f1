// Turns flags and a calibration into the settings of a sweep.
#include "app/shared/mounting.h"

#include "app/shared/numbers.h"
#include "core/scan/georef/calibration.h"

#include <cmath>

namespace edgescan::cli {

void addMountingFlags(CLI::App& command, Mounting& mounting, const std::string& group) {
    addNumber(command, "--expected-lines", mounting.expectedLines, {0, 20000}, "Lines of a whole sweep; 0 = not known").group(group);
    addNumber(command, "--ticks-per-degree", mounting.ticksPerDeg, {-1e9, 1e9}, "Encoder counts per degree, where there is an encoder")
        .group(group);
    command.add_flag("--stop-and-go", mounting.stopAndGo, "The stepper stops while a line is measured; without this flag it turns on")
        ->group(group);
}

Result<scanner::SweepSettings> sweepOf(const Mounting& mounting) {
    scanner::SweepSettings sweep = scanner::assumedSweep();
    if (!mounting.calibration.empty()) {
        const auto calibration = openCalibration(mounting.calibration);
        if (!calibration) return calibration.error();
        sweep.axis = std::abs(calibration->axis.z()) >= std::abs(calibration->axis.x()) ? Axis::Spin : Axis::Sweep;
        sweep.degPerLine = calibration->degPerStep; // its first angle and direction are applied with the pose of the scanner
        sweep.indexDeg = calibration->mirrorIndexDeg;
        sweep.axisAssumed = sweep.stepAssumed = false;
    }
    if (mounting.axis) {
        sweep.axis = *mounting.axis;
        sweep.axisAssumed = false;
    }
    if (mounting.lineStepDeg) {
        sweep.degPerLine = mounting.lineStepDeg;
        sweep.stepAssumed = false;
    }
    sweep.firstLineDeg = mounting.firstLineDeg.value_or(sweep.firstLineDeg);
    const bool calibrated = !mounting.calibration.empty(); // its first angle is applied with the pose
    sweep.firstAssumed = !mounting.firstLineDeg && !calibrated && scanner::guessesFirst(sweep);
    sweep.ticksPerDeg = mounting.ticksPerDeg;
    sweep.expectedLines = mounting.expectedLines;
    if (sweep.stepAssumed) sweep.degPerLine = scanner::assumedStepDeg(sweep.expectedLines);
    sweep.continuous = !mounting.stopAndGo;
    return sweep;
}

} // namespace edgescan::cli
