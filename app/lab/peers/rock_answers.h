// Methods that find rocks in one scan, for comparison: EdgeScan's own, a simple watershed on edges, and PCL's segmentations.
#pragma once

#include "app/lab/peers/peers.h"
#include "app/lab/score/rock_evaluation.h"
#include "core/edges/settings/settings.h"
#include "core/rocks/selection/rock_settings.h"

#include <memory>
#include <span>

namespace edgescan::lab {

/// The settings of our own methods; PCL's have their own parameters.
struct RockMethodSettings {
    edges::Settings edges; ///< its method is EdgeScan+ or a part of it
    rocks::RockSettings rocks;
};

struct RockMethod {
    const char* key;  ///< key in JSON
    const char* name; ///< name in tables
    bool isPcl;       ///< runs only if PCL's methods are requested
    RockDetection (*find)(const std::shared_ptr<const Scan>& scan, const RockMethodSettings& choices);
};
[[nodiscard]] std::span<const RockMethod> rockMethods();

} // namespace edgescan::lab
