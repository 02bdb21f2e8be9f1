// The methods that edgescan-lab families runs on every scene: a table of usual ones, and those that a person names.
#pragma once

#include "app/lab/families/scene_score.h"
#include "core/base/result.h"

#include <string>
#include <vector>

namespace edgescan::cli {

/// "default, thesis, ...", for the help.
[[nodiscard]] std::string usualContestants();

/// From "NAME=FLAGS" with the flags of a method, or the NAME of a usual one; all usual ones if nothing is typed. Error: unknown name, wrong
/// flags, the same name twice.
[[nodiscard]] Result<std::vector<lab::Contestant>> contestantsOf(const std::vector<std::string>& typed);

} // namespace edgescan::cli
