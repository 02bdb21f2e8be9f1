// Distances to the nearest barrier: the same as by trying all barriers, however the work is divided.
#include "core/rocks/segmentation/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace edgescan::rocks {
namespace {

Grid<float> bySearch(const Grid<std::uint8_t>& free) {
    Grid<float> distance(free.lines, free.beams, std::sqrt(1e15F));
    for (int i = 0; i < free.lines; ++i) {
        for (int j = 0; j < free.beams; ++j) {
            for (int k = 0; k < free.lines; ++k) {
                for (int l = 0; l < free.beams; ++l) {
                    if (free.at(k, l) != 0) continue;
                    const int squared = (i - k) * (i - k) + (j - l) * (j - l);
                    distance.at(i, j) = std::min(distance.at(i, j), std::sqrt(static_cast<float>(squared)));
                }
            }
        }
    }
    return distance;
}

// Many barriers, few, one, and none; lines and columns without any.
TEST(Distance, IsThatOfTheNearestBarrier) {
    std::mt19937 random(31);
    for (const auto& [lines, beams] : {std::pair{1, 1}, {1, 70}, {70, 1}, {33, 64}, {64, 97}}) {
        for (const std::uint32_t every : {3U, 40U, 900U, 1000000000U}) {
            Grid<std::uint8_t> free(lines, beams, 255);
            for (std::uint8_t& cell : free.cells) cell = random() % every == 0 ? 0 : 255;
            const Grid<float> wanted = bySearch(free);
            for (const int threads : {1, 2, 4})
                ASSERT_EQ(distanceToZero(free, threads), wanted) << lines << " x " << beams << ", " << every;
        }
    }
}

// A grid whose squares are not exact in floats is measured by OpenCV, and so is one with long ways.
TEST(Distance, IsThatOfTheNearestBarrierInLargeGrids) {
    for (const auto& [lines, beams] : {std::pair{2, 2600}, {1500, 40}}) {
        Grid<std::uint8_t> free(lines, beams, 1);
        free.at(1, 3) = 0;
        const Grid<float> distance = distanceToZero(free, 2);
        for (int i = 0; i < lines; ++i) {
            for (int j = 0; j < beams; ++j)
                ASSERT_EQ(distance.at(i, j), std::sqrt(static_cast<float>((i - 1) * (i - 1) + (j - 3) * (j - 3)))) << i << ", " << j;
        }
    }
}

} // namespace
} // namespace edgescan::rocks
