// The rim of open voids, as distinguished from drop-outs, filters, lost lines and surfaces that fade out.
#include "core/edges/edgescan_plus/void_rim.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/rocks/attributes/study.h"
#include "core/rocks/segmentation/inputs.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <set>

namespace edgescan::edges {
namespace {

constexpr int kWallLines = 90, kWallBeams = 120;

using IsOpen = std::function<bool(int, int)>;

Scan wallWith(const IsOpen& isOpen) {
    const PolarGeometry polar = test::regularAngles(kWallLines, kWallBeams);
    return test::makeScan(kWallLines, kWallBeams,
                          [&](int i, int j) { return isOpen(i, j) ? 0.0 : test::wallRangeMm(polar, i, j, 5000.0); });
}

// Without noise a slanted surface may look like the depth steps of a camera.
std::vector<std::uint32_t> rimOf(const Scan& scan, NoiseKind kind = NoiseKind::Laser) {
    Settings settings;
    settings.noiseKind = kind;
    return detectEdges(std::make_shared<const Scan>(scan), settings)->responses->rim;
}

// The same by looking at each cell, without runs: measured cells that share a side with a void of 30 cells.
std::set<std::uint32_t> slowRim(const Scan& scan) {
    const InverseRange inverse = inverseRange(scan);
    const auto isVoid = [&](int i, int j) { return inverse.support.contains(i, j) && inverse.support.at(i, j) == Support::Void; };
    Grid<std::uint8_t> seen(scan.lines(), scan.beams());
    std::set<std::uint32_t> rim;
    for (int line = 0; line < scan.lines(); ++line) {
        for (int beam = 0; beam < scan.beams(); ++beam) {
            if (!isVoid(line, beam) || seen.at(line, beam) != 0) continue;
            std::vector<std::pair<int, int>> cells{{line, beam}};
            seen.at(line, beam) = 1;
            std::set<std::uint32_t> around;
            for (std::size_t n = 0; n < cells.size(); ++n) {
                const auto [i, j] = cells[n];
                for (const auto& [i2, j2] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
                    if (isVoid(i2, j2) && seen.at(i2, j2) == 0) {
                        seen.at(i2, j2) = 1;
                        cells.emplace_back(i2, j2);
                    } else if (inverse.support.contains(i2, j2) && inverse.isMeasured(i2, j2)) {
                        around.insert(static_cast<std::uint32_t>(scan.rangeMm.index(i2, j2)));
                    }
                }
            }
            if (cells.size() >= 30) rim.merge(around);
        }
    }
    return rim;
}

TEST(VoidRim, IsWhatSharesASideWithAVoidOfThirtyCells) {
    const std::vector<IsOpen> shapes{
        [](int i, int j) { return (i - 40) * (i - 40) + (j - 60) * (j - 60) < 300; },
        [](int i, int j) { return j >= 100 || i >= 80; },
        [](int i, int j) { return (i / 9 + j / 9) % 2 == 0; },                              // touching at corners only
        [](int i, int j) { return (i % 12 < 6 && j % 30 < 25) || (j % 30 < 6 && i > 20); }, // combs
        [](int, int) { return true; },
        [](int, int) { return false; },
    };
    for (std::size_t n = 0; n < shapes.size(); ++n) {
        const Scan scan = wallWith(shapes[n]);
        const auto rim = rimOf(scan);
        EXPECT_TRUE(std::ranges::is_sorted(rim)) << n;
        EXPECT_EQ(std::set<std::uint32_t>(rim.begin(), rim.end()), slowRim(scan)) << n;
    }
}

TEST(VoidRim, AGapBelowThirtyCellsHasNone) {
    const auto hole = [](int cells) {
        return wallWith([cells](int i, int j) { return i >= 40 && i < 45 && j >= 50 && (i - 40) + 5 * (j - 50) < cells; });
    };
    EXPECT_TRUE(rimOf(hole(29)).empty());
    EXPECT_FALSE(rimOf(hole(30)).empty());
    EXPECT_TRUE(detectEdges(std::make_shared<const Scan>(hole(29)), Settings{})->edges->empty());
}

TEST(VoidRim, LostLinesAndFiltersHaveNone) {
    for (const CellState state : {CellState::Lost, CellState::Masked, CellState::OutOfWindow}) {
        Scan scan = wallWith([](int i, int) { return i >= 40 && i < 50; });
        for (CellState& cell : scan.state.cells) cell = cell == CellState::NoReturn ? state : cell;
        EXPECT_TRUE(rimOf(scan).empty()) << cellStateName(state);
    }
}

// A floor that slants away along the beams until nothing comes back.
TEST(VoidRim, ASurfaceThatFadesOutHasNone) {
    const auto floor = [](double slantDeg) {
        const double slant = std::tan(slantDeg * std::numbers::pi / 180), step = 0.25 * std::numbers::pi / 180;
        return test::makeScan(kWallLines, kWallBeams,
                              [=](int, int j) { return j >= 60 ? 0.0 : 3000.0 * std::exp(slant * step * (j - 30)); });
    };
    EXPECT_EQ(rimOf(floor(60)).size(), static_cast<std::size_t>(kWallLines));
    EXPECT_EQ(rimOf(floor(75)).size(), static_cast<std::size_t>(kWallLines));
    EXPECT_TRUE(rimOf(floor(84)).empty());
}

// A box in front of a wall: missing points next to it, which a depth camera has as a shadow, a hole in the wall, and the wall's end.
TEST(VoidRim, OfADepthCameraIsTheNearSideOfAVoid) {
    const auto isBox = [](int i, int j) { return i >= 30 && i < 60 && j >= 20 && j < 40; };
    const auto isShadow = [](int i, int j) { return i >= 30 && i < 60 && j >= 40 && j < 46; };
    const auto isHole = [](int i, int j) { return i >= 10 && i < 20 && j >= 60 && j < 70; };
    const PolarGeometry polar = test::regularAngles(kWallLines, kWallBeams);
    const Scan scan = test::makeScan(kWallLines, kWallBeams, [&](int i, int j) {
        if (isShadow(i, j) || isHole(i, j) || j >= 100) return 0.0;
        return test::wallRangeMm(polar, i, j, isBox(i, j) ? 4000.0 : 5000.0);
    });
    const auto rim = rimOf(scan, NoiseKind::Camera);
    ASSERT_EQ(rim.size(), 30U);
    for (const std::uint32_t k : rim) EXPECT_EQ(static_cast<int>(k) % kWallBeams, 39) << k;
    const auto all = rimOf(scan);
    EXPECT_EQ(all.size(), 30U + 30 + 2 * 6 + 4 * 10 + static_cast<std::size_t>(kWallLines));
}

TEST(VoidRim, RocksAreTheSameWithAndWithoutIt) {
    const auto wall = std::make_shared<const Scan>(wallWith([](int i, int j) { return i >= 20 && i < 50 && j >= 40 && j < 90; }));
    Settings without;
    without.classes &= ~kClassVoidRim;
    const auto with = detectEdges(wall, Settings{}, KeepFor::Rocks), none = detectEdges(wall, without, KeepFor::Rocks);
    EXPECT_GT(with->edges->size(), none->edges->size() + 100);
    const auto rocksOf = [](const Detection& detection) {
        const rocks::Study study = rocks::studyRocks(rocks::rockInputs(detection), {});
        return rocks::rockLabels(*study.segmentation, study.map);
    };
    EXPECT_EQ(rocksOf(*with), rocksOf(*none));
}

} // namespace
} // namespace edgescan::edges
