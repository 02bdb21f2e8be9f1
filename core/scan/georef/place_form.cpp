// Two tables of fields, and files made of texts.
#include "core/scan/georef/place_form.h"
#include "core/base/translated_text.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/survey_line.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <optional>

namespace edgescan {
namespace {

using Json = nlohmann::ordered_json;
using Kind = PlaceField::Kind;

constexpr const char* kForm = "form";
const std::vector<std::string> kNorths{"grid", "true"};

// clang-format off
const std::vector<PlaceField>& poseTable() {
    static const std::vector<PlaceField> rows{
        {"talin", "easting_m", "Easting E [m]", Kind::Number, nullptr},
        {"talin", "northing_m", "Northing N [m]", Kind::Number, nullptr},
        {"talin", "elevation_m", "RL, positive up [m]", Kind::Number, nullptr},
        {"talin", "heading_deg", "Heading, clockwise from north [degrees]", Kind::Number, nullptr},
        {"talin", "heading_ref", "North of the heading", Kind::Word, "grid", kNorths},
        {"inclinometer", "tilt_x_deg", "Tilt: pitch, nose up [degrees]", Kind::Number, "0"},
        {"inclinometer", "tilt_y_deg", "Tilt: roll, right side down [degrees]", Kind::Number, "0"},
        {"talin", "zone", "Zone or EPSG code", Kind::Text, ""},
        {"talin", "datum", "Datum", Kind::Text, ""},
        {"boom", "azimuth_deg", "Azimuth of the boom, positive to the left [degrees]", Kind::Number, "0"},
        {"talin", "pitch_deg", "Robot's pitch, nose up [degrees]", Kind::Number, "0"},
        {"talin", "roll_deg", "Robot's roll, right side down [degrees]", Kind::Number, "0"},
    };
    return rows;
}

const std::vector<PlaceField>& mountingTable() {
    static const std::vector<PlaceField> rows{
        {"", "robot", "Name of robot or scanner", Kind::Text, ""},
        {"talin", "boresight_rpy_deg", "Boresight: roll, pitch, yaw [degrees]", Kind::ThreeNumbers, "0, 0, 0"},
        {"talin", "in_robot_m", "Lever arm of TALIN in the robot: forward, left, up [m]", Kind::ThreeNumbers, "0, 0, 0"},
        {"boom", "head_in_robot_m", "Lever arm of the head in the robot: forward, left, up [m]", Kind::ThreeNumbers, "0, 0, 0"},
        {"boom", "pivot_in_robot_m", "Pivot of a boom in the robot, in place of the head [m]", Kind::ThreeNumbers, ""},
        {"boom", "arm_m", "From pivot to head [m]", Kind::ThreeNumbers, ""},
        {"boom", "azimuth_about", "The boom's azimuth turns about", Kind::Word, "vertical", {"vertical", "robot_z"}},
        {"inclinometer", "viewing", "The scanner looks", Kind::Word, "forward", {"forward", "up", "down", "rpy", "matrix"}},
        {"inclinometer", "rpy_deg", "Looking direction: roll, pitch, yaw [degrees]", Kind::ThreeNumbers, ""},
        {"inclinometer", "matrix", "Looking direction: nine numbers by rows", Kind::NineNumbers, ""},
        {"inclinometer", "offset_m", "Axis of the stepper from the inclinometer [m]", Kind::ThreeNumbers, "0, 0, 0"},
        {"inclinometer", "reads", "Tilt is given as", Kind::Word, "elevations", {"elevations", "pitch_roll"}},
        {"stepper", "mount_rpy_deg", "Scanner on the stepper: roll, pitch, yaw [degrees]", Kind::ThreeNumbers, "0, 0, 0"},
        {"stepper", "mount_m", "Scanner on the stepper: x, y, z [m]", Kind::ThreeNumbers, "0, 0, 0"},
        {"stepper", "axis", "Axis of the stepper", Kind::ThreeNumbers, "0, 0, 1"},
        {"stepper", "zero_deg", "Zero of the stepper [degrees]", Kind::Number, "0"},
        {"stepper", "direction", "Direction of the stepper, 1 or -1", Kind::Number, "1"},
        {"stepper", "step_deg", "Step from line to line [degrees]", Kind::Number, "0.18"},
        {"stepper", "mirror_index_deg", "Beam at the time stamp of a line [degrees]", Kind::Number, "-144"},
        {"grid", "convergence_deg", "Grid convergence [degrees]", Kind::Number, "0"},
        {"grid", "scale", "Scale of the grid", Kind::Number, "1"},
        {"limits", "tilt_change_deg", "Largest change of tilt during a sweep [degrees]", Kind::Number, "0.2"},
        {"limits", "pose_age_s", "Largest age of a pose [s]", Kind::Number, "0"},
    };
    return rows;
}
// clang-format on

std::size_t numbersOf(Kind kind) { return kind == Kind::NineNumbers ? 9 : kind == Kind::ThreeNumbers ? 3 : 1; }
bool isNumeric(Kind kind) { return kind != Kind::Word && kind != Kind::Text; }

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t\r\n");
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r\n") - from + 1);
}

/// The value of a text that is not empty. Null: not that many numbers.
Json valueOf(const PlaceField& field, std::string_view text) {
    if (!isNumeric(field.kind)) return std::string(text);
    const std::vector<double> numbers = typedNumbers(text, numbersOf(field.kind));
    if (numbers.empty()) return {};
    if (field.kind == Kind::Number) return numbers.front();
    if (field.kind == Kind::ThreeNumbers) return numbers;
    Json rows = Json::array();
    for (std::size_t row = 0; row < 3; ++row) rows.push_back({numbers[3 * row], numbers[3 * row + 1], numbers[3 * row + 2]});
    return rows;
}

std::string textOf(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number()) return shortestText(value.get<double>());
    std::string text;
    for (const Json& item : value) text += (text.empty() ? "" : ", ") + textOf(item);
    return text;
}

