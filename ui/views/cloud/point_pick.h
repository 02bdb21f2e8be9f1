// Finds the point under the cursor: exactly, from the geometry alone, without reading back a picture.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "ui/views/cloud/cloud_geometry.h"

#include <Eigen/Core>

#include <QPolygonF>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::ui {

/// The projection from local coordinates to device pixels (x right, y down, origin at the top left corner).
struct ScreenView {
    Eigen::Matrix4d worldToClip = Eigen::Matrix4d::Identity();
    double width = 1.0;
    double height = 1.0;
    double pointSize = 1.0; ///< side of a drawn point, device pixels
};

struct ScreenPoint {
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;  ///< increases away from the camera: clip w (perspective) or z (parallel)
    bool inside = false; ///< between the near and far plane
};
[[nodiscard]] ScreenPoint toScreen(const ScreenView& view, const Eigen::Vector3f& point);

struct ScreenSegment {
    double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
};
/// The part of a straight line in front of the camera; empty if all of it is behind.
[[nodiscard]] std::optional<ScreenSegment> screenSegment(const ScreenView& view, const Eigen::Vector3f& from, const Eigen::Vector3f& to);

/// The visible cell whose point is nearest to the pixel, within `radius`. Visits only tiles that reach the window: usually far below 1 ms
/// at 1.14 M points.
[[nodiscard]] std::optional<std::uint32_t> pickPoint(const CloudGeometry& cloud, const ScreenView& view, double x, double y, double radius);

/// The cell without a point that is nearest to the pixel, within `radius`. It is taken as far from the sensor as the nearer of the points
/// before and behind it on its line: there an opening in a surface is drawn. `tables`: of the cloud's scan.
[[nodiscard]] std::optional<std::uint32_t> pickVoid(const CloudGeometry& cloud, const CartesianTables& tables, const ScreenView& view,
                                                    double x, double y, double radius);

/// The same as pickPoint() among `cells`, ascending, whose points are drawn over all others as squares with sides of 2 * `half` device
/// pixels: the one that covers the pixel and is not hidden. Empty: there is none.
[[nodiscard]] std::optional<std::uint32_t> pickDrawnOver(const CloudGeometry& cloud, const ScreenView& view, double x, double y,
                                                         double half, std::span<const std::uint32_t> cells);

/// The same result as pickPoint() by visiting every point; the oracle of the tests.
[[nodiscard]] std::optional<std::uint32_t> pickPointSlowly(const CloudGeometry& cloud, const ScreenView& view, double x, double y,
                                                           double radius);

/// Cells, ascending, whose points are drawn inside a polygon (device pixels, even-odd rule) and not hidden by nearer ones. On any thread.
[[nodiscard]] std::vector<std::uint32_t> pointsInside(const CloudGeometry& cloud, const ScreenView& view, const QPolygonF& corners);

/// True if another point is drawn in front of this cell's point.
[[nodiscard]] bool isPointHidden(const CloudGeometry& cloud, const ScreenView& view, std::uint32_t cell);

} // namespace edgescan::ui
