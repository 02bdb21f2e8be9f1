// The stages of the method compared with OpenCV, with direct sums, and for the treatment of holes.
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/grid/missing_cells.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgescan::edges {
namespace {

// ThreadSanitizer would report OpenCV's thread pool.
const bool kNoPool = (cv::setNumThreads(0), true);

Grid<std::uint8_t> randomImage(int lines, int beams, std::uint32_t seed) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> image(lines, beams);
    // Blocks with noise: flat parts, steps and ties, which depend on rounding and suppression.
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) image.at(i, j) = static_cast<std::uint8_t>((i / 5 * 37 + j / 7 * 91 + random() % 4) % 256);
    }
    return image;
}

std::vector<Settings> manySettings() {
    std::vector<Settings> all;
    for (const int kernel : {1, 3, 5, 7, 9, 11}) {
        for (const double sigma : {kAutomatic, 0.3, 1.0, 4.7}) {
            for (const int aperture : {3, 5, 7}) {
                for (const Norm norm : {Norm::L1, Norm::L2}) {
                    Settings s;
                    s.kernel = kernel;
                    s.sigma = sigma;
                    s.aperture = aperture;
                    s.norm = norm;
                    s.lower = aperture == 3 ? 25 : 160;
                    all.push_back(s);
                }
            }
        }
    }
    return all;
}

TEST(Gray, ThesisFormulaAsPrinted) {
    const Scan scan = test::makeScan(1, 5, [](int, int j) { return std::array{0.0F, 1000.0F, 1500.0F, 2000.0F, 3000.0F}[std::size_t(j)]; });
    Settings s;
    s.scaling = Scaling::Thesis; // c = 255 / (3000 - 1000)
    const GrayImage gray = grayImage(scan, s);
    EXPECT_EQ(gray.levels.cells, (std::vector<std::uint8_t>{0, 128, 191, 255, 255}));
    EXPECT_EQ(gray.saturated, 1U);
}

TEST(Gray, WindowRunsFromNearToFarAndClamps) {
    const Scan scan = test::makeScan(1, 5, [](int, int j) { return std::array{0.0F, 1000.0F, 1500.0F, 2000.0F, 3000.0F}[std::size_t(j)]; });
    Settings s;
    s.scaling = Scaling::Window;
    EXPECT_EQ(grayImage(scan, s).levels.cells, (std::vector<std::uint8_t>{0, 0, 64, 128, 255})); // 63.75, 127.5 to even
    s.nearMm = 1500;
    s.farMm = 2000;
    EXPECT_EQ(grayImage(scan, s).levels.cells, (std::vector<std::uint8_t>{0, 0, 0, 255, 255}));
    EXPECT_EQ(grayImage(scan, s).saturated, 2U);
}

TEST(Gray, OneSingleRangeHasNoDepthInAnyScaling) {
    const Scan scan = test::makeScan(4, 4, [](int, int) { return 5000.0F; });
    for (const Scaling scaling : {Scaling::Thesis, Scaling::Window, Scaling::Log}) {
        Settings s = cannySettings();
        s.scaling = scaling;
        const auto detection = detectEdges(std::make_shared<Scan>(scan), s);
        EXPECT_TRUE(detection->edges->empty());
    }
}

TEST(Gray, LogarithmicLevelsAreEqualRatios) {
    std::vector<float> ranges{1000, 1500, 2000.5F, 3000, 7000, 16000, 30000};
    const Scan scan = test::makeScan(1, 7, [&](int, int j) { return ranges[std::size_t(j)]; });
    Settings s;
    s.nearMm = 2000;
    s.farMm = 16000;
    const GrayImage gray = grayImage(scan, s);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
        const double level = std::log(ranges[k] / 2000.0) * 255 / std::log(8.0);
        EXPECT_EQ(gray.levels[k], std::lround(std::clamp(level, 0.0, 255.0))) << ranges[k];
    }
    EXPECT_EQ(gray.saturated, 3U);
    EXPECT_NEAR(mmPerLevel(gray.scale, 10000), 10000 * std::log(8.0) / 255, 1e-9);
}

