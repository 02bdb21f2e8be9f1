// LAS 1.0 to 1.4, uncompressed, point formats 0 to 10 (ASPRS).
#pragma once

#include "core/points/point_table.h"

#include <string_view>

namespace edgescan {

[[nodiscard]] bool looksLikeLas(std::string_view text);

/// The points and what our own records say of them, before any grid is looked for.
Result<PointTable> readLasPoints(const Source& source);

/// Provenance that this program wrote behind the points; empty when there is none.
[[nodiscard]] std::string lasRecord(std::string_view bytes);

/// Error: compressed (LAZ), a header that promises more than the file holds, no grid and no picture from the sensor.
Result<Scan> readLas(const Source& source);

} // namespace edgescan
