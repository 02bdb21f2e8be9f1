// One row per option.
#include "core/io/open_options_json.h"

#include "core/base/json_fields.h"

#include <array>

namespace edgescan {
namespace {

using Json = nlohmann::ordered_json;

struct NumberOption {
    const char* key;
    std::optional<double> OpenOptions::*member;
};
constexpr std::array<NumberOption, 6> kNumbers{{
    {"beam-start", &OpenOptions::beamStartDeg},
    {"beam-step", &OpenOptions::beamStepDeg},
    {"line-start", &OpenOptions::lineStartDeg},
    {"line-step", &OpenOptions::lineStepDeg},
    {"unit-mm", &OpenOptions::unitMm},
    {"grid-step", &OpenOptions::gridStepDeg},
}};

} // namespace

std::string openOptionsText(const OpenOptions& options) {
    Json object = Json::object();
    for (const NumberOption& number : kNumbers) {
        if (const auto& value = options.*number.member) object[number.key] = *value;
    }
    if (options.axis) object["axis"] = *options.axis == Axis::Spin ? "spin" : "sweep";
    if (const auto& s = options.sensorM) object["sensor"] = {s->x(), s->y(), s->z()};
    if (options.projection != Projection::Auto) object["project"] = options.projection == Projection::Always ? "always" : "never";
    if (options.straighten) object["straighten"] = true;
    if (options.scanIndex != 0) object["scan"] = options.scanIndex;
    return object.empty() ? std::string() : object.dump();
}

Result<OpenOptions> parseOpenOptions(const std::string& json, const std::string& where) {
    OpenOptions options;
    if (json.empty()) return options;
    const nlohmann::json object = nlohmann::json::parse(json, nullptr, false);
    if (!object.is_object()) return Error{"what the scan was opened with is damaged", where, "export again"};
    JsonFields fields(object, where, "verify with the version that made the export");
    for (const NumberOption& number : kNumbers) {
        if (fields.has(number.key)) options.*number.member = fields.number(number.key, 0.0);
    }
    if (fields.has("axis")) options.axis = fields.choice("axis", {"spin", "sweep"}) == 0 ? Axis::Spin : Axis::Sweep;
    if (fields.has("sensor")) options.sensorM = fields.neededVector("sensor");
    const std::size_t projection = fields.choice("project", {"auto", "always", "never"});
    options.projection = projection == 0 ? Projection::Auto : projection == 1 ? Projection::Always : Projection::Never;
    options.straighten = fields.boolean("straighten", false);
    options.scanIndex = static_cast<std::size_t>(fields.number("scan", 0, {0, 1e6}));
    fields.done();
    if (fields.problem()) return *fields.problem();
    return options;
}

} // namespace edgescan
