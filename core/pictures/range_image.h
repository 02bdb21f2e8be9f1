// Ranges as gray pictures: row = line, column = beam, one number per pixel, 0 = no return. PNG of 16 bits, TIFF of 16 bits or floats.
#pragma once

#include "core/points/source.h"

#include <cstdint>

#include <string_view>

namespace edgescan {

inline constexpr std::uint64_t kMostPerDeflatedByte = 1032; // deflate shrinks no further

[[nodiscard]] bool looksLikePng(std::string_view text);
[[nodiscard]] bool looksLikeTiff(std::string_view text);

/// lines x beams in millimetres (or unitMm of the options). Error: not a gray picture of 16 bits, damaged, no angles.
Result<Scan> readRangePng(const Source& source);

/// The same for TIFF, also with 4-byte floats. Error also when the program was built without libtiff.
Result<Scan> readRangeTiff(const Source& source);

/// The scan that a picture's numbers are. Values that are not finite or not above 0 are no returns.
Result<Scan> scanFromPicture(Grid<float> values, const char* format, const Source& source);

} // namespace edgescan