TEST(Gray, TheAutomaticWindowIgnoresStrayReturnsAndSpansAFactorOfFive) {
    Scan scan = test::makeScan(100, 100, [](int i, int j) { return 4000.0F + static_cast<float>(i + j); });
    scan.rangeMm[0] = 39000; // dust and one distant return: half a percent
    for (std::size_t k = 1; k < 50; ++k) scan.rangeMm[k] = 20;
    for (const auto& [method, factor] : {std::pair{Method::Canny, 5.0}, {Method::EdgeScanPlus, 1.2}}) {
        Settings settings;
        settings.method = method;
        const GrayScale scale = grayScale(scan, settings);
        EXPECT_NEAR(scale.farMm / scale.nearMm, factor, 0.01);
        EXPECT_NEAR(std::sqrt(scale.farMm * scale.nearMm), 4099, 20);
    }
}

TEST(Gray, RangesOfWholeMillimetresGiveWhatOtherRangesGive) {
    std::mt19937 random(5);
    for (int turn = 0; turn < 20; ++turn) {
        Scan whole =
            test::makeScan(60, 70, [&](int, int) { return static_cast<float>(200 + random() % (turn % 2 == 0 ? 30000 : 100000)); });
        for (int n = 0; n < 200; ++n) whole.state[random() % whole.cells()] = CellState::NoReturn;
        Scan other = whole;
        other.rangeMm[77] += 0.25F; // one range is enough: the levels are then searched
        whole.state[77] = other.state[77] = CellState::Valid;
        Settings settings;
        const GrayScale scale = grayScale(whole, settings); // of sorted ranges
        const GrayImage gray = grayImage(whole, settings);
        EXPECT_EQ(gray.scale.nearMm, scale.nearMm);
        EXPECT_EQ(gray.scale.farMm, scale.farMm);
        settings.nearMm = scale.nearMm;
        settings.farMm = scale.farMm;
        GrayImage searched = grayImage(other, settings);
        EXPECT_NEAR(searched.levels[77], gray.levels[77], 1);
        searched.levels[77] = gray.levels[77];
        EXPECT_EQ(searched.levels, gray.levels) << "turn " << turn;
        EXPECT_EQ(searched.saturated, gray.saturated) << "turn " << turn;
    }
}

TEST(Smooth, WeightsAreThoseOfOpenCv) {
    for (const int size : {3, 5, 7, 9, 11}) {
        for (const double sigma : {kAutomatic, 0.3, 0.8, 1.4, 3.0, 9.9}) {
            const std::vector<int> weights = gaussianWeights(size, sigma);
            EXPECT_TRUE(kNoPool && std::accumulate(weights.begin(), weights.end(), 0) == 256);
        }
    }
}

TEST(Smooth, AroundHolesEqualsOpenCvWhereNothingIsMissing) {
    for (const Settings& s : manySettings()) {
        for (const auto& [lines, beams] : {std::pair{1, 1}, {2, 3}, {17, 4}, {40, 61}}) {
            const Grid<std::uint8_t> image = randomImage(lines, beams, 7);
            Grid<std::uint8_t> missing(lines, beams);
            EXPECT_EQ(smoothAroundHoles(image, missing, s), smooth(image, s));
        }
    }
}

// The definition, cell by cell: a missing cell counts as the centre of the window.
Grid<std::uint8_t> smoothedByDefinition(const Grid<std::uint8_t>& image, const Grid<std::uint8_t>& missing,
                                        const std::vector<int>& weights) {
    const int reach = static_cast<int>(weights.size()) / 2;
    Grid<std::uint8_t> result(image.lines, image.beams);
    for (int i = 0; i < image.lines; ++i) {
        for (int j = 0; j < image.beams; ++j) {
            if (missing.at(i, j) != 0) continue;
            double sum = 0;
            for (int di = -reach; di <= reach; ++di) {
                for (int dj = -reach; dj <= reach; ++dj) {
                    const int y = cv::borderInterpolate(i + di, image.lines, cv::BORDER_REFLECT_101);
                    const int x = cv::borderInterpolate(j + dj, image.beams, cv::BORDER_REFLECT_101);
                    const int level = missing.at(y, x) != 0 ? image.at(i, j) : image.at(y, x);
                    sum += weights[std::size_t(di + reach)] / 256.0 * (weights[std::size_t(dj + reach)] / 256.0) * level;
                }
            }
            result.at(i, j) = static_cast<std::uint8_t>(std::floor(sum + 0.5));
        }
    }
    return result;
}

Grid<std::uint8_t> randomHoles(int lines, int beams, std::uint32_t seed) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> missing(lines, beams);
    for (auto& cell : missing.cells) cell = random() % 6 == 0 ? 255 : 0;
    return missing;
}

