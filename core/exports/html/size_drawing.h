// The size curve of the visible rocks as a drawing.
#pragma once

#include "core/rocks/attributes/size_curve.h"

#include <string>

namespace edgescan::exports {

/// An SVG element with the id "sizes". The curve must have rocks.
[[nodiscard]] std::string sizeDrawing(const rocks::SizeCurve& curve);

} // namespace edgescan::exports
