// One scan at many values of one setting, so that the user can choose by eye.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/settings/parameters.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace edgescan::edges {

/// One value. Its edges are those that the program shows at this value.
struct SheetEntry {
    double value = 0.0;
    std::size_t edges = 0;
    bool steady = false; ///< belongs to the longest run of values over which at most a fifth of the edge cells disappear
};

/// Values of a parameter, ascending, each once: `now` and others around it, in equal ratios if the parameter can be multiplied, otherwise
/// in equal steps; all choices if it has choices. At most `most`. `now` is one of them unless it is automatic and its value on the scan is
/// unknown.
[[nodiscard]] std::vector<double> sheetValues(const Parameter& parameter, double now, std::size_t most);

/// Sets `steady` in the entries.
void markSteady(std::vector<SheetEntry>& entries);

/// Runs the method at each value, with all other settings unchanged. `made` is called with each detection as soon as it is ready, in the
/// order of the values; if it returns false, the work ends with the entries so far. `steady` is set when all are ready.
[[nodiscard]] std::vector<SheetEntry> contactSheet(const std::shared_ptr<const Scan>& scan, const Settings& settings,
                                                   const Parameter& parameter, const std::vector<double>& values,
                                                   const std::function<bool(const SheetEntry&, const Detection&)>& made);

} // namespace edgescan::edges
