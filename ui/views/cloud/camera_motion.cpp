// Camera poses for mouse movements.
#include "ui/views/cloud/camera_motion.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan::ui {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double kPoleRad = 89.0 * std::numbers::pi / 180.0;
constexpr double kNearestM = 0.02; // no laser scanner resolves less
constexpr double kMargin = 1.04;   // free margin around the fitted points
constexpr double kUsualViewAngleDeg = 45.0;
constexpr double kWidestViewAngleDeg = 84.0; // larger angles distort the rocks at the rim
constexpr double kFarthestBack = 0.3;        // of the median depth

double tanHalf(const CameraPose& pose) { return std::tan(0.5 * pose.viewAngleDeg * std::numbers::pi / 180.0); }

CameraPose orbited(const CameraPose& pose, const Vector3d& centre, const Eigen::Matrix3d& turn) {
    CameraPose out = pose;
    out.position = centre + turn * (pose.position - centre);
    out.focus = centre + turn * (pose.focus - centre);
    out.up = turn * pose.up;
    // Without this, thousands of small rotations would move `up` away from the right angle.
    const Vector3d forward = out.forward();
    out.up = (out.up - forward * forward.dot(out.up)).normalized();
    return out;
}

std::vector<Vector3d> samplePoints(const CloudGeometry& cloud) {
    std::vector<Vector3d> points;
    for (const auto& part : cloud.drawOrder) {
        for (const std::uint32_t k : part) points.push_back(cloud.point(k).cast<double>());
        if (points.size() > 5000) break;
    }
    return points;
}

/// From the sensor in the directions of the frame, pulled back a little if the points need it.
CameraPose fromSensor(const Vector3d& sensor, const std::vector<Vector3d>& points, const ViewFrame& frame, const CameraPose& lens,
                      double widthByHeight) {
    CameraPose out = lens;
    out.position = sensor;
    out.focus = sensor + frame.forward;
    out.up = frame.up;
    if (points.empty()) return out;

    // Tangents of the angles at which the sensor sees the points; points behind it have no such angle.
    std::vector<double> tangents, ahead;
    for (const Vector3d& p : points) {
        const Vector3d d = p - sensor;
        const double depth = d.dot(frame.forward);
        const double reach = std::max(std::abs(d.dot(frame.right)) / widthByHeight, std::abs(d.dot(frame.up)));
        tangents.push_back(depth > 1e-6 ? reach / depth : 1e6);
        ahead.push_back(depth);
    }
    const double middle = std::max(10 * kNearestM, quantile(ahead, 0.5));
    const double wanted = 2.0 * std::atan(quantile(tangents, 0.9)) * 180.0 / std::numbers::pi;
    out.viewAngleDeg = std::clamp(wanted, kUsualViewAngleDeg, kWidestViewAngleDeg);

    const double tanV = tanHalf(out);
    const double tanH = tanV * widthByHeight;
    std::vector<double> back;
    for (const Vector3d& p : points) {
        const Vector3d d = p - sensor;
        const double reach = std::max(std::abs(d.dot(frame.right)) / tanH, std::abs(d.dot(frame.up)) / tanV);
        back.push_back(reach - d.dot(frame.forward));
    }
    // A sweep of 360 degrees does not fit in a view; a camera far back would only show the walls from outside.
    const double pulledBack = std::clamp(quantile(back, 0.99) * kMargin, 0.0, kFarthestBack * middle);
    out.position = sensor - frame.forward * pulledBack;
    out.focus = sensor + frame.forward * middle;
    return out;
}

struct DepthSpan {
    double nearest = 0.0;
    double farthest = 0.0;
};
DepthSpan depthSpan(const CameraPose& pose, const Box3f& box) {
    const Vector3d forward = pose.forward();
    const double middle = forward.dot(box.center().cast<double>() - pose.position);
    const double half = 0.5 * forward.cwiseAbs().dot(box.sizes().cast<double>());
    return {middle - half, middle + half};
}

} // namespace

double CameraPose::halfHeight() const { return distance() * tanHalf(*this); }

CameraPose turned(const CameraPose& pose, const Vector3d& centre, const Vector3d& upAxis, double rightRad, double upRad) {
    const double tilt = std::asin(std::clamp(pose.forward().dot(upAxis), -1.0, 1.0));
    const double limit = std::max(kPoleRad, std::abs(tilt)); // a view from above starts at the pole
    const double sense = pose.up.dot(upAxis) >= -1e-9 ? 1.0 : -1.0;
    const double wanted = std::clamp(tilt + sense * upRad, -limit, limit);
    const AngleAxisd pitch(sense * (wanted - tilt), pose.right());
    const AngleAxisd yaw(-rightRad, upAxis);
    return orbited(pose, centre, (yaw * pitch).toRotationMatrix());
}

