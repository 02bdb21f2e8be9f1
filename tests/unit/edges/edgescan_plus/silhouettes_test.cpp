// Outlines before a void, as distinguished from missing data.
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/edgescan_plus/silhouettes.h"

#include "core/edges/pipeline/pipeline.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace edgescan::edges {
namespace {

constexpr int kLines = 90, kBeams = 120;

// A box 1 m in front of a wall, lines 30 to 59 and beams 40 to 69; next to it, at higher beams, a stripe of 12 cells without a return.
std::shared_ptr<const Scan> boxWithShadow(double boxMm = 4000) {
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    return std::make_shared<const Scan>(test::makeScan(kLines, kBeams, [&](int i, int j) {
        const bool rows = i >= 30 && i < 60;
        if (rows && j >= 70 && j < 82) return 0.0;
        return test::wallRangeMm(polar, i, j, rows && j >= 40 && j < 70 ? boxMm : 5000.0);
    }));
}

std::size_t silhouettesOf(const Detection& detection) { return countClasses(detection)[static_cast<std::size_t>(DepthEdge::Silhouette)]; }

TEST(Silhouettes, TheSideOfABoxBeforeItsShadowIsOneAndTheWallBehindIsNone) {
    const auto scan = boxWithShadow();
    const auto detection = detectEdges(scan, Settings{});
    const std::vector<std::uint32_t>& cells = detection->responses->silhouettes;
    std::set<std::uint32_t> wanted;
    for (int i = 30; i < 60; ++i) wanted.insert(static_cast<std::uint32_t>(scan->rangeMm.index(i, 69)));
    EXPECT_TRUE(std::ranges::is_sorted(cells));
    EXPECT_EQ(std::set<std::uint32_t>(cells.begin(), cells.end()), wanted);
    for (const std::uint32_t k : wanted) EXPECT_EQ((*detection->mask)[k], 255);
    EXPECT_GE(silhouettesOf(*detection), 26U); // corners also count as jumps
    Settings without;
    without.classes &= ~kClassSilhouette;
    EXPECT_EQ(silhouettesOf(*detectEdges(scan, without)), 0U);
}

TEST(Silhouettes, MissingDataOnOneSurfaceHaveNone) {
    EXPECT_TRUE(detectEdges(boxWithShadow(5000), Settings{})->responses->silhouettes.empty());
}

// A shadow so narrow that the gap is filled, along beams or along lines: the straight line across it spreads the jump.
TEST(Silhouettes, AGapThatIsFilledHidesNoOutline) {
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    for (const bool alongLines : {false, true}) {
        for (int width = 1; width <= 4; ++width) {
            const auto scan = [&](double nearMm) {
                return std::make_shared<const Scan>(test::makeScan(kLines, kBeams, [&](int i, int j) {
                    const int n = alongLines ? i : j;
                    if (n >= 45 && n < 45 + width) return 0.0;
                    return test::wallRangeMm(polar, i, j, n < 45 ? nearMm : 5000.0);
                }));
            };
            const auto torn = detectEdges(scan(4700), Settings{});
            std::set<std::uint32_t> wanted;
            for (int m = 0; m < (alongLines ? kBeams : kLines); ++m)
                wanted.insert(static_cast<std::uint32_t>(alongLines ? torn->mask->index(44, m) : torn->mask->index(m, 44)));
            const std::vector<std::uint32_t>& cells = torn->responses->silhouettes;
            EXPECT_EQ(std::set<std::uint32_t>(cells.begin(), cells.end()), wanted) << alongLines << " " << width;
            for (const std::uint32_t k : wanted) EXPECT_EQ((*torn->mask)[k], 255) << alongLines << " " << width << " " << k;
            EXPECT_TRUE(detectEdges(scan(5000), Settings{})->responses->silhouettes.empty()) << "a drop-out has no outline (S3)";
        }
    }
}

// The same hole with a step below the jump threshold: not certain.
TEST(Silhouettes, AStepThatIsNoJumpIsNone) { EXPECT_TRUE(detectEdges(boxWithShadow(4970), Settings{})->responses->silhouettes.empty()); }

TEST(Silhouettes, AVoidThatReachesTheBorderHasNoOutline) {
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    const auto scan = std::make_shared<const Scan>(
        test::makeScan(kLines, kBeams, [&](int i, int j) { return j >= 70 || i >= 60 ? 0.0 : test::wallRangeMm(polar, i, j, 4000.0); }));
    EXPECT_TRUE(detectEdges(scan, Settings{})->responses->silhouettes.empty());
}

// A floor that slants away by 75 degrees along the beams loses its returns, and there is a wall behind.
TEST(Silhouettes, ASurfaceThatSlantsAwayIsNone) {
    const double slant = std::tan(75 * std::numbers::pi / 180), step = 0.25 * std::numbers::pi / 180;
    const auto scan = std::make_shared<const Scan>(test::makeScan(kLines, kBeams, [&](int, int j) {
        if (j >= 60 && j < 70) return 0.0;
        return j >= 70 ? 30000.0 : 3000.0 * std::exp(slant * step * (j - 30));
    }));
    EXPECT_TRUE(detectEdges(scan, Settings{})->responses->silhouettes.empty());
}

TEST(Silhouettes, ShortOnesAreDroppedAndTheThresholdMapKnowsTheSame) {
    const auto scan = boxWithShadow();
    const auto found = detectEdges(scan, Settings{});
    Settings settings;
    settings.classes = kClassSilhouette;
    settings.minimumLength = 30;
    ASSERT_EQ(edgesAtVoids(*found->responses, settings).size(), 1U);
    EXPECT_EQ(edgesAtVoids(*found->responses, settings).front().cells.size(), 30U);
    settings.minimumLength = 31;
    EXPECT_TRUE(edgesAtVoids(*found->responses, settings).front().cells.empty());
}

} // namespace
} // namespace edgescan::edges
