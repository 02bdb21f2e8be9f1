// CRC-32, eight bytes at a step.
#include "core/live/crc32.h"

#include <array>

namespace edgescan {
namespace {

constexpr std::size_t kStep = 8;
using Tables = std::array<std::array<std::uint32_t, 256>, kStep>;

constexpr Tables makeTables() {
    Tables tables{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
        tables[0][n] = c;
    }
    for (std::size_t t = 1; t < kStep; ++t) {
        for (std::size_t n = 0; n < 256; ++n) tables[t][n] = tables[0][tables[t - 1][n] & 255U] ^ (tables[t - 1][n] >> 8U);
    }
    return tables;
}
constexpr Tables kTables = makeTables();

} // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before) {
    std::uint32_t c = ~before;
    const auto at = [&](std::size_t i) { return std::uint32_t{bytes[i]}; };
    while (bytes.size() >= kStep) {
        c ^= at(0) | at(1) << 8U | at(2) << 16U | at(3) << 24U;
        c = kTables[7][c & 255U] ^ kTables[6][c >> 8U & 255U] ^ kTables[5][c >> 16U & 255U] ^ kTables[4][c >> 24U] ^ kTables[3][at(4)] ^
            kTables[2][at(5)] ^ kTables[1][at(6)] ^ kTables[0][at(7)];
        bytes = bytes.subspan(kStep);
    }
    for (const std::uint8_t b : bytes) c = kTables[0][(c ^ b) & 255U] ^ (c >> 8U);
    return ~c;
}

} // namespace edgescan
