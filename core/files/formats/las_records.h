// What the records behind the header of a LAS file say: the units of its coordinates, by the well-known text or the GeoTIFF keys of their
// system, and further columns of its points.
#pragma once

#include "core/files/point_tables/point_columns.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files::las {

struct StatedUnits {
    bool degrees = false;           ///< x and y are degrees of longitude and latitude
    std::optional<double> mm;       ///< millimetres per unit of x and y; empty: not stated
    std::optional<double> heightMm; ///< likewise of z, where the file states it on its own
    std::string name;               ///< of the unit, or of the system without a known unit; for sentences
};

/// Of the text of a coordinate system (OGC 01-009 and ISO 19162).
[[nodiscard]] StatedUnits unitsOfWkt(std::string_view text);

/// Where the records of a file are: `records` of them behind the header, from `recordsAt` to `recordsEnd`, and `extended` behind the
/// points.
struct RecordPlaces {
    std::uint64_t recordsAt = 0, records = 0, recordsEnd = 0, extendedAt = 0, extended = 0;
};
/// Of all records of the user LASF_Projection; the text goes before the keys. Damaged records are not read.
[[nodiscard]] StatedUnits statedUnits(std::span<const std::byte> file, const RecordPlaces& places);

/// Further columns of a file's points, with their places in a point of `pointBytes` bytes, `from` byte on; empty where no record of the
/// header describes them. Records are from `recordsAt` to `recordsEnd`.
[[nodiscard]] std::vector<RecordField> extraFields(std::span<const std::byte> file, std::uint64_t recordsAt, std::uint64_t records,
                                                   std::uint64_t recordsEnd, std::size_t from, std::size_t pointBytes);

} // namespace edgescan::files::las
