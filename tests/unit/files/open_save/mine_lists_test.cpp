// Points in mine coordinates without a record: their lines turn about an axis of any direction, and the mirror is off it.
#include "core/files/open_save/check_measured.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/rotations.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/point_round_trip.h"
#include "tests/support/save_clouds.h"
#include "tests/support/scored_scene.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct Bell {
    Axis axis = Axis::Sweep;
    std::uint64_t seed = 1;
    int lines = 150, beams = 191;
    const char* scene = "hangup";
    double turnDeg = 180;
    double gridScale = 1.0;
};

/// A simulated draw-bell with a place in the mine; its mounting differs from the ideal one.
Scan placedBell(const Bell& bell) {
    sim::SimulationSettings settings;
    settings.scene = bell.scene;
    settings.seed = bell.seed;
    settings.lines = bell.lines;
    settings.beams = bell.beams;
    settings.axis = bell.axis;
    settings.turnDeg = bell.turnDeg;
    Scan scan = sim::simulate(settings)->scan;
    auto placement = std::make_shared<Placement>(*randomPlacement(static_cast<unsigned>(bell.seed), 1, bell.axis == Axis::Sweep));
    placement->gridScale = bell.gridScale;
    scan.placement = placement;
    return scan;
}

Result<Scan> opened(const std::string& bytes, const char* extension, const ReadingOptions& options = {}) {
    return readScanBytes(std::as_bytes(std::span(bytes)), extension, options);
}

std::size_t otherRanges(const Scan& scan, const Scan& back) {
    std::size_t other = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        other += scan.state[k] != back.state[k] ? 1 : 0;
        other += scan.state[k] == CellState::Valid && back.state[k] == CellState::Valid && scan.rangeMm[k] != back.rangeMm[k] ? 1 : 0;
    }
    return other;
}

std::size_t otherEdges(const Scan& scan, const Scan& back) {
    const auto mask = maskOf(scan), other = maskOf(back);
    std::size_t count = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) count += (*mask)[k] != (*other)[k] ? 1 : 0;
    return count;
}

bool says(const std::vector<std::string>& sentences, const char* words) {
    return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(words) != std::string::npos; });
}

/// As PCL writes it again: without our comments.
std::string withoutComments(const std::string& pcd) {
    const std::size_t data = pcd.find("DATA binary\n");
    std::string header;
    std::istringstream lines(pcd.substr(0, data));
    for (std::string line; std::getline(lines, line);)
        header += line.starts_with("# edgescan") || line.starts_with("# EdgeScan") ? "" : line + "\n";
    return header + pcd.substr(data);
}

} // namespace

TEST(MineList, ComesBackAsTheSameScanFromEveryMountingSceneAndFormat) {
    const std::vector<Bell> bells{{Axis::Sweep, 1},
                                  {Axis::Spin, 2},
                                  {Axis::Spin, 4, 220, 143},
                                  {Axis::Sweep, 5, 97, 381, "pile"},
                                  {Axis::Spin, 7, 90, 286, "empty", 120},
                                  {Axis::Sweep, 8, 130, 240, "hangup", 100}};
    for (const Bell& bell : bells) {
        const Scan scan = placedBell(bell);
        for (const RoundTrip& trip : {RoundTrip{.format = "xyz", .decimals = 4}, RoundTrip{.format = "csv", .decimals = 4, .thinned = 0.3},
                                      RoundTrip{.format = "ply", .decimals = 9}, RoundTrip{.format = "las", .decimals = 3}}) {
            SCOPED_TRACE(std::string(trip.format) + " seed " + std::to_string(bell.seed));
            RoundTrip placed = trip;
            placed.frame = CoordinateFrame::Mine;
            const CameBack back = roundTrip(scan, placed);
            ASSERT_EQ(back.problem, "");
            EXPECT_EQ(back.lost, 0U);
            EXPECT_EQ(back.moved, 0U);
            EXPECT_LE(back.lines, scan.lines());
            if (trip.decimals > 3)
                EXPECT_EQ(back.differ, 0U);
            else
                EXPECT_LE(back.differ, 3 * back.differRounded + 5); // coordinates are rounded in three directions, ranges in one
        }
    }
}

