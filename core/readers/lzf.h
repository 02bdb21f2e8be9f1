// LZF as in liblzf (Marc Lehmann): what "binary_compressed" PCD files are packed with.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace edgescan {

/// Unpacks into exactly `size` bytes. Empty when the packed bytes are damaged or give another size.
[[nodiscard]] std::vector<std::byte> unpackLzf(std::span<const std::byte> packed, std::size_t size);

/// No packing makes a byte stand for more than this many.
inline constexpr std::size_t kMostPerPackedByte = 132;

} // namespace edgescan
