// The values of a picked cell: the resolution there, and the plane of its surface, compared with known planes.
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/inspect/measure/cell_target.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/placed_points.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <random>

namespace edgescan::inspect {
namespace {

// A sweep with the LMS511's steps; `rangeM` gives the range in a direction; with noise `sigmaM`.
Scan sweepOfSurface(const std::function<double(const Eigen::Vector3d&)>& rangeM, double sigmaM, std::uint32_t seed = 1, int lines = 61,
                    int beams = 81) {
    Scan scan = test::makeScan(lines, beams, [](int, int) { return 1000.0F; });
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (int j = 0; j < beams; ++j) polar.beamDeg[static_cast<std::size_t>(j)] = 90.0 + (j - beams / 2) / 6.0;
    for (int i = 0; i < lines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = 0.18 * (i - lines / 2);
    const CartesianTables tables(scan);
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const double range = rangeM(tables.direction(static_cast<int>(k) / beams, static_cast<int>(k) % beams)) + sigmaM * noise(random);
        scan.rangeMm[k] = static_cast<float>(1000.0 * range);
        if (!(range > 0.0)) scan.state[k] = CellState::NoReturn; // the beam never meets it
    }
    return scan;
}

// The plane with this unit normal (towards the sensor) that the middle beam, along z, meets at `distanceM`.
std::function<double(const Eigen::Vector3d&)> planeAt(const Eigen::Vector3d& normal, double distanceM) {
    return [normal, distanceM](const Eigen::Vector3d& way) { return normal.z() * distanceM / normal.dot(way); };
}

Eigen::Vector3d tilted(double offBeamDeg, double turnDeg) {
    const double off = offBeamDeg * std::numbers::pi / 180, turn = turnDeg * std::numbers::pi / 180;
    return {std::sin(off) * std::cos(turn), std::sin(off) * std::sin(turn), -std::cos(off)};
}

double degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

std::size_t middleOf(const Scan& scan) { return scan.rangeMm.index(scan.lines() / 2, scan.beams() / 2); }

TEST(Resolution, IsTheWayToTheNextBeamPlusTheWidthOfTheBeam) {
    // The figures of docs/reference/rules.md, "S15": 29 mm of spacing and 59 mm of beam at 10 m; lines of 0.18 degrees are 31.4 mm apart.
    Scan scan = sweepOfSurface([](const Eigen::Vector3d&) { return 10.0; }, 0.0);
    const auto along = resolutionAt(scan, CartesianTables(scan), middleOf(scan));
    ASSERT_TRUE(along);
    EXPECT_NEAR(along->beamM, 0.059, 1e-9);
    EXPECT_NEAR(along->spacingM, 10.0 * 0.18 * std::numbers::pi / 180, 1e-5);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (double& deg : polar.lineDeg) deg *= 0.1667 / 0.18;
    EXPECT_NEAR(resolutionAt(scan, CartesianTables(scan), middleOf(scan))->smallestM(), 0.088, 5e-4);
    EXPECT_NEAR(resolutionAt(scan, CartesianTables(scan), middleOf(scan), {0.013, 0.011})->smallestM(), 0.152, 5e-4);
    // In the corner there is one neighbour in each direction.
    EXPECT_NEAR(resolutionAt(scan, CartesianTables(scan), 0)->smallestM(), 0.088, 2e-3);
    scan.state[0] = CellState::NoReturn;
    EXPECT_FALSE(resolutionAt(scan, CartesianTables(scan), 0));
}

TEST(Resolution, OfAnOrganisedCloudNeedsANeighbourWithAPoint) {
    Scan scan = test::makeScan(3, 3, [](int, int) { return 5000.0F; });
    PointGeometry points{Grid<Eigen::Vector3d>(3, 3, Eigen::Vector3d::Constant(std::nan("")))};
    points.pointsM.at(1, 1) = {0, 0, 5};
    scan.geometry = points;
    EXPECT_FALSE(resolutionAt(scan, CartesianTables(scan), 4));
    std::get<PointGeometry>(scan.geometry).pointsM.at(1, 2) = {0.02, 0, 5};
    EXPECT_NEAR(resolutionAt(scan, CartesianTables(scan), 4)->spacingM, 0.02, 1e-5);
}

TEST(SurfaceAt, IsThePlaneThatIsThere) {
    const double sigma = 0.006;
    for (const double off : {0.0, 12.0, 45.0, 70.0}) {
        for (const double turn : {0.0, 77.0, 200.0}) {
            int within = 0;
            double told = 0.0;
            for (std::uint32_t seed = 1; seed <= 40; ++seed) {
                const Scan scan = sweepOfSurface(planeAt(tilted(off, turn), 5.0), sigma, seed);
                const auto surface = surfaceAt(scan, CartesianTables(scan), middleOf(scan), sigma);
                ASSERT_TRUE(surface) << off << ' ' << turn;
                EXPECT_NEAR(surface->offBeamDeg, off, std::max(4.5 * surface->sigmaDeg, 1e-6)) << turn << " seed " << seed;
                within += degreesBetween(surface->normal, tilted(off, turn)) < 2 * surface->sigmaDeg ? 1 : 0;
                told += surface->sigmaDeg / 40;
                EXPECT_NEAR(surface->reliefM, sigma, 0.5 * sigma);
            }
            // Two standard deviations in the worse of two directions: 86 of 100 if both are equal, 95 if one is much worse.
            EXPECT_GE(within, 30) << off << ' ' << turn;
            EXPECT_LT(told, 1.5);
        }
    }
}

TEST(SurfaceAt, OfACellAtTheFootOfAStepIsThatOfItsSide) {
    const auto step = [](const Eigen::Vector3d& way) { return (way.x() < 0.0 ? 5.0 : 5.6) / way.z(); };
    const Scan scan = sweepOfSurface(step, 0.004);
    const CartesianTables tables(scan);
    for (const int beam : {scan.beams() / 2 - 1, scan.beams() / 2, scan.beams() / 2 + 1, scan.beams() / 2 + 2}) {
        const auto surface = surfaceAt(scan, tables, scan.rangeMm.index(30, beam), 0.004);
        ASSERT_TRUE(surface) << beam;
        EXPECT_LT(degreesBetween(surface->normal, {0, 0, -1}), 4.0) << beam;
    }
}

TEST(SurfaceAt, IsNoneWhereNothingIsFlatEnough) {
    Scan scan = sweepOfSurface(planeAt(tilted(0, 0), 5.0), 0.0);
    const Scan grazing = sweepOfSurface(planeAt(tilted(89.5, 0), 5.0), 0.0);
    EXPECT_FALSE(surfaceAt(grazing, CartesianTables(grazing), middleOf(grazing), 0.006));
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (k != middleOf(scan)) scan.state[k] = CellState::NoReturn;
    }
    EXPECT_FALSE(surfaceAt(scan, CartesianTables(scan), middleOf(scan), 0.006));
}

TEST(Dip, FallsTheWayOfItsSteepestLine) {
    // A roof that falls to the east by 30 degrees: its upper side faces up and to the east.
    const auto roof = [](double dipDeg, double toDeg) {
        const double dip = dipDeg * std::numbers::pi / 180, to = toDeg * std::numbers::pi / 180;
        return Eigen::Vector3d(std::sin(dip) * std::sin(to), std::sin(dip) * std::cos(to), std::cos(dip));
    };
    for (const double dip : {5.0, 30.0, 89.0}) {
        for (const double to : {0.0, 90.0, 181.0, 359.0}) {
            for (const double side : {1.0, -1.0}) { // seen from above or from below: the plane is the same
                const Dip found = dipOf(side * roof(dip, to));
                EXPECT_NEAR(found.dipDeg, dip, 1e-9);
                EXPECT_NEAR(found.directionDeg, to, 1e-9);
            }
        }
    }
    EXPECT_NEAR(dipOf({0, 0, 1}).dipDeg, 0.0, 1e-12);
}

TEST(TargetAt, SaysWhatTheDetectionAndThePlaneSay) {
    auto scan = std::make_shared<Scan>(sweepOfSurface(planeAt(tilted(20, 0), 5.0), 0.006));
    const auto detection = edges::detectEdges(scan, edges::Settings{});
    const RangeNoise noise = noiseOf(*detection);
    const std::size_t k = middleOf(*scan);
    const CellTarget target = targetAt(*detection, noise, k);
    EXPECT_NEAR(target.distanceM, 5.0, 0.03);
    EXPECT_DOUBLE_EQ(target.toleranceM, 2 * noise.at(target.distanceM) / 1000);
    EXPECT_NEAR(target.toleranceM, 0.012, 0.004);
    ASSERT_TRUE(target.surface && target.resolution);
    EXPECT_FALSE(target.dip) << "without a pose nothing is known of the horizon";
    // With a pose the dip is that of the plane, transformed to the mine grid.
    const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    Placement placement;
    placement.poses = {RigidTransform{turn.toRotationMatrix(), {10, 20, 30}}};
    scan->placement = std::make_shared<const Placement>(placement);
    const CellTarget placed = targetAt(*detection, noise, k);
    ASSERT_TRUE(placed.dip);
    EXPECT_NEAR(placed.dip->dipDeg, dipOf(turn * placed.surface->normal).dipDeg, 1e-6);
    EXPECT_NEAR(placed.dip->directionDeg, dipOf(turn * placed.surface->normal).directionDeg, 1e-6);
    // A cell without a range has no such values.
    scan->state[k] = CellState::NoReturn;
    const CellTarget hole = targetAt(*detection, noise, k);
    EXPECT_FALSE(hole.surface || hole.resolution || hole.dip);
    EXPECT_EQ(hole.probe.state, CellState::NoReturn);
}

TEST(TargetAt, ReportsTheStrengthOfAnEdgeAsItWasDecidedOn) {
    const auto scan = std::make_shared<const Scan>(test::boxesScan(120, 160, 3));
    const auto detection = edges::detectEdges(scan, edges::Settings{});
    const RangeNoise noise = noiseOf(*detection);
    int edges = 0;
    for (const std::uint32_t k : *detection->edges) {
        const CellTarget target = targetAt(*detection, noise, k);
        if (target.probe.kind == edges::DepthEdge::Border || target.probe.kind == edges::DepthEdge::VoidRim) continue;
        ++edges;
        ASSERT_TRUE(target.strength);
        EXPECT_GT(*target.strength, 0.0) << k;
    }
    EXPECT_GT(edges, 100);
    int told = 0;
    for (std::size_t k = 0; k < scan->cells(); k += 7) { // 0 would mean a cell suppressed by a neighbour
        const auto strength = targetAt(*detection, noise, k).strength;
        EXPECT_TRUE(!strength || *strength > 0) << k;
        told += strength ? 1 : 0;
        if (k % 63 != 0) continue; // the card and Why have one number
        EXPECT_DOUBLE_EQ(strength.value_or(0), edges::whyCell(*detection, k).strength) << k;
    }
    EXPECT_GT(told, 100);
    edges::Settings canny;
    canny.method = edges::Method::Canny;
    const auto gray = edges::detectEdges(scan, canny);
    EXPECT_FALSE(targetAt(*gray, noiseOf(*gray), gray->edges->front()).strength);
    EXPECT_DOUBLE_EQ(noiseOf(*gray).at(5), noise.at(5)) << "the noise is the scan's, not the method's";
}

// The ends of the boom by the chain of frames itself: in local metres, from a head placed there.
TEST(BoomAt, IsWhereTheChainOfFramesPutsIt) {
    std::mt19937 random(5);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    for (int run = 0; run < 20; ++run) {
        Scan scan = sweepOfSurface(planeAt(tilted(between(0, 60), between(0, 360)), 5.0), 0.0);
        Calibration c;
        c.axis = Eigen::Vector3d::UnitX();
        c.mountRpyDeg = {between(-1, 1), between(-1, 1), between(-1, 1)};
        c.mountM = {0.01, 0.02, 0.03};
        c.inclinometerM = {between(-0.3, 0.3), 0.1, between(-0.3, 0.3)};
        c.headInRobotM = {between(3, 5), between(-1, 1), 2.6}; // the pivot
        c.armM = {between(1, 4), between(-0.1, 0.1), between(-0.1, 0.1)};
        PoseTrack poses;
        poses.boomAzimuthDeg = between(-60, 60);
        poses.inclinometer = {{0.0, between(-20, 20), between(-5, 5)}};
        poses.talin = {{0.0, {620000, 6200000, 250}, between(0, 360), false, between(-5, 5), between(-5, 5)}};
        const auto placed = placeScan(scan, c, poses);
        ASSERT_TRUE(placed) << placed.error().sentence();
        scan.placement = *placed;
        const auto endAt = [&](const Eigen::Vector3d& arm) {
            Calibration end = c;
            end.armM = arm;
            end.inclinometerM.setZero(); // then the origin of the axis base is the head
            const auto there = placeScan(scan, end, poses);
            return (*there)->originEnhM - scan.placement->originEnhM + (*there)->poses.front().translationM;
        };
        const Eigen::Vector3d pivot = endAt(Eigen::Vector3d::Zero());
        const Eigen::Vector3d head = endAt(c.armM);
        EXPECT_NEAR((head - pivot).norm(), c.armM.norm(), 1e-9);
        const std::size_t k = middleOf(scan);
        const Eigen::Vector3d point = minePoint(scan, k).localM;
        double nearest = 1e9;
        for (int n = 0; n <= 100000; ++n) nearest = std::min(nearest, (point - pivot - n / 1e5 * (head - pivot)).norm());
        const CartesianTables tables(scan);
        const auto surface = surfaceAt(scan, tables, k, 0.001);
        ASSERT_TRUE(surface);
        const auto boom = boomAt(scan, k, surface->normal);
        ASSERT_TRUE(boom);
        EXPECT_NEAR(boom->distanceM, nearest, 1e-6);
        const PlacedPoints places(scan);
        const int line = static_cast<int>(k) / scan.beams();
        const int beam = static_cast<int>(k) % scan.beams();
        const Eigen::Vector3d normal =
            places.local(line, beam, surface->normal) - places.local(line, beam, Eigen::Vector3d(Eigen::Vector3d::Zero()));
        const double off = degreesBetween(normal, head - pivot);
        EXPECT_NEAR(*boom->angleDeg, std::min(off, 180 - off), 1e-6);
        EXPECT_FALSE(boomAt(scan, k, std::nullopt)->angleDeg);
    }
}

TEST(BoomAt, NothingIsSaidWhereNoBoomIsKnown) {
    Scan scan = sweepOfSurface(planeAt(tilted(20, 0), 5.0), 0.0);
    EXPECT_FALSE(boomAt(scan, middleOf(scan), std::nullopt));
    Calibration c;
    c.axis = Eigen::Vector3d::UnitX();
    c.armM = {3, 0, 0};
    PoseTrack poses;
    poses.inclinometer = {{0.0, 0, 0}};
    poses.talin = {{0.0, {620000, 6200000, 250}, 0, false, 0, 0}};
    poses.headInRobotM = {4, 1, 2}; // the pose gives the position of the head, but not that of the boom
    const auto placed = placeScan(scan, c, poses);
    ASSERT_TRUE(placed) << placed.error().sentence();
    EXPECT_FALSE((*placed)->boom);
    poses.headInRobotM.setConstant(kUnknownTime);
    EXPECT_TRUE((*placeScan(scan, c, poses))->boom);
}

} // namespace
} // namespace edgescan::inspect
