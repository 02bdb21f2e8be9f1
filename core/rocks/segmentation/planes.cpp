// Computes sums over windows, several columns at once.
#include "core/rocks/segmentation/planes.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace edgescan::rocks {
namespace {

constexpr std::size_t kWide = 2 * kPlaneReach + 1;

// Vectors for the columns of a window that are summed at once, as many as a register of doubles holds.
struct FourColumns {
    using Numbers = std::uint32_t __attribute__((vector_size(16)));
    using Doubles = double __attribute__((vector_size(32)));
    using Floats = FourLanes;
};
struct EightColumns {
    using Numbers = std::uint32_t __attribute__((vector_size(32)));
    using Doubles = double __attribute__((vector_size(64)));
    using Floats = EightLanes;
};

template <class T, class Vector>
EDGESCAN_INLINE T sumOf(const Vector& vector) {
    std::array<T, sizeof(Vector) / sizeof(T)> values;
    std::memcpy(values.data(), &vector, sizeof vector);
    for (std::size_t half = values.size() / 2; half > 0; half /= 2) {
        for (std::size_t n = 0; n < half; ++n) values[n] += values[n + half];
    }
    return values[0];
}

// All sums but that of the squares of u are exact in any order: u has 24 bits, a double 53. The squares are added by column.
template <class In, bool kSquares>
EDGESCAN_INLINE void addColumns(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own, WindowSums& sums,
                                std::size_t lane) {
    constexpr std::size_t kCount = kLanes<typename In::Floats>, kGroups = (kWide + kCount - 1) / kCount;
    typename In::Numbers counts{}, byColumn{}, bySquare{};
    typename In::Doubles all{}, across{}, upwards{};
    std::array<double, kGroups * kCount> squares;
#pragma GCC unroll 3
    for (std::size_t group = 0; group < kGroups; ++group) {
        typename In::Numbers number{}, column, used;
        typename In::Doubles total{}, upward{}, square{}, x, weight;
        for (std::size_t n = 0; n < kCount; ++n) {
            column[n] = static_cast<std::uint32_t>(group * kCount + n);
            const bool isInside = group * kCount + n < kWide;
            used[n] = isInside ? UINT32_MAX : 0;
            weight[n] = isInside ? 1.0 : 0.0;
            x[n] = isInside ? static_cast<double>(group * kCount + n) - kPlaneReach : 0.0;
        }
#pragma GCC unroll 9
        for (std::uint32_t row = 0; row < kWide; ++row) {
            const std::size_t at = row * beams + group * kCount;
            typename In::Numbers there, bits;
            std::memcpy(&there, segment + at, sizeof there);
            std::memcpy(&bits, u + at, sizeof bits);
            const auto isOwn = reinterpret_cast<typename In::Numbers>(there == own);
            number += isOwn & (1U | row << kRowsFrom | row * row << kSquaresFrom);
            const auto own4 = __builtin_convertvector(reinterpret_cast<typename In::Floats>(bits & isOwn), typename In::Doubles);
            total += own4;
            upward += total;
            if constexpr (kSquares) square += own4 * own4;
        }
        number &= used;
        counts += number;
        byColumn += column * (number & ((1U << kSquaresFrom) - 1));
        bySquare += column * column * (number & kNumberBits);
        all += total * weight;
        across += total * x;
        upwards += upward * weight;
        if constexpr (kSquares) std::memcpy(&squares[group * kCount], &square, sizeof square);
    }
    sums.counts[lane] = sumOf<std::uint32_t>(counts);
    sums.byColumn[lane] = sumOf<std::uint32_t>(byColumn);
    sums.bySquare[lane] = sumOf<std::uint32_t>(bySquare);
    sums.u[lane] = sumOf<double>(all);
    sums.xu[lane] = sumOf<double>(across);
    sums.upward[lane] = sumOf<double>(upwards);
    if constexpr (kSquares) {
        double sum = 0;
        for (std::size_t n = 0; n < kWide; ++n) sum += squares[n];
        sums.uu[lane] = sum;
    }
}

} // namespace

void addWindow(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own, WindowSums& sums, std::size_t lane) {
    vectorised<addColumns<FourColumns, false>, addColumns<FourColumns, false>, addColumns<EightColumns, false>>(segment, u, beams, own,
                                                                                                                sums, lane);
}

void addSquaredWindow(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own, WindowSums& sums,
                      std::size_t lane) {
    vectorised<addColumns<FourColumns, true>, addColumns<FourColumns, true>, addColumns<EightColumns, true>>(segment, u, beams, own, sums,
                                                                                                             lane);
}

} // namespace edgescan::rocks
