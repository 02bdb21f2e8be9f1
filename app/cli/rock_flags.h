// The flags for finding rocks, used by `rocks`, `report` and `batch`.
#pragma once

#include "app/shared/options.h"
#include "core/rocks/selection/preset.h"

#include <string>
#include <utility>
#include <vector>

namespace edgescan::cli {

struct RockFlags {
    std::vector<std::pair<const rocks::RockParameter*, double>> typed;
    std::string region, edits; ///< as typed
    std::vector<rocks::RegionCorner> corners;
};

/// Adds one flag per row of rockParameters(), --region, and --edits for commands with one scan.
void addRockFlags(CLI::App& command, RockFlags& flags, bool ofOneScan);

/// True if any of these flags is given.
[[nodiscard]] bool anyTyped(const RockFlags& flags);

/// Parses the region; from here on a file of edits is an input. Error: the region is invalid.
Result<Done> checkRocks(RockFlags& flags);

/// "--level 1 --region '0,0 9,9'", for a POSIX shell.
[[nodiscard]] std::string typedFlags(const RockFlags& flags);

/// Reads the file of edits. Typed settings override those of the file. The settings of the result are always present.
Result<rocks::Preset> presetOf(const RockFlags& flags, const Scan& scan);

} // namespace edgescan::cli
