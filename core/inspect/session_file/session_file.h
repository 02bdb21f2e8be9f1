// The session file: the viewer's state as JSON (docs/guide/sessions.md).
#pragma once

#include "core/base/result.h"
#include "core/inspect/session_file/viewer_state.h"

#include <string_view>

namespace edgescan::inspect {

inline constexpr const char* kSessionEnding = ".edgescan-session.json";

/// The text of a session file in `folder`. Paths in or below the folder above `folder` are stored both relative to `folder` and absolute;
/// other paths only absolute. `savedUtc`: ISO 8601, or empty.
[[nodiscard]] std::string sessionText(const ViewerState& state, const std::filesystem::path& folder, const std::string& savedUtc);

/// The content of a session file, and the possible places of its scan.
struct ReadSession {
    ViewerState state;
    std::string savedUtc;
    std::vector<std::filesystem::path> places; ///< of the scan, the most likely first; empty for the demo
};
/// `folder`: of the file, for its relative paths. Error: damaged, another format, unknown keys, cells that the scan does not have, numbers
/// out of bounds. A faulty file is never partly loaded.
Result<ReadSession> sessionFromText(std::string_view text, const std::filesystem::path& folder, const std::string& where);
/// The same from a file.
Result<ReadSession> readSession(const std::filesystem::path& path);
/// Whether the file is JSON that names the format of sessions, whatever its own name is; the rest of it may be damaged.
[[nodiscard]] bool isSession(const std::filesystem::path& path);

} // namespace edgescan::inspect
