// Jumps and folds compared with the formulas of docs/method/edges.md, "Step 3" and "Step 5", in double precision and cell by cell.
#include "core/edges/edgescan_plus/surface_lines.h"
#include "core/scan/angle_correction/interlace.h"
#include "core/scan/grid/inverse_range.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace edgescan::edges {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// The crack between a cell and the next one.
double plainCrack(const float* at, const float* there, std::ptrdiff_t s, double angle, const DepthLimits& limits) {
    const auto u = [&](int n) { return static_cast<double>(at[n * s]); };
    const auto solid = [&](int n) { return there[n * s] != 0; };
    const auto range = [](double inverse) { return 1000 / std::max(inverse, 1e-6); };
    if (!solid(0) || !solid(1)) return 0;
    const double ownAway = u(0) - u(-1), ownOn = u(2) - u(1);
    const double away = solid(-1) ? ownAway : solid(2) ? ownOn : 0;
    const double on = solid(2) ? ownOn : solid(-1) ? ownAway : 0;
    const double before = u(0) - away, after = u(1) + on;
    const double before2 = std::max(before, 1e-6) + (solid(-1) && solid(-2) ? u(-2) - u(-1) : 0);
    const double after2 = std::max(after, 1e-6) + (solid(2) && solid(3) ? u(3) - u(2) : 0);
    const auto end = [&](double first, double second, double third) {
        const auto noisy = static_cast<double>(limits.noisy);
        return noisy * (1.083 * first + 0.333 * second - 0.417 * third) + (1 - noisy) * (1.5 * first - 0.5 * second);
    };
    const double left = end(u(0), std::max(before, 1e-6), before2), right = end(u(1), std::max(after, 1e-6), after2);
    const double step = std::min(std::abs(range(u(0)) - range(u(1))), std::abs(range(left) - range(right)));
    const double slope = 0.5 * (std::abs(range(u(0)) - range(before)) + std::abs(range(after) - range(u(1))));
    const double near = std::min(range(u(0)), range(u(1)));
    return step / (static_cast<double>(limits.jumpMm) + static_cast<double>(limits.growth) * near +
                   static_cast<double>(limits.grazing) * slope + static_cast<double>(limits.reliefMm) * slope / (near * angle));
}

// A line through one side of a cell.
struct PlainSide {
    int cells = 0;
    double slope = 0, height = 0; // slope of u per step outwards, and height over the cell
};
PlainSide plainSide(const float* at, const std::uint8_t* link, std::ptrdiff_t s, int sign, int most, int blurred) {
    const auto linked = [&](int n) { return link[sign > 0 ? n * s : -(n + 1) * s] != 0; }; // from the nth cell to the next
    int untilBreak = 0;
    while (untilBreak < 16 && linked(untilBreak)) ++untilBreak;
    const int clear = untilBreak == 16 ? 15 : std::max(std::min(untilBreak, 1), untilBreak - blurred);
    PlainSide side;
    double sum = 0, weighted = 0;
    for (int n = 1; n <= std::min(most, clear); ++n) {
        const double off = static_cast<double>(at[sign * n * s]) - static_cast<double>(at[0]);
        ++side.cells;
        sum += off;
        weighted += n * off;
    }
    if (side.cells == 0) return side;
    const double count = side.cells + 1, mean = 0.5 * side.cells;
    side.slope = (weighted - mean * sum) / (count * (count * count - 1) / 12);
    side.height = sum / count - mean * side.slope;
    return side;
}

struct PlainFit {
    double before = 0, after = 0, misfitMm = 0, noise = 0;
    bool fitted = false, onTheEdge = false; // of two windows
};
PlainFit plainFit(const float* at, const std::uint8_t* link, std::ptrdiff_t s, double angle, const DepthLimits& limits) {
    const double u = static_cast<double>(at[0]);
    const double wanted = std::clamp(static_cast<double>(limits.windowMm) * 0.001 * u / angle + 0.5, 3.0, 15.0);
    PlainFit fit;
    const double halfSpot = limits.spotGrows ? 0.5 * (0.013 * u + 0.0046) / angle + 0.5 : 1;
    const auto isOnTheEdge = [](double cells) { return std::abs(cells - std::round(cells)) < 1e-3; };
    fit.onTheEdge = (wanted > 3 && wanted < 15 && isOnTheEdge(wanted)) || (halfSpot > 1 && isOnTheEdge(halfSpot));
    const int most = static_cast<int>(wanted), blurred = std::max(1, static_cast<int>(halfSpot));
    const PlainSide left = plainSide(at, link, s, -1, most, blurred), right = plainSide(at, link, s, 1, most, blurred);
    fit.before = left.cells > 0 ? left.slope / (u * angle) : -right.slope / (u * angle);
    fit.after = right.cells > 0 ? -right.slope / (u * angle) : left.slope / (u * angle);
    const int fewer = std::min(left.cells, right.cells);
    fit.fitted = fewer >= 2;
    const double n = std::max(fewer, 1) + 1;
    fit.noise = 1.41 * 0.55 * 0.001 * limits.foldNoise.at(1 / u) * std::sqrt(12 / (n * (n * n - 1))) * u / angle;
    fit.misfitMm = std::abs(1000 / (u + left.height) - 1000 / (u + right.height));
    return fit;
}

