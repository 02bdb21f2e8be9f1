// The coordinate system of a cloud as well-known text (OGC 01-009), for formats that carry one.
#pragma once

#include "core/files/point_tables/cloud_columns.h"

#include <optional>
#include <string>

namespace edgescan::files {

/// The EPSG system where the pose names one that is known here (UTM on WGS 84, by name or code) and the coordinates are its own; else a
/// local system that no program takes for a place on earth. One line of ASCII.
[[nodiscard]] std::string coordinateSystemWkt(const CloudColumns& cloud);

/// The EPSG code of the system that a pose names, if it is known here.
[[nodiscard]] std::optional<int> epsgCode(const std::string& grid);

} // namespace edgescan::files
