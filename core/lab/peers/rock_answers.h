// Ways from one scan to rocks, side by side: the recipe, a simple watershed on edges, and PCL's segmentations.
#pragma once

#include "core/edges/settings/settings.h"
#include "core/lab/peers/peers.h"
#include "core/lab/score/rock_evaluation.h"
#include "core/rocks/selection/rock_settings.h"

#include <memory>
#include <span>

namespace edgescan {

/// What the ways that are ours are set to; PCL's have their own parameters.
struct RockChoices {
    Settings edges; ///< its method is EdgeScan+ or a part of it
    RockSettings rocks;
};

struct RockWay {
    const char* key;  ///< in JSON
    const char* name; ///< in tables
    bool peer;        ///< only where peers are asked for
    RockAnswer (*find)(const std::shared_ptr<const Scan>& scan, const RockChoices& choices);
};
[[nodiscard]] std::span<const RockWay> rockWays();

} // namespace edgescan
