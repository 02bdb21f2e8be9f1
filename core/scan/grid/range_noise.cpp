// The noise of the ranges from the flattest tiles of a sweep.
#include "core/scan/grid/inverse_range.h"

#include "core/base/order_statistic.h"
#include "core/base/simd.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace edgescan {
namespace {

constexpr int kTile = 8;               // lines and beams
constexpr int kFewestOfTile = 48;      // second differences
constexpr double kShareOfTiles = 0.20; // of the tiles have less noise than the result
constexpr double kMedianOfNormal = 0.6745;
constexpr double kFewTiles = 25, kEnoughTiles = 75;
constexpr double kMostRelief = 1.5;    // times that the noise of the middle tile exceeds the result
constexpr double kReliefGrows = 7.0;   // times that the square of relief's second differences grows from one cell to two
constexpr double kLeastOfNoise = 0.25; // share of the second differences that is noise at least
constexpr std::size_t kCells = 125000; // at most about these are looked at, for each distance

// The distance of the cells of a line from the straight line through those `lag` before and after them, divided by the deviation that the
// noise of an LMS511 gives it; negative unless all three cells were measured.
EDGESCAN_INLINE void offStraightOfScanner(const float* u, const Support* support, int beams, int lag, float* __restrict off) {
    const auto offset = static_cast<float>(0.001 * kScannerNoise.offsetMm), perMetre = static_cast<float>(0.001 * kScannerNoise.perMetreMm);
    constexpr float kOfSecondDifference = 2.4494897F; // root of 6
    for (int j = lag; j < beams - lag; ++j) {
        const float range = 1.0F / u[j];
        const bool measured =
            (support[j - lag] == Support::Measured) & (support[j] == Support::Measured) & (support[j + lag] == Support::Measured);
        const float distance = std::abs(u[j - lag] - 2 * u[j] + u[j + lag]) * range * range;
        off[j] = measured ? distance / (kOfSecondDifference * (offset + perMetre * range)) : -1.0F;
    }
}

// The middle values of at most kTogether tiles; -1 where too few are 0 or more. Bits of such floats are in the order of the numbers, so
// each step decides a bit, for all tiles together: a selection by exchanges takes five times as long.
constexpr int kTogether = 16;
EDGESCAN_INLINE void middleOfTiles(const float* off, int beams, int tiles, float* __restrict middle) {
    constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();
    using OfTiles = std::array<std::int32_t, kTogether>;
    std::array<OfTiles, static_cast<std::size_t>(kTile) * kTile> values;
    OfTiles count{}, found{};
    for (int n = 0; n < kTile * kTile; ++n) {
        for (int tile = 0; tile < kTogether; ++tile) {
            const auto value = std::bit_cast<std::int32_t>(off[n / kTile * beams + std::min(tile, tiles - 1) * kTile + n % kTile]);
            values[n][tile] = value >= 0 ? value : kNone;
            count[tile] += value >= 0 ? 1 : 0;
        }
    }
    for (std::int32_t bit = 1 << 30; bit != 0; bit >>= 1) {
        OfTiles less{};
        for (const OfTiles& value : values) {
            for (int tile = 0; tile < kTogether; ++tile) less[tile] += value[tile] < (found[tile] | bit) ? 1 : 0;
        }
        for (int tile = 0; tile < kTogether; ++tile) found[tile] |= less[tile] <= count[tile] / 2 ? bit : 0;
    }
    for (int tile = 0; tile < tiles; ++tile) middle[tile] = count[tile] >= kFewestOfTile ? std::bit_cast<float>(found[tile]) : -1.0F;
}

// The second differences of the tiles with enough of them, as noise in units of that of an LMS511.
std::vector<float> noiseOfTiles(const InverseRange& inverse, int lag) {
    const int beams = inverse.u.beams, rows = inverse.u.lines / kTile;
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCells));
    std::vector<float> off(static_cast<std::size_t>(kTile) * static_cast<std::size_t>(beams), -1.0F), tiles;
    for (int row = std::min(every, rows) / 2; row < rows; row += every) {
        for (int n = 0; n < kTile; ++n)
            vectorised<offStraightOfScanner>(inverse.u.line(row * kTile + n), inverse.support.line(row * kTile + n), beams, lag,
                                             off.data() + static_cast<std::ptrdiff_t>(n) * beams);
        for (int first = 0; first < beams / kTile; first += kTogether) {
            std::array<float, kTogether> middle;
            middle.fill(-1);
            vectorised<middleOfTiles>(off.data() + first * kTile, beams, std::min(kTogether, beams / kTile - first), middle.data());
            for (const float value : middle) {
                if (value >= 0) tiles.push_back(value / static_cast<float>(kMedianOfNormal));
            }
        }
    }
    return tiles;
}

// The noise in the second differences of neighbours, after what they have of relief, as those of every second cell show it.
double withoutRelief(double near, double far) {
    const double relief = std::max(0.0, far * far - near * near) / (kReliefGrows - 1);
    return std::sqrt(std::max(near * near - relief, kLeastOfNoise * kLeastOfNoise * near * near));
}

// The noise of a scanner varies little, and the estimate by what is in view. So an estimate near 1 counts as 1, and a part of a scan has
// the thresholds of the whole.
double nearlyOne(double times) {
    struct Point {
        double from, to;
    };
    constexpr std::array<Point, 4> kPoints{{{0.25, 0.25}, {0.5, 1.0}, {1.3, 1.0}, {2.0, 2.0}}};
    if (times <= kPoints.front().from || times >= kPoints.back().from) return times;
    std::size_t n = 1;
    while (times > kPoints[n].from) ++n;
    const Point before = kPoints[n - 1], after = kPoints[n];
    return before.to + (times - before.from) * (after.to - before.to) / (after.from - before.from);
}

} // namespace

TileNoise tileNoise(const InverseRange& inverse, const RangeNoise& ofRange) {
    std::vector<float> tiles = noiseOfTiles(inverse, 1);
    const double share = std::clamp((static_cast<double>(tiles.size()) - kFewTiles) / (kEnoughTiles - kFewTiles), 0.0, 1.0);
    if (share <= 0) return {ofRange, ofRange};
    std::vector<float> wide = noiseOfTiles(inverse, 2);
    const auto noiseAt = [&](double shareOfTiles) {
        const auto near = static_cast<double>(quantile(tiles, shareOfTiles));
        return wide.empty() ? near : withoutRelief(near, static_cast<double>(quantile(wide, shareOfTiles)));
    };
    const double times = std::max(noiseAt(kShareOfTiles), noiseAt(0.5) / kMostRelief);
    const auto mixed = [&](double multiple) {
        const auto sum = [&](double scanner, double all) { return share * multiple * scanner + (1 - share) * all; };
        return RangeNoise{sum(kScannerNoise.offsetMm, ofRange.offsetMm), sum(kScannerNoise.perMetreMm, ofRange.perMetreMm), 0};
    };
    return {mixed(times), mixed(nearlyOne(times))};
}

RangeNoise rangeNoise(const InverseRange& inverse) { return tileNoise(inverse, noiseByRange(inverse)).measured; }

} // namespace edgescan
