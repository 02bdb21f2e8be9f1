// Makes and reads the scenes of each source.
#include "app/lab/families/scene_sources.h"

#include "app/lab/families/stored_scene.h"
#include "app/lab/stones/stone_scene.h"
#include "core/files/open_save/cloud_points.h"
#include "core/files/open_save/open_scan.h"

#include <algorithm>
#include <string_view>

namespace edgescan::lab {
namespace {

namespace fs = std::filesystem;

/// Folders or files in a folder whose names begin and end in this way, sorted.
std::vector<fs::path> namesIn(const fs::path& folder, const std::string& begin, std::string_view end = {}) {
    std::vector<fs::path> found;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(begin) && name.ends_with(end)) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    return found;
}

// Heaps of real stones.
fs::path stonesOf(const FamilyPlaces& places) { return places.stones.empty() ? places.shared / "data/real_stones/stones" : places.stones; }
Result<Done> stonesReady(const Family&, const FamilyPlaces& places) {
    std::error_code failed;
    if (!fs::exists(stonesOf(places) / "rocks.json", failed))
        return Error{"the meshes of real stones are missing", stonesOf(places).string(), "name their folder with --stones"};
    if (!canSettle() && places.settled.empty())
        return Error{"this program cannot let stones fall", "Bullet", "install libbullet-dev and build again, or give --settled"};
    return Done{};
}
Result<MadeScene> stonesScene(const Family& family, const SceneOrder& order, const FamilyPlaces& places, const GoOn& goOn) {
    if (!order.file.empty()) return storedScene(order.file);
    const Result<Stones> stones = readStones(stonesOf(places), places.stoneSet, 1);
    if (!stones) return stones.error();
    StoneScene scene{.kind = family.kind,
                     .set = places.stoneSet,
                     .seed = order.seed,
                     .view = order.view,
                     .full = family.full,
                     .carved = order.carved,
                     .noise = family.noise,
                     .settled = places.settled};
    Result<StoneScan> made = stoneScan(scene, *stones, 1, [&goOn](double) { return !goOn || goOn(); });
    if (!made) return made.error();
    return MadeScene{std::make_shared<const Scan>(std::move(made->simulation.scan)), std::move(made->truth)};
}
std::vector<fs::path> storedStones(const Family& family, const FamilyPlaces& places) {
    if (family.full || family.noise != 1.0) return {};
    return namesIn(places.shared / "data/real_stones/scenes", std::string("real_") + family.kind + "_");
}

std::vector<fs::path> storedPolar(const Family&, const FamilyPlaces& places) {
    return namesIn(places.shared / "data/real_stones/scenes", "polar_");
}

// The simulator.
sim::SimulationSettings simulatedSettings(const Family& family, const SceneOrder& order) {
    sim::SimulationSettings settings;
    settings.scene = family.kind;
    settings.seed = order.seed;
    settings.lines = family.full ? 1000 : 500;
    settings.beams = family.full ? 1141 : 571;
    settings.noise = family.noise;
    settings.truth = true;
    settings.threads = 1; // scenes are made at the same time
    if (!family.variants.empty()) family.variants[order.variant].change(settings);
    return settings;
}
Result<MadeScene> simulatedBy(const sim::SimulationSettings& settings, const GoOn& goOn) {
    Result<sim::Simulation> made = sim::simulate(settings, [&goOn](double) { return !goOn || goOn(); });
    if (!made) return made.error();
    sim::TruthSet truth = sim::truthSetOf(*made);
    return MadeScene{std::make_shared<const Scan>(std::move(made->scan)), std::move(truth)};
}
Result<Done> simulatorReady(const Family&, const FamilyPlaces&) { return Done{}; }
Result<MadeScene> simulatedScene(const Family& family, const SceneOrder& order, const FamilyPlaces&, const GoOn& goOn) {
    return simulatedBy(simulatedSettings(family, order), goOn);
}

// Re-scans of a measured surface.
fs::path surfaceOf(const FamilyPlaces& places) {
    return places.surface.empty() ? places.shared / "data/otira_rocks/Otira_1cm_grains.ply" : places.surface;
}
Result<Done> surfaceReady(const Family&, const FamilyPlaces& places) {
    std::error_code failed;
    if (fs::exists(surfaceOf(places), failed)) return Done{};
    return Error{"the cloud of the re-scans is missing", surfaceOf(places).string(), "name one with --surface"};
}
Result<MadeScene> rescannedScene(const Family& family, const SceneOrder& order, const FamilyPlaces& places, const GoOn& goOn) {
    auto points = files::cloudPoints(surfaceOf(places));
    if (!points) return points.error();
    sim::SimulationSettings settings = simulatedSettings(family, order);
    settings.surface = std::move(*points);
    return simulatedBy(settings, goOn);
}

// Labelled Kinect clouds: the folder of the truth has the name of the cloud.
Result<MadeScene> kinectScene(const Family&, const SceneOrder& order, const FamilyPlaces& places, const GoOn&) {
    Result<Scan> scan = files::openScan(places.shared / "data/mosd_kinect" / (order.file.filename().string() + ".pcd"));
    if (!scan) return scan.error();
    Result<sim::TruthSet> truth = sim::readTruth(order.file);
    if (!truth) return truth.error();
    return MadeScene{std::make_shared<const Scan>(std::move(*scan)), std::move(*truth)};
}
std::vector<fs::path> storedKinect(const Family&, const FamilyPlaces& places) {
    return places.kinect.empty() ? std::vector<fs::path>() : namesIn(places.kinect, "test");
}

Result<MadeScene> corridorScene(const Family&, const SceneOrder& order, const FamilyPlaces&, const GoOn&) {
    Result<Scan> scan = files::openScan(order.file);
    if (!scan) return scan.error();
    return MadeScene{std::make_shared<const Scan>(std::move(*scan)), std::nullopt};
}
std::vector<fs::path> storedCorridors(const Family&, const FamilyPlaces& places) {
    return namesIn(places.shared / "data/lms200_corridor", "scan", ".json");
}

Result<MadeScene> polarScene(const Family&, const SceneOrder& order, const FamilyPlaces&, const GoOn&) { return storedScene(order.file); }

} // namespace

const SceneSource kRealStones{"real stones", stonesReady, stonesScene, storedStones, "no scene of real stones of this kind is stored"};
const SceneSource kPolar{"real rocks where they lay", nullptr, polarScene, storedPolar, "no such scene is stored"};
const SceneSource kRescans{"re-scans of boulders", surfaceReady, rescannedScene, nullptr, ""};
const SceneSource kSimulator{"simulator", simulatorReady, simulatedScene, nullptr, ""};
const SceneSource kKinect{"Kinect", nullptr, kinectScene, storedKinect,
                          "the truth of the Kinect clouds is missing (docs/measurements/kinect-truth makes it for --kinect)"};
const SceneSource kCorridors{"corridors", nullptr, corridorScene, storedCorridors, "the scans of a corridor are missing"};

} // namespace edgescan::lab
