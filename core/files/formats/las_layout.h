// Where things are in a LAS file (ASPRS LAS 1.4 R15), for reader and writer.
#pragma once

#include "core/files/point_tables/cloud_columns.h"
#include "core/files/point_tables/point_columns.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::files::las {

// Byte offsets in the public header.
inline constexpr std::size_t kGlobalEncoding = 6, kVersionMajor = 24, kVersionMinor = 25, kSystem = 26, kSoftware = 58, kDay = 90,
                             kYear = 92, kHeaderSize = 94, kPointsAt = 96, kRecordCount = 100, kPointFormat = 104, kPointBytes = 105,
                             kLegacyPoints = 107, kScale = 131, kOffset = 155, kMaxMin = 179, kWaveformAt = 227, kExtendedAt = 235,
                             kExtendedCount = 243, kPoints = 247, kPointsByReturn = 255;
/// Of a point of any format.
inline constexpr std::size_t kIntensity = 12;
/// The number of the return of its pulse: three bits before format 6, four from there on.
inline constexpr std::size_t kReturn = 14;
inline constexpr unsigned kLegacyReturn = 0x07, kLongReturn = 0x0F;
/// A point marked so was deleted: a bit of the byte of flags, which is that of the class before format 6 (and does not exist in LAS 1.0).
inline constexpr std::size_t kFlags = 15;
inline constexpr unsigned kWithheldFlag = 0x04, kWithheldClass = 0x80;
inline constexpr std::size_t kHeader12 = 227, kHeader13 = 235, kHeader14 = 375;
/// Records after the header: reserved 2, user 16, id 2, length 2 (extended: 8), description 32.
inline constexpr std::size_t kRecordHeader = 54, kExtendedHeader = 60;
inline constexpr std::size_t kRecordUser = 2, kRecordId = 18, kRecordLength = 20;
/// Least bytes of a point of each format.
inline constexpr std::array<std::uint16_t, 11> kFormatBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/// Our own records: user "EdgeScan". The description of the grid, its cells (1 byte state and 4 byte range each, in order), and
/// provenance.
inline constexpr const char* kOurUser = "EdgeScan";
inline constexpr std::uint16_t kDescriptionId = 1, kCellsId = 2, kProvenanceId = 3;
inline constexpr std::size_t kCellBytes = 5;

} // namespace edgescan::files::las

namespace edgescan::files {

/// LAS 1.4: whole millimetres, columns behind x y z as extra bytes. Error: no points, or farther apart than LAS can hold.
Result<std::string> lasBytes(CloudColumns cloud, const std::string& where, bool asText);

} // namespace edgescan::files
