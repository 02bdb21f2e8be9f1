// The values reported for a cell are those that the detection of the whole scan used.
#include "core/edges/edgescan_plus/cell_probe.h"

#include "app/lab/sim/simulate.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/report.h"
#include "core/files/open_save/open_scan.h"
#include "tests/support/depth_edges.h"
#include "tests/support/scans.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <regex>
#include <string>

namespace edgescan::edges {
namespace {

Scan smallBell(double interlaceDeg = 0.0) {
    sim::SimulationSettings settings;
    settings.lines = 150;
    settings.beams = 160;
    settings.seed = 11;
    settings.dropouts = 0.03;
    settings.interlaceDeg = interlaceDeg;
    return sim::simulate(settings)->scan;
}

bool besideFilled(const InverseRange& inverse, int line, int beam) {
    for (int i = line - 1; i <= line + 1; ++i) {
        for (int j = beam - 1; j <= beam + 1; ++j) {
            if (inverse.support.contains(i, j) && inverse.support.at(i, j) == Support::Filled) return true;
        }
    }
    return false;
}

// Every reported part must agree with the responses of the whole scan; strengths to the last bit.
void expectSameAsWhole(const Scan& scan, const Settings& settings, int cells) {
    const DepthResponses whole = test::depthResponses(scan, settings);
    const InverseRange inverse = inverseRange(scan);
    std::mt19937 random(7);
    int exact = 0;
    int jumps = 0;
    int folds = 0;
    int outdone = 0;
    std::vector<std::size_t> asked{0, static_cast<std::size_t>(scan.beams()) - 1, scan.cells() - 1};
    std::vector<std::size_t> strong;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if ((*whole.jump)[k] > 0.7F || std::abs(whole.crease[k]) > 0.7F) strong.push_back(k);
    }
    while (static_cast<int>(asked.size()) < cells)
        asked.push_back(asked.size() % 2 == 0 ? random() % scan.cells() : strong[random() % strong.size()]);
    for (const std::size_t k : asked) {
        const int line = static_cast<int>(k) / scan.beams();
        const int beam = static_cast<int>(k) % scan.beams();
        const DepthProbe probe = probeDepth(scan, settings, line, beam);
        // Edges are moved around gaps: the response of a filled cell moves to a neighbouring cell.
        const auto same = [&](float kept, float held) {
            if (probe.support == Support::Filled) return held == 0.0F;
            return kept == held || (kept == 0.0F && probe.support == Support::Measured && besideFilled(inverse, line, beam));
        };
        ASSERT_PRED2(same, probe.jump.after, (*whole.jump)[k]) << line << " " << beam;
        ASSERT_PRED2(same, probe.crease.after, whole.crease[k]) << line << " " << beam;
        exact += probe.jump.after == (*whole.jump)[k] && probe.crease.after == whole.crease[k] ? 1 : 0;
        EXPECT_EQ(probe.noiseAt5mMm, whole.noise.at(5.0));
        double jump = 0;
        for (const DepthStepAtCell& step : probe.steps) {
            EXPECT_NEAR(step.stepMm / step.limitMm(), step.strength, 1e-3 * step.strength);
            EXPECT_NEAR(step.smallestMm, whole.jumpMm, 1e-6);
            if (step.cellIsNearer) jump = std::max(jump, step.strength);
        }
        EXPECT_EQ(jump, static_cast<double>(probe.jump.before));
        for (const FoldAtCell& fold : probe.folds)
            EXPECT_NEAR(fold.dihedralDeg * fold.meets / std::max(probe.creaseDeg, fold.noiseDeg), fold.strength,
                        1e-3 * fold.strength + 1e-6);
        jumps += probe.jump.after > 0 ? 1 : 0;
        folds += probe.crease.after != 0 ? 1 : 0;
        outdone += probe.jump.stronger || probe.crease.stronger ? 1 : 0;
    }
    EXPECT_GT(jumps, 0);
    EXPECT_GT(folds, 0);
    EXPECT_GT(outdone, 0);
    EXPECT_GT(exact, 9 * cells / 10);
}

TEST(DepthProbe, StrengthsAreThoseOfTheWholeScan) {
    expectSameAsWhole(smallBell(), {}, 250);
    expectSameAsWhole(smallBell(0.6), {}, 60); // beams interlaced
    Settings noisy;
    noisy.noiseMm = 20; // three cells, two passes
    noisy.grazing = 0.7;
    expectSameAsWhole(smallBell(), noisy, 60);
}

TEST(DepthProbe, StrengthsAreThoseOfARealSweep) {
    EDGESCAN_NEEDS_SHARED("data/lms200_corridor");
    const std::filesystem::path corridor = test::sharedFolder() / "data/lms200_corridor/scan000.json";
    const Result<Scan> scan = files::openScan(corridor);
    ASSERT_TRUE(scan);
    expectSameAsWhole(*scan, {}, 100);
}

// A box half a metre in front of a wall, and a corner of 90 degrees towards the scanner.
TEST(DepthProbe, AStepAndACornerHaveTheirSizes) {
    const Scan step = test::makeScan(60, 60, [](int, int j) { return j < 30 ? 4000.0F : 4500.0F; });
    Settings settings;
    settings.noiseMm = 1;
    const DepthProbe edge = probeDepth(step, settings, 30, 29);
    ASSERT_FALSE(edge.steps.empty());
    EXPECT_NEAR(edge.steps[0].stepMm, 500, 1);
    EXPECT_TRUE(edge.steps[0].cellIsNearer);
    EXPECT_EQ(edge.steps[0].beam, 30);
    EXPECT_EQ(edge.steps[0].along, Along::Beams);
    EXPECT_NEAR(edge.steps[0].growthMm, 40, 1); // 1 % of 4 m
    const DepthProbe behind = probeDepth(step, settings, 30, 30);
    ASSERT_FALSE(behind.steps.empty());
    EXPECT_FALSE(behind.steps[0].cellIsNearer);
    EXPECT_EQ(behind.jump.before, 0.0F);

    const PolarGeometry polar = test::regularAngles(80, 80);
    const Scan corner = test::makeScan(80, 80, [&](int i, int j) {
        const double a = polar.beamDeg[static_cast<std::size_t>(j)] * std::numbers::pi / 180;
        const double p = polar.lineDeg[static_cast<std::size_t>(i)] * std::numbers::pi / 180;
        return 5000.0 / (std::sin(a) * std::cos(p) + std::abs(std::cos(a)));
    });
    const DepthProbe ridge = probeDepth(corner, settings, 40, 40);
    ASSERT_FALSE(ridge.folds.empty());
    EXPECT_EQ(ridge.folds[0].along, Along::Beams);
    EXPECT_FALSE(ridge.folds[0].convex);             // |x| + z = 5 m: farthest in the middle
    EXPECT_NEAR(ridge.folds[0].dihedralDeg, 90, 20); // smoothing and the neighbouring cell reduce it
}

TEST(DepthProbe, TheWinnerIsTheNeighbourAlongTheStrongerWay) {
    const auto scan = std::make_shared<const Scan>(smallBell());
    const auto detection = detectEdges(scan, Settings{});
    std::mt19937 random(3);
    int told = 0;
    for (int n = 0; n < 4000 && told < 12; ++n) {
        const std::uint32_t k = (*detection->edges)[random() % detection->edges->size()];
        const int line = static_cast<int>(k) / scan->beams();
        const int beam = static_cast<int>(k) % scan->beams() + (n % 2 == 0 ? 1 : -1);
        if (!scan->rangeMm.contains(line, beam) || detection->mask->at(line, beam) != 0) continue;
        const Why why = whyCell(*detection, scan->rangeMm.index(line, beam));
        if (!why.suppressedBy || why.strength <= why.lower || !why.takesPart) continue;
        ++told;
        const ThinnedStrength& channel = why.kind == DepthEdge::Jump ? why.depth->jump : why.depth->crease;
        EXPECT_EQ(static_cast<double>(std::abs(channel.before)), why.strength);
        EXPECT_EQ(channel.after, 0.0F);
        EXPECT_EQ(std::abs(why.suppressedBy->line - line) + std::abs(why.suppressedBy->beam - beam), 1); // never a diagonal one
        EXPECT_GE(why.suppressedBy->strength, why.compared);
        EXPECT_NE(why.verdict.find("an edge is one cell wide"), std::string::npos) << why.verdict;
    }
    EXPECT_EQ(told, 12);
}

// "114 = 41 + 61 + 3.9 + 7.4" does not add up.
void expectPrintedSum(const std::string& text) {
    const std::regex sentence(R"(limit ([0-9.]+) mm = ([^:;]*(?:\(raised: [^)]*\))?[^:;]*): strength)"), number(R"([0-9]+\.[0-9])");
    for (std::sregex_iterator each(text.begin(), text.end(), sentence), end; each != end; ++each) {
        const std::string parts = (*each)[2];
        double sum = 0;
        for (std::sregex_iterator part(parts.begin(), parts.end(), number); part != end; ++part) sum += std::stod(part->str());
        EXPECT_NEAR(sum, std::stod((*each)[1]), 1e-6) << each->str();
    }
}

TEST(DepthProbe, TextAndReportNameStepFoldNoiseClassAndChain) {
    const auto scan = std::make_shared<const Scan>(smallBell());
    const auto detection = detectEdges(scan, Settings{});
    bool jump = false;
    bool fold = false;
    for (std::size_t n = 0; n < detection->edges->size() && !(jump && fold); n += 7) {
        const std::uint32_t k = (*detection->edges)[n];
        const bool isJump = (*detection->classes)[k] == DepthEdge::Jump;
        if (isJump ? jump : fold) continue;
        (isJump ? jump : fold) = true;
        const Why why = whyCell(*detection, k);
        const std::string text = whyText(why, detection->settings);
        EXPECT_NE(text.find(isJump ? "Step in depth: " : "Fold: "), std::string::npos) << text;
        EXPECT_NE(text.find("Range noise used: sigma "), std::string::npos) << text;
        expectPrintedSum(text);
        EXPECT_NE(text.find("Edge strength"), std::string::npos) << text;
        EXPECT_EQ(text.find("ensitivity"), std::string::npos) << text;
        EXPECT_NE(text.find("Chain: " + std::to_string(why.chainCells)), std::string::npos) << text;
        EXPECT_NE(text.find(isJump ? "class jump" : "class con"), std::string::npos) << text;
        ASSERT_TRUE(why.chainTop);
        EXPECT_EQ(why.chainMembers.size(), why.chainCells);
        EXPECT_GE(why.chainTop->strength, why.strength);
        const nlohmann::ordered_json report = exports::whyReport(*detection, why);
        const auto& measured = report["measured"];
        EXPECT_GT(measured["noise_mm"].get<double>(), 0);
        EXPECT_FALSE(measured[isJump ? "steps" : "folds"].empty());
        EXPECT_TRUE(measured[isJump ? "steps" : "folds"][0].contains(isJump ? "step_mm" : "dihedral_deg"));
        EXPECT_EQ(report["response_class"], report["class"]);
        EXPECT_EQ(report["unit"], "x");
        EXPECT_GT(report["text"].size(), 3U);
        EXPECT_NE(report["verdict"].get<std::string>().find("sensitivity"), std::string::npos);
    }
    EXPECT_TRUE(jump && fold);
}

TEST(DepthProbe, OtherMethodsSayUnitAndDirection) {
    // Levels rise along the beams.
    const auto scan =
        std::make_shared<const Scan>(test::makeScan(30, 30, [](int, int j) { return 3000.0F + 200.0F * static_cast<float>(j); }));
    for (const Method method :
         {Method::Roberts, Method::Sobel, Method::Prewitt, Method::Kirsch, Method::Robinson, Method::Canny, Method::LogRange}) {
        Settings settings;
        settings.method = method;
        const auto detection = detectEdges(scan, settings);
        const Why why = whyCell(*detection, scan->rangeMm.index(15, 15));
        ASSERT_TRUE(why.directionDeg) << static_cast<int>(method);
        EXPECT_NEAR(*why.directionDeg, 0, 1) << static_cast<int>(method);
        const std::string unit = method == Method::LogRange ? "% of range" : "levels";
        EXPECT_EQ(why.unit, unit);
        EXPECT_NE(whyText(why, settings).find(unit), std::string::npos);
    }
    // In percent of the range, the threshold is the typed value.
    Settings settings;
    settings.method = Method::LogRange;
    settings.stepPercent = 4;
    const Why why = whyCell(*detectEdges(scan, settings), scan->rangeMm.index(15, 15));
    EXPECT_NEAR(why.lower, 4, 1e-9);
    EXPECT_NEAR(why.upper, 100 * (std::pow(1.04, 3) - 1), 1e-9);
    // Rotated by 90 degrees: along the lines.
    const auto turned =
        std::make_shared<const Scan>(test::makeScan(30, 30, [](int i, int) { return 9000.0F - 200.0F * static_cast<float>(i); }));
    for (const Method method : {Method::Roberts, Method::Sobel, Method::Kirsch, Method::Robinson}) {
        settings.method = method;
        EXPECT_NEAR(*whyCell(*detectEdges(turned, settings), scan->rangeMm.index(15, 15)).directionDeg, -90, 1);
    }
}

} // namespace
} // namespace edgescan::edges
