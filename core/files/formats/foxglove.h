// What the reader and the writer of clouds for Foxglove and Lichtblick share (docs/reference/formats.md, "Foxglove").
#pragma once

#include "core/files/point_tables/cloud_columns.h"

#include <string>

namespace edgescan::files {

/// The library in the header of such a file, by which it is known again.
inline constexpr const char* kFoxgloveLibrary = "edgescan-foxglove/1";
/// The metadata record of what the messages do not say: which topic is the whole cloud, its grid, origin and provenance.
inline constexpr const char* kFoxgloveMetadata = "edgescan";

inline constexpr const char* kFoxgloveCloudTopic = "/edgescan/cloud"; ///< every point
inline constexpr const char* kFoxgloveEdgesTopic = "/edgescan/edges"; ///< those that are edges
inline constexpr const char* kFoxgloveLinesTopic = "/edgescan/lines"; ///< line by line, at the time of each line

/// MCAP with the messages foxglove.PointCloud and foxglove.FrameTransform as JSON. Error: not enough memory.
Result<std::string> foxgloveBytes(CloudColumns cloud, const std::string& where, bool asText);

} // namespace edgescan::files
