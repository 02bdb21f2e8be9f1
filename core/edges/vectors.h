// Loops that are compiled twice, with the processor choosing: for any x86-64 and for AVX2. Both give the same bits: no operation is fused
// or reordered (-ffp-contract=off, no -ffast-math). Elsewhere, and under sanitizers that cannot bear the choosing, once.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define EDGESCAN_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define EDGESCAN_VECTORS
#endif
