// The parts of grid recognition: points seen along a rotation axis, fits of lines and beams to them, tidy angles.
#pragma once

#include "core/base/grid.h"
#include "core/files/grid_recovery/recover_grid.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::files::recognition {

inline constexpr double kPi = std::numbers::pi;
inline constexpr std::uint32_t kNone = RecoveredGrid::kNoPoint;
inline constexpr double kShareOnGrid = 0.99; // of the points, for a grid to be believed

inline constexpr double kLeastFilled = 0.05; // of the cells; below, any cloud would fit
inline constexpr double kMostDoubled = 0.05; // of the points, in cells with another one; above, the cells are too large

/// A point with u along the rotation axis; (u, v, w) is right-handed. A scan line is the half planes at angle `plane` and
/// plane + 180 degrees about u; within it `tilt` is the signed angle from u. Missing points are all zero.
struct AxisPoint {
    double u = 0.0, v = 0.0, w = 0.0;

    [[nodiscard]] bool missing() const { return u == 0.0 && v == 0.0 && w == 0.0; }
    [[nodiscard]] double squaredRadius() const { return v * v + w * w; }
    [[nodiscard]] double range() const { return std::sqrt(u * u + squaredRadius()); }
    [[nodiscard]] double plane() const { return std::atan2(w, v); }
    /// Distance from the axis, negative on the far half of the plane; and how far off the plane.
    [[nodiscard]] double radiusIn(double cosPlane, double sinPlane) const { return v * cosPlane + w * sinPlane; }
    [[nodiscard]] double offPlane(double cosPlane, double sinPlane) const { return w * cosPlane - v * sinPlane; }
};

/// Lines and beams found for one rotation axis. Radians.
struct Fit {
    std::vector<double> plane;   ///< one per line, continuous
    std::vector<double> tilt;    ///< one per beam, continuous and monotone
    Grid<std::uint32_t> pointOf; ///< lines x beams, RecoveredGrid::kNoPoint where empty
    bool complete = false;       ///< every cell was in the list, in order
    std::size_t unplaced = 0;
    std::size_t doubled = 0; ///< different points in one cell
    std::size_t copied = 0;  ///< the same point again
    double residual = 0.0;   ///< median distance from the fitted beam in beam steps
};

/// What was seen when no fit came out, for the sentence.
struct NoFit {
    std::size_t lines = 0, beams = 0; ///< groups of angles found, 0 = no group was distinct
    double onGrid = 0.0;              ///< share of points on them
};

/// The list is the grid, cell after cell, line by line or beam by beam; points without a return are in it.
/// `rowLength` 0 = every divisor of the number of points is tried.
std::optional<Fit> fitFileOrder(std::span<const AxisPoint> points, const Precision& precision, std::size_t rowLength);

/// Points in the order of the scan, line after line, some left out: a line begins where the mirror starts over.
std::optional<Fit> fitRuns(std::span<const AxisPoint> points, const Precision& precision, NoFit& seen);

/// Points in any order, some left out: lines and beams are groups of angles with voids between them.
std::optional<Fit> fitGroups(std::span<const AxisPoint> points, const Precision& precision, NoFit& seen);

/// Angles measured again from all points of each line and beam, with the standard error of each. Radians.
struct MeasuredAngles {
    std::vector<double> plane, planeError, tilt, tiltError;
};
[[nodiscard]] MeasuredAngles measureAngles(const Fit& fit, std::span<const AxisPoint> points, const Precision& precision);

/// Shares of the points on the grid.
struct OnGrid {
    double share = 0.0;    ///< of points with a return that lie within a quarter step of their cell's beam
    double residual = 0.0; ///< median distance in beam steps
    bool telling = false;  ///< the points are written precisely enough to distinguish cells
};
[[nodiscard]] OnGrid judge(const Fit& fit, std::span<const AxisPoint> points, const Precision& precision);

/// Degrees made tidy: start + i * step with few digits where that agrees with the measured values within their errors; else
/// the measured values, rounded below their error.
[[nodiscard]] std::vector<double> tidyAngles(const std::vector<double>& degrees, const std::vector<double>& errors);

/// Where angles that are multiples of one step leave some out: the place of each among all of them; empty when they do not.
[[nodiscard]] std::vector<std::size_t> placesOnSteps(const std::vector<double>& angles);

/// Median of absolute differences between neighbours; 0 when there are none.
[[nodiscard]] double medianStep(const std::vector<double>& angles);

} // namespace edgescan::files::recognition
