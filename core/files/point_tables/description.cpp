// Reading the JSON description: every key is checked, because it may come from anywhere.
#include "core/files/point_tables/description.h"

#include "core/base/checked_size.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/scan/georef/placement_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <utility>

namespace edgescan::files {
namespace {

constexpr std::array<std::pair<const char*, std::string Acquisition::*>, 9> kTexts{{
    {"vendor", &Acquisition::vendor},
    {"model", &Acquisition::model},
    {"serial", &Acquisition::serial},
    {"firmware", &Acquisition::firmware},
    {"start_utc", &Acquisition::startUtc},
    {"end_utc", &Acquisition::endUtc},
    {"clock_source", &Acquisition::clockSource},
    {"contamination", &Acquisition::contamination},
    {"echo_filter", &Acquisition::echoFilter},
}};

constexpr const char* kFormat = "edgescan-raw-grid/1";
constexpr auto kMostCells = static_cast<std::uint64_t>(physical::kAlongOneSide.limits.most);
constexpr std::size_t kMostCodes = 65536; // as many as 16 bits can distinguish
const char* const kSeeFormat = "compare it with docs/reference/formats.md, \"Raw grid\"";

/// What else this program writes as JSON, and what it is for.
struct OwnFile {
    std::string_view format, what, hint;
};
constexpr std::array kOwnFiles = std::to_array<OwnFile>({
    {"FeatureCollection", "this is a drawing of rocks (GeoJSON) and not a scan", "open its scan"},
    {"edgescan-preset/1", "this is a preset and not a scan", "choose it in the panel Edges, or give it with --preset"},
    {"edgescan-detect/1", "this is a report of detect and not a scan", "open its scan"},
    {"edgescan-rocks/1", "this is a report of rocks and not a scan", "open its scan"},
    {"edgescan-pose/1", "this is a pose and not a scan", "open its scan and give it with --pose"},
    {"edgescan-calibration/1", "this is a calibration and not a scan", "open its scan and give it with --calibration"},
    {"edgescan-targets/1", "this is a file of targets and not a scan", "open its scan"},
    {"edgescan-rock-edits/1", "this is edits of rocks and not a scan", "open its scan, or give it with --edits"},
    {"edgescan-record/1", "this is a record of an export and not a scan", "open its scan, or check it with edgescan-cli verify"},
    {"edgescan-provenance/1", "this is a record of an export and not a scan", "open its scan, or check it with edgescan-cli verify"},
});

std::vector<std::uint32_t> codesIn(JsonFields& fields, const char* key, std::vector<std::uint32_t> missing) {
    if (!fields.has(key)) return missing;
    std::vector<std::uint32_t> codes;
    for (const double value : fields.numbers(key, {0, 4294967295.0})) {
        if (value != std::floor(value)) return fields.refuse(key, "must hold counts"), missing;
        codes.push_back(static_cast<std::uint32_t>(value));
    }
    if (codes.size() > kMostCodes)
        return fields.refuse(key, withValues("holds %1, and there are %2", {counted(codes.size(), "count"), kMostCodes})), missing;
    return codes;
}

std::optional<AngleList> anglesIn(JsonFields& fields, const char* key, std::uint64_t count, NumberLimits limits) {
    if (!fields.has(key)) return std::nullopt;
    if (fields.value(key).is_object()) {
        JsonFields steps = fields.object(key);
        if (!steps.has("start") || !steps.has("step")) return fields.refuse(key, "needs start and step"), std::nullopt;
        return AngleSteps{steps.number("start", 0, limits), steps.number("step", 0, physical::kStepDeg.limits)};
    }
    auto list = fields.numbers(key, limits);
    if (list.size() != count) fields.refuse(key, withValues("holds %1, %2 are needed", {counted(list.size(), "angle"), count}));
    return AngleList{std::move(list)};
}

void readAxis(JsonFields& fields, GridDescription& grid) {
    if (fields.has("axis")) grid.axis = fields.choice("axis", {"spin", "sweep"}) == 0 ? Axis::Spin : Axis::Sweep;
    grid.lineDirection = fields.number("line_direction", 1.0);
    if (std::abs(grid.lineDirection) != 1.0) fields.refuse("line_direction", "must be 1 or -1");
    if (fields.has("sensor_m")) grid.sensorM = fields.neededVector("sensor_m", physical::kPlaceM.limits);
}

void readStateRuns(JsonFields& fields, GridDescription& grid) {
    if (!fields.has("state_runs")) return;
    const nlohmann::json& runs = fields.value("state_runs");
    if (!runs.is_array()) return fields.refuse("state_runs", "must be a list");
    const std::uint64_t cells = productOf({grid.lines, grid.beams});
    for (const nlohmann::json& run : runs) {
        const bool shaped =
            run.is_array() && run.size() == 3 && run[0].is_string() && run[1].is_number_unsigned() && run[2].is_number_unsigned();
        const auto state = shaped ? cellStateNamed(run[0].get<std::string>()) : std::nullopt;
        if (!state) return fields.refuse("state_runs", "must hold [\"state\", first cell, cells]");
        const StateRun read{*state, run[1].get<std::uint64_t>(), run[2].get<std::uint64_t>()};
        if (sumOf({read.firstCell, read.cells}) > cells) return fields.refuse("state_runs", "leaves the grid");
        if (read.cells > 0) grid.stateRuns.push_back(read);
    }
    // A cell has one state: runs that overlap say two, and a few bytes each could name the whole grid over and over.
    std::ranges::sort(grid.stateRuns, {}, &StateRun::firstCell);
    for (std::size_t i = 1; i < grid.stateRuns.size(); ++i) {
        const StateRun& before = grid.stateRuns[i - 1];
        if (before.firstCell + before.cells > grid.stateRuns[i].firstCell)
            return fields.refuse("state_runs", withValues("names cell %1 twice", {grid.stateRuns[i].firstCell}));
    }
}

/// The place of the scan; it must fit the grid.
Result<std::shared_ptr<const Placement>> readPlacement(JsonFields& fields, const GridDescription& grid, const std::string& where) {
    if (!fields.has("placement")) return std::shared_ptr<const Placement>();
    return placementFromJson(fields.value("placement"), grid.lines, where);
}

void readDataFile(JsonFields& fields, GridDescription& grid) {
    if (!fields.has("data")) return;
    const std::string name = fields.text("data");
    const std::filesystem::path path(name);
    const bool leaves = std::any_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
    if (name.empty() || path.is_absolute() || leaves || name.find('\0') != std::string::npos) {
        return fields.refuse("data", "must name a file in the same folder");
    }
    grid.dataFile = name;
}

nlohmann::json angleJson(const std::vector<double>& degrees) {
    const AngleList list = shortestAngles(degrees);
    if (const auto* steps = std::get_if<AngleSteps>(&list)) return nlohmann::json{{"start", steps->startDeg}, {"step", steps->stepDeg}};
    return std::get<std::vector<double>>(list);
}

} // namespace

nlohmann::ordered_json acquisitionToJson(const Acquisition& acquisition) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const auto& [key, member] : kTexts) {
        if (!(acquisition.*member).empty()) object[key] = acquisition.*member;
    }
    if (acquisition.linesExpected > 0) object["lines_expected"] = acquisition.linesExpected;
    return object;
}

