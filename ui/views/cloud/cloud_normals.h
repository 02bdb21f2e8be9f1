// Which way the surface faces at each cell, for shading only: a flat gray cloud shows no rock.
#pragma once

#include "ui/views/cloud/cloud_geometry.h"

#include <vector>

namespace edgescan::ui {

/// 3 floats per cell k: unit normal towards the sensor, from a fit over the neighbours along the line and along the beam that lie on
/// the same surface; where there are too few, the direction to the sensor. Uses lines, beams, xyz, valid and sensor of `cloud`.
[[nodiscard]] std::vector<float> surfaceNormals(const CloudGeometry& cloud);

} // namespace edgescan::ui
