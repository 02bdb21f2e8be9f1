// Limits for the numbers of files, flags and settings, set by physics and surveying. A number outside its limits cannot be a measurement.
// All readers use this one table; docs/reference/formats.md shows it.
#pragma once

#include <array>
#include <limits>

namespace edgescan {

struct NumberLimits {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    /// False for NaN.
    [[nodiscard]] constexpr bool hold(double value) const { return value >= least && value <= most; }
};

/// One row of the table.
struct PhysicalLimit {
    const char* what;
    const char* unit; ///< empty: a number without unit
    NumberLimits limits;
    const char* why;
    bool zero = true; ///< whether 0 is allowed

    [[nodiscard]] constexpr bool hold(double value) const { return limits.hold(value) && (zero || value != 0.0); }
};

namespace physical {

inline constexpr PhysicalLimit kRangeMm{"range", "mm", {0, 1e9}, "no scanner reaches farther than 1,000 km"};
inline constexpr PhysicalLimit kUnitMm{"unit of counts and numbers", "mm", {1e-6, 1e6}, "from a nanometre to a kilometre"};
inline constexpr PhysicalLimit kBeamDeg{"angle of a beam, a heading or a mounting", "degrees", {-360, 360}, "one turn"};
inline constexpr PhysicalLimit kLineDeg{"angle of a line", "degrees", {-1e6, 1e6}, "a stepper that turns on for days"};
inline constexpr PhysicalLimit kStepDeg{
    "step from beam to beam or line to line", "degrees", {-180, 180}, "not 0: two beams never look the same way", false};
inline constexpr PhysicalLimit kGridStepDeg{
    "cell of a projected cloud", "degrees", {1e-4, 45}, "finer than any scanner, coarser than any use"};
inline constexpr PhysicalLimit kTiltDeg{"tilt, pitch", "degrees", {-90, 90}, "beyond it, it is the other way round"};
inline constexpr PhysicalLimit kRollDeg{"roll, convergence", "degrees", {-180, 180}, "half a turn"};
inline constexpr PhysicalLimit kPlaceM{"easting, northing, place of a sensor", "m", {-1e8, 1e8}, "more than the way round the earth"};
inline constexpr PhysicalLimit kElevationM{"elevation", "m", {-2e4, 2e4}, "deeper than any mine, higher than any mountain"};
inline constexpr PhysicalLimit kLeverM{"lever arm on a robot", "m", {-100, 100}, "nothing on a robot is farther away"};
inline constexpr PhysicalLimit kCoordinate{
    "coordinate, in the file's own unit", "", {-1e12, 1e12}, "the way round the earth in tenths of a millimetre"};
inline constexpr PhysicalLimit kGridScale{"scale of a mine grid", "", {0.9, 1.1}, "map projections stay within a hundredth"};
inline constexpr PhysicalLimit kAlongOneSide{"lines, beams", "", {1, 1 << 30}, "more than a day of scanning"};

} // namespace physical

inline constexpr double kFootMm = 304.8, kUsSurveyFootMm = 1200.0 / 3937.0 * 1000.0;

/// All rows, as the document shows them.
inline constexpr std::array<PhysicalLimit, 14> kPhysicalLimits{
    physical::kRangeMm,     physical::kUnitMm,     physical::kBeamDeg,   physical::kLineDeg,     physical::kStepDeg,
    physical::kGridStepDeg, physical::kTiltDeg,    physical::kRollDeg,   physical::kPlaceM,      physical::kElevationM,
    physical::kLeverM,      physical::kCoordinate, physical::kGridScale, physical::kAlongOneSide};

} // namespace edgescan
