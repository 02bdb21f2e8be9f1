// The cell that a click means: compared with a slow search that knows the true surfaces.
#include "core/inspect/measure/jumps_along.h"
#include "core/inspect/measure/near_side.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <tuple>

namespace edgescan::inspect {
namespace {

TEST(JumpsAlong, AStepIsOneAndAFoldIsNone) {
    const std::vector<double> step{5, 5, 5, 5, 8, 8, 8, 8};
    const auto jumps = jumpsAlong(step, 7);
    ASSERT_EQ(jumps.size(), 1U);
    EXPECT_EQ(jumps[0].nearer(), 3);
    EXPECT_EQ(jumps[0].farther(), 4);
    EXPECT_NEAR(jumps[0].stepM, 3.0, 1e-9);
    // Two planes that meet: a wall and a floor, in steps of one degree.
    std::vector<double> fold;
    for (int n = 0; n < 30; ++n) {
        const double angle = (n - 15) * 3.14159265 / 180;
        fold.push_back(std::min(6.0 / std::cos(angle), angle < -1e-9 ? 0.9 / std::sin(-angle) : 1e9));
    }
    EXPECT_TRUE(jumpsAlong(fold, 7).empty());
    // A slanted plane without end, at 75 degrees to the beam.
    std::vector<double> slanted;
    for (int n = 0; n < 30; ++n) slanted.push_back(4.0 / std::cos((60 + n / 2.0) * 3.14159265 / 180));
    EXPECT_TRUE(jumpsAlong(slanted, 7).empty());
}

TEST(JumpsAlong, MixedPixelsAndGapsAreBetweenItsEnds) {
    const auto one = jumpsAlong(std::vector<double>{5, 5, 5, 6.2, 8, 8, 8}, 7);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(std::tuple(one[0].from, one[0].to), std::tuple(2, 4));
    const auto gap = jumpsAlong(std::vector<double>{5, 5, 5, 0, 0, 0, 8, 8, 8}, 7);
    ASSERT_EQ(gap.size(), 1U);
    EXPECT_EQ(std::tuple(gap[0].from, gap[0].to), std::tuple(2, 6));
    EXPECT_TRUE(jumpsAlong(std::vector<double>{5, 5, 5, 0, 0, 0, 8, 8, 8}, 2).empty());
    EXPECT_TRUE(jumpsAlong(std::vector<double>{5, 5, 5, 0, 0, 0, 5, 5, 5}, 7).empty());
    EXPECT_TRUE(jumpsAlong({}, 7).empty());
}

/// What a click means where the true depth of every cell is known.
class Oracle {
public:
    explicit Oracle(const Scan& scan, double apartM) : scan_(scan), apartM_(apartM) {}

    [[nodiscard]] std::uint32_t meant(std::uint32_t k) const {
        const int line = static_cast<int>(k) / scan_.beams(), beam = static_cast<int>(k) % scan_.beams();
        std::optional<std::uint32_t> start;
        auto least = std::tuple(1000, 0.0, 0U);
        around(line, beam, [&](int i, int j, int square) {
            if (range(i, j) <= 0.0) return;
            const auto order = std::tuple(square, range(i, j), index(i, j));
            if (!start || order < least) std::tie(least, start) = std::pair(order, std::optional(index(i, j)));
        });
        if (!start) return k;
        const int startLine = static_cast<int>(*start) / scan_.beams(), startBeam = static_cast<int>(*start) % scan_.beams();
        std::uint32_t best = *start;
        least = std::tuple(1000, 0.0, 0U);
        around(line, beam, [&](int i, int j, int square) {
            if (range(i, j) <= 0.0 || isSame(range(i, j), range(startLine, startBeam)) || range(i, j) > range(startLine, startBeam)) return;
            const auto order = std::tuple(square, range(i, j), index(i, j));
            if (order < least) std::tie(least, best) = std::pair(order, index(i, j));
        });
        return best;
    }

private:
    template <class Visit>
    void around(int line, int beam, Visit visit) const {
        for (int i = line - kSnapReach; i <= line + kSnapReach; ++i) {
            for (int j = beam - kSnapReach; j <= beam + kSnapReach; ++j) {
                if (scan_.rangeMm.contains(i, j)) visit(i, j, (i - line) * (i - line) + (j - beam) * (j - beam));
            }
        }
    }
    [[nodiscard]] bool isSame(double a, double b) const { return std::abs(a - b) < apartM_; }
    [[nodiscard]] double range(int i, int j) const {
        return scan_.state.at(i, j) == CellState::Valid ? static_cast<double>(scan_.rangeMm.at(i, j)) / 1000.0 : 0.0;
    }
    [[nodiscard]] std::uint32_t index(int i, int j) const { return static_cast<std::uint32_t>(scan_.rangeMm.index(i, j)); }

