// nlohmann's dump(), without exceptions and without unprintable characters.
#include "core/base/json_text.h"

#include "core/base/foreign_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

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

bool isAscii(const std::string& text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

template <class Json>
bool needsNoEscape(const Json& json) {
    if (json.is_string()) return isAscii(json.template get_ref<const std::string&>());
    if (json.is_object())
        return std::ranges::all_of(json.items(), [](const auto& item) { return isAscii(item.key()) && needsNoEscape(item.value()); });
    return !json.is_array() || std::ranges::all_of(json, needsNoEscape<Json>);
}

template <class Json>
Json escaped(const Json& json) {
    if (json.is_string()) return escapedBytes(json.template get_ref<const std::string&>());
    if (json.is_array()) {
        Json list = Json::array();
        for (const Json& item : json) list.push_back(escaped(item));
        return list;
    }
    if (!json.is_object()) return json;
    Json object = Json::object();
    for (const auto& [key, value] : json.items()) object[escapedBytes(key)] = escaped(value);
    return object;
}

template <class Json>
std::string textOf(const Json& json, int indent, bool ascii) {
    if (!needsNoEscape(json)) return printableJson(escaped(json).dump(indent, ' ', ascii));
    return printableJson(json.dump(indent, ' ', ascii));
}

} // namespace

std::string jsonText(const nlohmann::json& json, int indent) { return textOf(json, indent, false); }

std::string jsonText(const nlohmann::ordered_json& json, int indent) { return textOf(json, indent, false); }

std::string asciiJsonText(const nlohmann::ordered_json& json, int indent) { return textOf(json, indent, true); }

std::string shortJsonText(nlohmann::ordered_json json, int indent) {
    shorten(json);
    return jsonText(json, indent);
}

} // namespace edgescan
