// The signs on tools, drawn from paths in the colours of the theme: the build has no Qt Svg.
#pragma once

#include <QIcon>
#include <QPainterPath>

namespace edgescan::ui {

/// Lines of a path in SVG's words: M L H V C A Z and their small forms, ellipses upright. Anything else ends it.
[[nodiscard]] QPainterPath pathOf(const char* words);

/// "pin", "measure", "rocks" ...; of another name: nothing. On: white; greyed where it cannot be used; else the colour of words.
[[nodiscard]] QIcon toolIcon(const char* name);

} // namespace edgescan::ui
