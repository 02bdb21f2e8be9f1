// Edges matched between two scans of one place: compared with an exhaustive search, with an object in front, and with approximate poses.
#include "app/lab/repeatability/repeatability.h"
#include "app/lab/sim/simulate.h"
#include "core/inspect/registration/scan_alignment.h"
#include "tests/support/point_lists.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace edgescan;
using namespace edgescan::lab;
using namespace edgescan::test;

namespace {

std::shared_ptr<const Scan> bell(int lines, int beams, std::uint64_t seed) {
    sim::SimulationSettings settings;
    settings.lines = lines;
    settings.beams = beams;
    settings.seed = seed;
    auto simulation = sim::simulate(settings);
    EXPECT_TRUE(simulation);
    return std::make_shared<const Scan>(std::move(simulation->scan));
}

RigidTransform moved(double deg, const Eigen::Vector3d& axis, const Eigen::Vector3d& shiftM) {
    return {Eigen::AngleAxisd(deg * std::numbers::pi / 180, axis.normalized()).toRotationMatrix(), shiftM};
}

Grid<std::uint8_t> someCells(const Scan& scan, double share, unsigned seed) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    for (std::uint8_t& cell : mask.cells) cell = static_cast<double>(random() % 1000) < 1000 * share ? 255 : 0;
    return mask;
}

/// The same by comparing every pair.
RepeatCount byForce(const inspect::PlacedScan& a, const Grid<std::uint8_t>& maskA, const inspect::PlacedScan& b,
                    const Grid<std::uint8_t>& maskB, double radiusM) {
    RepeatCount count;
    const auto oneWay = [&](const inspect::PlacedScan& from, const Grid<std::uint8_t>& mask, const inspect::PlacedScan& to,
                            const Grid<std::uint8_t>& other) {
        for (std::size_t k = 0; k < mask.size(); ++k) {
            const Eigen::Vector3d& p = from.pointsM[k];
            if (mask[k] == 0 || !p.allFinite()) continue;
            ++count.edges;
            double best = 9, range = 0;
            bool found = false;
            for (std::size_t n = 0; n < to.pointsM.size(); ++n) {
                const Eigen::Vector3d& q = to.pointsM[n];
                if (!q.allFinite()) continue;
                const double off = ((q - to.sensorM).normalized() - (p - to.sensorM).normalized()).norm();
                if (off < best) best = off, range = (q - to.sensorM).norm();
                found = found || (other[n] != 0 && (q - p).norm() <= radiusM);
            }
            if (best > 1.5 * to.stepRad || range < (p - to.sensorM).norm() - 2 * radiusM) continue;
            ++count.visible;
            count.found += found ? 1 : 0;
        }
    };
    oneWay(a, maskA, b, maskB);
    oneWay(b, maskB, a, maskA);
    return count;
}

} // namespace

TEST(Repeat, CountsAsASearchThroughEverythingDoes) {
    const auto scan = bell(40, 50, 3);
    const auto other = bell(36, 44, 3);
    const inspect::PlacedScan a = inspect::placedBy(scan, {});
    for (const double shift : {0.0, 0.4}) {
        const inspect::PlacedScan b = inspect::placedBy(other, moved(2, {1, 2, 3}, {shift, 0.1, -shift}));
        const Grid<std::uint8_t> maskA = someCells(*scan, 0.2, 5);
        const Grid<std::uint8_t> maskB = someCells(*other, 0.3, 6);
        for (const double radius : {0.05, 0.2}) {
            const RepeatCount count = RepeatCounter(a, b, radius).count(maskA, maskB);
            const RepeatCount expected = byForce(a, maskA, b, maskB, radius);
            EXPECT_EQ(count.edges, expected.edges);
            EXPECT_EQ(count.visible, expected.visible);
            EXPECT_EQ(count.found, expected.found);
            EXPECT_GT(count.found, 0U);
            EXPECT_LT(count.visible, count.edges);
        }
    }
}

TEST(Repeat, WhatIsHiddenFromTheOtherIsNotHeldAgainstAnybody) {
    // A far wall; in the other scan there is a near board in front of its left half.
    const auto scanOf = [](bool board) {
        return std::make_shared<const Scan>([&] {
            Scan scan = makeScan(ScanShape{.lines = 30, .beams = 40, .noReturns = 0});
            for (std::size_t k = 0; k < scan.cells(); ++k) scan.rangeMm[k] = board && k % 40 < 20 ? 2000.0F : 8000.0F;
            return scan;
        }());
    };
    const auto open = scanOf(false);
    const auto blocked = scanOf(true);
    const inspect::PlacedScan a = inspect::placedBy(open, {}), b = inspect::placedBy(blocked, {});
    Grid<std::uint8_t> mask(30, 40);
    for (int line = 5; line < 25; ++line) mask.at(line, 8) = mask.at(line, 30) = 255;
    const RepeatCount count = RepeatCounter(a, b, 0.05).count(mask, Grid<std::uint8_t>(30, 40));
    EXPECT_EQ(count.edges, 40U);
    EXPECT_EQ(count.visible, 20U);
    EXPECT_EQ(count.found, 0U);
}

