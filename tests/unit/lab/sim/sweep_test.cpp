// The simulated sweep: repeatable to the byte, and noisy, mixed and gappy by the amounts stated (docs/method/edges.md, "Simulator").
#include "app/lab/sim/beam.h"
#include "app/lab/sim/scenes.h"
#include "app/lab/sim/settings_json.h"
#include "app/lab/sim/simulate.h"
#include "app/lab/sim/truth/truth.h"
#include "core/scan/grid/cartesian.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

namespace edgescan::sim {
namespace {

using namespace sim;

SimulationSettings small(const char* scene) {
    SimulationSettings settings;
    settings.scene = scene;
    settings.lines = 60;
    settings.beams = 80;
    return settings;
}

/// Geometry only: ranges are those of the centre rays.
SimulationSettings perfect(const char* scene) {
    SimulationSettings settings = small(scene);
    settings.noise = 0.0;
    settings.dropouts = 0.0;
    settings.dust = 0.0;
    settings.footprint = false;
    settings.echoLoss = false;
    settings.absorbingPatches = 0;
    settings.rockRoughnessMm = 0.0;
    settings.wallRoughnessMm = 0.0;
    settings.truth = true;
    return settings;
}

// A few lines near the vertical, and the whole fan.
SimulationSettings narrowStaircase() {
    SimulationSettings settings = perfect("staircase");
    settings.lines = 20;
    settings.beams = 1141;
    return settings;
}

Simulation swept(const SimulationSettings& settings) {
    Result<Simulation> result = simulate(settings);
    EXPECT_TRUE(result) << (result ? "" : result.error().sentence());
    return result ? std::move(*result) : Simulation{};
}

/// Points of a floor with a raised half, for the scene that scans a cloud.
std::vector<Eigen::Vector3f> steps() {
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 200; ++j)
            points.emplace_back(0.2F * static_cast<float>(j), 0.2F * static_cast<float>(i), j < 100 ? 0.0F : 1.0F);
    return points;
}

TEST(SimSweep, NominalGeometry) {
    SimulationSettings settings = perfect("wall");
    settings.lines = 1000;
    settings.beams = 1141;
    settings.truth = false;
    const Simulation full = swept(settings);
    const auto& polar = std::get<PolarGeometry>(full.scan.geometry);
    EXPECT_EQ(full.scan.name, "wall-seed1");
    EXPECT_EQ(full.scan.format, "simulated");
    EXPECT_EQ(full.scan.lines(), 1000);
    EXPECT_EQ(full.scan.beams(), 1141);
    EXPECT_DOUBLE_EQ(polar.beamDeg.front(), -5.0);
    EXPECT_DOUBLE_EQ(polar.beamDeg.back(), 185.0);
    EXPECT_NEAR(polar.beamDeg[1] - polar.beamDeg[0], 1.0 / 6.0, 1e-12);
    EXPECT_DOUBLE_EQ(polar.lineDeg.front(), -90.0);
    EXPECT_NEAR(polar.lineDeg[1] - polar.lineDeg[0], 0.18, 1e-12);
    EXPECT_FLOAT_EQ(full.scan.rangeMm.at(500, 570), 6000.0F);
    EXPECT_FALSE(full.truth);
}

TEST(SimSweep, EverySceneSweepsInBothMountings) {
    for (const SimulationScene& scene : simulationScenes()) {
        for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
            SimulationSettings settings = small(scene.name);
            settings.axis = axis;
            settings.truth = true;
            settings.surface = steps();
            const Simulation result = swept(settings);
            const auto counts = countCells(result.scan);
            EXPECT_EQ(counts[0] + counts[1], result.scan.cells()) << scene.name;
            EXPECT_GT(counts[0], result.scan.cells() / 8) << scene.name;
            for (std::size_t k = 0; k < result.scan.cells(); ++k) {
                const float range = result.scan.rangeMm[k];
                EXPECT_EQ(range, std::round(range));
                EXPECT_EQ(range > 0.0F, result.scan.state[k] == CellState::Valid);
                EXPECT_EQ(result.truth->object[k] > 0, result.truth->cleanMm[k] > 0.0F);
            }
        }
    }
}

