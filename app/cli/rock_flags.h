// The flags that say how rocks are found: of `rocks`, `report` and `batch`.
#pragma once

#include "app/shared/options.h"
#include "core/rocks/selection/preset.h"

#include <string>
#include <utility>
#include <vector>

namespace edgescan::cli {

struct RockFlags {
    std::vector<std::pair<const RockParameter*, double>> typed;
    std::string region, edits; ///< as typed
    std::vector<RegionCorner> corners;
};

/// One flag per row of rockParameters(), --region, and --edits where they are of one scan.
void addRockFlags(CLI::App& command, RockFlags& flags, bool ofOneScan);

/// Anything typed.
[[nodiscard]] bool anyTyped(const RockFlags& flags);

/// Reads the region; a file of edits is an input from here on. Error: a region that is none.
Result<Done> checkRocks(RockFlags& flags);

/// "--level 1 --region '0,0 9,9'", for a POSIX shell.
[[nodiscard]] std::string typedFlags(const RockFlags& flags);

/// What the file of edits says; of the settings what is typed goes before what the file has. They are never empty.
Result<RockPreset> presetOf(const RockFlags& flags, const Scan& scan);

} // namespace edgescan::cli
