// Scans heaps of real stones.
#include "app/lab/stones/stone_scene.h"

#include "app/lab/sim/convex_rock.h"
#include "app/lab/sim/sweep.h"
#include "app/lab/stones/carved_stone.h"
#include "app/lab/stones/stone_truth.h"
#include "core/scan/georef/rotations.h"

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

namespace fs = std::filesystem;
using sim::Purpose;

constexpr double kFirstBeamDeg = 48.5, kBeamStepDeg = 1.0 / 6.0, kLineStepDeg = 0.2;
constexpr int kBeams = 500, kLines = 400;

/// From the frame of the site to that of a moved scanner.
struct View {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d moveM = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& placeM) const { return turn * placeM + moveM; }
};

View viewOf(const StoneScene& scene) {
    View view;
    if (scene.view == 0) return view;
    sim::RandomSequence dice(scene.seed, Purpose::Repeats, static_cast<std::uint64_t>(scene.view));
    // Each place is turned about the middle of the heap, or about the axis of the bell.
    Eigen::Vector3d about = Eigen::Vector3d::Zero(), move;
    double yawDeg = 0;
    if (scene.kind == "pile") {
        yawDeg = dice.uniform(-12, 12);
        about = {0, -6, 0};
        for (int axis = 0; axis < 3; ++axis) move[axis] = axis == 0 ? dice.uniform(-0.7, 0.7) : dice.uniform(-0.4, axis == 1 ? 0.4 : 0.3);
    } else {
        const bool bench = scene.kind == "bench";
        const double aside = bench ? 0.4 : 0.5;
        yawDeg = dice.uniform(40, 320);
        if (bench) about = {0, -1.2, 0};
        for (int axis = 0; axis < 2; ++axis) move[axis] = dice.uniform(-aside, aside);
        move[2] = dice.uniform(bench ? -0.3 : -0.8, 0.5);
    }
    view.turn = rotationZ(radians(yawDeg));
    view.moveM = about - view.turn * about + move;
    return view;
}

sim::MeshCopy copyOf(std::shared_ptr<const sim::StoredMesh> mesh, const View& view, const Eigen::Matrix3d& turn,
                     const Eigen::Vector3d& placeM, double size) {
    sim::MeshCopy copy;
    copy.mesh = std::move(mesh);
    copy.rotation = (view.turn * turn).cast<float>();
    copy.scale = static_cast<float>(size);
    copy.placeM = (view * placeM).cast<float>();
    return copy;
}

/// What the scene's list of rocks says of a copy. The volume is that inside the mesh, which is closed but for small holes.
sim::RockTruth rockOf(const Stone& stone, const sim::MeshCopy& copy) {
    const double scale = copy.scale;
    const std::vector<Eigen::Vector3f>& points = stone.mesh->points();
    sim::RockTruth rock{.object = copy.object};
    std::vector<Eigen::Vector3d> cornersM;
    for (const Eigen::Vector3f& corner : stone.hull) cornersM.emplace_back(scale * corner.cast<double>());
    std::ranges::transform(sim::spansOf(cornersM), rock.spansM.begin(), [](double span) { return static_cast<float>(span); });
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& point : points) sum += point.cast<double>();
    rock.centreM = copy.rotation * (copy.scale * (sum / static_cast<double>(points.size())).cast<float>()) + copy.placeM;
    double volume = 0.0;
    for (const sim::StoredMesh::Corners& triangle : stone.mesh->triangles()) {
        const auto corner = [&](std::size_t n) { return points[static_cast<std::size_t>(triangle[n])].cast<double>(); };
        volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
    }
    rock.volumeM3 = static_cast<float>(std::abs(volume) * scale * scale * scale);
    return rock;
}

/// Walls and resting stones in the frame of the site, seen from the view.
Result<sim::Scene> sceneOf(const Site& site, const Heap& heap, const Stones& stones, const StoneScene& asked) {
    const View view = viewOf(asked);
    constexpr double kRestMps = 0.5;
    sim::Scene scene;
    for (const SiteWall& wall : site.walls) {
        if (wall.fine.triangles.empty()) continue;
        auto mesh = std::make_shared<const sim::StoredMesh>(wall.fine.points, wall.fine.triangles);
        scene.copies.push_back(copyOf(std::move(mesh), view, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), 1.0));
        scene.copies.back().face = wall.number;
    }
    std::uint16_t object = sim::kFirstRock;
    for (const RestingStone& stone : heap) {
        const Stone* of = stones.named(stone.stone);
        if (of == nullptr)
            return Error{"the heap has the stone " + stone.stone + ", which is not there", "stones",
                         "read the folder that it was settled with"};
        if (!site.isScanned(view * stone.placeM) || stone.speedMps > kRestMps) continue;
        const std::uint64_t seed = sim::hashOf(asked.seed, Purpose::Shapes, static_cast<std::uint64_t>(asked.view) << 16U | object);
        const Stone scanned = asked.carved ? carvedStone(*of, seed) : *of;
        scene.copies.push_back(copyOf(scanned.mesh, view, stone.turn.toRotationMatrix(), stone.placeM, stone.sizeM));
        scene.copies.back().object = object++;
        scene.rocks.push_back(rockOf(scanned, scene.copies.back()));
    }
    return scene;
}

