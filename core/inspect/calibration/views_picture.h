// How far the two views of a turn lie apart, as a picture of the check.
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/scan/georef/assembly.h"

namespace edgescan {

/// With these errors: a row per line of the late view, a column per beam (of a sweep: per beam at the ends of its axis). White where the
/// views agree, blue where the surface lies nearer than the late view has it, red where it lies farther, full colour at 50 mm; gray where
/// nothing was compared.
[[nodiscard]] Grid<Rgb> viewsPicture(const Scan& scan, const AssemblyErrors& errors);

/// The first above the second, gray between them: before and after.
[[nodiscard]] Grid<Rgb> oneOverTheOther(const Grid<Rgb>& above, const Grid<Rgb>& below);

} // namespace edgescan
