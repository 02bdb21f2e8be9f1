// SHA-256 of bytes in memory or of a file, as lower-case hex (FIPS 180-4, through OpenSSL).
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace edgescan {

/// 64 lower-case hex digits.
[[nodiscard]] std::string sha256Hex(std::span<const std::byte> bytes);

/// The same for a file, read in pieces, so of any size. Error: no regular file, or it cannot be read.
Result<std::string> sha256OfFile(const std::filesystem::path& path);

} // namespace edgescan
