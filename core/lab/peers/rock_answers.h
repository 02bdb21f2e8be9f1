// Methods that find rocks in one scan, for comparison: EdgeScan's own, a simple watershed on edges, and PCL's segmentations.
#pragma once

#include "core/edges/settings/settings.h"
#include "core/lab/peers/peers.h"
#include "core/lab/score/rock_evaluation.h"
#include "core/rocks/selection/rock_settings.h"

#include <memory>
#include <span>

namespace edgescan {

/// The settings of our own methods; PCL's have their own parameters.
struct RockChoices {
    Settings edges; ///< its method is EdgeScan+ or a part of it
    RockSettings rocks;
};

struct RockWay {
    const char* key;  ///< key in JSON
    const char* name; ///< name in tables
    bool peer;        ///< runs only if PCL's methods are requested
    RockAnswer (*find)(const std::shared_ptr<const Scan>& scan, const RockChoices& choices);
};
[[nodiscard]] std::span<const RockWay> rockWays();

} // namespace edgescan
