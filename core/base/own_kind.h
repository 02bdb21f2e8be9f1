// Which of EdgeScan's kinds of JSON a file is, or PNG. A file of one kind is never replaced by one of another.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace edgescan {

/// "edgescan-raw-grid" of {"format": "edgescan-raw-grid/1", ...}; reports have "schema". Of several lines the first counts. "PNG" of a
/// picture. Empty: the text is not of EdgeScan.
[[nodiscard]] std::string ownKind(std::string_view text);

/// Error if the file is there, holds something, and is not of this kind. Empty: any file that is not of EdgeScan.
[[nodiscard]] Result<Done> checkIsOfKind(const std::filesystem::path& path, const std::string& kind);

} // namespace edgescan