Result<std::shared_ptr<const Acquisition>> acquisitionFromJson(const nlohmann::json& object, const std::string& where) {
    const char* hint = "save the scan again, or remove \"acquisition\"";
    if (!object.is_object()) return Error{"\"acquisition\" must be an object {...}", where, hint};
    JsonFields fields(object, where, hint);
    auto acquisition = std::make_shared<Acquisition>();
    for (const auto& [key, member] : kTexts) (*acquisition).*member = fields.text(key);
    acquisition->linesExpected = static_cast<int>(fields.number("lines_expected", 0, {0, 1e9}));
    fields.done();
    if (fields.problem()) return *fields.problem();
    return std::shared_ptr<const Acquisition>(acquisition);
}

Result<GridDescription> parseDescription(std::string_view json, const std::string& where) {
    const auto object = parseJsonObject(json, kFormat, where);
    if (!object) {
        const auto own = std::ranges::find_if(
            kOwnFiles, [&](const OwnFile& one) { return json.find("\"" + std::string(one.format) + "\"") != json.npos; });
        if (own == kOwnFiles.end()) return object.error();
        return Error{std::string(own->what), where, std::string(own->hint)};
    }
    JsonFields fields(*object, where, kSeeFormat);
    GridDescription grid;
    grid.lines = fields.wholeNumber("lines", 1, kMostCells);
    grid.beams = fields.wholeNumber("beams", 1, kMostCells);
    grid.unitMm = fields.number("unit_mm", 1.0);
    if (!(grid.unitMm > 0)) fields.refuse("unit_mm", "must be greater than 0");
    grid.unitMm = fields.number("unit_mm", 1.0, physical::kUnitMm.limits);
    grid.noReturnCodes = codesIn(fields, "no_return", {0});
    grid.statusCodes = codesIn(fields, "status_codes", {});
    grid.beamDeg = anglesIn(fields, "beam_deg", grid.beams, physical::kBeamDeg.limits);
    grid.lineDeg = anglesIn(fields, "line_deg", grid.lines, physical::kLineDeg.limits);
    grid.lineSkewDeg = anglesIn(fields, "line_skew_deg", grid.beams, physical::kLineDeg.limits);
    grid.note = fields.text("note");
    readDataFile(fields, grid);
    readAxis(fields, grid);
    readStateRuns(fields, grid);
    if (fields.problem()) return *fields.problem();
    auto placement = readPlacement(fields, grid, where);
    if (!placement) return placement.error();
    grid.placement = *placement;
    if (fields.has("acquisition")) {
        auto acquisition = acquisitionFromJson(fields.value("acquisition"), where);
        if (!acquisition) return acquisition.error();
        grid.acquisition = *acquisition;
    }
    grid.unknownKeys = fields.unknown();
    return grid;
}

