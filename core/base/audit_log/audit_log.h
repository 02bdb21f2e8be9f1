// A log of all actions on scans. Each line holds the hash of the line before, so that a later change of a line is detected
// (docs/reference/audit.md).
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
/// Event of the line that follows a line torn by a crash or a power failure. Its "details" hold the length of the torn line, "torn_bytes".
inline constexpr const char* kRecoveredEvent = "recovered";

/// One line: {"n": 1, "utc": "...", "event": "...", "details": {...}, "before": HASH, "sha256": HASH}. "before" is the "sha256" of the line
/// before. "sha256" is the hash of the bytes of the line up to the comma before "sha256".
struct AuditLine {
    std::uint64_t n = 0; ///< from 1
    std::string utc, event;
    nlohmann::ordered_json details;
    std::string before, sha256;
};

/// The line as text, without its line feed.
[[nodiscard]] std::string auditText(const AuditLine& line);
/// Reads one line. Error: not a line of a log, or its bytes do not match its hash.
Result<AuditLine> auditLine(std::string_view text, const std::string& where);

/// Appends to one file. Several programs may append at the same time. Existing lines are never removed or overwritten.
class AuditLog {
public:
    explicit AuditLog(std::filesystem::path path) : path_(std::move(path)) {}

    /// Returns when the line is on the disk. Error: the disk is full, no right to write, the last line is not a line of a log.
    Result<Done> append(const std::string& event, const nlohmann::ordered_json& details) const;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace edgescan
