// The detectors of the thesis's chapter 3 compared with sums over their masks, small hand-computed examples, and the treatment of holes.
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gradient_masks.h"
#include "core/edges/gray/log_range.h"
#include "core/edges/gray/zero_crossings.h"
#include "tests/support/detectors.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace edgescan::edges {
namespace {

using Mask = std::vector<std::vector<int>>;

Grid<std::uint8_t> noiseImage(int lines, int beams, std::uint32_t seed) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> image(lines, beams);
    for (std::uint8_t& level : image.cells) level = static_cast<std::uint8_t>(random() % 256);
    return image;
}

Grid<std::uint8_t> someMissing(int lines, int beams, std::uint32_t seed, unsigned percent) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> missing(lines, beams);
    for (std::uint8_t& cell : missing.cells) cell = random() % 100 < percent ? 255 : 0;
    return missing;
}

// The sum of levels times mask, written out; a missing cell counts as the window's centre.
double sumAt(const Grid<std::uint8_t>& image, const Grid<std::uint8_t>& missing, const Mask& mask, int line, int beam) {
    const int reach = static_cast<int>(mask.size()) / 2;
    double sum = 0;
    for (int di = -reach; di <= reach; ++di) {
        for (int dj = -reach; dj <= reach; ++dj) {
            const int i = std::clamp(line + di, 0, image.lines - 1);
            const int j = std::clamp(beam + dj, 0, image.beams - 1);
            const int level = missing.at(i, j) != 0 ? image.at(line, beam) : image.at(i, j);
            sum += level * mask[static_cast<std::size_t>(di + reach)][static_cast<std::size_t>(dj + reach)];
        }
    }
    return sum;
}

// Rotated by 45 degrees, clockwise.
Mask turned(const Mask& m) { return {{m[1][0], m[0][0], m[0][1]}, {m[2][0], m[1][1], m[0][2]}, {m[2][1], m[2][2], m[1][2]}}; }

Mask transposed(const Mask& m) {
    Mask t = m;
    for (std::size_t i = 0; i < m.size(); ++i) {
        for (std::size_t j = 0; j < m.size(); ++j) t[i][j] = m[j][i];
    }
    return t;
}

const Mask kSobel{{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}};
const Mask kPrewitt{{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}};
const Mask kKirsch{{-3, -3, 5}, {-3, 0, 5}, {-3, -3, 5}};
const Mask kRobertsA{{0, 0, 0}, {0, 1, 0}, {0, 0, -1}};
const Mask kRobertsB{{0, 0, 0}, {0, 0, 1}, {0, -1, 0}};

// The value of each detector's formula at a cell.
double expected(Method method, Norm norm, const Grid<std::uint8_t>& image, const Grid<std::uint8_t>& missing, int line, int beam) {
    const auto sum = [&](const Mask& mask) { return sumAt(image, missing, mask, line, beam); };
    const auto two = [&](double a, double b) { return norm == Norm::L1 ? std::abs(a) + std::abs(b) : std::hypot(a, b); };
    if (method == Method::Roberts) return two(sum(kRobertsA), sum(kRobertsB));
    if (method == Method::Sobel) return two(sum(kSobel), sum(transposed(kSobel)));
    if (method == Method::Prewitt) return two(sum(kPrewitt), sum(transposed(kPrewitt)));
    Mask mask = method == Method::Kirsch ? kKirsch : kSobel;
    double strongest = 0;
    for (int turn = 0; turn < 8; ++turn) {
        strongest = std::max(strongest, sum(mask));
        mask = turned(mask);
    }
    EXPECT_EQ(mask, method == Method::Kirsch ? kKirsch : kSobel);
    return strongest;
}

constexpr std::array kMasked{Method::Roberts, Method::Sobel, Method::Prewitt, Method::Kirsch, Method::Robinson};
constexpr std::array kAll{Method::Roberts,  Method::Sobel,        Method::Prewitt, Method::Kirsch,
                          Method::Robinson, Method::MarrHildreth, Method::Log};

