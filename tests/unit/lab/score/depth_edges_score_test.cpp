// Ground truth, score, and EdgeScan+, which measures surfaces relative to straight lines in inverse range.
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/scan/angle_correction/interlace.h"
#include "tests/support/depth_edges.h"
#include "tests/support/scans.h"
#include "tests/support/scored_scene.h"
#include "tests/support/scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace edgescan::lab {
namespace {

sim::Simulation simulated(const char* scene, std::uint64_t seed, int lines = 250, int beams = 286) {
    return test::scoredScene(scene, seed, lines, beams);
}

std::size_t countOf(const sim::EdgeTruth& truth, sim::EdgeClass wanted) {
    return static_cast<std::size_t>(
        std::count(truth.edgeClass.cells.begin(), truth.edgeClass.cells.end(), static_cast<std::uint8_t>(wanted)));
}

TEST(EdgeTruth, AWallHasNoEdgeAndABellHasAllKinds) {
    const sim::Simulation wall = simulated("wall", 3);
    const sim::EdgeTruth none = sim::edgeTruth(*wall.truth);
    for (const sim::EdgeClass c : {sim::EdgeClass::Occluding, sim::EdgeClass::Contact, sim::EdgeClass::Crease})
        EXPECT_EQ(countOf(none, c), 0U);
    const sim::Simulation bell = simulated("hangup", 3);
    const sim::EdgeTruth all = sim::edgeTruth(*bell.truth);
    for (const sim::EdgeClass c : {sim::EdgeClass::Occluding, sim::EdgeClass::Contact, sim::EdgeClass::Crease})
        EXPECT_GT(countOf(all, c), 100U);
}

TEST(EdgeScore, TheTruthItselfIsPerfectAndNothingFindsNothing) {
    const sim::Simulation bell = simulated("hangup", 4);
    const sim::EdgeTruth truth = sim::edgeTruth(*bell.truth);
    Grid<std::uint8_t> mask(bell.scan.lines(), bell.scan.beams());
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = truth.edgeClass[k] != 0 ? 255 : 0;
    const EdgeScore perfect = test::scoreEdges(mask, truth, 2);
    EXPECT_EQ(perfect.all.f(), 1.0);
    EXPECT_EQ(perfect.crease.f(), 1.0);
    EXPECT_LT(perfect.strictOutline.precision(), 1.0); // creases do not belong to the outline
    const EdgeScore nothing = test::scoreEdges(Grid<std::uint8_t>(mask.lines, mask.beams), truth, 2);
    EXPECT_EQ(nothing.all.recall(), 0.0);
    EXPECT_EQ(nothing.all.f(), 0.0);
}

TEST(EdgeScore, FalseAlarmsCountOnlyWhereTheyAreScored) {
    sim::EdgeTruth truth{Grid<std::uint8_t>(20, 20), Grid<std::uint8_t>(20, 20)};
    for (int j = 2; j < 18; ++j) truth.edgeClass.at(5, j) = static_cast<std::uint8_t>(sim::EdgeClass::Occluding);
    Grid<std::uint8_t> mask(20, 20);
    for (int j = 2; j < 18; ++j) mask.at(6, j) = 255; // one line next to the truth
    mask.at(15, 3) = mask.at(15, 10) = 255;
    truth.ignore.at(15, 10) = 255;
    const EdgeScore score = test::scoreEdges(mask, truth, 2);
    EXPECT_EQ(score.occluding.found, 16U);
    EXPECT_EQ(score.occluding.false_, 1U);
    EXPECT_EQ(test::scoreEdges(mask, truth, 0.5).occluding.found, 0U);
}

TEST(DepthEdges, FindMoreOfTheRocksThanGrayLevelsDo) {
    EdgeScore depth;
    EdgeScore gray;
    for (const char* scene : {"hangup", "pile"}) {
        const sim::Simulation bell = simulated(scene, 21);
        const sim::EdgeTruth truth = sim::edgeTruth(*bell.truth);
        depth += test::scoreEdges(test::depthEdges(bell.scan, {}).mask, truth, 2);
        gray += test::scoreEdges(*edges::detectEdges(std::make_shared<Scan>(bell.scan), edges::cannySettings())->mask, truth, 2);
    }
    std::printf("all edges, 286 x 250: depth edges F %.3f, gray levels F %.3f\n", depth.all.f(), gray.all.f());
    EXPECT_GT(depth.all.f(), gray.all.f() + 0.15);
    EXPECT_GT(depth.all.recall(), 0.75);
}

TEST(DepthEdges, AFlatWallWithDropOutsHasNoneAndItsOpeningHasARim) {
    const PolarGeometry polar = test::regularAngles(200, 320);
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, 6.0);
    const Scan wall = test::makeScan(200, 320, [&](int i, int j) {
        const bool hole = (i > 40 && i < 90 && j > 50 && j < 150) || random() % 100 < 5;
        return hole ? 0.0 : test::wallRangeMm(polar, i, j, 5000.0) + std::round(noise(random));
    });
    const edges::DepthEdges edges = test::depthEdges(wall, {});
    const auto cells = std::count(edges.mask.cells.begin(), edges.mask.cells.end(), 255);
    EXPECT_EQ(std::count(edges.kind.cells.begin(), edges.kind.cells.end(), edges::DepthEdge::VoidRim), cells);
    EXPECT_NEAR(static_cast<double>(cells), 2 * (49 + 99), 30);
    for (int i = 0; i < wall.lines(); ++i) {
        for (int j = 0; j < wall.beams(); ++j) {
            if (i < 38 || i > 92 || j < 48 || j > 152) {
                EXPECT_EQ(edges.mask.at(i, j), 0) << i << " " << j;
            }
        }
    }
}

