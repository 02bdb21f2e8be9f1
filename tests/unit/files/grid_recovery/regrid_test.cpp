// Clouds without a grid are put onto one as seen from their sensor, and every point is accounted for.
#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/files/grid_recovery/regrid.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/point_files.h"
#include "tests/support/point_lists.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <set>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// Random directions over a window; a ball in front of a wall.
std::vector<Eigen::Vector3d> ballBeforeWall(std::size_t count, const Eigen::Vector3d& sensor, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<Eigen::Vector3d> points;
    while (points.size() < count) {
        const Eigen::Vector3d d = Eigen::Vector3d(1, 0.5 * unit(random), 0.4 * unit(random)).normalized();
        const Eigen::Vector3d centre(4, 0, 0);
        const double b = d.dot(centre);
        const double under = b * b - centre.squaredNorm() + 0.64;
        points.push_back(sensor + d * (under > 0 ? b - std::sqrt(under) : 8 / d.x()));
    }
    return points;
}

std::string asPly(const std::vector<Eigen::Vector3d>& points) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (const auto& p : points)
        text += numberText("%.12g", p.x()) + " " + numberText("%.12g", p.y()) + " " + numberText("%.12g", p.z()) + "\n";
    return text;
}

Result<Scan> readText(const std::string& text, const char* extension, const ReadingOptions& options) {
    return readScanBytes(std::as_bytes(std::span(text)), extension, options);
}

bool anyHolds(const std::vector<std::string>& sentences, const std::string& part) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const auto& s) { return s.find(part) != std::string::npos; });
}

std::filesystem::path shared(const char* name) { return edgescan::test::sharedFolder() / "data" / name; }

} // namespace

TEST(Regrid, EveryPointIsInACellOrAttachedToANearerOne) {
    const Eigen::Vector3d sensor(100, -20, 3);
    const auto points = ballBeforeWall(40000, sensor, 3);
    const auto grid = regrid({points, sensor, {}, {}});
    ASSERT_TRUE(grid) << grid.error().sentence();
    EXPECT_EQ(grid->filled + grid->hidden.size() + grid->outside, points.size());
    EXPECT_EQ(grid->outside, 0U);
    std::set<std::uint32_t> seen;
    for (const std::uint32_t point : grid->pointOf.cells) {
        if (point != Regridded::kNoPoint) {
            EXPECT_TRUE(seen.insert(point).second);
        }
    }
    for (std::size_t n = 0; n < grid->hidden.size(); ++n) {
        const auto [cell, point] = grid->hidden[n];
        EXPECT_TRUE(seen.insert(point).second);
        if (n > 0) {
            EXPECT_LE(grid->hidden[n - 1].cell, cell);
        }
        ASSERT_NE(grid->pointOf[cell], Regridded::kNoPoint);
        EXPECT_LE((points[grid->pointOf[cell]] - sensor).norm(), (points[point] - sensor).norm());
    }
    EXPECT_EQ(seen.size(), points.size());
    EXPECT_GT(grid->closed, 0.85);
    EXPECT_GT(grid->fillRatio(), 0.8);
    EXPECT_NEAR(grid->nearest, 3.2, 0.01);
}

TEST(Regrid, TheStepFollowsTheSpacingNotTheCountOrTheBounds) {
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    auto points = ballBeforeWall(30000, origin, 4);
    const auto one = regrid({points, origin, {}, {}});
    // The same directions a second time, farther away: twice the points, the same spacing.
    auto doubled = points;
    for (const auto& p : points) doubled.push_back(p * 1.5);
    const auto two = regrid({doubled, origin, {}, {}});
    // A few stray points in all directions: a window ten times as large.
    auto strays = points;
    for (int i = 0; i < 6; ++i) strays.push_back(5 * Eigen::Vector3d(-1, 0.1 * i, 0.5 - 0.2 * i).normalized());
    const auto three = regrid({strays, origin, {}, {}});
    ASSERT_TRUE(one && two && three);
    EXPECT_NEAR(two->beamStepDeg, one->beamStepDeg, 0.15 * one->beamStepDeg);
    EXPECT_NEAR(three->beamStepDeg, one->beamStepDeg, 0.15 * one->beamStepDeg);
    EXPECT_EQ(three->outside, 6U);
    EXPECT_EQ(two->hidden.size(), one->hidden.size() + points.size());
    const auto given = regrid({points, origin, 2.0, {}});
    ASSERT_TRUE(given);
    EXPECT_DOUBLE_EQ(given->beamStepDeg, 2.0);
}

