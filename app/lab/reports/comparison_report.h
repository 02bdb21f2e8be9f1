// A comparison as the thesis's tables 6.1 and 6.2 and as JSON.
#pragma once

#include "app/lab/peers/comparison.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace edgescan::lab {

/// Tables for a person: every method with milliseconds per step, edges and scores; then the thesis's printed figures and today's.
[[nodiscard]] std::string comparisonText(const Scan& scan, const std::vector<ComparedMethod>& methods);

[[nodiscard]] nlohmann::ordered_json comparisonReport(const Scan& scan, const std::vector<ComparedMethod>& methods,
                                                      const ComparisonSettings& settings);

} // namespace edgescan::lab
