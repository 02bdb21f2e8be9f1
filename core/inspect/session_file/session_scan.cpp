// Reads and writes the scan of a session, and finds its file.
#include "core/inspect/session_file/session_scan.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>

namespace edgescan::inspect {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPath = 4096;
constexpr int kMostSide = 1'000'000;
constexpr std::uint64_t kMostSessionCells = std::uint64_t{1} << 28U;
const std::vector<std::string> kBases{"poses", "pairs", "surfaces"};                        // as StationBasis
const std::vector<std::string> kScanKinds{"file", "demo", "demo_after_blast", "recording"}; // as SessionScan::Kind

/// The relative path if it remains valid when both files are moved together: for paths in or below the folder above `folder`. Otherwise
/// empty.
std::string relativePath(const fs::path& path, const fs::path& folder) {
    const fs::path relative = path.lexically_relative(folder);
    const auto up = std::ranges::count(relative, fs::path(".."));
    return relative.empty() || up > 1 ? std::string() : relative.generic_string();
}

nlohmann::ordered_json pathJson(const fs::path& path, const fs::path& folder) {
    nlohmann::ordered_json json{{"absolute", path.string()}};
    if (const std::string relative = relativePath(path, folder); !relative.empty()) json["relative"] = relative;
    return json;
}

/// Both places, the relative one first.
std::vector<fs::path> pathsFrom(JsonFields fields, const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const char* key : {"relative", "absolute"}) {
        const std::string text = fields.text(key);
        if (text.size() > kLongestPath || text.find('\0') != std::string::npos) fields.refuse(key, "must be a path");
        if (text.empty() || fields.problem()) continue;
        const fs::path path = (fs::path(key[0] == 'r' ? folder : fs::path()) / text).lexically_normal();
        if (!path.is_absolute()) fields.refuse(key, "must be a whole path");
        if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
    }
    fields.done();
    if (paths.empty()) fields.refuse("absolute", "must be a path");
    return paths;
}

/// The first existing path; if no path exists, the first one.
std::string pathThere(const std::vector<fs::path>& paths) {
    std::error_code none;
    for (const fs::path& path : paths) {
        if (fs::exists(path, none)) return path.string();
    }
    return paths.empty() ? std::string() : paths.front().string();
}

nlohmann::ordered_json placeJson(const LayerPlace& place) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({place.toFirst.rotation(i, 0), place.toFirst.rotation(i, 1), place.toFirst.rotation(i, 2)});
    const Eigen::Vector3d& shift = place.toFirst.translationM;
    nlohmann::ordered_json json{{"by", kBases[static_cast<std::size_t>(place.by)]},
                                {"rotation", std::move(rows)},
                                {"translation_m", {shift.x(), shift.y(), shift.z()}}};
    if (place.residualM) json["residual_m"] = *place.residualM;
    if (place.pairsM) json["pairs_m"] = *place.pairsM;
    if (!place.warnings.empty()) json["warnings"] = place.warnings;
    return json;
}

LayerPlace placeFrom(JsonFields fields) {
    LayerPlace place;
    place.by = static_cast<StationBasis>(fields.choice("by", kBases));
    place.toFirst = {fields.rotation("rotation"), fields.neededVector("translation_m")};
    if (fields.has("residual_m")) place.residualM = fields.neededNumber("residual_m", {0.0, 1e6});
    if (fields.has("pairs_m")) place.pairsM = fields.neededNumber("pairs_m", {0.0, 1e6});
    place.warnings = fields.texts("warnings");
    fields.done();
    return place;
}

fs::path absolutePath(const fs::path& path) { return path.empty() ? path : fs::absolute(path).lexically_normal(); }

} // namespace

SessionScan fileScan(const fs::path& path, ReadingOptions reading, const NotebookScan& identity) {
    reading.pose = absolutePath(reading.pose).string();
    reading.calibration = absolutePath(reading.calibration).string();
    reading.progress = nullptr;
    return {SessionScan::Kind::File, absolutePath(path), identity, {}, 0.0, std::move(reading)};
}

