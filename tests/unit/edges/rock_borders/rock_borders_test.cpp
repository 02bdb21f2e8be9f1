// The probability of a rock border: its features against slow versions, where it is unknown, and the view that follows from it.
#include "core/edges/rock_borders/rock_borders.h"

#include "app/lab/sim/simulate.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "tests/support/scans.h"
#include "tests/support/simulated_bell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace edgescan::edges {
namespace {

std::shared_ptr<const Scan> bell() {
    static const auto scan = std::make_shared<const Scan>(*test::simulatedBell(150, 191, 12));
    return scan;
}

std::shared_ptr<const Scan> pileWithLostCells() {
    sim::SimulationSettings settings;
    settings.scene = "pile";
    settings.seed = 11;
    settings.lines = 200;
    settings.beams = 229;
    settings.dropouts = 0.08;
    return std::make_shared<const Scan>(sim::simulate(settings)->scan);
}

Settings onlyBorders(double percent) {
    Settings settings;
    settings.rockBorders = true;
    settings.borderPercent = percent;
    return settings;
}

TEST(RockBorders, WindowsAreSumsOfTheirCells) {
    std::mt19937 random(2);
    Grid<int> values(13, 21);
    for (int& value : values.cells) value = static_cast<int>(random() % 1000);
    const WindowSums<std::uint64_t> sums(13, 21, [&](std::size_t k) { return static_cast<std::uint64_t>(values[k]); });
    for (const int reach : {0, 1, 4, 40}) {
        for (std::size_t k = 0; k < values.size(); ++k) {
            const int line = static_cast<int>(k) / 21, beam = static_cast<int>(k) % 21;
            std::uint64_t sum = 0;
            int cells = 0;
            for (int i = line - reach; i <= line + reach; ++i) {
                for (int j = beam - reach; j <= beam + reach; ++j) {
                    if (!values.contains(i, j)) continue;
                    sum += static_cast<std::uint64_t>(values.at(i, j));
                    ++cells;
                }
            }
            const auto window = sums.around(line, beam, reach);
            ASSERT_EQ(window.sum, sum);
            ASSERT_EQ(window.cells, cells);
        }
    }
}

TEST(RockBorders, AreTheSameForAnyNumberOfThreadsAndForEachCellAlone) {
    const auto detection = detectEdges(bell(), {});
    ASSERT_GT(detection->edges->size(), 500U);
    EXPECT_FALSE(detection->borders.isMade()) << "only those who read them pay";
    const std::vector<BorderPercent>& all = *detection->borders;
    ASSERT_EQ(all.size(), detection->edges->size());
    const auto of = [&](std::span<const std::uint32_t> cells, int threads) {
        return borderPercents(*detection->surface, *detection->responses, detection->settings, cells, threads);
    };
    EXPECT_EQ(of(*detection->edges, 3), all);
    for (std::size_t n = 0; n < all.size(); n += 97) EXPECT_EQ(of(std::span(*detection->edges).subspan(n, 1), 1).front(), all[n]);
}

TEST(RockBorders, EdgesAtVoidsAreBorders) {
    const auto detection = detectEdges(pileWithLostCells(), {});
    std::size_t atVoids = 0;
    for (std::size_t n = 0; n < detection->edges->size(); ++n) {
        const DepthEdge kind = (*detection->classes)[(*detection->edges)[n]];
        if (kind != DepthEdge::Silhouette && kind != DepthEdge::VoidRim) continue;
        ++atVoids;
        EXPECT_EQ((*detection->borders)[n], 100);
    }
    EXPECT_GT(atVoids, 0U);
}

TEST(RockBorders, AreUnknownAtTheEndOfTheGridAndInTinyScans) {
    const auto step = [](int lines, int beams) {
        return std::make_shared<const Scan>(test::makeScan(lines, beams, [&](int, int j) { return j < beams / 2 ? 3000.0 : 4000.0; }));
    };
    for (const auto& [lines, beams, known] : {std::tuple{40, 40, true}, {40, 7, false}, {3, 3, false}}) {
        const auto detection = detectEdges(step(lines, beams), {});
        for (const BorderPercent percent : *detection->borders) EXPECT_EQ(percent != kUnknownBorder, known) << lines << " x " << beams;
    }
}

TEST(RockBorders, AreUnknownInScansOfDepthCameras) {
    Settings camera;
    camera.noiseKind = NoiseKind::Camera;
    const auto detection = detectEdges(bell(), camera);
    for (std::size_t n = 0; n < detection->edges->size(); ++n)
        EXPECT_TRUE((*detection->borders)[n] == kUnknownBorder || (*detection->borders)[n] == 100);
}

TEST(RockBorders, TheViewIsThePartOfTheEdgesWithThatProbability) {
    const auto all = detectEdges(bell(), {});
    for (const double percent : {1.0, 30.0, 70.0, 99.0}) {
        const auto view = detectEdges(bell(), onlyBorders(percent));
        std::vector<std::uint32_t> wanted;
        for (std::size_t n = 0; n < all->edges->size(); ++n) {
            if ((*all->borders)[n] >= percent) wanted.push_back((*all->edges)[n]);
        }
        EXPECT_EQ(*view->edges, wanted) << percent;
    }
}

// Threshold map, curve and the threshold of a cell describe the same edges as the decision at each threshold.
TEST(RockBorders, ThresholdsOfTheViewAgreeWithItsEdges) {
    const auto detection = detectEdges(bell(), onlyBorders(40));
    const ThresholdMap map = thresholdMapOf(*detection);
    const std::vector<double> strengths{0.5, 0.8, 1.0, 1.7};
    const std::vector<std::size_t> counts =
        edgeCounts(rowOf(Method::EdgeScanPlus).decision.levels(*detection, strengths), strengths.size());
    for (std::size_t n = 0; n < strengths.size(); ++n) {
        Settings settings = onlyBorders(40);
        settings.sensitivity = strengths[n];
        const auto there = detectEdges(bell(), settings);
        EXPECT_EQ(edgesAt(map, strengths[n]), *there->mask) << strengths[n];
        EXPECT_EQ(counts[n], there->edges->size()) << strengths[n];
    }
    for (std::size_t k = 0; k < map.highest.size(); k += 211)
        EXPECT_EQ(rowOf(Method::EdgeScanPlus).decision.threshold(*detection, k), map.highest[k]) << k;
}

// A pile with lost cells has edges at voids that are jumps, too: no view leaves them out.
TEST(RockBorders, EdgesAtVoidsStayInTheView) {
    const auto view = detectEdges(pileWithLostCells(), onlyBorders(70));
    std::size_t alsoJumps = 0;
    for (const ClassCells& edges : edgesAtVoids(*view->responses, view->settings)) {
        for (const std::uint32_t k : edges.cells) {
            EXPECT_NE((*view->mask)[k], 0) << k;
            alsoJumps += (*view->classes)[k] != edges.kind ? 1 : 0;
        }
    }
    EXPECT_GT(alsoJumps, 0U);
    EXPECT_EQ(edgesAt(thresholdMapOf(*view), 1.0), *view->mask);
}

TEST(RockBorders, ReasonsAreAllKindsOfEvidenceTheStrongestFirst) {
    const auto detection = detectEdges(bell(), {});
    const auto reasons = borderReasons(*detection->surface, *detection->responses, detection->settings, (*detection->edges)[200]);
    ASSERT_EQ(reasons.size(), static_cast<std::size_t>(kBorderEvidences));
    EXPECT_TRUE(std::ranges::is_sorted(reasons, std::greater<>{}, [](const BorderReason& r) { return std::abs(r.added); }));
    EXPECT_EQ(evidenceOf(0), BorderEvidence::Steps);
    EXPECT_EQ(evidenceOf(kBorderFeatures - 1), BorderEvidence::Distance);
}

} // namespace
} // namespace edgescan::edges
