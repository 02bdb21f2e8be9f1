// The colour of the selection, in all views.
#pragma once

#include <QColor>

namespace edgescan::ui {

/// As light as rock faces and the cloud, so that edges contrast with it as they do with them. It differs from every rock colour for all
/// kinds of colour vision.
inline constexpr QRgb kSelectedColour = qRgb(190, 40, 250);

} // namespace edgescan::ui