TEST(Regrid, ASpinningScannersRingsStayItsLines) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Eigen::Vector3d> points;
    for (int ring = 0; ring < 16; ++ring) {
        const double elevation = (-15 + 2 * ring) * 3.14159265358979 / 180;
        for (int n = 0; n < 900; ++n) {
            const double azimuth = (n + 0.3 * unit(random)) * 0.4 * 3.14159265358979 / 180;
            const double range = 5 + std::sin(3 * azimuth) + unit(random) * 0.01;
            points.push_back(range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                                     std::sin(elevation)));
        }
    }
    std::shuffle(points.begin(), points.end(), random);
    const auto grid = regrid({points, Eigen::Vector3d::Zero(), {}, {}});
    ASSERT_TRUE(grid) << grid.error().sentence();
    EXPECT_TRUE(grid->fan);
    EXPECT_EQ(grid->pointOf.lines, 16);
    EXPECT_NEAR(grid->lineStepDeg, 2.0, 0.01);
    EXPECT_NEAR(grid->beamStepDeg, 0.5, 0.25);
    EXPECT_EQ(grid->filled + grid->hidden.size(), points.size());
}

TEST(Regrid, WrongPlacesAreFoundByNumbers) {
    const Eigen::Vector3d sensor = Eigen::Vector3d::Zero();
    const auto points = ballBeforeWall(5000, sensor, 6);
    const auto far = regrid({points, Eigen::Vector3d(5000, 0, 0), {}, {}});
    ASSERT_FALSE(far);
    EXPECT_NE(far.error().what.find("5000 points lie in one direction"), std::string::npos) << far.error().sentence();
    const auto fine = regrid({points, sensor, 0.001, {}});
    ASSERT_FALSE(fine);
    EXPECT_NE((fine.error().what + fine.error().hint).find("--grid-step"), std::string::npos) << fine.error().sentence();
    EXPECT_FALSE(regrid({points, sensor, -1.0, {}}));
    EXPECT_FALSE(regrid({points, sensor, std::nan(""), {}}));
    EXPECT_FALSE(regrid({}));
    const std::vector<Eigen::Vector3d> same(1000, Eigen::Vector3d(1, 2, 3));
    EXPECT_FALSE(regrid({same, sensor, {}, {}}));
    EXPECT_FALSE(regrid({same, same[0], {}, {}}));
}

TEST(Regrid, OpenedCloudsKeepTheirPointsAndReportTheNumbers) {
    const Eigen::Vector3d sensor(620100.5, 6200050.25, 300);
    const auto points = ballBeforeWall(20000, sensor, 7);
    ReadingOptions options;
    options.sensorM = sensor;
    const auto scan = readText(asPly(points), ".ply", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto& geometry = std::get<PointGeometry>(scan->geometry);
    EXPECT_EQ(geometry.sensorM, sensor);
    const auto counts = countCells(*scan);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), scan->cells());
    EXPECT_EQ(counts[0] + scan->attached.size(), points.size());
    EXPECT_TRUE(anyHolds(scan->warnings, "20000 points in"));
    EXPECT_TRUE(anyHolds(scan->warnings, "fill ratio"));
    EXPECT_TRUE(anyHolds(scan->warnings, std::to_string(scan->attached.size()) + " points attached"));
    for (std::size_t k = 0; k < scan->cells(); ++k) {
        if (scan->state[k] != CellState::Valid) continue;
        EXPECT_NEAR(scan->rangeMm[k], (geometry.pointsM[k] - sensor).norm() * 1000, 1e-2);
    }
    options.projection = Projection::Never;
    EXPECT_FALSE(readText(asPly(points), ".ply", options));
}