PolarGeometry geometryOf(const StoneScene& scene, const Site& site) {
    const int finer = scene.full ? 2 : 1;
    PolarGeometry polar;
    polar.axis = scene.spin ? Axis::Spin : Axis::Sweep;
    for (int j = 0; j < finer * kBeams; ++j) polar.beamDeg.push_back(kFirstBeamDeg + kBeamStepDeg * j / finer);
    const double step = (scene.spin ? 180.0 / kLines : kLineStepDeg) / finer;
    for (int i = 0; i < finer * kLines; ++i) polar.lineDeg.push_back((scene.spin ? 0.0 : site.firstLineDeg) + step * i);
    return polar;
}

/// From the site to the scanner: a sweep is tilted by its mount; a spin looks where the middle line of the sweep looks.
Eigen::Matrix3d mountOf(const StoneScene& scene, const Site& site) {
    const double middleDeg = scene.spin ? site.firstLineDeg + 0.5 * kLineStepDeg * kLines : 0.0;
    return rotationX(radians(-site.mountDeg - middleDeg));
}

/// The errors of the device, as in docs/method/edges.md, "Simulator"; the meshes have all the relief.
sim::SimulationSettings settingsOf(const StoneScene& scene, const PolarGeometry& polar, int threads) {
    sim::SimulationSettings settings;
    const auto kind = static_cast<std::uint64_t>(std::ranges::find(siteKinds(), scene.kind) - siteKinds().begin());
    settings.seed = sim::hashOf(scene.seed, Purpose::Noise, siteKinds().size() * static_cast<std::uint64_t>(scene.view) + kind);
    settings.lines = static_cast<int>(polar.lineDeg.size());
    settings.beams = static_cast<int>(polar.beamDeg.size());
    settings.turnDeg = (polar.lineDeg[1] - polar.lineDeg[0]) * settings.lines;
    settings.axis = polar.axis;
    settings.noise = scene.noise;
    settings.absorbingPatches = 4;
    settings.lineJitterDeg = 0.01;
    settings.truth = true;
    settings.threads = threads;
    return settings;
}

} // namespace

Result<Heap> heapOf(const StoneScene& scene, const Site& site, const Stones& stones, const StoneProgress& progress) {
    const std::string name = heapFileName(scene.kind, scene.set, scene.seed);
    std::error_code failed;
    if (!scene.settled.empty() && fs::exists(scene.settled / name, failed)) return readHeap(scene.settled / name);
    Result<Heap> heap = settledHeap(site, stones, scene.set, scene.seed, progress);
    if (!heap || scene.settled.empty()) return heap;
    if (const auto written = writeHeap(*heap, scene.settled, name); !written) return written.error();
    return heap;
}

Result<StoneScan> stoneScan(const StoneScene& scene, const Stones& stones, int threads, const StoneProgress& progress) {
    constexpr double kPhysics = 0.6, kSweep = 0.8; // share of the time
    const auto part = [&](double from, double to) {
        return [&progress, from, to](double fraction) { return !progress || progress(from + (to - from) * fraction); };
    };
    if (std::ranges::find(stoneSets(), scene.set) == stoneSets().end())
        return Error{"there is no set \"" + scene.set + "\"", "stones", "use free, lab or all"};
    const Result<Site> site = siteOf(scene.kind, scene.seed);
    if (!site) return site.error();
    const Result<Heap> heap = heapOf(scene, *site, stones, part(0, kPhysics));
    if (!heap) return heap.error();
    Result<sim::Scene> fromSite = sceneOf(*site, *heap, stones, scene);
    if (!fromSite) return fromSite.error();
    const sim::Scene seen = sim::rotated(std::move(*fromSite), mountOf(scene, *site).cast<float>());
    const PolarGeometry polar = geometryOf(scene, *site);
    const sim::SimulationSettings settings = settingsOf(scene, polar, threads);
    Result<sim::Simulation> simulation = sim::sweepScene(seen, polar, settings, part(kPhysics, kSweep));
    if (!simulation) return simulation.error();
    sim::TruthSet truth = stoneTruth(seen, *simulation, settings, scene.full ? 2 : 1);
    StoneScan result{std::move(*simulation), std::move(truth)};
    result.simulation.scan.name =
        scene.kind + "-" + scene.set + "-seed" + std::to_string(scene.seed) + "-view" + std::to_string(scene.view);
    if (progress && !progress(1.0)) return Error{"cancelled", "", ""};
    return result;
}

} // namespace edgescan::lab
