// Reading the JSON description: every key is checked, because it may come from anywhere.
#include "core/points/description.h"

#include "core/base/number_text.h"
#include "core/georef/placement_json.h"
#include "core/points/acquisition_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace edgescan {
namespace {

using PlainJson = nlohmann::json;

constexpr std::size_t kLargestJson = 64U << 20U; // angles of a million lines need 20 MB
constexpr int kDeepest = 16;
constexpr double kMostCells = 1 << 30; // along one side
const char* const kSeeFormat = "compare it with docs/formats.md, \"Raw grid\"";

/// nlohmann's parser survives any depth, but what it builds is as deep as the file says.
bool nestedDeeperThan(std::string_view json, int limit) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else
                inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > limit) return true;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return false;
}

/// Reads one object key by key; the first thing wrong is kept and stops the rest.
class Keys {
public:
    Keys(const PlainJson& object, std::string where) : object_(&object), where_(std::move(where)) {}

    [[nodiscard]] bool has(const char* key) const { return object_->contains(key) && !(*object_)[key].is_null(); }
    [[nodiscard]] const PlainJson& at(const char* key) const { return (*object_)[key]; }
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }
    void refuse(const std::string& key, const std::string& what) {
        if (!problem_) problem_ = Error{"\"" + key + "\" " + what, where_, kSeeFormat};
    }

    double number(const char* key, double missing) {
        if (!has(key)) return missing;
        return finite(at(key), key).value_or(missing);
    }
    std::uint64_t wholeNumber(const char* key, double least, double most) {
        if (!has(key)) return refuse(key, "is missing"), 0;
        const auto value = finite(at(key), key);
        if (!value) return 0;
        if (*value != std::floor(*value) || *value < least || *value > most) {
            return refuse(key, "must be a whole number from " + shortestText(least) + " to " + shortestText(most)), 0;
        }
        return static_cast<std::uint64_t>(*value);
    }
    std::string word(const char* key) {
        if (!has(key)) return {};
        if (!at(key).is_string()) return refuse(key, "must be text"), std::string();
        return at(key).get<std::string>();
    }
    std::vector<std::uint32_t> codes(const char* key, std::vector<std::uint32_t> missing) {
        if (!has(key)) return missing;
        std::vector<std::uint32_t> list;
        for (const double value : numbers(at(key), key)) {
            if (value < 0 || value > 4294967295.0 || value != std::floor(value)) return refuse(key, "must hold counts"), missing;
            list.push_back(static_cast<std::uint32_t>(value));
        }
        return list;
    }
    std::optional<AngleList> angles(const char* key, std::uint64_t count) {
        if (!has(key)) return std::nullopt;
        const PlainJson& value = at(key);
        if (value.is_object()) {
            if (!value.contains("start") || !value.contains("step")) return refuse(key, "needs start and step"), std::nullopt;
            const auto start = finite(value["start"], key);
            const auto step = finite(value["step"], key);
            if (!start || !step) return std::nullopt;
            return AngleSteps{*start, *step};
        }
        auto list = numbers(value, key);
        if (!problem_ && list.size() != count) {
            refuse(key, "holds " + std::to_string(list.size()) + " angles, " + std::to_string(count) + " are needed");
        }
        return AngleList{std::move(list)};
    }
    std::vector<double> numbers(const PlainJson& value, const char* key) {
        std::vector<double> list;
        if (!value.is_array()) return refuse(key, "must be a list of numbers"), list;
        list.reserve(value.size());
        for (const PlainJson& item : value) {
            const auto number = finite(item, key);
            if (!number) break;
            list.push_back(*number);
        }
        return list;
    }

private:
    std::optional<double> finite(const PlainJson& value, const char* key) {
        if (!value.is_number()) return refuse(key, "must hold numbers, not " + std::string(value.type_name())), std::nullopt;
        const auto number = value.get<double>();
        if (!std::isfinite(number) || std::abs(number) > 1e12) return refuse(key, "holds a number out of all reason"), std::nullopt;
        return number;
    }

    const PlainJson* object_;
    std::string where_;
    std::optional<Error> problem_;
};

