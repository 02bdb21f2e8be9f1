// LAZ, compressed LAS, through LASzip where the program was built with it.
#pragma once

#include "core/files/point_tables/source.h"

#include <cstddef>
#include <vector>

namespace edgescan::files {

/// Coordinates of the file and what it holds of each return's strength.
struct LasPoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<float> intensity;           ///< one per point
    std::vector<std::uint8_t> returnNumber; ///< one per point
    std::size_t withheld = 0;               ///< points that the file marks as deleted; their places are not finite
    std::uint64_t end = 0;                  ///< offset in the file behind the last byte of the points and of their table of chunks
    std::vector<std::byte> extra;           ///< of a LAZ file: the bytes after the fixed part of each point, one after the other
};

/// The points of a LAZ file. Error: built without LASzip, damaged, larger than the memory.
Result<LasPoints> readLazPoints(const Source& source);

} // namespace edgescan::files