Vector3d turntableAxis(const CameraPose& pose, const Vector3d& up, const Vector3d& topOfPicture) {
    constexpr double kMuchTheSame = 0.7; // cosine
    const bool same = std::abs(topOfPicture.dot(up)) > kMuchTheSame;
    return same || std::abs(pose.up.dot(up)) >= std::abs(pose.up.dot(topOfPicture)) ? up : topOfPicture;
}

CameraPose tumbled(const CameraPose& pose, const Vector3d& centre, double rightRad, double upRad) {
    return orbited(pose, centre, (AngleAxisd(-rightRad, pose.up) * AngleAxisd(upRad, pose.right())).toRotationMatrix());
}

CameraPose panned(const CameraPose& pose, const Vector3d& anchor, double dx, double dy, double viewHeightPx) {
    const double depth = pose.parallel ? pose.distance() : std::max(kNearestM, pose.forward().dot(anchor - pose.position));
    const double metresPerPixel = 2.0 * depth * tanHalf(pose) / std::max(1.0, viewHeightPx);
    const Vector3d shift = (pose.up * dy - pose.right() * dx) * metresPerPixel;
    CameraPose out = pose;
    out.position += shift;
    out.focus += shift;
    return out;
}

CameraPose zoomed(const CameraPose& pose, const Vector3d& anchor, double factor) {
    if (pose.distance() / factor < kNearestM) return pose;
    CameraPose out = pose;
    out.position = anchor + (pose.position - anchor) / factor;
    out.focus = anchor + (pose.focus - anchor) / factor;
    return out;
}

CameraPose rolled(const CameraPose& pose, double rad) {
    CameraPose out = pose;
    out.up = AngleAxisd(rad, pose.forward()) * pose.up;
    return out;
}

CameraPose centredOn(const CameraPose& pose, const Vector3d& point) {
    CameraPose out = pose;
    out.position = point - pose.forward() * pose.distance();
    out.focus = point;
    return out;
}

CameraPose lookingAt(const Box3f& box, const Vector3d& forward, const Vector3d& up, const CameraPose& lens, double widthByHeight) {
    CameraPose out = lens;
    out.viewAngleDeg = kUsualViewAngleDeg;
    out.focus = box.center().cast<double>();
    out.position = out.focus - forward;
    out.up = (up - forward * forward.dot(up)).normalized();
    const Vector3d right = out.right();
    const double tanV = tanHalf(out);
    const double tanH = tanV * widthByHeight;
    double distance = kNearestM;
    for (int i = 0; i < 8; ++i) {
        const Vector3d d = box.corner(static_cast<Box3f::CornerType>(i)).cast<double>() - out.focus;
        const double depth = lens.parallel ? 0.0 : d.dot(forward);
        distance = std::max({distance, std::abs(d.dot(right)) / tanH - depth, std::abs(d.dot(out.up)) / tanV - depth});
    }
    out.position = out.focus - forward * distance * kMargin;
    return out;
}

CameraPose lookingAtFrom(const Vector3d& place, const Box3f& box, const Vector3d& up, const CameraPose& lens, double widthByHeight) {
    const Vector3d away = box.center().cast<double>() - place;
    if (!(away.norm() > kNearestM)) return lookingAt(box, lens.forward(), up, lens, widthByHeight);
    const Vector3d forward = away.normalized();
    CameraPose out = lookingAt(box, forward, up, lens, widthByHeight);
    if (lens.parallel || out.distance() <= away.norm()) return out;
    out.position = place;
    double widest = 0.0; // tangent of half the angle
    for (int i = 0; i < 8; ++i) {
        const Vector3d d = box.corner(static_cast<Box3f::CornerType>(i)).cast<double>() - place;
        const double depth = std::max(kNearestM, d.dot(forward));
        widest = std::max({widest, std::abs(d.dot(out.right())) / depth / widthByHeight, std::abs(d.dot(out.up)) / depth});
    }
    out.viewAngleDeg = std::clamp(2.0 * std::atan(widest) * 180.0 / std::numbers::pi, kUsualViewAngleDeg, kWidestViewAngleDeg);
    return out;
}

CameraPose fromScanner(const CloudGeometry& cloud, const CameraPose& lens, double widthByHeight) {
    return fromSensor(cloud.sensor.cast<double>(), samplePoints(cloud), cloud.scannerView, lens, widthByHeight);
}