TEST(Regrid, ExportsCanCarryTheAttachedPoints) {
    const auto points = ballBeforeWall(20000, Eigen::Vector3d::Zero(), 8);
    const auto scan = readText(asPly(points), ".ply", {});
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(anyHolds(scan->warnings, "the origin, because no sensor position is known"));
    Grid<std::uint8_t> mask(scan->lines(), scan->beams());
    std::size_t edges = 0;
    for (std::size_t k = 0; k < mask.size(); k += 2) {
        mask[k] = 255;
        edges += scan->state[k] == CellState::Valid ? 1 : 0;
    }
    for (const AttachedPoint& point : scan->attached) edges += mask[point.cell] != 0 ? 1 : 0;
    SaveOptions save;
    save.includeAttached = true;
    const auto rows = [](const Result<std::string>& bytes) {
        return bytes ? static_cast<std::size_t>(std::count(bytes->begin(), bytes->end(), '\n')) - 1 : 0;
    };
    EXPECT_EQ(rows(cloudBytes(*scan, "cloud.csv", &mask, save)), points.size());
    EXPECT_EQ(rows(edgeBytes(*scan, mask, "edges.csv", save)), edges);
    EXPECT_EQ(rows(cloudBytes(*scan, "cloud.csv", &mask)), countCells(*scan)[0]);
}

TEST(Regrid, LinesStoredTwiceAndShuffledAreRecoveredAndReported) {
    ScanShape shape;
    shape.motorJitter = 0.5;
    shape.beamStart = 20;
    const Scan expected = makeScan(shape);
    const ListStyle style{.shuffled = true, .dropped = 0.2, .keepMissing = false, .doubledLines = true};
    const auto points = listOf(expected, style);
    const auto scan = readText(textOf(points, style), ".xyz", {});
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), shape.lines);
    EXPECT_EQ(scan->beams(), shape.beams);
    EXPECT_EQ(countCells(*scan)[0], points.size() / 2);
    EXPECT_TRUE(anyHolds(scan->warnings, std::to_string(points.size() / 2) + " points stood in the list before"));
    EXPECT_TRUE(anyHolds(scan->warnings, "40 lines x 60 beams were recovered"));
    EXPECT_TRUE(anyHolds(scan->warnings, "line angles are uneven"));
    EXPECT_TRUE(scan->attached.empty());
}

// A list as survey programs store it, of rocks from a place that is not the scanner's.
TEST(Regrid, ASimulatedRockPileFromAGivenPlaceGivesSensibleEdges) {
    sim::SimulationSettings pile;
    pile.lines = 400;
    pile.beams = 400;
    const auto points = listOf(sim::simulate(pile)->scan, {.shuffled = true, .dropped = 0.3, .keepMissing = false});
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
                        "\nproperty double x\nproperty double y\nproperty double z\nproperty float scalar_class\nend_header\n";
    for (const Eigen::Vector3d& p : points) {
        for (const double v : {p.x(), p.y(), p.z()}) appendValue(bytes, v);
        appendValue(bytes, 2.0F);
    }
    ReadingOptions options;
    options.sensorM = Eigen::Vector3d(0.4, -0.3, -0.5);
    auto scan = readText(bytes, ".ply", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_GT(countCells(*scan)[0], points.size() / 6);
    EXPECT_EQ(countCells(*scan)[0] + scan->attached.size(), points.size());
    EXPECT_TRUE(anyHolds(scan->warnings, std::to_string(points.size()) + " points in"));
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*scan)), edges::cannySettings());
    const double share = static_cast<double>(detection->edges->size()) / static_cast<double>(countCells(*detection->scan)[0]);
    EXPECT_GT(share, 0.02) << "outlines: neither empty nor speckle";
    EXPECT_LT(share, 0.25);
}

