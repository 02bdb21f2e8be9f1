// How far the two views of a turn lie apart, as a picture of the check.
#pragma once

#include "core/base/grid.h"
#include "core/base/rgb.h"
#include "core/georef/assembly.h"

namespace edgescan {

/// Two panels over each other, with the nominal assembly above and with `errors` below: a row per line that sees surfaces a second time, a
/// column per beam. White where the views agree, blue where the surface lies nearer than the late view has it, red where it lies farther,
/// full colour at 50 mm; gray where nothing was compared.
[[nodiscard]] Grid<Rgb> viewsPicture(const Scan& scan, const AssemblyErrors& errors);

} // namespace edgescan
