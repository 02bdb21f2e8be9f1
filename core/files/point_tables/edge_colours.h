// Colours of points in files: edges green as on the screen, the other classes in theirs.
#pragma once

#include "core/base/rgb.h"

#include <array>

namespace edgescan::files {

inline constexpr Rgb kNoEdgeColour{128, 128, 128};
/// By DepthEdge: an edge of a method without classes, jump, convex, concave, data border, outline before a void, void rim. Each of the last
/// five has a contrast of 3 : 1 and more to the cloud's gray.
inline constexpr std::array<Rgb, 7> kEdgeColours{
    {{0, 255, 0}, {0, 255, 0}, {0, 255, 255}, {255, 205, 255}, {255, 215, 150}, {255, 255, 130}, {195, 230, 255}}};

} // namespace edgescan::files
