// What was done with scans, line by line, so that a later change of a line shows (docs/audit.md).
#pragma once

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgescan {

/// "before" of the first line.
inline constexpr const char* kNoLineBefore = "0000000000000000000000000000000000000000000000000000000000000000";
/// Of the line that goes on behind one that a crash or a power cut tore: "details" hold its length, "torn_bytes".
inline constexpr const char* kRecoveredEvent = "recovered";

/// What a line holds: {"n": 1, "utc": "...", "event": "...", "details": {...}, "before": HASH, "sha256": HASH}. "before" is the "sha256" of
/// the line before, and "sha256" that of the bytes of the line up to the comma before it.
struct AuditLine {
    std::uint64_t n = 0; ///< from 1
    std::string utc, event;
    nlohmann::ordered_json details;
    std::string before, sha256;
};

/// The line without its line feed.
[[nodiscard]] std::string auditText(const AuditLine& line);
/// Error: it is no such line, or its bytes do not have its hash.
Result<AuditLine> auditLine(std::string_view text, const std::string& where);

/// Appends to one file; several programs may do so at the same time. Nothing is ever taken out or written over.
class AuditLog {
public:
    explicit AuditLog(std::filesystem::path path) : path_(std::move(path)) {}

    /// Is on the disk when it returns. Error: the disk is full, no right to write, the last line is none of a log.
    Result<Done> append(const std::string& event, const nlohmann::ordered_json& details) const;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace edgescan
