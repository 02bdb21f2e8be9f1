// One scan at many values of one setting, for the eye to choose from.
#pragma once

#include "core/edges/pipeline/detection.h"
#include "core/edges/settings/parameters.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace edgescan {

/// Of one value. What the detection says is what the program shows at that value.
struct SheetEntry {
    double value = 0.0;
    std::size_t edges = 0;
    bool steady = false; ///< of the longest run of values over which no more than a fifth of the edge cells goes
};

/// Values of a parameter, ascending, each once: `now` and others round it, in equal ratios where it can be multiplied, else in equal steps;
/// all of the choices where it has choices. At most `most`; `now` is one of them unless it is automatic and nothing is known of it.
[[nodiscard]] std::vector<double> sheetValues(const Parameter& parameter, double now, std::size_t most);

/// Marks the steady ones.
void markSteady(std::vector<SheetEntry>& entries);

/// Runs the method at each value, all other settings as they are. `made` is told each detection as it is there, in the order of the values;
/// false from it ends the work with what is known. The steady ones are marked when all are there.
[[nodiscard]] std::vector<SheetEntry> contactSheet(const std::shared_ptr<const Scan>& scan, const Settings& settings,
                                                   const Parameter& parameter, const std::vector<double>& values,
                                                   const std::function<bool(const SheetEntry&, const Detection&)>& made);

} // namespace edgescan
