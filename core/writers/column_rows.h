// Columns of a cloud read row by row, for writers that treat some of them apart.
#pragma once

#include "core/writers/cloud_columns.h"

#include <string_view>

namespace edgescan {

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

} // namespace edgescan