TEST(MineList, FourByteFloatsAboutAnOriginComeBackToo) {
    for (const Bell& bell : {Bell{Axis::Sweep, 10}, Bell{Axis::Spin, 11}}) {
        const Scan scan = placedBell(bell);
        const CameBack back = roundTrip(scan, {.format = "pcd", .decimals = 9, .frame = CoordinateFrame::MineLocal});
        ASSERT_EQ(back.problem, "");
        EXPECT_EQ(back.lost, 0U);
        EXPECT_EQ(back.differ, 0U);
    }
}

TEST(MineList, TheScaleOfTheGridIsFound) {
    for (const Bell& bell : {Bell{Axis::Sweep, 27, 150, 191, "hangup", 180, 0.9996}, Bell{Axis::Spin, 28, 150, 191, "pile", 180, 1.0003}}) {
        const Scan scan = placedBell(bell);
        for (const char* format : {"xyz", "ply"}) {
            const CameBack back = roundTrip(scan, {.format = format, .decimals = format[0] == 'x' ? 4 : 9, .frame = CoordinateFrame::Mine});
            ASSERT_EQ(back.problem, "");
            EXPECT_EQ(back.lost, 0U);
            EXPECT_EQ(back.moved, 0U);
            EXPECT_EQ(back.differ, 0U);
            EXPECT_TRUE(says(back.warnings, "the grid has the scale"));
        }
    }
}

TEST(MineList, AMisfitThatRoundingDoesNotExplainIsReported) {
    Scan scan = placedBell({Axis::Sweep, 29});
    auto placement = std::make_shared<Placement>(*scan.placement);
    placement->poses.resize(static_cast<std::size_t>(scan.lines()), placement->poses.front());
    for (std::size_t i = 0; i < placement->poses.size(); ++i)
        placement->poses[i].translationM.z() += 0.002 * std::sin(0.4 * static_cast<double>(i));
    scan.placement = placement;
    const WrittenPoints written = writtenPoints(scan, {.decimals = 4, .frame = CoordinateFrame::Mine});
    const auto back = opened(pointText(written.points, 4), ".xyz");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_TRUE(says(back->warnings, "more than the rounding of the numbers explains"));
}

TEST(MineList, PointsWithoutSizeBeyondAnyReachAreRefusedWhateverTheirFormat) {
    const ScanShape shape{.lines = 20, .beams = 20, .beamStart = 90, .beamStep = 0.01, .lineStep = 0.01, .nearest = 5e5};
    EXPECT_TRUE(checkMeasured(makeScan(shape), "near"));
    ScanShape far = shape;
    far.nearest = 5e6;
    const auto refused = checkMeasured(makeScan(far), "far");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("--sensor"), std::string::npos) << refused.error().sentence();
}

TEST(MineList, TheFoundPlacePutsEachPointWhereTheFileHasIt) {
    for (const Bell& bell : {Bell{Axis::Sweep, 13}, Bell{Axis::Spin, 14}}) {
        const Scan scan = placedBell(bell);
        const WrittenPoints written = writtenPoints(scan, {.decimals = 4, .frame = CoordinateFrame::Mine});
        const auto back = opened(pointText(written.points, 4), ".xyz");
        ASSERT_TRUE(back) << back.error().sentence();
        ASSERT_TRUE(back->placement);
        ASSERT_EQ(back->cells(), scan.cells());
        for (std::size_t n = 0; n < written.cell.size(); ++n)
            EXPECT_LT((minePoint(*back, written.cell[n]).enhM - written.points[n]).norm(), 2e-4);
        EXPECT_TRUE(says(back->warnings, "The points are in another frame than the scanner's"));
    }
}

TEST(MineList, ACsvWithLinesBeamsAndRangesNeedsNoRecord) {
    for (const Bell& bell : {Bell{Axis::Sweep, 16}, Bell{Axis::Spin, 17}}) {
        const Scan scan = placedBell(bell);
        const auto bytes = cloudBytes(scan, "cloud.csv", nullptr, {.frame = CoordinateFrame::Mine});
        ASSERT_TRUE(bytes);
        const auto back = opened(*bytes, ".csv");
        ASSERT_TRUE(back) << back.error().sentence();
        ASSERT_EQ(back->lines(), scan.lines());
        ASSERT_EQ(back->beams(), scan.beams());
        EXPECT_EQ(otherRanges(scan, *back), 0U);
        EXPECT_EQ(otherEdges(scan, *back), 0U);
    }
}

