// Loops that are compiled several times: for any x86-64, for AVX2, and for AVX-512 (x86-64-v4) if the compiler supports it. The processor
// chooses at run time. All versions give the same bits: no operation is fused or reordered (-ffp-contract=off, no -ffast-math). On other
// processors, and under sanitizers that do not support this choice, the loop is compiled once.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>

#if !defined(__x86_64__) || !defined(__GNUC__) || defined(__clang__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EDGESCAN_SIMD
#define EDGESCAN_SIMD_WIDE false
#elif __GNUC__ >= 12
#define EDGESCAN_SIMD __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#define EDGESCAN_SIMD_WIDE __builtin_cpu_supports("avx2")
#else
#define EDGESCAN_SIMD __attribute__((target_clones("avx2", "default")))
#define EDGESCAN_SIMD_WIDE __builtin_cpu_supports("avx2")
#endif

namespace edgescan {

/// Cells of a line that are processed together, for loops over a line that the compiler alone cannot vectorise: sixteen if the processor
/// has EDGESCAN_SIMD_WIDE, otherwise four, because a wider vector would be processed cell by cell.
using FourLanes = float __attribute__((vector_size(16)));
using SixteenLanes = float __attribute__((vector_size(64)));
inline constexpr int kMostLanes = 16;
template <class Lanes>
inline constexpr int kLanes = sizeof(Lanes) / sizeof(float);

template <class Lanes>
inline __attribute__((always_inline)) void load(Lanes& lanes, const float* from) {
    std::memcpy(&lanes, from, sizeof lanes);
}
template <class Lanes>
inline __attribute__((always_inline)) void store(float* to, const Lanes& lanes) {
    std::memcpy(to, &lanes, sizeof lanes);
}
/// The largest of `kCount` values (a power of two), found by halving.
template <int kCount>
inline __attribute__((always_inline)) float largest(const float* values) {
    if constexpr (kCount == 1) {
        return *values;
    } else {
        std::array<float, kCount / 2> larger;
        for (int n = 0; n < kCount / 2; ++n) larger[n] = std::max(values[n], values[n + kCount / 2]);
        return largest<kCount / 2>(larger.data());
    }
}

} // namespace edgescan
