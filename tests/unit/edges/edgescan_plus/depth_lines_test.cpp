// The stages of EdgeScan+ line by line, compared with the same stages, and with simpler ones, on the whole sweep.
#include "core/base/order_statistic.h"
#include "core/edges/edgescan_plus/jump.h"
#include "core/edges/edgescan_plus/mixed_pixels.h"
#include "core/edges/edgescan_plus/surface_lines.h"
#include "core/scan/grid/missing_cells.h"
#include "tests/support/depth_edges.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

namespace edgescan::edges {
namespace {

// The mean range of a cell and of those on the next beams, as a wide spot has it; 0 if one of them is missing.
float blurred(const Scan& scan, int i, int j, int cells) {
    float sum = 0;
    for (int n = j; n < std::min(j + cells, scan.beams()); ++n) {
        if (scan.rangeMm.at(i, n) <= 0) return 0;
        sum += scan.rangeMm.at(i, n);
    }
    return sum / static_cast<float>(std::min(cells, scan.beams() - j));
}

// Boxes, slanted and rough surfaces, mixed pixels and holes, in sizes near those of the blocks in the loops.
Scan randomScan(std::mt19937& random) {
    constexpr std::array<int, 12> kSizes{1, 2, 3, 5, 8, 17, 31, 33, 48, 64, 70, 101};
    const int lines = kSizes[random() % kSizes.size()];
    const int beams = kSizes[random() % kSizes.size()];
    const double dropouts = std::array<double, 4>{0.0, 0.02, 0.2, 0.7}[random() % 4];
    const Scan boxes = test::boxesScan(lines, beams, static_cast<unsigned>(random()), dropouts);
    const double slant = static_cast<double>(random() % 400) * 0.01;
    // The spot of the beam covers many cells at small distances.
    const int spot = std::array<int, 4>{1, 1, 4, 6}[random() % 4];
    const double scale = std::array<double, 3>{1.0, 0.3, 0.1}[random() % 3];
    return test::makeScan(lines, beams, [&](int i, int j) {
        const float range = blurred(boxes, i, j, spot);
        const bool mixed = range > 0 && random() % 40 == 0;
        return range > 0 ? scale * (range * (mixed ? 0.8 : 1.0) + slant * (30 * i + 20 * j)) : 0.0;
    });
}

bool sameBits(const float* a, const float* b, int count) { return std::memcmp(a, b, static_cast<std::size_t>(count) * sizeof(float)) == 0; }

// A window that holds a whole sweep and its margin.
Lines wholeSweep(const Grid<float>& values, float margin, int firstLine = 0) {
    return {values.beams, values.lines + 4 * Lines::kMargin, margin, firstLine};
}
template <class Window>
void addMargin(Window& lines) {
    for (int i = 0; i < 2 * Lines::kMargin; ++i) lines.nextEmpty();
}
Lines wholeSweepOf(const Grid<float>& values, float margin) {
    Lines lines = wholeSweep(values, margin);
    for (int i = 0; i < values.lines; ++i) std::copy(values.line(i), values.line(i) + values.beams, lines.next());
    addMargin(lines);
    return lines;
}

Grid<float> solidOf(const InverseRange& inverse) {
    Grid<float> solid(inverse.u.lines, inverse.u.beams);
    for (std::size_t k = 0; k < solid.size(); ++k) solid[k] = inverse.support[k] == Support::Void ? 0.0F : 1.0F;
    return solid;
}

// docs/method/edges.md, "Step 2" cell by cell, as mixed_pixels.h describes it.
struct PlainVeil {
    const Lines& u;
    const Lines& solid;
    std::ptrdiff_t step;
    const DepthLimits& limits;
    const float* at = nullptr;
    const float* there = nullptr;
    int longRuns = 0; // that were snapped

    [[nodiscard]] float value(int n) const { return at[n * step]; }
    [[nodiscard]] bool solids(int from, int to) const {
        bool all = true;
        for (int n = from; n <= to; ++n) all = all && there[n * step] != 0;
        return all;
    }
    static float gap(float a, float b) { return std::abs(1000.0F / a - 1000.0F / b); }
    static bool between(float u, float a, float b) { return a > 0 && b > 0 && u > std::min(a, b) && u < std::max(a, b); }

