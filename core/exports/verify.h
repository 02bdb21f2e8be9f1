// Makes an export again from its record, and reports whether it is the same, byte for byte.
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
    bool identical = false;                       ///< the export, its record and the files made again agree
    std::filesystem::path exported;               ///< the verified file
    std::filesystem::path scan;                   ///< the scan from which it was made again
    std::optional<std::uint64_t> firstDifference; ///< first differing byte of the export, from 0
    std::vector<std::string> damage;              ///< sentences: a record that was altered, which says nothing about the export
    std::vector<std::string> findings;            ///< sentences: the differences, and possible reasons
    std::vector<std::string> remarks;             ///< differences that do not count: a picture compressed by another zlib
    std::string expectedSha256, foundSha256;      ///< of the export made again, and of the one on the disk
};

/// A report as a page, a document or JSON: no record is written for it, and it cannot be made again.
[[nodiscard]] bool isReport(const std::filesystem::path& file);

/// The scan is searched by its SHA-256 in the folder of the export and, if given, in all folders under `scansFolder`. Error: the record is
/// missing, all copies of the record were altered, the scan was not found, the scan cannot be opened.
Result<Verification> verifyExport(const std::filesystem::path& exported, const std::optional<std::filesystem::path>& scansFolder = {});

/// One line for a person: "edges.pcd: identical to ..." or the differences.
[[nodiscard]] std::string verificationText(const Verification& verification);
[[nodiscard]] nlohmann::ordered_json verificationReport(const Verification& verification);

} // namespace edgescan::exports
