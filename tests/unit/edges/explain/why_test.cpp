// Why a cell is an edge: the explanation must agree with the method.
#include "app/lab/sim/simulate.h"
#include "core/edges/explain/why.h"
#include "core/edges/gray/canny.h"
#include "core/edges/pipeline/edge_count_curve.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/edges/settings/slider_scale.h"
#include "core/exports/report.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace edgescan::edges {
namespace {

std::vector<Settings> everyMethod() {
    std::vector<Settings> all;
    for (const Choice& choice : findParameter("method")->choices) {
        Settings s;
        findParameter("method")->set(s, choice.value);
        s.lower = s.method == Method::Kirsch ? 60 : 12;
        all.push_back(s);
        s.classes = kClassRock | kClassBorder;
        s.maskMissing = false;
        s.norm = Norm::L2;
        all.push_back(s);
    }
    return all;
}

TEST(Why, TheValueAtWhichACellAppearsIsTheLastOneAtWhichItDoes) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 50, 3, 0.03));
    std::mt19937 random(5);
    int appear = 0, vanish = 0;
    for (const Settings& settings : everyMethod()) {
        const auto detection = detectEdges(scan, settings);
        for (int n = 0; n < 12; ++n) {
            // Half of the cells are edges, half are random cells.
            const std::size_t k = n % 2 == 0 && !detection->edges->empty() ? (*detection->edges)[random() % detection->edges->size()]
                                                                           : random() % scan->cells();
            const Why why = whyCell(*detection, k);
            const Parameter& parameter = *findParameter(why.parameter);
            EXPECT_EQ(why.probe.edge, (*detection->mask)[k] != 0);
            EXPECT_TRUE(!why.probe.edge || (why.appearsAt && *why.appearsAt >= parameter.get(settings))) << why.verdict;
            if (!why.appearsAt) continue;
            ++appear;
            Settings at = settings;
            parameter.set(at, *why.appearsAt);
            EXPECT_NE((*detectEdges(scan, at)->mask)[k], 0) << why.verdict;
            const double beyond = *why.appearsAt + std::pow(10.0, -parameter.decimals) * 1.001;
            if (beyond > parameter.maximum) continue;
            ++vanish;
            parameter.set(at, beyond);
            EXPECT_EQ((*detectEdges(scan, at)->mask)[k], 0) << why.verdict;
        }
    }
    EXPECT_GT(appear, 0);
    EXPECT_GT(vanish, 0);
}

// Of an edge and of a cell without one.
TEST(Why, TheReasonIsTrueForTheNumbers) {
    const auto simulated = sim::simulate({.lines = 90, .beams = 81, .dropouts = 0.02, .slips = 0.05});
    ASSERT_TRUE(simulated);
    std::array<int, 6> times{};
    int byLength = 0;
    for (const auto& scan : {std::make_shared<Scan>(test::boxesScan(40, 50, 3, 0.03)), std::make_shared<Scan>(simulated->scan)}) {
        for (Settings settings : everyMethod()) {
            settings.minimumLength = settings.maskMissing ? 9 : 1;
            settings.rockBorders = !settings.maskMissing;
            const auto detection = detectEdges(scan, settings);
            for (std::size_t k = 0; k < scan->cells(); k += 13) {
                const Why why = whyCell(*detection, k);
                if (why.probe.edge && why.level == StrengthLevel::Above) EXPECT_GT(why.strength, why.upper) << why.verdict;
                if (why.probe.edge && why.level == StrengthLevel::Between) EXPECT_GT(why.strength, why.lower) << why.verdict;
                if (why.verdict.find("because its chain is then shorter") != std::string::npos && ++byLength <= 9) {
                    Settings at = settings;
                    at.sensitivity = *why.appearsAt + 0.0101;
                    EXPECT_EQ((*detectEdges(scan, at)->mask)[k], 0) << why.verdict;
                    at.minimumLength = 1;
                    EXPECT_NE((*detectEdges(scan, at)->mask)[k], 0) << why.verdict;
                }
                if (why.probe.edge || why.probe.state != CellState::Valid || !why.takesPart) continue;
                const NoEdge reason = noEdgeReason(why);
                ++times.at(static_cast<std::size_t>(reason));
                if (reason == NoEdge::TooWeak) EXPECT_LE(why.strength, why.lower) << why.verdict;
                if (reason == NoEdge::StrongerNeighbour) EXPECT_GE(why.suppressedBy->strength, why.compared) << why.verdict;
                if (reason == NoEdge::NoStrongPlace) EXPECT_GT(why.strength, why.lower) << why.verdict;
                if (reason == NoEdge::TooShort) EXPECT_LT(why.chainCells, settings.minimumLength) << why.verdict;
            }
        }
    }
    for (const int each : times) EXPECT_GT(each, 0);
    EXPECT_GT(byLength, 0);
}

