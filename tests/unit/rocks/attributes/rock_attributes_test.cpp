// Attributes of rocks of known size and place: balls in front of a wall; and slow versions of calipers, outlines and hulls.
#include "core/rocks/attributes/attributes.h"
#include "core/rocks/attributes/hulls.h"
#include "core/rocks/attributes/outlines.h"
#include "core/rocks/attributes/size_curve.h"
#include "core/rocks/attributes/visible_spans.h"
#include "core/rocks/attributes/visible_surface.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/rock_scene.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

namespace edgescan::rocks {
namespace {

struct Ball {
    Eigen::Vector3d centreM;
    double radiusM;
};

// Balls in front of a wall 8 m above the scanner.
Scan ballsScan(const std::vector<Ball>& balls, int lines = 200, int beams = 260) {
    Scan scan = test::makeScan(lines, beams, [](int, int) { return 1.0F; });
    const CartesianTables tables(scan);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d way = tables.direction(static_cast<int>(k) / beams, static_cast<int>(k) % beams);
        double range = 8.0 / way.z();
        for (const Ball& ball : balls) {
            const double along = way.dot(ball.centreM);
            const double under = along * along - ball.centreM.squaredNorm() + ball.radiusM * ball.radiusM;
            if (under > 0) range = std::min(range, along - std::sqrt(under));
        }
        scan.rangeMm[k] = static_cast<float>(std::round(1000 * range));
    }
    return scan;
}

struct FoundBalls {
    Segmentation segments;
    RegionMap map;
    std::vector<Rock> rocks;
};
FoundBalls found(const Scan& scan) {
    FoundBalls f;
    f.segments = test::segmentationOf(std::make_shared<const Scan>(scan));
    f.map = rocksAt(f.segments, mergeTree(f.segments), {});
    f.rocks = rockRows(f.segments, f.map);
    return f;
}

TEST(RockRows, ABallHasItsSizePlaceAndDistance) {
    const FoundBalls f = found(ballsScan({{{-1.0, 0.2, 5.0}, 0.5}, {{1.2, -0.3, 6.0}, 0.3}}));
    ASSERT_EQ(f.rocks.size(), 2U);
    const double radii[] = {0.5, 0.3};
    const Eigen::Vector3d centres[] = {{-1.0, 0.2, 5.0}, {1.2, -0.3, 6.0}};
    for (std::size_t n = 0; n < 2; ++n) {
        const Rock& rock = f.rocks[n];
        const double away = centres[n].norm();
        const double seen = 2 * radii[n] * std::sqrt(1 - std::pow(radii[n] / away, 2)); // the widest visible circle
        EXPECT_NEAR(rock.longestCaliperM, seen, rock.toleranceM);
        EXPECT_NEAR(rock.shortestCaliperM, seen, rock.toleranceM);
        EXPECT_LE(rock.shortestCaliperM, rock.longestCaliperM);
        EXPECT_LT(rock.toleranceM, 0.16);
        EXPECT_GT(rock.distanceM, away - radii[n]);
        EXPECT_LT(rock.distanceM, away);
        const double nearer = rock.distanceM / away; // the visible part is in front of the widest circle
        EXPECT_NEAR(rock.areaM2, std::numbers::pi * seen * seen / 4 * nearer * nearer, 0.1 * rock.areaM2);
        EXPECT_LT((rock.centreM.normalized() - centres[n].normalized()).norm(), 0.01);
        EXPECT_GT(rock.unoccluded, 0.9);
        EXPECT_GT(rock.confidence, 0.9);
        EXPECT_TRUE(rock.contacts.empty());
        EXPECT_TRUE(rock.rocksBehind.empty());
        EXPECT_EQ(rockLabels(f.segments, f.map)[rock.cell], rock.label);
    }
}

TEST(RockRows, TheNearerOfTwoThatOverlapLiesBefore) {
    const FoundBalls f = found(ballsScan({{{0.0, 0.0, 4.0}, 0.3}, {{0.5, 0.0, 6.0}, 0.7}}));
    ASSERT_EQ(f.rocks.size(), 2U);
    const Rock& far = f.rocks[0];
    const Rock& near = f.rocks[1];
    EXPECT_GT(far.distanceM, near.distanceM);
    EXPECT_EQ(near.rocksBehind, std::vector<std::uint32_t>{1});
    EXPECT_EQ(far.rocksInFront, std::vector<std::uint32_t>{2});
    EXPECT_TRUE(near.rocksInFront.empty());
    EXPECT_LT(far.unoccluded, near.unoccluded);
}

TEST(RockRows, RocksThatTheTreeSoonMergesMayBeOne) {
    const FoundBalls f = found(ballsScan({{{-1.0, 0.2, 5.0}, 0.5}, {{1.2, -0.3, 6.0}, 0.3}, {{0.2, 0.9, 5.5}, 0.3}}));
    ASSERT_EQ(f.rocks.size(), 3U);
    const auto segmentOf = [&](std::uint32_t label) { return f.map.regions[label].firstSegment; };
    std::vector<Rock> rocks = f.rocks;
    for (const auto& [height, nearlyAsCheap] : {std::pair(kLikelyJoin / 2, true), std::pair(2 * kLikelyJoin, false)}) {
        const MergeTree tree{{{height, std::min(segmentOf(1), segmentOf(3)), std::max(segmentOf(1), segmentOf(3))}}};
        addLikelyJoins(tree, f.map, rocks);
        using Labels = std::vector<std::uint32_t>;
        EXPECT_EQ(rocks[0].maybeOneWith, nearlyAsCheap ? Labels{3} : Labels{}) << height;
        EXPECT_EQ(rocks[1].maybeOneWith, Labels{}) << height;
        EXPECT_EQ(rocks[2].maybeOneWith, nearlyAsCheap ? Labels{1} : Labels{}) << height;
    }
}

TEST(RockRows, FreeHeightBelowEndsAtAnObjectOrAVoid) {
    // Up is the scanner's z axis: the path down from the ball leads towards the scanner's level, and leaves the fan after some metres.
    const Scan open = ballsScan({{{1.0, 0.0, 5.0}, 0.4}});
    const FoundBalls f = found(open);
    ASSERT_EQ(f.rocks.size(), 1U);
    EXPECT_GT(f.rocks[0].freeHeightM, 0.5);
    EXPECT_LT(f.rocks[0].freeHeightM, 4.6);
    // Another ball is half a metre below it.
    const FoundBalls two = found(ballsScan({{{1.0, 0.0, 5.0}, 0.4}, {{1.0, 0.0, 3.9}, 0.2}}));
    ASSERT_EQ(two.rocks.size(), 2U);
    const Rock& upper = two.rocks[0].distanceM > two.rocks[1].distanceM ? two.rocks[0] : two.rocks[1];
    EXPECT_LE(upper.freeHeightM, 0.6);
    // There was no return from below it.
    Scan silent = open;
    const Grid<std::uint32_t> labels = rockLabels(f.segments, f.map);
    for (std::size_t k = 0; k < silent.cells(); ++k) {
        if (labels[k] != 0) continue;
        silent.state[k] = CellState::NoReturn;
        silent.rangeMm[k] = 0;
    }
    const FoundBalls alone = found(silent);
    ASSERT_EQ(alone.rocks.size(), 1U);
    // Only the space that the beams to the ball itself crossed is free.
    EXPECT_LT(alone.rocks[0].freeHeightM, f.rocks[0].freeHeightM - 0.5);
}

TEST(RockRows, CellsThatSawPastTheRimMakeNoRockLonger) {
    const FoundBalls f = found(ballsScan({{{0.3, 0.0, 5.0}, 0.5}}));
    ASSERT_EQ(f.rocks.size(), 1U);
    Segmentation segments = f.segments;
    Scan scan = *segments.inputs.scan;
    const Grid<std::uint32_t> labels = rockLabels(f.segments, f.map);
    int changed = 0;
    for (std::size_t k = 0; k < scan.cells() && changed < 4; ++k) { // the first ones, at its upper rim
        if (labels[k] != 1 || scan.state[k] != CellState::Valid) continue;
        scan.rangeMm[k] += 9000.0F;
        ++changed;
    }
    segments.inputs.scan = std::make_shared<const Scan>(std::move(scan));
    const std::vector<Rock> rocks = rockRows(segments, f.map);
    EXPECT_NEAR(rocks[0].longestCaliperM, f.rocks[0].longestCaliperM, 0.05);
    EXPECT_NEAR(rocks[0].shortestCaliperM, f.rocks[0].shortestCaliperM, 0.05);
    EXPECT_NEAR(rocks[0].distanceM, f.rocks[0].distanceM, 0.01);
}

// With 8 rocks P80 was the width of the sixth: 75 % are not wider.
TEST(SizeCurve, ThisShareOfTheRocksIsNotWider) {
    std::mt19937 random(7);
    for (std::size_t count = 1; count < 60; ++count) {
        std::vector<Rock> rocks(count);
        for (Rock& rock : rocks) rock.shortestCaliperM = 0.01 * static_cast<double>(random() % 90 + 10);
        const SizeCurve curve = sizeCurve(rocks);
        for (const auto& [wideM, percent] : {std::pair{curve.p20M, 20U}, {curve.p50M, 50U}, {curve.p80M, 80U}}) {
            const auto within = [&, limit = wideM](auto isWithin) {
                return static_cast<std::size_t>(std::ranges::count_if(curve.widthsM, [&](double w) { return isWithin(w, limit); }));
            };
            EXPECT_GE(100 * within(std::less_equal{}), percent * count) << percent << " % of " << count;
            EXPECT_LT(100 * within(std::less{}), percent * count) << percent << " % of " << count;
        }
    }
}

TEST(RockRows, SizesAndFinesAddUp) {
    const FoundBalls f = found(ballsScan({{{-1.5, 0.0, 5.0}, 0.5}, {{0.2, 0.0, 5.0}, 0.3}, {{1.6, 0.0, 5.0}, 0.4}}));
    ASSERT_EQ(f.rocks.size(), 3U);
    const SizeCurve curve = sizeCurve(f.rocks, 0.7);
    EXPECT_EQ(curve.rocks(), 3U);
    EXPECT_NEAR(curve.p50M, 0.8, 0.1);
    EXPECT_NEAR(curve.topM, 1.0, 0.1);
    EXPECT_NEAR(curve.oversizeShare, 2.0 / 3, 1e-9);
    EXPECT_TRUE(std::is_sorted(curve.widthsM.begin(), curve.widthsM.end()));
    EXPECT_EQ(curve.shareUpTo(0.0), 0.0);
    EXPECT_NEAR(curve.shareUpTo(curve.widthsM[0]), 1.0 / 3, 1e-9);
    EXPECT_EQ(curve.shareUpTo(curve.topM), 1.0);
    EXPECT_EQ(sizeCurve({}).rocks(), 0U);
    std::uint64_t cells = 0;
    for (std::size_t n = 1; n < f.map.regions.size(); ++n)
        cells += f.map.regions[n].kind == RegionKind::Fines ? f.map.regions[n].sums.cells : 0;
    EXPECT_EQ(regionCounts(f.map, RegionKind::Fines).cells, cells);
}

PlanePoints planePoints(const std::vector<Eigen::Vector2d>& points) {
    PlanePoints result;
    for (const Eigen::Vector2d& p : points) result.add(p.x(), p.y());
    return result;
}

TEST(Calipers, AreThoseOfAllDirections) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int round = 0; round < 20; ++round) {
        std::vector<Eigen::Vector2d> points;
        for (int n = 0; n < 3 + round * 20; ++n) points.emplace_back(number(random), 0.4 * number(random));
        const Calipers calipers = calipersOf(planePoints(points));
        double longest = 0;
        double shortest = 1e9;
        for (int step = 0; step < 7200; ++step) {
            const double angle = step * std::numbers::pi / 7200;
            const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
            double least = 1e9;
            double most = -1e9;
            for (const Eigen::Vector2d& p : points) {
                least = std::min(least, way.dot(p));
                most = std::max(most, way.dot(p));
            }
            longest = std::max(longest, most - least);
            shortest = std::min(shortest, most - least);
        }
        EXPECT_NEAR(calipers.longest, longest, 1e-5);
        EXPECT_NEAR(calipers.shortest, shortest, 2e-3);
        EXPECT_LE(calipers.shortest, shortest + 1e-12);
    }
    EXPECT_EQ(calipersOf({}).longest, 0.0);
    EXPECT_EQ(calipersOf(planePoints({{1, 1}})).longest, 0.0);
    EXPECT_EQ(calipersOf(planePoints({{1, 1}, {1, 1}, {4, 5}})).longest, 5.0);
    EXPECT_EQ(calipersOf(planePoints({{1, 1}, {2, 2}, {4, 4}})).shortest, 0.0);
}

