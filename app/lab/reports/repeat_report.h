// Repeatability of edges as a table and as JSON.
#pragma once

#include "app/lab/repeatability/repeatability.h"
#include "core/inspect/registration/scan_alignment.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace edgescan::lab {

/// The parameters and results of one repeatability run.
struct RepeatRun {
    double radiusM = 0.0;
    std::optional<inspect::ScanAlignment> alignment; ///< empty: the poses were used without correction
    std::vector<MethodRepeatability> methods;
};

[[nodiscard]] std::string repeatText(const RepeatRun& run);
[[nodiscard]] nlohmann::ordered_json repeatReport(const RepeatRun& run);

} // namespace edgescan::lab