std::vector<double> anglesOf(const AngleList& list, std::uint64_t count) {
    if (const auto* given = std::get_if<std::vector<double>>(&list)) return *given;
    const auto& steps = std::get<AngleSteps>(list);
    std::vector<double> degrees(count);
    for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = steps.startDeg + static_cast<double>(i) * steps.stepDeg;
    return degrees;
}

std::optional<PolarGeometry> polarOf(const GridDescription& grid) {
    if (!grid.beamDeg || !grid.lineDeg || !grid.axis) return std::nullopt;
    PolarGeometry polar{anglesOf(*grid.beamDeg, grid.beams), anglesOf(*grid.lineDeg, grid.lines), *grid.axis, grid.lineDirection};
    if (grid.lineSkewDeg) polar.lineSkewDeg = anglesOf(*grid.lineSkewDeg, grid.beams);
    return polar;
}

bool needsRangesOnly(const std::string& description) {
    if (description.empty()) return false;
    const auto grid = parseDescription(description, "");
    return grid && !grid->sensorM && grid->beamDeg && grid->lineDeg && grid->axis;
}

void applyDescription(Scan& scan, const GridDescription& grid) {
    scan.unitMm = grid.unitMm;
    scan.noReturnCodes = grid.noReturnCodes;
    scan.statusCodes = grid.statusCodes;
    scan.note = grid.note;
    scan.placement = grid.placement;
    scan.acquisition = grid.acquisition;
}

void applyStateRuns(Scan& scan, const GridDescription& grid) {
    for (const StateRun& run : grid.stateRuns) {
        const auto end = std::min<std::uint64_t>(run.firstCell + run.cells, scan.cells());
        for (std::uint64_t k = run.firstCell; k < end; ++k) scan.state[k] = run.state;
    }
}

AngleList shortestAngles(const std::vector<double>& degrees) {
    if (degrees.empty()) return degrees;
    const double start = degrees.front();
    if (degrees.size() == 1) return AngleSteps{start, 0.0};
    const auto last = static_cast<double>(degrees.size() - 1);
    for (const double step : {degrees[1] - start, (degrees.back() - start) / last, std::round((degrees[1] - start) * 1e9) / 1e9}) {
        if (anglesOf(AngleSteps{start, step}, degrees.size()) == degrees) return AngleSteps{start, step};
    }
    return degrees;
}