// Cells whose middle is inside the rings by the even-odd rule.
bool isWithin(const std::vector<OutlineRing>& rings, int line, int beam) {
    bool inside = false;
    for (const OutlineRing& ring : rings) {
        for (std::size_t n = 0; n < ring.corners.size(); ++n) {
            const CellCorner& a = ring.corners[n];
            const CellCorner& b = ring.corners[(n + 1) % ring.corners.size()];
            if (a.beam != b.beam || a.beam <= beam) continue; // sides along the lines, on the right
            if (std::min(a.line, b.line) <= line && line < std::max(a.line, b.line)) inside = !inside;
        }
    }
    return inside;
}

TEST(RockOutlines, EncloseTheCellsOfTheirLabelAndNoOthers) {
    std::mt19937 random(9);
    for (int round = 0; round < 20; ++round) {
        Grid<std::uint32_t> labels(12, 15);
        for (std::uint32_t& label : labels.cells) label = static_cast<std::uint32_t>(random()) % (round % 3 == 0 ? 2U : 4U);
        const auto outlines = outlinesOf(labels, 3);
        ASSERT_EQ(outlines.size(), 4U);
        EXPECT_TRUE(outlines[0].empty());
        for (std::uint32_t label = 1; label <= 3; ++label) {
            for (int i = 0; i < labels.lines; ++i) {
                for (int j = 0; j < labels.beams; ++j) ASSERT_EQ(isWithin(outlines[label], i, j), labels.at(i, j) == label);
            }
            std::uint32_t part = UINT32_MAX;
            for (const OutlineRing& ring : outlines[label]) {
                EXPECT_GE(ring.corners.size(), 4U);
                EXPECT_EQ(ring.hole, ring.part == part); // the first of a part is its outer ring
                part = ring.part;
                for (const std::uint32_t k : ring.inside) EXPECT_EQ(labels[k], label);
                for (std::size_t n = 0; n < ring.corners.size(); ++n) {
                    const CellCorner& a = ring.corners[n];
                    const CellCorner& b = ring.corners[(n + 1) % ring.corners.size()];
                    EXPECT_TRUE((a.line == b.line) != (a.beam == b.beam));
                }
            }
        }
    }
}

