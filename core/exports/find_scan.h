// Finds the file that an export was made from by its content, even if it was moved or renamed.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace edgescan::exports {

/// The file with this SHA-256: first the one with its old name in the folder of the export, then any file in this folder, then any file
/// under `scansFolder`.
Result<std::filesystem::path> findScan(const std::string& sha256, const std::string& oldName, const std::filesystem::path& exported,
                                       const std::optional<std::filesystem::path>& scansFolder);

} // namespace edgescan::exports
