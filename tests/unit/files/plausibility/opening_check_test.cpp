// Evidence against a reading: rooms seen with wrong mounting, angles and units, and a room read correctly.
#include "core/files/plausibility/opening_check.h"

#include "core/files/grid_recovery/regrid.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/plausibility/common_planes.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/shared_folder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace edgescan::files {
namespace {

/// A room of 8 x 6 x 5 m with flat walls, oblique to the scanner (a wall across the axis looks the same for every step); each beam ends on
/// the nearest wall.
Scan room(Axis axis, double lineStepDeg) {
    Scan scan;
    PolarGeometry polar;
    polar.axis = axis;
    for (int j = 0; j < 120; ++j) polar.beamDeg.push_back(30.0 + j);
    for (int i = 0; i < 120; ++i) polar.lineDeg.push_back(-60.0 + i * lineStepDeg);
    scan.geometry = polar;
    scan.rangeMm = Grid<float>(120, 120);
    scan.state = Grid<CellState>(120, 120, CellState::Valid);
    const CartesianTables tables(scan);
    const Eigen::Matrix3d aslant = Eigen::AngleAxisd(0.6, Eigen::Vector3d(1.0, 0.7, 0.3).normalized()).toRotationMatrix();
    const Eigen::Vector3d far(4.2, 3.1, 2.6), near(-3.8, -2.9, -2.4);
    for (int i = 0; i < 120; ++i) {
        for (int j = 0; j < 120; ++j) {
            const Eigen::Vector3d way = aslant * tables.direction(i, j);
            double range = 1e9;
            for (int a = 0; a < 3; ++a) {
                if (way[a] != 0.0) range = std::min(range, (way[a] > 0 ? far[a] : near[a]) / way[a]);
            }
            scan.rangeMm.at(i, j) = static_cast<float>(std::round(range * 1000.0));
        }
    }
    return scan;
}

const OpeningPoint& pointOf(const std::vector<OpeningPoint>& points, const std::string& what) {
    return *std::ranges::find_if(points, [&](const OpeningPoint& point) { return point.what == what; });
}

} // namespace

TEST(OpeningCheck, NothingSpeaksAgainstARoomAsItIs) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        const auto points = openingCheck(room(axis, 1.0), {});
        EXPECT_FALSE(looksWrong(points)) << pointOf(points, "Mounting").against.text() << pointOf(points, "Line angles").against.text();
        EXPECT_FALSE(looksGuessed(points));
    }
}

TEST(OpeningCheck, AWrongMountingBendsWallsAndTheOtherOneIsOffered) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        Scan scan = room(axis, 1.0);
        const Axis wrong = axis == Axis::Spin ? Axis::Sweep : Axis::Spin;
        std::get<PolarGeometry>(scan.geometry).axis = wrong;
        const OpeningPoint mounting = pointOf(openingCheck(scan, {}), "Mounting");
        EXPECT_FALSE(mounting.against.empty());
        ASSERT_EQ(mounting.others.size(), 1u);
        EXPECT_EQ(mounting.others.front().options.axis, axis);
    }
}

TEST(OpeningCheck, AWrongSpanBendsWallsAndTheTrueStepComesFirst) {
    Scan scan = room(Axis::Spin, 1.0);
    auto& lines = std::get<PolarGeometry>(scan.geometry).lineDeg;
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = -60.0 + 0.5 * static_cast<double>(i);
    const OpeningPoint angles = pointOf(openingCheck(scan, {}), "Line angles");
    EXPECT_FALSE(angles.against.empty());
    ASSERT_FALSE(angles.others.empty());
    EXPECT_NEAR(*angles.others.front().options.lineStepDeg, 1.0, 1e-9);
}

TEST(OpeningCheck, TheOtherReadingIsTheScanWithThatGeometry) {
    const Scan scan = room(Axis::Spin, 1.0);
    const OpeningPoint order = pointOf(openingCheck(scan, {}), "Order of the lines");
    ASSERT_EQ(order.others.size(), 1u);
    EXPECT_DOUBLE_EQ(*order.others.front().options.lineStartDeg, 60.0);
    EXPECT_DOUBLE_EQ(*order.others.front().options.lineStepDeg, -1.0);
}

