// LAZ, compressed LAS, through LASzip where the program was built with it.
#pragma once

#include "core/points/source.h"

#include <vector>

namespace edgescan {

/// The points of a LAZ file, in its coordinates. Error: built without LASzip, damaged, larger than the memory.
Result<std::vector<Eigen::Vector3d>> readLazPoints(const Source& source);

} // namespace edgescan
