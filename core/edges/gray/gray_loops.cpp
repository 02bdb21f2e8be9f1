// Gaussian, Sobel and suppression line by line, with rows that stay in the cache.
#include "core/edges/gray/gray_loops.h"

#include "core/base/simd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

// Says that the rows of a loop do not overlap: the compiler would not check so many rows at run time.
#if defined(__clang__)
#define EDGESCAN_APART // for fuzzing only
#else
#define EDGESCAN_APART _Pragma("GCC ivdep")
#endif

namespace edgescan::edges {
namespace {

constexpr int kPad = 16;   // cells on either side of a row of the buffer; 5 are needed
constexpr int kBlock = 64; // cells that the loops process at once

// Calls work(first cell, cells) for blocks of a row. The last block overlaps the one before, so that loops never end with single cells.
template <class Work>
EDGESCAN_INLINE void inBlocks(int beams, Work work) {
    if (beams < kBlock) return work(0, beams);
    for (int first = 0; first < beams; first += kBlock) work(std::min(first, beams - kBlock), std::integral_constant<int, kBlock>());
}

// Rows of an image's width with a margin on either side.
template <class T>
class Rows {
public:
    Rows(int count, int beams) : width_(static_cast<std::size_t>(beams) + 2 * kPad), cells_(static_cast<std::size_t>(count) * width_) {}
    [[nodiscard]] T* operator[](int row) { return cells_.data() + static_cast<std::size_t>(row) * width_ + kPad; }

private:
    std::size_t width_;
    std::vector<T> cells_;
};

// Mirrored at the border without repeating the border cell, as cv::BORDER_REFLECT_101.
EDGESCAN_INLINE int insideOf(int i, int count) {
    if (count == 1) return 0;
    while (i < 0 || i >= count) i = i < 0 ? -i : 2 * (count - 1) - i;
    return i;
}

// ---- Levels. For products below 512, floats differ from doubles by less than 1e-4. So a float product rounds to the same level, unless it
// is that close to the middle between two levels. If so, doubles decide for the block of cells.
constexpr float kSurelyRounded = 0.5F - 1e-4F;
constexpr float kToWhole = 12582912.0F; // 1.5 x 2^23: a sum with it has no fraction bits, and rounds to even

struct QuickLevels {
    int outside; ///< number of valid ranges outside the limits
    bool isSure; ///< all levels are the same as with doubles
};
EDGESCAN_INLINE QuickLevels quickLevels(const float* rangeMm, const CellState* states, int cells, float factor, float least, float most,
                                        std::uint8_t* __restrict levels) {
    int doubtful = 0;
    int outside = 0;
    EDGESCAN_APART
    for (int j = 0; j < cells; ++j) {
        const float range = rangeMm[j];
        const int valid = states[j] == CellState::Valid ? -1 : 0;
        const float product = range * factor;
        const float level = (product + kToWhole) - kToWhole;
        doubtful |= std::fabs(product - level) <= kSurelyRounded ? 0 : -1; // NaN is not certain either
        outside -= valid & ((range < least ? -1 : 0) | (range > most ? -1 : 0));
        const float notBelow = level > 0.0F ? level : 0.0F;
        const float within = notBelow < 255.0F ? notBelow : 255.0F;
        levels[j] = static_cast<std::uint8_t>(static_cast<int>(within) & valid);
    }
    return {outside, doubtful == 0};
}

EDGESCAN_INLINE void exactLevels(const float* rangeMm, const CellState* states, int cells, double factor, std::uint8_t* levels) {
    for (int j = 0; j < cells; ++j)
        levels[j] =
            states[j] == CellState::Valid ? static_cast<std::uint8_t>(std::clamp(std::nearbyint(rangeMm[j] * factor), 0.0, 255.0)) : 0;
}

EDGESCAN_INLINE std::size_t levelsAll(const Grid<float>& rangeMm, const Grid<CellState>& states, LinearLevels to,
                                      Grid<std::uint8_t>& levels) {
    // Comparisons of floats with limits rounded to the inside give the same result as those of doubles with the limits themselves.
    auto least = static_cast<float>(to.nearMm), most = static_cast<float>(to.farMm);
    if (least < to.nearMm) least = std::nextafter(least, std::numeric_limits<float>::infinity());
    if (most > to.farMm) most = std::nextafter(most, -std::numeric_limits<float>::infinity());
    const auto factor = static_cast<float>(to.factor);
    std::size_t outside = 0;
    constexpr int kMany = 4 * kBlock; // for more cells, counting takes as long
    const std::size_t whole = rangeMm.size() / kMany * kMany;
    const auto convert = [&](std::size_t k, auto cells) __attribute__((always_inline)) {
        const float* from = rangeMm.cells.data() + k;
        const CellState* state = states.cells.data() + k;
        std::uint8_t* level = levels.cells.data() + k;
        const QuickLevels quick = quickLevels(from, state, cells, factor, least, most, level);
        if (!quick.isSure) exactLevels(from, state, cells, to.factor, level);
        outside += static_cast<std::size_t>(quick.outside);
    };
    for (std::size_t k = 0; k < whole; k += kMany) convert(k, std::integral_constant<int, kMany>());
    if (whole < rangeMm.size()) convert(whole, static_cast<int>(rangeMm.size() - whole));
    return outside;
}

// ---- Gaussian. Weights without their common divisor: if the sums then fit into 16 bits, twice as many cells are processed at once.
template <int kReach, class Sum>
EDGESCAN_INLINE void blurBody(const Grid<std::uint8_t>& levels, const std::vector<int>& weights, int divisor, Grid<std::uint8_t>& blurred) {
    const int beams = levels.beams;
    std::array<std::uint16_t, kReach + 1> w;
    for (int d = 0; d <= kReach; ++d) w[d] = static_cast<std::uint16_t>(weights[static_cast<std::size_t>(kReach + d)] / divisor);
    const int whole = 256 / divisor; // a power of two
    int shift = 0;
    while ((1 << shift) < whole * whole) ++shift;
    const auto half = static_cast<Sum>((whole * whole) / 2);
    Rows<std::uint16_t> rows(1, beams);
    std::uint16_t* __restrict sums = rows[0];
    for (int i = 0; i < levels.lines; ++i) {
        std::array<const std::uint8_t*, 2 * kReach + 1> from;
        for (int d = -kReach; d <= kReach; ++d) from[static_cast<std::size_t>(d + kReach)] = levels.line(insideOf(i + d, levels.lines));
        inBlocks(
            beams, [=](int first, auto cells) __attribute__((always_inline)) {
                const int end = first + cells;
                EDGESCAN_APART
                for (int j = first; j < end; ++j) {
                    auto sum = static_cast<std::uint16_t>(w[0] * from[kReach][j]);
                    for (int d = 1; d <= kReach; ++d)
                        sum = static_cast<std::uint16_t>(
                            sum + static_cast<std::uint16_t>(w[d] * static_cast<std::uint16_t>(from[kReach - d][j] + from[kReach + d][j])));
                    sums[j] = sum;
                }
            });
        for (int d = 1; d <= kReach; ++d) {
            sums[-d] = sums[insideOf(-d, beams)];
            sums[beams - 1 + d] = sums[insideOf(beams - 1 + d, beams)];
        }
        std::uint8_t* __restrict to = blurred.line(i);
        inBlocks(
            beams, [=](int first, auto cells) __attribute__((always_inline)) {
                const int end = first + cells;
                EDGESCAN_APART
                for (int j = first; j < end; ++j) {
                    auto sum = static_cast<Sum>(w[0] * static_cast<Sum>(sums[j]));
                    for (int d = 1; d <= kReach; ++d)
                        sum = static_cast<Sum>(
                            sum + static_cast<Sum>(w[d] * static_cast<Sum>(static_cast<Sum>(sums[j - d]) + static_cast<Sum>(sums[j + d]))));
                    to[j] = static_cast<std::uint8_t>(static_cast<Sum>(sum + half) >> shift);
                }
            });
    }
}

template <int kReach>
EDGESCAN_INLINE void blurOfReach(const Grid<std::uint8_t>& levels, const std::vector<int>& weights, int divisor,
                                 Grid<std::uint8_t>& blurred) {
    if (divisor >= 16)
        blurBody<kReach, std::uint16_t>(levels, weights, divisor, blurred);
    else
        blurBody<kReach, std::uint32_t>(levels, weights, divisor, blurred);
}

EDGESCAN_INLINE void blurAll(const Grid<std::uint8_t>& levels, const std::vector<int>& weights, Grid<std::uint8_t>& blurred) {
    int divisor = 256;
    for (const int weight : weights) divisor = std::gcd(divisor, weight);
    switch (weights.size() / 2) {
    case 1:
        return blurOfReach<1>(levels, weights, divisor, blurred);
    case 2:
        return blurOfReach<2>(levels, weights, divisor, blurred);
    case 3:
        return blurOfReach<3>(levels, weights, divisor, blurred);
    case 4:
        return blurOfReach<4>(levels, weights, divisor, blurred);
    default:
        return blurOfReach<5>(levels, weights, divisor, blurred);
    }
}

// ---- Sobel.
template <int kAperture>
struct Sobel;
template <>
struct Sobel<3> {
    static constexpr std::array<int, 3> kDerivative{-1, 0, 1}, kSmoothing{1, 2, 1};
    using Sum = std::int16_t;
};
template <>
struct Sobel<5> {
    static constexpr std::array<int, 5> kDerivative{-1, -2, 0, 2, 1}, kSmoothing{1, 4, 6, 4, 1};
    using Sum = std::int16_t;
};
template <>
struct Sobel<7> {
    static constexpr std::array<int, 7> kDerivative{-1, -4, -5, 0, 5, 4, 1}, kSmoothing{1, 6, 15, 20, 15, 6, 1};
    using Sum = std::int32_t; // and divided by 16
};

template <class Sum, std::size_t kTaps, class From>
EDGESCAN_INLINE Sum weighted(const std::array<int, kTaps>& weights, From from) {
    Sum sum = 0;
    for (std::size_t n = 0; n < kTaps; ++n) {
        if (weights[n] != 0)
            sum = static_cast<Sum>(sum + static_cast<Sum>(static_cast<Sum>(weights[n]) * static_cast<Sum>(from(static_cast<int>(n)))));
    }
    return sum;
}

// As cv::Canny stores it: within 16 bits; for aperture 7 divided by 16 and rounded to even.
EDGESCAN_INLINE std::int16_t stored(std::int16_t sum) { return sum; }
EDGESCAN_INLINE std::int16_t stored(std::int32_t sum) { return static_cast<std::int16_t>((sum + 7 + ((sum >> 4) & 1)) >> 4); }

template <class Magnitude>
EDGESCAN_INLINE Magnitude magnitudeOf(std::int16_t x, std::int16_t y) {
    if constexpr (sizeof(Magnitude) == 2)
        return static_cast<std::int16_t>(static_cast<std::int16_t>(x < 0 ? -x : x) + static_cast<std::int16_t>(y < 0 ? -y : y));
    else
        return x * x + y * y;
}

// Gradient and magnitude of line i. `smooth` and `rise`: buffers for the sums across lines.
template <int kAperture, class Magnitude, class Sum>
EDGESCAN_INLINE void gradientLine(const Grid<std::uint8_t>& levels, int i, Sum* __restrict smooth, Sum* __restrict rise,
                                  std::int16_t* __restrict dx, std::int16_t* __restrict dy, Magnitude* __restrict magnitude) {
    constexpr int kReach = kAperture / 2;
    const int beams = levels.beams;
    std::array<const std::uint8_t*, kAperture> from;
    for (int d = 0; d < kAperture; ++d) from[static_cast<std::size_t>(d)] = levels.line(std::clamp(i + d - kReach, 0, levels.lines - 1));
    inBlocks(
        beams, [=](int first, auto cells) __attribute__((always_inline)) {
            const int end = first + cells;
            EDGESCAN_APART
            for (int j = first; j < end; ++j) {
                const auto level = [&](int n) { return from[static_cast<std::size_t>(n)][j]; };
                smooth[j] = weighted<Sum>(Sobel<kAperture>::kSmoothing, level);
                rise[j] = weighted<Sum>(Sobel<kAperture>::kDerivative, level);
            }
        });
    for (int d = 1; d <= kReach; ++d) {
        smooth[-d] = smooth[0];
        rise[-d] = rise[0];
        smooth[beams - 1 + d] = smooth[beams - 1];
        rise[beams - 1 + d] = rise[beams - 1];
    }
    inBlocks(
        beams, [=](int first, auto cells) __attribute__((always_inline)) {
            const int end = first + cells;
            EDGESCAN_APART
            for (int j = first; j < end; ++j) {
                const std::int16_t x = stored(weighted<Sum>(Sobel<kAperture>::kDerivative, [&](int n) { return smooth[j + n - kReach]; }));
                const std::int16_t y = stored(weighted<Sum>(Sobel<kAperture>::kSmoothing, [&](int n) { return rise[j + n - kReach]; }));
                dx[j] = x;
                dy[j] = y;
                magnitude[j] = magnitudeOf<Magnitude>(x, y);
            }
        });
}

// ---- Suppression.
constexpr std::uint32_t kTan22 = 13573; // tan(22.5 degrees) x 2^15, as cv::Canny rounds it

// All ones where true, as wide as the values: selections by bits, because the processor would mispredict branches.
template <class Lane>
EDGESCAN_INLINE Lane all(bool condition) {
    return condition ? Lane{-1} : Lane{0};
}

// cv::Canny compares y 2^15 < x kTan22 and y 2^15 > x (kTan22 + 2^16). kTan22 is odd and x is below 2^15, so x kTan22 / 2^15 is whole only
// for x = 0, where the magnitude alone decides. So its whole part gives the same result.
template <class Magnitude>
EDGESCAN_INLINE void suppressCells(const std::int16_t* dx, const std::int16_t* dy, const Magnitude* up, const Magnitude* here,
                                   const Magnitude* down, int cells, Magnitude low, Magnitude high, std::uint8_t* __restrict marks) {
    EDGESCAN_APART
    for (int j = 0; j < cells; ++j) {
        const auto x = static_cast<std::uint16_t>(dx[j] < 0 ? -dx[j] : dx[j]);
        const auto y = static_cast<std::uint16_t>(dy[j] < 0 ? -dy[j] : dy[j]);
        const auto twice = static_cast<std::uint16_t>(x + x);
        const auto limit = static_cast<std::int16_t>((static_cast<std::uint32_t>(twice) * kTan22) >> 16U);
        const Magnitude alongBeams = all<std::int16_t>(static_cast<std::int16_t>(y) <= limit);
        const Magnitude alongLines = all<std::int16_t>(static_cast<std::int16_t>(y - twice) > limit);
        const auto straight = static_cast<Magnitude>(alongBeams | alongLines);
        const Magnitude otherSign = static_cast<std::int16_t>(static_cast<std::int16_t>(dx[j] ^ dy[j]) >> 15);
        const auto falling = static_cast<Magnitude>(~straight & ~otherSign);
        const auto rising = static_cast<Magnitude>(~straight & otherSign);
        const auto first =
            static_cast<Magnitude>((alongBeams & here[j - 1]) | (alongLines & up[j]) | (falling & up[j - 1]) | (rising & up[j + 1]));
        const auto second =
            static_cast<Magnitude>((alongBeams & here[j + 1]) | (alongLines & down[j]) | (falling & down[j + 1]) | (rising & down[j - 1]));
        const Magnitude value = here[j];
        const auto tie = static_cast<Magnitude>(straight & all<Magnitude>(value == second));
        const auto keeps =
            static_cast<Magnitude>(all<Magnitude>(value > low) & all<Magnitude>(value > first) & (all<Magnitude>(value > second) | tie));
        // 1 and 2 of a mask of ones: weak, and strong.
        marks[j] = static_cast<std::uint8_t>(keeps & (CannyMarks::kWeak - all<Magnitude>(value > high)));
    }
}

template <class Magnitude>
EDGESCAN_INLINE bool anyAbove(const Magnitude* values, int cells, Magnitude low) {
    Magnitude most = 0;
    for (int j = 0; j < cells; ++j) most = values[j] > most ? values[j] : most;
    return most > low;
}

template <int kAperture, class Magnitude>
EDGESCAN_INLINE void suppressBody(const Grid<std::uint8_t>& levels, CannyLimits limits, CannyMarks& marks) {
    using Sum = typename Sobel<kAperture>::Sum;
    constexpr auto kMost = static_cast<std::int32_t>(std::numeric_limits<Magnitude>::max());
    const auto low = static_cast<Magnitude>(std::clamp(limits.low, 0, kMost));
    const auto high = static_cast<Magnitude>(std::clamp(limits.high, 0, kMost));
    const int beams = levels.beams;
    Rows<Sum> sums(2, beams);
    Rows<std::int16_t> gradients(4, beams);
    Rows<Magnitude> magnitudes(3, beams); // cells outside are 0
    for (int i = 0; i <= levels.lines; ++i) {
        Magnitude* down = magnitudes[i % 3];
        if (i < levels.lines)
            gradientLine<kAperture>(levels, i, sums[0], sums[1], gradients[i % 2], gradients[2 + i % 2], down);
        else
            std::fill(down, down + beams, Magnitude{0});
        if (i == 0) continue;
        const Magnitude* up = magnitudes[(i + 1) % 3];
        const Magnitude* here = magnitudes[(i + 2) % 3];
        const std::int16_t* dx = gradients[(i + 1) % 2];
        const std::int16_t* dy = gradients[2 + (i + 1) % 2];
        std::uint8_t* to = marks.framed.data() + marks.index(i - 1, 0);
        inBlocks(
            beams, [=](int j, auto cells) __attribute__((always_inline)) {
                if (anyAbove(here + j, cells, low)) suppressCells(dx + j, dy + j, up + j, here + j, down + j, cells, low, high, to + j);
            });
    }
}

EDGESCAN_INLINE void suppressAll(const Grid<std::uint8_t>& levels, int aperture, bool squared, CannyLimits limits, CannyMarks& marks) {
    const auto run = [&]<int kAperture>() __attribute__((always_inline)) {
        if (squared)
            suppressBody<kAperture, std::int32_t>(levels, limits, marks);
        else
            suppressBody<kAperture, std::int16_t>(levels, limits, marks);
    };
    if (aperture == 3)
        run.template operator()<3>();
    else if (aperture == 5)
        run.template operator()<5>();
    else
        run.template operator()<7>();
}

} // namespace

std::size_t levelsBy(InstructionSet set, const Grid<float>& rangeMm, const Grid<CellState>& states, LinearLevels to,
                     Grid<std::uint8_t>& levels) {
    return vectorised<levelsAll>.by(set, rangeMm, states, to, levels);
}

void blurBy(InstructionSet set, const Grid<std::uint8_t>& levels, const std::vector<int>& weights, Grid<std::uint8_t>& blurred) {
    vectorised<blurAll>.by(set, levels, weights, blurred);
}

void suppressBy(InstructionSet set, const Grid<std::uint8_t>& smoothed, int aperture, bool squared, CannyLimits limits, CannyMarks& marks) {
    vectorised<suppressAll>.by(set, smoothed, aperture, squared, limits, marks);
}

} // namespace edgescan::edges
