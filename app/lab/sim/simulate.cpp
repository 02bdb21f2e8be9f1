// Simulates one sweep: checks the settings, builds the scene and scans it.
#include "app/lab/sim/simulate.h"

#include "app/lab/sim/random.h"
#include "app/lab/sim/scenes.h"
#include "app/lab/sim/sweep.h"
#include "app/lab/sim/wall_kinds.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <new>
#include <type_traits>

namespace edgescan::sim {
namespace {

using namespace sim;

constexpr double kFirstBeamDeg = -5.0;
constexpr double kFanDeg = 190.0;

constexpr std::array kNumbers{
    SimulationNumber{"lines", "", "", "Scan lines over the turn", 2, 100000, 0, 0, EDGESCAN_NUMBER(SimulationSettings, lines)},
    SimulationNumber{"beams", "", "", "Beams over -5 to 185 degrees", 3, 100000, 0, 0, EDGESCAN_NUMBER(SimulationSettings, beams)},
    SimulationNumber{"sweep-number", "", "", "Which of several sweeps of the same scene: other noise, dust and dropouts", 0, 1000000, 0, 0,
                     EDGESCAN_NUMBER(SimulationSettings, repeat)},
    SimulationNumber{"rock-count", "", "", "Boulders in the arch or pile", 0, 3000, 0, 0, EDGESCAN_NUMBER(SimulationSettings, rocks)},
    SimulationNumber{"rock-roughness", "", "", "Relief of the rocks, standard deviation [mm]", 0, 200, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, rockRoughnessMm)},
    SimulationNumber{"rock-rounding", "", "",
                     "Radius of the rocks' corners and ridges, as a share of the largest ball that fits in: 0 (broken) to 0.9 (worn)", 0,
                     0.9, 0, 3, EDGESCAN_NUMBER(SimulationSettings, rockRounding)},
    SimulationNumber{"rock-size", "", "", "Times the size of every rock; small ones need a larger rock-count to fill the same room", 0.1, 3,
                     0, 3, EDGESCAN_NUMBER(SimulationSettings, rockSize)},
    SimulationNumber{"rock-lumps", "", "", "Smooth lumps of the rocks in addition to their relief, standard deviation [mm]", 0, 100, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, rockLumpsMm)},
    SimulationNumber{"rock-lump-size", "", "",
                     "Lattice that the lumps are drawn on; from one to the next it is two to three times as far [m]", 0.02, 10, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, rockLumpM)},
    SimulationNumber{"wall-roughness", "", "",
                     "Relief of the wall, standard deviation [mm]; 30 in the bell and 0 in the scene wall unless given", 0, 200, 0, 3,
                     EDGESCAN_NUMBER_OF(SimulationSettings, wallRoughnessMmOf(s), wallRoughnessMm)},
    SimulationNumber{"absorbing-patches", "", "", "Round spots that send nothing back", 0, 1000, 0, 0,
                     EDGESCAN_NUMBER(SimulationSettings, absorbingPatches)},
    SimulationNumber{"distance", "", "", "Distance of wall, staircase or rescan [m]", 0.1, 100, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, distanceM)},
    SimulationNumber{"hole-size", "", "", "Their diameter or side [m]", 0, 100, 0, 3, EDGESCAN_NUMBER(SimulationSettings, holeM)},
    SimulationNumber{"hole-count", "", "", "How many: one is in the middle, several are spread as the seed says", 0, 400, 0, 0,
                     EDGESCAN_NUMBER(SimulationSettings, holes)},
    SimulationNumber{"surface-scale", "", "", "Times its size", 0.001, 1000, 0, 3, EDGESCAN_NUMBER(SimulationSettings, surfaceScale)},
    SimulationNumber{"noise", "", "", "Times the range noise of the device", 0, 100, 0, 3, EDGESCAN_NUMBER(SimulationSettings, noise)},
    SimulationNumber{"dropouts", "", "", "Share of cells lost at random, 0 to 1", 0, 1, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, dropouts)},
    SimulationNumber{"dust", "", "", "Share of cells with an echo from dust, 0 to 1", 0, 1, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, dust)},
    SimulationNumber{"range-step", "", "", "Ranges come in whole steps of this [mm]", 0.01, 1000, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, rangeStepMm)},
    SimulationNumber{"max-range", "", "", "Farthest range [m]", 1, 1000, 0, 3, EDGESCAN_NUMBER(SimulationSettings, maxRangeM)},
    SimulationNumber{"line-jitter", "", "", "Jitter of the line angle [degrees]", 0, 1, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, lineJitterDeg)},
    SimulationNumber{"interlace", "", "", "Line angle of odd beams minus that of even beams [degrees]", -5, 5, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, interlaceDeg)},
    SimulationNumber{"motor-skew", "", "", "How far the stepper moves on while the mirror sweeps the fan [degrees]", -5, 5, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, motorSkewDeg)},
    SimulationNumber{"slips", "", "", "Share of lines on which the stepper lags one step behind, 0 to 1", 0, 1, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, slips)},
    SimulationNumber{"turn", "", "", "How far the stepper turns [degrees]", 1, 720, 0, 3, EDGESCAN_NUMBER(SimulationSettings, turnDeg)},
    SimulationNumber{"mount-t1", "", "", "Lever arm of the scanner: along x of a spin, along y of a sweep [mm]", -500, 500, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, assembly.t1Mm())},
    SimulationNumber{"mount-t2", "", "", "Lever arm of the scanner: along y of a spin, along z of a sweep [mm]", -500, 500, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, assembly.t2Mm())},
    SimulationNumber{"mount-tilt", "", "", "Tilt of the fan against the axis: roll of a spin, yaw of a sweep [degrees]", -20, 20, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, assembly.tiltDeg())},
    SimulationNumber{"mount-index", "", "", "Error of the beam angle: pitch of the mount [degrees]", -20, 20, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, assembly.indexDeg())},
    SimulationNumber{"turn-error", "", "", "Error of the stepper's angle at 180 degrees [degrees]", -20, 20, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, assembly.turnDeg())},
    SimulationNumber{"zero-jump", "", "", "How far the stepper's zero moves at half of the turn [degrees]", -20, 20, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, zeroJumpDeg)},
    SimulationNumber{"status-codes", "", "", "Share of cells with a device status code instead of a range, 0 to 1", 0, 1, 0, 3,
                     EDGESCAN_NUMBER(SimulationSettings, statusCodes)},
    SimulationNumber{"threads", "", "", "0 = one per core; the result is the same", 0, 1024, 0, 0,
                     EDGESCAN_NUMBER(SimulationSettings, threads)},
};

