// PTX (Leica Cyclone): scans as full grids about their scanner, with the pose of each; columns are lines, rows are beams.
#pragma once

#include "core/points/source.h"

#include <Eigen/Core>

#include <string_view>
#include <vector>

namespace edgescan {

/// Two lines with one whole number, then rows of three, three, three and three numbers and of four.
[[nodiscard]] bool looksLikePtx(std::string_view text);

/// The points of the scan that the options ask for, moved by its matrix; without 0 0 0, which is no return.
Result<std::vector<Eigen::Vector3d>> readPtxPoints(const Source& source);

/// The scan that the options ask for, placed by its matrix. 0 0 0 is no return. Error: cut off, a count that lies, no such scan.
Result<Scan> readPtx(const Source& source);

} // namespace edgescan