TEST(Regrid, BouldersFromAGivenPlaceGiveSensibleEdges) {
    EDGESCAN_NEEDS_SHARED("data/otira_rocks");
    ReadingOptions options;
    options.sensorM = Eigen::Vector3d(23.5, 10, -6); // five metres above and six in front of the river bed
    auto scan = openScan(shared("otira_rocks/Otira_1cm_grains.ply"), options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_GT(countCells(*scan)[0], 15000U);
    EXPECT_EQ(countCells(*scan)[0] + scan->attached.size(), 100769U);
    EXPECT_TRUE(anyHolds(scan->warnings, "100769 points in"));
    const auto detection = edges::detectEdges(std::make_shared<const Scan>(std::move(*scan)), edges::cannySettings());
    const double share = static_cast<double>(detection->edges->size()) / static_cast<double>(countCells(*detection->scan)[0]);
    EXPECT_GT(share, 0.02); // outlines: neither empty nor speckle
    EXPECT_LT(share, 0.15);
}

TEST(Regrid, ASensorFarAwayIsInMetresWhateverTheNumbersOfTheFileAre) {
    // A quarry from the air: farther than a scanner's reach, with coordinates of a survey grid, in metres and in millimetres.
    const Eigen::Vector3d sensor(512766, 5403705, 1900);
    auto points = ballBeforeWall(20000, Eigen::Vector3d::Zero(), 9);
    for (Eigen::Vector3d& p : points) p = sensor + 180 * Eigen::Vector3d(p.z(), p.y(), -p.x());
    ReadingOptions options;
    options.sensorM = sensor;
    const auto metres = readText(asPly(points), ".ply", options);
    ASSERT_TRUE(metres) << metres.error().sentence();
    EXPECT_NEAR(rangeLimits(*metres).maxMm, 180 * 8 * 1.2 * 1000, 180 * 8 * 0.3 * 1000);
    EXPECT_TRUE(anyHolds(metres->warnings, "Unit taken as metres")) << metres->warnings.front();
    for (Eigen::Vector3d& p : points) p *= 1000;
    const auto millimetres = readText(asPly(points), ".ply", options);
    ASSERT_TRUE(millimetres) << millimetres.error().sentence();
    EXPECT_TRUE(anyHolds(millimetres->warnings, "Unit taken as millimetres"));
    EXPECT_NEAR(rangeLimits(*millimetres).maxMm, rangeLimits(*metres).maxMm, 2);
}

TEST(Regrid, RealCloudsOpenProjectedOrSayWhyNot) {
    EDGESCAN_NEEDS_SHARED("data/traps");
    const auto livox = openScan(shared("traps/livox_bin_unorganized.pcd"));
    ASSERT_TRUE(livox) << livox.error().sentence();
    EXPECT_EQ(countCells(*livox)[0] + livox->attached.size(), 227143U);
    const auto airborne = openScan(shared("traps/airborne_utm_float32.pcd"));
    ASSERT_FALSE(airborne);
    for (const char* part : {"38010 points", "in one direction", "resolution of about 0.5", "--sensor"})
        EXPECT_NE(airborne.error().sentence().find(part), std::string::npos) << airborne.error().sentence();
    ReadingOptions above;
    above.sensorM = Eigen::Vector3d(512766, 5403705, 1000);
    const auto fromAbove = openScan(shared("traps/airborne_utm_float32.pcd"), above);
    ASSERT_TRUE(fromAbove) << fromAbove.error().sentence();
    EXPECT_TRUE(anyHolds(fromAbove->warnings, "have a resolution of about 0.5"));
    above.sensorM = Eigen::Vector3d(512766, 5403705, 2600); // farther than a scanner's reach: nevertheless metres
    const auto fromHigh = openScan(shared("traps/airborne_utm_float32.pcd"), above);
    ASSERT_TRUE(fromHigh) << fromHigh.error().sentence();
    EXPECT_LT(rangeLimits(*fromHigh).maxMm, 5e6F);
}
