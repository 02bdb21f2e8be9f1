// Checks whether a ground truth belongs to a scan.
#pragma once

#include "app/lab/sim/truth/truth_files.h"

#include <string>

namespace edgescan::lab {

/// Error: the truth belongs to another scene. The error names `folder`. The shapes must be equal.
[[nodiscard]] Result<Done> checkTruthFits(const Scan& scan, const sim::TruthSet& truth, const std::string& folder);

} // namespace edgescan::lab
