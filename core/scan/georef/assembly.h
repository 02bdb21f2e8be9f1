// Errors of the scanner's mounting on the stepper, relative to the nominal mounting (docs/reference/calibration.md).
#pragma once

#include "core/scan/georef/calibration.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <cstdint>

namespace edgescan {

/// The errors that can be estimated from surfaces seen twice in one sweep. All other mounting errors are gauge, or cannot be seen in one
/// scan. The values are a plain array for the solver.
///
/// | member | spin, axis z | sweep, axis x |
/// |---|---|---|
/// | t1Mm | mount x | mount y |
/// | t2Mm | mount y | mount z |
/// | tiltDeg | mount roll | mount yaw |
/// | indexDeg | mount pitch | mount pitch |
/// | turnDeg | the stepper's angle at 180 degrees, minus 180 | the same |
struct AssemblyErrors {
    static constexpr std::size_t kCount = 5;
    std::array<double, kCount> values{};

    double& t1Mm() { return values[0]; }
    double& t2Mm() { return values[1]; }
    double& tiltDeg() { return values[2]; }
    double& indexDeg() { return values[3]; }
    double& turnDeg() { return values[4]; }
    [[nodiscard]] double t1Mm() const { return values[0]; }
    [[nodiscard]] double t2Mm() const { return values[1]; }
    [[nodiscard]] double tiltDeg() const { return values[2]; }
    [[nodiscard]] double indexDeg() const { return values[3]; }
    [[nodiscard]] double turnDeg() const { return values[4]; }

    /// The stepper's true angle divided by the recorded one.
    [[nodiscard]] double turnFactor() const { return 1.0 + turnDeg() / 180.0; }

    bool operator==(const AssemblyErrors&) const = default;
};

/// T_MS with these errors.
[[nodiscard]] RigidTransform sensorInMover(Axis axis, const AssemblyErrors& errors);

/// The calibration with its stepper's values taken from `errors`; all else is unchanged.
[[nodiscard]] Calibration withAssembly(Calibration calibration, Axis axis, const AssemblyErrors& errors);

} // namespace edgescan
