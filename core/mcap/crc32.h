// CRC-32 as MCAP, zip and PNG use it (reflected polynomial EDB88320).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace edgescan {

/// `before` is the CRC of the bytes that came earlier, so that a long run can be summed piece by piece.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

} // namespace edgescan
