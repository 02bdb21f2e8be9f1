// One row per text.
#include "core/files/point_tables/acquisition_json.h"

#include "core/base/json_fields.h"

#include <nlohmann/json.hpp>

#include <array>
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

} // namespace edgescan::files