    const Scan& scan_;
    double apartM_;
};

/// One plate in front of a wall, with noise of a centimetre and lost cells.
Scan plateScan(std::uint32_t seed, double dropouts) {
    std::mt19937 random(seed);
    const int top = 8 + static_cast<int>(random() % 10), left = 8 + static_cast<int>(random() % 10);
    const int high = 8 + static_cast<int>(random() % 10), wide = 8 + static_cast<int>(random() % 10);
    const double nearMm = 3000 + static_cast<double>(random() % 3000), farMm = nearMm + 500 + static_cast<double>(random() % 8000);
    return test::makeScan(48, 48, [&](int i, int j) {
        if (static_cast<double>(random() % 10000) < dropouts * 10000) return 0.0;
        const bool plate = i >= top && i < top + high && j >= left && j < left + wide;
        return (plate ? nearMm : farMm) + static_cast<double>(random() % 11) - 5.0;
    });
}

TEST(NearSide, AClickAtAPlateIsThatOfTheSlowSearch) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        const Scan scan = plateScan(seed, 0.0);
        const Oracle oracle(scan, 0.3);
        for (std::uint32_t k = 0; k < scan.cells(); ++k) {
            const ClickedCell meant = nearSideCell(scan, k);
            ASSERT_EQ(scan.rangeMm[meant.cell] < scan.rangeMm[k] - 300, scan.rangeMm[oracle.meant(k)] < scan.rangeMm[k] - 300)
                << "seed " << seed << ", line " << k / 48 << ", beam " << k % 48;
            ASSERT_EQ(meant.moved(), oracle.meant(k) != k) << "seed " << seed << ", line " << k / 48 << ", beam " << k % 48;
            if (meant.moved()) {
                ASSERT_EQ(meant.reason, SnapReason::BehindAnEdge);
                ASSERT_NEAR(meant.nearerM, static_cast<double>(scan.rangeMm[k] - scan.rangeMm[meant.cell]) / 1000, 1e-6);
            }
            // As near as the slow search finds it; of several cells at one distance any.
            const auto away = [&](std::uint32_t cell) {
                return std::hypot(static_cast<int>(cell / 48) - static_cast<int>(k / 48),
                                  static_cast<int>(cell % 48) - static_cast<int>(k % 48));
            };
            ASSERT_EQ(away(meant.cell), away(oracle.meant(k))) << "seed " << seed << ", line " << k / 48 << ", beam " << k % 48;
        }
    }
}

TEST(NearSide, LostCellsDoNotChangeTheSurface) {
    int clicks = 0, differ = 0;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        const Scan scan = plateScan(seed, 0.03);
        const Oracle oracle(scan, 0.3);
        for (std::uint32_t k = 0; k < scan.cells(); ++k, ++clicks) {
            const ClickedCell meant = nearSideCell(scan, k);
            if (meant.measured()) {
                EXPECT_EQ(scan.state[meant.cell], CellState::Valid);
            }
            differ += std::abs(scan.rangeMm[meant.cell] - scan.rangeMm[oracle.meant(k)]) > 300 ? 1 : 0;
        }
    }
    EXPECT_LT(differ, clicks / 1000) << "of " << clicks;
}