TEST(DepthEdges, GoRoundALostRangeByItsNeighbours) {
    // A plate in front of a wall; one range of its edge is lost.
    Scan scan = test::makeScan(30, 40, [&](int, int j) { return j < 20 ? 3000.0 : 5000.0; });
    EXPECT_EQ(test::depthEdges(scan, {}).mask.at(10, 19), 255);
    scan.state.at(10, 19) = CellState::NoReturn;
    scan.rangeMm.at(10, 19) = 0;
    const edges::DepthEdges edges = test::depthEdges(scan, {});
    EXPECT_EQ(edges.mask.at(10, 19), 0);
    EXPECT_EQ(edges.mask.at(10, 18), 255);
    EXPECT_EQ(edges.kind.at(10, 18), edges::DepthEdge::Jump);
    for (int i = 2; i < 28; ++i) {
        int cells = 0;
        for (int j = 0; j < 40; ++j) cells += edges.mask.at(i, j) != 0 ? 1 : 0;
        EXPECT_EQ(cells, 1) << i;
    }
}

TEST(DepthEdges, RandomDropOutsCostLittle) {
    sim::SimulationSettings settings;
    settings.seed = 22;
    settings.lines = 250;
    settings.beams = 286;
    settings.truth = true;
    std::array<double, 2> f{};
    for (const double dropouts : {0.002, 0.15}) {
        settings.dropouts = dropouts;
        const sim::Simulation bell = *sim::simulate(settings);
        f[dropouts > 0.1 ? 1 : 0] = test::scoreEdges(test::depthEdges(bell.scan, {}).mask, sim::edgeTruth(*bell.truth), 2).all.f();
    }
    std::printf("all edges, 286 x 250: F %.3f, with 15 %% drop-outs %.3f\n", f[0], f[1]);
    EXPECT_GT(f[1], f[0] - 0.03);
}

TEST(DepthEdges, DecidingAgainGivesTheResultOfMeasuringAgain) {
    const sim::Simulation bell = simulated("pile", 23, 120, 150);
    edges::Settings settings;
    const edges::DepthResponses responses = test::depthResponses(bell.scan, settings);
    settings.sensitivity = 1.4;
    settings.hysteresisPercent = 50;
    settings.minimumLength = 7;
    settings.classes &= ~edges::kClassConvex;
    const edges::DepthEdges decided = edges::decideDepthEdges(responses, settings);
    const edges::DepthEdges whole = test::depthEdges(bell.scan, settings);
    EXPECT_EQ(decided.mask, whole.mask);
    EXPECT_EQ(decided.kind, whole.kind);
    EXPECT_EQ(std::count(whole.kind.cells.begin(), whole.kind.cells.end(), edges::DepthEdge::Convex), 0);
}