TEST(RockHulls, HoldAllVisiblePoints) {
    const FoundBalls f = found(ballsScan({{{-1.0, 0.2, 5.0}, 0.5}, {{1.2, -0.3, 6.0}, 0.3}}));
    const std::vector<Hull> hulls = rockHulls(f.segments, f.map);
    ASSERT_EQ(hulls.size(), 2U);
    const CartesianTables tables(*f.segments.inputs.scan);
    const Grid<std::uint32_t> labels = visibleSurfaces(f.segments, f.map);
    for (const Hull& hull : hulls) {
        ASSERT_GT(hull.triangles.size(), 20U);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (const auto& t : hull.triangles) {
            const Eigen::Vector3d a = tables.point(hull.cells.at(t[0]));
            const Eigen::Vector3d normal =
                (tables.point(hull.cells.at(t[1])) - a).cross(tables.point(hull.cells.at(t[2])) - a).normalized();
            for (std::size_t k = 0; k < labels.size(); ++k) {
                if (labels[k] == hull.label && f.segments.inputs.surface->inverse.support[k] == Support::Measured) {
                    ASSERT_LT(normal.dot(tables.point(k) - a), kHullToleranceM + 1e-9);
                }
            }
            for (std::size_t n = 0; n < 3; ++n) ++sides[{t[n], t[(n + 1) % 3]}];
        }
        for (const auto& [side, count] : sides) {
            EXPECT_EQ(count, 1);
            EXPECT_EQ(sides.count({side.second, side.first}), 1U); // closed
        }
    }
}

} // namespace
} // namespace edgescan::rocks
