// Polygon files (PLY 1.0): vertices with scalar properties; ascii, little and big endian.
#pragma once

#include "core/points/point_table.h"
#include "core/points/source.h"

#include <string_view>

namespace edgescan {

[[nodiscard]] bool looksLikePly(std::string_view text);
/// The points as the file has them, before anything is made of them.
Result<PointTable> readPlyPoints(const Source& source);
Result<Scan> readPly(const Source& source);

} // namespace edgescan
