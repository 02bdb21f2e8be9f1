// The scan of a session as JSON: kind, paths, hash, reading options.
#pragma once

#include "core/base/json_fields.h"
#include "core/inspect/session_file/viewer_state.h"

namespace edgescan::inspect {

[[nodiscard]] nlohmann::ordered_json sessionScanJson(const SessionScan& scan, const std::filesystem::path& folder);

struct PlacedSessionScan {
    SessionScan scan;                          ///< with the most likely of the paths
    std::vector<std::filesystem::path> places; ///< all paths, the most likely first
};
/// Error: those of sessionFromText().
Result<PlacedSessionScan> sessionScanFrom(JsonFields fields, const std::filesystem::path& folder, const std::string& where);

} // namespace edgescan::inspect
