// Finds the file that an export was made from by its content, even if it was moved or renamed.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace edgescan::exports {

/// The file with this SHA-256 that `isIt` accepts: first the one with its old name in the folder of the export, then any file in this
/// folder, then any file under `scansFolder`. Files of other descriptions may have the same bytes: where `isIt` accepts none, the first.
Result<std::filesystem::path> findScan(const std::string& sha256, const std::string& oldName, const std::filesystem::path& exported,
                                       const std::optional<std::filesystem::path>& scansFolder,
                                       const std::function<bool(const std::filesystem::path&)>& isIt);

} // namespace edgescan::exports
