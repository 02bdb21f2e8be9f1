// Why a cell is an edge or not, as JSON.
#include "core/report/why_report.h"

#include "core/edges/depth_settings.h"
#include "core/edges/parameters.h"
#include "core/edges/step_meaning.h"

namespace edgescan {
namespace {

using json = nlohmann::ordered_json;

json cellReport(const CellStrength& cell) { return {{"line", cell.line}, {"beam", cell.beam}, {"strength", cell.strength}}; }

const char* standingName(Standing standing) {
    static constexpr const char* kNames[]{"below", "between", "above"};
    return kNames[static_cast<std::size_t>(standing)];
}

} // namespace

nlohmann::ordered_json whyReport(const Frame& frame, const Why& why) {
    const Probe& probe = why.probe;
    const bool valid = probe.state == CellState::Valid;
    json report{{"input", frame.scan->path},
                {"line", probe.line},
                {"beam", probe.beam},
                {"state", cellStateName(probe.state)},
                {"range_mm", valid ? json(probe.rangeMm) : json(nullptr)},
                {"gray", probe.gray},
                {"smoothed", why.smoothed ? json(*why.smoothed) : json(nullptr)},
                {"takes_part", why.takesPart},
                {"method", formatValue(*findParameter("method"), static_cast<double>(frame.settings.method))},
                {"edge", probe.edge},
                {"class", probe.edge && frame.classes ? json(edgeClassName(probe.kind)) : json(nullptr)}};
    report["gradient"] = nullptr;
    if (why.alongBeams) {
        report["gradient"] = {{"along_beams", *why.alongBeams},
                              {"along_lines", *why.alongLines},
                              {"direction_deg", why.directionDeg ? json(*why.directionDeg) : json(nullptr)}};
    }
    report["strength"] = why.strength;
    report["thresholds"] = {{"lower", why.lower}, {"upper", why.upper}};
    const std::string meaning = thresholdText(frame.settings, frame.gray->scale);
    if (!meaning.empty()) report["thresholds"]["meaning"] = meaning;
    report["standing"] = standingName(why.standing);
    report["suppressed_by"] = why.suppressedBy ? cellReport(*why.suppressedBy) : json(nullptr);
    report["chain"] = json::array();
    for (const CellStrength& cell : why.chain) report["chain"].push_back(cellReport(cell));
    report["chain_cells"] = why.chainCells;
    report["appears_at"] = why.appearsAt ? json{{why.parameter, *why.appearsAt}} : json(nullptr);
    report["verdict"] = why.verdict;
    return report;
}

} // namespace edgescan
