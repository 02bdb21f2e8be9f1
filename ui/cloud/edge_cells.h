// The edge cells of a frame, and the same by class for methods that tell classes apart.
#pragma once

#include <QColor>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace edgescan::ui {

inline constexpr int kEdgeClasses = 4; // jump, convex, concave, data border: DepthEdge - 1

struct EdgeCells {
    using Indices = std::shared_ptr<const std::vector<std::uint32_t>>; ///< k = line * beams + beam, ascending
    Indices all;
    std::array<Indices, kEdgeClasses> byClass; ///< null: the method tells no classes apart
    bool operator==(const EdgeCells&) const = default;
};

/// Colours of the other classes beside that of a jump, which has the colour of every edge. Each has a contrast of 3 : 1 and
/// more to the cloud's gray.
inline const QColor kConvexColour{0, 255, 255};
inline const QColor kConcaveColour{255, 205, 255};
inline const QColor kBorderColour{255, 215, 150};

} // namespace edgescan::ui
