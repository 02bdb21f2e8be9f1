// Bodies, outlines and the prices of merges against values that are computed from the cells of a whole body.
#include "core/rocks/segmentation/borders.h"
#include "core/rocks/segmentation/merge_tree.h"
#include "tests/support/rock_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace edgescan::rocks {
namespace {

const Segmentation& bell() {
    static const Segmentation segments = test::segmentationOf(test::rockScene("hangup", 815, 140, 160).scan);
    return segments;
}

/// Everything that follows from the grid of segments, when `group` are the segments.
Segmentation grouped(const Segmentation& segments, const std::vector<std::uint32_t>& group) {
    Segmentation coarse = segments;
    for (std::size_t k = 0; k < coarse.segment.size(); ++k) coarse.segment[k] = group[coarse.segment[k]];
    for (SegmentRun& run : coarse.beamRuns) run.segment = group[run.segment];
    std::vector<SegmentSums> sums(segments.sums.size());
    std::vector<std::int64_t> outer(segments.outer.size());
    for (std::size_t n = 1; n < sums.size(); ++n) {
        sums[group[n]].add(segments.sums[n]);
        outer[group[n]] += segments.outer[n];
    }
    coarse.sums = std::move(sums);
    coarse.outer = std::move(outer);
    return coarse;
}

void expectNear(double a, double b, double share) { EXPECT_NEAR(a, b, share * std::max(1.0, std::abs(b))); }

TEST(Bodies, SumsOfMergedSegmentsAreThoseOfTheirCells) {
    const Segmentation& segments = bell();
    const std::vector<std::uint32_t> group = groupsAt(mergeTree(segments.count(), segments.borders), segments.count(), 0);
    const std::vector<BodySums> leaves = segmentBodies(segments), whole = segmentBodies(grouped(segments, group));
    std::vector<BodySums> merged(leaves.size());
    for (std::size_t n = 1; n < leaves.size(); ++n) merged[group[n]].add(leaves[n]);
    std::size_t bodies = 0;
    for (std::size_t n = 1; n < merged.size(); ++n) {
        if (group[n] != n) continue;
        ++bodies;
        EXPECT_EQ(merged[n].cells, whole[n].cells);
        EXPECT_EQ(merged[n].outerLength, whole[n].outerLength);
        for (std::size_t k = 0; k < merged[n].angles.size(); ++k) expectNear(merged[n].angles[k], whole[n].angles[k], 1e-9);
        ASSERT_EQ(merged[n].hull.size(), whole[n].hull.size());
        const BodyShape a = shapeOf(merged[n], segments.inputs.responses->noise);
        const BodyShape b = shapeOf(whole[n], segments.inputs.responses->noise);
        expectNear(a.roughness, b.roughness, 1e-6);
        expectNear(a.fill, b.fill, 1e-9);
        expectNear(a.bulge, b.bulge, 1e-5);
    }
    EXPECT_GT(bodies, 20U);
}

/// A body that covers all cells of a grid whose u is a quadric of the angles.
BodySums bodyOf(double curvature, double noise) {
    BodySums body;
    std::uint32_t dice = 1;
    for (int i = -10; i <= 10; ++i) {
        for (int j = -10; j <= 10; ++j) {
            dice = dice * 1664525U + 1013904223U;
            const double x = 0.005 * j, y = 0.005 * i, error = noise * (static_cast<double>(dice >> 8U) / 8388608.0 - 1.0);
            const double u = 0.2 + 0.3 * x - 0.1 * y - curvature * (x * x + y * y) + error;
            const std::array<double, 5> px{1, x, x * x, x * x * x, x * x * x * x}, py{1, y, y * y, y * y * y, y * y * y * y};
            for (int sum = 0; sum <= 4; ++sum) {
                for (int b = 0; b <= sum; ++b) {
                    const auto at = static_cast<std::size_t>(sum * (sum + 1) / 2 + b);
                    const double power = px[static_cast<std::size_t>(sum - b)] * py[static_cast<std::size_t>(b)];
                    body.angles[at] += power;
                    if (sum <= 2) body.inverses[at] += power * u;
                }
            }
            body.sumU2 += u * u;
            ++body.cells;
            ++body.points.cells;
            const Eigen::Vector3d point = Eigen::Vector3d(x, 1, y) / u;
            body.points.sumM += point;
            body.points.sumM2 += point * point.transpose();
        }
    }
    body.hull = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    return body;
}

TEST(Bodies, AQuadricHasNoRoughnessAndItsBulgeHasItsSign) {
    constexpr RangeNoise kNoise{5, 0, 0};
    const BodySums ball = bodyOf(2.0, 0), bowl = bodyOf(-2.0, 0), rough = bodyOf(2.0, 0.002);
    EXPECT_LT(shapeOf(ball, kNoise).roughness, 1.0); // 5 mm; narrow bodies need a ridge
    EXPECT_GT(shapeOf(ball, kNoise).bulge, 0.0);
    EXPECT_LT(shapeOf(bowl, kNoise).bulge, 0.0);
    // 0.002 / sqrt(3) per metre at 5 m is 29 mm.
    EXPECT_NEAR(shapeOf(rough, kNoise).roughness, 29.0 / 5.0, 0.5);
    EXPECT_NEAR(shapeOf(ball, kNoise).fill, 1.0, 0.1);
}

TEST(Outlines, AreTheSumsOverTheCracksOfTheGridWithAnyNumberOfThreads) {
    const Segmentation& segments = bell();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> cracks;
    std::vector<std::int64_t> outer(segments.sums.size());
    const AngularSteps& steps = segments.inputs.surface->steps;
    const auto lengthOf = [](float rad) { return std::llround(static_cast<double>(rad) / kLengthStep); };
    const Grid<std::uint32_t>& grid = segments.segment;
    const auto at = [&grid](int i, int j) { return grid.contains(i, j) ? grid.at(i, j) : kNoSegment; };
    for (int i = -1; i < grid.lines; ++i) {
        for (int j = -1; j < grid.beams; ++j) {
            const auto look = [&](std::uint32_t a, std::uint32_t b, std::int64_t length) {
                if (a != b && a != kNoSegment && b != kNoSegment) cracks[std::minmax(a, b)] += length;
                if (a != b && (a == kNoSegment || b == kNoSegment)) outer[std::max(a, b)] += length;
            };
            const int line = std::max(i, 0), beam = std::max(j, 0);
            if (i >= 0) look(at(i, j), at(i, j + 1), lengthOf(steps.lineAt(line, beam)));
            if (j >= 0) look(at(i, j), at(i + 1, j), lengthOf(steps.beam[static_cast<std::size_t>(beam)]));
        }
    }
    ASSERT_EQ(segments.outlines.size(), segments.borders.size());
    for (std::size_t n = 0; n < segments.borders.size(); ++n) {
        const OutlineSums& sums = segments.outlines[n];
        EXPECT_EQ(sums.length, (cracks[{segments.borders[n].a, segments.borders[n].b}]));
        EXPECT_EQ(std::accumulate(sums.byEdge.begin(), sums.byEdge.end(), std::int64_t{0}), sums.length);
        for (const std::int64_t turn : sums.turn) EXPECT_LE(std::abs(turn), 2 * sums.length + 1);
    }
    EXPECT_EQ(segments.outer, outer);
}

TEST(MergePrice, EveryMergeIsThePairWhosePriceIsTheLowestAtItsTime) {
    const Segmentation& segments = bell();
    // A price on which the other numbers of the pair count, too.
    MergeRules rules;
    std::size_t asked = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> prices;
    rules.price = [&](const PairFeatures& features, std::uint32_t a, std::uint32_t b) {
        ++asked;
        EXPECT_LT(a, b);
        for (const float feature : features) EXPECT_TRUE(std::isfinite(feature));
        return prices[{a, b}] =
                   static_cast<double>(features[0]) + 0.3 * static_cast<double>(features[24]) - static_cast<double>(features[40]);
    };
    std::set<std::uint32_t> gone;
    double highest = -1e9;
    rules.merged = [&](const Merge& merge) {
        const auto here = prices.find({merge.remaining, merge.gone});
        ASSERT_NE(here, prices.end());
        for (const auto& [pair, price] : prices) EXPECT_GE(price, here->second);
        highest = std::max(highest, here->second);
        EXPECT_EQ(merge.height, highest);
        gone.insert(merge.gone);
        // A border of the merged body that did not change may keep its price; one that two borders became is asked again.
        prices.erase({merge.remaining, merge.gone});
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> renamed;
        for (const auto& [pair, price] : prices) {
            const std::uint32_t a = pair.first == merge.gone ? merge.remaining : pair.first;
            const std::uint32_t b = pair.second == merge.gone ? merge.remaining : pair.second;
            renamed[{std::min(a, b), std::max(a, b)}] = price;
        }
        prices = std::move(renamed);
    };
    const MergeTree tree = mergeTree(segments, rules);
    EXPECT_EQ(tree.merges.size(), gone.size());
    EXPECT_GT(tree.merges.size(), segments.count() / 2);
    EXPECT_GT(asked, segments.borders.size());
}

TEST(MergePrice, ThePairOfTwoBodiesIsTheSameFromBothSides) {
    const Segmentation& segments = bell();
    const std::vector<BodySums> sums = segmentBodies(segments);
    const RangeNoise noise = segments.inputs.responses->noise;
    for (std::size_t n = 0; n < segments.borders.size(); n += 7) {
        const SegmentBorder& border = segments.borders[n];
        const auto bodyOfSegment = [&](std::uint32_t segment) {
            return Body{sums[segment], shapeOf(sums[segment], noise), {{border.meanZ(), segments.outlines[n].length}}};
        };
        const Body a = bodyOfSegment(border.a), b = bodyOfSegment(border.b);
        if (a.sums.points.cells == b.sums.points.cells) continue;
        EXPECT_EQ(pairFeatures(a, b, {border, segments.outlines[n]}, noise),
                  pairFeatures(b, a, {border.reversed(), segments.outlines[n]}, noise));
    }
}

} // namespace
} // namespace edgescan::rocks
