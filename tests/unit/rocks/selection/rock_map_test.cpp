// Rocks of simulated scenes whose rocks are known.
#include "core/rocks/selection/region_of_interest.h"
#include "tests/support/rock_scene.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace edgescan::rocks {
namespace {

struct Found {
    test::RockScene scene;
    Segmentation segments;
    MergeTree tree;
};
const Found& hangup() {
    static const Found found = [] {
        Found f{test::rockScene("hangup", 4711, 400, 457), {}, {}};
        f.segments = test::segmentationOf(f.scene.scan);
        f.tree = mergeTree(f.segments);
        return f;
    }();
    return found;
}

TEST(RockMap, FindsTheRocksOfASceneThatNobodyTunedOn) {
    const Found& f = hangup();
    const RegionMap map = rocksAt(f.segments, f.tree, {});
    EXPECT_GT(map.rocks, 40U);
    EXPECT_GT(test::panopticQuality(f.segments, map, f.scene.truth, 100), 0.80);
    RockSettings coarse;
    coarse.level = 4;
    EXPECT_LT(test::panopticQuality(f.segments, rocksAt(f.segments, f.tree, coarse), f.scene.truth, 100),
              test::panopticQuality(f.segments, map, f.scene.truth, 100));
}

TEST(RockMap, AgainGivesTheSameLabels) {
    const Found& f = hangup();
    const Segmentation again = test::segmentationOf(f.scene.scan);
    EXPECT_EQ(again.segment, f.segments.segment);
    const MergeTree tree = mergeTree(again);
    for (const double level : {-4.0, 0.0, 2.5}) {
        RockSettings settings;
        settings.level = level;
        EXPECT_EQ(rockLabels(again, rocksAt(again, tree, settings)), rockLabels(f.segments, rocksAt(f.segments, f.tree, settings)));
    }
}

TEST(RockMap, RocksComeFirstAndTheLargestOfThemFirst) {
    const Found& f = hangup();
    const RegionMap map = rocksAt(f.segments, f.tree, {});
    for (std::uint32_t n = 1; n < map.regions.size(); ++n) {
        EXPECT_EQ(n <= map.rocks, map.regions[n].kind == RegionKind::Rock);
        EXPECT_FALSE(n > 1 && n <= map.rocks && map.regions[n].sums.areaM2 > map.regions[n - 1].sums.areaM2);
        EXPECT_EQ(map.regions[n].kind == RegionKind::Fines, map.regions[n].sums.cells < 100U);
        EXPECT_LE(map.regions[n].nearShare, 1.0);
    }
    const Grid<std::uint32_t> labels = rockLabels(f.segments, map);
    std::vector<std::uint32_t> cells(map.rocks + 1);
    for (std::size_t k = 0; k < labels.size(); ++k) {
        ASSERT_LE(labels[k], map.rocks);
        if (f.segments.inputs.surface->inverse.support[k] == Support::Measured) ++cells[labels[k]];
    }
    for (std::uint32_t n = 1; n <= map.rocks; ++n) EXPECT_EQ(cells[n], map.regions[n].sums.cells);
}

TEST(RockMap, WhatIsARockIsSaidByItsSums) {
    const Found& f = hangup();
    const RegionMap map = rocksAt(f.segments, f.tree, {});
    for (std::uint32_t n = 1; n < map.regions.size(); ++n) {
        const Region& r = map.regions[n];
        if (r.kind == RegionKind::Fines) continue;
        const std::array<double, kScoreInputs> inputs{
            r.bulge, r.nearShare, std::max(0.0, r.longM - 2.5), r.edgeShare, r.depthRatio, std::max(0.0, 0.05 - r.depthRatio), r.boxShare};
        EXPECT_EQ(scoreInputs(r, map.settings), inputs);
        EXPECT_EQ(r.kind == RegionKind::Rock, r.score > 0 && (r.sweepSides < 3 || r.nearShare >= 0.05) &&
                                                  r.confidence >= kLeastConfidence && (r.sums.sumM / r.sums.cells).norm() < 15);
        double covered = 0;
        for (const RegionBorder& border : map.borders)
            covered += border.a == n || border.b == n ? static_cast<double>(border.sumE2) / 65536 : 0;
        EXPECT_NEAR(r.edgeShare, r.outlineCracks == 0 ? 1 : covered / r.outlineCracks, 1e-9);
        EXPECT_TRUE(r.depthRatio >= 0 && r.depthRatio <= 1 && r.boxShare > 0) << r.depthRatio << " " << r.boxShare;
    }
}

TEST(RockMap, LevelsOfARegionEndWhereItIsSplitAndWhereItIsMerged) {
    const Found& f = hangup();
    const RegionMap map = rocksAt(f.segments, f.tree, {});
    const auto members = [&](std::uint32_t segment, double level) {
        const std::vector<std::uint32_t> group = groupsAt(f.tree, f.segments.count(), level);
        return std::ranges::count(group, group[segment]);
    };
    std::size_t split = 0, merged = 0;
    for (std::size_t n = 1; n < map.regions.size(); ++n) {
        const Region& region = map.regions[n];
        const auto now = members(region.firstSegment, 0);
        EXPECT_EQ(members(region.firstSegment, 0.999 * region.levelsAbove), now);
        EXPECT_EQ(members(region.firstSegment, -0.999 * region.levelsBelow), now);
        if (region.levelsAbove < kMostLevels && ++merged) EXPECT_GT(members(region.firstSegment, region.levelsAbove + 1e-9), now);
        if (region.levelsBelow < kMostLevels && ++split) EXPECT_LT(members(region.firstSegment, -region.levelsBelow - 1e-9), now);
    }
    EXPECT_GT(split, 10U);
    EXPECT_GT(merged, 10U);
}

TEST(RockMap, BordersOfRegionsAreThoseOfTheirSegments) {
    const Found& f = hangup();
    const RegionMap map = rocksAt(f.segments, f.tree, {});
    std::uint64_t ofSegments = 0;
    for (const SegmentBorder& border : f.segments.borders)
        ofSegments += map.regionOfSegment[border.a] != map.regionOfSegment[border.b] ? border.cracks : 0;
    std::uint64_t ofRegions = 0;
    for (const RegionBorder& border : map.borders) {
        EXPECT_LT(border.a, border.b);
        ofRegions += border.cracks;
    }
    EXPECT_EQ(ofSegments, ofRegions);
    EXPECT_TRUE(std::is_sorted(map.borders.begin(), map.borders.end(),
                               [](const auto& x, const auto& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); }));
}