Scan headOf(const Scan& scan) {
    Scan head;
    head.rangeMm.lines = scan.lines();
    head.rangeMm.beams = scan.beams();
    head.state = scan.state;
    if (const auto* points = std::get_if<PointGeometry>(&scan.geometry))
        head.geometry = PointGeometry{{}, points->sensorM, points->angles};
    else
        head.geometry = scan.geometry;
    head.unitMm = scan.unitMm;
    head.noReturnCodes = scan.noReturnCodes;
    head.statusCodes = scan.statusCodes;
    return head;
}

nlohmann::ordered_json descriptionJson(const Scan& scan, const std::string& dataFile) {
    nlohmann::ordered_json object;
    object["format"] = kFormat;
    if (!dataFile.empty()) object["data"] = dataFile;
    object["lines"] = scan.lines();
    object["beams"] = scan.beams();
    object["unit_mm"] = scan.unitMm;
    object["no_return"] = scan.noReturnCodes;
    object["status_codes"] = scan.statusCodes;
    const auto* points = std::get_if<PointGeometry>(&scan.geometry);
    const PolarGeometry* polar = points == nullptr ? &std::get<PolarGeometry>(scan.geometry) : points->angles ? &*points->angles : nullptr;
    if (polar != nullptr) {
        object["beam_deg"] = angleJson(polar->beamDeg);
        object["line_deg"] = angleJson(polar->lineDeg);
        object["axis"] = polar->axis == Axis::Spin ? "spin" : "sweep";
        if (polar->lineDirection < 0) object["line_direction"] = -1;
        if (!polar->lineSkewDeg.empty()) object["line_skew_deg"] = angleJson(polar->lineSkewDeg);
    }
    if (points != nullptr) object["sensor_m"] = {points->sensorM.x(), points->sensorM.y(), points->sensorM.z()};
    if (scan.placement) object["placement"] = placementToJson(*scan.placement);
    if (scan.acquisition) {
        if (auto acquisition = acquisitionToJson(*scan.acquisition); !acquisition.empty()) object["acquisition"] = std::move(acquisition);
    }
    for (const StateRun& run : stateRunsOf(scan)) object["state_runs"].push_back({cellStateName(run.state), run.firstCell, run.cells});
    if (!scan.note.empty()) object["note"] = scan.note;
    return object;
}

std::string descriptionText(const Scan& scan, const std::string& dataFile, int indent) {
    return jsonText(descriptionJson(scan, dataFile), indent);
}

namespace {

// Whether ranges alone do not express it.
bool needsStateRun(CellState state) { return state == CellState::Lost || state == CellState::Masked || state == CellState::OutOfWindow; }

constexpr std::size_t kBlock = 256; // cells; in most blocks the ranges alone say every state

bool needsAnyStateRun(const CellState* states) {
    static_assert(static_cast<int>(CellState::Valid) == 0 && sizeof(CellState) == 1);
    std::array<std::uint64_t, kBlock / 8> eights;
    std::memcpy(eights.data(), states, kBlock);
    std::uint64_t other = 0;
    for (const std::uint64_t eight : eights) other |= eight;
    return other != 0 && std::any_of(states, states + kBlock, needsStateRun);
}

} // namespace

std::vector<StateRun> stateRunsOf(const Scan& scan) {
    std::vector<StateRun> runs;
    const std::vector<CellState>& states = scan.state.cells;
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (k % kBlock == 0 && k + kBlock <= states.size() && !needsAnyStateRun(states.data() + k)) {
            k += kBlock - 1;
            continue;
        }
        const CellState state = states[k];
        if (!needsStateRun(state)) continue;
        const bool continues = !runs.empty() && runs.back().state == state && runs.back().firstCell + runs.back().cells == k;
        if (continues)
            ++runs.back().cells;
        else
            runs.push_back({state, k, 1});
    }
    return runs;
}

std::optional<CellState> cellStateNamed(std::string_view name) {
    for (int i = 0; i < kCellStates; ++i) {
        if (name == cellStateName(static_cast<CellState>(i))) return static_cast<CellState>(i);
    }
    return std::nullopt;
}

} // namespace edgescan::files
