// Turns typed texts into settings and options.
#include "app/shared/typed_settings.h"

#include "core/base/inputs.h"
#include "core/base/shell_quoted.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <optional>

namespace edgescan::cli {
namespace {

const std::string kLower = "lower";

} // namespace

MethodFlags nothingTyped() {
    MethodFlags flags;
    for (const Parameter& p : parameters()) flags.typed[p.key] = kNotTyped;
    return flags;
}

bool anyTyped(const MethodFlags& flags) {
    if (!flags.preset.empty()) return true;
    return std::ranges::any_of(flags.typed, [](const auto& flag) { return flag.second != kNotTyped; });
}

std::string typedFlags(const MethodFlags& flags) {
    std::string text = flags.preset.empty() ? "" : "--preset " + shellQuoted(flags.preset);
    for (const Parameter& p : parameters()) {
        const std::string& value = flags.typed.at(p.key);
        if (value != kNotTyped) text += (text.empty() ? "--" : " --") + std::string(p.key) + " " + shellQuoted(value);
    }
    return text;
}

Result<Preset> presetOf(const MethodFlags& flags) {
    if (!flags.preset.empty()) return findPreset(flags.preset);
    // Gray-level flags without a method select Canny on gray levels: otherwise a typed threshold would have no effect.
    const bool gray = flags.typed.at("method") == kNotTyped && std::ranges::any_of(flags.typed, [](const auto& flag) {
                          const Parameter& parameter = *findParameter(flag.first);
                          return flag.second != kNotTyped && !parameter.usedBy(Settings{}) && parameter.usedBy(cannySettings());
                      });
    return findPreset(gray ? "log" : builtInPresets().front().name);
}

namespace {

// All settings that need no scan. A lower threshold typed as a depth is not converted here.
Result<Settings> settingsBut(const MethodFlags& flags) {
    const Result<Preset> preset = presetOf(flags);
    if (!preset) return preset.error();
    Settings settings = preset->settings;
    for (const auto& [key, text] : flags.typed) {
        if (text == kNotTyped) continue;
        if (key == kLower && typedStep(text)) continue;
        const Parameter& parameter = *findParameter(key);
        const Result<double> value = parseValue(parameter, text);
        if (!value) return value.error();
        parameter.set(settings, *value);
    }
    if (flags.typed.at(kLower) == kNotTyped) {
        Settings before = preset->settings;
        if (stepGain(before).straight <= 0) before = cannySettings();
        settings.lower = lowerWithSameStep(before, settings);
    }
    if (const auto checked = checkSettings(settings); !checked) return checked.error();
    // With a method or a preset every parameter may be typed. Without them a flag that has no effect is an error.
    const bool chosen = !flags.preset.empty() || flags.typed.at("method") != kNotTyped;
    for (const auto& [key, text] : flags.typed) {
        if (chosen || text == kNotTyped || findParameter(key)->usedBy(settings)) continue;
        const Parameter& method = *findParameter("method");
        return Error{"the method " + formatValue(method, method.get(settings)) + " takes no notice of this flag", "--" + key,
                     "leave it out, or name a --method or --preset that uses it"};
    }
    return settings;
}

} // namespace

Result<Settings> settingsOf(const MethodFlags& flags) {
    if (typedStep(flags.typed.at(kLower)))
        return Error{"a depth becomes a threshold only once there is a scan", "--lower", "give the threshold in gray levels here"};
    return settingsBut(flags);
}

Result<Done> checkMethod(const MethodFlags& flags) {
    claimInput(flags.preset); // if it is a file
    const Result<Settings> settings = settingsBut(flags);
    if (!settings) return settings.error();
    return Done{};
}

Result<Settings> settingsFor(const MethodFlags& flags, const Scan& scan) {
    Result<Settings> settings = settingsBut(flags);
    const auto step = typedStep(flags.typed.at(kLower));
    if (!settings || !step) return settings;
    const Result<double> lower = lowerOfStep(*step, *settings, grayScale(scan, *settings));
    if (!lower) return lower.error();
    settings->lower = *lower;
    return settings;
}

ExportOptions exportOptions(const WriteFlags& flags, CoordinateFrame usual) {
    ExportOptions options;
    options.frame = flags.frame == "scanner" ? CoordinateFrame::Scanner
                    : flags.frame == "local" ? CoordinateFrame::MineLocal
                    : flags.frame == "mine"  ? CoordinateFrame::Mine
                                             : usual;
    options.ascii = flags.ascii;
    options.includeAttached = flags.includeAttached;
    options.choices = flags.choices;
    options.operatorName = flags.operatorName;
    options.role = flags.role;
    return options;
}

} // namespace edgescan::cli