/// "plain, rough": of the rows of a table.
std::string namesOf(const auto& table) {
    std::string names;
    for (const auto& row : table) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

std::optional<Error> refusal(const SimulationSettings& s) {
    for (const SimulationNumber& number : simulationNumbers()) {
        const double value = number.get(s);
        if (number.limits().hold(value)) continue;
        std::string name = number.key;
        std::ranges::replace(name, '-', ' ');
        return Error{name + " is " + shortestText(value), "simulate",
                     "use " + shortestText(number.minimum) + " to " + shortestText(number.maximum)};
    }
    if (s.truth && (s.assembly != AssemblyErrors{} || s.zeroJumpDeg != 0 || s.station != RigidTransform{}))
        return Error{"the truth is that of rays from the origin, which an assembly with errors and another station do not have", "simulate",
                     "leave the truth or the errors of the assembly out"};
    if (s.afterBlast && s.scene != "hangup")
        return Error{"there is nothing to blast in the scene \"" + s.scene + "\"", "simulate", "use the scene hangup"};
    const WallKind* wall = wallKindNamed(s.wallKind);
    if (wall == nullptr) return Error{"there is no kind of wall \"" + s.wallKind + "\"", "simulate", "use one of " + namesOf(wallKinds())};
    if (!wall->archFits && s.scene == "hangup")
        return Error{"there is no room for an arch of rocks in a " + s.wallKind, "simulate",
                     "use the scene empty or pile, or another kind of wall"};
    constexpr double kMostCells = 1e8;
    if (1.0 * s.lines * s.beams > kMostCells)
        return Error{"lines x beams is more than 100 million cells", "simulate", "use fewer lines or beams"};
    return std::nullopt;
}

Result<Scene> sceneOf(const SimulationSettings& settings) {
    const Rocks rocks{settings.rocks, settings.rockSize, settings.rockRounding};
    const WallKind& wall = *wallKindNamed(settings.wallKind);
    if (settings.scene == "hangup") return hangupScene(settings.seed, rocks, wall, settings.afterBlast);
    if (settings.scene == "pile") return pileScene(settings.seed, rocks, wall);
    if (settings.scene == "empty") return emptyScene(settings.seed, wall);
    if (settings.scene == "wall") return wallScene({settings.distanceM, settings.hole, settings.holes, settings.holeM}, settings.seed);
    if (settings.scene == "staircase") return staircaseScene(settings.distanceM);
    if (settings.scene == "rescan") {
        Eigen::AlignedBox3f box;
        for (const Eigen::Vector3f& p : settings.surface) box.extend(p);
        if (settings.surface.size() < 3 || !(box.sizes().head<2>().minCoeff() > 0))
            return Error{"the scene \"rescan\" has no surface to scan", "simulate", "give a cloud of points with --surface"};
        std::vector<Eigen::Vector3f> points = settings.surface;
        for (Eigen::Vector3f& p : points) p *= static_cast<float>(settings.surfaceScale);
        return rescanScene(points, settings.distanceM);
    }
    return Error{"there is no scene \"" + settings.scene + "\"", "simulate", "use one of " + namesOf(simulationScenes())};
}

PolarGeometry nominalGeometry(const SimulationSettings& s) {
    PolarGeometry polar;
    polar.axis = s.axis;
    for (int j = 0; j < s.beams; ++j) polar.beamDeg.push_back(kFirstBeamDeg + kFanDeg * j / (s.beams - 1));
    // A sweep is centred on the vertical; a spin may start at any angle, and starts at 0.
    const double first = s.axis == Axis::Sweep ? -s.turnDeg / 2.0 : 0.0;
    for (int i = 0; i < s.lines; ++i) polar.lineDeg.push_back(first + s.turnDeg * i / s.lines);
    return polar;
}

} // namespace