/// The object of a group; a list of readings gives way to one.
Json& groupIn(Json& file, const char* group) {
    if (*group == '\0') return file;
    Json& object = file[group];
    if (object.is_array()) object = object.empty() ? Json::object() : Json(object.front());
    if (!object.is_object()) object = Json::object();
    return object;
}

void put(Json& file, const PlaceField& field, std::string_view text) {
    text = trimmed(text);
    Json& group = groupIn(file, field.group);
    const Json value = text.empty() ? Json() : valueOf(field, text);
    // A pose file needs the numbers that a calibration may leave out.
    const bool usual = value.is_null() && field.usual != nullptr && (field.kind == Kind::Number || field.kind == Kind::Word);
    if (usual || !value.is_null())
        group[field.key] = usual ? valueOf(field, field.usual) : value;
    else
        group.erase(field.key);
}

Json begun(const std::string& base, const char* format) {
    Json file{{"format", format}};
    if (auto parsed = parseOrderedJson(base, kForm, kSettingsJson); !base.empty() && parsed && parsed->is_object())
        file = std::move(*parsed);
    return file;
}

Json mountingJson(const TypedFile& typed) {
    Json file = begun(typed.base, "edgescan-calibration/1");
    for (std::size_t n = 0; n < mountingTable().size(); ++n) put(file, mountingTable()[n], typed.texts[n]);
    return file;
}

Json poseJson(const TypedFile& typed) {
    Json file = begun(typed.base, "edgescan-pose/1");
    file.erase("calibration");
    for (std::size_t n = 0; n < poseTable().size(); ++n) put(file, poseTable()[n], typed.texts[n]);
    return file;
}

using Check = std::function<std::optional<Error>(const std::string& json)>;
std::optional<Error> poseError(const std::string& json) {
    const auto read = parsePoses(json, kForm);
    return read ? std::nullopt : std::optional(read.error());
}
std::optional<Error> mountingError(const std::string& json) {
    const auto read = parseCalibration(json, kForm);
    return read ? std::nullopt : std::optional(read.error());
}

/// The label without its unit and its list of axes.
std::string nameOf(const PlaceField& field) {
    const std::string label = field.label;
    return label.substr(0, label.find(field.kind == Kind::ThreeNumbers || field.kind == Kind::NineNumbers ? ": " : " ["));
}

/// "\"talin.easting_m\" is 1e+09 and must ..." with the label in place of the key.
std::string sentenceFor(const PlaceField& field, const Error& error) {
    const std::size_t end = error.what.find("\" ", 1);
    return error.what.starts_with('"') && end != error.what.npos ? nameOf(field) + error.what.substr(end + 1) + "." : error.what + ".";
}

bool isAbout(const PlaceField& field, const Error& error) {
    const std::string group = field.group;
    return error.what.starts_with("\"" + group + (group.empty() ? "" : ".") + field.key + "\" ");
}

/// A value that every file allows, in place of a wrong one: the other texts are checked as well.
Json soundValue(const PlaceField& field) {
    if (field.kind == Kind::NineNumbers) return valueOf(field, "1 0 0 0 1 0 0 0 1");
    const std::string usual = field.usual == nullptr ? "" : field.usual;
    return valueOf(field, !usual.empty() || !isNumeric(field.kind) ? usual : field.kind == Kind::Number ? "0" : "0 0 0");
}