void readAxis(Keys& keys, GridDescription& grid) {
    const std::string axis = keys.word("axis");
    if (axis == "spin")
        grid.axis = Axis::Spin;
    else if (axis == "sweep")
        grid.axis = Axis::Sweep;
    else if (!axis.empty())
        keys.refuse("axis", "must be \"spin\" or \"sweep\"");
    grid.lineDirection = keys.number("line_direction", 1.0);
    if (std::abs(grid.lineDirection) != 1.0) keys.refuse("line_direction", "must be 1 or -1");
    if (!keys.has("sensor_m")) return;
    const auto sensor = keys.numbers(keys.at("sensor_m"), "sensor_m");
    if (sensor.size() == 3)
        grid.sensorM = Eigen::Vector3d(sensor[0], sensor[1], sensor[2]);
    else
        keys.refuse("sensor_m", "must hold three numbers");
}

void readStateRuns(Keys& keys, GridDescription& grid) {
    if (!keys.has("state_runs")) return;
    const PlainJson& runs = keys.at("state_runs");
    if (!runs.is_array()) return keys.refuse("state_runs", "must be a list");
    const double cells = static_cast<double>(grid.lines) * static_cast<double>(grid.beams);
    for (const PlainJson& run : runs) {
        const bool shaped =
            run.is_array() && run.size() == 3 && run[0].is_string() && run[1].is_number_unsigned() && run[2].is_number_unsigned();
        const auto state = shaped ? cellStateNamed(run[0].get<std::string>()) : std::nullopt;
        if (!state) return keys.refuse("state_runs", "must hold [\"state\", first cell, cells]");
        const StateRun read{*state, run[1].get<std::uint64_t>(), run[2].get<std::uint64_t>()};
        if (static_cast<double>(read.firstCell) + static_cast<double>(read.cells) > cells)
            return keys.refuse("state_runs", "leaves the grid");
        grid.stateRuns.push_back(read);
    }
}

/// Where the scan stands; it must fit the grid.
Result<std::shared_ptr<const Placement>> readPlacement(const Keys& keys, const GridDescription& grid, const std::string& where) {
    if (!keys.has("placement")) return std::shared_ptr<const Placement>();
    return placementFromJson(keys.at("placement"), grid.lines, where);
}

void readDataFile(Keys& keys, GridDescription& grid) {
    if (!keys.has("data")) return;
    const std::string name = keys.word("data");
    const std::filesystem::path path(name);
    const bool leaves = std::any_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
    if (name.empty() || path.is_absolute() || leaves || name.find('\0') != std::string::npos) {
        return keys.refuse("data", "must name a file in the same folder");
    }
    grid.dataFile = name;
}

PlainJson angleJson(const std::vector<double>& degrees) {
    const AngleList list = shortestAngles(degrees);
    if (const auto* steps = std::get_if<AngleSteps>(&list)) return PlainJson{{"start", steps->startDeg}, {"step", steps->stepDeg}};
    return std::get<std::vector<double>>(list);
}

} // namespace

