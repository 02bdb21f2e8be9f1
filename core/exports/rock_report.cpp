// Writes rocks as JSON and as a table: one row per rock, units in the names.
#include "core/exports/rock_report.h"

#include "core/base/csv_text.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/rocks/attributes/size_curve.h"
#include "core/scan/georef/placed_points.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

namespace edgescan::exports {
namespace {

using Json = nlohmann::ordered_json;

double millimetres(double metres) { return rounded(metres, 1000); }
double thousandths(double share) { return rounded(share, 1000); }

// A row's columns in order, as JSON; the table uses the same columns.
class RowWriter {
public:
    RowWriter(const rocks::Study& study, CoordinateFrame frame)
        : scan_(*study.segmentation->inputs.scan), frame_(frame), curve_(rocks::sizeCurve(study.rocks, study.settings.oversizeM)) {
        if (frame != CoordinateFrame::Scanner) placed_.emplace(scan_);
    }

    [[nodiscard]] Json row(const rocks::Rock& rock) const {
        const auto beams = static_cast<std::uint32_t>(scan_.beams());
        const int line = static_cast<int>(rock.cell / beams);
        const int beam = static_cast<int>(rock.cell % beams);
        const Eigen::Vector3d centre = placed_ ? placed_->inFrame(frame_, line, beam, rock.centreM) : rock.centreM;
        return {{"rock", rock.label},
                {"line", line},
                {"beam", beam},
                {"cells", rock.cells},
                {"x_m", millimetres(centre.x())},
                {"y_m", millimetres(centre.y())},
                {"z_m", millimetres(centre.z())},
                {"distance_m", millimetres(rock.distanceM)},
                {"visible_long_m", millimetres(rock.longestCaliperM)},
                {"visible_wide_m", millimetres(rock.shortestCaliperM)},
                {"tolerance_m", millimetres(rock.toleranceM)},
                {"visible_area_m2", rounded(rock.areaM2, 1e4)},
                {"unoccluded_share", thousandths(rock.unoccluded)},
                {"in_front_of", rock.rocksBehind},
                {"behind", rock.rocksInFront},
                {"contacts_at_least", rock.contacts},
                {"touches_other", rock.touchesOther},
                {"free_below_at_least_m", rounded(rock.freeHeightM, 100)},
                {"arch_deg", rock.archDeg ? Json(rounded(*rock.archDeg, 1)) : Json()},
                {"arch_tolerance_deg", rock.archDeg ? Json(rocks::kArchToleranceDeg) : Json()},
                {"hangs_below", rock.archDeg ? Json(rock.isBelowContacts) : Json()},
                {"finer_share", thousandths(curve_.shareUpTo(rock.shortestCaliperM))},
                {"confidence", thousandths(rock.confidence)},
                {"by_hand", rock.byHand},
                {"note", rocks::kRockCaveat}};
    }
    [[nodiscard]] const rocks::SizeCurve& curve() const { return curve_; }

private:
    const Scan& scan_;
    CoordinateFrame frame_;
    rocks::SizeCurve curve_;
    std::optional<PlacedPoints> placed_;
};

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

std::string cellText(const Json& value) {
    if (value.is_null()) return {};
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    if (value.is_string()) return csvCell(value.get<std::string>());
    if (value.is_number_float()) return shortestText(value.get<double>());
    if (!value.is_array()) return std::to_string(value.get<std::int64_t>());
    std::string text;
    for (const Json& item : value) text += (text.empty() ? "" : " ") + std::to_string(item.get<std::int64_t>());
    return text;
}

} // namespace

std::string labelsSha256(const Grid<std::uint32_t>& labels) { return sha256Hex(std::as_bytes(std::span(labels.cells))); }

Json rocksReport(const rocks::Study& study, CoordinateFrame frame) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const rocks::UpDirection up = rocks::upOf(scan);
    const RowWriter writer(study, frame);
    Json rows = Json::array();
    for (const rocks::Rock& rock : study.rocks) rows.push_back(writer.row(rock));
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
                {"size_curve", curveJson(writer.curve())},
                {"fines", countsJson(rocks::regionCounts(study.map, rocks::RegionKind::Fines))},
                {"not_rock", countsJson(rocks::regionCounts(study.map, rocks::RegionKind::NotRock))},
                {"outside_region", countsJson(rocks::regionCounts(study.map, rocks::RegionKind::Outside))},
                {"labels_sha256", labelsSha256(rocks::rockLabels(*study.segmentation, study.map))},
                {"rocks", rows},
                {"warnings", scan.warnings},
                {"version", version()}};
    return report;
}

std::string rocksTable(const rocks::Study& study, CoordinateFrame frame) {
    const RowWriter writer(study, frame);
    std::string text;
    const Json names = writer.row(rocks::Rock{}); // also for the header of a table without rocks
    for (const auto& [key, value] : names.items()) text += (text.empty() ? "" : ",") + key;
    text += '\n';
    for (const rocks::Rock& rock : study.rocks) {
        std::string line;
        bool first = true;
        const Json row = writer.row(rock);
        for (const auto& [key, value] : row.items()) {
            if (!first) line += ',';
            first = false;
            line += cellText(value);
        }
        text += line + '\n';
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
                {"long_m", millimetres(r.longM)},
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