// Single echoes 50 to 150 mm in front of a wall or behind it; and a post two cells wide, which remains. An echo is recognised because it is
// farther from all eight around it than they are from each other. Where the wall slants so much that these differ by more than an echo, it
// is not, and the four cells around it are a chain of the minimum length 4 (a length of 5 would drop it, and much else of true edges).
TEST(DepthEdges, DustCloseToAWallIsNone) {
    constexpr int kLines = 200, kBeams = 320;
    constexpr double kLeastEchoMm = 50.0, kNoiseMm = 5.0;
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, kNoiseMm);
    const auto slants = [&](int i, int j) {
        const double here = test::wallRangeMm(polar, i, j, 5000.0);
        const int aside = j < kBeams / 2 ? -1 : 1, away = i < kLines / 2 ? -1 : 1;
        return test::wallRangeMm(polar, std::clamp(i + away, 0, kLines - 1), std::clamp(j + aside, 0, kBeams - 1), 5000.0) - here >
               0.3 * kLeastEchoMm; // twice that from one corner of the nine cells to the other, and noise
    };
    for (const bool post : {false, true}) {
        int echoes = 0;
        const Scan wall = test::makeScan(kLines, kBeams, [&](int i, int j) {
            const bool echo = i % 3 == 1 && j % 3 == 1 && random() % 44 == 0; // never two next to each other
            const double dust = echo ? kLeastEchoMm + static_cast<double>(random() % 100) : 0.0;
            const bool atPost = post && (j == 160 || j == 161);
            echoes += echo ? 1 : 0;
            return test::wallRangeMm(polar, i, j, 5000.0) + std::round(noise(random)) + (i % 2 == 0 ? dust : -dust) -
                   (atPost ? 300.0 : 0.0);
        });
        EXPECT_GT(echoes, 100);
        const edges::DepthEdges edges = test::depthEdges(wall, {});
        int beside = 0, elsewhere = 0, onSlant = 0, facing = 0;
        for (int i = 0; i < kLines; ++i) {
            for (int j = 0; j < kBeams; ++j) {
                facing += slants(i, j) ? 0 : 1;
                if (edges.mask.at(i, j) != 0) ++(std::abs(j - 160) < 6 ? beside : slants(i, j) ? onSlant : elsewhere);
            }
        }
        EXPECT_GT(2 * facing, kLines * kBeams);
        EXPECT_EQ(elsewhere, 0);
        EXPECT_LE(onSlant, echoes / 9) << "of " << echoes << " echoes";
        EXPECT_EQ(beside > 150, post) << beside;
    }
}

// A floor seen at a grazing angle, measured with odd beams half a line ahead, and with one stepper step of three times the length.
Scan slopedFloor(double parityDeg, int longStepAfter) {
    constexpr int kLines = 80;
    const PolarGeometry polar = test::regularAngles(kLines, 160);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 3.0);
    return test::makeScan(kLines, 160, [&](int i, int j) {
        const double extra = longStepAfter >= 0 && i > longStepAfter ? 0.5 : 0.0;
        const double line = 50.0 + 0.25 * i + extra + (j % 2 == 1 ? parityDeg : 0.0);
        const double p = line * std::numbers::pi / 180;
        const double a = polar.beamDeg[static_cast<std::size_t>(j)] * std::numbers::pi / 180;
        return std::round(2000.0 / (std::sin(a) * std::cos(p)) + noise(random));
    });
}

TEST(Interlace, BeamsFromTwoPassesAreDetectedAndStraightened) {
    InverseRange even = inverseRange(slopedFloor(0.0, -1));
    const SweepSlips nothing = straighten(even);
    EXPECT_FALSE(nothing.interlaced);
    EXPECT_EQ(nothing.slipCount, 0);

    const Scan floor = slopedFloor(0.125, -1);
    InverseRange combed = inverseRange(floor);
    const SweepSlips slips = straighten(combed);
    EXPECT_TRUE(slips.interlaced);
    for (int i = 5; i + 5 < floor.lines(); ++i) EXPECT_NEAR(slips.parity[static_cast<std::size_t>(i)], 0.5, 0.12) << i;
    const edges::DepthEdges edges = test::depthEdges(floor, {});
    EXPECT_EQ(std::count(edges.mask.cells.begin(), edges.mask.cells.end(), 255), 0);
}

TEST(Interlace, ASlipOfTheStepperIsNoEdge) {
    const Scan floor = slopedFloor(0.0, 40);
    InverseRange slipped = inverseRange(floor);
    const SweepSlips slips = straighten(slipped);
    EXPECT_FALSE(slips.interlaced);
    for (const std::vector<float>& extra : slips.remaining) EXPECT_NEAR(extra[40], 2.0, 0.3);
    const edges::DepthEdges edges = test::depthEdges(floor, {});
    EXPECT_EQ(std::count(edges.mask.cells.begin(), edges.mask.cells.end(), 255), 0);
}

