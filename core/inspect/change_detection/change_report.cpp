// Writes the table of regions; draws ranges in gray with coloured changes.
#include "core/inspect/change_detection/change_report.h"

#include "core/base/number_text.h"
#include "core/base/tolerance_text.h"
#include "core/scan/georef/placed_points.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace edgescan::inspect {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 12;

std::string withCount(const char* name, std::size_t n) { return std::string(name) + " " + std::to_string(n); }

std::string millimetres(double metres) { return fixedText(1000 * metres, 0) + " mm"; }

std::string rowOf(const Scan& later, const ChangedRegion& region) {
    const auto beams = static_cast<std::uint32_t>(later.beams());
    std::string row = rightAligned(region.farther ? "farther" : "nearer", 8) + rightAligned(millimetres(region.byM), 11) + " ± " +
                      rightAligned(millimetres(shownTolerance(region.toleranceM, 3)), 6) + rightAligned(fixedText(region.areaM2, 2), 9) +
                      " m²" + rightAligned(std::to_string(region.cells), 8) + " cells, at line " + std::to_string(region.cell / beams) +
                      " beam " + std::to_string(region.cell % beams) + ", " + fixedText(region.rangeM, 2) + " m";
    if (!later.placement) return row;
    const Eigen::Vector3d mine = minePoint(later, region.cell).enhM;
    return row + ", E " + fixedText(mine.x(), 2) + " N " + fixedText(mine.y(), 2) + " RL " + fixedText(mine.z(), 2);
}

Json regionJson(const Scan& later, const ChangedRegion& region) {
    const auto beams = static_cast<std::uint32_t>(later.beams());
    Json json{{"change", region.farther ? "farther" : "nearer"},
              {"by_m", region.byM},
              {"tolerance_m", region.toleranceM},
              {"area_m2", region.areaM2},
              {"cells", region.cells},
              {"line", region.cell / beams},
              {"beam", region.cell % beams},
              {"range_m", region.rangeM},
              {"lines", {region.firstLine, region.lastLine}},
              {"beams", {region.firstBeam, region.lastBeam}},
              {"mine", nullptr}};
    if (later.placement) {
        const Eigen::Vector3d mine = minePoint(later, region.cell).enhM;
        json["mine"] = {mine.x(), mine.y(), mine.z()};
    }
    return json;
}

Rgb tinted(std::uint8_t gray, const Rgb& colour) {
    const auto mix = [gray](std::uint8_t c) { return static_cast<std::uint8_t>((gray + c) / 2); };
    return {mix(colour.red), mix(colour.green), mix(colour.blue)};
}

} // namespace

std::string registrationText(const RegistrationResult& how) {
    if (how.by == RegistrationBasis::OneScan) return "one scan with two settings";
    std::string text = how.by == RegistrationBasis::Surfaces ? "no pose: lined up by their surfaces"
                       : how.inMine                          ? "lined up by their poses"
                                                             : "lined up by given positions of the scanner, not in the mine grid";
    return text + (how.sameCells ? "" : "; other cells: points of one moved to the grid of the other");
}

std::string changeText(const Scan& later, const SceneChange& change) {
    const RegistrationResult& how = change.earlier.how;
    const bool isSameFile = how.by == RegistrationBasis::OneScan && !how.warnings.empty(); // as the warning says
    std::string text = isSameFile ? "" : registrationText(how) + "\n";
    for (const std::string& warning : change.earlier.how.warnings) text += warning + "\n";
    text += "edges: " + withCount("+ gained", change.edges.gained) + ", " + withCount("- lost", change.edges.lost) + ", " +
            withCount("kept", change.edges.unchanged) + ", " + withCount("not seen by the other", change.edges.unknown);
    if (change.earlier.edgesLeftOut > 0)
        text += "\n" + withCount("edge cells of the earlier scan lie where the later one did not look, or behind what it saw",
                                 change.earlier.edgesLeftOut);
    if (change.earlier.how.by == RegistrationBasis::OneScan) return text;
    const RangeChanges& ranges = change.ranges;
    text += "\ncells: " + withCount("nearer", ranges.nearer) + ", " + withCount("farther", ranges.farther) + ", " +
            withCount("same", ranges.same) + ", " + withCount("no range now", ranges.noReturnNow) + ", " +
            withCount("no range before", ranges.noReturnBefore);
    text += "\nmedian difference " + fixedText(change.differMm, 1) + " mm";
    text += "\na change is more than " + fixedText(kChangeSigmas, 0) +
            " standard deviations: " + fixedText(kChangeSigmas * change.noise.at(5.0), 0) + " mm at 5 m, " +
            fixedText(kChangeSigmas * change.noise.at(10.0), 0) + " mm at 10 m";
    if (!change.earlier.how.measurable()) return text;
    text += "\n" + counted(change.regions.size(), "region") + " of " + std::to_string(kSmallestRegion) +
            " cells and more, visible surface from one viewpoint";
    for (std::size_t n = 0; n < std::min(kMostRows, change.regions.size()); ++n) text += "\n" + rowOf(later, change.regions[n]);
    if (change.regions.size() > kMostRows) text += "\n(smaller ones with --json)";
    return text;
}

