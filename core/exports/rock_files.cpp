// Writes labels, rows and hulls of rocks.
#include "core/exports/rock_files.h"

#include "core/base/bounded_json.h"
#include "core/base/csv_text.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "core/exports/frame_points.h"
#include "core/files/formats/coordinate_system.h"
#include "core/files/formats/dxf_text.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/source.h"
#include "core/rocks/attributes/hulls.h"
#include "core/rocks/attributes/outlines.h"
#include "core/rocks/attributes/visible_surface.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
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

using Places = std::vector<Eigen::Vector3d>;

constexpr const char* kSureLayer = "ROCKS";
constexpr const char* kDoubtfulLayer = "ROCKS_DOUBTFUL";
constexpr const char* kNumberLayer = "ROCK_NUMBERS";
constexpr std::array<files::DxfLayer, 3> kRockLayers{{{kSureLayer, "3"}, {kDoubtfulLayer, "2"}, {kNumberLayer, "7"}}};
constexpr std::size_t kFewestCorners = 3;
constexpr double kNumberHeight = 0.3; // share of the visible width
constexpr double kSmallestNumberM = 0.05, kLargestNumberM = 0.5;

// By label: the closed lines around the visible surface of each rock, the first point not repeated.
std::vector<std::vector<Places>> outlinesInSpace(const rocks::Study& study, const FramePoints& points) {
    const auto rings = rocks::outlinesOf(rocks::visibleSurfaces(*study.segmentation, study.map), study.map.rocks);
    std::vector<std::vector<Places>> outlines(rings.size());
    for (std::size_t label = 1; label < rings.size(); ++label) {
        for (const rocks::OutlineRing& ring : rings[label]) {
            if (ring.inside.size() < kFewestCorners) continue;
            Places places;
            for (const std::uint32_t k : ring.inside) places.push_back(points.at(k));
            outlines[label].push_back(std::move(places));
        }
    }
    return outlines;
}

std::string dxfOutlines(const rocks::Study& study, const FramePoints& points, const std::string& record) {
    const auto outlines = outlinesInSpace(study, points);
    const auto middleOf = [&](const rocks::Rock& rock) { return points.at(rock.cell, rock.centreM); };
    Eigen::AlignedBox3d box;
    for (const rocks::Rock* rock : rocks::rocksToList(study)) {
        box.extend(middleOf(*rock));
        for (const Places& line : outlines[rock->label]) {
            for (const Eigen::Vector3d& place : line) box.extend(place);
        }
    }
    files::DxfText drawing(false);
    drawing.comment(points.text());
    drawing.comment(rocks::kRockCaveat);
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) drawing.comment(line);
    drawing.begin(box, kRockLayers);
    for (const rocks::Rock* listed : rocks::rocksToList(study)) {
        const rocks::Rock& rock = *listed;
        const char* layer = rocks::isDoubtful(rock) && !rock.byHand ? kDoubtfulLayer : kSureLayer;
        for (const Places& line : outlines[rock.label]) {
            drawing.beginLine(layer, true);
            for (const Eigen::Vector3d& place : line) drawing.vertex(layer, place);
            drawing.endLine(layer);
        }
        drawing.text(kNumberLayer, middleOf(rock), std::clamp(kNumberHeight * rock.shortestCaliperM, kSmallestNumberM, kLargestNumberM),
                     std::to_string(rock.label));
    }
    return drawing.end();
}

Json lineJson(const Places& line) {
    constexpr double kTenthsOfMillimetres = 1e4;
    Json corners = Json::array();
    for (std::size_t n = 0; n <= line.size(); ++n) {
        const Eigen::Vector3d& place = line[n % line.size()];
        corners.push_back(
            {rounded(place.x(), kTenthsOfMillimetres), rounded(place.y(), kTenthsOfMillimetres), rounded(place.z(), kTenthsOfMillimetres)});
    }
    return corners;
}

Json recordJson(const std::string& record) {
    const auto parsed = parseOrderedJson(record, "");
    return parsed ? *parsed : Json();
}

// The member "crs" of GeoJSON 2008: without it programs take the numbers for degrees. A system that is not known is a local one, which GDAL
// reads as well-known text.
Json systemJson(const Scan& scan) {
    const std::optional<int> code = files::epsgCode(scan.placement->grid);
    files::CloudColumns cloud; // without points
    cloud.frame = CoordinateFrame::Mine;
    cloud.grid = scan.placement->grid;
    return {{"type", "name"},
            {"properties", {{"name", code ? "urn:ogc:def:crs:EPSG::" + std::to_string(*code) : files::coordinateSystemWkt(cloud)}}}};
}

