// Whether the shape of a scan depends on a mounting that was not given.
#pragma once

#include "core/scan/grid/scan.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace edgescan {

inline constexpr const char* kMountingAssumed = "How a motor turned the scanner was not said. ASSUMED: "; ///< begins the scan's warning
inline constexpr const char* kAxisAssumed = "the axis (";                   ///< of that sentence, if the axis was not given
inline constexpr const char* kStepAssumed = "the step from line to line ("; ///< and before the degrees of a step not given

enum class Assumed { Nothing, Step, Mounting };

/// What the sentence says was assumed. Step: the axis was given.
[[nodiscard]] inline Assumed assumedIn(std::string_view sentence) {
    if (!sentence.starts_with(kMountingAssumed)) return Assumed::Nothing;
    return sentence.find(kAxisAssumed) == sentence.npos ? Assumed::Step : Assumed::Mounting;
}

/// Ranges are measured in any case; lengths between cells, sizes and coordinates are right only if the assumption is.
[[nodiscard]] inline Assumed assumedIn(const Scan& scan) {
    Assumed most = Assumed::Nothing;
    for (const std::string& warning : scan.warnings) most = std::max(most, assumedIn(std::string_view(warning)));
    return most;
}

[[nodiscard]] inline bool mountingAssumed(const Scan& scan) { return assumedIn(scan) != Assumed::Nothing; }

} // namespace edgescan
