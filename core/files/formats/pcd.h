// What the reader and the writer of PCD share.
#pragma once

#include "core/files/point_tables/cloud_columns.h"

#include <string>

namespace edgescan::files {

/// Three numbers follow this in a comment of our own PCD files with metres from the origin of a mine grid: what is to be added to x y z and
/// to the sensor's place in VIEWPOINT.
inline constexpr const char* kPcdOrigin = "edgescan-origin ";
/// The same for the sensor's place where VIEWPOINT holds the origin, as in files of the first versions.
inline constexpr const char* kPcdSensor = "edgescan-sensor ";

/// Binary, or text. Error: not enough memory.
Result<std::string> pcdBytes(CloudColumns cloud, const std::string& where, bool ascii);

} // namespace edgescan::files
