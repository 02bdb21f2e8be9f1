// What a placed scan looks like in the mine, and whether that fits the mounting that was typed for it.
#pragma once

#include "core/scan/georef/calibration.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <cstdint>

namespace edgescan {

/// Easting, Northing and RL, of all points.
struct PlacedLook {
    Eigen::Vector3d sensor, least, most; ///< the scanner, and the span of its points and itself
    double elevationDeg = 0.0;           ///< of the scanner's z axis above the horizon
    double belowShare = 0.0;             ///< 0..1 of the points: lower than the scanner
};
/// The scan must have a placement.
[[nodiscard]] PlacedLook placedLook(const Scan& scan);

enum class LookDoubt : std::uint8_t {
    None,
    TurnedForward, ///< mounted looking forward: what a scan without a pose shows above the scanner is in front of it
    NotUp,         ///< mounted looking up, and pitch and roll turn it away from up
    MostlyBelow,   ///< mounted looking up, and most points are lower than the scanner
};
/// Only of mountings given by a word; three angles or a matrix were measured.
[[nodiscard]] LookDoubt lookDoubt(const PlacedLook& look, Viewing viewing);

} // namespace edgescan
