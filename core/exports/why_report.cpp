// Why a cell is an edge or not, as JSON.
#include "core/exports/why_report.h"

#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace edgescan::exports {
namespace {

using json = nlohmann::ordered_json;

json cellReport(const edges::CellStrength& cell) { return {{"line", cell.line}, {"beam", cell.beam}, {"strength", cell.strength}}; }

const char* levelName(edges::StrengthLevel level) {
    static constexpr const char* kNames[]{"below", "between", "above"};
    return kNames[static_cast<std::size_t>(level)];
}

const char* alongName(edges::Along along) { return along == edges::Along::Beams ? "beams" : "lines"; }

json stepReport(const edges::DepthStepAtCell& step) {
    return {
        {"along", alongName(step.along)},
        {"line", step.line},
        {"beam", step.beam},
        {"this_cell_is_nearer", step.cellIsNearer},
        {"step_mm", step.stepMm},
        {"limit_mm", step.limitMm()},
        {"limit_parts_mm", {{"jump", step.smallestMm}, {"growth", step.growthMm}, {"grazing", step.grazingMm}, {"relief", step.reliefMm}}},
        {"strength", step.strength}};
}

json foldReport(const edges::FoldAtCell& fold, double creaseDeg) {
    return {{"along", alongName(fold.along)},
            {"dihedral_deg", fold.dihedralDeg},
            {"class", fold.convex ? "convex" : "concave"},
            {"limit_deg", std::max(fold.noiseDeg, creaseDeg)},
            {"limit_parts_deg", {{"crease", creaseDeg}, {"noise", fold.noiseDeg}}},
            {"counts", fold.meets},
            {"strength", fold.strength}};
}

json suppressedReport(const std::optional<edges::CellStrength>& by, double compared) {
    if (!by) return nullptr;
    json report = cellReport(*by);
    report["against"] = compared;
    return report;
}

json thinnedReport(const edges::ThinnedStrength& thinned) {
    return {{"strength", std::abs(thinned.before)},
            {"remains", thinned.after != 0},
            {"suppressed_by", suppressedReport(thinned.stronger, static_cast<double>(thinned.compared))}};
}

const char* supportName(Support support) {
    static constexpr const char* kNames[]{"void", "measured", "filled"};
    return kNames[static_cast<std::size_t>(support)];
}

json depthReport(const edges::DepthProbe& depth) {
    json report{{"support", supportName(depth.support)},
                {"mixed_pixel_taken_at_mm", depth.snappedMm ? json(*depth.snappedMm) : json(nullptr)},
                {"noise_mm", depth.noiseMm},
                {"noise_mm_at_5_m", depth.noiseAt5mMm},
                {"noise_mm_for_folds", depth.foldNoiseMm},
                {"interlaced", depth.interlaced}};
    report["steps"] = json::array();
    for (const edges::DepthStepAtCell& step : depth.steps) report["steps"].push_back(stepReport(step));
    report["folds"] = json::array();
    for (const edges::FoldAtCell& fold : depth.folds) report["folds"].push_back(foldReport(fold, depth.creaseDeg));
    report["jump"] = thinnedReport(depth.jump);
    report["crease"] = thinnedReport(depth.crease);
    return report;
}

json borderReport(const edges::Why& why) {
    if (!why.border) return nullptr;
    json report{{"percent", *why.border == edges::kUnknownBorder ? json(nullptr) : json(*why.border)}, {"left_out", why.leftOut}};
    report["evidence"] = json::array();
    for (const edges::BorderReason& reason : why.borderReasons)
        report["evidence"].push_back({{"of", edges::evidenceKey(reason.evidence)}, {"log_odds", reason.added / double{kLogOddsUnit}}});
    return report;
}

// The text for a person, with one or two sentences per line.
json linesOf(const std::string& text) {
    json lines = json::array();
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

} // namespace

nlohmann::ordered_json whyReport(const edges::Detection& detection, const edges::Why& why) {
    const edges::Probe& probe = why.probe;
    const bool valid = probe.state == CellState::Valid;
    json report{{"input", detection.scan->path},
                {"line", probe.line},
                {"beam", probe.beam},
                {"state", cellStateName(probe.state)},
                {"range_mm", valid ? json(probe.rangeMm) : json(nullptr)},
                {"gray", probe.gray},
                {"smoothed", why.smoothed ? json(*why.smoothed) : json(nullptr)},
                {"takes_part", why.takesPart},
                {"method", edges::formatValue(*edges::findParameter("method"), static_cast<double>(detection.settings.method))},
                {"edge", probe.edge},
                {"class", probe.edge && detection.classes ? json(edges::edgeClassName(probe.kind)) : json(nullptr)}};
    report["gradient"] = nullptr;
    if (why.alongBeams) {
        report["gradient"] = {{"along_beams", *why.alongBeams},
                              {"along_lines", *why.alongLines},
                              {"direction_deg", why.directionDeg ? json(*why.directionDeg) : json(nullptr)}};
    }
    if (!why.alongBeams && why.directionDeg) report["gradient"] = {{"direction_deg", *why.directionDeg}};
    report["rough_around"] = why.rough ? json{{"folding_share", why.rough->share}, {"factor", why.rough->factor}} : json(nullptr);
    report["measured"] = why.depth ? depthReport(*why.depth) : json(nullptr);
    report["response_class"] = why.kind != edges::DepthEdge::None ? json(edges::edgeClassName(why.kind)) : json(nullptr);
    report["round_gap"] = why.movedFromGap;
    report["border"] = borderReport(why);
    report["unit"] = why.unit;
    report["strength"] = why.strength;
    report["thresholds"] = {{"lower", why.lower}, {"upper", why.upper}};
    const std::string meaning = edges::thresholdText(detection.settings, detection.gray->scale);
    if (!meaning.empty()) report["thresholds"]["meaning"] = meaning;
    report["against_thresholds"] = levelName(why.level);
    report["suppressed_by"] = suppressedReport(why.suppressedBy, why.compared);
    report["chain"] = json::array();
    for (const edges::CellStrength& cell : why.chain) report["chain"].push_back(cellReport(cell));
    report["chain_cells"] = why.chainCells;
    report["chain_strongest"] = why.chainTop ? cellReport(*why.chainTop) : json(nullptr);
    report["appears_at"] = why.appearsAt ? json{{why.parameter, *why.appearsAt}} : json(nullptr);
    report["verdict"] = why.verdict;
    report["text"] = linesOf(edges::whyText(why, detection.settings));
    return report;
}

} // namespace edgescan::exports
