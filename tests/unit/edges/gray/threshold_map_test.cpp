// The threshold map compared with the methods themselves, run at every threshold.
#include "core/edges/gray/canny.h"
#include "core/edges/gray/log_range.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/edge_count_curve.h"
#include "core/edges/pipeline/swept_edges.h"
#include "core/edges/pipeline/threshold_map.h"
#include "tests/support/detectors.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::edges {
namespace {

Grid<std::uint8_t> blocks(int lines, int beams, std::uint32_t seed) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> image(lines, beams);
    const auto noise = static_cast<unsigned>(1 + random() % 40);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j)
            image.at(i, j) = static_cast<std::uint8_t>((static_cast<unsigned>(i / 5 * 37 + j / 7 * 91) + random() % noise) % 256);
    }
    return image;
}

Grid<std::uint8_t> holes(int lines, int beams, std::uint32_t seed) {
    std::mt19937 random(seed);
    Grid<std::uint8_t> missing(lines, beams);
    for (std::uint8_t& cell : missing.cells) cell = random() % 12 == 0 ? 255 : 0;
    return missing;
}

// Thresholds between, at and one bit beyond the values of the map.
std::vector<double> thresholdsOf(const ThresholdMap& map, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<double> all{0.0, 0.1, 1.0, 2.5, 7.0, 10.0, 33.3, 100.0, 340.0, 5000.0, 20000.0};
    for (int n = 0; n < 12; ++n) {
        const double highest = map.highest[random() % map.highest.size()];
        if (highest < 0 || !std::isfinite(highest)) continue;
        all.insert(all.end(), {highest, std::nextafter(highest, 1e9), std::max(0.0, std::nextafter(highest, -1.0))});
    }
    return all;
}

void expectTheMapCellByCell(const Gradient& gradient, const Settings& s) {
    const Grid<std::int32_t> suppressed = suppressedMagnitude(gradient, s.norm);
    const ThresholdMap map = cannyThresholdMap(gradient, s);
    for (std::size_t k = 0; k < suppressed.size(); ++k) {
        ASSERT_EQ(suppressedMagnitudeAt(gradient, s.norm, k), suppressed[k]) << k;
        ASSERT_EQ(cannyThresholdAt(gradient, s, k), map.highest[k]) << k;
    }
}

TEST(ThresholdMap, EqualsCannyAtEveryThreshold) {
    std::size_t edges = 0;
    std::uint32_t seed = 0;
    for (const auto& [lines, beams] : {std::pair{1, 1}, {1, 40}, {2, 9}, {37, 53}}) {
        for (const int aperture : {3, 5, 7}) {
            for (const Norm norm : {Norm::L1, Norm::L2}) {
                for (const double ratio : {1.0, 3.0, 2.7}) {
                    Settings s;
                    s.aperture = aperture;
                    s.norm = norm;
                    s.ratio = ratio;
                    const Grid<std::uint8_t> image = smooth(blocks(lines, beams, ++seed), s);
                    const Grid<std::uint8_t> missing = holes(lines, beams, seed);
                    const ThresholdMap whole = cannyThresholdMap(sobelGradient(image, nullptr, aperture), s);
                    const ThresholdMap masked = cannyThresholdMap(sobelGradient(image, &missing, aperture), s);
                    for (const Grid<std::uint8_t>* without : {static_cast<const Grid<std::uint8_t>*>(nullptr), &missing})
                        expectTheMapCellByCell(sobelGradient(image, without, aperture), s);
                    for (const double threshold : thresholdsOf(whole, seed)) {
                        s.lower = threshold;
                        const Grid<std::uint8_t> mask = canny(image, s);
                        ASSERT_EQ(edgesAt(whole, threshold), mask) << threshold << " aperture " << aperture << " ratio " << ratio;
                        edges += edgeCells(mask).size();
                    }
                    for (const double threshold : thresholdsOf(masked, seed)) {
                        s.lower = threshold;
                        ASSERT_EQ(edgesAt(masked, threshold), cannyAroundHoles(image, missing, s)) << threshold << " masked";
                    }
                }
            }
        }
    }
    EXPECT_GT(edges, 10000U);
}

TEST(ThresholdMap, EqualsLogRangeCannyAtEveryStep) {
    for (const std::uint32_t seed : {1U, 2U}) {
        const Scan scan = test::boxesScan(50, 60, seed, 0.05);
        for (const Norm norm : {Norm::L1, Norm::L2}) {
            Settings s;
            s.norm = norm;
            const ThresholdMap map = logRangeThresholdMap(scan, s);
            for (std::size_t k = 0; k < map.highest.size(); k += 7) ASSERT_EQ(logRangeThresholdAt(scan, s, k), map.highest[k]) << k;
            for (const double threshold : thresholdsOf(map, seed)) {
                if (threshold > 100) continue;
                s.stepPercent = threshold;
                ASSERT_EQ(edgesAt(map, threshold), logRangeEdges(scan, s)) << threshold;
            }
        }
    }
}

