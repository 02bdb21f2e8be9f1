// edgescan-cli evaluate --rocks: rocks of simulated scenes against the true ones.
#pragma once

#include "app/shared/options.h"
#include "core/compare/rock_answers.h"

#include <string>
#include <vector>

namespace edgescan::cli {

struct EvaluateRocks {
    std::vector<std::string> files, truths;
    std::string json;     ///< file, "-" or empty
    std::string pictures; ///< folder; empty = none
    bool peers = false;
    RockChoices choices;
    ReadFlags read;
};

/// The exit code.
[[nodiscard]] int evaluateRocks(const EvaluateRocks& evaluate);

} // namespace edgescan::cli
