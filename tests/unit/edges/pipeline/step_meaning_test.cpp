// The meaning of thresholds, compared with scans of steps of known depth.
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/presets.h"
#include "tests/support/detectors.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr std::array kGrayMethods{Method::Canny,  Method::Roberts,  Method::Sobel,        Method::Prewitt,
                                  Method::Kirsch, Method::Robinson, Method::MarrHildreth, Method::Log};

Settings linear(Method method, int kernel = 3) {
    Settings s;
    s.method = method;
    s.scaling = Scaling::Window;
    s.nearMm = 0;
    s.farMm = 25500; // 100 mm per level
    s.kernel = kernel;
    s.ratio = 1.0;
    return s;
}

// Edge cells of a step of `stepMm` behind 5 m, in the middle of a scan.
std::size_t edgesOfStep(double stepMm, bool diagonal, const Settings& settings) {
    const Scan scan =
        test::makeScan(60, 60, [&](int i, int j) { return static_cast<float>((diagonal ? j > i : j > 29) ? 5000.0 + stepMm : 5000.0); });
    const auto detection = detectEdges(std::make_shared<Scan>(scan), settings);
    std::size_t count = 0;
    // Where a step leaves the image, the repeated border bends it.
    for (int i = 20; i < 40; ++i) {
        for (int j = 20; j < 40; ++j) count += detection->mask->at(i, j) != 0 ? 1 : 0;
    }
    return count;
}

TEST(StepMeaning, OfTheThesisRecipeAsWorkedOutInTheViewersDesign) {
    Settings s = cannySettings();
    const StepGain gain = stepGain(s);
    EXPECT_NEAR(gain.straight, 3.0, 1e-6);
    EXPECT_NEAR(gain.diagonal, 4.375, 1e-6);
    s.lower = 10;
    const GrayScale thirtyMetres{0, 30000, false};
    EXPECT_NEAR(depthStep(s.lower, s, thirtyMetres)->largestMm, 390, 3);
    EXPECT_NEAR(depthStep(s.upper(), s, thirtyMetres)->largestMm, 1180, 5);
    EXPECT_EQ(thresholdText(s, thirtyMetres), "weak edge from a step of 0.27 to 0.39 m, strong from 0.81 to 1.2 m");
}

TEST(StepMeaning, AStepJustBeyondTheBandIsAnEdgeAndOneJustBelowIsNone) {
    for (const Method method : kGrayMethods) {
        for (const int kernel : {1, 3, 5, 9}) {
            if (method == Method::Log && kernel > 3) continue; // second differences below the rounding of gray levels
            Settings s = linear(method, kernel);
            const StepGain gain = stepGain(s);
            ASSERT_GT(gain.straight, 0);
            for (const bool diagonal : {false, true}) {
                const double perLevel = diagonal ? gain.diagonal : gain.straight;
                s.lower = 100 * perLevel; // of a step of 100 levels = 10 m
                EXPECT_GT(edgesOfStep(10400, diagonal, s), 0U) << static_cast<int>(method) << " kernel " << kernel << diagonal;
                EXPECT_EQ(edgesOfStep(9600, diagonal, s), 0U) << static_cast<int>(method) << " kernel " << kernel << diagonal;
            }
        }
    }
}

TEST(StepMeaning, AperturesAndNormsOfCanny) {
    for (const int aperture : {3, 5, 7}) {
        for (const Norm norm : {Norm::L1, Norm::L2}) {
            Settings s = linear(Method::Canny);
            s.aperture = aperture;
            s.norm = norm;
            s.lower = 100 * stepGain(s).straight;
            EXPECT_GT(edgesOfStep(10200, false, s), 0U) << aperture;
            EXPECT_EQ(edgesOfStep(9800, false, s), 0U) << aperture;
        }
    }
}

