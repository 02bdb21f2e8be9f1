// The figures of one method on one scene, in memory and as JSON.
#pragma once

#include "app/lab/families/made_scene.h"
#include "app/lab/score/score.h"
#include "core/edges/settings/settings.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::lab {

inline constexpr double kFamilyTolerance = 2.0; ///< cells

/// A method with its settings that runs on every scene.
struct Contestant {
    std::string name;
    std::string flags; ///< as typed
    /// null: PCL's OrganizedEdge on the un-rolled scan, which has the highest F of PCL's detectors
    std::optional<edges::Settings> settings;
};

/// Number of cells by DepthEdge; the first one: edge cells of a method without classes.
using CellsByClass = std::array<std::size_t, edges::kDepthEdges>;
/// Names of these classes.
inline constexpr std::array<const char*, edges::kDepthEdges> kCellClassNames{"unclassed", "jump",       "convex",  "concave",
                                                                             "border",    "silhouette", "void_rim"};

struct SceneScore {
    std::optional<EdgeScore> edges; ///< null without truth
    CellsByClass cells{};           ///< of the mask
    CellsByClass away{};            ///< of the thinned mask: scored cells farther than the tolerance from all true edges
    std::string note;               ///< why there is no result
};

/// A group of true edges that is reported.
struct ScoreGroup {
    const char* key;
    const char* name;
    EdgeCounts EdgeScore::*counts;
    bool judged; ///< by the protocol
};
inline constexpr std::array<ScoreGroup, 3> kScoreGroups{
    {{"all", "all edges", &EdgeScore::all, true},
     {"outline", "outline", &EdgeScore::outline, true},
     {"strict_outline", "outline, a crease is false", &EdgeScore::strictOutline, false}}};

[[nodiscard]] SceneScore sceneScore(const MadeScene& scene, const Contestant& contestant);

[[nodiscard]] nlohmann::ordered_json sceneScoreJson(const SceneScore& score);
/// The score as sceneScoreJson() wrote it; the F in it are not read. Error: not such an object; it names `where`.
[[nodiscard]] Result<SceneScore> sceneScoreFrom(const nlohmann::json& json, const std::string& where);

} // namespace edgescan::lab
