// Writes rocks as JSON and as a table: one row per rock, units in the names.
#include "core/exports/rock_report.h"

#include "core/base/csv_text.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/version.h"

#include <nlohmann/json.hpp>

#include <span>
#include <type_traits>
#include <variant>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

double millimetres(double metres) { return rounded(metres, 1000); }
double thousandths(double share) { return rounded(share, 1000); }

Json jsonOf(const rocks::RockValue& value) {
    return std::visit(
        [](const auto& held) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>)
                return nullptr;
            else
                return held;
        },
        value);
}

Json curveJson(const rocks::SizeCurve& curve) {
    const bool isSaid = curve.oversizeM > 0;
    return {{"rocks", curve.rocks()},
            {"visible_wide_p20_m", millimetres(curve.p20M)},
            {"visible_wide_p50_m", millimetres(curve.p50M)},
            {"visible_wide_p80_m", millimetres(curve.p80M)},
            {"visible_wide_top_m", millimetres(curve.topM)},
            {"oversize_m", isSaid ? Json(millimetres(curve.oversizeM)) : Json()},
            {"oversize_share", isSaid ? Json(thousandths(curve.oversizeShare)) : Json()},
            {"note", rocks::kSizeCurveCaveat}};
}

Json countsJson(const rocks::RegionCounts& counts) {
    return {{"regions", counts.regions}, {"cells", counts.cells}, {"visible_area_m2", rounded(counts.areaM2, 1e4)}};
}

struct CsvText {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool truth) const { return truth ? "1" : "0"; }
    std::string operator()(std::uint32_t whole) const { return std::to_string(whole); }
    std::string operator()(double number) const { return shortestText(number); }
    std::string operator()(const char* words) const { return csvCell(words); }
    std::string operator()(std::span<const std::uint32_t> list) const {
        std::string text;
        for (const std::uint32_t item : list) text += (text.empty() ? "" : " ") + std::to_string(item);
        return text;
    }
};

} // namespace

std::string labelsSha256(const Grid<std::uint32_t>& labels) { return sha256Hex(std::as_bytes(std::span(labels.cells))); }

rocks::NamedCells namedCells(std::span<const inspect::PinnedTarget> targets) {
    rocks::NamedCells names;
    for (const inspect::PinnedTarget& target : targets) names.emplace_back(target.cell, target.name);
    return names;
}

Json rocksReport(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const rocks::UpDirection up = rocks::upOf(scan);
    const rocks::RockRows rows(study, frame);
    Json report{{"input", scan.path},
                {"sha256", scan.sha256},
                {"lines", scan.lines()},
                {"beams", scan.beams()},
                {"note", rocks::kRockCaveat},
                {"settings", rocks::rockSettingsToJson(study.settings)},
                {"edits", rocks::rockEditsToJson(study.edits, scan.lines(), scan.beams())["edits"]},
                {"frame", frameName(frame)},
                {"up", {{"direction", {up.up.x(), up.up.y(), up.up.z()}}, {"assumed", up.assumed}}},
                {"rock_count", study.rocks.size()},
                {"size_curve", curveJson(rows.curve())},
                {"fines", countsJson(rocks::regionCounts(study.map, rocks::RegionKind::Fines))},
                {"not_rock", countsJson(rocks::regionCounts(study.map, rocks::RegionKind::NotRock))},
                {"outside_region", countsJson(rocks::regionCounts(study.map, rocks::RegionKind::Outside))},
                {"labels_sha256", labelsSha256(rocks::rockLabels(*study.segmentation, study.map))},
                {"rocks", rockRowsJson(study, frame, names)},
                {"warnings", scan.warnings},
                {"version", version()}};
    return report;
}

Json rockRowsJson(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names) {
    const rocks::RockRows rows(study, frame, names);
    Json all = Json::array();
    for (const rocks::Rock* rock : rocks::rocksToList(study)) {
        const rocks::RockRow row = rows.of(*rock);
        Json object = Json::object();
        for (const rocks::RockColumn& column : rocks::rockColumns(frame)) object[column.key] = jsonOf(column.value(row));
        all.push_back(std::move(object));
    }
    return all;
}

std::string rocksTable(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names) {
    const rocks::RockRows rows(study, frame, names);
    std::string text;
    for (const rocks::RockColumn& column : rocks::rockColumns(frame)) text += (text.empty() ? "" : ",") + std::string(column.key);
    text += '\n';
    for (const rocks::Rock* rock : rocks::rocksToList(study)) {
        const rocks::RockRow row = rows.of(*rock);
        std::string line;
        for (const rocks::RockColumn& column : rocks::rockColumns(frame)) line += std::visit(CsvText{}, column.value(row)) + ',';
        line.back() = '\n';
        text += line;
    }
    return text;
}

Json whyReport(const rocks::Study& study, const rocks::BorderWhy& why) {
    const auto width = static_cast<std::uint32_t>(study.segmentation->segment.beams);
    const auto cellJson = [&](std::uint32_t k) { return Json{{"line", k / width}, {"beam", k % width}}; };
    const auto regionJson = [&](std::uint32_t region) -> Json {
        if (region == 0) return nullptr;
        const rocks::Region& r = study.map.regions[region];
        return {{"rock", region <= study.map.rocks ? Json(region) : Json()},
                {"kind", rocks::regionKindName(r.kind)},
                {"by_hand", r.byHand},
                {"cells", r.sums.cells},
                {"bulge", thousandths(r.bulge)},
                {"near", thousandths(r.nearShare)},
                {"edges", thousandths(r.edgeShare)},
                {"depth", thousandths(r.depthRatio)},
                {"fill", thousandths(r.boxShare)},
                {"four_sd_m", millimetres(r.longM)},
                {"score", thousandths(r.score)},
                {"confidence", thousandths(r.confidence)}};
    };
    Json report{{"input", study.segmentation->inputs.scan->path},
                {"cells", {cellJson(why.cells[0]), cellJson(why.cells[1])}},
                {"level", study.settings.level},
                {"regions", {regionJson(why.regions[0]), regionJson(why.regions[1])}},
                {"same_region", why.sameRegion()},
                {"joined_from_level", why.joinedFrom ? Json(thousandths(*why.joinedFrom)) : Json()},
                {"always_one", why.alwaysOne},
                {"border", nullptr},
                {"verdict", why.verdict},
                {"note", rocks::kRockCaveat}};
    if (why.border) {
        const rocks::RegionBorder& b = *why.border;
        report["border"] = {{"cracks", b.cracks},
                            {"e1", thousandths(b.mean(b.sumE1))},
                            {"e2", thousandths(b.mean(b.sumE2))},
                            {"v", thousandths(b.mean(b.sumValley))},
                            {"w", thousandths(b.mean(b.sumWide))},
                            {"z", thousandths(b.meanZ())},
                            {"first_nearer_cracks", b.jumpsA},
                            {"second_nearer_cracks", b.jumpsB},
                            {"contact_cracks", b.valleys}};
    }
    return report;
}

} // namespace edgescan::exports
