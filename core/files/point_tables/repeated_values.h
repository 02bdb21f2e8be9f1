// The one rule by which every reader recognises a value or a point that means "nothing measured".
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::files {

/// Ranges of a scan, of points or of the lines of a laser, in any unit. What is not above 0 counts as no return already.
struct RangesToJudge {
    std::span<const double> ranges;
    double absolute = 0, relative = 0;                       ///< the same range may differ by absolute + relative * range
    std::function<Eigen::Vector3d(std::size_t)> direction{}; ///< unit vector of a range; asked for few of them
    std::optional<double> stated{};                          ///< the largest number that the file or its type can hold
};

/// A range that means "no return".
struct RepeatedRange {
    double least = 0;      ///< this range and all above it
    std::size_t count = 0; ///< how many they are
};

/// The largest range is one where five or more have it and it is far apart: twice as far as all others, in directions so wide apart
/// that no surface has one range there, as finely as the others are written. Where it is the stated limit it is one if it repeats three
/// times and more often than any other range near it. Empty: it is measured. Linear in the count of ranges.
[[nodiscard]] std::optional<RepeatedRange> repeatedRange(const RangesToJudge& given);

/// A point that means "no return".
struct RepeatedPoint {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::size_t count = 0;
};

/// Points that repeat exactly, eight times and more, where nothing else repeats an eighth as often and no other point is nearer than a
/// tenth of their distance from the origin; three times are enough far outside of all others. At most a few. Points that are rounded so
/// coarsely that many share their place are measured, and so is the point on the axis of a scan, which all lines have. What counts as no
/// return already is not looked at. Linear in the count of points where few repeat.
[[nodiscard]] std::vector<RepeatedPoint> repeatedPoints(std::span<const Eigen::Vector3d> points);

/// "40 ranges of 65535 (in the numbers of the file) ...": what was taken, and the option against it.
[[nodiscard]] std::string repeatedSentence(std::size_t count, const std::string& what);
/// Such a sentence is in the warning.
[[nodiscard]] bool isRepeatedWarning(const std::string& warning);

} // namespace edgescan::files
