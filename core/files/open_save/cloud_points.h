// The points of a cloud alone, without a grid.
#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <filesystem>
#include <vector>

namespace edgescan::files {

/// Metres. Error: as openScan().
Result<std::vector<Eigen::Vector3f>> cloudPoints(const std::filesystem::path& path);

} // namespace edgescan::files