TEST(SimSweep, SameSeedSameBytesForAnyNumberOfThreads) {
    SimulationSettings settings = small("hangup");
    settings.truth = true;
    settings.threads = 1;
    const Simulation one = swept(settings);
    settings.threads = 2;
    const Simulation two = swept(settings);
    settings.threads = 5;
    const Simulation five = swept(settings);
    EXPECT_EQ(one.scan.rangeMm, two.scan.rangeMm);
    EXPECT_EQ(one.scan.rangeMm, five.scan.rangeMm);
    EXPECT_EQ(one.scan.state, two.scan.state);
    EXPECT_EQ(one.truth->object, two.truth->object);
    EXPECT_EQ(one.truth->cleanMm, five.truth->cleanMm);
    settings.seed = 2;
    EXPECT_NE(swept(settings).scan.rangeMm, one.scan.rangeMm);
}

TEST(SimSweep, TruthChangesNoRange) {
    SimulationSettings settings = small("hangup");
    const Simulation without = swept(settings);
    settings.truth = true;
    EXPECT_EQ(swept(settings).scan.rangeMm, without.scan.rangeMm);
}

TEST(SimSweep, NoiseOnAWallIsTheModels) {
    SimulationSettings settings = perfect("wall");
    settings.noise = 1.0;
    settings.rangeStepMm = 0.01;
    settings.lines = 300;
    settings.beams = 300;
    const Simulation result = swept(settings);
    const CartesianTables tables(result.scan);
    double squares = 0.0;
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < result.scan.cells(); ++k) {
        if (result.scan.state[k] != CellState::Valid) continue;
        const double clean = static_cast<double>(result.truth->cleanMm[k]);
        const double cosine = 6000.0 / clean;
        const double sigma = (5.5 + 0.25 * clean / 1000.0) * (1.0 + 0.35 * (1.0 / cosine - 1.0));
        const double deviation = (static_cast<double>(result.scan.rangeMm[k]) - clean) / sigma;
        sum += deviation;
        squares += deviation * deviation;
        ++count;
    }
    ASSERT_GT(count, 30000);
    EXPECT_NEAR(sum / count, 0.0, 0.02);
    EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.02);
    EXPECT_NEAR(sim::rangeSigmaM(10.0, 1.0), 0.008, 1e-12);
}

TEST(SimSweep, DropoutsComeAtTheirRate) {
    SimulationSettings settings = perfect("wall");
    settings.lines = 200;
    settings.beams = 300;
    const auto valid = static_cast<double>(countCells(swept(settings).scan)[0]);
    settings.dropouts = 0.05;
    const auto left = static_cast<double>(countCells(swept(settings).scan)[0]);
    EXPECT_NEAR(1.0 - left / valid, 0.05, 4.0 * std::sqrt(0.05 / valid));
    settings.dropouts = 1.0;
    EXPECT_EQ(countCells(swept(settings).scan)[0], 0U);
}

TEST(SimSweep, DustLiesInFrontOfTheWall) {
    SimulationSettings settings = perfect("wall");
    settings.dust = 0.1;
    const Simulation result = swept(settings);
    int dust = 0;
    int valid = 0;
    for (std::size_t k = 0; k < result.scan.cells(); ++k) {
        if (result.scan.state[k] != CellState::Valid) continue;
        ++valid;
        if (result.scan.rangeMm[k] < result.truth->cleanMm[k] - 1.0F) ++dust;
        EXPECT_LE(result.scan.rangeMm[k], result.truth->cleanMm[k] + 1.0F);
    }
    EXPECT_NEAR(static_cast<double>(dust) / valid, 0.1, 0.03);
}

