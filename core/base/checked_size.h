// Sizes that files promise, multiplied and added without wrapping round: what is too large stays too large, and every check refuses it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>

namespace edgescan {

inline constexpr std::uint64_t kTooLarge = std::numeric_limits<std::uint64_t>::max();

/// The product, or kTooLarge where 64 bits do not hold it.
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

/// Bytes that so many packed bytes may unpack to, whatever the packing: scans shrink tenfold, bombs a thousandfold. The constant lets small
/// files of much the same through.
[[nodiscard]] constexpr std::uint64_t mostUnpackedBytes(std::uint64_t packed) {
    constexpr std::uint64_t kAlways = 8U << 20U;
    constexpr std::uint64_t kPerByte = 64;
    return sumOf({kAlways, productOf({packed, kPerByte})});
}

} // namespace edgescan
