// Ranges as gray pictures: row = line, column = beam, one number per pixel, 0 = no return. PNG of 16 bits, TIFF of 16 bits or floats.
#pragma once

#include "core/files/point_tables/source.h"

#include <cstdint>
#include <optional>
#include <string>

namespace edgescan::files {

inline constexpr std::uint64_t kBytesPerPixel = 32; ///< while a picture becomes a scan

/// Error when the file is far too small for so many bytes of pixels: a bomb, or a false header.
Result<Done> checkUnpacked(std::uint64_t bytes, const Source& source);

/// A sentence where a picture asks to be turned or mirrored when it is shown (tag 274 of TIFF and EXIF): its rows are taken as they are.
[[nodiscard]] std::optional<std::string> orientationNotApplied(std::uint64_t orientation);

/// lines x beams in millimetres (or unitMm of the options). Error: no gray picture of 16 bits or 4-byte floats, damaged, no angles; or when
/// the program was built without libtiff.
Result<Scan> readRangeTiff(const Source& source);

/// The scan that a picture's numbers are: counts of 16 bits are millimetres, the unit of floats shows itself, and --unit goes before both.
/// Values that are not finite or not above 0 are missing returns.
Result<Scan> scanFromPicture(const Grid<float>& values, bool counts, const char* format, const Source& source);

} // namespace edgescan::files
