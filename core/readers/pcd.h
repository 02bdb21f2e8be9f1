// Point Cloud Data v0.7 (PCL): ascii, binary and binary_compressed; fields of any type and count.
#pragma once

#include "core/points/point_table.h"
#include "core/points/source.h"

#include <string_view>

namespace edgescan {

[[nodiscard]] bool looksLikePcd(std::string_view text);
/// The points as the file has them, before anything is made of them.
Result<PointTable> readPcdPoints(const Source& source);
Result<Scan> readPcd(const Source& source);

} // namespace edgescan
