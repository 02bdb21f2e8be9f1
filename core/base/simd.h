// Loops that are compiled once for each instruction set, and called for the one that the process uses (core/base/instruction_set.h). All
// versions give the same bits: no operation is fused or reordered (-ffp-contract=off, no -ffast-math).
#pragma once

#include "core/base/instruction_set.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

/// Before each function that is a part of a loop: the compiler compiles it inside every version of the loop.
#define EDGESCAN_INLINE inline __attribute__((always_inline))

#if defined(__x86_64__) && defined(__GNUC__)
#define EDGESCAN_SSE42 __attribute__((target("sse4.2,popcnt")))
#define EDGESCAN_AVX2 __attribute__((target("avx2,bmi")))
#if defined(__clang__)
#define EDGESCAN_AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,bmi")))
#else
#define EDGESCAN_AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,bmi,prefer-vector-width=512")))
#endif
#endif

namespace edgescan {

/// A loop, declared with EDGESCAN_INLINE, in one version for each instruction set. Wider registers may have loops of their own.
template <auto kLoop, auto kOfAvx2 = kLoop, auto kOfAvx512 = kOfAvx2>
class Vectorised;
template <class R, class... A, R (*kLoop)(A...), R (*kOfAvx2)(A...), R (*kOfAvx512)(A...)>
class Vectorised<kLoop, kOfAvx2, kOfAvx512> {
public:
    R operator()(A... a) const { return by(instructionSet(), a...); }
    R by(InstructionSet set, A... a) const { return kVersions[static_cast<std::size_t>(set)](a...); }

private:
    static R plain(A... a) { return kLoop(a...); }
#if defined(__x86_64__) && defined(__GNUC__)
    EDGESCAN_SSE42 static R sse42(A... a) { return kLoop(a...); }
    EDGESCAN_AVX2 static R avx2(A... a) { return kOfAvx2(a...); }
    EDGESCAN_AVX512 static R avx512(A... a) { return kOfAvx512(a...); }
    static constexpr std::array<R (*)(A...), kInstructionSets.size()> kVersions{plain, sse42, avx2, avx512};
#else
    static constexpr std::array<R (*)(A...), 1> kVersions{plain};
#endif
};
/// Calls a loop: vectorised<loop>(arguments).
template <auto kLoop, auto kOfAvx2 = kLoop, auto kOfAvx512 = kOfAvx2>
inline constexpr Vectorised<kLoop, kOfAvx2, kOfAvx512> vectorised;

/// Cells of a line that are processed together, for loops over a line that the compiler alone cannot vectorise: as many as a register of
/// the instruction set holds, because the compiler takes a wider vector apart and processes it cell by cell.
using FourLanes = float __attribute__((vector_size(16)));
using EightLanes = float __attribute__((vector_size(32)));
using SixteenLanes = float __attribute__((vector_size(64)));
template <class Lanes>
inline constexpr int kLanes = sizeof(Lanes) / sizeof(float);

template <class Lanes>
EDGESCAN_INLINE void load(Lanes& lanes, const float* from) {
    std::memcpy(&lanes, from, sizeof lanes);
}
template <class Lanes>
EDGESCAN_INLINE void store(float* to, const Lanes& lanes) {
    std::memcpy(to, &lanes, sizeof lanes);
}
/// The largest of `kCount` values (a power of two), found by halving.
template <int kCount>
EDGESCAN_INLINE float largest(const float* values) {
    if constexpr (kCount == 1) {
        return *values;
    } else {
        std::array<float, kCount / 2> larger;
        for (int n = 0; n < kCount / 2; ++n) larger[n] = std::max(values[n], values[n + kCount / 2]);
        return largest<kCount / 2>(larger.data());
    }
}

} // namespace edgescan