TEST(MineList, PointsInAnyOrderAreRefusedOrProjectedWithTheReason) {
    const Scan scan = placedBell({Axis::Sweep, 19});
    const WrittenPoints written = writtenPoints(scan, {.decimals = 4, .shuffled = true, .frame = CoordinateFrame::Mine});
    const auto back = opened(pointText(written.points, 4), ".xyz");
    ASSERT_FALSE(back);
    EXPECT_NE(back.error().sentence().find("do not follow each other in scan lines"), std::string::npos) << back.error().sentence();
    EXPECT_NE(back.error().sentence().find("--sensor"), std::string::npos);
}

TEST(MinePcd, ViewpointIsTheSensorInTheNumbersOfThePoints) {
    const Scan scan = placedBell({Axis::Spin, 20});
    const auto bytes = cloudBytes(scan, "cloud.pcd", nullptr, {.frame = CoordinateFrame::Mine});
    ASSERT_TRUE(bytes);
    const PlacedPoints placed(scan);
    const Eigen::Vector3d sensor = placed.local(0, 0, Eigen::Vector3d::Zero());
    std::istringstream viewpoint(bytes->substr(bytes->find("\nVIEWPOINT ") + 11));
    for (int axis = 0; axis < 3; ++axis) {
        double value = 0;
        viewpoint >> value;
        EXPECT_NEAR(value, sensor[axis], 1e-9);
    }
    EXPECT_NE(bytes->find("# edgescan-origin 620000 6200000 250 "), std::string::npos);
    // What is read is in the mine grid, sensor and all.
    ReadingOptions projected;
    projected.projection = Projection::Always;
    const auto whole = opened(*bytes, ".pcd", projected);
    ASSERT_TRUE(whole) << whole.error().sentence();
    EXPECT_LT((std::get<PointGeometry>(whole->geometry).sensorM - placed.originEnhM() - sensor).norm(), 1e-6);
}

TEST(MinePcd, SavedAgainByPclItOpensAsTheSameScan) {
    for (const Bell& bell : {Bell{Axis::Sweep, 22}, Bell{Axis::Spin, 23}}) {
        const Scan scan = placedBell(bell);
        const auto bytes = cloudBytes(scan, "cloud.pcd", nullptr, {.frame = CoordinateFrame::Mine});
        ASSERT_TRUE(bytes);
        for (const std::string& pcd : {*bytes, withoutComments(*bytes)}) {
            const auto back = opened(pcd, ".pcd");
            ASSERT_TRUE(back) << back.error().sentence();
            ASSERT_EQ(back->cells(), scan.cells());
            EXPECT_EQ(otherRanges(scan, *back), 0U);
            EXPECT_EQ(otherEdges(scan, *back), 0U);
        }
    }
}

TEST(MinePcd, AViewpointThatIsNoSensorIsNotUsed) {
    const Scan scan = placedBell({Axis::Sweep, 25});
    for (const bool shuffled : {false, true}) {
        const WrittenPoints written = writtenPoints(scan, {.decimals = 9, .shuffled = shuffled, .frame = CoordinateFrame::MineLocal});
        std::string pcd = pointPcd(written.points);
        pcd.replace(pcd.find("VIEWPOINT 0 0 0"), 15, "VIEWPOINT 620000 6200000 250");
        const auto back = opened(pcd, ".pcd");
        ASSERT_EQ(static_cast<bool>(back), !shuffled);
        if (shuffled) {
            EXPECT_NE(back.error().sentence().find("no scanner measures so"), std::string::npos) << back.error().sentence();
            EXPECT_NE(back.error().sentence().find("--sensor"), std::string::npos);
        } else {
            EXPECT_EQ(back->cells(), scan.cells());
            EXPECT_TRUE(says(back->warnings, "no scanner measures so"));
        }
    }
}