nlohmann::ordered_json sessionScanJson(const SessionScan& scan, const fs::path& folder) {
    nlohmann::ordered_json json{{"kind", kScanKinds[static_cast<std::size_t>(scan.kind)]}};
    if (hasPath(scan.kind)) json["path"] = pathJson(scan.path, folder);
    if (scan.kind == SessionScan::Kind::Recording) json["head"] = {{"lines", scan.head.lines}, {"sha256", scan.head.sha256}};
    if (scan.startS > 0.0) json["head"]["start_s"] = scan.startS;
    json["sha256"] = scan.identity.sha256;
    json["name"] = scan.identity.name;
    json["lines"] = scan.identity.lines;
    json["beams"] = scan.identity.beams;
    if (const std::string reading = readingOptionsText(scan.reading); !reading.empty()) {
        if (const auto object = parseOrderedJson(reading, "session")) json["reading"] = *object;
    }
    if (!scan.reading.pose.empty()) json["pose"] = pathJson(scan.reading.pose, folder);
    if (!scan.reading.calibration.empty()) json["calibration"] = pathJson(scan.reading.calibration, folder);
    return json;
}

Result<PlacedSessionScan> sessionScanFrom(JsonFields fields, const fs::path& folder, const std::string& where) {
    PlacedSessionScan placed;
    SessionScan& scan = placed.scan;
    scan.kind = static_cast<SessionScan::Kind>(fields.choice("kind", kScanKinds));
    if (hasPath(scan.kind)) placed.places = pathsFrom(fields.object("path"), folder);
    if (scan.kind == SessionScan::Kind::Recording) {
        JsonFields head = fields.object("head");
        scan.head = {static_cast<int>(head.wholeNumber("lines", 1, kMostSide)), head.text("sha256")};
        scan.startS = head.number("start_s", 0.0);
        head.done();
    }
    scan.path = pathThere(placed.places);
    scan.identity = {fields.text("sha256"), fields.text("name"), static_cast<int>(fields.wholeNumber("lines", 1, kMostSide)),
                     static_cast<int>(fields.wholeNumber("beams", 1, kMostSide))};
    if (static_cast<std::uint64_t>(scan.identity.lines) * static_cast<std::uint64_t>(scan.identity.beams) > kMostSessionCells)
        fields.refuse("lines", "must be those of a scan of at most 2^28 cells");
    if (const nlohmann::json& reading = fields.value("reading"); !reading.is_null()) {
        auto options = parseReadingOptions(jsonText(reading), where);
        if (!options) return options.error();
        scan.reading = std::move(*options);
    }
    if (fields.has("pose")) scan.reading.pose = pathThere(pathsFrom(fields.object("pose"), folder));
    if (fields.has("calibration")) scan.reading.calibration = pathThere(pathsFrom(fields.object("calibration"), folder));
    fields.done();
    if (fields.problem()) return *fields.problem();
    return placed;
}

nlohmann::ordered_json layersJson(const std::vector<Layer>& layers, const fs::path& folder) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Layer& layer : layers) {
        nlohmann::ordered_json one{{"scan", sessionScanJson(layer.scan, folder)}, {"visible", layer.visible}};
        if (layer.place) one["place"] = placeJson(*layer.place);
        list.push_back(std::move(one));
    }
    return list;
}

Result<std::vector<Layer>> layersFrom(JsonFields& fields, const char* key, const fs::path& folder, const std::string& where) {
    std::vector<Layer> layers;
    for (JsonFields& one : fields.objects(key)) {
        auto scan = sessionScanFrom(one.object("scan"), folder, where);
        if (!scan) return scan.error();
        Layer layer{std::move(scan->scan), one.boolean("visible", true), std::nullopt};
        if (one.has("place")) layer.place = placeFrom(one.object("place"));
        one.done();
        layers.push_back(std::move(layer));
    }
    if (layers.size() > kMostLayers) fields.refuse(key, "must be a list of at most 50 scans");
    return layers;
}

} // namespace edgescan::inspect