TEST(RockMap, ALevelFurtherUpOnlyJoins) {
    const Found& f = hangup();
    std::vector<std::uint32_t> before = groupsAt(f.tree, f.segments.count(), -4);
    for (double level = -3.5; level <= 4; level += 0.5) {
        const std::vector<std::uint32_t> now = groupsAt(f.tree, f.segments.count(), level);
        for (std::size_t segment = 1; segment < now.size(); ++segment) EXPECT_EQ(now[segment], now[before[segment]]);
        before = now;
    }
}

TEST(RockMap, WhatAPersonSaysOfARegionHolds) {
    const Found& f = hangup();
    const RegionMap map = rocksAt(f.segments, f.tree, {});
    const Region& first = map.regions[1];
    const std::vector<RockCall> called{{first.firstSegment, true}, {first.firstSegment, false}};
    const RegionMap other = rocksAt(f.segments, f.tree, {}, called);
    EXPECT_EQ(other.rocks, map.rocks - 1);
    const Region& now = other.regions[other.regionOfSegment[first.firstSegment]];
    EXPECT_EQ(now.kind, RegionKind::NotRock);
    EXPECT_TRUE(now.byHand);
}

TEST(RockMap, OutsideTheRegionOfInterestNothingIsARock) {
    const Found& f = hangup();
    RockSettings settings;
    settings.region = {{100, 100}, {300, 350}};
    const RegionMap map = rocksAt(f.segments, f.tree, settings);
    EXPECT_GT(map.rocks, 3U);
    EXPECT_LT(map.rocks, rocksAt(f.segments, f.tree, {}).rocks);
    const Grid<std::uint32_t> labels = regionLabels(f.segments, map);
    std::vector<std::uint32_t> inside(map.regions.size());
    for (int i = 100; i <= 300; ++i) {
        for (int j = 100; j <= 350; ++j) {
            if (f.segments.inputs.surface->inverse.isMeasured(i, j)) ++inside[labels.at(i, j)];
        }
    }
    for (std::size_t n = 1; n < map.regions.size(); ++n)
        EXPECT_EQ(2 * inside[n] < map.regions[n].sums.cells, map.regions[n].kind == RegionKind::Outside);
    settings.region = {{100, 100}, {100, 350}, {300, 350}, {300, 100}};
    EXPECT_EQ(rockLabels(f.segments, rocksAt(f.segments, f.tree, settings)), rockLabels(f.segments, map));
}

