// The path along the surface and the throat: compared with plain geometry, with a slow version, and with random trials.
#include "core/base/number_text.h"
#include "core/inspect/measure/lengths.h"
#include "core/inspect/measure/notebook.h"
#include "core/inspect/measure/surface_path.h"
#include "core/inspect/measure/throat.h"
#include "core/sim/random.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace edgescan::inspect {
namespace {

constexpr RangeNoise kQuietNoise{0.5, 0.0};

/// Steps of 1/4 degree around the vertical; the range of each cell from its direction.
template <class Range>
Scan fineScan(int lines, int beams, Range rangeM) {
    Scan scan = test::makeScan(lines, beams, [](int, int) { return 1000.0F; });
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = Axis::Sweep;
    for (int j = 0; j < beams; ++j) polar.beamDeg[static_cast<std::size_t>(j)] = 90.0 + (j - beams / 2) / 4.0;
    for (int i = 0; i < lines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = (i - lines / 2) / 4.0;
    const CartesianTables tables(scan);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const double r = rangeM(tables.direction(i, j));
            scan.rangeMm.at(i, j) = static_cast<float>(1000.0 * r);
            if (r <= 0.0) scan.state.at(i, j) = CellState::NoReturn;
        }
    }
    return scan;
}

std::uint32_t cellOf(const Scan& scan, int line, int beam) { return static_cast<std::uint32_t>(scan.rangeMm.index(line, beam)); }

TEST(SurfacePath, OnAFlatWallIsTheDistance) {
    const Scan wall = fineScan(81, 161, [](const Eigen::Vector3d& d) { return 5.0 / d.z(); });
    const CartesianTables tables(wall);
    for (const auto& [from, to] : {std::pair{cellOf(wall, 40, 5), cellOf(wall, 40, 155)}, {cellOf(wall, 3, 7), cellOf(wall, 77, 120)}}) {
        const auto path = surfacePath(wall, tables, kQuietNoise, from, to);
        ASSERT_TRUE(path);
        EXPECT_NEAR(path->lengthM, (tables.point(from) - tables.point(to)).norm(), 0.004);
        EXPECT_EQ(path->leaps, 0);
        EXPECT_GT(path->nodes, 10);
        const auto told = measureCells(wall, kQuietNoise, MeasureKind::Path, std::vector{from, to});
        ASSERT_TRUE(told);
        EXPECT_EQ(told->lengths.front().valueM, path->lengthM);
    }
}

TEST(SurfacePath, FollowsARoof) {
    // Two flat sides that meet above the middle: 1 m up per 1 m across, on each side.
    const auto roof = [](const Eigen::Vector3d& d) { return 6.0 / (d.z() + std::abs(d.x())); };
    const Scan scan = fineScan(41, 161, roof);
    const CartesianTables tables(scan);
    const auto from = cellOf(scan, 20, 30), to = cellOf(scan, 20, 130), top = cellOf(scan, 20, 80);
    const auto path = surfacePath(scan, tables, kQuietNoise, from, to);
    ASSERT_TRUE(path);
    const double sides = (tables.point(from) - tables.point(top)).norm() + (tables.point(top) - tables.point(to)).norm();
    EXPECT_NEAR(path->lengthM, sides, 0.03);
    EXPECT_GT(path->lengthM, path->straightM + 0.2);
}

TEST(SurfacePath, ReportsJumpsAndGaps) {
    Scan step = fineScan(21, 161, [](const Eigen::Vector3d& d) { return (d.x() < 0 ? 5.0 : 6.0) / d.z(); });
    const CartesianTables tables(step);
    const auto from = cellOf(step, 10, 30), to = cellOf(step, 10, 130);
    EXPECT_EQ(surfacePath(step, tables, kQuietNoise, from, to)->leaps, 1);
    const auto measured = measureCells(step, kQuietNoise, MeasureKind::Path, std::vector{from, to});
    EXPECT_NE(measureBasis(*measured).find("jumps that are part of it: 1"), std::string::npos) << measureBasis(*measured);
    for (int j = 40; j < 60; ++j) step.state.at(10, j) = CellState::NoReturn;
    EXPECT_EQ(surfacePath(step, tables, kQuietNoise, from, to)->leaps, 2);
    step.state.at(10, 30) = CellState::NoReturn;
    EXPECT_FALSE(surfacePath(step, tables, kQuietNoise, from, to));
    EXPECT_FALSE(surfacePath(step, tables, kQuietNoise, 999999, to));
}