Result<GridDescription> parseDescription(std::string_view json, const std::string& where) {
    if (json.size() > kLargestJson) return Error{"a description of a grid is never this large", where, kSeeFormat};
    if (nestedDeeperThan(json, kDeepest)) return Error{"the JSON is nested too deep to describe a grid", where, kSeeFormat};
    PlainJson object;
    try {
        object = PlainJson::parse(json);
    } catch (const PlainJson::exception& problem) {
        const auto* syntax = dynamic_cast<const PlainJson::parse_error*>(&problem);
        const std::string place = syntax != nullptr ? where + ": byte " + std::to_string(syntax->byte) : where;
        return Error{"the JSON is damaged or cut off here", place, "copy the file again"};
    }
    if (!object.is_object()) return Error{"the JSON holds no object and so describes no grid", where, kSeeFormat};
    Keys keys(object, where);
    const std::string format = keys.word("format");
    if (format != "edgescan-raw-grid/1" && !keys.problem()) {
        return Error{format.empty() ? "this JSON does not describe a raw grid: \"format\" is missing"
                                    : "\"format\" is \"" + format.substr(0, 60) + "\", not \"edgescan-raw-grid/1\"",
                     where, kSeeFormat};
    }
    GridDescription grid;
    grid.lines = keys.wholeNumber("lines", 1, kMostCells);
    grid.beams = keys.wholeNumber("beams", 1, kMostCells);
    grid.unitMm = keys.number("unit_mm", 1.0);
    if (!(grid.unitMm > 0 && grid.unitMm <= 1e6)) keys.refuse("unit_mm", "must be greater than 0");
    grid.noReturnCodes = keys.codes("no_return", {0});
    grid.statusCodes = keys.codes("status_codes", {});
    grid.beamDeg = keys.angles("beam_deg", grid.beams);
    grid.lineDeg = keys.angles("line_deg", grid.lines);
    grid.lineSkewDeg = keys.angles("line_skew_deg", grid.beams);
    grid.note = keys.word("note");
    readDataFile(keys, grid);
    readAxis(keys, grid);
    readStateRuns(keys, grid);
    if (keys.problem()) return *keys.problem();
    auto placement = readPlacement(keys, grid, where);
    if (!placement) return placement.error();
    grid.placement = *placement;
    if (keys.has("acquisition")) {
        auto acquisition = acquisitionFromJson(keys.at("acquisition"), where);
        if (!acquisition) return acquisition.error();
        grid.acquisition = *acquisition;
    }
    return grid;
}

std::vector<double> anglesOf(const AngleList& list, std::uint64_t count) {
    if (const auto* given = std::get_if<std::vector<double>>(&list)) return *given;
    const auto& steps = std::get<AngleSteps>(list);
    std::vector<double> degrees(count);
    for (std::size_t i = 0; i < degrees.size(); ++i) degrees[i] = steps.startDeg + static_cast<double>(i) * steps.stepDeg;
    return degrees;
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

std::string descriptionText(const Scan& scan, const std::string& dataFile, int indent) {
    nlohmann::ordered_json object;
    object["format"] = "edgescan-raw-grid/1";
    if (!dataFile.empty()) object["data"] = dataFile;
    object["lines"] = scan.lines();
    object["beams"] = scan.beams();
    object["unit_mm"] = scan.unitMm;
    object["no_return"] = scan.noReturnCodes;
    object["status_codes"] = scan.statusCodes;
    if (const auto* polar = std::get_if<PolarGeometry>(&scan.geometry)) {
        object["beam_deg"] = angleJson(polar->beamDeg);
        object["line_deg"] = angleJson(polar->lineDeg);
        object["axis"] = polar->axis == Axis::Spin ? "spin" : "sweep";
        if (polar->lineDirection < 0) object["line_direction"] = -1;
        if (!polar->lineSkewDeg.empty()) object["line_skew_deg"] = angleJson(polar->lineSkewDeg);
    } else {
        const auto& sensor = std::get<PointGeometry>(scan.geometry).sensorM;
        object["sensor_m"] = {sensor.x(), sensor.y(), sensor.z()};
    }
    if (scan.placement) object["placement"] = placementToJson(*scan.placement);
    if (scan.acquisition) {
        if (auto acquisition = acquisitionToJson(*scan.acquisition); !acquisition.empty()) object["acquisition"] = std::move(acquisition);
    }
    for (const StateRun& run : stateRunsOf(scan)) object["state_runs"].push_back({cellStateName(run.state), run.firstCell, run.cells});
    if (!scan.note.empty()) object["note"] = scan.note;
    return object.dump(indent, ' ', false, PlainJson::error_handler_t::replace);
}

std::vector<StateRun> stateRunsOf(const Scan& scan) {
    std::vector<StateRun> runs;
    for (std::size_t k = 0; k < scan.state.size(); ++k) {
        const CellState state = scan.state[k];
        if (state != CellState::Lost && state != CellState::Masked && state != CellState::OutOfWindow) continue;
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

} // namespace edgescan
