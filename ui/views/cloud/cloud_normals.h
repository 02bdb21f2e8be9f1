// Surface normals of the cells, only for shading: without shading a gray cloud shows no shape.
#pragma once

#include "ui/views/cloud/cloud_geometry.h"

#include <vector>

namespace edgescan::ui {

/// 3 floats per cell k: unit normal towards the sensor, fitted to the neighbours on the same surface along the line and along the beam.
/// With too few neighbours: the direction to the sensor. Uses lines, beams, xyz, valid and sensor of `cloud`.
[[nodiscard]] std::vector<float> surfaceNormals(const CloudGeometry& cloud);

} // namespace edgescan::ui
