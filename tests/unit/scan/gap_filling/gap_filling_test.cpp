// Filled gaps: how each is filled, which gaps stay, and that other results change only on request.
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/scan/gap_filling/gap_filling.h"

#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/provenance.h"
#include "core/scan/gap_filling/plane_in_u.h"
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"
#include "tests/support/scans.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace edgescan {
namespace {

constexpr int kLines = 60, kBeams = 80;

bool inHole(int i, int j) { return i >= 25 && i < 31 && j >= 30 && j < 37; }

/// Exact ranges of a wall, 5 m away.
double exactWall(const PolarGeometry& polar, int i, int j) {
    const double a = polar.beamDeg[static_cast<std::size_t>(j)] * std::numbers::pi / 180;
    const double p = polar.lineDeg[static_cast<std::size_t>(i)] * std::numbers::pi / 180;
    return 5000.0 / (std::sin(a) * std::cos(p));
}

template <class Hole>
Scan wallWith(Hole hole) {
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    return test::makeScan(kLines, kBeams, [&](int i, int j) { return hole(i, j) ? 0.0 : exactWall(polar, i, j); });
}

TEST(Gaps, APlaneRoundAHoleFillsItToTwoMillimetres) {
    const Scan scan = wallWith(inHole);
    const GapFilling filling = fillGaps(scan, 8);
    ASSERT_EQ(filling.cells.size(), 6U * 7U);
    EXPECT_EQ(filling.byPlane, filling.cells.size());
    EXPECT_EQ(filling.gaps, 1U);
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    for (const FilledCell& cell : filling.cells) {
        const int i = static_cast<int>(cell.cell) / kBeams, j = static_cast<int>(cell.cell) % kBeams;
        EXPECT_TRUE(inHole(i, j)); // u is linear to step^2 u for a fan
        EXPECT_NEAR(cell.rangeMm, exactWall(polar, i, j), 2.0) << i << " " << j;
        EXPECT_GT(cell.sdMm, 0.0F);
    }
    EXPECT_TRUE(std::ranges::is_sorted(filling.cells, {}, &FilledCell::cell));
    EXPECT_EQ(filling.at(0), nullptr);
    EXPECT_EQ(filling.at(filling.cells[3].cell), &filling.cells[3]);
    EXPECT_TRUE(fillGaps(scan, 0).cells.empty());
}

// Sides of a hole at 3 and at 5 m: the position of the outline between them is unknown.
TEST(Gaps, NothingIsFilledAcrossAJump) {
    const Scan scan = test::makeScan(kLines, kBeams, [](int i, int j) { return inHole(i, j) ? 0.0 : j < 33 ? 3000.0 : 5000.0; });
    const GapFilling filling = fillGaps(scan, 8);
    EXPECT_EQ(filling.byPlane, 0U);
    for (const FilledCell& cell : filling.cells) {
        const int j = static_cast<int>(cell.cell) % kBeams;
        EXPECT_EQ(cell.rangeMm, j < 33 ? 3000.0F : 5000.0F); // along the lines both ends are on one surface
        EXPECT_EQ(cell.by, FilledBy::Line);
    }
}

TEST(Gaps, WhatIsTooLargeAtTheBorderOrTakenOutStays) {
    EXPECT_TRUE(fillGaps(wallWith([](int i, int j) { return i >= 20 && i < 32 && j >= 20 && j < 32; }), 8).cells.empty());
    EXPECT_TRUE(fillGaps(wallWith([](int i, int j) { return i < 4 && j >= 20 && j < 24; }), 8).cells.empty());
    EXPECT_TRUE(fillGaps(wallWith([](int i, int) { return i == 20; }), 8).cells.empty());
    for (const CellState state : {CellState::Masked, CellState::OutOfWindow}) {
        Scan scan = wallWith(inHole);
        scan.state.at(27, 33) = state;
        EXPECT_TRUE(fillGaps(scan, 8).cells.empty());
    }
    Scan lost = wallWith(inHole);
    lost.state.at(27, 33) = CellState::Lost;
    EXPECT_EQ(fillGaps(lost, 8).cells.size(), 6U * 7U);
}

// Dust between the gap and the border of the grid: there is no end behind it.
TEST(Gaps, DustAtTheBorderIsNoEnd) {
    Scan scan = wallWith([](int i, int j) { return i == 1 && j >= 30 && j < 33; });
    for (int j = 29; j < 34; ++j) scan.rangeMm.at(0, j) = j % 2 == 0 ? 500.0F : 20000.0F;
    for (const FilledCell& cell : fillGaps(scan, 8).cells) EXPECT_NEAR(cell.rangeMm, 5000.0, 100.0);
}

// Least squares with equal weights, by Eigen.
TEST(Gaps, ThePlaneIsThatOfLeastSquaresAndItsLeverageToo) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-4, 4), noise(-1e-4, 1e-4);
    std::vector<RingCell> ring;
    for (int n = 0; n < 40; ++n) {
        const double x = place(random), y = place(random);
        ring.push_back({x, y, 0.2 + 0.003 * x - 0.002 * y + noise(random)});
    }
    const auto plane = fitPlaneInU(ring, 1.0); // all deviations are below the noise: weights differ by less than 1e-7
    ASSERT_TRUE(plane);
    Eigen::MatrixXd a(40, 3);
    Eigen::VectorXd b(40);
    for (int n = 0; n < 40; ++n) {
        const RingCell& cell = ring[static_cast<std::size_t>(n)];
        a.row(n) << 1, cell.beams, cell.lines;
        b[n] = cell.u;
    }
    const Eigen::Vector3d best = a.colPivHouseholderQr().solve(b);
    EXPECT_NEAR(plane->u0, best[0], 1e-9);
    EXPECT_NEAR(plane->alongBeams, best[1], 1e-9);
    EXPECT_NEAR(plane->alongLines, best[2], 1e-9);
    const Eigen::Vector3d at(1, 2.5, -1.5);
    EXPECT_NEAR(plane->leverage(2.5, -1.5), at.dot((a.transpose() * a).inverse() * at), 1e-5);
    ring.resize(6);
    EXPECT_FALSE(fitPlaneInU(ring, 1.0));
    std::vector<RingCell> line;
    for (int n = 0; n < 12; ++n) line.push_back({1.0 * n, 2.0 * n, 0.2});
    EXPECT_FALSE(fitPlaneInU(line, 1.0));
}

