// The rows of a cloud, for writers: single numbers, and all of them as text or binary records.
#pragma once

#include "core/base/result.h"
#include "core/files/point_tables/cloud_columns.h"

#include <string_view>

namespace edgescan::files {

[[nodiscard]] inline std::size_t rowsOf(const CloudColumns& cloud) { return cloud.width * cloud.height; }

/// Null when the cloud has no such column.
[[nodiscard]] inline const CloudColumn* columnNamed(const CloudColumns& cloud, std::string_view name) {
    for (const CloudColumn& column : cloud.columns) {
        if (column.name == name) return &column;
    }
    return nullptr;
}

[[nodiscard]] inline double numberIn(const CloudColumn& column, std::size_t row) {
    return std::visit([row](const auto& values) { return static_cast<double>(values[row]); }, column.values);
}

/// x y z of a row: the first three columns.
[[nodiscard]] inline Eigen::Vector3d pointIn(const CloudColumns& cloud, std::size_t row) {
    return {numberIn(cloud.columns[0], row), numberIn(cloud.columns[1], row), numberIn(cloud.columns[2], row)};
}

/// The finite numbers of a column of intensities.
struct IntensitySpan {
    double least = 0, greatest = 0;
    bool whole = true;
    /// 0 .. 1 for PTX: as it is where all are in it, else stretched from the least to the greatest; one half where there is none.
    [[nodiscard]] double ofOne(double value) const;
    /// All are whole numbers from 0 to `most`.
    [[nodiscard]] bool fits(double most) const { return whole && least >= 0 && greatest <= most; }
};
[[nodiscard]] IntensitySpan intensitySpan(const CloudColumn& column);

/// Mine coordinates become metres from their origin: 4-byte floats would step by half a metre there. The sensor stays in mine coordinates.
void subtractOrigin(CloudColumns& cloud);

/// One line of text per row. Mine coordinates have four decimals, other numbers of eight bytes nine at most unless the cloud has a
/// description, and all else has as many digits as it takes.
void appendRows(std::string& text, const CloudColumns& cloud, char separator);

/// One binary record per row: each column's value as it is in memory.
void appendRecords(std::string& bytes, const CloudColumns& cloud);

/// Comment lines of the description and the record, each behind the format's own comment word.
void appendComments(std::string& text, const CloudColumns& cloud, const std::string& word);

/// Error when the memory does not suffice for so many bytes per number.
Result<Done> checkRoom(const CloudColumns& cloud, const std::string& where, std::uint64_t bytesPerNumber);

} // namespace edgescan::files
