// Writers of the formats that CAD, survey and mesh programs read. Each is a function from columns to the bytes of the file.
#pragma once

#include "core/writers/cloud_columns.h"

#include <string>

namespace edgescan {

/// LAS 1.4: whole millimetres, columns behind x y z as extra bytes. Error: no points, or farther apart than LAS can hold.
Result<std::string> lasBytes(const CloudColumns& cloud, const std::string& where);

/// DXF of release 12: points on layers CLOUD and EDGE_POINTS, edges as polylines on EDGE_LINES.
Result<std::string> dxfBytes(const CloudColumns& cloud, const std::string& where);

/// PTX: the whole grid about its sensor, 0 0 0 where there is no point; its matrix moves it into the frame of the columns.
Result<std::string> ptxBytes(const CloudColumns& cloud, const std::string& where);

/// OBJ: vertices, with colours where there is a column of edges.
Result<std::string> objBytes(const CloudColumns& cloud, const std::string& where);

} // namespace edgescan
