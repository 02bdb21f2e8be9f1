// The scans of a session as JSON: kind, paths, hash, reading options; and the place of each layer.
#pragma once

#include "core/base/json_fields.h"
#include "core/inspect/session_file/viewer_state.h"

namespace edgescan::inspect {

[[nodiscard]] nlohmann::ordered_json sessionScanJson(const SessionScan& scan, const std::filesystem::path& folder);

struct PlacedSessionScan {
    SessionScan scan;                          ///< with the most likely of the paths
    std::vector<std::filesystem::path> places; ///< all paths, the most likely first
};
[[nodiscard]] nlohmann::ordered_json layersJson(const std::vector<Layer>& layers, const std::filesystem::path& folder);
/// Error: those of sessionFromText().
Result<std::vector<Layer>> layersFrom(JsonFields& fields, const char* key, const std::filesystem::path& folder, const std::string& where);

/// Error: those of sessionFromText().
Result<PlacedSessionScan> sessionScanFrom(JsonFields fields, const std::filesystem::path& folder, const std::string& where);

} // namespace edgescan::inspect
