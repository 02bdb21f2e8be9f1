// Families of scenes: each a source, a kind, a grid and a noise. The scenes of a family are drawn, so that they are unknown beforehand.
#pragma once

#include "app/lab/families/made_scene.h"
#include "app/lab/sim/simulate.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::lab {

/// Where scenes come from besides the simulator. A file or folder that does not exist makes its families skipped.
struct FamilyPlaces {
    std::filesystem::path shared = "../shared"; ///< data of others
    std::filesystem::path surface{};            ///< cloud of the re-scans; empty: the boulders in `shared`
    std::filesystem::path kinect{};             ///< a folder of truth for each Kinect cloud; docs/measurements/kinect-truth makes them
    std::filesystem::path stones{};             ///< meshes of real stones; empty: those in `shared`
    std::string stoneSet = "lab";               ///< of app/lab/stones: those that judge, "lab", or those that may teach, "free"
    std::filesystem::path settled{};            ///< stones that already fell into place, to make scenes faster
};

/// What is measured on the scenes of a family.
enum class Measure : std::uint8_t {
    Edges,      ///< F against the truth
    FalseCells, ///< edge cells away from the truth
    Counts,     ///< edge cells of each class; the truth is unknown
};

/// A scene to make.
struct SceneOrder {
    std::string name;             ///< unique among all families and draws
    std::uint64_t seed = 0;       ///< of a fresh scene
    std::size_t variant = 0;      ///< of a fresh scene: index of Family::variants
    std::filesystem::path file{}; ///< of a stored scene; empty for a fresh one
    bool carved = false;          ///< of a fresh heap of stones: each has a surface of its own
    int view = 0;                 ///< of a fresh heap of stones: 1, 2, ...: from a moved scanner
};

struct Family;

/// False ends the work.
using GoOn = std::function<bool()>;

struct SceneSource {
    const char* name;
    /// Error: why no fresh scene of the family can be made here. Null: the source has stored scenes only.
    Result<Done> (*ready)(const Family&, const FamilyPlaces&);
    Result<MadeScene> (*make)(const Family&, const SceneOrder&, const FamilyPlaces&, const GoOn&);
    /// Stored scenes of the family, sorted. Null: the source has fresh scenes only.
    std::vector<std::filesystem::path> (*stored)(const Family&, const FamilyPlaces&);
    const char* without; ///< why there is no scene, if neither is there
};

/// One of the kinds of a fresh scene of a family, which take turns.
struct FamilyVariant {
    const char* name;
    std::function<void(sim::SimulationSettings&)> change;
};

struct Family {
    const char* name;
    const SceneSource* source;
    const char* kind; ///< for the simulator the name of a scene
    bool full = false;
    double noise = 1.0;
    Measure measure = Measure::Edges;
    std::size_t small = 0; ///< number of scenes in the small run
    std::vector<FamilyVariant> variants{};
};

/// Those with real stones first.
[[nodiscard]] std::span<const Family> families();

/// Whether a fresh scene can be scanned from several places.
[[nodiscard]] bool hasViews(const Family& family);

/// Null for an unknown name.
[[nodiscard]] const Family* findFamily(const std::string& name);

/// A seed that was not chosen: from a hash of the text, the family and the number of the scene; below 10^15.
[[nodiscard]] std::uint64_t drawnSeed(const std::string& draw, const std::string& family, std::size_t scene);

struct SceneDraw {
    std::string text;
    std::size_t fresh = 10; ///< fresh scenes per family
    bool small = false;     ///< few scenes for each change: stored ones where a family has any
};
/// The scenes of a family. Error: there are none here, with the reason.
[[nodiscard]] Result<std::vector<SceneOrder>> drawnScenes(const Family& family, const SceneDraw& draw, const FamilyPlaces& places);

/// Error: as its source, or "stopped".
[[nodiscard]] Result<MadeScene> makeScene(const Family& family, const SceneOrder& order, const FamilyPlaces& places, const GoOn& goOn);

} // namespace edgescan::lab