Json changeReport(const Scan& later, const SceneChange& change) {
    const RegistrationResult& how = change.earlier.how;
    const char* ways[]{"one scan", "poses", "surfaces"};
    Json surfaces = nullptr;
    if (how.surfaces)
        surfaces = {
            {"pairs", how.surfaces->pairs}, {"residual_m", how.surfaces->residualM}, {"residual_before_m", how.surfaces->residualBeforeM}};
    Json report{{"lined_up_by", ways[static_cast<std::size_t>(how.by)]},
                {"same_cells", how.sameCells},
                {"surfaces", std::move(surfaces)},
                {"out_of_spec", how.outOfSpec},
                {"warnings", how.warnings},
                {"edges",
                 {{"gained", change.edges.gained},
                  {"lost", change.edges.lost},
                  {"kept", change.edges.unchanged},
                  {"unseen", change.edges.unknown},
                  {"left_out", change.earlier.edgesLeftOut}}},
                {"cells", nullptr},
                {"median_difference_mm", nullptr},
                {"change_limit_mm", nullptr},
                {"regions", Json::array()}};
    if (how.by == RegistrationBasis::OneScan) return report;
    const RangeChanges& ranges = change.ranges;
    report["cells"] = {{"nearer", ranges.nearer},
                       {"farther", ranges.farther},
                       {"same", ranges.same},
                       {"no_return_now", ranges.noReturnNow},
                       {"no_return_before", ranges.noReturnBefore}};
    report["median_difference_mm"] = change.differMm;
    report["change_limit_mm"] = {{"at_5_m", kChangeSigmas * change.noise.at(5.0)}, {"at_10_m", kChangeSigmas * change.noise.at(10.0)}};
    for (const ChangedRegion& region : change.regions) report["regions"].push_back(regionJson(later, region));
    return report;
}

Grid<Rgb> changePicture(const Scan& later, const SceneChange& change) {
    const RangeLimits limits = rangeLimits(later);
    const float span = std::max(1.0F, limits.maxMm - limits.minMm);
    const bool ranges = change.ranges.cells.size() == later.cells();
    Grid<Rgb> picture(later.lines(), later.beams(), Rgb{40, 20, 60});
    for (std::size_t k = 0; k < later.cells(); ++k) {
        if (later.state[k] == CellState::Valid) {
            const auto gray = static_cast<std::uint8_t>(30.0F + 120.0F * (later.rangeMm[k] - limits.minMm) / span);
            picture[k] = {gray, gray, gray};
            if (ranges && change.ranges.cells[k] == RangeChange::Nearer) picture[k] = tinted(gray, kGainedColour);
            if (ranges && change.ranges.cells[k] == RangeChange::Farther) picture[k] = tinted(gray, kLostColour);
        }
        if (change.edges.cells[k] == EdgeChange::Unchanged) picture[k] = kUnchangedColour;
        if (change.edges.cells[k] == EdgeChange::Gained) picture[k] = kGainedColour;
        if (change.edges.cells[k] == EdgeChange::Lost) picture[k] = kLostColour;
    }
    return picture;
}

} // namespace edgescan::inspect