TEST(SurfacePath, LiesWithinItsToleranceUnderNoise) {
    const RangeNoise noise{6.0, 0.0};
    const Scan wall = fineScan(41, 161, [](const Eigen::Vector3d& d) { return 5.0 / d.z(); });
    const CartesianTables exact(wall);
    int within = 0, all = 0;
    for (std::uint64_t round = 0; round < 300; ++round) {
        Scan noisy = wall;
        for (std::size_t k = 0; k < noisy.cells(); ++k)
            noisy.rangeMm[k] += static_cast<float>(6.0 * sim::normalOf(sim::hashOf(round, sim::Purpose::Noise, k)));
        const CartesianTables tables(noisy);
        const auto from = cellOf(noisy, 20, 10 + static_cast<int>(round % 40)), to = cellOf(noisy, 20, 110 + static_cast<int>(round % 40));
        const auto path = surfacePath(noisy, tables, noise, from, to);
        ASSERT_TRUE(path);
        ++all;
        within += std::abs(path->lengthM - (exact.point(from) - exact.point(to)).norm()) <= path->toleranceM ? 1 : 0;
        EXPECT_LT(path->toleranceM, 0.15);
    }
    EXPECT_GE(within, all * 95 / 100) << within << " of " << all;
}

TEST(Throat, IsBetweenTheNearRimsWhateverRimOfAVoidBehindIsPicked) {
    // A plate at 5 m with a slot from -0.5 to 0.5 m; behind it a wall at 18 m with a void, whose rim is seen through the slot.
    const auto slot = [](const Eigen::Vector3d& d) {
        const double x = 5.0 * d.x() / d.z(), y = 5.0 * d.y() / d.z();
        if (std::abs(x) > 0.5 || std::abs(y) > 0.5) return 5.0 / d.z();
        return std::abs(x) < 0.3 && std::abs(y) < 0.3 ? 0.0 : 18.0 / d.z();
    };
    const Scan scan = fineScan(101, 101, slot);
    const CartesianTables tables(scan);
    const auto behind = [&](int line, int beam) {
        return scan.state.at(line, beam) == CellState::Valid && scan.rangeMm.at(line, beam) > 9000.0F;
    };
    for (int line = 40; line <= 60; line += 5) {
        int left = 0, right = 0; // of the void, on the wall
        for (int beam = 1; beam < 101; ++beam) {
            if (behind(line, beam - 1) && scan.state.at(line, beam) != CellState::Valid) left = beam - 1;
            if (behind(line, beam) && scan.state.at(line, beam - 1) != CellState::Valid) right = beam;
        }
        ASSERT_LT(left, right);
        int near = left;
        while (behind(line, near)) --near;
        for (const int from : {left, near}) {
            const auto found = narrowestBetween(scan, tables, cellOf(scan, line, from), cellOf(scan, line, right));
            ASSERT_TRUE(found) << line;
            for (const std::uint32_t k : *found) EXPECT_LT(scan.rangeMm[k], 6000.0F) << line;
            EXPECT_NEAR((tables.point((*found)[0]) - tables.point((*found)[1])).norm(), 1.0, 0.06) << line;
        }
    }
}

