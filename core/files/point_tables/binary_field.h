// One scalar of a binary record: where it is and how it is stored.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace edgescan::files {

enum class Scalar : std::uint8_t { Int8, Int16, Int32, Int64, UInt8, UInt16, UInt32, UInt64, Float32, Float64 };

[[nodiscard]] constexpr std::size_t sizeOf(Scalar scalar) {
    switch (scalar) {
    case Scalar::Int8:
    case Scalar::UInt8:
        return 1;
    case Scalar::Int16:
    case Scalar::UInt16:
        return 2;
    case Scalar::Int32:
    case Scalar::UInt32:
    case Scalar::Float32:
        return 4;
    default:
        return 8;
    }
}

namespace binary {

template <class T>
[[nodiscard]] double as(const std::byte* at, bool bigEndian) {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), at, sizeof(T));
    if (bigEndian == (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
    return static_cast<double>(std::bit_cast<T>(bytes));
}

} // namespace binary

/// Calls visit(n, value) for the `count` numbers that are `stride` bytes from each other.
template <class Visit>
void forEachScalar(Scalar scalar, const std::byte* first, std::size_t stride, std::size_t count, bool bigEndian, Visit visit) {
    const auto all = [&]<class T>(T) {
        for (std::size_t n = 0; n < count; ++n) visit(n, binary::as<T>(first + n * stride, bigEndian));
    };
    switch (scalar) {
    case Scalar::Int8:
        return all(std::int8_t{});
    case Scalar::Int16:
        return all(std::int16_t{});
    case Scalar::Int32:
        return all(std::int32_t{});
    case Scalar::Int64:
        return all(std::int64_t{});
    case Scalar::UInt8:
        return all(std::uint8_t{});
    case Scalar::UInt16:
        return all(std::uint16_t{});
    case Scalar::UInt32:
        return all(std::uint32_t{});
    case Scalar::UInt64:
        return all(std::uint64_t{});
    case Scalar::Float32:
        return all(float{});
    case Scalar::Float64:
        return all(double{});
    }
}

/// The number at `at`; the caller has checked that sizeOf(scalar) bytes are there.
[[nodiscard]] inline double readScalar(Scalar scalar, const std::byte* at, bool bigEndian) {
    double number = 0;
    forEachScalar(scalar, at, 0, 1, bigEndian, [&number](std::size_t, double value) { number = value; });
    return number;
}

} // namespace edgescan::files