std::shared_ptr<const Scan> pile() {
    sim::SimulationSettings settings;
    settings.scene = "pile";
    settings.seed = 401;
    settings.lines = 250;
    settings.beams = 286;
    settings.dropouts = 0.05;
    return std::make_shared<const Scan>(sim::simulate(settings)->scan);
}

TEST(Gaps, EdgesAndNoiseAreTheSameUnlessFilledCellsAreToTakePart) {
    const auto scan = pile();
    const auto plain = edges::detectEdges(scan, edges::Settings{});
    edges::Settings settings;
    settings.fillCells = 8;
    const auto filled = edges::detectEdges(scan, settings);
    ASSERT_TRUE(filled->filled);
    EXPECT_GT(filled->filled->cells.size(), 1000U);
    EXPECT_EQ(*filled->mask, *plain->mask);
    EXPECT_EQ(*filled->classes, *plain->classes);
    settings.fillEdges = true;
    const auto taken = edges::detectEdges(scan, settings);
    EXPECT_EQ(taken->responses->noise.at(5.0), plain->responses->noise.at(5.0));
    EXPECT_NE(*taken->mask, *plain->mask);
    for (const std::uint32_t k : *taken->edges) EXPECT_TRUE(scan->state[k] == CellState::Valid || taken->filled->at(k) != nullptr);
    // The same in a pipeline that had run with other settings before.
    edges::Pipeline pipeline;
    for (const bool edges : {true, false, true}) {
        settings.fillEdges = edges;
        EXPECT_EQ(*pipeline.run(scan, settings)->mask, edges ? *taken->mask : *plain->mask);
    }
}

TEST(Gaps, VoidsStayVoids) {
    sim::SimulationSettings settings;
    settings.scene = "wall";
    settings.hole = sim::WallHole::Round;
    settings.holes = 4;
    settings.holeM = 2.0; // of 26 cells: a hole as small as a gap that is filled looks like lost cells
    settings.lines = 250;
    settings.beams = 286;
    settings.truth = true;
    const sim::Simulation wall = *sim::simulate(settings);
    for (const FilledCell& cell : fillGaps(wall.scan, 8).cells) EXPECT_NE(wall.truth->object[cell.cell], 0);
}

TEST(Gaps, ExportsHoldNoFilledCellUnlessAskedAndThenMarkIt) {
    edges::Settings settings;
    settings.fillCells = 8;
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(wallWith(inHole)), settings);
    const auto rowsOf = [&](const exports::ExportOptions& options) {
        const auto files = exports::exportFiles(exports::ExportContent::FullCloud, *detection, "cloud.csv", "", options);
        EXPECT_TRUE(files) << files.error().sentence();
        return files ? files->front().bytes : std::string();
    };
    const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
    const std::string plain = rowsOf({});
    EXPECT_EQ(plain.find("filled"), std::string::npos);
    exports::ExportOptions options;
    options.choices.filled = true;
    const std::string with = rowsOf(options);
    EXPECT_EQ(lines(with), lines(plain) + 6 * 7);
    EXPECT_NE(with.find("filled_sd_mm"), std::string::npos);
    const auto record = nlohmann::json::parse(exports::exportRecord(exports::ExportContent::FullCloud, *detection, options));
    EXPECT_EQ(record["filled"]["cells"], 6 * 7);
    EXPECT_EQ(record["filled"]["in_export"], true);
    EXPECT_FALSE(exports::exportFiles(exports::ExportContent::FullCloud, *detection, "cloud.xyz", "", options));
    EXPECT_FALSE(exports::exportFiles(exports::ExportContent::FullCloud, *detection, "cloud.las", "", options));
    // Opened again they are not measured cells.
    for (const char* extension : {".csv", ".pcd", ".ply"}) {
        const auto files =
            exports::exportFiles(exports::ExportContent::FullCloud, *detection, std::string("cloud") + extension, "", options);
        ASSERT_TRUE(files) << files.error().sentence();
        const auto back = test::readBytes(files->front().bytes, extension);
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_EQ(countCells(*back)[0], countCells(*detection->scan)[0]) << extension;
        const auto isTold = [](const std::string& w) { return w.starts_with("42 points were filled"); };
        EXPECT_EQ(std::ranges::count_if(back->warnings, isTold), 1);
        // Next to its sidecar, which also holds the grid.
        const test::Folder folder;
        const auto path = folder / (std::string("cloud") + extension);
        ASSERT_TRUE(exports::exportWithProvenance(exports::ExportContent::FullCloud, *detection, path, options));
        const auto beside = files::openScan(path);
        ASSERT_TRUE(beside) << beside.error().sentence();
        EXPECT_EQ(beside->state, detection->scan->state) << extension;
        EXPECT_EQ(std::ranges::count_if(beside->warnings, isTold), 1);
    }
    const auto without = edges::detectEdges(detection->scan, edges::Settings{});
    EXPECT_FALSE(exports::exportFiles(exports::ExportContent::FullCloud, *without, "cloud.csv", "", options));
}

} // namespace
} // namespace edgescan