TEST(Throat, IsTheNarrowestPairOfASlowVersion) {
    // A plate at 5 m with an oblique slot, behind it a wall at 9 m.
    const auto slot = [](const Eigen::Vector3d& d) {
        const double x = 5.0 * d.x() / d.z(), y = 5.0 * d.y() / d.z();
        return (x > -0.4 + 0.2 * y && x < 0.5 - 0.15 * y ? 9.0 : 5.0) / d.z();
    };
    for (const bool open : {false, true}) {
        Scan scan = fineScan(61, 101, slot);
        if (open) { // no return through the slot
            const CartesianTables aim(scan);
            for (std::size_t k = 0; k < scan.cells(); ++k) {
                if (scan.rangeMm[k] * static_cast<float>(aim.direction(static_cast<int>(k) / 101, static_cast<int>(k) % 101).z()) > 7000.0F)
                    scan.state[k] = CellState::NoReturn;
            }
        }
        const CartesianTables tables(scan);
        int left = 0, right = 0;
        for (int j = 1; j < 101; ++j) {
            const bool was = scan.state.at(30, j - 1) == CellState::Valid && scan.rangeMm.at(30, j - 1) < 7000.0F;
            const bool is = scan.state.at(30, j) == CellState::Valid && scan.rangeMm.at(30, j) < 7000.0F;
            if (was && !is) left = j - 1;
            if (!was && is) right = j;
        }
        const auto a = cellOf(scan, 30, left - 2), b = cellOf(scan, 30, right + 1);
        const auto found = narrowestBetween(scan, tables, a, b);
        ASSERT_TRUE(found);
        const double told = (tables.point((*found)[0]) - tables.point((*found)[1])).norm();
        const double reach = 0.25 * (tables.point(a) - tables.point(b)).norm();
        double narrowest = 1e9;
        for (std::uint32_t m = 0; m < scan.cells(); ++m) {
            if (!((tables.point(m) - tables.point(a)).norm() <= reach) || scan.rangeMm[m] > 7000.0F) continue;
            for (std::uint32_t n = 0; n < scan.cells(); ++n) {
                if (!((tables.point(n) - tables.point(b)).norm() <= reach) || scan.rangeMm[n] > 7000.0F) continue;
                narrowest = std::min(narrowest, (tables.point(m) - tables.point(n)).norm());
            }
        }
        EXPECT_NEAR(told, narrowest, 1e-9) << open;
        const auto length = measureCells(scan, kQuietNoise, MeasureKind::Throat, *found);
        EXPECT_NEAR(length->lengths.front().valueM, told, 1e-12);
        // Where its ends are is said as seen from the clicks.
        const auto basis = [&](std::uint32_t from, std::uint32_t to) {
            return measureBasis(*measureStored(scan, kQuietNoise, {MeasureKind::Throat, {(*found)[0], (*found)[1]}, {from, to}}));
        };
        double awayM = 0.0; // across the beams
        for (const auto& [end, click] : {std::pair((*found)[0], a), std::pair((*found)[1], b)}) {
            const Eigen::Vector3d to = tables.point(click).normalized() * tables.point(end).norm();
            awayM = std::max(awayM, (tables.point(end) - to).norm());
        }
        EXPECT_NE(basis(a, b).find("its ends are up to " + fixedText(awayM, 2) + " m from the clicks"), std::string::npos) << basis(a, b);
        EXPECT_EQ(basis((*found)[0], (*found)[1]).find("click", 40), std::string::npos) << basis((*found)[0], (*found)[1]);
        const auto one = cellOf(scan, 30, (left + right) / 2 - 3), other = cellOf(scan, 30, (left + right) / 2 + 3); // of the wall behind
        EXPECT_EQ(basis(one, other).find("longer") != std::string::npos, !open) << basis(one, other);
        // A block along the slot blocks every path, and so does a whole wall.
        Scan blocked = scan;
        for (int i = 0; i < 61; ++i) {
            blocked.rangeMm.at(i, (left + right) / 2) = 4000.0F;
            blocked.state.at(i, (left + right) / 2) = CellState::Valid;
        }
        EXPECT_FALSE(narrowestBetween(blocked, CartesianTables(blocked), a, b));
    }
    const Scan wall = fineScan(41, 61, [](const Eigen::Vector3d& d) { return 5.0 / d.z(); });
    EXPECT_FALSE(narrowestBetween(wall, CartesianTables(wall), cellOf(wall, 20, 20), cellOf(wall, 20, 40)));
}

