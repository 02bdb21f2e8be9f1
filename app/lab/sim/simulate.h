// The synthetic draw-bell: a scene of convex rocks, scanned by an LMS511 with its beam, noise and faults (docs/method/edges.md,
// "Simulator").
#pragma once

#include "app/lab/sim/seam.h"
#include "core/base/result.h"
#include "core/base/table_row.h"
#include "core/scan/georef/assembly.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::sim {

/// Beam divergence: 4.6 mrad or 11 mrad.
enum class DeviceProfile : std::uint8_t { HighResolution, Standard };

enum class WallHole : std::uint8_t { None, Round, Square };

/// Steps of the scene "staircase", mm, from the middle outwards: even indices towards +x, odd ones towards -x. Outer treads are farther
/// away.
inline constexpr std::array<double, 8> kStaircaseMm{20.0, 30.0, 50.0, 80.0, 120.0, 200.0, 300.0, 500.0};

/// The defaults give an LMS511's full grid (docs/method/edges.md, "Simulator").
struct SimulationSettings {
    std::string scene = "hangup"; ///< one of simulationScenes()
    std::uint64_t seed = 1;       ///< the same seed gives the same bytes for any number of threads
    int lines = 1000;             ///< over the turn, with steps of turnDeg / lines
    int beams = 1141;             ///< over -5..185 degrees, including both ends
    Axis axis = Axis::Sweep;
    int repeat = 0;         ///< index of a repeated sweep of one scene: the same rocks, other noise, dust and dropouts
    double turnDeg = 180.0; ///< rotation of the stepper; beyond 180 a spin sees surfaces twice
    DeviceProfile profile = DeviceProfile::HighResolution;

    // The scene.
    bool afterBlast = false;      ///< only "hangup": the same bell after a blast at a keystone, with different noise
    int rocks = 420;              ///< number in the arch or pile; scenes without rocks ignore it
    double rockRoughnessMm = 8.0; ///< standard deviation of the fractal relief
    double rockRounding = 0.0;    ///< radius of corners and ridges, as a share of the largest ball around a rock's middle that fits inside
    double rockSize = 1.0;        ///< factor on the size of every rock; their number is unchanged
    double rockLumpsMm = 0.0;     ///< standard deviation of smooth lumps of the rocks, in addition to their roughness
    double rockLumpM = 0.35;      ///< lattice of the lumps; the distance between lumps is two to three times as long
    std::string wallKind = "plain";        ///< of the bell: one of wallKinds()
    std::optional<double> wallRoughnessMm; ///< the same for the walls; default: 30 for those of the bell, 0 for the scene "wall"
    int absorbingPatches = 6;              ///< number of round spots without a return
    double distanceM = 6.0;                ///< distance of the wall, or of the staircase's middle tread
    WallHole hole = WallHole::None;        ///< open voids in the wall
    int holes = 1;                         ///< one hole is in the middle, several are distributed according to the seed
    double holeM = 2.0;                    ///< diameter or side of the holes
    std::vector<Eigen::Vector3f> surface;  ///< points of the scene "rescan", metres, z towards the surveyor
    double surfaceScale = 1.0;             ///< factor on the size of the surface
    std::string surfaceFile;               ///< file of its points, as information in the settings

    // The measurement; each effect can be switched off.
    double noise = 1.0;         ///< factor on (5.5 + 0.25 r[m]) mm x (1 + 0.35 (1/cos - 1))
    double dropouts = 0.002;    ///< probability that a cell is lost at random
    double dust = 0.0008;       ///< probability of an echo from dust in front of the surface
    bool footprint = true;      ///< 11 sub-rays per beam; false: only the centre
    bool mixedPixels = true;    ///< echoes closer than 0.6 m merge; false: the object with the largest part of the beam gives the range
    bool echoLoss = true;       ///< grazing and weak echoes are often lost
    double rangeStepMm = 1.0;   ///< ranges come in whole steps
    double maxRangeM = 40.0;    ///< larger distances give no return
    double lineJitterDeg = 0.0; ///< standard deviation of the true line angle around the recorded one
    double interlaceDeg = 0.0;  ///< true line angle of odd beams minus that of even beams
    double motorSkewDeg = 0.0;  ///< movement of the stepper while the mirror sweeps the fan
    double slips = 0.0;         ///< probability per line that the stepper falls one step behind
    AssemblyErrors assembly;    ///< rays start and point according to these errors, while the recorded angles stay nominal; not with truth
    RigidTransform station;     ///< from the scanner's frame to that of the scene, where the first station is at the origin; not with truth
    double zeroJumpDeg = 0.0;   ///< shift of the stepper's zero at half of the turn
    double statusCodes = 0.0;   ///< probability that the device reports a status code in place of a range

    bool truth = false; ///< also fill Simulation::truth
    int threads = 0;    ///< 0: one per core
};

/// The true hit of each cell's centre ray. Grids are lines x beams; cells without a hit hold zeros.
struct SimulationTruth {
    Grid<std::uint16_t> object;   ///< 0 no hit, 1 wall, 2.. rocks
    Grid<std::uint16_t> face;     ///< number of the flat or smooth part of the object, from 1
    Grid<float> cleanMm;          ///< range with relief, without noise, steps or footprint
    Grid<Eigen::Vector3f> normal; ///< unit vector, scanner frame, towards the scanner; without relief
    Grid<std::uint8_t> absorbed;  ///< 1 in absorbing patches
    Grid<std::uint8_t> rounded;   ///< 1 on rounded corners and ridges of rocks
    Grid<sim::Seam> toNextBeam;   ///< the seam between the surfaces of the cell and of the next beam; zero on one face of a rock
    Grid<sim::Seam> toNextLine;

    struct Rock {
        int object = 0;
        Eigen::Vector3f centreM = Eigen::Vector3f::Zero(); ///< scanner frame
        std::array<float, 3> spansM{};                     ///< full size, longest first, including hidden parts
        float volumeM3 = 0.0F;
    };
    std::vector<Rock> rocks;
};

struct Simulation {
    Scan scan; ///< name "<scene>-seed<seed>", format "simulated", whole range steps; cells are Valid, NoReturn (range 0) or DeviceStatus
    std::optional<SimulationTruth> truth;
};

/// wallRoughnessMm, or the default of the scene if it is not given.
[[nodiscard]] double wallRoughnessMmOf(const SimulationSettings& settings);

/// Called on the calling thread with the share done, 0..1, never decreasing; false cancels.
using SimulationProgress = std::function<bool(double fraction)>;

/// The seed of noise, dropouts and all else that differs between sweeps; the scene itself uses the seed of the settings.
[[nodiscard]] std::uint64_t measurementSeed(const SimulationSettings& settings);

/// The names of the scenes, and what each shows.
struct SimulationScene {
    const char* name;
    const char* help;
};
[[nodiscard]] const std::vector<SimulationScene>& simulationScenes();

/// Error: a setting is given that this scene does not use. `given`: by its key, "rock-count".
[[nodiscard]] std::optional<Error> idleIn(const std::string& scene, const std::function<bool(const std::string& key)>& given);
/// The Error of a number or size of holes with the shape none.
[[nodiscard]] Error noHoles();

/// A numeric setting. A default that depends on the scene is the one of the scene.
using SimulationNumber = TableRow<SimulationSettings>;
[[nodiscard]] std::span<const SimulationNumber> simulationNumbers();

/// Casts every beam. Error: an unknown scene, a setting outside its limits, not enough memory, or "cancelled".
[[nodiscard]] Result<Simulation> simulate(const SimulationSettings& settings, const SimulationProgress& progress = {});

} // namespace edgescan::sim
