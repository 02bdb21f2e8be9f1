// The gray path's own loops compared with OpenCV, for every instruction set of this machine.
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <random>
#include <string>

namespace edgescan::edges {
namespace {

constexpr int kPictures = 10000; // for each instruction set

// Noise, blocks, ramps and mixtures of these: ties, flat parts, and the largest steps of eight bits.
Grid<std::uint8_t> anyPicture(std::mt19937& random) {
    const bool isWide = random() % 8 == 0; // several blocks of the loops, and a remainder
    const int lines = 1 + static_cast<int>(random() % (random() % 3 == 0 ? 4U : 24U));
    const int beams = 1 + static_cast<int>(random() % (isWide ? 300U : random() % 3 == 0 ? 5U : 90U));
    Grid<std::uint8_t> picture(lines, beams);
    const unsigned noise = 1U << (random() % 9U);
    const auto below = [&random](unsigned count) { return static_cast<unsigned>(random() % count); };
    const unsigned tall = 1 + below(9), broad = 1 + below(12), slope = below(7), steps = below(256);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const auto line = static_cast<unsigned>(i), beam = static_cast<unsigned>(j);
            picture.at(i, j) = static_cast<std::uint8_t>((line / tall * steps + beam / broad * 91) % 256 * (noise < 200 ? 1 : 0) +
                                                         slope * beam / 3 + random() % noise);
        }
    }
    return picture;
}

Settings anySettings(std::mt19937& random) {
    constexpr std::array kSigmas{kAutomatic, kAutomatic, 0.1, 0.45, 0.8, 1.3, 2.6, 10.0};
    Settings settings;
    settings.kernel = 1 + 2 * static_cast<int>(random() % 6U);
    settings.sigma = kSigmas[random() % kSigmas.size()];
    settings.aperture = 3 + 2 * static_cast<int>(random() % 3U);
    settings.norm = random() % 2 == 0 ? Norm::L1 : Norm::L2;
    const unsigned digits = settings.aperture == 3 ? 9U : 12U + static_cast<unsigned>(settings.aperture) - 5U;
    settings.lower = static_cast<double>(random() % (1U << (1 + random() % digits))) * (random() % 2 == 0 ? 1.0 : 0.37);
    settings.ratio = random() % 4 == 0 ? 1.0 : 1.0 + static_cast<double>(random() % 90U) / 10;
    return settings;
}

class EveryGrayLoop : public testing::TestWithParam<InstructionSet> {
protected:
    void SetUp() override {
        cv::setNumThreads(0);
        if (!isHere(GetParam())) GTEST_SKIP() << "this processor has no " << nameOf(GetParam());
    }
};

TEST_P(EveryGrayLoop, EqualsOpenCvOnThousandsOfPictures) {
    std::mt19937 random(16);
    std::size_t edges = 0;
    for (int n = 0; n < kPictures; ++n) {
        const Grid<std::uint8_t> levels = anyPicture(random);
        const Settings s = anySettings(random);
        cv::Mat picture(levels.lines, levels.beams, CV_8U, const_cast<std::uint8_t*>(levels.cells.data()));
        cv::Mat blurred;
        cv::GaussianBlur(picture, blurred, {s.kernel, s.kernel}, std::isnan(s.sigma) ? 0.0 : s.sigma);
        const Grid<std::uint8_t> smoothed = smoothBy(GetParam(), levels, s);
        ASSERT_TRUE(std::equal(smoothed.cells.begin(), smoothed.cells.end(), blurred.data))
            << n << ": " << levels.lines << " x " << levels.beams << ", kernel " << s.kernel << ", sigma " << s.sigma;
        cv::Mat mask;
        cv::Canny(blurred, mask, s.lower, s.upper(), s.aperture, s.norm == Norm::L2);
        const Grid<std::uint8_t> found = cannyBy(GetParam(), smoothed, s);
        ASSERT_TRUE(std::equal(found.cells.begin(), found.cells.end(), mask.data))
            << n << ": " << levels.lines << " x " << levels.beams << ", aperture " << s.aperture << ", lower " << s.lower << ", upper "
            << s.upper();
        edges += static_cast<std::size_t>(cv::countNonZero(mask));
    }
    EXPECT_GT(edges, 100000U) << "hardly a picture had an edge";
}

// Ranges of whole and fractional millimetres, and ranges exactly in the middle between two levels or next to it.
TEST_P(EveryGrayLoop, LevelsAreThoseOfDoubles) {
    std::mt19937 random(5);
    std::size_t middles = 0;
    for (int n = 0; n < 600; ++n) {
        const int cells = 1 + static_cast<int>(random() % 1500U);
        const LinearLevels to =
            linearLevels({static_cast<double>(random() % 3000U) / 7, 3000.0 + static_cast<double>(random() % 40000U) / 8, false});
        Grid<float> ranges(1, cells);
        Grid<CellState> states(1, cells, CellState::Valid);
        for (std::size_t k = 0; k < ranges.size(); ++k) {
            const auto middle = static_cast<float>((static_cast<double>(random() % 300U) + 0.5) / to.factor);
            const std::array<float, 6> any{static_cast<float>(random() % 60000U),
                                           static_cast<float>(random() % 60000U) / 13,
                                           middle,
                                           std::nextafter(middle, 0.0F),
                                           static_cast<float>(random() % 2 == 0 ? to.nearMm : to.farMm),
                                           random() % 2 == 0 ? 1e30F : -3.0F};
            ranges[k] = any[random() % (n % 3 == 0 ? 2U : any.size())];
            if (random() % 5 == 0) states[k] = CellState::NoReturn;
        }
        Grid<std::uint8_t> levels(1, cells);
        const std::size_t outside = levelsBy(GetParam(), ranges, states, to, levels);
        std::size_t expectedOutside = 0;
        for (std::size_t k = 0; k < ranges.size(); ++k) {
            const double range = ranges[k];
            const bool valid = states[k] == CellState::Valid;
            const double level = valid ? std::clamp(std::nearbyint(range * to.factor), 0.0, 255.0) : 0.0;
            ASSERT_EQ(levels[k], level) << range << " x " << to.factor;
            expectedOutside += valid && (range < to.nearMm || range > to.farMm) ? 1U : 0U;
            middles += std::abs(range * to.factor - std::floor(range * to.factor) - 0.5) < 1e-5 ? 1U : 0U;
        }
        EXPECT_EQ(outside, expectedOutside);
    }
    EXPECT_GT(middles, 10000U);
}

TEST_P(EveryGrayLoop, NoCellsGiveNoCells) {
    EXPECT_EQ(cannyBy(GetParam(), Grid<std::uint8_t>(), Settings{}).size(), 0U);
    EXPECT_EQ(smoothBy(GetParam(), Grid<std::uint8_t>(), Settings{}).size(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Instructions, EveryGrayLoop, testing::ValuesIn(kInstructionSets),
                         [](const testing::TestParamInfo<InstructionSet>& tested) {
                             std::string name;
                             for (const char c : std::string(nameOf(tested.param))) {
                                 if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
                             }
                             return name;
                         });

} // namespace
} // namespace edgescan::edges
