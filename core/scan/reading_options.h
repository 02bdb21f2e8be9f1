// What the user says on opening a file.
#pragma once

#include "core/scan/scan.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace edgescan {

/// What to do with points that lie on no grid of lines and beams.
enum class Projection : std::uint8_t {
    Auto,   ///< project them when no grid is found
    Always, ///< project them about the sensor without looking for a grid
    Never,  ///< refuse them
};

/// An option that is empty is taken from the file, or found out and told in Scan::warnings.
struct OpenOptions {
    std::optional<double> beamStartDeg;     ///< range CSV: angle of the first column (--beam-start)
    std::optional<double> beamStepDeg;      ///< --beam-step
    std::optional<double> lineStartDeg;     ///< angle of the first line (--line-start)
    std::optional<double> lineStepDeg;      ///< --line-step
    std::optional<Axis> axis;               ///< how the stepper turns (--axis); decides range CSV and point lists that fit both
    std::optional<double> unitMm;           ///< millimetres per number in the file, instead of what it says or what is detected
    std::optional<Eigen::Vector3d> sensorM; ///< where a cloud was taken from, metres, in the frame of its points (--sensor)
    std::optional<double> gridStepDeg;      ///< cells of a projected cloud (--grid-step); empty = from the spacing of its points
    Projection projection = Projection::Auto;
    std::string pose;          ///< pose file (--pose); with the calibration it gives the scan its place in the mine
    std::string calibration;   ///< the robot's calibration file (--calibration)
    bool straighten = false;   ///< correct the angles of interlaced beams and slipped lines (--straighten)
    std::size_t scanIndex = 0; ///< which scan of a file that holds several, from 0 (--scan)

    /// Told the stage and how much of it is done (0..1), from the thread that opens; false cancels: Error "cancelled".
    std::function<bool(const char* stage, double fraction)> progress;
};

} // namespace edgescan
