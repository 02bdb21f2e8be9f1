// The parts of re-gridding: points as directions, the window they fill, the spacing between them, and scan lines among them.
#pragma once

#include "core/files/grid_recovery/regrid.h"

#include <vector>

namespace edgescan::files::regridding {

/// A return as seen from the sensor. Radians, growing to the right and downwards.
struct Sight {
    double across = 0.0;
    double down = 0.0;
    double range = 0.0;
    std::uint32_t point = 0;
};

struct Window {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    [[nodiscard]] bool holds(const Sight& s) const { return s.across >= left && s.across <= right && s.down >= top && s.down <= bottom; }
};

/// Cells of a step over a window: how many points fill, and how closed the filled area is.
struct Cover {
    std::size_t filled = 0;
    double closed = 0.0; ///< share of the neighbours of filled cells that are filled too
};
/// `sidewaysOnly`: neighbours are those in the same line.
[[nodiscard]] Cover coverOf(const std::vector<Sight>& sights, const Window& window, double stepAcross, double stepDown, bool sidewaysOnly);

/// The smallest step, radians, at which the filled area closes: between points that are neighbours in angle no cell stays empty.
/// For a fan (`lineStep` > 0) the step along the lines only.
[[nodiscard]] double spacingOf(const std::vector<Sight>& sights, const Window& window, double lineStep);

/// Lines of a scanner among the sights of a cloud: rings about the sensor's upright axis (a spinning scanner with several beams), or
/// planes through one of the axes (a fan on a stepper whose beams are uneven). Empty when no lines are distinct.
struct Fan {
    std::vector<Sight> sights;     ///< `down` is the line's number
    std::vector<double> lineAngle; ///< radians, one per line
};
[[nodiscard]] std::optional<Fan> findFan(const LooseCloud& cloud);

} // namespace edgescan::files::regridding
