// Floats as text: identical to the standard library.
#include "core/files/point_tables/float_text.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace edgescan::files {
namespace {

std::string ours(float value) {
    std::array<char, 64> room{};
    return {room.data(), writeFloat(room.data(), room.data() + room.size(), value)};
}

std::string library(float value) {
    std::array<char, 64> room{};
    return {room.data(), std::to_chars(room.data(), room.data() + room.size(), value).ptr};
}

TEST(FloatText, IsThatOfTheLibraryAtBorders) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float value :
         {0.0F,      0.001F,   0.1F,      0.5F, 1.0F,      2.0F,  9.5F,  9.999999F,   10.0F, 99.99999F, 1000.0F, 4980.5F,  9999.999F,
          99998.99F, 99999.0F, 99999.01F, 1e5F, 123456.7F, 1e-4F, 3e-5F, 16777216.0F, 1e10F, 1e38F,     1e-40F,  kInfinity}) {
        for (const float near : {value, std::nextafter(value, kInfinity), std::nextafter(value, -kInfinity)}) {
            EXPECT_EQ(ours(near), library(near));
            EXPECT_EQ(ours(-near), library(-near));
        }
    }
}

TEST(FloatText, IsThatOfTheLibraryOfEverySize) {
    std::mt19937_64 random(16);
    for (int n = 0; n < 2000000; ++n) {
        // From 2^-12 to 2^18: the whole range of the fast path, and its surroundings.
        const auto power = static_cast<std::uint32_t>(115 + random() % 31);
        const float value = std::bit_cast<float>(power << 23U | static_cast<std::uint32_t>(random() & 0x807FFFFFU));
        ASSERT_EQ(ours(value), library(value)) << n;
    }
}

TEST(FloatText, IsThatOfTheLibraryWhereDecimalsAreFew) {
    for (int n = -300000; n <= 300000; ++n) {
        for (const double part : {1.0, 10.0, 100.0, 1000.0, 16.0, 1024.0}) {
            const auto value = static_cast<float>(n / part);
            ASSERT_EQ(ours(value), library(value)) << n << " / " << part;
        }
    }
}

} // namespace
} // namespace edgescan::files
