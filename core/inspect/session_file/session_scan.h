// The scan of a session as JSON: kind, paths, hash, how it is read.
#pragma once

#include "core/base/json_fields.h"
#include "core/inspect/session_file/session_file.h"

namespace edgescan {

[[nodiscard]] nlohmann::ordered_json sittingScanJson(const SittingScan& scan, const std::filesystem::path& folder);

struct PlacedSittingScan {
    SittingScan scan;                          ///< with the likeliest of the paths
    std::vector<std::filesystem::path> places; ///< all, the likeliest first
};
/// Error: as sittingFromText().
Result<PlacedSittingScan> sittingScanFrom(JsonFields fields, const std::filesystem::path& folder, const std::string& where);

} // namespace edgescan