double plainFold(const PlainFit& along, const PlainFit& across, const DepthLimits& limits) {
    if (!along.fitted) return 0;
    const double a = along.before, b = along.after, tilt = 0.5 * (across.before + across.after);
    const double tilted = 1 + tilt * tilt;
    const double fold = std::atan2(std::abs(a - b) * std::sqrt(tilted), a * b + tilted) / kDegree;
    const double floor = 4.5 / kDegree * along.noise * std::sqrt(tilted) / (std::min(a * a, b * b) + tilted);
    const double mean = 0.5 * (a + b), apart = along.misfitMm / static_cast<double>(limits.misfitMm);
    const double size =
        fold / std::sqrt(1 + apart * apart / (mean * mean + tilted)) / std::max(static_cast<double>(limits.creaseDeg), floor);
    return a < b ? size : -size;
}

TEST(DepthFormulas, JumpsAndFoldsAreThoseOfTheMethod) {
    std::mt19937 random(41);
    int cracks = 0, folds = 0;
    for (int round = 0; round < 50; ++round) {
        const int lines = 20 + static_cast<int>(random() % 60), beams = 20 + static_cast<int>(random() % 200);
        const Scan boxes = test::boxesScan(lines, beams, static_cast<std::uint32_t>(random()), std::array{0.0, 0.02, 0.3}[random() % 3]);
        const double scale = std::array{1.0, 0.3, 0.1}[random() % 3], slant = static_cast<double>(random() % 400) * 0.01;
        const Scan scan = test::makeScan(lines, beams, [&](int i, int j) {
            const float range = boxes.rangeMm.at(i, j);
            return range > 0 ? scale * (static_cast<double>(range) + slant * (30 * i + 20 * j)) : 0.0;
        });
        DepthLimits limits;
        limits.jumpMm = random() % 2 == 0 ? 5.0F : 40.0F;
        limits.noisy = static_cast<float>(random() % 3) / 2;
        limits.windowMm = static_cast<float>(20 + random() % 200);
        limits.spotGrows = random() % 2 == 0;
        limits.noise = {4.0, 0.2};
        limits.foldNoise = round % 2 == 0 ? limits.noise : RangeNoise{3.0, 0.1, 0.05};
        const InverseRange inverse = inverseRange(scan);
        const AngularSteps steps = angularSteps(scan);
        const SweepSlips slips = noSlips(lines);
        SurfaceLines surface(inverse, steps, slips, limits);
        std::vector<float> room;
        while (surface.foldLine() < lines) {
            surface.advance();
            for (const Along along : {Along::Beams, Along::Lines}) {
                const Lines& u = surface.surface().u;
                if (const int i = surface.jumpLine(); i >= 0 && i < lines) {
                    const float* angle = anglesOf(steps, along, i, room);
                    for (int j = 0; j < beams; ++j) {
                        const double expected = plainCrack(u.line(i) + j, surface.surface().solid.line(i) + j, stepOf(u, along),
                                                           static_cast<double>(angle[j]), limits);
                        ASSERT_NEAR(static_cast<double>(surface.cracks(along).line(i)[j]), expected, 1e-3 * (1 + expected)) << round;
                        cracks += expected > 1 ? 1 : 0;
                    }
                }
                if (const int i = surface.foldLine(); i >= 0 && i < lines) {
                    const Along other = along == Along::Beams ? Along::Lines : Along::Beams;
                    const auto fitAt = [&](Along way, int j) {
                        const float* angle = anglesOf(steps, way, i, room);
                        return plainFit(surface.smoothed().line(i) + j, surface.links(way).line(i) + j, stepOf(surface.smoothed(), way),
                                        static_cast<double>(angle[j]), limits);
                    };
                    for (int j = 0; j < beams; ++j) {
                        const PlainFit own = fitAt(along, j), across = fitAt(other, j);
                        if (own.onTheEdge || across.onTheEdge) continue;
                        const double expected = plainFold(own, across, limits);
                        ASSERT_NEAR(static_cast<double>(surface.folds(along).line(i)[j]), expected, 3e-3 * (1 + std::abs(expected)))
                            << round << ": " << i << ", " << j;
                        folds += std::abs(expected) > 1 ? 1 : 0;
                    }
                }
            }
        }
    }
    EXPECT_GT(cracks, 3000);
    EXPECT_GT(folds, 1000);
}

} // namespace
} // namespace edgescan::edges
