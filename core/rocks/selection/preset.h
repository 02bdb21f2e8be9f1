// The settings of rocks and the user's edits for one scan, as a sidecar file (docs/method/rocks.md, "Edits").
#pragma once

#include "core/rocks/selection/edits.h"
#include "core/rocks/selection/rock_settings.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace edgescan::rocks {

struct Preset {
    std::optional<RockSettings> settings; ///< empty: edits only
    std::vector<Edit> edits;
    std::string sha256; ///< hash of the scan's file; empty: unknown

    bool operator==(const Preset&) const = default;
};

inline constexpr std::uint64_t kMostPresetBytes = std::uint64_t{64} << 20U; ///< of a file

/// mergedEdits(), and the settings of `mine` if it changed them. @param base what both began with
[[nodiscard]] Preset mergedPreset(const Preset& base, const Preset& mine, const Preset& theirs);

/// SCAN.EXT.rocks.json
[[nodiscard]] std::filesystem::path rockPresetPath(const std::filesystem::path& scan);

/// The edits (rockEditsToJson), with "settings" and "sha256" if they are known, as text of a file.
[[nodiscard]] std::string rockPresetText(const Preset& preset, int lines, int beams);

/// Reads the text of rockPresetText() or rockEditsToJson(). Error: those of rockEditsFromJson() and rockSettingsFromJson(), or the text
/// belongs to a file with a hash other than `sha256` (if both are known).
Result<Preset> rockPresetFromText(std::string_view text, int lines, int beams, const std::string& sha256, const std::string& where);
/// The same from a file.
Result<Preset> readRockPreset(const std::filesystem::path& path, const Scan& scan);

} // namespace edgescan::rocks