TEST(Detectors, EqualTheirMasksWrittenOut) {
    for (const auto& [lines, beams] : {std::pair{1, 1}, {1, 7}, {2, 3}, {23, 31}}) {
        const Grid<std::uint8_t> image = noiseImage(lines, beams, 3);
        for (const unsigned percent : {0U, 12U}) {
            const Grid<std::uint8_t> missing = someMissing(lines, beams, 5, percent);
            for (const Method method : kMasked) {
                for (const Norm norm : {Norm::L1, Norm::L2}) {
                    Settings s;
                    s.norm = norm;
                    const Grid<float> response = rowOf(method).response(image, &missing, s);
                    for (int i = 0; i < lines; ++i) {
                        for (int j = 0; j < beams; ++j) {
                            const double wanted = missing.at(i, j) != 0 ? 0.0 : expected(method, norm, image, missing, i, j);
                            ASSERT_NEAR(response.at(i, j), wanted, 1e-3) << static_cast<int>(method) << " " << i << " " << j;
                        }
                    }
                }
            }
        }
    }
}

TEST(Detectors, AStepOfTenByHand) {
    Grid<std::uint8_t> image(5, 6);
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 6; ++j) image.at(i, j) = j < 3 ? 20 : 30;
    }
    const Settings s;
    for (const auto& [method, left, right] : {std::tuple{Method::Roberts, 20.0F, 0.0F},
                                              {Method::Sobel, 40.0F, 40.0F},
                                              {Method::Prewitt, 30.0F, 30.0F},
                                              {Method::Kirsch, 150.0F, 90.0F},
                                              {Method::Robinson, 40.0F, 40.0F}}) {
        const Grid<float> response = rowOf(method).response(image, nullptr, s);
        EXPECT_EQ(response.at(2, 2), left);
        EXPECT_EQ(response.at(2, 3), right);
        EXPECT_EQ(response.at(2, 1), 0.0F);
        EXPECT_EQ(response.at(2, 5), 0.0F);
    }
    // 4-neighbour mask: -10 left of the step, +10 right of it; the change is 20 and belongs to the first of the two equal cells.
    const Grid<float> log = rowOf(Method::Log).response(image, nullptr, s);
    EXPECT_EQ(log.at(2, 2), 20.0F);
    EXPECT_EQ(log.at(2, 3), 0.0F);
    Settings five;
    five.logMask = LogMask::FiveByFive;
    // Columns of the mask sum to -1 -4 10 -4 -1 (border lines apart): left of the step -50, right of it +50.
    EXPECT_EQ(rowOf(Method::Log).response(image, nullptr, five).at(2, 2), 100.0F);
}

TEST(Detectors, TheEightDirectionsAnswerAlikeWhereverAStepPoints) {
    // The eight rotations of a step by 45 degrees around a cell.
    std::array<std::uint8_t, 8> ring{90, 90, 90, 90, 10, 10, 10, 10};
    for (const Method method : {Method::Kirsch, Method::Robinson}) {
        std::vector<float> answers;
        for (int turn = 0; turn < 8; ++turn) {
            Grid<std::uint8_t> image(3, 3, std::uint8_t{50});
            const std::array<std::pair<int, int>, 8> places{{{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}}};
            for (std::size_t n = 0; n < 8; ++n) image.at(places[n].first, places[n].second) = ring[n];
            answers.push_back(rowOf(method).response(image, nullptr, Settings{}).at(1, 1));
            std::ranges::rotate(ring, ring.begin() + 1);
        }
        EXPECT_EQ(std::ranges::count(answers, answers.front()), 8);
        EXPECT_GT(answers.front(), 100.0F);
    }
}

