// Checks whether a log is as it was written. If it is not, lists the wrong lines.
#pragma once

#include "core/base/audit_log/audit_log.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan {

enum class AuditFaultKind : std::uint8_t {
    Altered, ///< the bytes of the line were changed
    Dropped, ///< lines were deleted
    Moved,   ///< the line is at another place than where it was written, or it is there twice
};
/// "altered", "dropped", "moved".
[[nodiscard]] const char* auditFaultName(AuditFaultKind kind);

struct AuditFault {
    AuditFaultKind kind = AuditFaultKind::Altered;
    std::uint64_t place = 0; ///< line of the file, from 1; for deleted lines: the line behind the gap
    std::uint64_t n = 0;     ///< "n" of the line; for deleted lines: "n" of the first of them; 0: unknown
    std::string sentence;
};

struct AuditCheck {
    std::uint64_t lines = 0; ///< lines that are complete and unchanged
    std::string
        last; ///< "sha256" of the last of these lines. If the operator notes it elsewhere, it shows later whether the end is missing.
    std::uint64_t recovered = 0; ///< lines that a crash tore, as the log itself records
    std::vector<AuditFault> faults;
};

/// `expectedLast` (may be empty): a hash that was noted elsewhere. If the log does not contain it, the end of the log is missing. Error:
/// the file cannot be read.
Result<AuditCheck> checkAudit(const std::filesystem::path& path, const std::string& expectedLast = {});

} // namespace edgescan