TEST(SimSweep, GrazingAndPatchesLoseEchoes) {
    SimulationSettings settings = perfect("empty");
    settings.absorbingPatches = 40;
    const Simulation result = swept(settings);
    std::size_t absorbed = 0;
    for (std::size_t k = 0; k < result.scan.cells(); ++k) {
        if (result.truth->absorbed[k] == 0) continue;
        ++absorbed;
        EXPECT_EQ(result.scan.state[k], CellState::NoReturn);
    }
    EXPECT_GT(absorbed, 5U);
    sim::Echo grazing{.rangeM = 4.0, .cosine = 0.03, .signal = 1.0};
    sim::Echo weak{.rangeM = 30.0, .cosine = 1.0, .signal = 0.002};
    settings.echoLoss = true;
    int lostGrazing = 0;
    int lostWeak = 0;
    for (std::size_t k = 0; k < 1000; ++k) {
        lostGrazing += sim::measuredMm(grazing, k, settings) == 0.0 ? 1 : 0;
        lostWeak += sim::measuredMm(weak, k, settings) == 0.0 ? 1 : 0;
    }
    EXPECT_NEAR(lostGrazing, 630, 60);
    EXPECT_NEAR(lostWeak, 900, 40);
}

TEST(SimSweep, MixedPixelsLieOnlyAtEdges) {
    SimulationSettings settings = narrowStaircase();
    settings.footprint = true;
    settings.rangeStepMm = 0.1;
    const Simulation mixed = swept(settings);
    settings.mixedPixels = false;
    const Simulation clean = swept(settings);
    const auto& truth = *mixed.truth;
    int between = 0;
    for (int i = 0; i < 20; ++i) {
        for (int j = 2; j + 2 < 1141; ++j) {
            if (truth.object.at(i, j) == 0 || truth.cleanMm.at(i, j) > 12000.0F) continue;
            bool edge = false;
            for (int d = -1; d <= 1; ++d) edge = edge || truth.object.at(i, j + d) != truth.object.at(i, j);
            const float off = std::abs(mixed.scan.rangeMm.at(i, j) - truth.cleanMm.at(i, j));
            if (off > 10.0F && edge) ++between;
            if (!edge) {
                EXPECT_LT(off, 5.0F) << i << ' ' << j;
                EXPECT_EQ(mixed.scan.rangeMm.at(i, j), clean.scan.rangeMm.at(i, j));
            }
        }
    }
    EXPECT_GT(between, 10);
}

TEST(SimSweep, StaircaseStepsAreRecovered) {
    SimulationSettings settings = narrowStaircase();
    settings.noise = 1.0;
    settings.footprint = true;
    const Simulation result = swept(settings);
    const CartesianTables tables(result.scan);
    std::map<int, std::pair<double, int>> depth; // by object: sum of z and count, along the vertical line
    for (int j = 1; j + 1 < 1141; ++j) {
        const int object = result.truth->object.at(10, j);
        const bool edge = result.truth->object.at(10, j - 1) != object || result.truth->object.at(10, j + 1) != object;
        const Eigen::Vector3d p = tables.point(10, j);
        if (object == 0 || edge || p.hasNaN()) continue;
        depth[object].first += p.z();
        ++depth[object].second;
    }
    const auto mean = [&](int object) { return 1000.0 * depth[object].first / depth[object].second; };
    ASSERT_EQ(depth.size(), 9U);
    EXPECT_NEAR(mean(2), 6000.0, 3.0);
    for (int i = 0; i < 4; ++i) { // objects 3-6 to the right, 7-10 to the left
        const auto place = static_cast<std::size_t>(2 * i);
        EXPECT_NEAR(mean(3 + i) - mean(i == 0 ? 2 : 2 + i), kStaircaseMm[place], 6.0);
        EXPECT_NEAR(mean(7 + i) - mean(i == 0 ? 2 : 6 + i), kStaircaseMm[place + 1], 6.0);
    }
}

