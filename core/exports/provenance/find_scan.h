// Finds the file that an export was made from by what it holds, wherever it was moved and however it is called now.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace edgescan::exports {

/// The file with this SHA-256: first under its old name beside the export, then any file beside it, then any file under `scansFolder`.
Result<std::filesystem::path> findScan(const std::string& sha256, const std::string& oldName, const std::filesystem::path& exported,
                                       const std::optional<std::filesystem::path>& scansFolder);

} // namespace edgescan::exports
