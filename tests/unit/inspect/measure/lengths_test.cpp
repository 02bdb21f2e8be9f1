// Lengths and angles: values compared with plain geometry, errors compared with random trials, and no number below the resolution.
#include "app/lab/sim/simulate.h"
#include "core/inspect/measure/lengths.h"
#include "core/scan/grid/missing_cells.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace edgescan::inspect {
namespace {

constexpr RangeNoise kUsualNoise{5.5, 0.25};

// A wall at 10.3 m with a plate of side `sideM` in front of it at 10 m; steps of 1/6 degree in both directions, so that a plate of 50 mm
// has two cells.
Scan plateScan(double sideM) {
    Scan scan = test::makeScan(41, 41, [](int, int) { return 1000.0F; });
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (std::size_t n = 0; n < 41; ++n) {
        polar.beamDeg[n] = 90.0 + (static_cast<double>(n) - 20) / 6;
        polar.lineDeg[n] = (static_cast<double>(n) - 20) / 6;
    }
    const CartesianTables tables(scan);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d way = tables.direction(static_cast<int>(k / 41), static_cast<int>(k % 41));
        const Eigen::Vector3d on = way * (10.0 / way.z());
        const bool plate = std::abs(on.x() - 0.015) <= sideM / 2 && std::abs(on.y()) <= sideM / 2;
        scan.rangeMm[k] = static_cast<float>(1000.0 * (plate ? 10.0 : 10.3) / way.z());
    }
    return scan;
}

// The outermost cells of the plate on the middle line.
std::vector<std::uint32_t> endsOfPlate(const Scan& scan) {
    std::vector<std::uint32_t> on;
    for (int j = 0; j < 41; ++j) {
        if (scan.rangeMm.at(20, j) < 10150.0F) on.push_back(static_cast<std::uint32_t>(scan.rangeMm.index(20, j)));
    }
    return {on.front(), on.back()};
}

TEST(Lengths, ARockOf50MmAt10MIsNoNumber) {
    const Scan small = plateScan(0.050);
    const auto ends = endsOfPlate(small);
    ASSERT_EQ(ends[1], ends[0] + 1);
    const auto measured = measureCells(small, kUsualNoise, MeasureKind::Distance, ends);
    ASSERT_TRUE(measured);
    EXPECT_TRUE(measured->lengths.front().isBelow);
    EXPECT_EQ(measureText(*measured), "< 89 mm"); // 29.1 of spacing, 59 of beam, rounded up
    EXPECT_EQ(measureBasis(*measured), "ranges 10.00 / 10.00 m");
    EXPECT_EQ(measureText(*measureCells(small, kUsualNoise, MeasureKind::Vertical, ends)), "< 89 mm");
    EXPECT_EQ(measureText(*measureCells(small, kUsualNoise, MeasureKind::Angle, std::vector{ends[0], ends[1], ends[0] + 200})),
              "not resolved");
    const Scan large = plateScan(0.40);
    const auto wide = measureCells(large, kUsualNoise, MeasureKind::Distance, endsOfPlate(large));
    EXPECT_FALSE(wide->lengths.front().isBelow);
    EXPECT_NEAR(wide->lengths.front().valueM, 0.40, 2 * 0.0291);
    // One of two spans may be below the resolution.
    const auto both = endsOfPlate(large);
    const std::vector<std::uint32_t> four{both[0], both[1], both[0], both[0] + 1};
    EXPECT_NE(measureText(*measureCells(large, kUsualNoise, MeasureKind::Spans, four)).find(" × < 89 mm"), std::string::npos);
}