TEST(SimSweep, StaircaseStepsAreThoseOfItsTreadsAtAnyDistance) {
    for (const double distanceM : {2.0, 6.0, 15.0}) {
        SimulationSettings settings = narrowStaircase();
        settings.distanceM = distanceM;
        settings.rangeStepMm = 0.5;
        const Simulation result = swept(settings);
        const CartesianTables tables(result.scan);
        const std::vector<StaircaseTread> treads = staircaseTreads(distanceM);
        ASSERT_EQ(treads.size(), kStaircaseMm.size() + 1);
        std::set<int> seen;
        for (int j = 0; j < 1141; ++j) {
            const int object = result.truth->object.at(10, j);
            if (object == 0) continue;
            const StaircaseTread& tread = treads[static_cast<std::size_t>(object - kFirstRock)];
            const Eigen::Vector3d p = tables.point(10, j);
            if (result.truth->face.at(10, j) == result.truth->face.at(10, 570)) {
                EXPECT_NEAR(p.z(), tread.frontM, 0.002);
            }
            seen.insert(object);
        }
        EXPECT_EQ(seen.size(), treads.size()) << distanceM;
        for (const double step : {50.0, 80.0, 120.0, 200.0, 300.0, 500.0})
            EXPECT_EQ(std::ranges::count(treads, step, &StaircaseTread::stepMm), 1) << step;
        const EdgeTruth truth = edgeTruth(*result.truth);
        for (int j = 240; j < 900; ++j) { // every step that is scored is one edge between the two cells next to it
            const int a = result.truth->object.at(10, j);
            const int b = result.truth->object.at(10, j + 1);
            if (a == b || a == 0 || b == 0) continue;
            const double step = treads[static_cast<std::size_t>(std::max(a, b) - kFirstRock)].stepMm;
            const bool occluding = truth.edgeClass.at(10, j) == 1 || truth.edgeClass.at(10, j + 1) == 1;
            EXPECT_EQ(occluding, step >= 50.0) << distanceM << ' ' << step;
        }
    }
}

TEST(SimSweep, WallIsFlatUnlessItsRoughnessIsGiven) {
    SimulationSettings settings = perfect("wall");
    const auto spread = [&](std::optional<double> roughness) {
        settings.wallRoughnessMm = roughness;
        const Simulation result = swept(settings);
        const CartesianTables tables(result.scan);
        double squares = 0;
        int count = 0;
        for (int i = 20; i < 40; ++i) {
            for (int j = 30; j < 50; ++j, ++count) squares += std::pow(1000.0 * tables.point(i, j).z() - 6000.0, 2);
        }
        return std::sqrt(squares / count);
    };
    EXPECT_LT(spread({}), 1.0);
    EXPECT_LT(spread(0.0), 1.0);
    const double rough = spread(20.0);
    EXPECT_GT(rough, 5.0);
    EXPECT_NEAR(spread(40.0) / rough, 2.0, 0.1);
}

// Connected groups of cells without a return.
int voidsOf(const Scan& scan) {
    Grid<std::uint8_t> left(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < left.size(); ++k) left[k] = scan.state[k] != CellState::Valid;
    int voids = 0;
    for (int i = 0; i < left.lines; ++i) {
        for (int j = 0; j < left.beams; ++j) {
            if (left.at(i, j) == 0) continue;
            ++voids;
            std::vector<std::pair<int, int>> open{{i, j}};
            while (!open.empty()) {
                const auto [a, b] = open.back();
                open.pop_back();
                if (!left.contains(a, b) || left.at(a, b) == 0) continue;
                left.at(a, b) = 0;
                for (const auto& [da, db] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) open.emplace_back(a + da, b + db);
            }
        }
    }
    return voids;
}