TEST(Detectors, LaplacianMasksWrittenOut) {
    const Grid<std::uint8_t> image = noiseImage(17, 22, 9);
    const Grid<std::uint8_t> missing = someMissing(17, 22, 10, 10);
    const Mask four{{0, -1, 0}, {-1, 4, -1}, {0, -1, 0}};
    const Mask eight{{-1, -1, -1}, {-1, 8, -1}, {-1, -1, -1}};
    const Mask five{{0, 0, -1, 0, 0}, {0, -1, -2, -1, 0}, {-1, -2, 16, -2, -1}, {0, -1, -2, -1, 0}, {0, 0, -1, 0, 0}};
    for (const auto& [name, mask] :
         {std::pair{LogMask::FourNeighbours, four}, {LogMask::EightNeighbours, eight}, {LogMask::FiveByFive, five}}) {
        const Grid<float> response = laplacian(image, &missing, name);
        for (int i = 0; i < 17; ++i) {
            for (int j = 0; j < 22; ++j)
                ASSERT_EQ(response.at(i, j), missing.at(i, j) != 0 ? 0.0 : sumAt(image, missing, mask, i, j)) << i << " " << j;
        }
    }
}

// Gaussian without missing cells, then the Laplacian, as one double sum per cell.
double laplacianOfGaussianAt(const Grid<std::uint8_t>& image, const Grid<std::uint8_t>& missing, double sigma, int line, int beam) {
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    const auto smooth = [&](int atLine, int atBeam) {
        double sum = 0;
        double weights = 0;
        for (int di = -reach; di <= reach; ++di) {
            for (int dj = -reach; dj <= reach; ++dj) {
                const int i = std::clamp(atLine + di, 0, image.lines - 1);
                const int j = std::clamp(atBeam + dj, 0, image.beams - 1);
                if (missing.at(i, j) != 0) continue;
                const double weight = std::exp(-(di * di + dj * dj) / (2 * sigma * sigma));
                sum += weight * image.at(i, j);
                weights += weight;
            }
        }
        return sum / weights;
    };
    double sum = 0;
    for (const auto& [i, j] : {std::pair{line - 1, beam}, {line + 1, beam}, {line, beam - 1}, {line, beam + 1}}) {
        if (image.contains(i, j) && missing.at(i, j) == 0) sum += smooth(i, j) - smooth(line, beam);
    }
    return sum * sigma * sigma * sigma * std::sqrt(2 * std::numbers::pi);
}

TEST(Detectors, MarrHildrethIsTheLaplacianOfTheGaussian) {
    const Grid<std::uint8_t> image = noiseImage(14, 19, 21);
    for (const double sigma : {0.6, 1.4, 3.0}) {
        const Grid<std::uint8_t> missing = someMissing(14, 19, 22, 15);
        const Grid<float> response = laplacianOfGaussian(image, &missing, sigma);
        for (int i = 0; i < 14; ++i) {
            for (int j = 0; j < 19; ++j) {
                const double wanted = missing.at(i, j) != 0 ? 0.0 : laplacianOfGaussianAt(image, missing, sigma, i, j);
                ASSERT_NEAR(response.at(i, j), wanted, 1e-3) << sigma << " " << i << " " << j;
            }
        }
    }
}

TEST(Detectors, ZeroCrossingsBelongToTheCellCloserToZero) {
    Grid<float> values(1, 9);
    values.cells = {3, 5, -1, -4, 0, 7, 7, 0, 0};
    const Grid<float> slope = zeroCrossingSlope(values, nullptr);
    // 5 | -1: slope six, at the -1. -4 0 7: slope eleven, at the zero. 7 0 0 does not cross zero.
    EXPECT_EQ(slope.cells, (std::vector<float>{0, 0, 6, 0, 11, 0, 0, 0, 0}));
    Grid<std::uint8_t> missing(1, 9);
    missing[2] = missing[4] = 255;
    EXPECT_EQ(zeroCrossingSlope(values, &missing).cells, std::vector<float>(9, 0.0F));
    Grid<float> upright(9, 1, values.cells);
    EXPECT_EQ(zeroCrossingSlope(upright, nullptr).cells, slope.cells);
}

