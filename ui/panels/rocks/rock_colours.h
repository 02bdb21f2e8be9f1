// Colours of rock faces as QColor.
#pragma once

#include "core/rocks/attributes/faces.h"

#include <QColor>

namespace edgescan::ui {

/// `place`: index into kRockFaceColours.
[[nodiscard]] inline QColor rockColour(std::size_t place) {
    const Rgb& colour = rocks::kRockFaceColours[place];
    return {colour.red, colour.green, colour.blue};
}

} // namespace edgescan::ui
