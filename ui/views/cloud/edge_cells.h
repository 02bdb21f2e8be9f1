// The edge cells of a frame, and the same by class for methods that tell classes apart.
#pragma once

#include "core/files/point_tables/edge_colours.h"

#include <QColor>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace edgescan::ui {

inline constexpr int kEdgeClasses = 5; // jump, convex, concave, data border, outline before a void: DepthEdge - 1

struct EdgeCells {
    using Indices = std::shared_ptr<const std::vector<std::uint32_t>>; ///< k = line * beams + beam, ascending
    Indices all;
    std::array<Indices, kEdgeClasses> byClass;                           ///< null: the method tells no classes apart
    std::array<float, kEdgeClasses> sizes{1.0F, 1.0F, 1.0F, 1.0F, 1.0F}; ///< of the points of each class, of the usual one
    bool operator==(const EdgeCells&) const = default;
};

/// By class; the first one is also the colour of every edge where classes are not told apart.
using EdgeColours = std::array<QColor, kEdgeClasses>;

inline QColor colourOf(const Rgb& colour) { return {colour.red, colour.green, colour.blue}; }
/// As files have them.
inline const EdgeColours kUsualColours{colourOf(kEdgeColours[1]), colourOf(kEdgeColours[2]), colourOf(kEdgeColours[3]),
                                       colourOf(kEdgeColours[4]), colourOf(kEdgeColours[5])};
/// Told apart by those who see no difference between red and green: along yellow, white and blue. 3 : 1 and more to the cloud's gray, too.
inline const EdgeColours kColourBlindColours{QColor(240, 228, 66), QColor(178, 223, 255), QColor(255, 255, 255), QColor(255, 210, 190),
                                             QColor(190, 255, 190)};

} // namespace edgescan::ui
