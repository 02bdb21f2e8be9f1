// Reads and writes session files.
#include "core/inspect/session_file/session_file.h"

#include "core/base/bounded_json.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/grid/scan_time.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <system_error>

namespace edgescan::inspect {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void cut(std::vector<CellRun>& runs, std::size_t cells) {
    std::erase_if(runs, [cells](const CellRun& run) { return run.first >= cells; });
    if (!runs.empty()) runs.back().count = static_cast<std::uint32_t>(std::min<std::size_t>(runs.back().count, cells - runs.back().first));
}

// The scans of a session as JSON: kind, paths, hash, reading options; and the place of each layer.

struct PlacedSessionScan {
    SessionScan scan;                          ///< with the most likely of the paths
    std::vector<std::filesystem::path> places; ///< all paths, the most likely first
};

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

/// Error: those of sessionFromText().
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

/// Error: those of sessionFromText().
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

constexpr const char* kSessionFormat = "edgescan-session/1";
constexpr const char* kAnySessionFormat = "\"edgescan-session/"; // also of a later EdgeScan
constexpr JsonBounds kSessionJson{std::size_t{32} << 20U, 10, 100'000};
constexpr std::size_t kMostSwitches = 100;
constexpr std::size_t kLongestLayout = std::size_t{1} << 16U; // bytes
constexpr std::size_t kLongestPreset = 4096;

Json vectorJson(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// [first, count, first, count, ...]
Json runsJson(const std::vector<CellRun>& runs) {
    Json list = Json::array();
    for (const CellRun& run : runs) {
        list.push_back(run.first);
        list.push_back(run.count);
    }
    return list;
}

/// Stored as runs: a few bytes may represent very many cells.
std::vector<CellRun> runsFrom(JsonFields& fields, const char* key, std::size_t cells) {
    const nlohmann::json& list = fields.value(key);
    std::vector<CellRun> runs;
    if (list.is_null()) return runs;
    const auto isIndex = [](const nlohmann::json& n) { return n.is_number_unsigned() && n.get<std::uint64_t>() <= UINT32_MAX; };
    bool good = list.is_array() && list.size() % 2 == 0 && std::ranges::all_of(list, isIndex);
    std::size_t end = 0;
    for (std::size_t n = 0; good && n + 1 < list.size(); n += 2) {
        const CellRun run{list[n].get<std::uint32_t>(), list[n + 1].get<std::uint32_t>()};
        good = run.count > 0 && run.first >= end && run.count <= cells && run.first <= cells - run.count;
        end = run.first + static_cast<std::size_t>(run.count);
        runs.push_back(run);
    }
    if (!good) fields.refuse(key, "must be a list of first cell and number of cells, in order, of cells of the scan");
    return runs;
}

/// Cells in any order, without duplicates.
std::vector<std::uint32_t> cellsFrom(JsonFields& fields, const char* key, std::size_t cells) {
    const nlohmann::json& list = fields.value(key);
    std::vector<std::uint32_t> found;
    if (list.is_null()) return found;
    const auto isCell = [&](const nlohmann::json& n) { return n.is_number_unsigned() && n.get<std::uint64_t>() < cells; };
    if (!list.is_array() || list.size() > edges::kMostMarks || !std::ranges::all_of(list, isCell)) {
        fields.refuse(key, "must be a list of cells of the scan, 1000 at most");
        return found;
    }
    for (const nlohmann::json& cell : list) found.push_back(cell.get<std::uint32_t>());
    std::vector<std::uint32_t> sorted = found;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) fields.refuse(key, "must have no cell twice");
    return found;
}

std::map<std::string, std::string> textsFrom(JsonFields& fields, const char* key) {
    std::map<std::string, std::string> texts;
    const nlohmann::json& object = fields.value(key);
    if (object.is_null()) return texts;
    const auto isText = [](const nlohmann::json& each) {
        return each.is_string() && each.get_ref<const std::string&>().size() <= kLongestLayout;
    };
    if (!object.is_object() || object.size() > kMostSwitches || !std::ranges::all_of(object, isText))
        fields.refuse(key, "must be an object of texts");
    else
        for (const auto& [name, text] : object.items()) texts[name] = text.get<std::string>();
    return texts;
}

std::map<std::string, bool> switchesFrom(JsonFields& fields, const char* key) {
    std::map<std::string, bool> switches;
    const nlohmann::json& object = fields.value(key);
    if (object.is_null()) return switches;
    const auto isSwitch = [](const nlohmann::json& each) { return each.is_boolean(); };
    if (!object.is_object() || object.size() > kMostSwitches || !std::ranges::all_of(object, isSwitch))
        fields.refuse(key, "must be an object of switches");
    else
        for (const auto& [name, on] : object.items()) switches[name] = on.get<bool>();
    return switches;
}

std::string shortPath(JsonFields& fields, const char* key) {
    std::string text = fields.text(key);
    if (text.size() > kLongestPreset || text.find('\0') != std::string::npos) fields.refuse(key, "must be a name or a path");
    return text;
}

Json cameraJson(const SessionCamera& camera) {
    return {{"position", vectorJson(camera.position)},
            {"focus", vectorJson(camera.focus)},
            {"up", vectorJson(camera.up)},
            {"view_angle_deg", camera.viewAngleDeg},
            {"parallel", camera.parallel}};
}

/// A valid camera: its viewing direction is defined, and its upward direction is not parallel to it.
SessionCamera cameraFrom(JsonFields fields) {
    SessionCamera camera;
    camera.position = fields.neededVector("position");
    camera.focus = fields.neededVector("focus");
    camera.up = fields.neededVector("up", {-1.0, 1.0});
    camera.viewAngleDeg = fields.neededNumber("view_angle_deg", {1.0, 175.0});
    camera.parallel = fields.boolean("parallel", false);
    fields.done();
    const Eigen::Vector3d way = camera.focus - camera.position;
    if (way.norm() < 1e-6 || way.normalized().cross(camera.up).norm() < 1e-3) fields.refuse("up", "must be a direction across the view");
    return camera;
}

Result<edges::Settings> usableSettings(JsonFields& fields, const std::string& where) {
    const nlohmann::json& object = fields.value("settings");
    if (!object.is_object()) return Error{"\"settings\" must be an object", where, "open another session"};
    const Result<edges::Settings> settings = edges::settingsFromJson(edges::settingsOfRecord(object, 0), edges::cannySettings(), where);
    if (!settings) return settings;
    if (const auto good = edges::checkSettings(*settings); !good) return good.error();
    return settings;
}

/// The parts of the state with their own readers.
Result<Done> nestedFrom(JsonFields& fields, const std::string& where, ReadSession& read) {
    ViewerState& state = read.state;
    const NotebookScan& of = state.scan.identity;
    const Result<edges::Settings> settings = usableSettings(fields, where);
    if (!settings) return settings.error();
    state.tuning.settings = *settings;
    if (const nlohmann::json& targets = fields.value("targets"); !targets.is_null()) {
        auto notebook = notebookFromText(jsonText(targets), of, where);
        if (!notebook) return notebook.error();
        state.targets.notebook = std::move(*notebook);
    }
    if (const nlohmann::json& rocks = fields.value("rocks"); !rocks.is_null()) {
        auto preset = rocks::rockPresetFromText(jsonText(rocks), of.lines, of.beams, of.sha256, where);
        if (!preset) return preset.error();
        state.rocks = std::move(*preset);
    }
    return Done{};
}

} // namespace

SessionScan fileScan(const fs::path& path, ReadingOptions reading, const NotebookScan& identity) {
    reading.pose = absolutePath(reading.pose).string();
    reading.calibration = absolutePath(reading.calibration).string();
    reading.progress = nullptr;
    return {SessionScan::Kind::File, absolutePath(path), identity, {}, 0.0, std::move(reading)};
}

ScanHead scanHead(const Scan& scan, int lines) {
    const int taken = std::min(lines, scan.lines());
    const std::size_t cells = static_cast<std::size_t>(taken) * static_cast<std::size_t>(scan.beams());
    return {taken, sha256Hex(std::as_bytes(std::span(scan.rangeMm.cells).first(cells)))};
}

bool isSweepOf(const SessionScan& scan, const Scan& sweep) {
    const double startS = startOfScan(sweep).value_or(0.0);
    const bool otherStart = scan.startS > 0.0 && startS > 0.0 && std::abs(startS - scan.startS) > kSameStartS;
    return !otherStart && sweep.beams() == scan.identity.beams && scanHead(sweep, scan.head.lines) == scan.head;
}

ViewerState cutTo(ViewerState state, std::size_t cells) {
    const auto gone = [cells](std::uint32_t cell) { return cell >= cells; };
    const auto someGone = [&gone](const auto& one) { return std::ranges::any_of(one.cells, gone); };
    std::erase_if(state.targets.notebook.targets, [&gone](const PinnedTarget& target) { return gone(target.cell); });
    std::erase_if(state.targets.notebook.measures, someGone);
    if (state.targets.active && gone(*state.targets.active)) state.targets.active.reset();
    cut(state.selection.selected, cells);
    cut(state.selection.hidden, cells);
    std::erase_if(state.marks.wanted, gone);
    std::erase_if(state.marks.unwanted, gone);
    if (state.rocks) std::erase_if(state.rocks->edits, someGone);
    return state;
}

std::string sessionText(const ViewerState& state, const fs::path& folder, const std::string& savedUtc) {
    const NotebookScan& of = state.scan.identity;
    Json whole{{"format", kSessionFormat},      {"program", version()},
               {"saved_utc", savedUtc},         {"scan", sessionScanJson(state.scan, folder)},
               {"preset", state.tuning.preset}, {"settings", edges::settingsToJson(state.tuning.settings)}};
    const auto text = [](const std::string& nested) {
        const auto json = parseOrderedJson(nested, "session");
        return json ? *json : Json();
    };
    whole["targets"] = text(notebookText(state.targets.notebook, of));
    if (state.targets.active) whole["active"] = *state.targets.active;
    whole["selected"] = runsJson(state.selection.selected);
    whole["hidden"] = runsJson(state.selection.hidden);
    if (state.rocks) whole["rocks"] = text(rocks::rockPresetText(*state.rocks, of.lines, of.beams));
    whole["marked"] = {{"edge", state.marks.wanted}, {"no_edge", state.marks.unwanted}};
    if (state.earlier)
        whole["kept"] = {{"scan", sessionScanJson(state.earlier->scan, folder)},
                         {"settings", edges::settingsToJson(state.earlier->settings)}};
    if (!state.layers.empty()) whole["layers"] = layersJson(state.layers, folder);
    if (state.view.camera) whole["camera"] = cameraJson(*state.view.camera);
    if (state.view.images)
        whole["images"] = {{"beam", state.view.images->beam}, {"line", state.view.images->line}, {"zoom", state.view.images->zoom}};
    whole["switches"] = state.switches;
    whole["looks"] = state.looks;
    whole["layout"] = state.layout;
    if (!state.keptIn.empty()) whole["kept_in"] = state.keptIn.string();
    return asciiJsonText(whole, 1) + "\n";
}

Result<ReadSession> sessionFromText(std::string_view text, const fs::path& folder, const std::string& where) {
    const auto object = parseJson(text, where, kSessionJson);
    if (!object) return object.error();
    if (!object->is_object() || !object->contains("format") || (*object)["format"] != kSessionFormat)
        return Error{std::string("this is not a session (") + kSessionFormat + ")", where,
                     "choose a file that EdgeScan saved as a session"};
    JsonFields fields(*object, where, "open another session, or the scan itself");
    (void)fields.text("format");
    (void)fields.text("program");
    ReadSession read;
    ViewerState& state = read.state;
    read.savedUtc = fields.text("saved_utc");
    if (!read.savedUtc.empty() && !parseUtc(read.savedUtc)) fields.refuse("saved_utc", "must be a time such as 2026-11-20T10:15:30Z");
    auto scan = sessionScanFrom(fields.object("scan"), folder, where);
    if (!scan) return scan.error();
    state.scan = std::move(scan->scan);
    read.places = std::move(scan->places);
    const std::size_t cells = static_cast<std::size_t>(state.scan.identity.lines) * static_cast<std::size_t>(state.scan.identity.beams);
    state.tuning.preset = shortPath(fields, "preset");
    if (auto nested = nestedFrom(fields, where, read); !nested) return nested.error();
    if (fields.has("active")) state.targets.active = static_cast<std::uint32_t>(fields.wholeNumber("active", 0, cells - 1));
    state.selection.selected = runsFrom(fields, "selected", cells);
    state.selection.hidden = runsFrom(fields, "hidden", cells);
    JsonFields marked = fields.object("marked");
    state.marks = {cellsFrom(marked, "edge", cells), cellsFrom(marked, "no_edge", cells)};
    marked.done();
    if (fields.has("kept")) {
        JsonFields kept = fields.object("kept");
        auto of = sessionScanFrom(kept.object("scan"), folder, where);
        if (!of) return of.error();
        const Result<edges::Settings> settings = usableSettings(kept, where);
        if (!settings) return settings.error();
        kept.done();
        state.earlier = EarlierScan{std::move(of->scan), *settings};
    }
    if (fields.has("layers")) {
        auto layers = layersFrom(fields, "layers", folder, where);
        if (!layers) return layers.error();
        state.layers = std::move(*layers);
    }
    if (fields.has("camera")) state.view.camera = cameraFrom(fields.object("camera"));
    if (fields.has("images")) {
        JsonFields images = fields.object("images");
        state.view.images = SessionImages{images.neededNumber("beam", {-1e9, 1e9}), images.neededNumber("line", {-1e9, 1e9}),
                                          images.neededNumber("zoom", {1e-4, 1e4})};
        images.done();
    }
    state.switches = switchesFrom(fields, "switches");
    state.looks = textsFrom(fields, "looks");
    state.layout = textsFrom(fields, "layout");
    state.keptIn = shortPath(fields, "kept_in");
    fields.done();
    if (fields.problem()) return *fields.problem();
    return read;
}

Result<ReadSession> readSession(const fs::path& path) {
    const auto bytes = readWholeFile(path, kSessionJson.bytes);
    if (!bytes) return bytes.error();
    return sessionFromText(textOf(*bytes), fs::absolute(path).parent_path(), path.string());
}

bool isSession(const fs::path& path) {
    std::error_code problem;
    if (!fs::is_regular_file(path, problem) || fs::file_size(path, problem) > kSessionJson.bytes || problem) return false;
    const auto bytes = readWholeFile(path, kSessionJson.bytes);
    if (!bytes) return false;
    const std::string_view text = textOf(*bytes);
    const auto first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{' && text.find(kAnySessionFormat) != std::string_view::npos;
}

} // namespace edgescan::inspect
