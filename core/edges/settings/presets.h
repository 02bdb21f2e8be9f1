// Named settings: the built-in ones, and those in preset files.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/settings.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace edgescan::edges {

struct Preset {
    std::string name;
    std::string help; ///< one sentence
    Settings settings;
    std::string path; ///< empty for a built-in preset
    /// Keys of a file that a person wrote; empty: the program wrote it, with every setting.
    std::vector<std::string> keys = {};
};

/// Canny on gray levels with default values for all else. Values read from files start from these, because the first preset files named no
/// method.
[[nodiscard]] Settings cannySettings();

/// "default" first, then "log", "thesis", "window", "smooth-walls", "default-4" and "default-3" (docs/method/edges.md, "Gray levels and
/// presets").
[[nodiscard]] std::span<const Preset> builtInPresets();

/// Name and version of the default settings; the version increases if a default changes. docs/reference/rules.md, "S19".
struct DefaultSet {
    const char* name;
    int version;
};
inline constexpr DefaultSet kDefaultSet{"default", 5};

/// The default settings of a version. All versions before 4 give version 3, the first ones that are stored here.
[[nodiscard]] Settings defaultSettings(int version);

/// All settings as a record or a session of this version of the default set wrote them, in the words of today: every key, and "all" as the
/// classes of that time. Version 0: not stated, so the keys show which version it was.
[[nodiscard]] nlohmann::json settingsOfRecord(nlohmann::json settings, int version);

/// Keys of the parameters that differ from the defaults and that the method of `settings` reads, in the table's order.
[[nodiscard]] std::vector<std::string> changedFromDefault(const Settings& settings);

/// Finds a built-in preset by name, or reads a preset file by path. Error: neither exists, or the file is not a preset.
[[nodiscard]] Result<Preset> findPreset(const std::string& nameOrPath);

/// The text of a preset file: {"format": "edgescan-preset/1", "name": ..., "settings": {...}}.
[[nodiscard]] std::string presetText(const Preset& preset);

} // namespace edgescan::edges
