// Named settings: the built-in ones and those that people keep in files.
#pragma once

#include "core/base/result.h"
#include "core/settings/settings.h"

#include <span>
#include <string>

namespace edgescan {

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

/// A built-in preset's name, or the path of a preset file. Error: neither, or the file is not a preset.
[[nodiscard]] Result<Preset> findPreset(const std::string& nameOrPath);

/// The text of a preset file: {"format": "edgescan-preset/1", "name": ..., "settings": {...}}.
[[nodiscard]] std::string presetText(const Preset& preset);

} // namespace edgescan
