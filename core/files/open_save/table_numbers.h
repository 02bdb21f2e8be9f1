// What the numbers of a table of points mean: their unit, how they were rounded, where the sensor is among them.
#pragma once

#include "core/files/grid_recovery/unit.h"
#include "core/files/point_tables/point_table.h"

#include <string>
#include <vector>

namespace edgescan::files {

/// A binary file does not say how its numbers were rounded; when all are whole thousandths, say, they were.
[[nodiscard]] Precision withDecimals(Precision precision, const std::vector<Eigen::Vector3d>& points);

/// Of every point about the table's sensor, in the numbers of the file; 0 where it is not a return.
[[nodiscard]] std::vector<double> rangesOf(const PointTable& table);

/// The unit that the user gave, that the file says, or that the numbers show, in this order.
[[nodiscard]] RangeUnit unitOf(const PointTable& table, const std::vector<double>& ranges, const Source& source);

/// How coarse the numbers are, in words, where they are so large that 4-byte floats hold them only in steps; else empty.
[[nodiscard]] std::string coarseStep(const PointTable& table,
                                     const char* sentence = "numbers up to %1 in this file have a resolution of about %2");

/// `what`, and coarseStep behind it.
[[nodiscard]] std::string withCoarseStep(std::string what, const PointTable& table);

/// Large numbers in 4-byte floats are coarse wherever the sensor is; printed ones are as fine as their decimals.
[[nodiscard]] Precision precisionAboutSensor(const PointTable& table);

/// The same where the sensor's place is not known: numbers with more digits than a 4-byte float are as fine as their spread.
[[nodiscard]] Precision precisionAnywhere(const PointTable& table);

/// The sensor's place that the user gave in metres, in the file's own numbers. Where these do not say their unit, each one puts the
/// sensor elsewhere: one in which the ranges about it are whole millimetres, else metres within a scanner's reach, else the nearest.
void applyGivenSensor(PointTable& table, const Source& source);

/// A sensor farther away than that, in sizes of all that it measured, sees all points within about a degree: no scanner measures so.
inline constexpr double kMostTimesTheirSize = 50;

/// Takes the origin in place of a sensor's place of the file that cannot be: so far away that no scanner distinguishes the points from
/// there. A remark says so. True where it did.
[[nodiscard]] bool dropImpossibleSensor(PointTable& table, const Source& source);

/// An organised cloud whose points all lie one way from the origin was not taken from there: coordinates of a mine, and it is unknown where
/// the scanner was. Empty: nothing speaks against the origin, or a sensor's place is known.
[[nodiscard]] std::optional<Error> wrongOrigin(const PointTable& table, const Source& source);

} // namespace edgescan::files
