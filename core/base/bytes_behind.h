// What a reader says of bytes that follow everything it reads.
#pragma once

#include "core/base/number_text.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace edgescan {

/// Zeros up to the end of a page are padding: PCL and tapes write them.
[[nodiscard]] inline bool isPadding(std::span<const std::byte> rest) {
    constexpr std::size_t kLargestPage = 65536;
    return rest.size() < kLargestPage && std::ranges::all_of(rest, [](std::byte byte) { return byte == std::byte{0}; });
}

/// "12 bytes behind the points were not read."; empty where there are none, or padding. `what`: "the points".
[[nodiscard]] inline std::optional<std::string> bytesBehind(std::span<const std::byte> rest, const std::string& what) {
    if (isPadding(rest)) return std::nullopt;
    return withValues(counted(rest.size(), "byte behind %1 was not read.", "bytes behind %1 were not read."), {what});
}

} // namespace edgescan
