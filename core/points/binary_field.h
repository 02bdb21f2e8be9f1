// One scalar of a binary record: where it lies and how it is stored.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace edgescan {

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
    std::byte bytes[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
        bytes[i] = at[bigEndian == (std::endian::native == std::endian::little) ? sizeof(T) - 1 - i : i];
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
}

} // namespace binary

/// The number at `at`; the caller has checked that sizeOf(scalar) bytes are there.
[[nodiscard]] inline double readScalar(Scalar scalar, const std::byte* at, bool bigEndian) {
    switch (scalar) {
    case Scalar::Int8:
        return binary::as<std::int8_t>(at, bigEndian);
    case Scalar::Int16:
        return binary::as<std::int16_t>(at, bigEndian);
    case Scalar::Int32:
        return binary::as<std::int32_t>(at, bigEndian);
    case Scalar::Int64:
        return binary::as<std::int64_t>(at, bigEndian);
    case Scalar::UInt8:
        return binary::as<std::uint8_t>(at, bigEndian);
    case Scalar::UInt16:
        return binary::as<std::uint16_t>(at, bigEndian);
    case Scalar::UInt32:
        return binary::as<std::uint32_t>(at, bigEndian);
    case Scalar::UInt64:
        return binary::as<std::uint64_t>(at, bigEndian);
    case Scalar::Float32:
        return binary::as<float>(at, bigEndian);
    case Scalar::Float64:
        return binary::as<double>(at, bigEndian);
    }
    return 0.0;
}

} // namespace edgescan
