// nlohmann's dump(), without exceptions and without unprintable characters.
#include "core/base/json_text.h"

#include "core/base/foreign_text.h"

#include <nlohmann/json.hpp>

namespace edgescan {
namespace {

constexpr std::size_t kMostInReports = 4000;

void shorten(nlohmann::ordered_json& json) {
    if (json.is_structured()) {
        for (auto& item : json) shorten(item);
    } else if (json.is_string() && json.get_ref<const std::string&>().size() > kMostInReports) {
        json = printable(json.get_ref<const std::string&>(), kMostInReports);
    }
}

} // namespace

std::string jsonText(const nlohmann::json& json, int indent) {
    return printableJson(json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string jsonText(const nlohmann::ordered_json& json, int indent) {
    return printableJson(json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

std::string asciiJsonText(const nlohmann::ordered_json& json, int indent) {
    return printableJson(json.dump(indent, ' ', true, nlohmann::ordered_json::error_handler_t::replace));
}

std::string shortJsonText(nlohmann::ordered_json json, int indent) {
    shorten(json);
    return jsonText(json, indent);
}

} // namespace edgescan
