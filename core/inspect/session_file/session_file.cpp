// Reads and writes session files.
#include "core/inspect/session_file/session_file.h"

#include "core/base/bounded_json.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/utc_time.h"
#include "core/base/version.h"
#include "core/base/whole_file.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/inspect/session_file/session_scan.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace edgescan::inspect {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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
