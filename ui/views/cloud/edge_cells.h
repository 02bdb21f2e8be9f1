// The edge cells of a frame, all together and by class for methods that have classes.
#pragma once

#include "core/files/point_tables/edge_colours.h"

#include <QColor>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace edgescan::ui {

inline constexpr int kEdgeClasses = 6; // jump, convex, concave, data border, outline before a void, void rim: DepthEdge - 1

struct EdgeCells {
    using Indices = std::shared_ptr<const std::vector<std::uint32_t>>; ///< k = line * beams + beam, ascending
    Indices all;
    std::array<Indices, kEdgeClasses> byClass;                                 ///< null: the method has no classes
    std::array<float, kEdgeClasses> sizes{1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F}; ///< point size per class, relative to the normal size
    bool operator==(const EdgeCells&) const = default;
};

/// By class; methods without classes use the first colour for every edge.
using EdgeColours = std::array<QColor, kEdgeClasses>;

inline QColor colourOf(const Rgb& colour) { return {colour.red, colour.green, colour.blue}; }
/// The same colours as in files.
inline const EdgeColours kUsualColours{colourOf(files::kEdgeColours[1]), colourOf(files::kEdgeColours[2]),
                                       colourOf(files::kEdgeColours[3]), colourOf(files::kEdgeColours[4]),
                                       colourOf(files::kEdgeColours[5]), colourOf(files::kEdgeColours[6])};
inline constexpr std::size_t kRimClass = kEdgeClasses - 1;
/// What edges are drawn in: each class in its own colour, or all in the first one. Rims of open voids always have their own: what is behind
/// them is not known.
inline EdgeColours drawnColours(const EdgeColours& colours, bool byClass) {
    if (byClass) return colours;
    EdgeColours drawn;
    drawn.fill(colours.front());
    drawn[kRimClass] = colours[kRimClass];
    return drawn;
}
/// How strongly an edge is drawn while edges are not drawn by class: a border of a rock, or one whose probability is unknown; less likely;
/// a fold within a rock. EdgeCells::byClass has the strengths first, and the rims of open voids in their place.
enum EdgeStrength : std::uint8_t { kStrongEdge, kWeakEdge, kThinEdge };
inline constexpr std::size_t kEdgeStrengths = 3;
inline constexpr std::array<float, kEdgeStrengths> kStrengthSizes{1.0F, 0.75F, 0.45F}; // of points
inline constexpr std::array<int, kEdgeStrengths> kStrengthPercent{100, 75, 55};        // of brightness
inline QColor dimmedTo(const QColor& colour, int percent) {
    return {colour.red() * percent / 100, colour.green() * percent / 100, colour.blue() * percent / 100};
}
inline EdgeColours strengthColours(const EdgeColours& colours) {
    EdgeColours drawn = colours;
    for (std::size_t n = 0; n < kEdgeStrengths; ++n) drawn[n] = dimmedTo(colours.front(), kStrengthPercent[n]);
    return drawn;
}

/// Distinct with red-green colour blindness: along yellow, white and blue. Contrast to the cloud's gray at least 3 : 1.
inline const EdgeColours kColourBlindColours{QColor(240, 228, 66),  QColor(178, 223, 255), QColor(255, 255, 255),
                                             QColor(255, 210, 190), QColor(190, 255, 190), QColor(230, 215, 255)};

} // namespace edgescan::ui
