// Named settings: the built-in ones and those that people keep in files.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/settings.h"

#include <span>
#include <string>
#include <vector>

namespace edgescan::edges {

struct Preset {
    std::string name;
    std::string help; ///< one sentence
    Settings settings;
    std::string path; ///< empty for a built-in preset
};

/// Canny on gray levels, every other value as by default. What is read from files starts here: the first ones named no method.
[[nodiscard]] Settings cannySettings();

/// "default" first, then "log", "thesis" and "window" (docs/method.md, "Gray levels and presets").
[[nodiscard]] std::span<const Preset> builtInPresets();

/// Which default settings these are; the number rises when a default changes. docs/operator.md, "S19".
struct DefaultSet {
    const char* name;
    int version;
};
inline constexpr DefaultSet kDefaultSet{"default", 3};

/// Keys of the parameters that differ from the default settings and that the method of `settings` reads, in the table's order.
[[nodiscard]] std::vector<std::string> changedFromDefault(const Settings& settings);

/// A built-in preset's name, or the path of a preset file. Error: neither, or the file is not a preset.
[[nodiscard]] Result<Preset> findPreset(const std::string& nameOrPath);

/// The text of a preset file: {"format": "edgescan-preset/1", "name": ..., "settings": {...}}.
[[nodiscard]] std::string presetText(const Preset& preset);

} // namespace edgescan::edges