// "the strength 1.73 ... disappears above 1.72" would contradict itself.
TEST(Why, TheStrengthIsRoundedAsItsLimit) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 50, 3, 0.03));
    const auto detection = detectEdges(scan, Settings{});
    int checked = 0;
    for (const std::uint32_t k : *detection->edges) {
        Why why = whyCell(*detection, k);
        if (why.level != StrengthLevel::Above || why.verdict.find("the strength ") == std::string::npos) continue;
        why.strength = 1.728;
        why.appearsAt = 1.72;
        const std::string verdict = whyVerdict(why, detection->settings, Naming::Keys);
        EXPECT_NE(verdict.find("the strength 1.72 "), std::string::npos) << verdict;
        EXPECT_EQ(verdict.find("1.73"), std::string::npos) << verdict;
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

TEST(Why, TheThresholdOfOneCellIsThatOfTheMap) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 50, 3, 0.03));
    std::size_t edges = 0;
    for (Settings settings : everyMethod()) {
        for (const int length : {1, 6}) {
            settings.minimumLength = length;
            const auto detection = detectEdges(scan, settings);
            const ThresholdMap map = thresholdMapOf(*detection);
            for (std::size_t k = 0; k < scan->cells(); k += 11) {
                ASSERT_EQ(rowOf(settings.method).decision.threshold(*detection, k), map.highest[k]) << k;
                edges += map.highest[k] >= 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(edges, 100U);
}

TEST(Why, TheCurveCountsTheCellsOfTheMap) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 50, 3, 0.03));
    std::size_t edges = 0;
    for (Settings settings : everyMethod()) {
        settings.minimumLength = 4;
        const auto detection = detectEdges(scan, settings);
        const EdgeCountCurve curve = edgeCountCurve(*detection, sliderValues(sweptParameter(settings.method)));
        const ThresholdMap map = thresholdMapOf(*detection);
        for (std::size_t n = 0; n < curve.thresholds.size(); ++n) {
            ASSERT_EQ(curve.edges[n], edgeCells(edgesAt(map, curve.thresholds[n])).size()) << curve.thresholds[n];
            edges += curve.edges[n];
        }
    }
    EXPECT_GT(edges, 10000U);
}

TEST(Why, AWeakCellShowsItsWayToAStrongOne) {
    // A step in levels that fades along a column: strong at the top, weak below.
    const Scan scan = test::makeScan(30, 20, [](int i, int j) { return j < 10 ? 5000.0F : 5000.0F + static_cast<float>(1200 - 36 * i); });
    Settings s = cannySettings();
    s.scaling = Scaling::Window;
    s.nearMm = 0;
    s.farMm = 25500;
    s.lower = 9; // 3 levels of 100 mm; strong from 9 levels
    const auto detection = detectEdges(std::make_shared<Scan>(scan), s);
    const int beam = detection->mask->at(15, 9) != 0 ? 9 : 10;
    const Why why = whyCell(*detection, detection->mask->index(15, beam));
    ASSERT_TRUE(why.probe.edge);
    EXPECT_EQ(why.level, StrengthLevel::Between);
    ASSERT_GT(why.chain.size(), 2U);
    EXPECT_EQ(why.chain.front().line, 15);
    EXPECT_GT(why.chain.back().strength, why.upper);
    for (std::size_t n = 1; n < why.chain.size(); ++n) {
        EXPECT_LE(std::abs(why.chain[n].line - why.chain[n - 1].line), 1);
        EXPECT_LE(std::abs(why.chain[n].beam - why.chain[n - 1].beam), 1);
        EXPECT_GT(why.chain[n - 1].strength, why.lower);
    }
    EXPECT_NE(why.verdict.find("its chain reaches"), std::string::npos) << why.verdict;
    EXPECT_NEAR(std::abs(*why.directionDeg), 0, 10);
    // At the next cell the same step is slightly weaker: the edge suppresses it.
    const Why neighbour = whyCell(*detection, detection->mask->index(5, beam == 9 ? 10 : 9));
    EXPECT_FALSE(neighbour.probe.edge);
    ASSERT_TRUE(neighbour.suppressedBy) << neighbour.verdict;
    EXPECT_EQ(neighbour.suppressedBy->beam, beam);
    EXPECT_GE(neighbour.suppressedBy->strength, neighbour.compared);
}

TEST(Why, AHoleSaysThatItHasNoRange) {
    const auto scan = std::make_shared<Scan>(test::makeScan(20, 20, [](int i, int j) { return i == 10 && j == 10 ? 0.0F : 4000.0F; }));
    int asked = 0;
    for (const Settings& settings : everyMethod()) {
        if (!settings.maskMissing && findParameter("mask-missing")->usedBy(settings)) continue;
        const Why why = whyCell(*detectEdges(scan, settings), scan->rangeMm.index(10, 10));
        ++asked;
        EXPECT_FALSE(why.takesPart);
        EXPECT_EQ(why.verdict.find("No edge: it has no range"), 0U) << why.verdict;
        EXPECT_FALSE(why.appearsAt);
    }
    EXPECT_GT(asked, 0);
}

TEST(Why, TheReportHoldsWhatTheCommandLineContractNames) {
    const auto scan = std::make_shared<Scan>(test::boxesScan(40, 50, 3));
    const auto detection = detectEdges(scan, cannySettings());
    const nlohmann::ordered_json report = exports::whyReport(*detection, whyCell(*detection, (*detection->edges)[3]));
    for (const char* key :
         {"line", "beam", "range_mm", "gray", "smoothed", "gradient", "suppressed_by", "thresholds", "chain", "appears_at", "verdict"})
        EXPECT_TRUE(report.contains(key)) << key;
    EXPECT_EQ(report["thresholds"]["lower"], 6.0);
    EXPECT_EQ(report["thresholds"]["upper"], 18.0);
    EXPECT_GE(report["appears_at"]["lower"], 6.0);
    EXPECT_EQ(std::string(report["thresholds"]["meaning"]).find("weak edge from a step of "), 0U);
}

} // namespace
} // namespace edgescan::edges
