// The path along the surface and the throat: compared with plain geometry, with a slow version, and with random trials.
#include "app/lab/sim/random.h"
#include "core/base/number_text.h"
#include "core/inspect/measure/lengths.h"
#include "core/inspect/measure/notebook.h"
#include "core/inspect/measure/surface_path.h"
#include "core/inspect/measure/throat.h"
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
        EXPECT_EQ(basis((*found)[0], (*found)[1]).find("from the clicks"), std::string::npos) << basis((*found)[0], (*found)[1]);
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

TEST(Throat, ItsWaistIsFoundFromAnyClickAtItsSides) {
    const Scan waisted = fineScan(101, 101, [](const Eigen::Vector3d& d) {
        return (std::abs(5.0 * d.x() / d.z()) < 0.3 + 0.8 * std::abs(5.0 * d.y() / d.z()) ? 9.0 : 5.0) / d.z();
    });
    const std::vector<Clicked> waist = clicksAround(waisted, 50, 2);
    ASSERT_EQ(waist.size(), 25U);
    for (const Clicked& each : waist) EXPECT_NEAR(each.lengthM, waist.front().lengthM, 1e-9) << each.basis;
}

// A few lost beams of a rock are not a side of an opening.
TEST(Throat, ItsSidesAreNotLostBeamsOfARock) {
    Scan scan = fineScan(101, 101, [](const Eigen::Vector3d& d) { return (std::abs(5.0 * d.x() / d.z()) < 0.4 ? 9.0 : 5.0) / d.z(); });
    const std::vector<Clicked> whole = clicksAround(scan, 50, 2);
    int left = 0;
    for (int j = 1; j < 101; ++j) {
        if (scan.rangeMm.at(50, j - 1) < 7000.0F && scan.rangeMm.at(50, j) > 7000.0F) left = j - 1;
    }
    for (int i = 44; i < 57; i += 2) scan.state.at(i, left - 4) = CellState::NoReturn;
    const std::vector<Clicked> lost = clicksAround(scan, 50, 2);
    ASSERT_EQ(lost.size(), whole.size());
    for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_EQ(lost[n].lengthM, whole[n].lengthM);
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

// One click into an opening measures the width at that place, whether the beam went through it to a wall or measured nothing.
TEST(Throat, OneClickIntoTheOpeningMeasuresItThere) {
    for (const double behindM : {9.0, 0.0}) {
        const auto withHole = [&](const auto& isHole) {
            return fineScan(121, 121, [&](const Eigen::Vector3d& d) {
                const double x = 5.0 * d.x() / d.z(), y = 5.0 * d.y() / d.z();
                return (isHole(x, y) ? behindM : 5.0) / d.z();
            });
        };
        const auto widthAt = [](const Scan& scan, int line, int beam) {
            const std::uint32_t click = cellOf(scan, line, beam);
            const auto throat = throatThrough(scan, CartesianTables(scan), click);
            EXPECT_TRUE(throat) << line << " " << beam;
            if (!throat) return MeasuredCells{};
            const StoredMeasure stored{MeasureKind::Throat, {throat->ends.begin(), throat->ends.end()}, {click, click}};
            EXPECT_TRUE(stored.isByOneClick());
            return *measureStored(scan, kQuietNoise, stored);
        };
        const Scan round = withHole([](double x, double y) { return std::hypot(x, y) < 0.5; });
        const MeasuredCells middle = widthAt(round, 60, 60);
        EXPECT_NEAR(middle.lengths.front().valueM, 1.0, 0.06);
        EXPECT_EQ(middle.clickBehindM, 0.0);
        EXPECT_EQ(middle.isDark, behindM == 0.0);
        // Any click into it measures its middle.
        for (const auto& [line, beam] : {std::pair{60, 72}, {48, 60}, {70, 50}, {52, 53}})
            EXPECT_NEAR(widthAt(round, line, beam).lengths.front().valueM, middle.lengths.front().valueM, 0.03) << line << " " << beam;
        // A slot is as wide as its sides are apart, wherever it was clicked; its ends do not count.
        const Scan slot = withHole([](double x, double y) { return std::abs(x) < 0.3 && std::abs(y) < 0.9; });
        for (const auto& [line, beam] : {std::pair{60, 60}, {60, 50}, {45, 66}, {75, 60}}) {
            const MeasuredCells across = widthAt(slot, line, beam);
            EXPECT_NEAR(across.lengths.front().valueM, 0.6, 0.06) << line << " " << beam << " " << measureBasis(across);
            EXPECT_LE(across.mostM, 0.7);
        }
        // Two clicks mean the same opening, however far from it and in whatever direction they are.
        const auto widthBetween = [](const Scan& scan, const std::array<int, 2>& one, const std::array<int, 2>& other) {
            const auto throat = throatAt(scan, CartesianTables(scan), cellOf(scan, one[0], one[1]), cellOf(scan, other[0], other[1]));
            EXPECT_TRUE(throat) << one[0] << " " << one[1];
            return throat ? std::array{throat->leastM, throat->mostM} : std::array{0.0, 0.0};
        };
        for (const auto& [one, other] : {std::pair{std::array{60, 20}, std::array{60, 100}}, {{8, 60}, {113, 60}}, {{30, 25}, {95, 100}}}) {
            EXPECT_NEAR(widthBetween(round, one, other)[0], 1.0, 0.06) << one[0];
            if (one[1] != other[1]) EXPECT_NEAR(widthBetween(slot, one, other)[1], 0.6, 0.06) << one[0]; // else along the slot
        }
        // The first end is at the side of the first click.
        const auto endBeam = [&](int first, int second) {
            const auto throat = throatAt(slot, CartesianTables(slot), cellOf(slot, 60, first), cellOf(slot, 60, second));
            return throat ? static_cast<int>(throat->ends[0]) % slot.beams() : -1;
        };
        EXPECT_LT(endBeam(20, 100), 60);
        EXPECT_GT(endBeam(100, 20), 60);
        // Its remark says whether it is between the sides that were clicked.
        const Scan oval = withHole([](double x, double y) { return std::hypot(x / 0.4, y / 0.55) < 1.0; });
        const auto remarkOf = [&](const std::array<int, 2>& one, const std::array<int, 2>& other) {
            const std::uint32_t a = cellOf(oval, one[0], one[1]), b = cellOf(oval, other[0], other[1]);
            const auto throat = throatAt(oval, CartesianTables(oval), a, b);
            EXPECT_TRUE(throat);
            if (!throat) return std::string();
            return measureBasis(
                *measureStored(oval, kQuietNoise, {MeasureKind::Throat, {throat->ends.begin(), throat->ends.end()}, {a, b}}));
        };
        const std::string sides = remarkOf({60, 20}, {60, 100}), turned = remarkOf({8, 60}, {113, 60});
        EXPECT_NE(sides.find("between the two sides that were clicked"), sides.npos) << sides;
        EXPECT_EQ(turned.find("between the two sides"), turned.npos) << turned;
        EXPECT_NE(turned.find("across the opening between the clicks, turned by "), turned.npos) << turned;
        // A void in the wall behind it means the opening in front of that wall.
        const Scan nested = fineScan(121, 121, [](const Eigen::Vector3d& d) {
            const double x = 5.0 * d.x() / d.z(), y = 5.0 * d.y() / d.z();
            return std::hypot(x, y) > 0.5 ? 5.0 / d.z() : std::hypot(x + 0.1, y) < 0.25 ? 0.0 : 18.0 / d.z();
        });
        for (const auto& [line, beam] : {std::pair{60, 60}, {60, 54}, {60, 75}})
            EXPECT_NEAR(widthAt(nested, line, beam).lengths.front().valueM, 1.0, 0.06) << line << " " << beam;
        // Two openings with a narrow place between them: each click measures its own.
        const Scan two = withHole([](double x, double y) {
            return std::hypot(x - 0.5, y) < 0.4 || std::hypot(x + 0.45, y) < 0.3 || (std::abs(x) < 0.3 && std::abs(y) < 0.08);
        });
        const auto around = [&](double x) {
            return widthAt(two, 60, 60 + static_cast<int>(std::lround(std::atan(x / 5.0) * 4.0 * 57.2958)));
        };
        const double one = around(0.5).lengths.front().valueM, other = around(-0.45).lengths.front().valueM;
        EXPECT_NEAR(std::max(one, other), 0.8, 0.06);
        EXPECT_NEAR(std::min(one, other), 0.6, 0.06);
        // Not a click on the wall next to it, nor one into a hollow that is less deep than wide, nor on a few lost beams of a surface.
        EXPECT_FALSE(throatThrough(slot, CartesianTables(slot), cellOf(slot, 60, 20)));
    }
    const auto through = [](const Scan& scan) { return throatThrough(scan, CartesianTables(scan), cellOf(scan, 60, 60)).has_value(); };
    for (const double deepM : {0.5, 2.0}) {
        const Scan hollow = fineScan(
            121, 121, [&](const Eigen::Vector3d& d) { return (std::hypot(d.x(), d.y()) < 0.1 * d.z() ? 5.0 + deepM : 5.0) / d.z(); });
        EXPECT_EQ(through(hollow), deepM > 1.0) << deepM;
    }
    Scan dropouts = fineScan(121, 121, [](const Eigen::Vector3d& d) { return 5.0 / d.z(); });
    for (int i = 57; i < 64; ++i) {
        for (int j = 57; j < 64; ++j) dropouts.state.at(i, j) = CellState::NoReturn;
    }
    EXPECT_FALSE(through(dropouts));
    EXPECT_FALSE(throatThrough(dropouts, CartesianTables(dropouts), static_cast<std::uint32_t>(dropouts.cells())));
    // Nor on one of a face between two nearer rocks, nor next to it.
    Scan face = fineScan(121, 121, [](const Eigen::Vector3d& d) { return (std::abs(d.x()) > 0.15 * d.z() ? 4.3 : 5.0) / d.z(); });
    for (const int side : {1, 3}) {
        for (int i = 60; i < 60 + side; ++i) {
            for (int j = 60; j < 60 + side; ++j) face.state.at(i, j) = CellState::NoReturn;
        }
        EXPECT_FALSE(through(face)) << side;
        EXPECT_FALSE(openingOfClick(face, CartesianTables(face), exactly(cellOf(face, 60, 58)))) << side;
    }
}

// An uneven opening before a slanting wall with a void in it: a click far from the middle sees other sides and another wall.
TEST(Throat, ClicksInOneOpeningFindAboutTheSame) {
    const Scan scan = fineScan(121, 121, [](const Eigen::Vector3d& d) {
        const double x = 5.0 * d.x() / d.z(), y = 5.0 * d.y() / d.z();
        const bool isHole = y > -0.45 + 0.25 * x && y < 0.4 - 0.3 * x && x > -0.6 - 0.2 * y && x < 0.55;
        if (!isHole) return (5.0 + 0.5 * x + 0.3 * y) / d.z();
        return std::hypot(x - 0.2, y - 0.1) < 0.12 ? 0.0 : (9.0 + 6.0 * x) / d.z();
    });
    const CartesianTables tables(scan);
    std::vector<double> lengthsM;
    for (int i = 44; i <= 76; i += 4) {
        for (int j = 44; j <= 76; j += 4) {
            const auto into = openingOfClick(scan, tables, nearSideCell(scan, cellOf(scan, i, j)));
            const auto throat = into ? throatThrough(scan, tables, *into) : std::nullopt;
            if (throat) lengthsM.push_back((tables.point(throat->ends[0]) - tables.point(throat->ends[1])).norm());
        }
    }
    ASSERT_GT(lengthsM.size(), 40U);
    std::ranges::sort(lengthsM);
    EXPECT_LT(lengthsM.back(), 1.08 * lengthsM.front()); // 1.18 from the first middles
}

// A view of points has no cell in a void: a click on it finds the rim.
TEST(Throat, AClickAtTheRimOfAVoidMeansTheVoid) {
    const Scan scan =
        fineScan(121, 121, [](const Eigen::Vector3d& d) { return std::hypot(d.x(), d.y()) < 0.06 * d.z() ? 0.0 : 5.0 / d.z(); });
    const CartesianTables tables(scan);
    const auto at = [&](int beam) { return openingOfClick(scan, tables, exactly(cellOf(scan, 60, beam))); };
    int rim = 60;
    while (scan.state.at(60, rim) != CellState::Valid) ++rim;
    ASSERT_GT(rim, 65);
    EXPECT_EQ(at(60), cellOf(scan, 60, 60));
    for (const int beam : {rim, rim + kSnapReach - 1}) {
        const auto into = at(beam);
        ASSERT_TRUE(into) << beam;
        const auto throat = throatThrough(scan, tables, *into);
        ASSERT_TRUE(throat) << beam;
        EXPECT_NEAR((tables.point(throat->ends[0]) - tables.point(throat->ends[1])).norm(), 0.6, 0.06) << beam;
    }
    EXPECT_FALSE(at(rim + kSnapReach)) << "the rock at the side";
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