TEST(Throat, IsNotAcrossAHollowOfARock) {
    for (const double deepM : {0.15, 0.6, 4.0}) {
        const auto hollow = [deepM](const Eigen::Vector3d& d) {
            const double x = 5.0 * d.x() / d.z(), y = 5.0 * d.y() / d.z();
            return (5.0 + (std::abs(x) < 0.5 && std::abs(y) < 0.4 ? deepM : 0.0)) / d.z();
        };
        const Scan scan = fineScan(101, 141, hollow);
        int left = 0, right = 0;
        for (int j = 1; j < 141; ++j) {
            const bool was = scan.rangeMm.at(50, j - 1) > 5100.0F, is = scan.rangeMm.at(50, j) > 5100.0F;
            if (!was && is && j < 70) left = j - 1;
            if (was && !is && j > 70) right = j;
        }
        ASSERT_LT(left, right);
        const auto a = cellOf(scan, 50, left - 2), b = cellOf(scan, 50, right + 2);
        const CartesianTables tables(scan);
        EXPECT_EQ(throatAt(scan, tables, a, b).has_value(), deepM > 0.25) << deepM;
        EXPECT_EQ(narrowestBetween(scan, tables, a, b).has_value(), deepM > 0.25) << deepM;
    }
}

// A plate at 5 m with an opening whose half width depends on the height; clicks on the plate next to its sides, `off` cells off each way.
struct Clicked {
    double lengthM;
    std::string basis;
    MeasuredCells measured;
};
std::vector<Clicked> clicksAround(const Scan& scan, int line, int off) {
    const CartesianTables tables(scan);
    int left = 0, right = 0;
    for (int j = 1; j < scan.beams(); ++j) {
        if (scan.rangeMm.at(line, j - 1) < 7000.0F && scan.rangeMm.at(line, j) > 7000.0F) left = j - 1;
        if (scan.rangeMm.at(line, j - 1) > 7000.0F && scan.rangeMm.at(line, j) < 7000.0F) right = j;
    }
    std::vector<Clicked> all;
    for (int a = -off; a <= off; ++a) {
        for (int b = -off; b <= off; ++b) {
            const auto from = cellOf(scan, line + a, left - off), to = cellOf(scan, line + b, right + off);
            const auto ends = narrowestBetween(scan, tables, from, to);
            if (!ends) return {};
            const auto measured = measureStored(scan, kQuietNoise, {MeasureKind::Throat, {(*ends)[0], (*ends)[1]}, {from, to}});
            all.push_back({measured->lengths.front().valueM, measureBasis(*measured), *measured});
        }
    }
    return all;
}

TEST(Throat, SaysWhetherAWayNextToItIsNarrower) {
    const auto opening = [](auto halfWidthM) {
        return fineScan(101, 101, [&](const Eigen::Vector3d& d) {
            return (std::abs(5.0 * d.x() / d.z()) < halfWidthM(5.0 * d.y() / d.z()) ? 9.0 : 5.0) / d.z();
        });
    };
    // Narrowest in the middle: clicks that differ find one length.
    const std::vector<Clicked> waist = clicksAround(opening([](double y) { return 0.3 + 0.8 * std::abs(y); }), 50, 2);
    ASSERT_EQ(waist.size(), 25U);
    for (const Clicked& each : waist) {
        EXPECT_NEAR(each.lengthM, waist.front().lengthM, 1e-9);
        EXPECT_NE(each.basis.find("no narrower way next to it"), std::string::npos) << each.basis;
    }
    // Narrower and narrower along the sides: each click finds another length, and the text says so.
    const Scan narrowing = opening([](double y) { return 0.4 + 0.35 * y; });
    const std::vector<Clicked> wedge = clicksAround(narrowing, 50, 2);
    ASSERT_EQ(wedge.size(), 25U);
    const auto [least, most] = std::ranges::minmax(wedge, {}, &Clicked::lengthM);
    EXPECT_GT(most.lengthM, least.lengthM + 0.01);
    for (const Clicked& each : wedge) {
        const std::string part = "farther along, the throat narrows to ";
        const auto at = each.basis.find(part);
        ASSERT_NE(at, std::string::npos) << each.basis;
        EXPECT_LT(std::stod(each.basis.substr(at + part.size())), each.lengthM);
        // The cells of that way have this length.
        const auto& [first, second] = each.measured.narrowerEnds;
        const auto there = measureStored(narrowing, kQuietNoise, {MeasureKind::Throat, {first, second}});
        ASSERT_TRUE(there);
        EXPECT_NEAR(there->lengths.front().valueM, each.measured.narrowerM, 1e-9);
    }
}

