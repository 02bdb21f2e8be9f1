// Products and sums of sizes that a file's header gives. They do not overflow: a size that is too large stays too large, and every check
// refuses it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>

namespace edgescan {

inline constexpr std::uint64_t kTooLarge = std::numeric_limits<std::uint64_t>::max();

/// The product, or kTooLarge if it does not fit into 64 bits.
[[nodiscard]] constexpr std::uint64_t productOf(std::initializer_list<std::uint64_t> factors) {
    std::uint64_t product = 1;
    bool large = false;
    for (const std::uint64_t factor : factors) {
        if (factor == 0) return 0;
        large = large || product > kTooLarge / factor;
        product *= factor;
    }
    return large ? kTooLarge : product;
}

/// The sum, or kTooLarge.
[[nodiscard]] constexpr std::uint64_t sumOf(std::initializer_list<std::uint64_t> terms) {
    std::uint64_t sum = 0;
    for (const std::uint64_t term : terms) sum = term > kTooLarge - sum ? kTooLarge : sum + term;
    return sum;
}

/// The most bytes that so many packed bytes may unpack to, for every compression. Scans shrink by a factor of ten, zip bombs by a thousand.
/// The constant term allows small files of equal values.
[[nodiscard]] constexpr std::uint64_t mostUnpackedBytes(std::uint64_t packed) {
    constexpr std::uint64_t kAlways = 8U << 20U;
    constexpr std::uint64_t kPerByte = 64;
    return sumOf({kAlways, productOf({packed, kPerByte})});
}

} // namespace edgescan
