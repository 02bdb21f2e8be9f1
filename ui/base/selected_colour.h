// The colour of what is selected, in all views.
#pragma once

#include <QColor>

namespace edgescan::ui {

/// As light as rock faces and cloud, so that edges are told from it as from them, and no rock's colour to any eye.
inline constexpr QRgb kSelectedColour = qRgb(190, 40, 250);

} // namespace edgescan::ui
