// Writes scans and results as JSON.
#include "core/exports/report.h"

#include "core/base/json_text.h"
#include "core/base/order_statistic.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/edges/edgescan_plus/edge_class_names.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/tuning/flat_scan.h"
#include "core/files/point_tables/description.h"
#include "core/scan/georef/placement_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <span>

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

// Rounds for the reader; the angles in the scan are unchanged.
double tidy(double value, double steps) { return std::round(value * steps) / steps; }

// First, last and step of a list of angles; if the steps differ, "uneven" with the smallest and the largest step.
json anglesReport(const std::vector<double>& degrees) {
    if (degrees.empty()) return json::object();
    json report{{"first", degrees.front()}, {"last", degrees.back()}, {"count", degrees.size()}};
    if (degrees.size() < 2) return report;
    const double mean = (degrees.back() - degrees.front()) / static_cast<double>(degrees.size() - 1);
    double smallest = degrees[1] - degrees[0];
    double largest = smallest;
    for (std::size_t i = 1; i < degrees.size(); ++i) {
        const double step = degrees[i] - degrees[i - 1];
        if (std::abs(step) < std::abs(smallest)) smallest = step;
        if (std::abs(step) > std::abs(largest)) largest = step;
    }
    report["step"] = tidy(mean, 1e9);
    report["even"] = largest - smallest <= 1e-6 * std::abs(mean) + 1e-9;
    if (!report["even"].get<bool>()) {
        report["smallest_step"] = tidy(smallest, 1e9);
        report["largest_step"] = tidy(largest, 1e9);
    }
    return report;
}

json rangeReport(const Scan& scan) {
    const RangeLimits limits = rangeLimits(scan);
    if (countCells(scan)[static_cast<std::size_t>(CellState::Valid)] == 0) return {{"min", nullptr}, {"max", nullptr}};
    return {{"min", limits.minMm}, {"max", limits.maxMm}};
}

/// Of the cells with an intensity.
json intensityReport(const Scan& scan) {
    std::size_t cells = 0;
    float least = 0, greatest = 0;
    for (const float value : scan.intensity.cells) {
        if (!std::isfinite(value)) continue;
        least = cells == 0 ? value : std::min(least, value);
        greatest = cells == 0 ? value : std::max(greatest, value);
        ++cells;
    }
    return {{"cells", cells}, {"min", least}, {"max", greatest}};
}

/// The placement of the scan, without the matrices.
json poseReport(const Scan& scan) {
    if (!scan.placement) return nullptr;
    json report = placementToJson(*scan.placement);
    report.erase("stepper");
    report["poses"] = scan.placement->poses.size();
    return report;
}

/// What happened to the points of a file with a list of points.
json pointsReport(const Scan& scan) { return {{"in_file", scan.pointsRead}, {"without_cell", scan.pointsLeftOut}}; }