TEST(NearSide, TheMiddleOfASurfaceAndOfAHoleStay) {
    const Scan scan = test::makeScan(40, 40, [](int i, int j) { return std::hypot(i - 20, j - 20) < 9 ? 0.0 : 5000.0; });
    const auto cell = [&](int i, int j) { return static_cast<std::uint32_t>(scan.rangeMm.index(i, j)); };
    EXPECT_FALSE(nearSideCell(scan, cell(5, 5)).moved());
    EXPECT_EQ(nearSideCell(scan, cell(5, 5)).reason, SnapReason::AsClicked);
    EXPECT_EQ(nearSideCell(scan, cell(20, 20)).reason, SnapReason::NoRange);
    EXPECT_FALSE(nearSideCell(scan, cell(20, 20)).measured());
    EXPECT_EQ(nearSideCell(scan, cell(20, 13)).cell, cell(20, 11));
    EXPECT_EQ(nearSideCell(scan, cell(20, 13)).reason, SnapReason::NoRange);
    EXPECT_TRUE(nearSideCell(scan, cell(20, 13)).measured());
    // The corners of the grid.
    for (const std::uint32_t k : {cell(0, 0), cell(0, 39), cell(39, 0), cell(39, 39)}) EXPECT_EQ(nearSideCell(scan, k).cell, k);
}

// The fault that an operator saw: the wall 13 m behind the rim was measured.
TEST(NearSide, TheRimOfAVoidIsNotTheWallBehindIt) {
    const Scan scan = test::makeScan(60, 60, [](int i, int j) { return std::hypot(i - 30, j - 30) < 12 ? 18000.0 : 5000.0; });
    for (int turn = 0; turn < 360; turn += 5) {
        const double radius = 10.5; // cells from the middle: a cell and a half inside the rim
        const int i = static_cast<int>(std::lround(30 + radius * std::sin(turn * 3.14159265 / 180)));
        const int j = static_cast<int>(std::lround(30 + radius * std::cos(turn * 3.14159265 / 180)));
        const ClickedCell meant = nearSideCell(scan, static_cast<std::uint32_t>(scan.rangeMm.index(i, j)));
        EXPECT_EQ(scan.rangeMm[meant.cell], 5000.0F) << "line " << i << ", beam " << j;
        EXPECT_NEAR(meant.nearerM, 13.0, 1e-6);
    }
}

TEST(NearSide, BetweenTwoSurfacesTheNearerOneIsNamedToo) {
    const Scan scan = test::makeScan(30, 30, [](int, int j) { return j < 14 ? 5000.0 : j < 18 ? 18000.0 : 4000.0; });
    const auto at = [&](int j) { return static_cast<std::uint32_t>(scan.rangeMm.index(12, j)); };
    EXPECT_EQ(nearSideCell(scan, at(15)).cell, at(13));
    EXPECT_EQ(nearSideCell(scan, at(15)).alsoNear, at(18));
    EXPECT_EQ(nearSideCell(scan, at(17)).cell, at(18));
    for (const int j : {5, 17, 18, 20}) EXPECT_EQ(nearSideCell(scan, at(j)).alsoNear, std::nullopt) << "beam " << j;
    // A slope has no surface in front of itself, also at its near end.
    const Scan slope = test::makeScan(30, 30, [](int, int j) { return j < 15 ? 9000.0 : 6000.0 - 60.0 * (j - 15); });
    for (int j = 15; j < 25; ++j) EXPECT_EQ(nearSideCell(slope, at(j)).alsoNear, std::nullopt) << "beam " << j;
}

TEST(NearSide, AMixedPixelMeansTheSurfaceInFront) {
    const Scan scan = test::makeScan(30, 30, [](int, int j) { return j < 15 ? 5000.0 : j == 15 ? 6400.0 : 8000.0; });
    const ClickedCell meant = nearSideCell(scan, static_cast<std::uint32_t>(scan.rangeMm.index(12, 15)));
    EXPECT_EQ(meant.cell, static_cast<std::uint32_t>(scan.rangeMm.index(12, 14)));
    EXPECT_EQ(meant.reason, SnapReason::MixedPixel);
}

