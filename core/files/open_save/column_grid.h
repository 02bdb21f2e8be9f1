// Points whose columns name the line and beam of each one: the grid of the file.
#pragma once

#include "core/files/point_tables/point_table.h"

#include <string>

namespace edgescan::files {

/// Lays the points out as an organised cloud, line by line, with NaN where a cell has none and the nearest where it has several (the others
/// stay in `behind`, in the numbers of the file). Unless `sensorGiven`, the sensor becomes the place from which the ranges of the file were
/// measured, where it has ranges. Ranges and states of the file are laid out too, or cleared where they do not fit. False, and the table
/// stays as it is, when line and beam do not make a grid; a remark says why.
[[nodiscard]] bool layOutByColumns(PointTable& table, bool sensorGiven, std::vector<AttachedPoint>& behind);

} // namespace edgescan::files