TEST(Smooth, EveryCellFollowsTheDefinitionWithAndWithoutHoles) {
    for (const Settings& s : manySettings()) {
        if (s.kernel == 1 || s.aperture != 3 || s.norm != Norm::L1) continue;
        const Grid<std::uint8_t> image = randomImage(23, 31, 3);
        const std::vector<int> weights = gaussianWeights(s.kernel, s.sigma);
        const Grid<std::uint8_t> holes = randomHoles(23, 31, 8);
        EXPECT_EQ(smoothAroundHoles(image, holes, s), smoothedByDefinition(image, holes, weights)) << s.kernel << " " << s.sigma;
        EXPECT_EQ(smooth(image, s), smoothedByDefinition(image, Grid<std::uint8_t>(23, 31), weights)) << s.kernel << " " << s.sigma;
    }
}

TEST(Smooth, NothingOfAHoleReachesItsSurroundings) {
    const Scan scan = test::boxesScan(60, 80, 5, 0.15);
    const Grid<std::uint8_t> missing = missingCells(scan);
    Settings s;
    s.kernel = 7;
    Grid<std::uint8_t> a = grayImage(scan, s).levels;
    Grid<std::uint8_t> b = a;
    for (std::size_t k = 0; k < b.size(); ++k) {
        if (missing[k] != 0) b[k] = static_cast<std::uint8_t>(k * 71);
    }
    const Grid<std::uint8_t> smoothedA = smoothAroundHoles(a, missing, s);
    EXPECT_EQ(smoothedA, smoothAroundHoles(b, missing, s));
    EXPECT_EQ(cannyAroundHoles(smoothedA, missing, s), cannyAroundHoles(smoothAroundHoles(b, missing, s), missing, s));
}

TEST(Canny, AroundHolesEqualsOpenCvWhereNothingIsMissing) {
    for (const Settings& s : manySettings()) {
        const Grid<std::uint8_t> image = smooth(randomImage(40, 61, 11), s);
        const Grid<std::uint8_t> mask = canny(image, s);
        EXPECT_EQ(cannyAroundHoles(image, Grid<std::uint8_t>(40, 61), s), mask) << s.kernel << " " << s.aperture;
    }
}

// The gradient by its definition, for every cell, then OpenCV's suppression and hysteresis.
Grid<std::uint8_t> cannyByDefinition(const Grid<std::uint8_t>& image, const Grid<std::uint8_t>& missing, const Settings& s) {
    cv::Mat derivative;
    cv::Mat smoothing;
    cv::getDerivKernels(derivative, smoothing, 1, 0, s.aperture, false, CV_64F);
    const int reach = s.aperture / 2;
    const double scale = s.aperture == 7 ? 1.0 / 16 : 1.0;
    cv::Mat dx(image.lines, image.beams, CV_16S, cv::Scalar(0));
    cv::Mat dy(image.lines, image.beams, CV_16S, cv::Scalar(0));
    for (int i = 0; i < image.lines; ++i) {
        for (int j = 0; j < image.beams; ++j) {
            if (missing.at(i, j) != 0) continue;
            double x = 0;
            double y = 0;
            for (int di = 0; di < s.aperture; ++di) {
                for (int dj = 0; dj < s.aperture; ++dj) {
                    const int li = std::clamp(i + di - reach, 0, image.lines - 1);
                    const int lj = std::clamp(j + dj - reach, 0, image.beams - 1);
                    const int level = missing.at(li, lj) != 0 ? image.at(i, j) : image.at(li, lj);
                    x += smoothing.at<double>(di) * derivative.at<double>(dj) * level;
                    y += derivative.at<double>(di) * smoothing.at<double>(dj) * level;
                }
            }
            dx.at<short>(i, j) = cv::saturate_cast<short>(x * scale);
            dy.at<short>(i, j) = cv::saturate_cast<short>(y * scale);
        }
    }
    cv::Mat edges;
    cv::Canny(dx, dy, edges, s.lower * scale, s.upper() * scale, s.norm == Norm::L2);
    return {image.lines, image.beams, std::vector<std::uint8_t>(edges.begin<std::uint8_t>(), edges.end<std::uint8_t>())};
}