TEST(Interlace, AStallAndTheLeapAfterItAreNoEdges) {
    // Three lines at one angle; then the stepper makes up for it, exactly or with an excess.
    const Scan floor = slopedFloor(0.0, -1);
    for (const int made : {3, 6}) {
        Scan stalled = floor;
        for (int i = 31; i + 3 < floor.lines(); ++i) {
            const int from = i < 34 ? 30 : i + made - 3;
            for (int j = 0; j < floor.beams(); ++j) stalled.rangeMm.at(i, j) = floor.rangeMm.at(std::min(from, floor.lines() - 1), j);
        }
        InverseRange inverse = inverseRange(stalled);
        const SweepSlips slips = straighten(inverse);
        for (std::size_t parity = 0; parity < 2; ++parity) {
            for (std::size_t i = 30; i < 33; ++i) EXPECT_NEAR(slips.measured[parity][i], -1.0, 0.15) << i;
            EXPECT_NEAR(slips.measured[parity][33], made, 0.25 * made);
            const float left = *std::max_element(slips.remaining[parity].begin() + 25, slips.remaining[parity].begin() + 45);
            EXPECT_NEAR(left, made - 3, 0.35 * made);
        }
        const edges::DepthEdges edges = test::depthEdges(stalled, {});
        int cells = 0;
        for (int i = 20; i < 50; ++i)
            for (int j = 0; j < floor.beams(); ++j) cells += edges.mask.at(i, j) != 0 ? 1 : 0;
        EXPECT_EQ(cells, 0) << made;
    }
}

TEST(DepthEdges, NoiseIsFoundFromTheScanItself) {
    for (const double sigma : {4.0, 12.0}) {
        const PolarGeometry polar = test::regularAngles(150, 200);
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0.0, sigma);
        const Scan wall =
            test::makeScan(150, 200, [&](int i, int j) { return test::wallRangeMm(polar, i, j, 5000.0) + std::round(noise(random)); });
        EXPECT_NEAR(rangeNoise(inverseRange(wall)).at(5.0), sigma, 0.15 * sigma);
    }
}

// A board in front of a wall, ranges without noise.
Scan boardBeforeWall(double distanceMm, double thicknessMm) {
    const PolarGeometry polar = test::regularAngles(100, 120);
    return test::makeScan(100, 120, [&](int i, int j) {
        const bool board = i >= 30 && i < 70 && j >= 40 && j < 80;
        const double a = polar.beamDeg[static_cast<std::size_t>(j)] * std::numbers::pi / 180;
        const double p = polar.lineDeg[static_cast<std::size_t>(i)] * std::numbers::pi / 180;
        return (distanceMm - (board ? thicknessMm : 0.0)) / (std::sin(a) * std::cos(p));
    });
}

TEST(DepthEdges, QuietScansFindSmallerJumpsWherePointsAreCloser) {
    // One step of 0.25 degrees is 4.4 mm at 1 m, 21.8 mm at 5 m.
    const Scan near = boardBeforeWall(1000.0, 25.0);
    const Scan far = boardBeforeWall(5000.0, 25.0);
    EXPECT_NEAR(pointSpacingMm(inverseRange(near), angularSteps(near)), 4.4, 0.3);
    EXPECT_NEAR(pointSpacingMm(inverseRange(far), angularSteps(far)), 21.8, 1.0);
    EXPECT_NEAR(test::depthResponses(near, {}).jumpMm, 8.7, 0.6);
    EXPECT_NEAR(test::depthResponses(far, {}).jumpMm, 21.0, 0.1);
    const auto jumps = [](const Scan& scan) {
        const edges::DepthEdges edges = test::depthEdges(scan, {});
        return std::count(edges.kind.cells.begin(), edges.kind.cells.end(), edges::DepthEdge::Jump);
    };
    EXPECT_NEAR(static_cast<double>(jumps(near)), 156.0, 8.0); // the rim of 40 x 40 cells
    EXPECT_EQ(jumps(far), 0);
}

TEST(DepthEdges, SpacingOfAnEmptyScanIsNothing) {
    const Scan empty = test::makeScan(20, 30, [](int, int) { return 0.0; });
    EXPECT_EQ(pointSpacingMm(inverseRange(empty), angularSteps(empty)), 0.0);
    const edges::DepthEdges edges = test::depthEdges(empty, {});
    EXPECT_EQ(std::count(edges.mask.cells.begin(), edges.mask.cells.end(), 255), 0);
}

} // namespace
} // namespace edgescan::lab