TEST(OpeningCheck, AnUnitThatMakesARoomOfMillimetresIsDoubted) {
    Scan scan = room(Axis::Spin, 1.0);
    for (float& range : scan.rangeMm.cells) range /= 1000.0F;
    scan.warnings.push_back("Unit taken as millimetres, in which every range is a whole number of millimetres.");
    const OpeningPoint unit = pointOf(openingCheck(scan, {}), "Unit");
    EXPECT_EQ(unit.source, OpeningPoint::Source::Guessed);
    EXPECT_FALSE(unit.against.empty());
    EXPECT_EQ(unit.others.front().options.unitMm, 1000.0);
    ReadingOptions typed;
    typed.unitMm = 1000.0;
    EXPECT_EQ(pointOf(openingCheck(room(Axis::Spin, 1.0), typed), "Unit").source, OpeningPoint::Source::Typed);
}

TEST(OpeningCheck, WhatWasFoundFromABareListIsGuessed) {
    Scan scan = room(Axis::Spin, 1.0);
    scan.warnings.push_back(std::string(kListsOnlyPoints) + "120 lines, 120 beams and mounting spin were found from them.");
    const auto points = openingCheck(scan, {});
    for (const char* what : {"Order of the lines", "Grid"}) EXPECT_EQ(pointOf(points, what).source, OpeningPoint::Source::Guessed) << what;
    for (const char* what : {"Mounting", "Line angles"}) EXPECT_EQ(pointOf(points, what).source, OpeningPoint::Source::Assumed) << what;
    EXPECT_TRUE(looksGuessed(points));
}

TEST(OpeningCheck, AStepThatWasAssumedIsNotFromTheFile) {
    Scan scan = room(Axis::Spin, 1.0);
    EXPECT_EQ(pointOf(openingCheck(scan, {}), "Line angles").source, OpeningPoint::Source::Stated);
    scan.warnings.push_back(std::string(kMountingAssumed) + "the step from line to line (0.18 degrees).");
    EXPECT_EQ(pointOf(openingCheck(scan, {}), "Line angles").source, OpeningPoint::Source::Assumed);
}

TEST(OpeningCheck, WhereRoughRockCannotShowAnAssumedStepUsualTurnsAreOffered) {
    Scan scan = room(Axis::Spin, 1.0);
    std::uint32_t random = 1;
    for (float& range : scan.rangeMm.cells) { // no piece is flat
        random = random * 1664525U + 1013904223U;
        range = 4000.0F + static_cast<float>(random >> 22U);
    }
    auto& lines = std::get<PolarGeometry>(scan.geometry).lineDeg;
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = 0.18 * static_cast<double>(i);
    scan.warnings.push_back(std::string(kMountingAssumed) + "the step from line to line (0.18 degrees).");
    const OpeningPoint angles = pointOf(openingCheck(scan, {}), "Line angles");
    EXPECT_NE(angles.taken.text().find("rough rock cannot show it"), std::string::npos) << angles.taken.text();
    ASSERT_FALSE(angles.others.empty());
    EXPECT_NEAR(*angles.others.front().options.lineStepDeg * 119, 180.0, 1e-6);
    EXPECT_NE(angles.others.front().words.text().find("180 in all"), std::string::npos) << angles.others.front().words.text();
}

TEST(OpeningCheck, ARealCorridorSaysHowItsScannerWasMounted) {
    EDGESCAN_NEEDS_SHARED("data/lms200_corridor");
    const std::filesystem::path path = test::sharedFolder() / "data/lms200_corridor/scan000.json";
    ReadingOptions options;
    EXPECT_TRUE(pointOf(openingCheck(*openAsAsked(path, options), options), "Mounting").against.empty());
    options.axis = Axis::Spin;
    const OpeningPoint mounting = pointOf(openingCheck(*openAsAsked(path, options), options), "Mounting");
    EXPECT_FALSE(mounting.against.empty());
    EXPECT_EQ(mounting.source, OpeningPoint::Source::Typed);
}

} // namespace edgescan::files
