// Whether a scan is the one that its ground truth was made with.
#pragma once

#include "core/eval/truth_files.h"

#include <string>

namespace edgescan {

/// Share of the ranges (lone ones left out) that agree with the clean ranges: within five standard deviations of the scan's own noise + 1 %
/// + 20 mm. Near 1 for the scan itself, whatever its noise, drop-outs, dust or slips; 1 where the truth has no clean ranges.
[[nodiscard]] double shareOfTrueRanges(const Scan& scan, const TruthSet& truth);

/// Error: the truth is of another scene. `folder` goes into the error. Shapes must be equal.
[[nodiscard]] Result<Done> checkTruthFits(const Scan& scan, const TruthSet& truth, const std::string& folder);

} // namespace edgescan
