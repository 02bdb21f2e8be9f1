// Scans a scene: casts the lines on all cores.
#include "app/lab/sim/sweep.h"

#include "app/lab/sim/aim.h"
#include "app/lab/sim/beam.h"
#include "app/lab/sim/caster.h"
#include "app/lab/sim/cell_seams.h"
#include "app/lab/sim/noise.h"
#include "app/lab/sim/random.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

namespace edgescan::sim {
namespace {

constexpr std::uint32_t kStatusCode = 65533; // an LMS511 never reports a range of this size

struct Patch {
    Eigen::Vector3d direction;
    double cosRadius;
};

/// The inputs of a line; shared by the threads, constant while they run.
struct Sweep {
    const SimulationSettings& settings;
    const Scene& scene;
    Footprint footprint;
    std::vector<Patch> patches;
    std::array<Scan, 2> aim; ///< true angles of even and odd beams
};

std::vector<Patch> patchesOf(const SimulationSettings& s, const CartesianTables& aim) {
    RandomSequence dice(s.seed, Purpose::Patches);
    std::vector<Patch> patches;
    for (int i = 0; i < s.absorbingPatches; ++i) {
        const double radius = dice.uniform(0.4, 1.0) * std::numbers::pi / 180.0;
        const int line = static_cast<int>(dice.uniform(0.15, 0.85) * s.lines);
        const int beam = static_cast<int>(dice.uniform(0.15, 0.85) * s.beams);
        patches.push_back({aim.direction(line, beam), std::cos(radius)});
    }
    return patches;
}

bool inPatch(const std::vector<Patch>& patches, const Eigen::Vector3d& direction) {
    for (const Patch& patch : patches)
        if (direction.dot(patch.direction) > patch.cosRadius) return true;
    return false;
}

/// Relief along the ray at the end of a sub-ray, metres. It changes the range but never the outline: the object that a ray hits is that of
/// the smooth body.
double reliefM(const Sweep& sweep, const Surface& surface, double cosine, const Eigen::Vector3d& place) {
    if (surface.texture == Texture::Smooth) return 0.0;
    const bool wall = surface.texture == Texture::Wall;
    const double height = 0.001 * (wall ? wallRoughnessMmOf(sweep.settings) : sweep.settings.rockRoughnessMm);
    const double lumps = wall ? 0.0 : 0.001 * sweep.settings.rockLumpsMm;
    const double along = std::max(cosine, 0.35);
    const auto seed = [&](unsigned kind) { return hashOf(sweep.settings.seed, Purpose::Shapes, (1ULL << kind) + surface.object); };
    double relief = height <= 0.0 ? 0.0 : height / along * fractalNoise(place, wall ? 1.4 : 0.5, 4, seed(40));
    if (lumps > 0.0) relief += lumps / along * valueNoise(place / sweep.settings.rockLumpM, seed(41)) / kValueNoiseSpread;
    return relief;
}

void castLine(const Sweep& sweep, const RayCaster& caster, const std::array<BeamDirections, 2>& aim, int line, Simulation& out) {
    const SimulationSettings& settings = sweep.settings;
    for (int beam = 0; beam < settings.beams; ++beam) {
        const std::size_t k = out.scan.rangeMm.index(line, beam);
        const Ray ray = aim[static_cast<std::size_t>(beam % 2)].ray(line, beam);
        const RayBundle bundle = bundleAlong(ray.direction, sweep.footprint, ray.fromM);
        const BundleHits hits = caster.cast(bundle);
        const bool absorbed = inPatch(sweep.patches, ray.direction);
        const auto reliefAt = [&](std::size_t lane, double rangeM) {
            const Surface surface = surfaceOf(sweep.scene, bundle, hits, lane);
            return reliefM(sweep, surface, cosineOf(sweep.scene, surface, bundle, hits, lane), ray.fromM + ray.direction * rangeM);
        };
        Echo echo = echoOf(bundle, hits, sweep.scene, settings);
        if (absorbed) echo = {};
        if (echo.signal > 0.0) echo.rangeM = std::max(0.001, echo.rangeM + reliefAt(echo.strongest, echo.rangeM));
        const auto range = static_cast<float>(measuredMm(echo, k, settings));
        out.scan.rangeMm[k] = range;
        out.scan.state[k] = range > 0.0F ? CellState::Valid : CellState::NoReturn;
        if (uniformOf(hashOf(measurementSeed(settings), Purpose::Status, k)) < settings.statusCodes) {
            out.scan.rangeMm[k] = static_cast<float>(kStatusCode * settings.rangeStepMm);
            out.scan.state[k] = CellState::DeviceStatus;
        }
        if (!out.truth) continue;
        out.truth->absorbed[k] = absorbed ? 1 : 0;
        if (hits.surface[0] < 0) continue;
        const Surface surface = surfaceOf(sweep.scene, bundle, hits, 0);
        const double clean = static_cast<double>(hits.distanceM[0]);
        out.truth->object[k] = surface.object;
        out.truth->face[k] = surface.face;
        out.truth->rounded[k] = surface.ridge >= 0 ? 1 : 0;
        out.truth->normal[k] = normalAt(sweep.scene, surface, placeOf(bundle, hits, 0));
        out.truth->cleanMm[k] = static_cast<float>(1000.0 * (clean + reliefAt(0, clean)));
    }
}

/// Returns false if cancelled. A cell depends only on its own index.
bool castAll(const Sweep& sweep, const SimulationProgress& progress, Simulation& out) {
    const AssemblyErrors& assembly = sweep.settings.assembly;
    const std::array<BeamDirections, 2> aim{BeamDirections(sweep.aim[0], assembly, sweep.settings.station),
                                            BeamDirections(sweep.aim[1], assembly, sweep.settings.station)};
    const RayCaster caster(sweep.scene, sweep.footprint, aim[0].centreM(), aim[0].leverM());
    if (!forAllLines(sweep.settings, progress, [&](int line) { castLine(sweep, caster, aim, line, out); })) return false;
    if (out.truth && sweep.scene.copies.empty()) {
        const SeamSources sources{sweep.scene, caster, {&aim[0].tables(), &aim[1].tables()}, !sweep.settings.surface.empty()};
        forAllLines(sweep.settings, {}, [&](int line) { findSeams(sources, line, *out.truth); });
    }
    return !progress || progress(1.0);
}

SimulationTruth emptyTruth(const SimulationSettings& s, const Scene& scene) {
    SimulationTruth truth{{s.lines, s.beams},
                          {s.lines, s.beams},
                          {s.lines, s.beams},
                          {s.lines, s.beams, Eigen::Vector3f::Zero().eval()},
                          {s.lines, s.beams},
                          {s.lines, s.beams},
                          {s.lines, s.beams},
                          {s.lines, s.beams},
                          {}};
    for (const RockTruth& rock : scene.rocks) truth.rocks.push_back({rock.object, rock.centreM, rock.spansM, rock.volumeM3});
    return truth;
}

} // namespace

bool forAllLines(const SimulationSettings& settings, const SimulationProgress& progress, const std::function<void(int line)>& work) {
    std::atomic<int> next{0};
    std::atomic<int> finished{0};
    std::atomic<bool> stopped{false};
    const auto share = [&](bool reports) {
        for (int line = next++; line < settings.lines && !stopped; line = next++) {
            work(line);
            const int done = ++finished;
            if (reports && progress && !progress(static_cast<double>(done) / settings.lines)) stopped = true;
        }
    };
    const unsigned cores = settings.threads > 0 ? static_cast<unsigned>(settings.threads) : std::thread::hardware_concurrency();
    {
        std::vector<std::jthread> others;
        for (unsigned t = 1; t < cores; ++t) others.emplace_back(share, false);
        share(true);
    }
    return !stopped;
}

PolarGeometry trueAngles(const SimulationSettings& s, const PolarGeometry& nominal, bool oddBeams) {
    PolarGeometry polar = nominal;
    for (std::size_t i = 0; i < polar.lineDeg.size(); ++i) {
        if (s.assembly.turnDeg() != 0) polar.lineDeg[i] *= s.assembly.turnFactor();
        if (2 * i >= polar.lineDeg.size()) polar.lineDeg[i] += s.zeroJumpDeg;
        polar.lineDeg[i] += s.lineJitterDeg * normalOf(hashOf(measurementSeed(s), Purpose::LineJitter, i));
        if (oddBeams) polar.lineDeg[i] += s.interlaceDeg;
        if (uniformOf(hashOf(measurementSeed(s), Purpose::Slips, i)) < s.slips) polar.lineDeg[i] -= s.turnDeg / s.lines;
    }
    if (s.motorSkewDeg != 0.0) {
        for (int j = 0; j < s.beams; ++j) polar.lineSkewDeg.push_back(s.motorSkewDeg * j / (s.beams - 1));
    }
    return polar;
}

Result<Simulation> sweepScene(const Scene& scene, const PolarGeometry& nominal, const SimulationSettings& settings,
                              const SimulationProgress& progress) {
    Simulation out;
    out.scan.format = "simulated";
    out.scan.geometry = nominal;
    out.scan.unitMm = settings.rangeStepMm;
    if (settings.statusCodes > 0) out.scan.statusCodes = {kStatusCode};
    out.scan.rangeMm = {settings.lines, settings.beams};
    out.scan.state = {settings.lines, settings.beams, CellState::NoReturn};
    if (settings.truth) out.truth = emptyTruth(settings, scene);

    const Footprint footprint{0.013, settings.profile == DeviceProfile::HighResolution ? 0.0046 : 0.011};
    Sweep sweep{settings, scene, footprint, {}, {}};
    sweep.aim[0].geometry = trueAngles(settings, nominal, false);
    sweep.aim[1].geometry = trueAngles(settings, nominal, true);
    sweep.patches = patchesOf(settings, CartesianTables(sweep.aim[0]));
    if (!castAll(sweep, progress, out)) return Error{"cancelled", "", ""};
    return out;
}

} // namespace edgescan::sim