TEST(StepMeaning, TypedDepthsBecomeThresholds) {
    EXPECT_EQ(typedStep("0.5m")->value, 500);
    EXPECT_EQ(typedStep("0.5 m")->value, 500);
    EXPECT_EQ(typedStep("300 mm")->value, 300);
    EXPECT_EQ(typedStep("12cm")->value, 120);
    EXPECT_TRUE(typedStep("4 %")->percent);
    for (const char* text : {"", "m", "12", "x m", "-1 m", "nan m", "1e999 m", "1 2 m", "%"}) EXPECT_FALSE(typedStep(text)) << text;

    const Settings s = linear(Method::Canny);
    const GrayScale scale{0, 25500, false};
    const Result<double> lower = lowerOfStep({2000, false}, s, scale);
    ASSERT_TRUE(lower);
    EXPECT_EQ(*lower, 60.0); // 20 levels x 3
    EXPECT_FALSE(lowerOfStep({3, true}, s, scale));
    EXPECT_FALSE(lowerOfStep({2000, false}, s, GrayScale{}));
    EXPECT_FALSE(lowerOfStep({2000, false}, Settings{}, scale));
    EXPECT_FALSE(lowerOfStep({1e12, false}, s, scale));
}

TEST(StepMeaning, LogarithmicStepsAreSharesOfTheRange) {
    Settings s = cannySettings();
    const GrayScale scale{2000, 8000, true};
    const Result<double> fivePercent = lowerOfStep({5, true}, s, scale);
    ASSERT_TRUE(fivePercent);
    s.lower = *fivePercent;
    const auto step = depthStep(s.lower, s, scale);
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->largestPercent, 5.0, 0.05);
    EXPECT_EQ(step->referenceMm, 4000);
    const Result<double> metres = lowerOfStep({200, false}, s, scale); // 5 % of 4 m
    ASSERT_TRUE(metres);
    EXPECT_EQ(*metres, *fivePercent);
    EXPECT_NE(depthStepText(*step).find("% of range"), std::string::npos);
}

TEST(StepMeaning, AnotherMethodKeepsTheStepInTheMiddleOfCannysTwo) {
    const Settings canny = cannySettings(); // follows edges from 2 levels on, starts them at 6
    for (const Method method : kGrayMethods) {
        Settings s = canny;
        s.method = method;
        s.lower = lowerWithSameStep(canny, s);
        const double levels = s.lower / stepGain(s).straight;
        if (method == Method::Log)
            EXPECT_EQ(s.lower, answerToRounding(s)); // its response to rounding is larger than that to a step of 4 levels
        else
            EXPECT_NEAR(levels, method == Method::Canny ? 2.0 : 4.0, 0.1) << static_cast<int>(method);
        // And back again.
        if (method != Method::Log) {
            EXPECT_NEAR(lowerWithSameStep(s, canny), canny.lower, 0.15) << static_cast<int>(method);
        }
    }
    Settings depth;
    EXPECT_EQ(lowerWithSameStep(canny, depth), depth.lower);
    Settings typed; // below the rounding, but the user chose it
    typed.method = Method::Log;
    typed.lower = 2.0;
    EXPECT_EQ(lowerWithSameStep(typed, typed), 2.0);
    Settings steeper = canny;
    steeper.ratio = 2.0;
    EXPECT_EQ(lowerWithSameStep(canny, steeper), 9.0); // both start at 18
}

TEST(StepMeaning, NoUsualThresholdFindsEdgesOnRoundedPlanes) {
    // Slants that answerToRounding() itself does not try.
    for (const Method method : kGrayMethods) {
        for (const LogMask mask : {LogMask::FourNeighbours, LogMask::EightNeighbours, LogMask::FiveByFive}) {
            if (method == Method::Canny || (method != Method::Log && mask != LogMask::FourNeighbours)) continue;
            Settings s;
            s.method = method;
            s.logMask = mask;
            s.lower = lowerWithSameStep(cannySettings(), s);
            EXPECT_GE(s.lower, answerToRounding(s)) << static_cast<int>(method);
            for (const auto& [alongLines, alongBeams] : {std::pair{0.11, 0.037}, {0.2, 0.13}, {0.0, 0.07}, {0.017, 0.23}}) {
                Grid<std::uint8_t> plane(90, 90);
                for (int i = 0; i < 90; ++i) {
                    for (int j = 0; j < 90; ++j)
                        plane.at(i, j) = static_cast<std::uint8_t>(std::lround(40 + alongLines * i + alongBeams * j));
                }
                const Grid<std::uint8_t> edges =
                    test::detectorMask(method, reads(method, kReadsKernel) ? smooth(plane, s) : plane, nullptr, s);
                EXPECT_EQ(std::ranges::count(edges.cells, 0), 90 * 90)
                    << static_cast<int>(method) << ' ' << alongLines << ' ' << alongBeams;
            }
        }
    }
}

} // namespace
} // namespace edgescan::edges