// The inside of a tunnel reaches all sides of the sweep; its outline is that of the four boulders in front of it.
TEST(RockMap, TheSurroundingsOfRocksAreNotARock) {
    constexpr int kLines = 300, kBeams = 300;
    const auto scan = std::make_shared<const Scan>(test::makeScan(kLines, kBeams, [](int i, int j) {
        const double wall = 2500 / std::cos(0.004 * (j - 150)) + (i * 7 + j * 13) % 5;
        for (const auto& [line, beam] : {std::pair(80, 80), std::pair(90, 210), std::pair(215, 75), std::pair(220, 230)}) {
            const double r = std::hypot(i - line, j - beam) / 32;
            if (r < 1) return wall - 500 - 300 * std::sqrt(1 - r * r);
        }
        return wall;
    }));
    const Segmentation segments = test::segmentationOf(scan);
    const RegionMap map = rocksAt(segments, mergeTree(segments), {});
    EXPECT_EQ(map.rocks, 4U);
    for (std::uint32_t n = 1; n <= map.rocks; ++n) EXPECT_LT(map.regions[n].sums.cells, 3300U);
    EXPECT_EQ(map.regions[5].sweepSides, 4);
}

TEST(RegionOfInterest, HoldsItsOutlineAndNothingBeyond) {
    const std::vector<RegionCorner> triangle{{0, 0}, {10, 0}, {0, 10}};
    for (int i = -2; i <= 12; ++i) {
        for (int j = -2; j <= 12; ++j) EXPECT_EQ(isInside(triangle, i, j), i >= 0 && j >= 0 && i + j <= 10) << i << ", " << j;
    }
    EXPECT_TRUE(isInside({}, 5, 5));
}

TEST(RockSettings, SurviveJsonAndRefuseWhatIsWrong) {
    RockSettings settings;
    settings.level = -1.5;
    settings.minimumCells = 250;
    settings.region = {{1, 2}, {30, 40}, {5, 6}};
    const auto back = rockSettingsFromJson(nlohmann::json(rockSettingsToJson(settings)), "here");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(*back, settings);
    for (const char* text : {R"({"level": 5})", R"({"level": "x"})", R"({"region": [[1, 2]]})", R"({"region": [[1, -2], [3, 4]]})",
                             R"({"region": 7})", R"({"min-cells": 0})", R"({"fine": 1})", "[]"})
        EXPECT_FALSE(rockSettingsFromJson(nlohmann::json::parse(text), "here")) << text;
    const auto region = parseRegion("1,2 30,40");
    ASSERT_TRUE(region);
    EXPECT_EQ(*region, (std::vector<RegionCorner>{{1, 2}, {30, 40}}));
    for (const char* text : {"", "1,2", "1,2 3", "1,2 3,", "1 2 3 4", "a,b c,d", "1,2 -3,4", "1,2;3,4", "99999999999,2 3,4"})
        EXPECT_FALSE(parseRegion(text)) << text;
}

} // namespace
} // namespace edgescan::rocks