TEST(Detectors, AHoleInAFlatImageHasNoEdge) {
    Grid<std::uint8_t> image(30, 40, std::uint8_t{120});
    Grid<std::uint8_t> missing(30, 40);
    std::mt19937 random(4);
    for (std::size_t k = 0; k < image.size(); ++k) {
        if (random() % 5 != 0 && !(k % 40 > 10 && k % 40 < 20)) continue;
        missing[k] = 255;
        image[k] = 0;
    }
    for (const Method method : kAll) {
        Settings s;
        s.lower = 0.001;
        EXPECT_TRUE(edgeCells(test::detectorMask(method, image, &missing, s)).empty()) << static_cast<int>(method);
        EXPECT_FALSE(edgeCells(test::detectorMask(method, image, nullptr, s)).empty()) << static_cast<int>(method);
    }
}

TEST(Detectors, AThresholdIsACompareOfTheResponse) {
    const Grid<std::uint8_t> image = noiseImage(40, 50, 30);
    for (const Method method : kAll) {
        Settings s;
        const Grid<float> response = rowOf(method).response(image, nullptr, s);
        for (const double threshold : {0.0, 5.0, 77.5, 400.0}) {
            s.lower = threshold;
            const Grid<std::uint8_t> mask = test::detectorMask(method, image, nullptr, s);
            for (std::size_t k = 0; k < mask.size(); ++k) ASSERT_EQ(mask[k] != 0, response[k] > threshold);
        }
    }
}

Settings logRange(double percent, int kernel = 3, int aperture = 3) {
    Settings s;
    s.stepPercent = percent;
    s.ratio = 1.0;
    s.kernel = kernel;
    s.aperture = aperture;
    return s;
}

TEST(LogRange, TheThresholdIsTheStepInPercentOfRangeAtAnyRangeAndKernel) {
    for (const double rangeMm : {900.0, 5000.0, 31000.0}) {
        for (const auto& [kernel, aperture] : {std::pair{1, 3}, {3, 3}, {5, 5}, {9, 7}}) {
            const Scan step =
                test::makeScan(40, 40, [&](int, int j) { return static_cast<float>(std::round(j < 20 ? rangeMm : rangeMm * 1.05)); });
            EXPECT_FALSE(edgeCells(logRangeEdges(step, logRange(4.7, kernel, aperture))).empty()) << rangeMm << " " << kernel;
            EXPECT_TRUE(edgeCells(logRangeEdges(step, logRange(5.3, kernel, aperture))).empty()) << rangeMm << " " << kernel;
        }
    }
}

TEST(LogRange, ShortGapsAreBridgedAndHolesHaveNoEdge) {
    std::mt19937 random(6);
    const Scan wall = test::makeScan(60, 80, [&](int i, int j) {
        const bool hole = (i > 20 && i < 40 && j > 30 && j < 50) || random() % 100 < 8;
        return hole ? 0.0F : 6000.0F + static_cast<float>(random() % 21);
    });
    EXPECT_TRUE(edgeCells(logRangeEdges(wall, logRange(3.0))).empty());
}

TEST(LogRange, NothingIsLostBelowOneGrayLevel) {
    // Steps of 0.8 %: far below one of 255 levels over this scan's ratio of ranges, but clear in the logarithm.
    const Scan step = test::makeScan(40, 60, [](int, int j) { return j < 20 ? 1000.0F : j < 40 ? 30000.0F : 30240.0F; });
    const Grid<std::uint8_t> mask = logRangeEdges(step, logRange(0.5));
    EXPECT_TRUE(mask.at(20, 39) != 0 || mask.at(20, 40) != 0);
}

} // namespace
} // namespace edgescan::edges
