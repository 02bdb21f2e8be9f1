// Exports of selected cells: the points, and the selection in the record.
#include "core/exports/record_parts.h"
#include "core/inspect/measure/cell_sets.h"
#include "core/scan/gap_filling/gap_filling.h"

#include <algorithm>

namespace edgescan::exports {

std::shared_ptr<const Scan> chosenScan(const edges::Detection& detection, const ExportOptions& options) {
    const bool filled = options.choices.filled && detection.filled;
    if (!options.selection && !filled) return detection.scan;
    auto chosen = std::make_shared<Scan>(filled ? withFilled(*detection.scan, *detection.filled).scan : *detection.scan);
    if (!options.selection) return chosen;
    for (const std::uint32_t k : inspect::allBut(*options.selection, chosen->cells())) {
        if (chosen->state[k] == CellState::Valid) chosen->state[k] = CellState::Masked;
    }
    return chosen;
}

nlohmann::ordered_json selectionRecord(const ExportOptions& options) {
    if (!options.selection) return {};
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const inspect::CellRun& run : inspect::runsOf(*options.selection)) runs.push_back({run.first, run.count});
    return {{"cells", options.selection->size()}, {"runs", std::move(runs)}};
}

std::shared_ptr<const std::vector<std::uint32_t>> selectionOf(const nlohmann::ordered_json& record, std::size_t cells) {
    const auto none = std::make_shared<const inspect::CellSet>();
    if (!record.is_object() || !record.contains("runs") || !record["runs"].is_array()) return none;
    std::vector<inspect::CellRun> runs;
    for (const auto& run : record["runs"]) {
        const bool pair = run.is_array() && run.size() == 2 && run[0].is_number_unsigned() && run[1].is_number_unsigned();
        if (!pair || run[0] > UINT32_MAX || run[1] > UINT32_MAX) return none;
        runs.push_back({run[0].get<std::uint32_t>(), run[1].get<std::uint32_t>()});
    }
    return std::make_shared<const inspect::CellSet>(inspect::cellsOf(runs, cells));
}

} // namespace edgescan::exports