std::string geoJsonOutlines(const rocks::Study& study, const std::string& record) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const auto outlines = outlinesInSpace(study, FramePoints(scan, CoordinateFrame::Mine));
    const Json rows = rockRowsJson(study, CoordinateFrame::Mine);
    Json features = Json::array();
    for (const rocks::Rock* rock : rocks::rocksToList(study)) {
        Json lines = Json::array();
        for (const Places& line : outlines[rock->label]) lines.push_back(lineJson(line));
        const Json geometry{{"type", "MultiLineString"}, {"coordinates", lines}};
        features.push_back({{"type", "Feature"},
                            {"id", rock->label},
                            {"properties", rows[features.size()]},
                            {"geometry", lines.empty() ? Json() : geometry}});
    }
    const Json collection{{"type", "FeatureCollection"},
                          {"name", "rocks"},
                          {"crs", systemJson(scan)},
                          {"note", rocks::kRockCaveat},
                          {"coordinates", "Easting, Northing, Elevation, metres"},
                          {"frame", frameName(CoordinateFrame::Mine)},
                          {"grid", scan.placement->grid},
                          {"edgescan-record", recordJson(record)},
                          {"features", features}};
    return jsonText(collection, -1) + "\n";
}

Json cornersJson(const rocks::OutlineRing& ring) {
    Json corners = Json::array();
    for (const rocks::CellCorner& corner : ring.corners) corners.push_back({corner.beam, corner.line});
    if (!ring.corners.empty()) corners.push_back({ring.corners.front().beam, ring.corners.front().line});
    return corners;
}

void appendPlace(std::string& text, const Eigen::Vector3d& place, int decimals) {
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        appendFixed(text, place[axis], decimals);
    }
}

std::string plyHulls(const std::vector<rocks::Hull>& hulls, const FramePoints& points, const std::string& record) {
    std::size_t corners = 0;
    std::size_t triangles = 0;
    for (const rocks::Hull& hull : hulls) {
        corners += hull.cells.size();
        triangles += hull.triangles.size();
    }
    std::string text = "ply\nformat ascii 1.0\ncomment " + points.text() +
                       "\ncomment convex hulls of visible points, never a volume\ncomment " + rocks::kRockCaveat + "\n";
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) text += "comment " + line + "\n";
    text += "element vertex " + std::to_string(corners) + "\nproperty double x\nproperty double y\nproperty double z\nproperty uint rock\n";
    text += "element face " + std::to_string(triangles) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const rocks::Hull& hull : hulls) {
        for (const std::uint32_t k : hull.cells) {
            appendPlace(text, points.at(k), points.decimals());
            text += " " + std::to_string(hull.label) + "\n";
        }
    }
    std::size_t first = 0;
    for (const rocks::Hull& hull : hulls) {
        for (const auto& [a, b, c] : hull.triangles)
            text += "3 " + std::to_string(first + a) + " " + std::to_string(first + b) + " " + std::to_string(first + c) + "\n";
        first += hull.cells.size();
    }
    return text;
}

std::string objHulls(const std::vector<rocks::Hull>& hulls, const FramePoints& points, const std::string& record) {
    std::string text = "# " + points.text() + "\n# convex hulls of visible points, never a volume\n# " + rocks::kRockCaveat + "\n";
    for (const std::string& line : files::commentLines(record, files::kRecordMark)) text += "# " + line + "\n";
    std::size_t first = 1;
    for (const rocks::Hull& hull : hulls) {
        if (hull.triangles.empty()) continue;
        text += "o rock_" + std::to_string(hull.label) + "\n";
        for (const std::uint32_t k : hull.cells) {
            text += "v ";
            appendPlace(text, points.at(k), points.decimals());
            text += '\n';
        }
        for (const auto& [a, b, c] : hull.triangles)
            text += "f " + std::to_string(first + a) + " " + std::to_string(first + b) + " " + std::to_string(first + c) + "\n";
        first += hull.cells.size();
    }
    return text;
}

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

Result<std::string> outlineBytes(const rocks::Study& study, CoordinateFrame frame, const std::filesystem::path& path,
                                 const std::string& record) {
    const Scan& scan = *study.segmentation->inputs.scan;
    const std::string extension = files::Source::lowerCase(path.extension());
    if (extension == ".geojson" && (frame != CoordinateFrame::Mine || scan.placement == nullptr))
        return Error{"programs take the numbers of GeoJSON for places on a map, and these would be in the " +
                         std::string(frame == CoordinateFrame::MineLocal ? "frame of a local origin" : "scanner's frame"),
                     path.string(),
                     scan.placement == nullptr
                         ? "give a pose and the robot's calibration, or write .dxf, or the outlines in the picture (.json)"
                         : "choose the mine grid as the frame (--frame mine), or write .dxf"};
    if (auto known = files::checkFrame(scan, frame, path.string()); !known) return known.error();
    if (extension == ".dxf") return dxfOutlines(study, FramePoints(scan, frame), record);
    if (extension == ".geojson") return geoJsonOutlines(study, record);
    return Error{"the extension names no format for this", path.string(), "use .dxf or .geojson"};
}

