// Named settings.
#include "core/edges/settings/presets.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/whole_file.h"
#include "core/edges/settings/parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace edgescan::edges {
namespace {

constexpr const char* kFormat = "edgescan-preset/1";

// As in the thesis: lower 10, holes and dust are processed like other cells.
Settings withoutMask(Scaling scaling) {
    Settings settings = cannySettings();
    settings.scaling = scaling;
    settings.maskMissing = false;
    settings.maskIsolated = false;
    settings.lower = 10.0;
    return settings;
}

Settings smoothWalls() {
    Settings settings;
    settings.growthPercent = 0.3;
    return settings;
}

} // namespace

Settings defaultSettings(int version) {
    Settings settings;
    if (version >= 5) return settings;
    settings.rules = 4;
    if (version == 4) return settings;
    settings.classes = kClassRock;
    settings.minimumLength = 5;
    settings.roughScans = false;
    settings.turns = false;
    return settings;
}

nlohmann::json settingsOfRecord(nlohmann::json settings, int version) {
    if (!settings.is_object()) return settings;
    if (version == 0) version = settings.contains("rules") ? kDefaultSet.version : settings.contains("rough-scans") ? 4 : 3;
    constexpr int kAllBefore4 = kClassRock | kClassBorder;
    if (version < 4 && settings.value("classes", nlohmann::json()) == "all")
        settings["classes"] = formatValue(*findParameter("classes"), kAllBefore4);
    const nlohmann::json usual = settingsToJson(defaultSettings(version));
    for (const auto& [key, value] : usual.items()) {
        if (!settings.contains(key)) settings[key] = value;
    }
    return settings;
}

Settings cannySettings() {
    Settings settings;
    settings.method = Method::Canny;
    return settings;
}

std::span<const Preset> builtInPresets() {
    static const std::vector<Preset> presets{
        {"default",
         "EdgeScan+: jumps in depth and folds of the surface, with thresholds that follow the noise of the scan.",
         Settings{},
         {}},
        {"log",
         "Canny on logarithmic gray levels, so that a step counts in percent of its range; missing data masked, so that a hole has no "
         "edge.",
         cannySettings(),
         {}},
        {"thesis", "The thesis to the letter: 255 / (Smax - Smin), 3x3 Gaussian, 1:3, holes are black.", withoutMask(Scaling::Thesis), {}},
        {"window", "As the thesis, but the gray levels run from the nearest to the farthest range.", withoutMask(Scaling::Window), {}},
        {"smooth-walls", "As default, for flat and quiet surfaces: low steps are edges far away too.", smoothWalls(), {}},
        {"default-4",
         "The default settings of version 4: the noise includes relief, rims end where a surface slants by 70 degrees, and on a scan of "
         "rough surfaces folds must exceed their surroundings.",
         defaultSettings(4),
         {}},
        {"default-3",
         "The default settings of version 3: no rims of open voids, chains of five cells and more, rough scans and turns of the stepper as "
         "any other.",
         defaultSettings(3),
         {}},
    };
    return presets;
}

std::vector<std::string> changedFromDefault(const Settings& settings) {
    std::vector<std::string> keys;
    for (const Parameter& p : parameters()) {
        if (p.usedBy(settings) && formatValue(p, p.get(settings)) != formatValue(p, p.get(Settings{}))) keys.emplace_back(p.key);
    }
    return keys;
}

Result<Preset> findPreset(const std::string& nameOrPath) {
    std::string names;
    for (const Preset& preset : builtInPresets()) {
        if (preset.name == nameOrPath) return preset;
        names += preset.name + ", ";
    }
    const std::filesystem::path path(nameOrPath);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        return Error{"there is no such preset and no such file", nameOrPath, "use " + names + "or the path of a preset file"};
    }
    const auto bytes = readWholeFile(path, kSettingsJson.bytes);
    if (!bytes) return bytes.error();
    const auto json = parseJson(textOf(*bytes), nameOrPath, kSettingsJson);
    if (!json) return json.error();
    if (!json->is_object() || json->value("format", nlohmann::json()) != kFormat)
        return Error{std::string("this is not a preset: it has no \"format\": \"") + kFormat + "\"", nameOrPath,
                     "save one from the viewer"};
    for (const auto& [key, value] : json->items()) {
        if (key != "format" && key != "name" && key != "settings")
            return Error{"a preset has no key \"" + key + "\"", nameOrPath, "put settings into \"settings\", and leave other keys out"};
    }
    if (!json->contains("settings") || (*json)["settings"].empty())
        return Error{"the preset has no \"settings\"", nameOrPath, "add this key with a setting, or save one from the viewer"};
    Result<Settings> settings = settingsFromJson((*json)["settings"], cannySettings(), nameOrPath);
    if (!settings) return settings.error();
    // Files of version 1.0 hold every setting of that time: they keep its masks.
    if (const nlohmann::json& all = (*json)["settings"]; all.contains("rough-scans") && !all.contains("rules")) settings->rules = 4;
    if (const auto checked = checkSettings(*settings); !checked) return checked.error();
    const nlohmann::json name = json->value("name", nlohmann::json());
    Preset preset{name.is_string() ? name.get<std::string>() : path.stem().string(), "From " + nameOrPath, *settings, nameOrPath};
    const bool isByHand = (*json)["settings"].size() < parameters().size() / 2;
    for (const auto& [key, value] : (*json)["settings"].items()) {
        if (isByHand) preset.keys.push_back(key);
    }
    return preset;
}

std::string presetText(const Preset& preset) {
    const nlohmann::json json{{"format", kFormat}, {"name", preset.name}, {"settings", settingsToJson(preset.settings)}};
    return jsonText(json, 2) + "\n";
}

} // namespace edgescan::edges
