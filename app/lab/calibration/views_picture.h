// The distance of the two views of a sweep as a picture, to check the self-calibration.
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/scan/georef/assembly.h"

namespace edgescan::inspect {

/// With these errors: a row per line of the late view, a column per beam (for a sweep mounting: per beam at the ends of its axis). White
/// where the views agree, blue where the surface is nearer than in the late view, red where it is farther, full colour at 50 mm; gray where
/// nothing was compared.
[[nodiscard]] Grid<Rgb> viewsPicture(const Scan& scan, const AssemblyErrors& errors);

/// The first above the second with gray between them: before and after.
[[nodiscard]] Grid<Rgb> oneOverTheOther(const Grid<Rgb>& above, const Grid<Rgb>& below);

} // namespace edgescan::inspect