std::span<const SimulationNumber> simulationNumbers() { return kNumbers; }

const std::vector<SimulationScene>& simulationScenes() {
    static const std::vector<SimulationScene> scenes{
        {"hangup", "rocks jammed across the bell, seen from below, with a chimney and the drift"},
        {"pile", "a slope of rocks against one wall, the bell open above"},
        {"empty", "the bell without rocks"},
        {"wall", "a wall, flat and whole unless asked otherwise"},
        {"staircase", "treads that fall away to both sides by 20, 50, 120, 300 and by 30, 80, 200, 500 mm"},
        {"rescan", "a measured surface, given with --surface, over the scanner"},
    };
    return scenes;
}

std::optional<Error> idleIn(const std::string& scene, const std::function<bool(const std::string& key)>& given) {
    struct Use {
        std::vector<std::string> keys, scenes;
    };
    static const std::vector<Use> uses{
        {{"after-blast"}, {"hangup"}},
        {{"rock-count", "rock-roughness", "rock-rounding", "rock-size", "rock-lumps", "rock-lump-size"}, {"hangup", "pile"}},
        {{"wall-kind"}, {"hangup", "pile", "empty"}},
        {{"wall-roughness"}, {"hangup", "pile", "empty", "wall"}},
        {{"surface", "surface-scale"}, {"rescan"}},
        {{"distance"}, {"wall", "staircase", "rescan"}},
        {{"hole-shape", "hole-count", "hole-size"}, {"wall"}}};
    if (std::ranges::find(simulationScenes(), scene, &SimulationScene::name) == simulationScenes().end()) return std::nullopt;
    for (const auto& [keys, scenes] : uses) {
        const auto idle = std::ranges::find_if(keys, given);
        if (idle == keys.end() || std::ranges::find(scenes, scene) != scenes.end()) continue;
        std::string names;
        for (const std::string& name : scenes) names += (names.empty() ? "" : ", ") + name;
        return Error{"the scene " + scene + " does not use this flag", "--" + *idle, "leave it out, or choose --scene " + names};
    }
    if (given("rock-lump-size") && !given("rock-lumps"))
        return Error{"rocks without lumps have no size of them", "--rock-lump-size", "give --rock-lumps too"};
    return std::nullopt;
}

Error noHoles() {
    return {"a wall without holes has no number or size of them", "--hole-shape none", "use round or square, or leave the others out"};
}

std::uint64_t measurementSeed(const SimulationSettings& settings) {
    if (settings.repeat == 0 && !settings.afterBlast) return settings.seed;
    return hashOf(settings.seed, Purpose::Repeats, 2 * static_cast<std::uint64_t>(settings.repeat) + (settings.afterBlast ? 1 : 0));
}

double wallRoughnessMmOf(const SimulationSettings& settings) {
    constexpr double kBellMm = 30.0;
    return settings.wallRoughnessMm.value_or(settings.scene == "wall" ? 0.0 : kBellMm);
}

Result<Simulation> simulate(const SimulationSettings& settings, const SimulationProgress& progress) {
    if (const auto no = refusal(settings)) return *no;
    try {
        Result<Scene> scene = sceneOf(settings);
        if (!scene) return scene.error();
        Result<Simulation> done = sweepScene(*scene, nominalGeometry(settings), settings, progress);
        if (done) done->scan.name = settings.scene + "-seed" + std::to_string(settings.seed) + (settings.afterBlast ? "-after" : "");
        return done;
    } catch (const std::bad_alloc&) {
        return Error{"not enough memory for this many cells", "simulate", "use fewer lines or beams"};
    }
}

} // namespace edgescan::sim
