// Settings and edits of one scan as JSON.
#include "core/rocks/selection/preset.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/whole_file.h"

#include <nlohmann/json.hpp>

namespace edgescan::rocks {

Preset mergedPreset(const Preset& base, const Preset& mine, const Preset& theirs) {
    const bool mineCounts = mine.settings != base.settings || !theirs.settings;
    return {mineCounts ? mine.settings : theirs.settings, mergedEdits(base.edits, mine.edits, theirs.edits), mine.sha256};
}

std::filesystem::path rockPresetPath(const std::filesystem::path& scan) { return scan.string() + ".rocks.json"; }

std::string rockPresetText(const Preset& preset, int lines, int beams) {
    nlohmann::ordered_json object = rockEditsToJson(preset.edits, lines, beams);
    if (!preset.sha256.empty()) object["sha256"] = preset.sha256;
    if (preset.settings) object["settings"] = rockSettingsToJson(*preset.settings);
    return jsonText(object, 1) + "\n";
}

Result<Preset> rockPresetFromText(std::string_view text, int lines, int beams, const std::string& sha256, const std::string& where) {
    auto object = parseJson(text, where);
    if (!object) return object.error();
    Preset preset;
    if (object->is_object() && object->contains("settings")) {
        const auto settings = rockSettingsFromJson((*object)["settings"], where);
        if (!settings) return settings.error();
        preset.settings = *settings;
        object->erase("settings");
    }
    if (object->is_object() && object->contains("sha256")) {
        const nlohmann::json& hash = (*object)["sha256"];
        if (!hash.is_string()) return Error{"\"sha256\" is not a text", where, "give edits that were made on this scan"};
        preset.sha256 = hash.get<std::string>();
        if (!sha256.empty() && preset.sha256 != sha256)
            return Error{"these edits were made on a file of other content", where, "give those of this scan, or move the file away"};
        object->erase("sha256");
    }
    auto edits = rockEditsFromJson(*object, lines, beams, where);
    if (!edits) return edits.error();
    preset.edits = std::move(*edits);
    return preset;
}

Result<Preset> readRockPreset(const std::filesystem::path& path, const Scan& scan) {
    const auto bytes = readWholeFile(path, kMostPresetBytes);
    if (!bytes) return bytes.error();
    return rockPresetFromText(textOf(*bytes), scan.lines(), scan.beams(), scan.sha256, path.string());
}

} // namespace edgescan::rocks