TEST(Lengths, AreThoseOfTheirPoints) {
    const Scan scan = test::boxesScan(60, 80, 3);
    const CartesianTables tables(scan);
    const std::vector<std::uint32_t> cells{105, 3220, 4007, 770};
    const auto point = [&](std::size_t n) { return tables.point(cells[n]); };
    const auto distance = measureCells(scan, kUsualNoise, MeasureKind::Distance, std::vector{cells[0], cells[1]});
    EXPECT_NEAR(distance->lengths.front().valueM, (point(0) - point(1)).norm(), 1e-12);
    const double height = point(1).z() - point(0).z();
    EXPECT_NEAR(distance->slopeDeg, std::asin(height / (point(0) - point(1)).norm()) * 180 / std::numbers::pi, 1e-9);
    const auto back = measureCells(scan, kUsualNoise, MeasureKind::Distance, std::vector{cells[1], cells[0]});
    EXPECT_NEAR(back->slopeDeg, -distance->slopeDeg, 1e-12);
    EXPECT_NE(measureBasis(*distance).find("slope "), std::string::npos);
    const auto vertical = measureCells(scan, kUsualNoise, MeasureKind::Vertical, std::vector{cells[0], cells[1]});
    EXPECT_TRUE(vertical->upAssumed);
    EXPECT_NEAR(vertical->lengths.front().valueM, point(1).z() - point(0).z(), 1e-12) << "the second is higher by so much";
    EXPECT_NE(measureBasis(*vertical).find("no pose"), std::string::npos);
    const auto angle = measureCells(scan, kUsualNoise, MeasureKind::Angle, std::vector{cells[0], cells[1], cells[2]});
    const Eigen::Vector3d a = (point(0) - point(1)).normalized(), b = (point(2) - point(1)).normalized();
    EXPECT_NEAR(angle->angleDeg, std::acos(a.dot(b)) * 180 / std::numbers::pi, 1e-6);
    const auto spans = measureCells(scan, kUsualNoise, MeasureKind::Spans, cells);
    EXPECT_NEAR(spans->lengths[0].valueM, (point(0) - point(1)).norm(), 1e-12);
    EXPECT_NEAR(spans->lengths[1].valueM, (point(2) - point(3)).norm(), 1e-12);
    EXPECT_FALSE(measureCells(scan, kUsualNoise, MeasureKind::Distance, cells));
    EXPECT_FALSE(measureCells(scan, kUsualNoise, MeasureKind::Distance, std::vector{cells[0], 60U * 80U}));
    EXPECT_FALSE(measureCells(scan, kUsualNoise, MeasureKind::Angle, std::vector{cells[0], cells[0], cells[1]}));
}

TEST(Lengths, AnEndBehindTheSurfaceUnderTheLineIsWarnedAbout) {
    const Scan large = plateScan(0.40);
    const auto ends = endsOfPlate(large);
    const auto onPlate = measureCells(large, kUsualNoise, MeasureKind::Distance, ends);
    EXPECT_EQ(onPlate->behindM, 0.0);
    EXPECT_EQ(onPlate->inFrontM, 0.0);
    EXPECT_EQ(measureBasis(*onPlate).find("behind"), std::string::npos);
    // The second end is five cells beyond the plate, on the wall 0.3 m behind it.
    const auto beyond = measureCells(large, kUsualNoise, MeasureKind::Distance, std::vector{ends[0], ends[1] + 5});
    EXPECT_NEAR(beyond->behindM, 0.3, 0.01);
    EXPECT_NE(measureBasis(*beyond).find("▲ an end is 0.30 m behind the surface next to it"), std::string::npos) << measureBasis(*beyond);
}

TEST(Lengths, ASurfaceInFrontOfTheMiddleOfALineIsNoWarning) {
    const Scan small = plateScan(0.10);
    const auto row = static_cast<std::uint32_t>(20 * small.beams());
    const auto wide = measureCells(small, kUsualNoise, MeasureKind::Distance, std::vector{row, row + 40});
    EXPECT_FALSE(wide->isWarned()) << measureBasis(*wide);
    EXPECT_NEAR(wide->nearerBetweenM, 0.3, 0.01);
    EXPECT_NE(measureBasis(*wide).find("between its ends the surface is up to 0.30 m nearer"), std::string::npos) << measureBasis(*wide);
    // An end near the plate may have been meant for the plate. So may one farther from it if the length would be another one.
    EXPECT_NEAR(measureCells(small, kUsualNoise, MeasureKind::Distance, std::vector{row, row + 28})->behindM, 0.3, 0.01);
    Scan deep = small;
    for (std::size_t k = 0; k < deep.cells(); ++k) deep.rangeMm[k] += deep.rangeMm[k] > 10'150.0F ? 2000.0F : 0.0F;
    EXPECT_NEAR(measureCells(deep, kUsualNoise, MeasureKind::Distance, std::vector{row, row + 40})->behindM, 2.3, 0.02);
}