TEST(SimSweep, AWallHasAsManyHolesAsAskedForWhereTheSeedSays) {
    for (const int holes : {2, 5, 9}) {
        for (const WallHole hole : {WallHole::Round, WallHole::Square}) {
            SimulationSettings settings = perfect("wall");
            settings.lines = 300;
            settings.beams = 320;
            settings.hole = hole;
            settings.holes = holes;
            settings.holeM = 1.4;
            const WallShape shape{6.0, hole, holes, 1.4};
            const auto centres = wallHoles(shape, settings.seed);
            ASSERT_TRUE(centres);
            const Simulation result = swept(settings);
            const CartesianTables tables(result.scan);
            Scan middle = result.scan;
            for (int i = 0; i < 300; ++i) {
                for (int j = 0; j < 320; ++j) {
                    const Eigen::Vector3d d = tables.direction(i, j);
                    const Eigen::Vector2d p = d.head<2>() * (6.0 / d.z());
                    if (d.z() < 0.1 || p.cwiseAbs().maxCoeff() > 17.0) { // past the wall
                        middle.state.at(i, j) = CellState::Valid;
                        continue;
                    }
                    bool inside = false;
                    bool rim = false;
                    for (const Eigen::Vector2d& centre : *centres) {
                        const Eigen::Vector2d q = p - centre;
                        const double reach = hole == WallHole::Round ? q.norm() : q.cwiseAbs().maxCoeff();
                        inside = inside || reach < 0.7;
                        rim = rim || std::abs(reach - 0.7) < 0.01;
                    }
                    if (!rim) {
                        EXPECT_EQ(result.scan.state.at(i, j) == CellState::Valid, !inside) << p.transpose();
                    }
                }
            }
            EXPECT_EQ(voidsOf(middle), holes);
            EXPECT_EQ(*wallHoles(shape, settings.seed), *centres);
            EXPECT_NE(*wallHoles(shape, settings.seed + 1), *centres);
        }
    }
    SimulationSettings full = small("wall");
    full.hole = WallHole::Round;
    full.holes = 100;
    const auto refused = simulate(full);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("no room for so many holes"), std::string::npos);
}

TEST(SimSweep, SettingsAreWrittenWithTheMeasuresOfTheScene) {
    SimulationSettings settings = small("wall");
    settings.hole = WallHole::Square;
    settings.holes = 3;
    const nlohmann::json wall = settingsJson(settings);
    EXPECT_EQ(wall["hole_centres_m"].size(), 3U);
    EXPECT_EQ(wall["hole_count"], 3);
    EXPECT_EQ(wall["wall_roughness_mm"], 0.0);
    settings.scene = "staircase";
    settings.distanceM = 3.0;
    const nlohmann::json stairs = settingsJson(settings);
    ASSERT_EQ(stairs["treads"].size(), 9U);
    EXPECT_EQ(stairs["treads"][0]["front_m"], 3.0);
    EXPECT_EQ(stairs["treads"][1]["step_mm"], 20.0);
    EXPECT_NEAR(stairs["treads"][2]["front_m"].get<double>(), 3.07, 1e-9);
    EXPECT_EQ(stairs["wall_roughness_mm"], 30.0);
    settings.surfaceFile = "rocks.ply";
    settings.surfaceScale = 4.0;
    EXPECT_EQ(settingsJson(settings)["surface"], "rocks.ply");
    EXPECT_EQ(settingsJson(settings)["surface_scale"], 4.0);
}

TEST(SimSweep, WallHoleIsAVoidOfItsSize) {
    for (const WallHole hole : {WallHole::Round, WallHole::Square}) {
        SimulationSettings settings = perfect("wall");
        settings.lines = 180;
        settings.beams = 191;
        settings.hole = hole;
        const Simulation result = swept(settings);
        const CartesianTables tables(result.scan);
        for (int i = 45; i < 135; ++i) {
            for (int j = 50; j < 140; ++j) {
                const Eigen::Vector3d d = tables.direction(i, j);
                const Eigen::Vector2d p = 6.0 * d.head<2>() / d.z();
                const double reach = hole == WallHole::Round ? p.norm() : p.cwiseAbs().maxCoeff();
                if (std::abs(reach - 1.0) < 0.01) continue;
                EXPECT_EQ(result.scan.state.at(i, j) == CellState::Valid, reach > 1.0) << p.transpose();
            }
        }
    }
}