TEST(Canny, EveryCellFollowsTheDefinitionWithAndWithoutHoles) {
    int compared = 0;
    for (const Settings& s : manySettings()) {
        if (s.kernel > 3 || !std::isnan(s.sigma)) continue;
        const Grid<std::uint8_t> image = smooth(randomImage(33, 29, 23), s);
        const Grid<std::uint8_t> none(33, 29);
        const Grid<std::uint8_t> holes = randomHoles(33, 29, 5);
        const Grid<std::uint8_t> mask = cannyAroundHoles(image, holes, s);
        EXPECT_EQ(mask, cannyByDefinition(image, holes, s)) << s.aperture;
        EXPECT_EQ(canny(image, s), cannyByDefinition(image, none, s)) << s.aperture;
        EXPECT_FALSE(edgeCells(mask).empty());
        ++compared;
    }
    EXPECT_GT(compared, 0);
}

class Wall : public ::testing::TestWithParam<double> {
protected:
    // 120 degrees of a flat wall, first facing the scanner, then rotated by up to 40 degrees. Single cells are missing; with `large` also a
    // rectangle, a disc and a slit.
    static std::shared_ptr<const Scan> wallWithHoles(double turnedDeg, bool large) {
        const int lines = 200;
        const int beams = 320;
        std::mt19937 random(9);
        std::normal_distribution<double> noise(0.0, 6.0);
        const PolarGeometry polar = test::regularAngles(lines, beams);
        return std::make_shared<const Scan>(test::makeScan(lines, beams, [&](int i, int j) {
            const bool rectangle = i > 40 && i < 90 && j > 50 && j < 150;
            const bool disc = (i - 130) * (i - 130) + (j - 220) * (j - 220) < 40 * 40;
            const bool slit = j == 280 && i > 20 && i < 180;
            const bool dropped = random() % 100 < 5;
            if ((large && (rectangle || disc || slit)) || dropped) return 0.0;
            const double a = (polar.beamDeg[std::size_t(j)] + turnedDeg) * std::numbers::pi / 180;
            const double p = polar.lineDeg[std::size_t(i)] * std::numbers::pi / 180;
            return std::round(5000.0 / (std::sin(a) * std::cos(p)) + noise(random));
        }));
    }
};

TEST_P(Wall, WithHolesGivesOnlyTheRimsOfTheLargeOnesInTheDefaultPreset) {
    const auto scan = wallWithHoles(GetParam(), true);
    const auto detection = detectEdges(scan, Settings{});
    const auto counts = countClasses(*detection);
    const std::size_t rim = counts.at(static_cast<std::size_t>(DepthEdge::VoidRim));
    EXPECT_EQ(detection->edges->size(), rim) << "an edge of another class";
    // Rectangle and disc: 49 x 99 cells, radius 40. The slit is a gap of one beam, which is bridged.
    EXPECT_GT(rim, 400U);
    EXPECT_LT(rim, 800U);

    Settings withoutRim;
    withoutRim.classes &= ~kClassVoidRim;
    EXPECT_TRUE(detectEdges(scan, withoutRim)->edges->empty());
    EXPECT_TRUE(detectEdges(wallWithHoles(GetParam(), false), Settings{})->edges->empty());
}

TEST_P(Wall, WithHolesGivesNoEdgeOnGrayLevels) {
    const auto scan = wallWithHoles(GetParam(), true);
    EXPECT_TRUE(detectEdges(scan, cannySettings())->edges->empty());
    Settings unmasked = cannySettings();
    unmasked.maskMissing = false;
    EXPECT_GT(detectEdges(scan, unmasked)->edges->size(), 200U); // shows that the test can fail: masking removes these
}

INSTANTIATE_TEST_SUITE_P(Turned, Wall, ::testing::Values(0.0, 15.0, -25.0));

TEST(Methods, EdgesLieOnValidCellsOnlyWhenMissingDataIsMasked) {
    const Parameter& method = *findParameter("method");
    for (const Choice& choice : method.choices) {
        Settings settings;
        method.set(settings, choice.value);
        std::size_t found = 0;
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            const auto scan = std::make_shared<Scan>(test::boxesScan(50, 70, seed, 0.1));
            const auto detection = detectEdges(scan, settings);
            found += detection->edges->size();
            for (const std::uint32_t k : *detection->edges) EXPECT_EQ(scan->state[k], CellState::Valid) << choice.name;
        }
        EXPECT_GT(found, 1000U) << choice.name;
    }
}

} // namespace
} // namespace edgescan::edges
