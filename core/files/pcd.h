// Point Cloud Data v0.7 (PCL): ascii, binary and binary_compressed; fields of any type and count.
#pragma once

#include "core/files/source.h"

#include <string_view>

namespace edgescan {

[[nodiscard]] bool looksLikePcd(std::string_view text);
Result<Scan> readPcd(const Source& source);

} // namespace edgescan
