// The icons of tools, drawn from paths in the colours of the theme: the build has no Qt Svg.
#pragma once

#include <QIcon>
#include <QPainterPath>

namespace edgescan::ui {

/// Parses the path commands M L H V C A Z of SVG, absolute and relative. Arcs must not be rotated. Parsing stops at any other character.
[[nodiscard]] QPainterPath pathOf(const char* words);

/// Icon named "pin", "measure", "rocks" ...; an empty icon for an unknown name. White when switched on, grey when disabled, else the colour
/// of text.
[[nodiscard]] QIcon toolIcon(const char* name);

} // namespace edgescan::ui