TEST(Repeat, RoughPosesAreRefinedAndTheResidualReported) {
    const auto scan = bell(160, 200, 7);
    const RigidTransform off = moved(1.0, {3, -1, 2}, {0.08, -0.05, 0.06});
    const inspect::PlacedScan fixed = inspect::placedBy(scan, {});
    const inspect::PlacedScan rough = inspect::placedBy(scan, off);
    const auto aligned = inspect::alignScans(fixed, rough, 0.5);
    ASSERT_TRUE(aligned) << aligned.error().sentence();
    EXPECT_LT(aligned->residualM, 0.2 * aligned->residualBeforeM);
    const RigidTransform left = aligned->correction * off;
    EXPECT_LT(Eigen::AngleAxisd(left.rotation).angle() * 180 / std::numbers::pi, 0.05);
    EXPECT_LT((left * Eigen::Vector3d(0, 0, 5) - Eigen::Vector3d(0, 0, 5)).norm(), 0.005); // at the rocks
}

TEST(Repeat, SurfacesLieAsFarApartAsTheirNoise) {
    // Dense scans: the nearest points in space are those with the same noise, and their distance would be far less than the noise.
    for (const double noise : {1.0}) {
        std::array<inspect::PlacedScan, 2> scans;
        for (int n = 0; n < 2; ++n) {
            sim::SimulationSettings settings;
            settings.lines = 400;
            settings.beams = 460;
            settings.seed = 9;
            settings.repeat = n;
            settings.noise = noise;
            auto simulation = sim::simulate(settings);
            ASSERT_TRUE(simulation);
            scans[static_cast<std::size_t>(n)] = inspect::placedBy(std::make_shared<const Scan>(std::move(simulation->scan)), {});
        }
        const auto aligned = inspect::alignScans(scans[0], scans[1], 0.5);
        ASSERT_TRUE(aligned) << aligned.error().sentence();
        // Median of |N(0, sigma)| is 0.67 sigma; on a slanted surface it is less.
        const double sigmaM = 0.001 * noise * 7;
        EXPECT_GT(aligned->residualM, 0.35 * sigmaM) << noise;
        EXPECT_LT(aligned->residualM, 1.5 * 0.67 * sigmaM) << noise;
    }
}

TEST(Repeat, AWallHoldsNothingAlongItself) {
    sim::SimulationSettings settings;
    settings.lines = 80;
    settings.beams = 90;
    settings.scene = "wall";
    auto simulation = sim::simulate(settings);
    ASSERT_TRUE(simulation);
    const auto scan = std::make_shared<const Scan>(std::move(simulation->scan));
    const auto aligned =
        inspect::alignScans(inspect::placedBy(scan, {}), inspect::placedBy(scan, moved(0.1, {0, 0, 1}, {0.01, 0, 0})), 0.3);
    ASSERT_FALSE(aligned);
    EXPECT_NE(aligned.error().what.find("do not hold"), std::string::npos) << aligned.error().sentence();
}

TEST(Repeat, PosesOf3dtkAreMirroredLikeTheirScans) {
    const Folder folder;
    writeText(folder / "a.pose", "100 -200 300\n0 90 0\n");
    const auto pose = inspect::open3dtkPose(folder / "a.pose");
    ASSERT_TRUE(pose) << pose.error().sentence();
    // Left-handed: x right, y up, z forward. 90 degrees about y takes forward to right; only y changes its sign between the two worlds.
    EXPECT_LT((*pose * Eigen::Vector3d(0, 0, 1) - Eigen::Vector3d(2, 2, 3)).norm(), 1e-12);
    EXPECT_LT((*pose * Eigen::Vector3d(0, 1, 0) - Eigen::Vector3d(1, 3, 3)).norm(), 1e-12);
    for (const char* text : {"1 2 3", "1 2 3 4 5 6 7", "1 2 3 4 5 nan", "a b c d e f", ""}) {
        writeText(folder / "b.pose", text);
        EXPECT_FALSE(inspect::open3dtkPose(folder / "b.pose")) << text;
    }
}

TEST(Repeat, EveryMethodIsComparedAtEqualNumbers) {
    const auto scan = bell(100, 120, 11);
    const auto again = bell(90, 130, 11);
    ComparisonSettings settings;
    settings.only = {"kirsch", "edgescan+", "sobel"};
    settings.repeats = 1;
    settings.withPcl = false;
    const auto rows = methodRepeatability(inspect::placedBy(scan, {}), inspect::placedBy(again, {}), 0.15, settings);
    ASSERT_EQ(rows.size(), 3U);
    std::size_t ours = 0;
    for (const MethodRepeatability& row : rows) {
        if (row.key == "edgescan+") ours = row.withFixedSettings.edges;
        EXPECT_GT(row.withFixedSettings.found, 0U) << row.key;
        EXPECT_LE(row.withFixedSettings.found, row.withFixedSettings.visible);
    }
    for (const MethodRepeatability& row : rows) {
        ASSERT_TRUE(row.atEqual) << row.key;
        EXPECT_NEAR(static_cast<double>(row.atEqual->edges), static_cast<double>(ours), 0.1 * static_cast<double>(ours)) << row.key;
    }
}
