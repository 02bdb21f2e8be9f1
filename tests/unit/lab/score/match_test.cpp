// Matching and thinning compared with exhaustive search.
#include "app/lab/score/match.h"
#include "app/lab/sim/truth/thin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace edgescan::lab {
namespace {

Grid<std::uint8_t> randomMask(int lines, int beams, unsigned oneIn, std::mt19937& random) {
    Grid<std::uint8_t> mask(lines, beams);
    for (auto& cell : mask.cells) cell = random() % oneIn == 0 ? 255 : 0;
    return mask;
}

double distance(std::uint32_t a, std::uint32_t b, int beams) {
    const int n = static_cast<int>(a);
    const int m = static_cast<int>(b);
    return std::hypot(n / beams - m / beams, n % beams - m % beams);
}

// Tries every choice: the largest possible number of pairs.
std::size_t mostPairs(const std::vector<std::uint32_t>& detected, std::size_t at, std::vector<std::uint32_t>& truth, double tolerance,
                      int beams) {
    if (at == detected.size()) return 0;
    std::size_t best = mostPairs(detected, at + 1, truth, tolerance, beams);
    for (std::size_t t = 0; t < truth.size(); ++t) {
        if (distance(detected[at], truth[t], beams) > tolerance) continue;
        const std::uint32_t taken = truth[t];
        truth.erase(truth.begin() + static_cast<std::ptrdiff_t>(t));
        best = std::max(best, 1 + mostPairs(detected, at + 1, truth, tolerance, beams));
        truth.insert(truth.begin() + static_cast<std::ptrdiff_t>(t), taken);
    }
    return best;
}

std::vector<std::uint32_t> cellsOf(const Grid<std::uint8_t>& mask) {
    std::vector<std::uint32_t> cells;
    for (std::size_t k = 0; k < mask.size(); ++k) {
        if (mask[k] != 0) cells.push_back(static_cast<std::uint32_t>(k));
    }
    return cells;
}

TEST(Match, IsAsLargeAsBruteForceFindsIt) {
    std::mt19937 random(12);
    for (int round = 0; round < 400; ++round) {
        const Grid<std::uint8_t> detected = randomMask(5, 7, 4, random);
        const Grid<std::uint8_t> truth = randomMask(5, 7, 4, random);
        const double tolerance = std::array{0.0, 1.0, 1.5, 2.0, 3.0}[random() % 5];
        const auto pairs = matchEdges(detected, truth, tolerance);
        std::vector<std::uint32_t> d = cellsOf(detected);
        std::vector<std::uint32_t> t = cellsOf(truth);
        if (d.size() > 8) continue;
        EXPECT_EQ(pairs.size(), mostPairs(d, 0, t, tolerance, 7));
        std::set<std::uint32_t> usedDetections;
        std::set<std::uint32_t> usedTruth;
        for (const MatchedPair& pair : pairs) {
            EXPECT_NE(detected[pair.detected], 0);
            EXPECT_NE(truth[pair.truth], 0);
            EXPECT_LE(distance(pair.detected, pair.truth, 7), tolerance + 1e-9);
            EXPECT_TRUE(usedDetections.insert(pair.detected).second);
            EXPECT_TRUE(usedTruth.insert(pair.truth).second);
        }
    }
}

TEST(Match, AMaskMatchesItselfAndAShiftedOneWithinTheTolerance) {
    std::mt19937 random(5);
    const Grid<std::uint8_t> mask = randomMask(80, 120, 9, random);
    const auto self = matchEdges(mask, mask, 2);
    EXPECT_EQ(self.size(), cellsOf(mask).size());
    for (const MatchedPair& pair : self) EXPECT_EQ(pair.detected, pair.truth); // nearest first
    Grid<std::uint8_t> shifted(80, 120);
    for (int i = 0; i < 80; ++i) {
        for (int j = 0; j + 2 < 120; ++j) shifted.at(i, j + 2) = mask.at(i, j);
    }
    EXPECT_EQ(matchEdges(shifted, mask, 2).size(), cellsOf(shifted).size());
}

int components(const Grid<std::uint8_t>& mask) {
    Grid<std::uint8_t> left = mask;
    int count = 0;
    for (std::size_t start = 0; start < left.size(); ++start) {
        if (left[start] == 0) continue;
        ++count;
        std::vector<std::size_t> stack{start};
        left[start] = 0;
        while (!stack.empty()) {
            const auto k = stack.back();
            stack.pop_back();
            const int line = static_cast<int>(k) / left.beams;
            const int beam = static_cast<int>(k) % left.beams;
            for (int i = line - 1; i <= line + 1; ++i) {
                for (int j = beam - 1; j <= beam + 1; ++j) {
                    if (!left.contains(i, j) || left.at(i, j) == 0) continue;
                    left.at(i, j) = 0;
                    stack.push_back(left.index(i, j));
                }
            }
        }
    }
    return count;
}

TEST(Thin, KeepsConnectionsAndLeavesLinesOneCellWide) {
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round) {
        Grid<std::uint8_t> mask(30, 40);
        for (int stroke = 0; stroke < 6; ++stroke) { // thick strokes
            int i = static_cast<int>(random() % 30);
            int j = static_cast<int>(random() % 40);
            for (int step = 0; step < 25; ++step) {
                i = std::clamp(i + static_cast<int>(random() % 3) - 1, 0, 29);
                j = std::clamp(j + static_cast<int>(random() % 3) - 1, 0, 39);
                for (int di = 0; di < 3; ++di) {
                    for (int dj = 0; dj < 3; ++dj) {
                        if (mask.contains(i + di, j + dj)) mask.at(i + di, j + dj) = 255;
                    }
                }
            }
        }
        const Grid<std::uint8_t> thin = sim::thinned(mask);
        EXPECT_EQ(components(thin), components(mask));
        EXPECT_EQ(sim::thinned(thin), thin);
        for (std::size_t k = 0; k < mask.size(); ++k) EXPECT_LE(thin[k], mask[k]);
        for (int i = 1; i + 1 < 30; ++i) {
            for (int j = 1; j + 1 < 40; ++j) {
                bool full = true;
                for (int di = -1; di <= 1; ++di) {
                    for (int dj = -1; dj <= 1; ++dj) full = full && thin.at(i + di, j + dj) != 0;
                }
                EXPECT_FALSE(full);
            }
        }
    }
}

