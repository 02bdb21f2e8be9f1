// The place of a scan that its own file states: a turn and a shift, whoever registered it.
#pragma once

#include "core/files/point_tables/source.h"
#include "core/scan/grid/scan.h"

namespace edgescan::files {

/// Gives the scan the place p_file = turn p + place, in metres unless --unit says otherwise. `turn` is a rotation. `format` names the
/// file's kind in what is said of it. Nothing is done when the scan has a place already, or when this one neither moves nor turns.
void placeAsWritten(Scan& scan, const Eigen::Matrix3d& turn, const Eigen::Vector3d& place, const char* format, const Source& source);

} // namespace edgescan::files
