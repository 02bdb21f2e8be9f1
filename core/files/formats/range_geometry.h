// Ranges that come as bare numbers, in tables of text, arrays and pictures: their angles, their unit, and which of them are not ranges.
#pragma once

#include "core/files/grid_recovery/recover_grid.h"
#include "core/files/point_tables/source.h"

namespace edgescan::files {

/// What says of ranges that their angles are missing: a refusal, with the count of ranges, and the beginning of a warning.
struct WithoutAngles {
    const char* refusal;
    const char* warning;
};
inline constexpr WithoutAngles kTable{"a table of %1 per line does not say its angles", "The table does not say its angles"},
    kPicture{"a picture of %1 per line does not say its angles", "The picture does not say its angles"},
    kArray{"a numpy array of %1 per line does not say its angles", "The numpy array does not say its angles"};

struct AssumedAngles {
    PolarGeometry polar;
    std::string warning; ///< empty when the user gave all of them
};

/// Angles from the options; where they do not give them those of an LMS511, if there are as many beams as it has (1141). Error: the options
/// that are needed.
Result<AssumedAngles> assumedAngles(std::size_t lines, std::size_t beams, const WithoutAngles& what, const Source& source);

/// Error when a sweep of so many lines and columns has no angles, before anything is read.
Result<Done> checkAnglesKnown(std::size_t beams, const WithoutAngles& what, const Source& source);

/// Numbers as a file has them, lines x beams; what is not finite is a missing return.
struct BareRanges {
    std::vector<double> values;
    std::size_t lines = 0, beams = 0;
    Precision precision;               ///< how exactly they are written
    std::optional<double> stated = {}; ///< the largest number of the type, where that is small
};

/// A scan of them, with angles as assumedAngles() and the unit found from the numbers where the options do not say it. 0, infinity and one
/// number below 0 that repeats are missing returns, with a warning, and so is the largest number where it means one
/// (repeated_values.h). Error: the angles are not known, or several numbers are below 0; `at` names the place of a cell ("line 3, column
/// 7").
Result<Scan> scanFromRanges(BareRanges ranges, const WithoutAngles& what, const Source& source,
                            const std::function<std::string(std::size_t line, std::size_t beam)>& at);

/// A number that means "no range" in tables: -1, or -9 and less.
[[nodiscard]] constexpr bool isNoRangeMark(double number) { return number == -1 || number == -0.001 || number <= -9; }

/// Sentences about numbers that are accepted and seldom meant, where the unit and the angles are given and not found: ranges that no
/// scanner measures, lines at one angle. `unit`: where the unit is given.
[[nodiscard]] std::vector<std::string> seldomMeasured(const Scan& scan, const std::string& unit);

} // namespace edgescan::files