ClipRange clipRange(const CameraPose& pose, const CloudGeometry& cloud, double nearShare, double farShare) {
    if (cloud.bounds.isEmpty()) return {0.1, 100.0};
    const DepthSpan all = depthSpan(pose, cloud.bounds);
    const DepthSpan most = depthSpan(pose, cloud.mainBounds);
    // A stray return kilometres away must not use up the depth resolution of the rocks.
    const double size = std::max({static_cast<double>(cloud.mainBounds.diagonal().norm()), most.farthest, pose.distance(), 0.1});
    double farM = std::min(all.farthest, 30.0 * size) + 0.01 * size;
    double nearM = all.nearest - 0.01 * size;
    const double floor = pose.parallel ? -30.0 * size : 0.0005 * size;
    nearM = std::max(nearM, floor);
    if (nearShare > 0.0)
        nearM = std::max(nearM, std::max(most.nearest, floor) + nearShare * (most.farthest - std::max(most.nearest, floor)));
    if (farShare > 0.0) farM = most.farthest - farShare * (most.farthest - std::max(most.nearest, floor));
    farM = std::max(farM, nearM + 0.001 * size);
    return {nearM, farM};
}

Matrix4d worldToClip(const CameraPose& pose, const ClipRange& clip, double widthByHeight) {
    const Vector3d forward = pose.forward();
    const Vector3d right = pose.right();
    const Vector3d up = right.cross(forward);
    Matrix4d view = Matrix4d::Identity();
    view.block<1, 3>(0, 0) = right.transpose();
    view.block<1, 3>(1, 0) = up.transpose();
    view.block<1, 3>(2, 0) = -forward.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * pose.position;

    Matrix4d lens = Matrix4d::Zero();
    const double depth = clip.farM - clip.nearM;
    if (pose.parallel) {
        const double half = pose.halfHeight();
        lens(0, 0) = 1.0 / (half * widthByHeight);
        lens(1, 1) = 1.0 / half;
        lens(2, 2) = -2.0 / depth;
        lens(2, 3) = -(clip.farM + clip.nearM) / depth;
        lens(3, 3) = 1.0;
    } else {
        const double half = tanHalf(pose);
        lens(0, 0) = 1.0 / (half * widthByHeight);
        lens(1, 1) = 1.0 / half;
        lens(2, 2) = -(clip.farM + clip.nearM) / depth;
        lens(2, 3) = -2.0 * clip.farM * clip.nearM / depth;
        lens(3, 2) = -1.0;
    }
    return lens * view;
}

Vector3d underCursor(const CameraPose& pose, double ndcX, double ndcY, double depth, double widthByHeight) {
    const double half = pose.parallel ? pose.halfHeight() : depth * tanHalf(pose);
    return pose.position + pose.forward() * depth + pose.right() * (ndcX * half * widthByHeight) + pose.up * (ndcY * half);
}

double spacingOnScreen(const CloudGeometry& cloud, const CameraPose& pose, int viewHeightPx) {
    constexpr std::size_t kSample = 400;
    constexpr double kLeast = 1.0, kMost = 7.0; // pixels
    constexpr double kShare = 0.9;              // of the points whose spacing is closed; the farthest ones would make all others coarse
    if (cloud.stepRad <= 0.0 || viewHeightPx <= 0) return kLeast;
    std::vector<double> pixels;
    const Vector3d forward = pose.forward();
    const double perMetre = 0.5 * viewHeightPx / pose.halfHeight(); // at the focus
    const auto& some = cloud.drawOrder.front();
    const std::size_t every = std::max<std::size_t>(1, some.size() / kSample);
    for (std::size_t n = 0; n < some.size(); n += every) {
        const Eigen::Vector3f point = cloud.point(some[n]);
        const double spacing = stepAt(cloud, some[n]).value_or(cloud.stepRad) * static_cast<double>((point - cloud.sensor).norm());
        const double depth = forward.dot(point.cast<double>() - pose.position);
        if (depth <= 0.0) continue;
        const double wide = pose.parallel ? perMetre : perMetre * pose.distance() / depth;
        // Points outside the picture are ignored.
        const Vector3d off = point.cast<double>() - pose.position - depth * forward;
        if (off.norm() * wide > viewHeightPx) continue;
        pixels.push_back(spacing * wide);
    }
    if (pixels.empty()) return kLeast;
    return std::clamp(quantile(pixels, kShare), kLeast, kMost);
}

} // namespace edgescan::ui
