// Whether a scan is the one that its ground truth was made with.
#pragma once

#include "core/sim/truth/truth_files.h"

#include <string>

namespace edgescan {

/// Error: the truth is of another scene. `folder` goes into the error. Shapes must be equal.
[[nodiscard]] Result<Done> checkTruthFits(const Scan& scan, const TruthSet& truth, const std::string& folder);

} // namespace edgescan
