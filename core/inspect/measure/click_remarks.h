// What a reader must know of the clicks of a measurement: cards, lists and reports have the same sentences.
#pragma once

#include "core/base/grid.h"
#include "core/base/translated_text.h"
#include "core/inspect/measure/notebook.h"

#include <string>
#include <vector>

namespace edgescan::inspect {

/// True if a nearer surface is within reach of a click (near_side.h).
[[nodiscard]] bool isDoubtful(const Scan& scan, const StoredMeasure& measure);
/// "end 1 not on an edge" or "2 ends not on an edge" of `mask` (lines x beams, 0 = no edge), by the rule of the status bar; empty: all ends
/// are on one, or the method finds the ends itself.
[[nodiscard]] std::string offEdgeText(const Grid<std::uint8_t>& mask, const StoredMeasure& measure, Translated translated = asWritten);
/// The ends that were moved to the near side, isDoubtful() as a warning (▲), and offEdgeText().
[[nodiscard]] std::vector<std::string> clickRemarks(const Scan& scan, const Grid<std::uint8_t>& mask, const StoredMeasure& measure,
                                                    Translated translated = asWritten);

} // namespace edgescan::inspect
