// The points of a DXF drawing, for comparing a file with what was to be written; polylines are left out.
#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// Coordinates of every POINT entity, in order. Error: a group that is cut off or holds no number. `where` goes into it.
Result<std::vector<Eigen::Vector3d>> dxfPoints(std::string_view text, const std::string& where);

} // namespace edgescan