TEST(ThresholdMap, EqualsTheDetectorsOfOneThreshold) {
    const Grid<std::uint8_t> image = blocks(30, 41, 8);
    const Grid<std::uint8_t> missing = holes(30, 41, 9);
    for (const Method method :
         {Method::Roberts, Method::Sobel, Method::Prewitt, Method::Kirsch, Method::Robinson, Method::MarrHildreth, Method::Log}) {
        Settings s;
        const ThresholdMap map = responseThresholdMap(rowOf(method).response(image, &missing, s));
        for (const double threshold : thresholdsOf(map, 3)) {
            s.lower = threshold;
            ASSERT_EQ(edgesAt(map, threshold), test::detectorMask(method, image, &missing, s)) << threshold;
        }
    }
}

// Every cell reads its neighbours until no value changes.
Grid<double> spreadSlowly(Grid<double> marker, const Grid<double>& mask) {
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < marker.lines; ++i) {
            for (int j = 0; j < marker.beams; ++j) {
                for (int a = i - 1; a <= i + 1; ++a) {
                    for (int b = j - 1; b <= j + 1; ++b) {
                        if (!marker.contains(a, b)) continue;
                        const double value = std::min(marker.at(a, b), mask.at(i, j));
                        if (value <= marker.at(i, j)) continue;
                        marker.at(i, j) = value;
                        changed = true;
                    }
                }
            }
        }
    }
    return marker;
}

// Few values and many, and more cells than are sorted.
TEST(ThresholdMap, SortedCellsGiveTheSameEdges) {
    std::mt19937 random(3);
    for (const auto& [lines, beams, share, values] :
         {std::array{1, 1, 1, 1}, {1, 7, 4, 3}, {90, 130, 8, 40}, {90, 130, 2, 40}, {600, 700, 5, 1 << 30}}) {
        ThresholdMap map{Grid<double>(lines, beams, -1.0)};
        for (double& highest : map.highest.cells) {
            if (static_cast<int>(random() % static_cast<unsigned>(share)) != 0) continue;
            const auto value = static_cast<unsigned>(random() % static_cast<unsigned>(values));
            highest = value == 1 ? std::numeric_limits<double>::infinity() : value / 3.0;
        }
        const SweptEdges swept(map);
        for (const double threshold : thresholdsOf(map, 1)) ASSERT_EQ(swept.at(threshold), edgesAt(map, threshold)) << threshold;
    }
}

TEST(ThresholdMap, ReconstructionFollowsWindingPaths) {
    std::mt19937 random(77);
    for (int round = 0; round < 40; ++round) {
        const int lines = 1 + static_cast<int>(random() % 20);
        const int beams = 1 + static_cast<int>(random() % 25);
        Grid<double> mask(lines, beams);
        Grid<double> marker(lines, beams);
        for (std::size_t k = 0; k < mask.size(); ++k) {
            mask[k] = random() % 3 == 0 ? -1.0 : static_cast<double>(random() % 50);
            marker[k] = random() % 9 == 0 ? mask[k] / (mask[k] < 0 ? 1 : 3) : -1.0;
        }
        ASSERT_EQ(reconstructed(marker, mask), spreadSlowly(marker, mask));
    }
}

TEST(ThresholdMap, LargestThresholdIsExactWhateverTheGuess) {
    for (const double limit : {0.0, 0.1, 1.0 / 3, 7.0, 1234.567}) {
        for (const double guess : {-1.0, 0.0, 0.1, 1.0 / 3, 7.0, 1e8, std::numeric_limits<double>::infinity()})
            EXPECT_EQ(largestThreshold([&](double t) { return t <= limit; }, guess), limit);
    }
    EXPECT_LT(largestThreshold([](double) { return false; }, 3), 0);
    EXPECT_EQ(largestThreshold([](double) { return true; }, 3), std::numeric_limits<double>::infinity());
}

std::vector<double> wholeNumbers(int count) {
    std::vector<double> all;
    for (int n = 0; n < count; ++n) all.push_back(n);
    return all;
}

EdgeCountCurve curveOf(const ThresholdMap& map, std::vector<double> thresholds) {
    std::vector<std::size_t> edges;
    for (const double threshold : thresholds) edges.push_back(edgeCells(edgesAt(map, threshold)).size());
    return edgeCountCurve(std::move(edges), std::move(thresholds), map.highest.size());
}

TEST(ThresholdMap, TheCurveFindsThePlateau) {
    // 1000 cells of noise up to 2, 200 edges between 40 and 60, nothing between.
    ThresholdMap map{Grid<double>(30, 50, -1.0)};
    for (std::size_t k = 0; k < 1000; ++k) map.highest[k] = static_cast<double>(k) / 500.0;
    for (std::size_t k = 1000; k < 1200; ++k) map.highest[k] = 40.0 + static_cast<double>(k - 1000) / 10.0;
    const EdgeCountCurve curve = curveOf(map, wholeNumbers(101));
    ASSERT_EQ(curve.thresholds.size(), 101U);
    EXPECT_EQ(curve.stableFrom, 2.0);
    EXPECT_EQ(curve.stableTo, 44.0);
    // An image full of edges is not stable, however long the count stays constant.
    for (std::size_t k = 0; k < 1000; ++k) map.highest[k] = 90.0 + static_cast<double>(k % 100) / 100.0;
    const EdgeCountCurve full = curveOf(map, wholeNumbers(101));
    EXPECT_EQ(full.stableFrom, full.stableTo);
    const EdgeCountCurve none = curveOf({Grid<double>(3, 3, -1.0)}, wholeNumbers(11));
    EXPECT_EQ(none.stableFrom, none.stableTo);
}

} // namespace
} // namespace edgescan::edges