    [[nodiscard]] bool worthwhile() const {
        const float apart = 0.001F * thresholdsApart() * limits.jumpMm;
        const auto areApart = [&](float a, float b) { return std::abs(a - b) > apart * a * b; };
        const float bend = std::abs(value(-2) - 2 * value(-1) + value(0)) + std::abs(value(1) - 2 * value(0) + value(-1));
        const bool bent = bend > 0.25F * apart * value(0) * value(0);
        return areApart(2 * value(-1) - value(-2), 2 * value(1) - value(2)) || (bent && areApart(value(-1), value(2)));
    }
    [[nodiscard]] bool one(float& result) const {
        const float before = 2 * value(-1) - value(-2);
        const float after = 2 * value(1) - value(2);
        if (!solids(-2, 2) || !between(value(0), before, after)) return false;
        const float allowed = limits.jumpAt(1000.0F / value(0));
        if (gap(before, value(0)) <= allowed || gap(after, value(0)) <= allowed) return false;
        result = gap(before, value(0)) < gap(after, value(0)) ? before : after;
        return true;
    }
    [[nodiscard]] float thresholdsApart() const { return limits.spotGrows ? 1.6F : 2.0F; }
    [[nodiscard]] float slope(int end, int sign, int run) const {
        const auto v = [&](int n) { return value(end + n * sign); };
        const bool five = there[(end + 2 * sign) * step] != 0 && there[(end + 3 * sign) * step] != 0 && there[(end + 4 * sign) * step] != 0;
        if (run > 3 && five) return 0.1F * (2 * (v(4) - v(0)) + v(3) - v(1));
        return there[(end + 2 * sign) * step] != 0 ? 0.5F * (value(end + 2 * sign) - value(end)) : value(end + sign) - value(end);
    }
    [[nodiscard]] bool run(int count, std::vector<float>& result) const {
        if (!solids(-2, count + 1)) return false;
        float farthest = 0;
        result.clear();
        for (int n = 0; n < count; ++n) {
            const float before = value(-1) - static_cast<float>(n + 1) * slope(-1, -1, count);
            const float after = value(count) - static_cast<float>(count - n) * slope(count, 1, count);
            if (!between(value(n), before, after)) return false;
            const float allowed = limits.jumpAt(1000.0F / std::max(before, after));
            if (std::min(gap(before, after), gap(value(-1), value(count))) < thresholdsApart() * allowed) return false;
            const float toBefore = gap(before, value(n));
            const float toAfter = gap(after, value(n));
            farthest = std::max(farthest, std::min(toBefore, toAfter) / allowed);
            result.push_back(toBefore <= toAfter ? before : after);
        }
        return farthest >= 0.5F;
    }
    int snapLine(int line, const float* angle, Lines& snapped) {
        int count = 0;
        for (int j = 0; j < u.beams; ++j) {
            at = u.line(line) + j;
            there = solid.line(line) + j;
            float* out = snapped.line(line) + j;
            if (*there == 0) continue;
            const bool isShort = worthwhile();
            if (isShort && one(*out)) {
                ++count;
                continue;
            }
            std::vector<float> values;
            const float rangeM = 1.0F / value(0);
            const float cell = rangeM * angle[j];
            const float spot = 0.013F + 0.0046F * rangeM;
            for (int cells = isShort ? 2 : 3; cells <= (limits.spotGrows ? kLongestRun : 2) && static_cast<float>(cells) * cell <= spot;
                 ++cells) {
                if ((cells > 2 && static_cast<float>(cells) * cell < 0.5F * spot) || !run(cells, values)) continue;
                for (int n = 0; n < cells; ++n) out[n * step] = values[static_cast<std::size_t>(n)];
                count += cells;
                longRuns += cells > 2 ? 1 : 0;
                break;
            }
        }
        return count;
    }
};

DepthLimits randomLimits(std::mt19937& random) {
    DepthLimits limits;
    limits.jumpMm = std::array<float, 4>{0.0F, 5.0F, 30.0F, 200.0F}[random() % 4];
    limits.growth = random() % 3 == 0 ? 0.0F : 0.01F;
    limits.noisy = static_cast<float>(random() % 3) / 2;
    limits.passes = 1 + static_cast<int>(random() % 2);
    limits.windowMm = static_cast<float>(20 + random() % 200);
    limits.noise = {4.0, 0.2};
    limits.spotGrows = random() % 3 != 0;
    return limits;
}

TEST(DepthLines, MixedPixelsSnapAsCellByCell) {
    std::mt19937 random(31);
    int snaps = 0, longRuns = 0;
    for (int round = 0; round < 300; ++round) {
        const Scan scan = randomScan(random);
        const InverseRange inverse = inverseRange(scan);
        const AngularSteps steps = angularSteps(scan);
        const DepthLimits limits = randomLimits(random);
        const Lines u = wholeSweepOf(inverse.u, 1.0F);
        const Lines solid = wholeSweepOf(solidOf(inverse), 0.0F);
        for (const Along along : {Along::Beams, Along::Lines}) {
            Lines snapped = u;
            Lines expected = u;
            std::vector<float> room;
            PlainVeil plain{u, solid, stepOf(u, along), limits};
            for (int i = 0; i < scan.lines(); ++i) {
                const float* angle = anglesOf(steps, along, i, room);
                snapMixedPixels({u, solid}, along, i, angle, limits, snapped);
                snaps += plain.snapLine(i, angle, expected);
            }
            longRuns += plain.longRuns;
            for (int i = 0; i < scan.lines(); ++i) ASSERT_TRUE(sameBits(snapped.line(i), expected.line(i), scan.beams())) << round;
        }
    }
    EXPECT_GT(snaps, 300);
    EXPECT_GT(longRuns, 100);
}

// Every stage on the whole sweep before the next one begins.
struct WholeSweep {
    std::vector<std::vector<float>> jumpBeams, jumpLines, foldBeams, foldLines;

