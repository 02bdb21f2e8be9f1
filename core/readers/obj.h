// OBJ (Wavefront): the vertices.
#pragma once

#include "core/points/point_table.h"

#include <string_view>

namespace edgescan {

/// Text whose first words are those of OBJ: v, vn, vt, f, o, g, s, mtllib, usemtl.
[[nodiscard]] bool looksLikeObj(std::string_view text);

/// The vertices, before any grid is looked for.
Result<PointTable> readObjPoints(const Source& source);

/// Error: a vertex that is cut off, no grid and no picture from the sensor.
Result<Scan> readObj(const Source& source);

} // namespace edgescan
