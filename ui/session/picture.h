// What the window shows of one frame: the frame itself and the images made of it off the GUI thread.
#pragma once

#include "core/edges/frame.h"
#include "ui/cloud/cloud_geometry.h"
#include "ui/cloud/edge_cells.h"

#include <QColor>
#include <QImage>

#include <memory>

namespace edgescan::ui {

/// Gray levels shown as black and white; only the display, never what the method sees.
struct DisplayLevels {
    int black = 0;
    int white = 255;
    bool operator==(const DisplayLevels&) const = default;
};

/// Never changed after it is made. All members change together in the window.
struct Picture {
    std::shared_ptr<const Frame> frame;
    std::shared_ptr<const CloudGeometry> cloud;
    std::shared_ptr<const QImage> gray;    ///< beams x lines pixels; missing data hatched violet
    std::shared_ptr<const QImage> edges;   ///< white edges on black; missing data hatched violet
    std::shared_ptr<const QImage> overlay; ///< green edges, transparent elsewhere
    EdgeCells edgeCells;
};

[[nodiscard]] QImage grayPicture(const Frame& frame, DisplayLevels levels);
[[nodiscard]] QImage edgePicture(const Frame& frame);
/// The edge map with the colours of the classes, where the method tells classes apart; else as edgePicture().
[[nodiscard]] QImage classPicture(const Frame& frame, const QColor& jump);
[[nodiscard]] QImage edgeOverlay(const Frame& frame, const QColor& colour);

/// Images of `frame`; what did not change since `last` (may be null) is taken from it.
[[nodiscard]] std::shared_ptr<const Picture> makePicture(const std::shared_ptr<const Frame>& frame,
                                                         const std::shared_ptr<const CloudGeometry>& cloud,
                                                         const std::shared_ptr<const Picture>& last);

} // namespace edgescan::ui
