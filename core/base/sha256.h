// SHA-256 of bytes in memory or of a file, as lower-case hex (FIPS 180-4, through OpenSSL).
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

struct SHA256state_st; // OpenSSL's

namespace edgescan {

/// SHA-256 of bytes that arrive in pieces.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::span<const std::byte> bytes);
    /// 64 lower-case hex digits. Call add() only before this.
    [[nodiscard]] std::string hex();

private:
    std::unique_ptr<SHA256state_st> context_;
};

/// 64 lower-case hex digits.
[[nodiscard]] std::string sha256Hex(std::span<const std::byte> bytes);

/// The same for a file of any size, read in pieces. Error: not a regular file, or it cannot be read.
Result<std::string> sha256OfFile(const std::filesystem::path& path);

} // namespace edgescan