// A click on a surface seen through the opening still finds a throat, but not without a warning; nor do two ends of different depth.
TEST(Throat, WarnsOfAClickBehindItAndOfEndsOfDifferentDepth) {
    const auto measured = [](double rightM, bool behind) {
        const Scan scan = fineScan(101, 101, [&](const Eigen::Vector3d& d) {
            const double x = 5.0 * d.x() / d.z();
            return (x < -0.4 ? 5.0 : x < 0.4 ? 9.0 : rightM) / d.z();
        });
        int left = 0, right = 0;
        for (int j = 1; j < 101; ++j) {
            if (scan.rangeMm.at(50, j - 1) < 7000.0F && scan.rangeMm.at(50, j) > 7000.0F) left = j - 1;
            if (scan.rangeMm.at(50, j - 1) > 7000.0F && scan.rangeMm.at(50, j) < 7000.0F) right = j;
        }
        const auto from = cellOf(scan, 50, behind ? left + 6 : left - 2), to = cellOf(scan, 50, right + 2);
        const auto throat = throatAt(scan, CartesianTables(scan), from, to);
        EXPECT_TRUE(throat);
        return *measureStored(scan, kQuietNoise, {MeasureKind::Throat, {throat->ends[0], throat->ends[1]}, {from, to}});
    };
    const MeasuredCells onRock = measured(5.0, false), through = measured(5.0, true), oblique = measured(5.6, false);
    EXPECT_FALSE(onRock.isWarned()) << measureBasis(onRock);
    EXPECT_NEAR(through.clickBehindM, 4.0, 0.2);
    EXPECT_TRUE(through.isWarned());
    EXPECT_NE(measureBasis(through).find("m behind it: the rim in front was taken"), std::string::npos) << measureBasis(through);
    EXPECT_NEAR(oblique.endsApartM(), 0.6, 0.1);
    EXPECT_TRUE(oblique.isWarned());
    EXPECT_NE(measureBasis(oblique).find("farther away than the other"), std::string::npos) << measureBasis(oblique);
}

// A hole in a wall: the surface that is seen through it is behind the wall in all directions. A wall next to a nearer one is not.
TEST(Throat, KnowsWhatIsSeenThroughAnOpening) {
    const auto hole = test::makeScan(80, 80, [](int i, int j) { return std::hypot(i - 40, j - 40) < 12 ? 18000.0 : 5000.0; });
    const auto cell = [](int line, int beam) { return static_cast<std::uint32_t>(80 * line + beam); };
    EXPECT_NEAR(seenThroughM(hole, cell(40, 40)), 13.0, 1e-9);
    EXPECT_NEAR(seenThroughM(hole, cell(31, 36)), 13.0, 1e-9);
    EXPECT_EQ(seenThroughM(hole, cell(20, 40)), 0.0);
    EXPECT_EQ(seenThroughM(hole, cell(0, 0)), 0.0);
    const auto step = test::makeScan(80, 80, [](int, int j) { return j < 40 ? 18000.0 : 5000.0; });
    EXPECT_EQ(seenThroughM(step, cell(40, 38)), 0.0);
    // A pit at the border of the scan, which has rock at three sides.
    const auto pit = test::makeScan(80, 80, [](int i, int j) { return i > 70 && std::abs(j - 40) < 6 ? 9000.0 : 5000.0; });
    EXPECT_EQ(seenThroughM(pit, cell(79, 40)), 0.0);
    auto none = hole;
    none.state[cell(40, 40)] = CellState::NoReturn;
    EXPECT_EQ(seenThroughM(none, cell(40, 40)), 0.0);
}

