// Makes an export again from its record and says whether it is the same, byte for byte.
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::exports {

struct Verification {
    bool identical = false;                       ///< the export, its record and what the scan gives are one
    std::filesystem::path exported;               ///< what was verified
    std::filesystem::path scan;                   ///< what it was made from again
    std::optional<std::uint64_t> firstDifference; ///< byte of the export, from 0
    std::vector<std::string> findings;            ///< sentences: what differs, and what may explain it
    std::vector<std::string> remarks;             ///< what is otherwise and no difference: a picture packed by another zlib
    std::string expectedSha256, foundSha256;      ///< of the export made again and of the one on the disk
};

/// The scan is looked for by its SHA-256 beside the export and, where given, anywhere under `scansFolder`. Error: no record, the record
/// was altered everywhere, no such scan, the scan cannot be opened.
Result<Verification> verifyExport(const std::filesystem::path& exported, const std::optional<std::filesystem::path>& scansFolder = {});

/// One line for a person: "edges.pcd: identical to ..." or what differs.
[[nodiscard]] std::string verificationText(const Verification& verification);
[[nodiscard]] nlohmann::ordered_json verificationReport(const Verification& verification);

} // namespace edgescan::exports
