// How likely an edge is the border of a rock, and why an edge is left out.
#include "app/lab/sim/simulate.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace edgescan::edges {
namespace {

std::shared_ptr<const Scan> simulatedBell() {
    return std::make_shared<const Scan>(sim::simulate({.lines = 90, .beams = 120, .dropouts = 0.02})->scan);
}

bool isSaid(const Why& why, const Detection& detection, const std::string& words) {
    return whyText(why, detection.settings).find(words) != std::string::npos;
}

TEST(WhyBorder, AnEdgeHasTheProbabilityOfTheDetectionAndWhatDecidedIt) {
    const auto detection = detectEdges(simulatedBell(), {});
    int decided = 0, unknown = 0;
    for (std::size_t n = 0; n < detection->edges->size(); n += 11) {
        const Why why = whyCell(*detection, (*detection->edges)[n]);
        ASSERT_EQ(why.border, (*detection->borders)[n]);
        EXPECT_FALSE(why.leftOut);
        EXPECT_LE(why.borderReasons.size(), 3U);
        EXPECT_TRUE(std::ranges::is_sorted(why.borderReasons, std::ranges::greater{}, [](const auto& r) { return std::abs(r.added); }));
        if (*why.border == kUnknownBorder) {
            ++unknown;
            EXPECT_TRUE(isSaid(why, *detection, "It is unknown if it is the border of a rock"));
            continue;
        }
        EXPECT_TRUE(isSaid(why, *detection, "It is " + std::to_string(*why.border) + " % likely the border of a rock"));
        if (why.probe.kind >= DepthEdge::Border) EXPECT_EQ(*why.border, 100);
        if (why.borderReasons.empty()) continue;
        ++decided;
        EXPECT_TRUE(isSaid(why, *detection, why.borderReasons.front().added > 0 ? "(for it)" : "(against it)"));
        const auto report = exports::whyReport(*detection, why);
        EXPECT_EQ(report["border"]["percent"], *why.border);
        EXPECT_EQ(report["border"]["evidence"].size(), why.borderReasons.size());
    }
    EXPECT_GT(decided, 10);
    EXPECT_GT(unknown, 0);
}

TEST(WhyBorder, AnEdgeThatIsLeftOutSaysFromWhereOnItIsShown) {
    const auto scan = simulatedBell();
    Settings settings;
    const auto all = detectEdges(scan, settings);
    settings.rockBorders = true;
    settings.borderPercent = 50;
    const auto some = detectEdges(scan, settings);
    int left = 0, shown = 0;
    for (std::size_t n = 0; n < all->edges->size(); n += 3) {
        const std::size_t k = (*all->edges)[n];
        const Why why = whyCell(*some, k);
        ASSERT_EQ(why.border, (*all->borders)[n]);
        EXPECT_NE(why.leftOut, why.probe.edge);
        EXPECT_EQ(why.leftOut, *why.border < 50);
        why.leftOut ? ++left : ++shown;
        if (!why.leftOut) continue;
        EXPECT_EQ(noEdgeReason(why), NoEdge::NotBorder);
        EXPECT_EQ(why.verdict.find("Left out: it is an edge, but only " + std::to_string(*why.border) + " % likely"), 0U) << why.verdict;
        EXPECT_NE(why.verdict.find("from 50 % on are shown (border-from)"), std::string::npos) << why.verdict;
        EXPECT_EQ(exports::whyReport(*some, why)["border"]["left_out"], true);
    }
    EXPECT_GT(left, 3);
    EXPECT_GT(shown, 5);
    for (std::size_t k = 0; k < scan->cells(); k += 131) {
        if ((*all->mask)[k] != 0) continue;
        const Why why = whyCell(*some, k);
        EXPECT_FALSE(why.leftOut || why.border) << why.verdict;
    }
}

TEST(WhyBorder, NothingIsSaidOfMethodsOnGrayLevels) {
    Settings settings;
    settings.method = Method::Canny;
    const auto detection = detectEdges(simulatedBell(), settings);
    const Why why = whyCell(*detection, detection->edges->front());
    EXPECT_FALSE(why.border);
    EXPECT_FALSE(isSaid(why, *detection, "border of a rock"));
    EXPECT_TRUE(exports::whyReport(*detection, why)["border"].is_null());
}

} // namespace
} // namespace edgescan::edges
