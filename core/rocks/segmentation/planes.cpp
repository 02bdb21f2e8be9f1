// Computes sums over windows, several columns at once.
#include "core/rocks/segmentation/planes.h"

#include "core/base/simd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace edgescan::rocks {
namespace {

constexpr double kRidge = 0.5; // added to the spreads, so that few cells in one line do not tilt the plane
constexpr int kFewestForPlane = 6;
constexpr int kWide = 2 * kPlaneReach + 1;
constexpr std::size_t kLanesAtOnce = 4;
constexpr std::size_t kGroups = kPlaneColumns / kLanesAtOnce;

using FourNumbers = std::uint32_t __attribute__((vector_size(16)));
using FourWide = double __attribute__((vector_size(32)));

// Sums of each column, rows counted from 0 at the top. All sums are exact in any order: u has 24 bits, a double 53.
struct ColumnSums {
    // number of cells, sum of their rows (from bit 9 on) and of the squared rows (from bit 17 on)
    std::array<std::uint32_t, kPlaneColumns> counts;
    std::array<double, kPlaneColumns> u;
    std::array<double, kPlaneColumns> upward;  // sum of u x (kWide - row)
    std::array<double, kPlaneColumns> squares; // sum of u^2, if it is asked for
};

template <bool kSquares>
EDGESCAN_INLINE void addColumns(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own, ColumnSums& sums) {
    for (std::size_t group = 0; group < kGroups; ++group) {
        FourNumbers counts{};
        FourWide total{}, upward{}, squares{};
        for (std::uint32_t row = 0; row < kWide; ++row) {
            const std::size_t at = row * beams + group * kLanesAtOnce;
            FourNumbers there;
            FourNumbers bits;
            std::memcpy(&there, segment + at, sizeof there);
            std::memcpy(&bits, u + at, sizeof bits);
            const auto isOwn = reinterpret_cast<FourNumbers>(there == own);
            counts += isOwn & (1U | row << 8U | row * row << 16U);
            const FourWide own4 = __builtin_convertvector(reinterpret_cast<FourLanes>(bits & isOwn), FourWide);
            total += own4;
            upward += total;
            if constexpr (kSquares) squares += own4 * own4;
        }
        std::memcpy(&sums.counts[group * kLanesAtOnce], &counts, sizeof counts);
        std::memcpy(&sums.u[group * kLanesAtOnce], &total, sizeof total);
        std::memcpy(&sums.upward[group * kLanesAtOnce], &upward, sizeof upward);
        if constexpr (kSquares) std::memcpy(&sums.squares[group * kLanesAtOnce], &squares, sizeof squares);
    }
}

PlaneSums sumsOf(const ColumnSums& columns) {
    PlaneSums plane;
    double upward = 0;
    for (int column = 0; column < kWide; ++column) {
        const auto at = static_cast<std::size_t>(column);
        const int x = column - kPlaneReach;
        const auto n = static_cast<int>(columns.counts[at] & 0xffU);
        const auto rows = static_cast<int>(columns.counts[at] >> 8U & 0xffU);
        const auto squares = static_cast<int>(columns.counts[at] >> 16U);
        const int y = rows - n * kPlaneReach;
        plane.n += n;
        plane.x += x * n;
        plane.xx += x * x * n;
        plane.y += y;
        plane.xy += x * y;
        plane.yy += squares - 2 * kPlaneReach * rows + n * (kPlaneReach * kPlaneReach);
        plane.u += columns.u[at];
        plane.xu += x * columns.u[at];
        upward += columns.upward[at];
    }
    plane.yu = (kWide - kPlaneReach) * plane.u - upward;
    return plane;
}

} // namespace

double PlaneSums::height() const {
    if (n < kFewestForPlane) return u / n;
    const double a = xx + kRidge;
    const double d = yy + kRidge;
    const double minor = a * d - static_cast<double>(xy) * xy;
    const double cx = x * d - static_cast<double>(y) * xy;
    const double cy = y * a - static_cast<double>(x) * xy;
    const double determinant = n * minor - x * cx - y * cy;
    return (u * minor - xu * cx - yu * cy) / determinant;
}

PlaneSums planeSums(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own) {
    ColumnSums columns;
    vectorised<addColumns<false>>(segment, u, beams, own, columns);
    return sumsOf(columns);
}

FittedPlane fittedPlane(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own) {
    ColumnSums columns;
    vectorised<addColumns<true>>(segment, u, beams, own, columns);
    const PlaneSums sums = sumsOf(columns);
    FittedPlane plane{sums.n};
    if (sums.n == 0) return plane;
    plane.u = sums.height();
    if (sums.n < kFewestForPlane) return plane;
    const double a = sums.xx + kRidge;
    const double d = sums.yy + kRidge;
    // The normal equations without the height: each row minus the height times its count.
    const double xu = sums.xu - sums.x * plane.u;
    const double yu = sums.yu - sums.y * plane.u;
    const double minor = a * d - static_cast<double>(sums.xy) * sums.xy;
    plane.x = (xu * d - yu * sums.xy) / minor;
    plane.y = (yu * a - xu * sums.xy) / minor;
    double squares = 0;
    for (int column = 0; column < kWide; ++column) squares += columns.squares[static_cast<std::size_t>(column)];
    const double off = squares - plane.u * sums.u - plane.x * sums.xu - plane.y * sums.yu;
    plane.scatter = std::sqrt(std::max(0.0, off / sums.n));
    return plane;
}

} // namespace edgescan::rocks