// An echo of dust two metres in front of a wall is not a surface that a click means, next to the rim of a plate and in the middle of the
// wall.
TEST(NearSide, AClickOnDustMeansWhatIsBehindIt) {
    Scan scan = test::makeScan(30, 30, [](int, int j) { return j < 15 ? 5000.0 : 8000.0; });
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(scan.rangeMm.index(i, j)); };
    for (const std::uint32_t dust : {at(12, 16), at(20, 24), at(6, 4)}) {
        scan.rangeMm[dust] = 2000.0F;
        const ClickedCell meant = nearSideCell(scan, dust);
        EXPECT_TRUE(meant.moved());
        EXPECT_EQ(meant.reason, SnapReason::Dust);
        EXPECT_GE(scan.rangeMm[meant.cell], 5000.0F);
        EXPECT_LT(meant.nearerM, 0.0);
        for (const std::uint32_t next : {dust - 1, dust + 1}) EXPECT_GE(scan.rangeMm[nearSideCell(scan, next).cell], 5000.0F); // nor a rim
    }
    // Nothing else was measured around it.
    Scan alone = test::makeScan(30, 30, [](int i, int j) { return i == 12 && j == 12 ? 3000.0 : 0.0; });
    EXPECT_EQ(nearSideCell(alone, at(12, 12)).cell, at(12, 12));
    EXPECT_EQ(nearSideCell(alone, at(12, 12)).reason, SnapReason::AsClicked);
}

// Of several cells of one surface that are as near to the click none is chosen for its short range: the ends of lengths would be too near.
TEST(NearSide, NoiseDoesNotChooseTheCell) {
    double sumMm = 0.0;
    constexpr int kScans = 1000;
    for (std::uint32_t seed = 1; seed <= kScans; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0.0, 8.0);
        const Scan scan = test::makeScan(15, 15, [&](int i, int j) { return i == 7 && j == 7 ? 0.0 : 5000.0 + noise(random); });
        const auto hole = static_cast<std::uint32_t>(scan.rangeMm.index(7, 7));
        const ClickedCell meant = nearSideCell(scan, hole);
        EXPECT_EQ(meant.reason, SnapReason::NoRange);
        sumMm += scan.rangeMm[meant.cell] - 5000.0;
    }
    EXPECT_NEAR(sumMm / kScans, 0.0, 1.0); // 8 mm / sqrt(1000) is 0.25 mm
}

} // namespace
// A click on an edge that is moved to the near surface means the edge of that surface.
TEST(NearSide, AClickOnAnEdgeMeansTheEdgeOfTheNearSurface) {
    const Scan scan = test::makeScan(30, 30, [](int, int j) { return j < 15 ? 5000.0 : 8000.0; });
    Grid<std::uint8_t> mask(30, 30);
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(scan.rangeMm.index(i, j)); };
    for (int i = 0; i < 30; ++i) mask.cells[at(i, 13)] = mask.cells[at(i, 15)] = 255; // one of each side, not next to the other
    EXPECT_EQ(nearSideCell(scan, at(12, 15)).cell, at(12, 14));
    EXPECT_EQ(nearSideEdge(scan, mask, at(12, 15)).cell, at(12, 13));
    EXPECT_EQ(nearSideEdge(scan, mask, at(12, 13)).cell, at(12, 13));
    EXPECT_EQ(nearSideEdge(scan, mask, at(12, 16)).cell, nearSideCell(scan, at(12, 16)).cell) << "no edge was clicked";
    mask.cells[at(12, 13)] = 0;
    EXPECT_EQ(nearSideEdge(scan, mask, at(12, 15)).cell, at(11, 13)) << "the nearest, also of another line";
    Grid<std::uint8_t> farther(30, 30);
    farther.cells[at(12, 15)] = 255;
    EXPECT_EQ(nearSideEdge(scan, farther, at(12, 15)).cell, at(12, 14)) << "no edge of the near surface";
}

} // namespace edgescan::inspect