TEST(Lengths, AHoleBehindAStepUnderTheLineIsGivenWithItsWholeDepth) {
    Scan large = plateScan(1.0);
    const auto ends = endsOfPlate(large);
    const std::uint32_t middle = (ends[0] + ends[1]) / 2;
    for (std::uint32_t k = middle - 12; k <= middle + 12; ++k) large.rangeMm[k] += k < middle - 6 ? 220.0F : 19000.0F;
    for (const auto& way : {std::vector{ends[0], ends[1]}, std::vector{ends[1], ends[0]}}) {
        const auto measured = measureCells(large, kUsualNoise, MeasureKind::Distance, way);
        EXPECT_NEAR(measured->inFrontM, 19.0, 0.05);
        EXPECT_EQ(measured->behindM, 0.0);
    }
}

TEST(Lengths, AnEchoOfDustUnderTheLineIsNoSurface) {
    Scan large = plateScan(0.40);
    const auto ends = endsOfPlate(large);
    large.rangeMm[(ends[0] + ends[1]) / 2] = 1377;
    EXPECT_TRUE(isIsolated(large, (ends[0] + ends[1]) / 2));
    EXPECT_EQ(measureCells(large, kUsualNoise, MeasureKind::Distance, ends)->behindM, 0.0);
    // The dust itself may be an end.
    EXPECT_GT(measureCells(large, kUsualNoise, MeasureKind::Distance, std::vector{ends[0], (ends[0] + ends[1]) / 2})->behindM, 0.5);
}

// At the end of a slanted surface a part of the beam misses it: the range has the error of the slope over a quarter of the beam.
TEST(Lengths, TheToleranceAtARimGrowsWithTheSlopeOfItsSurface) {
    const auto scanOf = [](double mmPerCell) {
        return test::makeScan(40, 40, [&](int, int j) { return j < 20 ? 5000.0 + mmPerCell * (j - 19) : 20000.0; });
    };
    const auto toleranceAt = [](const Scan& scan, int j) {
        const auto row = static_cast<std::uint32_t>(20 * scan.beams());
        // Along the beam, nearly: from the cell to one far behind it.
        return measureCells(scan, kUsualNoise, MeasureKind::Distance, std::vector{row + static_cast<std::uint32_t>(j), row + 21U})
            ->lengths[0]
            .toleranceM;
    };
    const Scan flat = scanOf(0), slanted = scanOf(60);
    EXPECT_LT(toleranceAt(slanted, 17), 1.05 * toleranceAt(flat, 17));
    const CartesianTables tables(slanted);
    const std::size_t rim = 20 * 40 + 19;
    const Resolution resolution = *resolutionAt(slanted, tables, rim);
    const double across = 4.94 * std::sin(tables.direction(20, 19).cross(tables.direction(20, 18)).norm());
    EXPECT_NEAR(clippedBeamM(slanted, tables, rim, resolution), 0.060 / across * resolution.beamM / 4, 1e-3);
    EXPECT_EQ(clippedBeamM(flat, tables, rim, resolution), 0.0);
    EXPECT_EQ(clippedBeamM(slanted, tables, rim - 3, resolution), 0.0);
    EXPECT_GT(toleranceAt(slanted, 19), 1.3 * toleranceAt(flat, 19));
}

