// Loops that are compiled several times, with the processor choosing: for any x86-64, for AVX2, and for AVX-512 (x86-64-v4) where the
// compiler can. All give the same bits: no operation is fused or reordered (-ffp-contract=off, no -ffast-math). Elsewhere, and under
// sanitizers that cannot bear the choosing, once.
#pragma once

#include <cstring>

#if !defined(__x86_64__) || !defined(__GNUC__) || defined(__clang__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EDGESCAN_VECTORS
#elif __GNUC__ >= 12
#define EDGESCAN_VECTORS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define EDGESCAN_VECTORS __attribute__((target_clones("avx2", "default")))
#endif

namespace edgescan {

/// Cells of a line that are worked on together, where a loop over a line cannot be made vectors of by the compiler alone.
inline constexpr int kLanes = 8;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));

inline __attribute__((always_inline)) void load(Lanes& lanes, const float* from) { std::memcpy(&lanes, from, sizeof lanes); }
inline __attribute__((always_inline)) void store(float* to, const Lanes& lanes) { std::memcpy(to, &lanes, sizeof lanes); }

} // namespace edgescan
