// Camera poses for mouse movements: pure functions from pose to pose.
#pragma once

#include "ui/views/cloud/cloud_geometry.h"

#include <Eigen/Core>

namespace edgescan::ui {

/// In the local coordinates of the cloud, metres.
struct CameraPose {
    Eigen::Vector3d position{0.0, 0.0, 0.0};
    Eigen::Vector3d focus{0.0, 0.0, 1.0}; ///< the camera looks from position to focus
    Eigen::Vector3d up{0.0, 1.0, 0.0};    ///< unit vector, perpendicular to the view direction
    double viewAngleDeg = 45.0;           ///< vertical
    bool parallel = false;

    [[nodiscard]] double distance() const { return (focus - position).norm(); }
    [[nodiscard]] Eigen::Vector3d forward() const { return (focus - position).normalized(); }
    [[nodiscard]] Eigen::Vector3d right() const { return forward().cross(up).normalized(); }
    /// Half the height of the visible area at the focus, metres. It is also the scale of the parallel view, so that switching between
    /// parallel and perspective keeps the size.
    [[nodiscard]] double halfHeight() const;

    bool operator==(const CameraPose&) const = default;
};

/// Turntable: rotates by `rightRad` about the fixed `upAxis` and by `upRad` about the camera's right axis; both about `centre`. The tilt
/// stops before the poles, so that the picture never flips.
[[nodiscard]] CameraPose turned(const CameraPose& pose, const Eigen::Vector3d& centre, const Eigen::Vector3d& upAxis, double rightRad,
                                double upRad);
/// The axis for a drag that begins at this pose: up, or the top of the scanner's picture where up points into the screen, as in a
/// draw-bell, and a turn about it would only roll the picture. Unit vectors.
[[nodiscard]] Eigen::Vector3d turntableAxis(const CameraPose& pose, const Eigen::Vector3d& up, const Eigen::Vector3d& topOfPicture);
/// Free (trackball) rotation about the camera's own axes.
[[nodiscard]] CameraPose tumbled(const CameraPose& pose, const Eigen::Vector3d& centre, double rightRad, double upRad);
/// Moves the picture by pixels (x right, y down) at the depth of `anchor`.
[[nodiscard]] CameraPose panned(const CameraPose& pose, const Eigen::Vector3d& anchor, double dx, double dy, double viewHeightPx);
/// factor > 1 moves closer; `anchor` stays at the same place on the screen.
[[nodiscard]] CameraPose zoomed(const CameraPose& pose, const Eigen::Vector3d& anchor, double factor);
/// Rotates the picture about the view direction, counter-clockwise.
[[nodiscard]] CameraPose rolled(const CameraPose& pose, double rad);
/// Keeps direction and distance; `point` becomes the focus.
[[nodiscard]] CameraPose centredOn(const CameraPose& pose, const Eigen::Vector3d& point);

/// Looks along `forward`, at the distance at which the box fits a view of this width / height.
[[nodiscard]] CameraPose lookingAt(const Box3f& box, const Eigen::Vector3d& forward, const Eigen::Vector3d& up, const CameraPose& lens,
                                   double widthByHeight);
/// lookingAt(), along the line of sight from a place and not from behind it: what is seen from there stays in sight. A box that is too
/// large for the usual lens gets a wider one.
[[nodiscard]] CameraPose lookingAtFrom(const Eigen::Vector3d& place, const Box3f& box, const Eigen::Vector3d& up, const CameraPose& lens,
                                       double widthByHeight);
/// The scanner's view: from the sensor along the mean direction. View angle and distance are just large enough for 99 % of the points,
/// within the limits of a flat picture. Row 0 is at the top if the geometry allows it.
[[nodiscard]] CameraPose fromScanner(const CloudGeometry& cloud, const CameraPose& lens, double widthByHeight);

/// Distance that 90 % of neighbouring points keep to on a screen of this height, pixels, from 1 to 7. It is computed on a sample from the
/// angles between beams and between lines at the sensor. 1 if unknown.
[[nodiscard]] double spacingOnScreen(const CloudGeometry& cloud, const CameraPose& pose, int viewHeightPx);

/// Share of the depth that is clipped in front and behind, 0 .. 1 each.
struct CloudClip {
    double nearShare = 0.0, farShare = 0.0;
    bool operator==(const CloudClip&) const = default;
};

struct ClipRange {
    double nearM = 0.1;
    double farM = 100.0;
};
/// Near and far planes around the box; nearShare / farShare in [0, 1] clip this share of the depth at each end.
[[nodiscard]] ClipRange clipRange(const CameraPose& pose, const CloudGeometry& cloud, double nearShare, double farShare);

/// From local coordinates to clip space for this view (OpenGL convention).
[[nodiscard]] Eigen::Matrix4d worldToClip(const CameraPose& pose, const ClipRange& clip, double widthByHeight);
/// Point at `depth` metres along the view direction under a place on the screen (-1 .. 1, y up).
[[nodiscard]] Eigen::Vector3d underCursor(const CameraPose& pose, double ndcX, double ndcY, double depth, double widthByHeight);

} // namespace edgescan::ui