// The tolerance compared with many readings of points distributed as the model assumes.
TEST(Lengths, TolerancesAreTwiceTheSpreadOfChance) {
    const Scan scan = test::boxesScan(120, 160, 9);
    const CartesianTables tables(scan);
    const std::vector<std::uint32_t> cells{25 * 160 + 20, 60 * 160 + 100, 110 * 160 + 30, 30 * 160 + 140};
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::vector<Eigen::Matrix3d> spread;
    for (const std::uint32_t k : cells) {
        const double range = tables.point(k).norm();
        spread.push_back(
            placeCovariance(tables.point(k) / range, kUsualNoise.at(range) / 1000, *resolutionAt(scan, tables, k)).llt().matrixL());
    }
    const auto spreadOf = [&](const auto& value) {
        double sum = 0.0, squares = 0.0;
        constexpr int kReadings = 20000;
        for (int n = 0; n < kReadings; ++n) {
            std::vector<Eigen::Vector3d> points;
            for (std::size_t m = 0; m < cells.size(); ++m)
                points.push_back(tables.point(cells[m]) + spread[m] * Eigen::Vector3d(normal(random), normal(random), normal(random)));
            const double v = value(points);
            sum += v;
            squares += v * v;
        }
        return std::sqrt(squares / kReadings - sum * sum / kReadings / kReadings);
    };
    const auto check = [&](double tolerance, const auto& value) { EXPECT_NEAR(tolerance, 2 * spreadOf(value), 0.04 * tolerance); };
    const std::vector<std::uint32_t> two(cells.begin(), cells.begin() + 2), three(cells.begin(), cells.begin() + 3);
    check(measureCells(scan, kUsualNoise, MeasureKind::Distance, two)->lengths[0].toleranceM,
          [](const auto& p) { return (p[0] - p[1]).norm(); });
    check(measureCells(scan, kUsualNoise, MeasureKind::Distance, two)->slopeToleranceDeg, [](const auto& p) {
        const Eigen::Vector3d way = p[1] - p[0];
        return std::atan2(way.z(), std::hypot(way.x(), way.y())) * 180 / std::numbers::pi;
    });
    check(measureCells(scan, kUsualNoise, MeasureKind::Vertical, two)->lengths[0].toleranceM,
          [](const auto& p) { return p[1].z() - p[0].z(); });
    check(measureCells(scan, kUsualNoise, MeasureKind::Angle, three)->angleToleranceDeg, [](const auto& p) {
        const Eigen::Vector3d a = p[0] - p[1], b = p[2] - p[1];
        return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
    });
    check(measureCells(scan, kUsualNoise, MeasureKind::Spans, cells)->lengths[1].toleranceM,
          [](const auto& p) { return (p[2] - p[3]).norm(); });
}

TEST(Lengths, HoldOnASimulatedWall) {
    // Between cells of the true wall and the measured one: at least 95 of 100 are within the reported tolerance, because the beam's width
    // does not move these points.
    sim::SimulationSettings settings;
    settings.scene = "wall";
    settings.lines = 120;
    settings.beams = 160;
    settings.dropouts = 0.0;
    settings.noise = 0.0;
    const auto exact = sim::simulate(settings);
    settings.noise = 1.0;
    const auto noisy = sim::simulate(settings);
    ASSERT_TRUE(exact && noisy);
    const RangeNoise noise = rangeNoise(inverseRange(noisy->scan));
    std::mt19937 random(3);
    int within = 0, all = 0;
    while (all < 400) {
        const std::vector<std::uint32_t> ends{static_cast<std::uint32_t>(random() % exact->scan.cells()),
                                              static_cast<std::uint32_t>(random() % exact->scan.cells())};
        const auto there = measureCells(exact->scan, noise, MeasureKind::Distance, ends);
        const auto told = measureCells(noisy->scan, noise, MeasureKind::Distance, ends);
        if (!there || !told || told->lengths[0].isBelow) continue;
        ++all;
        within += std::abs(there->lengths[0].valueM - told->lengths[0].valueM) <= told->lengths[0].toleranceM ? 1 : 0;
    }
    EXPECT_GE(within, 380) << "of 400";
}

TEST(MeasureKinds, HaveNamesForFiles) {
    for (int n = 0; n < kMeasureKinds; ++n) {
        const auto kind = static_cast<MeasureKind>(n);
        EXPECT_EQ(traitsOf(kind).kind, kind);
        EXPECT_EQ(measureKindNamed(traitsOf(kind).key), kind);
    }
    EXPECT_FALSE(measureKindNamed("volume"));
}

} // namespace
} // namespace edgescan::inspect
