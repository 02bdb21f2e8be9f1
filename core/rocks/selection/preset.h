// What a person turned and changed on one scan, as a file beside it: settings of rocks and edits by hand (docs/rocks-method.md, "Edits").
#pragma once

#include "core/rocks/selection/edits.h"
#include "core/rocks/selection/rock_settings.h"

#include <filesystem>
#include <optional>
#include <string>

namespace edgescan {

struct RockPreset {
    std::optional<RockSettings> settings; ///< empty: edits alone
    std::vector<RockEdit> edits;
    std::string sha256; ///< of the scan's file; empty: not said
};

/// SCAN.EXT.rocks.json
[[nodiscard]] std::filesystem::path rockPresetPath(const std::filesystem::path& scan);

/// The edits (rockEditsToJson) with "settings" and "sha256" where they are known, as text of a file.
[[nodiscard]] std::string rockPresetText(const RockPreset& preset, int lines, int beams);

/// Reads what rockPresetText() or rockEditsToJson() wrote. Error: as of rockEditsFromJson() and rockSettingsFromJson(), or made on a file
/// with another hash than `sha256` where both are known.
Result<RockPreset> rockPresetFromText(std::string_view text, int lines, int beams, const std::string& sha256, const std::string& where);
/// The same from a file.
Result<RockPreset> readRockPreset(const std::filesystem::path& path, const Scan& scan);

} // namespace edgescan
