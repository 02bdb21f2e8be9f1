// Makes the scenes of families, each once, and scores all contestants on each.
#pragma once

#include "app/lab/families/families.h"
#include "app/lab/families/scene_score.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace edgescan::lab {

struct ScoredScene {
    std::string name;
    std::uint64_t seed = 0;
    std::vector<SceneScore> scores; ///< by contestant
};

struct ScoredFamily {
    const Family* family = nullptr;
    std::string skipped; ///< why it has no scenes; one sentence
    std::vector<ScoredScene> scenes;
};

struct FamilyRunSettings {
    std::vector<const Family*> families;
    std::vector<Contestant> contestants;
    SceneDraw draw;
    FamilyPlaces places;
    int threads = 2;             ///< as many scenes are in memory at a time
    std::filesystem::path store; ///< folder of the scores of earlier runs; empty: they are not stored
    /// Called with the first scene of each family, from any thread.
    std::function<Result<Done>(const MadeScene& scene, const std::string& name)> showFirst;
    std::string program; ///< what else the scores depend on: part of their names in the store
};

/// Called from any thread, one at a time, when a scene is done; false stops.
using FamilyProgress = std::function<bool(const std::string& scene, std::size_t done, std::size_t total)>;

/// `goOn` may be called by several threads at a time. Error: a scene cannot be made or read, the store cannot be written, or "stopped";
/// what is in the store by then counts in the next run.
[[nodiscard]] Result<std::vector<ScoredFamily>> runFamilies(const FamilyRunSettings& settings, const GoOn& goOn = {},
                                                            const FamilyProgress& progress = {});

} // namespace edgescan::lab
