// Cells that are computed at once, one per lane of vectors. A lane has the same bits wherever it is.
#pragma once

#include "core/base/simd.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

// How vectors are returned does not matter: all functions with vectors are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace edgescan::rocks {

inline constexpr std::size_t kCellsAtOnce = 16;
template <class T>
using Lanes = std::array<T, kCellsAtOnce>;

/// The lanes of one vector, from `lane` on.
template <class Vector>
struct At {
    using Numbers = decltype(Vector{} < Vector{}); ///< a mask has all bits of a lane, or no bits
    std::size_t lane;

    EDGESCAN_INLINE Vector operator()(const Lanes<float>& lanes) const {
        Vector vector;
        load(vector, lanes.data() + lane);
        return vector;
    }
    template <class Number>
    EDGESCAN_INLINE Numbers operator()(const Lanes<Number>& lanes) const {
        Numbers numbers;
        std::memcpy(&numbers, lanes.data() + lane, sizeof numbers);
        return numbers;
    }
    EDGESCAN_INLINE void put(Lanes<float>& lanes, const Vector& vector) const { store(lanes.data() + lane, vector); }
    template <class Number>
    EDGESCAN_INLINE void put(Lanes<Number>& lanes, const Numbers& numbers) const {
        std::memcpy(lanes.data() + lane, &numbers, sizeof numbers);
    }
};

template <class Vector>
EDGESCAN_INLINE Vector absolute(const Vector& x) {
    return reinterpret_cast<Vector>(reinterpret_cast<typename At<Vector>::Numbers>(x) & INT32_MAX);
}
template <class Vector>
EDGESCAN_INLINE Vector smaller(const Vector& x, const Vector& y) {
    return y < x ? y : x;
}
template <class Vector>
EDGESCAN_INLINE Vector larger(const Vector& x, const Vector& y) {
    return x < y ? y : x;
}
template <class Vector>
EDGESCAN_INLINE Vector clipped(const Vector& x, float least, float most) {
    return x < least ? Vector{} + least : x > most ? Vector{} + most : x;
}
/// x where the mask is, otherwise 0.
template <class Vector>
EDGESCAN_INLINE Vector where(const typename At<Vector>::Numbers& mask, const Vector& x) {
    return reinterpret_cast<Vector>(reinterpret_cast<typename At<Vector>::Numbers>(x) & mask);
}
/// x where the mask is, otherwise y; by bits: compilers take a choice by a stored mask apart, lane by lane.
template <class Vector>
EDGESCAN_INLINE Vector chosen(const typename At<Vector>::Numbers& mask, const Vector& x, const Vector& y) {
    return reinterpret_cast<Vector>((reinterpret_cast<typename At<Vector>::Numbers>(x) & mask) |
                                    (reinterpret_cast<typename At<Vector>::Numbers>(y) & ~mask));
}

} // namespace edgescan::rocks