/// The sentence about a text that is not a value at all; empty: it is one.
std::string unreadable(const PlaceField& field, const std::string& typed) {
    const std::string_view text = trimmed(typed);
    if (text.empty()) return field.usual == nullptr ? withValues("%1 is missing.", {nameOf(field)}) : "";
    if (!valueOf(field, text).is_null()) return "";
    const std::size_t count = numbersOf(field.kind);
    const char* refused = count == 1   ? "%1: \"%2\" is not a number."
                          : count == 3 ? "%1: \"%2\" is not three numbers."
                                       : "%1: \"%2\" is not nine numbers.";
    return withValues(refused, {nameOf(field), std::string(text)});
}

/// One sentence per wrong text. `other`: a fault of the file that no single text has.
PlaceTexts faultsOf(const std::vector<PlaceField>& fields, const TypedFile& typed, Json file, const Check& check, std::string& other) {
    PlaceTexts faults;
    const auto replace = [&](const PlaceField& field) { groupIn(file, field.group)[field.key] = soundValue(field); };
    for (std::size_t n = 0; n < fields.size(); ++n) {
        faults.push_back(unreadable(fields[n], typed.texts[n]));
        if (!faults.back().empty()) replace(fields[n]);
    }
    for (auto error = check(jsonText(file)); error; error = check(jsonText(file))) {
        const auto about = std::ranges::find_if(fields, [&](const PlaceField& field) { return isAbout(field, *error); });
        std::string* const fault = about == fields.end() ? nullptr : &faults[static_cast<std::size_t>(about - fields.begin())];
        if (fault == nullptr || !fault->empty()) {
            other = error->what + ".";
            return faults;
        }
        *fault = sentenceFor(*about, *error);
        replace(*about);
    }
    return faults;
}

bool areEmpty(const PlaceTexts& faults) {
    return std::ranges::all_of(faults, [](const std::string& fault) { return fault.empty(); });
}

} // namespace

std::span<const PlaceField> poseFields() { return poseTable(); }
std::span<const PlaceField> mountingFields() { return mountingTable(); }

Result<PlaceTexts> placeTexts(std::span<const PlaceField> fields, std::string_view json, const std::string& where) {
    auto file = parseOrderedJson(json, where);
    if (!file) return file.error();
    if (!file->is_object()) return Error{"the file must hold an object {...}", where, "choose a pose or calibration file"};
    PlaceTexts texts;
    for (const PlaceField& field : fields) {
        const Json& group = groupIn(*file, field.group);
        const auto value = group.find(field.key);
        texts.push_back(value == group.end() || value->is_null() || value->is_object() ? std::string() : textOf(*value));
    }
    return texts;
}

std::string calibrationInPose(std::string_view json) {
    const auto file = parseOrderedJson(json, kForm);
    return file && file->is_object() && file->contains("calibration") ? jsonText((*file)["calibration"], 2) : std::string();
}

PlaceTexts nominalMounting(Axis axis) {
    PlaceTexts texts;
    for (const PlaceField& field : mountingTable()) {
        const std::string key = field.key;
        texts.push_back(key == "reads"     ? "pitch_roll"
                        : key == "viewing" ? "up"
                        : key == "axis"    ? (axis == Axis::Spin ? "0, 0, 1" : "1, 0, 0")
                                           : "");
    }
    return texts;
}

TypedPlace typedPlace(const TypedFile& pose, const TypedFile& mounting) {
    TypedPlace typed;
    Json file = poseJson(pose);
    typed.poseFaults = faultsOf(poseTable(), pose, file, poseError, typed.fault);
    const Json calibration = mountingJson(mounting);
    typed.mountFaults = faultsOf(mountingTable(), mounting, calibration, mountingError, typed.fault);
    if (!typed.fault.empty() || !areEmpty(typed.poseFaults) || !areEmpty(typed.mountFaults)) return typed;
    file["calibration"] = calibration;
    const std::string text = jsonText(file, 2) + "\n";
    if (const auto error = poseError(text))
        typed.fault = error->what + ".";
    else
        typed.file = text;
    return typed;
}

Result<std::string> typedMounting(const TypedFile& mounting) {
    const Json file = mountingJson(mounting);
    std::string other;
    for (const std::string& fault : faultsOf(mountingTable(), mounting, file, mountingError, other)) {
        if (!fault.empty()) return Error{fault, "", ""};
    }
    if (!other.empty()) return Error{other, "", ""};
    return jsonText(file, 2) + "\n";
}

} // namespace edgescan
