// The fewest decimals are those with which the nearest decimal number is still nearer to this float than half a step to the next. A float
// has 24 bits, so with up to 10 decimals (24 bits of powers of five) its multiple is exact as double, and so are the comparisons. Where a
// comparison is a tie, the library decides.
#include "core/files/point_tables/float_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace edgescan::files {
namespace {

constexpr int kLeastPower = -10, kMostPower = 16; // of two: from 0.001 to 131072
constexpr int kMostDecimals = 10;
constexpr std::array<double, kMostDecimals + 1> kTens{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10};
constexpr std::array<std::uint64_t, kMostDecimals + 1> kWholeTens{1,       10,       100,       1000,       10000,      100000,
                                                                  1000000, 10000000, 100000000, 1000000000, 10000000000};

constexpr double powerOfTwo(int power) { return std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52U); }
constexpr double halfStep(int power) { return powerOfTwo(power - 24); } // to the next float

// By power of two: so many decimals distinguish every float.
constexpr auto kEnough = [] {
    std::array<std::uint8_t, kMostPower - kLeastPower + 1> enough{};
    for (int power = kLeastPower; power <= kMostPower; ++power) {
        std::size_t decimals = 0;
        while (halfStep(power) * kTens[decimals] <= 0.5) ++decimals;
        enough[static_cast<std::size_t>(power - kLeastPower)] = static_cast<std::uint8_t>(decimals);
    }
    return enough;
}();

// Eight digits as text, zeros before them, the first in the lowest byte: fours of digits, pairs of them and digits side by side.
std::uint64_t eightDigits(std::uint32_t number) {
    const std::uint64_t fours = number / 10000U | std::uint64_t{number % 10000U} << 32U;
    const std::uint64_t hundreds = (fours * 10486U >> 20U) & 0x0000007F0000007FU;
    const std::uint64_t pairs = hundreds | (fours - 100U * hundreds) << 16U;
    const std::uint64_t tens = (pairs * 103U >> 10U) & 0x000F000F000F000FU;
    return (tens | (pairs - 10U * tens) << 8U) | 0x3030303030303030U;
}

// The last `digits` of the eight.
void writeLast(char* to, std::uint64_t eight, std::size_t digits) {
    eight >>= 8U * (8U - digits);
    if constexpr (std::endian::native == std::endian::big) eight = __builtin_bswap64(eight);
    std::memcpy(to, &eight, sizeof eight);
}

// The value times ten to the power of `decimals`, as a whole number.
struct Multiple {
    std::uint64_t number;
    bool tells; // the float from all others
    bool tie;

    Multiple(double value, double half, std::size_t decimals) {
        const double exact = value * kTens[decimals], most = half * kTens[decimals];
        number = static_cast<std::uint64_t>(static_cast<std::int64_t>(exact + 0.5));
        const double off = std::abs(exact - static_cast<double>(static_cast<std::int64_t>(number)));
        tells = off < most;
        tie = off == 0.5 || off == most;
    }
};

struct Decimal {
    std::uint64_t number = 0;
    std::size_t decimals = 0;
};

// False where the library is to decide.
bool fewestDecimals(double value, int power, Decimal& decimal) {
    const double half = halfStep(power);
    const std::size_t enough = kEnough[static_cast<std::size_t>(power - kLeastPower)]; // two and more
    const Multiple most(value, half, enough), less(value, half, enough - 1), least(value, half, enough - 2);
    if (most.tie || less.tie || least.tie) return false;
    decimal = {less.tells ? less.number : most.number, enough - (less.tells ? 1 : 0)}; // as often the one as the other: no jump
    if (!least.tells) return true;
    decimal = {least.number, enough - 2};
    while (decimal.decimals > 0) {
        const Multiple next(value, half, decimal.decimals - 1);
        if (next.tie) return false;
        if (!next.tells) return true;
        decimal = {next.number, decimal.decimals - 1};
    }
    return true;
}

} // namespace

char* writeFloat(char* to, char* end, float value) {
    constexpr float kLeast = 0.001F, kMost = 99999; // beyond, an exponent may be shorter
    const float size = std::abs(value);
    const auto bits = std::bit_cast<std::uint32_t>(size);
    const bool isPower = (bits & 0x7FFFFFU) == 0; // the step below it is smaller
    Decimal decimal;
    if (!(size >= kLeast && size <= kMost) || isPower ||
        !fewestDecimals(static_cast<double>(size), static_cast<int>(bits >> 23U) - 127, decimal))
        return std::to_chars(to, end, value).ptr;
    *to = '-';
    to += value < 0 ? 1 : 0;
    // Never rounded up to the next whole number, which would be printed with fewer decimals.
    const auto whole = static_cast<std::uint32_t>(size);
    const std::uint64_t part = decimal.number - whole * kWholeTens[decimal.decimals];
    const std::size_t digits =
        1U + (whole >= 10 ? 1U : 0U) + (whole >= 100 ? 1U : 0U) + (whole >= 1000 ? 1U : 0U) + (whole >= 10000 ? 1U : 0U);
    writeLast(to, eightDigits(whole), digits);
    to += digits;
    *to = '.';
    if (decimal.decimals <= 8) {
        writeLast(to + 1, eightDigits(static_cast<std::uint32_t>(part * kWholeTens[8 - decimal.decimals])), 8);
    } else {
        const std::size_t more = decimal.decimals - 8;
        writeLast(to + 1, eightDigits(static_cast<std::uint32_t>(part / kWholeTens[more])), 8);
        writeLast(to + 9, eightDigits(static_cast<std::uint32_t>(part % kWholeTens[more])), more);
    }
    return to + decimal.decimals + (decimal.decimals > 0 ? 1 : 0);
}

} // namespace edgescan::files
