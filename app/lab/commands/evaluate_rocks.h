// edgescan-lab evaluate --rocks: rocks of simulated scenes against the true ones.
#pragma once

#include "app/lab/peers/rock_answers.h"
#include "app/shared/options.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace edgescan::cli {

struct EvaluateRocks {
    std::vector<std::string> files, truths;
    std::string json;     ///< file, "-" or empty
    std::string pictures; ///< folder; empty = none
    bool peers = false;
    lab::RockMethodSettings choices;
    ReadFlags read;
};

/// Writes the figures where --json asks for them, else shows them. The exit code.
[[nodiscard]] int writeOrShow(const Result<nlohmann::ordered_json>& figures, const std::string& json,
                              const std::function<void(const nlohmann::ordered_json&)>& show);

/// The exit code.
[[nodiscard]] int evaluateRocks(const EvaluateRocks& evaluate);

} // namespace edgescan::cli
