// The map of linked responses compared with a search for each cell's threshold, and with chains followed one by one.
#include "core/edges/gray/canny.h"
#include "core/edges/pipeline/edge_levels.h"
#include "core/edges/pipeline/threshold_map.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace edgescan;
using namespace edgescan::edges;

namespace {

Grid<float> randomStrength(std::mt19937& random, int kind) {
    Grid<float> strength(1 + static_cast<int>(random() % 24), 1 + static_cast<int>(random() % 24));
    for (float& value : strength.cells) {
        const float one = static_cast<float>(random() % 100000) / 100000.0F;
        value = kind == 0   ? static_cast<float>(random() % 5)
                : kind == 1 ? 3 * one
                : kind == 2 ? std::exp(80 * (one - 0.5F))
                            : std::bit_cast<float>(static_cast<std::uint32_t>(random() % 0x7F800000U));
        if (random() % 3 == 0) value = 0;
        if (random() % 40 == 0) value = -1;
        if (random() % 90 == 0) value = std::numeric_limits<float>::quiet_NaN();
        if (random() % 90 == 0) value = std::numeric_limits<float>::infinity();
    }
    return strength;
}

// Connected cells above the lower threshold, if one of them is above the higher one and there are enough of them.
Grid<std::uint8_t> chainsOneByOne(const Grid<float>& strength, float high, float share, int minimumLength) {
    Grid<std::uint8_t> mask(strength.lines, strength.beams), seen = mask;
    for (std::size_t start = 0; start < strength.size(); ++start) {
        if (seen[start] != 0 || !(strength[start] > 0 && strength[start] > high * share)) continue;
        std::vector<std::size_t> chain{start};
        seen[start] = 1;
        bool isStrong = false;
        for (std::size_t at = 0; at < chain.size(); ++at) {
            const std::size_t k = chain[at];
            isStrong = isStrong || (strength[k] > high && strength[k] > high * share);
            const int line = static_cast<int>(k) / strength.beams, beam = static_cast<int>(k) % strength.beams;
            for (int i = line - 1; i <= line + 1; ++i) {
                for (int j = beam - 1; j <= beam + 1; ++j) {
                    if (!strength.contains(i, j) || seen.at(i, j) != 0) continue;
                    if (!(strength.at(i, j) > 0 && strength.at(i, j) > high * share)) continue;
                    seen.at(i, j) = 1;
                    chain.push_back(strength.index(i, j));
                }
            }
        }
        if (!isStrong || static_cast<int>(chain.size()) < minimumLength) continue;
        for (const std::size_t k : chain) mask[k] = 255;
    }
    return mask;
}

} // namespace

TEST(LinkedMap, IsWhatASearchOfEachCellFinds) {
    std::mt19937 random(11);
    for (int turn = 0; turn < 400; ++turn) {
        const float here = randomStrength(random, turn % 4)[0];
        if (!(here > 0)) continue;
        const float share = turn % 9 == 0 ? 0.0F : static_cast<float>(1 + random() % 1000) / 1000.0F;
        const ThresholdMap map = linkedThresholdMap(Grid<float>(1, 1, here), static_cast<double>(share), 1);
        const double weak = largestThreshold([&](double high) { return here > static_cast<float>(high) * share; }, here / share);
        const double strong = largestThreshold([&](double high) { return here > static_cast<float>(high); }, here);
        EXPECT_EQ(map.highest[0], std::min(weak, strong)) << here << " share " << share;
    }
}

// Some cells are edges at every threshold, and link chains if they are strong enough.
TEST(LinkedMap, TheCountsAtAllThresholdsAreThoseOfTheMap) {
    std::mt19937 random(13);
    std::size_t edges = 0;
    for (int turn = 0; turn < 300; ++turn) {
        const Grid<float> strength = randomStrength(random, turn % 3);
        const float share = turn % 9 == 0 ? 0.0F : static_cast<float>(1 + random() % 1000) / 1000.0F;
        const int minimumLength = 1 + static_cast<int>(random() % 6);
        std::vector<double> thresholds;
        const std::size_t most = 1 + random() % kMostLevels;
        for (std::size_t n = 0; n < most; ++n)
            thresholds.push_back(static_cast<double>(n) * (turn % 2 == 0 ? 0.05 : 1e-7 * std::exp(static_cast<double>(n) / 8)));
        std::vector<double> weak, strong;
        for (const double threshold : thresholds) {
            strong.push_back(static_cast<double>(static_cast<float>(threshold)));
            weak.push_back(static_cast<double>(static_cast<float>(threshold) * share));
        }
        EdgeLevels levels = edgeLevels(strength, weak, strong, minimumLength);
        ThresholdMap map = linkedThresholdMap(strength, static_cast<double>(share), minimumLength);
        for (std::uint32_t k = 0; k < strength.size(); ++k) {
            if (random() % 10 != 0) continue;
            levels.apart.push_back(k);
            map.highest[k] = std::numeric_limits<double>::infinity();
        }
        levels.atEach = levels.apart.size();
        const std::vector<std::size_t> counts = edgeCounts(levels, thresholds.size());
        for (std::size_t n = 0; n < thresholds.size(); ++n) {
            ASSERT_EQ(counts[n], edgeCells(edgesAt(map, thresholds[n])).size()) << "turn " << turn << " threshold " << thresholds[n];
            edges += counts[n];
        }
    }
    EXPECT_GT(edges, 100000U);
}

TEST(LinkedMap, IsWhatChainsOneByOneGive) {
    std::mt19937 random(12);
    for (int turn = 0; turn < 200; ++turn) {
        const Grid<float> strength = randomStrength(random, turn % 3);
        const float share = turn % 9 == 0 ? 0.0F : static_cast<float>(1 + random() % 1000) / 1000.0F;
        const int minimumLength = 1 + static_cast<int>(random() % 6);
        const ThresholdMap map = linkedThresholdMap(strength, static_cast<double>(share), minimumLength);
        const auto strengthOf = [&](std::size_t k) { return strength[k]; };
        for (std::size_t k = 0; k < strength.size(); ++k)
            ASSERT_EQ(linkedThresholdAt(strength.lines, strength.beams, strengthOf, static_cast<double>(share), minimumLength, k),
                      map.highest[k])
                << "turn " << turn << " cell " << k;
        for (int n = 0; n < 12; ++n) {
            const float some = strength[random() % strength.size()];
            const float high = n == 0 ? 0.0F : some > 0 && some < 1e9F ? some : static_cast<float>(n) / 5;
            EXPECT_EQ(edgesAt(map, static_cast<double>(high)), chainsOneByOne(strength, high, share, minimumLength))
                << "turn " << turn << " threshold " << high;
        }
    }
}
