// Any bytes as a preset file, and as the settings of the viewer's window: settings that can be used and written and read back, or an error
// sentence.
#include "core/base/bounded_json.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "tests/fuzz/text_file.h"

#include <nlohmann/json.hpp>

using namespace edgescan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text = fuzz::textOf(bytes, size);
    if (const auto json = parseJson(text, "fuzz", kSettingsJson); json && json->is_object()) {
        const auto settings = edges::settingsFromJson(*json, edges::Settings{}, "fuzz");
        if (!settings && !settings.error().sentence().ends_with(".")) std::abort();
    }
    const auto preset = edges::findPreset(fuzz::TextFile(text).path());
    if (!preset) {
        if (!preset.error().sentence().ends_with(".")) std::abort();
        return 0;
    }
    if (!edges::checkSettings(preset->settings)) std::abort();
    const std::string once = edges::presetText(*preset);
    const auto again = edges::findPreset(fuzz::TextFile(once).path());
    if (!again || edges::presetText(*again) != once) std::abort();
    return 0;
}