TEST(SimSweep, HangupFillsTheMiddleOfThePicture) {
    SimulationSettings settings = perfect("hangup");
    settings.lines = 200;
    settings.beams = 228;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        settings.seed = seed;
        const Simulation result = swept(settings);
        std::map<int, int> visible;
        int middle = 0;
        for (int i = 60; i < 140; ++i)
            for (int j = 70; j < 158; ++j) middle += result.truth->object.at(i, j) > 1 ? 1 : 0;
        for (const auto object : result.truth->object.cells) ++visible[object];
        EXPECT_GT(middle, 80 * 88 * 7 / 10) << seed;
        EXPECT_GT(visible.size(), 150U) << seed;
        EXPECT_EQ(result.truth->rocks.size(), 504U);
    }
}

TEST(SimSweep, AScannedCloudHangsOverTheScannerWithItsHighestPointNearest) {
    SimulationSettings settings = perfect("rescan");
    settings.surface = steps();
    const Simulation result = swept(settings);
    const CartesianTables tables(result.scan);
    for (std::size_t k = 0; k < result.scan.cells(); ++k) {
        const Eigen::Vector3d point = tables.point(k);
        if (result.scan.state[k] != CellState::Valid || point.head<2>().cwiseAbs().maxCoeff() > 19.0) continue;
        EXPECT_GT(point.z(), settings.distanceM - 0.002);
        EXPECT_LT(point.z(), settings.distanceM + 1.002);
    }
    settings.surface.clear();
    EXPECT_EQ(simulate(settings).error().sentence(),
              "simulate: the scene \"rescan\" has no surface to scan; give a cloud of points with --surface.");
}

TEST(SimSweep, StatusCodesAreNoRanges) {
    SimulationSettings settings = small("wall");
    settings.statusCodes = 0.1;
    const Simulation result = swept(settings);
    const auto counts = countCells(result.scan);
    const auto status = counts[static_cast<std::size_t>(CellState::DeviceStatus)];
    EXPECT_NEAR(static_cast<double>(status), 0.1 * static_cast<double>(result.scan.cells()),
                0.02 * static_cast<double>(result.scan.cells()));
    EXPECT_EQ(result.scan.statusCodes.size(), 1U);
}

TEST(SimSweep, NonsenseIsRefusedInOneSentence) {
    const auto sentence = [](auto change) {
        SimulationSettings settings = small("hangup");
        change(settings);
        const auto result = simulate(settings);
        return result ? std::string() : result.error().sentence();
    };
    EXPECT_EQ(sentence([](auto& s) { s.scene = "moon"; }),
              "simulate: there is no scene \"moon\"; use one of hangup, pile, empty, wall, staircase, rescan.");
    EXPECT_EQ(sentence([](auto& s) { s.lines = 1; }), "simulate: lines is 1; use 2 to 100000.");
    EXPECT_NE(sentence([](auto& s) { s.beams = 100001; }), "");
    EXPECT_NE(sentence([](auto& s) { s.lines = s.beams = 100000; }), "");
    EXPECT_NE(sentence([](auto& s) { s.noise = std::nan(""); }), "");
    EXPECT_NE(sentence([](auto& s) { s.rocks = -1; }), "");
    EXPECT_EQ(sentence([](auto& s) { s.rocks = 0; }), "");
}

TEST(SimSweep, ProgressRisesAndCancels) {
    double last = 0.0;
    const auto watched = simulate(small("wall"), [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    });
    EXPECT_TRUE(watched);
    EXPECT_DOUBLE_EQ(last, 1.0);
    const auto cancelled = simulate(small("wall"), [](double) { return false; });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().what, "cancelled");
}

} // namespace
} // namespace edgescan::sim
