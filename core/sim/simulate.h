// The synthetic draw-bell: a scene of convex rocks, swept by an LMS511 with its beam, noise and failings (docs/method.md, "Simulator").
#pragma once

#include "core/base/physical_limits.h"
#include "core/base/result.h"
#include "core/scan/georef/assembly.h"
#include "core/scan/grid/scan.h"
#include "core/sim/seam.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan {

/// How fast the beam widens: 4.6 mrad or 11 mrad.
enum class DeviceProfile : std::uint8_t { HighResolution, Standard };

enum class WallHole : std::uint8_t { None, Round, Square };

/// Steps of the scene "staircase", mm, from the middle outwards: even places towards +x, odd ones towards -x. Outer treads are farther
/// away.
inline constexpr std::array<double, 8> kStaircaseMm{20.0, 30.0, 50.0, 80.0, 120.0, 200.0, 300.0, 500.0};

/// The defaults are an LMS511's full grid (docs/method.md, "Simulator").
struct SimulationSettings {
    std::string scene = "hangup"; ///< one of simulationScenes()
    std::uint64_t seed = 1;       ///< same seed, same bytes, whatever the number of threads
    int lines = 1000;             ///< over the turn: steps of turnDeg / lines
    int beams = 1141;             ///< over -5..185 degrees, both ends included
    Axis axis = Axis::Sweep;
    int repeat = 0;         ///< which of several sweeps of one scene: the same rocks, other noise, dust and dropouts
    double turnDeg = 180.0; ///< of the stepper; beyond 180 a spin sees surfaces twice
    DeviceProfile profile = DeviceProfile::HighResolution;

    // The scene.
    bool afterBlast = false;      ///< of "hangup": the same bell after a blast at a keystone, with a noise of its own
    int rocks = 420;              ///< in the arch or pile; the scenes without rocks ignore it
    double rockRoughnessMm = 8.0; ///< standard deviation of the fractal relief
    double rockRounding = 0.0;    ///< radius of corners and ridges, as a share of the largest ball round a rock's middle that fits in it
    double rockSize = 1.0;        ///< times the size of every rock; their number stays
    double rockLumpsMm = 0.0;     ///< standard deviation of smooth lumps of the rocks, beside their roughness
    double rockLumpM = 0.35;      ///< lattice of the lumps; from one to the next it is two to three times as far
    std::optional<double> wallRoughnessMm; ///< likewise of the walls; unless given, 30 for those of the bell and 0 for the scene "wall"
    int absorbingPatches = 6;              ///< round spots that send nothing back
    double distanceM = 6.0;                ///< of the wall or of the staircase's middle tread
    WallHole hole = WallHole::None;        ///< open voids in the wall
    int holes = 1;                         ///< one is in the middle, several are spread as the seed says
    double holeM = 2.0;                    ///< their diameter or side
    std::vector<Eigen::Vector3f> surface;  ///< points of the scene "rescan", metres, z towards the surveyor
    double surfaceScale = 1.0;             ///< times the size of the surface
    std::string surfaceFile;               ///< where its points came from, for who reads the settings

    // The measurement; each ingredient can be switched off.
    double noise = 1.0;         ///< times (5.5 + 0.25 r[m]) mm x (1 + 0.35 (1/cos - 1))
    double dropouts = 0.002;    ///< probability that a cell is lost at random
    double dust = 0.0008;       ///< probability of an echo from dust in front of the surface
    bool footprint = true;      ///< 11 sub-rays per beam; false: the centre alone
    bool mixedPixels = true;    ///< echoes closer than 0.6 m merge; false: the object with most of the beam gives the range
    bool echoLoss = true;       ///< grazing and weak echoes are often lost
    double rangeStepMm = 1.0;   ///< ranges come in whole steps
    double maxRangeM = 40.0;    ///< nothing comes back from farther away
    double lineJitterDeg = 0.0; ///< standard deviation of the true line angle round the recorded one
    double interlaceDeg = 0.0;  ///< true line angle of odd beams minus that of even beams
    double motorSkewDeg = 0.0;  ///< how far the stepper moves on while the mirror sweeps the fan
    double slips = 0.0;         ///< probability that the stepper lags one step behind on a line
    AssemblyErrors assembly;    ///< each ray starts and points as they say, the recorded angles stay nominal; not with truth
    double zeroJumpDeg = 0.0;   ///< how far the stepper's zero moves at half of the turn
    double statusCodes = 0.0;   ///< probability that the device reports a status code instead of a range

    bool truth = false; ///< also fill Simulation::truth
    int threads = 0;    ///< 0: one per core
};

/// What the centre ray of each cell really hit. Grids are lines x beams; cells that hit nothing hold zeros.
struct SimulationTruth {
    Grid<std::uint16_t> object;   ///< 0 nothing, 1 wall, 2.. rocks
    Grid<std::uint16_t> face;     ///< flat or smooth part of the object, from 1
    Grid<float> cleanMm;          ///< range with relief, without noise, steps or footprint
    Grid<Eigen::Vector3f> normal; ///< unit, scanner frame, towards the scanner; without relief
    Grid<std::uint8_t> absorbed;  ///< 1 in absorbing patches
    Grid<std::uint8_t> rounded;   ///< 1 where a corner or ridge of a rock is rounded off
    Grid<sim::Seam> toNextBeam;   ///< the seam between the surfaces of the cell and of the next beam; none on one face of a rock
    Grid<sim::Seam> toNextLine;

    struct Rock {
        int object = 0;
        Eigen::Vector3f centreM = Eigen::Vector3f::Zero(); ///< scanner frame
        std::array<float, 3> spansM{};                     ///< full size, longest first, hidden parts included
        float volumeM3 = 0.0F;
    };
    std::vector<Rock> rocks;
};

struct Simulation {
    Scan scan; ///< name "<scene>-seed<seed>", format "simulated", whole range steps; cells are Valid, NoReturn (range 0) or DeviceStatus
    std::optional<SimulationTruth> truth;
};

/// wallRoughnessMm, or what the scene has where it is not given.
[[nodiscard]] double wallRoughnessMmOf(const SimulationSettings& settings);

/// Called on the calling thread with the finished share, 0..1, never falling; false cancels.
using SimulationProgress = std::function<bool(double fraction)>;

/// What noise, dropouts and all else that differs from sweep to sweep is drawn from; the scene itself comes from the seed.
[[nodiscard]] std::uint64_t measurementSeed(const SimulationSettings& settings);

/// Scene names and what each shows.
struct SimulationScene {
    const char* name;
    const char* help;
};
[[nodiscard]] const std::vector<SimulationScene>& simulationScenes();

/// A setting that is a number, with its flag and limits.
struct SimulationNumber {
    const char* key; ///< flag without "--"
    NumberLimits limits;
    double (*get)(const SimulationSettings&);
    void (*set)(SimulationSettings&, double); ///< of a value within the limits; what counts things loses its fraction
};
[[nodiscard]] std::span<const SimulationNumber> simulationNumbers();

/// Casts every beam. Error: a scene that does not exist, a setting outside its limits, not enough memory, or "cancelled".
[[nodiscard]] Result<Simulation> simulate(const SimulationSettings& settings, const SimulationProgress& progress = {});

} // namespace edgescan