    WholeSweep(const InverseRange& inverse, const AngularSteps& steps, const SweepSlips& slips, const DepthLimits& limits) {
        const int lines = inverse.u.lines;
        const int beams = inverse.u.beams;
        const Lines solid = wholeSweepOf(solidOf(inverse), 0.0F);
        Lines u = wholeSweepOf(inverse.u, 1.0F);
        std::vector<float> room;
        for (const Along along : {Along::Beams, Along::Lines}) {
            const Lines from = u;
            for (int i = 0; i < lines; ++i) snapMixedPixels({from, solid}, along, i, anglesOf(steps, along, i, room), limits, u);
        }
        const Links none(beams, lines + 4 * Lines::kMargin, 0, -1);
        std::array<Links, 2> links{none, none};
        for (const Along along : {Along::Beams, Along::Lines}) {
            Lines cracks = wholeSweep(inverse.u, 0.0F, -1);
            Lines cells = wholeSweep(inverse.u, 0.0F);
            Links& link = links[static_cast<std::size_t>(along)];
            cracks.nextEmpty();
            for (int i = 0; i < lines; ++i) crackJumps({u, solid}, along, i, anglesOf(steps, along, i, room), slips, limits, cracks);
            cracks.nextEmpty();
            for (int i = -1; i <= lines; ++i) surfaceLinks({u, solid}, cracks, along, i, slips, link);
            for (int i = 0; i < lines; ++i) jumpsOnNearerCells({u, solid}, cracks, along, i, cells);
            addMargin(link);
            for (int i = 0; i < lines; ++i)
                (along == Along::Beams ? jumpBeams : jumpLines).emplace_back(cells.line(i), cells.line(i) + beams);
        }
        for (int pass = 0; pass < limits.passes; ++pass) {
            for (const Along along : {Along::Beams, Along::Lines}) {
                Lines smooth = wholeSweep(inverse.u, 1.0F);
                for (int i = 0; i < lines; ++i)
                    smoothSurfaces(u, links[static_cast<std::size_t>(along)], along, i, pass == 0 ? 1.0F : limits.noisy, smooth);
                addMargin(smooth);
                u = smooth;
            }
        }
        FoldWork work;
        FoldStrengths folds{wholeSweep(inverse.u, 0.0F), wholeSweep(inverse.u, 0.0F)};
        for (int i = 0; i < lines; ++i) {
            foldStrengths(u, links[0], links[1], steps, i, limits, work, folds);
            foldBeams.emplace_back(folds.alongBeams.line(i), folds.alongBeams.line(i) + beams);
            foldLines.emplace_back(folds.alongLines.line(i), folds.alongLines.line(i) + beams);
        }
    }
};

TEST(DepthLines, StagesLineByLineSayWhatTheySayOfTheWholeSweep) {
    std::mt19937 random(32);
    double jumps = 0;
    double folds = 0;
    for (int round = 0; round < 150; ++round) {
        const Scan scan = randomScan(random);
        InverseRange inverse = inverseRange(scan);
        SweepSlips slips = noSlips(scan.lines());
        if (round % 3 == 0) slips.remaining[random() % 2][random() % static_cast<unsigned>(scan.lines())] = 1.3F;
        const AngularSteps steps = angularSteps(scan);
        const DepthLimits limits = randomLimits(random);
        const WholeSweep whole(inverse, steps, slips, limits);
        SurfaceLines surface(inverse, steps, slips, limits);
        const auto expectSame = [&](const Lines& lines, int line, const std::vector<std::vector<float>>& expected) {
            if (line < 0 || line >= scan.lines()) return 0.0;
            const std::vector<float>& values = expected[static_cast<std::size_t>(line)];
            EXPECT_TRUE(sameBits(lines.line(line), values.data(), scan.beams())) << round << ": line " << line;
            return static_cast<double>(std::count_if(values.begin(), values.end(), [](float value) { return value != 0; }));
        };
        while (surface.foldLine() < scan.lines()) {
            surface.advance();
            jumps += expectSame(surface.jumps(Along::Beams), surface.jumpLine(), whole.jumpBeams);
            jumps += expectSame(surface.jumps(Along::Lines), surface.jumpLine(), whole.jumpLines);
            folds += expectSame(surface.folds(Along::Beams), surface.foldLine(), whole.foldBeams);
            folds += expectSame(surface.folds(Along::Lines), surface.foldLine(), whole.foldLines);
        }
    }
    EXPECT_GT(jumps, 10000);
    EXPECT_GT(folds, 10000);
}

// Beams and lines removed at the start shift the cells in all blocks and windows.
TEST(DepthLines, WhatIsFarAwayDoesNotMatter) {
    constexpr int kFar = 48;
    const Scan scan = test::boxesScan(130, 140, 5, 0.03);
    Settings settings;
    settings.noiseMm = 6.75;
    settings.straighten = false;
    const DepthResponses whole = test::depthResponses(scan, settings);
    for (const auto& [lines, beams] : {std::array{1, 0}, std::array{0, 1}, std::array{7, 13}, std::array{33, 9}}) {
        Scan part = test::makeScan(130 - lines, 140 - beams, [&](int i, int j) {
            const std::size_t k = scan.rangeMm.index(i + lines, j + beams);
            return scan.state[k] == CellState::Valid ? scan.rangeMm[k] : 0.0F;
        });
        auto& polar = std::get<PolarGeometry>(part.geometry);
        const auto& from = std::get<PolarGeometry>(scan.geometry);
        polar.beamDeg.assign(from.beamDeg.begin() + beams, from.beamDeg.end());
        polar.lineDeg.assign(from.lineDeg.begin() + lines, from.lineDeg.end());
        const DepthResponses some = test::depthResponses(part, settings);
        int compared = 0;
        for (int i = kFar; i < part.lines(); ++i) {
            ASSERT_TRUE(sameBits(some.jump->line(i) + kFar, whole.jump->line(i + lines) + kFar + beams, part.beams() - kFar)) << i;
            ASSERT_TRUE(sameBits(some.crease.line(i) + kFar, whole.crease.line(i + lines) + kFar + beams, part.beams() - kFar)) << i;
            for (int j = kFar; j < part.beams(); ++j) compared += some.crease.at(i, j) != 0 ? 1 : 0;
        }
        EXPECT_GT(compared, 200);
    }
}

TEST(DepthLines, IsolatedCellsAndFilledGapsAreThoseOfCellByCell) {
    std::mt19937 random(33);
    for (int round = 0; round < 300; ++round) {
        const Scan scan = randomScan(random);
        const auto valid = [&](int i, int j) { return scan.state.contains(i, j) && scan.state.at(i, j) == CellState::Valid; };
        const auto range = [&](int i, int j) { return scan.rangeMm.at(i, j); };
        const InverseRange inverse = inverseRange(scan);
        const Grid<std::uint8_t> isolated = isolatedCells(scan);
        Grid<std::uint8_t> measured(scan.lines(), scan.beams());
        for (int i = 0; i < scan.lines(); ++i) {
            for (int j = 0; j < scan.beams(); ++j) {
                int agreeing = 0; // including the cell itself
                for (int n = 0; n < 9; ++n) {
                    const int a = i - 1 + n / 3;
                    const int b = j - 1 + n % 3;
                    agreeing += valid(a, b) && std::abs(range(a, b) - range(i, j)) <= 0.08F * range(i, j) + 60.0F ? 1 : 0;
                }
                ASSERT_EQ(isolated.at(i, j) == 255, valid(i, j) && agreeing < 3);
                ASSERT_EQ(isIsolated(scan, static_cast<std::uint32_t>(scan.state.index(i, j))), isolated.at(i, j) == 255);
                measured.at(i, j) = valid(i, j) && agreeing >= 3 ? 1 : 0;
            }
        }
        // Values from the two ends of a gap of up to four cells around a hole, nearer to one or the other.
        const auto filling = [&](int i, int j, int di, int dj) {
            int before = 1;
            int after = 1;
            while (before <= 4 && measured.contains(i - before * di, j - before * dj) && measured.at(i - before * di, j - before * dj) == 0)
                ++before;
            while (after <= 4 && measured.contains(i + after * di, j + after * dj) && measured.at(i + after * di, j + after * dj) == 0)
                ++after;
            const bool both = measured.contains(i - before * di, j - before * dj) && measured.contains(i + after * di, j + after * dj);
            if (!both || before + after - 1 > 4) return std::array{-1.0F, 0.0F};
            const float from = 1000.0F / range(i - before * di, j - before * dj);
            const float to = 1000.0F / range(i + after * di, j + after * dj);
            return std::array{std::abs(to - from), from + (to - from) / static_cast<float>(before + after) * static_cast<float>(before)};
        };
        for (int i = 0; i < scan.lines(); ++i) {
            for (int j = 0; j < scan.beams(); ++j) {
                if (measured.at(i, j) != 0) {
                    ASSERT_EQ(inverse.support.at(i, j), Support::Measured);
                    ASSERT_EQ(inverse.u.at(i, j), 1000.0F / range(i, j));
                    continue;
                }
                const auto [apartBeams, alongBeams] = filling(i, j, 0, 1);
                const auto [apartLines, alongLines] = filling(i, j, 1, 0);
                const bool filled = apartBeams >= 0 || apartLines >= 0;
                const bool lines = apartLines >= 0 && (apartBeams < 0 || apartLines < apartBeams);
                ASSERT_EQ(inverse.support.at(i, j), filled ? Support::Filled : Support::Void);
                ASSERT_EQ(inverse.u.at(i, j), !filled ? 1.0F / 60.0F : lines ? alongLines : alongBeams);
            }
        }
    }
}

TEST(OrderStatistic, IsThatOfASort) {
    std::mt19937 random(34);
    for (const int count : {1, 2, 3, 100, 5000}) {
        for (const float scale : {0.0F, 1e-40F, 1e-3F, 1e6F}) {
            std::vector<float> values(static_cast<std::size_t>(count));
            for (float& value : values) value = scale * static_cast<float>(random() % 1000);
            std::vector<float> sorted = values;
            std::sort(sorted.begin(), sorted.end());
            for (std::size_t n = 0; n < sorted.size(); n += 1 + sorted.size() / 50) ASSERT_EQ(nthSmallest(values, n), sorted[n]);
            ASSERT_EQ(nthSmallest(values, sorted.size() - 1), sorted.back());
        }
    }
}

} // namespace
} // namespace edgescan::edges
