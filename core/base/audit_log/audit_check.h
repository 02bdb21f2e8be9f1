// Whether a log is as it was written, and if not, which lines are wrong.
#pragma once

#include "core/base/audit_log/audit_log.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan {

enum class AuditFaultKind : std::uint8_t {
    Altered, ///< its bytes are not those that were written
    Dropped, ///< lines that were there are gone
    Moved,   ///< it stands at another place than where it was written, or twice
};
/// "altered", "dropped", "moved".
[[nodiscard]] const char* auditFaultName(AuditFaultKind kind);

struct AuditFault {
    AuditFaultKind kind = AuditFaultKind::Altered;
    std::uint64_t place = 0; ///< line of the file, from 1; of what is gone: the line behind it
    std::uint64_t n = 0;     ///< "n" of the line; of what is gone: of the first of it; 0: not known
    std::string sentence;
};

struct AuditCheck {
    std::uint64_t lines = 0;     ///< whole and as they were written
    std::string last;            ///< "sha256" of the last of them: noted elsewhere, it shows later whether the end is missing
    std::uint64_t recovered = 0; ///< lines that a crash tore, as the log itself says
    std::vector<AuditFault> faults;
};

/// `expectedLast` (may be empty): a hash that was noted elsewhere; a log without it lacks its end. Error: the file cannot be read.
Result<AuditCheck> checkAudit(const std::filesystem::path& path, const std::string& expectedLast = {});

} // namespace edgescan