TEST(Throat, ItsToleranceIncludesWhatClicksNextToItFind) {
    // Narrower and narrower along the sides, so that each click finds another length.
    const Scan scan = fineScan(101, 101, [](const Eigen::Vector3d& d) {
        return (std::abs(5.0 * d.x() / d.z()) < 0.4 + 0.35 * 5.0 * d.y() / d.z() ? 9.0 : 5.0) / d.z();
    });
    const CartesianTables tables(scan);
    int left = 0, right = 0;
    for (int j = 1; j < 101; ++j) {
        if (scan.rangeMm.at(50, j - 1) < 7000.0F && scan.rangeMm.at(50, j) > 7000.0F) left = j - 1;
        if (scan.rangeMm.at(50, j - 1) > 7000.0F && scan.rangeMm.at(50, j) < 7000.0F) right = j;
    }
    const auto lengthM = [&](const std::array<std::uint32_t, 2>& ends) { return (tables.point(ends[0]) - tables.point(ends[1])).norm(); };
    const auto from = cellOf(scan, 50, left - 3), to = cellOf(scan, 50, right + 3);
    const auto throat = throatAt(scan, tables, from, to);
    ASSERT_TRUE(throat);
    const auto measured = measureStored(scan, kQuietNoise, {MeasureKind::Throat, {throat->ends[0], throat->ends[1]}, {from, to}});
    ASSERT_TRUE(measured);
    const MeasuredLength& length = measured->lengths.front();
    std::vector<double> foundM;
    constexpr std::array<std::pair<int, int>, 5> kMoves{{{0, 0}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}}};
    for (const auto& [di, dj] : kMoves) {
        for (const auto& [ei, ej] : kMoves) {
            const auto ends = narrowestBetween(scan, tables, cellOf(scan, 50 + di, left - 3 + dj), cellOf(scan, 50 + ei, right + 3 + ej));
            ASSERT_TRUE(ends);
            EXPECT_LE(std::abs(lengthM(*ends) - length.valueM), length.toleranceM) << di << " " << dj << " " << ei << " " << ej;
            foundM.push_back(lengthM(*ends));
        }
    }
    std::ranges::sort(foundM);
    const double leastM = foundM.front(), mostM = foundM.back();
    EXPECT_DOUBLE_EQ(length.valueM, foundM[foundM.size() / 2]);
    EXPECT_GT(mostM, leastM + 0.01);
    EXPECT_DOUBLE_EQ(throat->leastM, leastM);
    EXPECT_DOUBLE_EQ(throat->mostM, mostM);
    EXPECT_NE(measureBasis(*measured).find(" mm away find " + fixedText(leastM, 3) + " to " + fixedText(mostM, 3) + " m"),
              std::string::npos)
        << measureBasis(*measured);
    // The same clicks without the list of clicks: the ends are the clicks.
    const auto bare = measureStored(scan, kQuietNoise, {MeasureKind::Throat, {from, to}, {}});
    EXPECT_DOUBLE_EQ(bare->mostM, mostM);
    // A hole without a range on both sides has no throat.
    Scan empty = scan;
    for (std::size_t k = 0; k < empty.cells(); ++k) empty.state[k] = CellState::NoReturn;
    EXPECT_FALSE(throatAt(empty, CartesianTables(empty), from, to));
    EXPECT_FALSE(throatAt(scan, tables, from, static_cast<std::uint32_t>(scan.cells())));
}

} // namespace
} // namespace edgescan::inspect