std::string pictureOutlines(const rocks::Study& study, const std::string& record) {
    const Grid<std::uint32_t> labels = rocks::rockLabels(*study.segmentation, study.map);
    const auto outlines = rocks::outlinesOf(labels, study.map.rocks);
    Json rows = Json::array();
    for (const rocks::Rock* rock : rocks::rocksToList(study)) {
        Json polygons = Json::array();
        for (const rocks::OutlineRing& ring : outlines[rock->label]) {
            if (!ring.hole) polygons.push_back(Json::array());
            polygons.back().push_back(cornersJson(ring));
        }
        rows.push_back({{"rock", rock->label}, {"polygons", polygons}});
    }
    const Json whole{{"schema", "edgescan-picture-outlines/1"},
                     {"note", rocks::kRockCaveat},
                     {"coordinates", "x = beam, y = line, corners of cells; lines go down"},
                     {"lines", labels.lines},
                     {"beams", labels.beams},
                     {"edgescan-record", recordJson(record)},
                     {"rocks", rows}};
    return jsonText(whole, -1) + "\n";
}

Result<Grid<std::uint16_t>> labelPicture(const rocks::Study& study, const std::string& where) {
    if (study.map.rocks > UINT16_MAX)
        return Error{"there are " + std::to_string(study.map.rocks) + " numbers of rocks and a picture of 16 bits numbers 65535", where,
                     "ask for larger rocks with --min-cells"};
    const Grid<std::uint32_t> labels = rocks::rockLabels(*study.segmentation, study.map);
    Grid<std::uint16_t> picture(labels.lines, labels.beams);
    for (std::size_t k = 0; k < labels.size(); ++k) picture[k] = static_cast<std::uint16_t>(labels[k]);
    return picture;
}

Result<std::string> tableBytes(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names,
                               const std::filesystem::path& path) {
    if (auto known = files::checkFrame(*study.segmentation->inputs.scan, frame, path.string()); !known) return known.error();
    return rocksTable(study, frame, names);
}

Result<std::string> reportBytes(const rocks::Study& study, CoordinateFrame frame, const rocks::NamedCells& names,
                                const std::filesystem::path& path, const std::string& record) {
    if (auto known = files::checkFrame(*study.segmentation->inputs.scan, frame, path.string()); !known) return known.error();
    Json whole{{"schema", kRocksSchema}};
    whole.update(rocksReport(study, frame, names));
    // A later version that verifies the export makes the same file, even if the scan was moved.
    const auto parsed = parseOrderedJson(record, "");
    if (parsed) {
        whole["input"] = parsed->at(Json::json_pointer("/scan/input"));
        whole["version"] = parsed->at(Json::json_pointer("/program/version"));
    }
    return jsonText(whole, 2) + "\n";
}

Result<std::string> hullBytes(const rocks::Study& study, CoordinateFrame frame, const std::filesystem::path& path,
                              const std::string& record) {
    const Scan& scan = *study.segmentation->inputs.scan;
    if (auto known = files::checkFrame(scan, frame, path.string()); !known) return known.error();
    const bool isPly = files::Source::lowerCase(path.extension()) == ".ply";
    if (!isPly && files::Source::lowerCase(path.extension()) != ".obj")
        return Error{"the extension names no format for this", path.string(), "use .ply or .obj"};
    const std::vector<rocks::Hull> all = rocks::rockHulls(*study.segmentation, study.map);
    std::vector<rocks::Hull> hulls;
    for (const rocks::Rock* rock : rocks::rocksToList(study)) hulls.push_back(all[rock->label - 1]);
    return (isPly ? plyHulls : objHulls)(hulls, FramePoints(scan, frame), record);
}

Json rocksRecord(const rocks::Study& study) {
    const Scan& scan = *study.segmentation->inputs.scan;
    Json record{{"settings", rocks::rockSettingsToJson(study.settings)},
                {"edits", rocks::rockEditsToJson(study.edits, scan.lines(), scan.beams())},
                {"count", study.rocks.size()},
                {"labels_sha256", labelsSha256(rocks::rockLabels(*study.segmentation, study.map))},
                {"note", rocks::kRockCaveat}};
    if (study.listed) record["listed"] = *study.listed;
    return record;
}

} // namespace edgescan::exports
