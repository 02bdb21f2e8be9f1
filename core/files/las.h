// LAS 1.0 to 1.4, uncompressed, point formats 0 to 10 (ASPRS).
#pragma once

#include "core/files/source.h"

#include <string_view>

namespace edgescan {

[[nodiscard]] bool looksLikeLas(std::string_view text);

/// Error: compressed (LAZ), a header that promises more than the file holds, no grid and no picture from the sensor.
Result<Scan> readLas(const Source& source);

} // namespace edgescan
