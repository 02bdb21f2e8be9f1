// Whether the shape of a scan depends on a mounting that was not given.
#pragma once

#include "core/scan/grid/scan.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace edgescan {

inline constexpr const char* kMountingAssumed =
    "How a motor turned the scanner was not said in full. ASSUMED: ";         ///< begins the scan's warning
inline constexpr const char* kAxisAssumed = "the axis (";                     ///< of that sentence, if the axis was not given
inline constexpr const char* kAxisFromRanges = ", seen in the ranges)";       ///< behind the name of an axis that the ranges show
inline constexpr const char* kStepAssumed = "the step from line to line (";   ///< and before the degrees of a step not given
inline constexpr const char* kFirstAssumed = "the angle of the first line ("; ///< likewise

/// Direction: only the angle of the first line, which turns the whole cloud. SeenAxis: the axis too, but the ranges show it
/// (core/scan/grid/axis_from_ranges.h). Step: the axis was given, or the ranges show it.
enum class Assumed { Nothing, Direction, SeenAxis, Step, Mounting };

/// What the sentence says was assumed.
[[nodiscard]] inline Assumed assumedIn(std::string_view sentence) {
    if (!sentence.starts_with(kMountingAssumed)) return Assumed::Nothing;
    const auto has = [&](std::string_view words) { return sentence.find(words) != sentence.npos; };
    if (has(kAxisAssumed) && !has(kAxisFromRanges)) return Assumed::Mounting;
    return has(kStepAssumed) ? Assumed::Step : has(kAxisAssumed) ? Assumed::SeenAxis : Assumed::Direction;
}

/// Ranges are measured in any case; lengths between cells and sizes are right only if the assumption is, and coordinates too.
[[nodiscard]] inline Assumed assumedIn(const Scan& scan) {
    Assumed most = Assumed::Nothing;
    for (const std::string& warning : scan.warnings) most = std::max(most, assumedIn(std::string_view(warning)));
    return most;
}

/// The axis was not given, and the ranges show it.
[[nodiscard]] inline bool isAxisFromRanges(const Scan& scan) {
    return std::ranges::any_of(scan.warnings,
                               [](const std::string& w) { return w.starts_with(kMountingAssumed) && w.find(kAxisFromRanges) != w.npos; });
}

/// Lengths depend on what was assumed.
[[nodiscard]] inline bool mountingAssumed(const Scan& scan) { return assumedIn(scan) > Assumed::Direction; }

} // namespace edgescan