/// The paper's two passes over all cells, until both remove no cell.
Grid<std::uint8_t> thinnedCellByCell(Grid<std::uint8_t> mask) {
    for (int idle = 0, pass = 0; idle < 2; ++pass) {
        const Grid<std::uint8_t> before = mask;
        for (int i = 0; i < mask.lines; ++i) {
            for (int j = 0; j < mask.beams; ++j) {
                const auto p = [&](int di, int dj) { return before.contains(i + di, j + dj) && before.at(i + di, j + dj) != 0; };
                const bool p2 = p(-1, 0), p3 = p(-1, 1), p4 = p(0, 1), p5 = p(1, 1), p6 = p(1, 0), p7 = p(1, -1), p8 = p(0, -1),
                           p9 = p(-1, -1);
                const int c = (!p2 && (p3 || p4)) + (!p4 && (p5 || p6)) + (!p6 && (p7 || p8)) + (!p8 && (p9 || p2));
                const int n =
                    std::min((p9 || p2) + (p3 || p4) + (p5 || p6) + (p7 || p8), (p2 || p3) + (p4 || p5) + (p6 || p7) + (p8 || p9));
                const bool m = pass % 2 == 0 ? (p6 || p7 || !p9) && p8 : (p2 || p3 || !p5) && p4;
                if (c == 1 && n >= 2 && n <= 3 && !m) mask.at(i, j) = 0;
            }
        }
        idle = mask == before ? idle + 1 : 0;
    }
    return mask;
}

TEST(Thin, LooksOnlyWhereSomethingChangedAndMissesNothing) {
    std::mt19937 random(4);
    for (int round = 0; round < 120; ++round) {
        Grid<std::uint8_t> mask(1 + static_cast<int>(random() % 40), 1 + static_cast<int>(random() % 40));
        const unsigned filled = 5 + static_cast<unsigned>(random() % 95); // per cent: from dust to a full picture with holes
        for (std::uint8_t& cell : mask.cells) cell = random() % 100 < filled ? 255 : 0;
        EXPECT_EQ(sim::thinned(mask), thinnedCellByCell(mask)) << mask.lines << " x " << mask.beams << ", " << filled << " %";
    }
}

} // namespace
} // namespace edgescan::lab