// The noise by scale, and the noise that folds are compared with.
json noiseReport(const edges::DepthResponses& responses) {
    const edges::NoiseScales& scales = responses.scales;
    json byLag = json::object();
    for (std::size_t n = 0; n < edges::kNoiseLags.size(); ++n) {
        if (scales.sigmaMm[n] > 0) byLag[std::to_string(edges::kNoiseLags[n])] = tidy(scales.sigmaMm[n], 1000);
    }
    return {{"kind", responses.neighboursAlike ? "neighbours_alike"
                     : scales.inSteps          ? "in_steps"
                                               : "white"},
            {"at_m", tidy(scales.rangeM, 1000)},
            {"mm", tidy(responses.noise.at(scales.rangeM), 1000)},
            {"mm_by_lag_in_cells", byLag},
            {"nil_differences", tidy(scales.nilShare, 1000)},
            {"mm_for_folds", tidy(responses.foldNoise.at(scales.rangeM), 1000)},
            {"law_mm",
             {{"at_0_m", tidy(responses.noise.offsetMm, 1000)},
              {"per_m", tidy(responses.noise.perMetreMm, 1000)},
              {"per_m2", tidy(responses.noise.perSquareMetreMm, 1000)}}}};
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

nlohmann::ordered_json cellsReport(const Scan& scan) {
    const auto counts = countCells(scan);
    json report = json::object();
    for (int s = 0; s < kCellStates; ++s) report[cellStateName(static_cast<CellState>(s))] = counts[static_cast<std::size_t>(s)];
    return report;
}

nlohmann::ordered_json geometryReport(const Scan& scan) {
    if (const auto* polar = std::get_if<PolarGeometry>(&scan.geometry))
        return {{"geometry", "beam x line angles"},
                {"axis", polar->axis == Axis::Spin ? "spin" : "sweep"},
                {"line_direction", polar->lineDirection},
                {"beam_deg", anglesReport(polar->beamDeg)},
                {"line_deg", anglesReport(polar->lineDeg)}};
    const Eigen::Vector3d& sensor = std::get<PointGeometry>(scan.geometry).sensorM;
    return {{"geometry", "organised points"}, {"sensor_m", {sensor.x(), sensor.y(), sensor.z()}}};
}

nlohmann::ordered_json infoReport(const Scan& scan) {
    json report{{"input", scan.path},         {"name", scan.name},
                {"format", scan.format},      {"sha256", scan.sha256},
                {"lines", scan.lines()},      {"beams", scan.beams()},
                {"cells", cellsReport(scan)}, {"range_mm", rangeReport(scan)},
                {"unit_mm", scan.unitMm},     {"frame", scan.placement ? "mine grid" : "scanner"},
                {"pose", poseReport(scan)},   {"warnings", scan.warnings}};
    report.update(geometryReport(scan));
    if (scan.intensity.size() > 0) report["intensity"] = intensityReport(scan);
    if (!scan.attached.empty()) report["attached_points"] = scan.attached.size();
    if (scan.pointsRead > 0) report["points"] = pointsReport(scan);
    if (scan.acquisition) report["acquisition"] = files::acquisitionToJson(*scan.acquisition);
    if (!scan.note.empty()) report["note"] = scan.note;
    return report;
}

nlohmann::ordered_json detectReport(const edges::Detection& detection, double loadMs) {
    const Scan& scan = *detection.scan;
    json timings{{"load", tidy(loadMs, 1000)}};
    for (const edges::StageTime& time : detection.timings) timings[time.stage] = tidy(time.milliseconds, 1000);
    timings["total"] = tidy(loadMs + detection.totalMs, 1000);
    const edges::GrayScale& scale = detection.gray->scale;
    std::vector<std::string> warnings = scan.warnings;
    if (scale.farMm <= scale.nearMm && detection.settings.method == edges::Method::Canny)
        warnings.emplace_back("Near and far leave no depth between them: the gray image is blank and has no edge.");
    json report{{"input", scan.path},
                {"sha256", scan.sha256},
                {"lines", scan.lines()},
                {"beams", scan.beams()},
                {"cells", cellsReport(scan)},
                {"range_mm", rangeReport(scan)},
                {"settings", edges::settingsToJson(detection.settings)},
                {"upper", detection.settings.upper()},
                {"gray",
                 {{"near_mm", scale.nearMm},
                  {"far_mm", scale.farMm},
                  {"logarithmic", scale.logarithmic},
                  {"saturated", detection.gray->saturated}}},
                {"edges", detection.edges->size()},
                {"classes", classesReport(detection)},
                {"rock_borders", rockBordersReport(detection)},
                {"noise_mm_at_5_m", detection.responses ? json(tidy(detection.responses->noise.at(5.0), 1000)) : json()},
                {"noise", detection.responses ? noiseReport(*detection.responses) : json()},
                {"roughness", roughnessReport(detection)},
                {"proposed_preset", edges::isFlatAndQuiet(detection) ? json("smooth-walls") : json()},
                {"jump_mm", detection.responses ? json(tidy(detection.responses->jumpMm, 1000)) : json()},
                {"edge_mask_sha256", maskSha256(*detection.mask)},
                {"frame", scan.placement ? "mine grid" : "scanner"},
                {"pose", poseReport(scan)},
                {"attached_points", scan.attached.size()},
                {"timings_ms", timings},
                {"warnings", warnings},
                {"version", version()}};
    if (scan.pointsRead > 0) report["points"] = pointsReport(scan);
    if (detection.filled) report["filled"] = filledReport(*detection.filled);
    return report;
}

nlohmann::ordered_json roughnessReport(const edges::Detection& detection) {
    if (!detection.responses || !detection.settings.roughScans || !edges::findParameter("rough-scans")->usedBy(detection.settings))
        return nullptr;
    const edges::Roughness& found = detection.responses->roughness;
    return {{"rough", found.rough}, {"folding_share", tidy(found.share, 1000)}, {"around_folds", tidy(found.aroundFolds, 1000)}};
}

nlohmann::ordered_json classesReport(const edges::Detection& detection) {
    if (!detection.classes) return nullptr;
    const auto counts = edges::countClasses(detection);
    json report = json::object();
    for (std::size_t kind = 1; kind < counts.size(); ++kind)
        report[edges::edgeClassName(static_cast<edges::DepthEdge>(kind))] = counts[kind];
    return report;
}

nlohmann::ordered_json rockBordersReport(const edges::Detection& detection) {
    if (!detection.borders) return nullptr;
    const edges::BorderCounts counts = edges::countBorders(detection);
    return {{"strong", counts.strong}, {"weak", counts.weak}, {"folds", counts.folds}, {"unknown", counts.unknown}};
}

nlohmann::ordered_json filledReport(const GapFilling& filling) {
    std::vector<float> sdMm;
    for (const FilledCell& cell : filling.cells) sdMm.push_back(cell.sdMm);
    const bool none = sdMm.empty();
    return {{"gaps", filling.gaps},
            {"cells", filling.cells.size()},
            {"by_plane", filling.byPlane},
            {"by_line", filling.cells.size() - filling.byPlane},
            {"sd_mm_p50", none ? json() : json(tidy(static_cast<double>(median(std::move(sdMm))), 100))}};
}

std::string reportText(const nlohmann::ordered_json& report, bool indented) { return shortJsonText(report, indented ? 2 : -1); }

std::string maskSha256(const Grid<std::uint8_t>& mask) { return sha256Hex(std::as_bytes(std::span(mask.cells))); }

} // namespace edgescan::exports
