// The camera of the 3D view.
#include "ui/views/cloud/cloud_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {

using Eigen::Vector3d;

double CloudView::aspect() const { return static_cast<double>(std::max(1, width())) / std::max(1, height()); }

double CloudView::pixelsOfPoint() const {
    constexpr double kNotSeen = 0.1; // px of a gap
    return std::max(1.0, std::ceil(pointSize_ * devicePixelRatioF() - kNotSeen));
}

ScreenView CloudView::screenView() const {
    const ClipRange clip = clipRange(pose_, extent(), clip_.nearShare, clip_.farShare);
    const double dpr = devicePixelRatioF();
    return {worldToClip(pose_, clip, aspect()), width() * dpr, height() * dpr, pixelsOfPoint()};
}

std::optional<QPointF> CloudView::pixelOf(std::uint32_t cell) const {
    if (!cloud_ || !cloud_->drawable(cell)) return std::nullopt;
    return pixelIn(screenView(), cloud_->point(cell));
}

std::optional<QPointF> CloudView::pixelIn(const ScreenView& view, const Eigen::Vector3f& point) const {
    const ScreenPoint p = toScreen(view, point);
    return p.inside ? std::optional(QPointF(p.x, p.y) / devicePixelRatioF()) : std::nullopt;
}

/// Only the boxes: of the cloud and its layers.
CloudGeometry CloudView::extent() const {
    CloudGeometry all;
    all.bounds = layersBounds_;
    all.mainBounds = all.wideBounds = layersMain_;
    if (cloud_) {
        all.bounds.extend(cloud_->bounds);
        all.mainBounds.extend(cloud_->mainBounds);
        all.wideBounds.extend(cloud_->wideBounds);
    }
    return all;
}

void CloudView::look(const Vector3d& forward, const Vector3d& up) { look(forward, up, extent().mainBounds); }

void CloudView::look(const Vector3d& forward, const Vector3d& up, const Box3f& all) {
    if (!cloud_ || all.isEmpty()) return;
    pose_ = lookingAt(all, forward, up, pose_, aspect());
    asked_ = forward;
    centre_ = pose_.focus;
    applyCamera();
}

void CloudView::viewFromScanner() {
    static const CloudGeometry nothing;
    frameFromScanner(cloud_ ? *cloud_ : nothing);
}

void CloudView::frameFromScanner(const CloudGeometry& cloud) {
    pose_ = fromScanner(cloud, pose_, aspect());
    asked_ = Vector3d::Zero();
    centre_ = pose_.focus;
    framed_ = &cloud == cloud_.get() ? std::optional(pose_) : std::nullopt;
    applyCamera();
}

std::vector<CloudView::Sample> CloudView::samples() const {
    constexpr std::size_t kLooks = 2000;
    std::vector<Sample> samples;
    const ScreenView view = screenView();
    const std::size_t cells = cloud_ ? cloud_->cells() : 0, looks = std::min(cells, kLooks);
    for (std::size_t n = 0; n < looks; ++n) {
        const std::size_t k = n * cells / looks + (n * 7919) % std::max<std::size_t>(1, cells / looks); // of all columns
        if (cloud_->drawable(k)) samples.push_back({cloud_->point(k), pixelIn(view, cloud_->point(k))});
    }
    return samples;
}

double CloudView::shareInPicture() const {
    const std::vector<Sample> all = samples();
    const auto seen = std::ranges::count_if(all, [&](const Sample& each) { return each.pixel && QRectF(rect()).contains(*each.pixel); });
    return all.empty() ? 0.0 : static_cast<double>(seen) / static_cast<double>(all.size());
}

void CloudView::resetView() {
    clip_ = {};
    viewFromScanner();
}

const ViewFrame& CloudView::axes() const {
    static const ViewFrame none;
    return axes_ ? *axes_ : cloud_ ? cloud_->axes : none;
}

void CloudView::viewFront() {
    if (cloud_) look(axes().forward, axes().up);
}
void CloudView::viewBack() {
    if (cloud_) look(-axes().forward, axes().up);
}
void CloudView::viewLeft() {
    if (cloud_) look(axes().right, axes().up);
}
void CloudView::viewRight() {
    if (cloud_) look(-axes().right, axes().up);
}
void CloudView::viewTop() {
    if (cloud_) look(-axes().up, axes().forward);
}
void CloudView::viewBottom() {
    if (cloud_) look(axes().up, -axes().forward); // right stays right, as in Front
}
void CloudView::viewIsometric() {
    if (!cloud_) return;
    const bool fromBelow = cloud_->scannerView.forward.dot(axes().up) > 0.3; // from above, the backs of the rocks would be seen
    look((axes().forward - axes().right + (fromBelow ? 1.0 : -1.0) * axes().up).normalized(), axes().up);
}
void CloudView::zoomToFit() {
    const Box3f all = extent().wideBounds;
    if (!cloud_ || all.isEmpty()) return;
    const CameraPose before = pose_;
    const bool isScanners = pose_.forward().isApprox(cloud_->scannerView.forward, 1e-6) && !pose_.forward().isApprox(asked_, 1e-6);
    if (isScanners) viewFromScanner();
    if (!isScanners || pose_ == before) look(pose_.forward(), pose_.up, all);
}

void CloudView::zoomToCells(const CellIndices& cells) {
    if (!cloud_) return;
    Box3f box;
    for (const std::uint32_t k : cells) {
        if (cloud_->drawable(k)) box.extend(cloud_->point(k));
    }
    if (box.isEmpty()) return;
    box.extend(box.center() + Eigen::Vector3f::Constant(0.05F)); // a single point would have a box without size
    pose_ = lookingAt(box, pose_.forward(), pose_.up, pose_, aspect());
    centre_ = pose_.focus;
    applyCamera();
}

void CloudView::flyTo(qint64 cell) {
    if (!cloud_ || cell < 0 || !cloud_->drawable(static_cast<std::size_t>(cell))) return;
    const Vector3d point = cloud_->point(static_cast<std::size_t>(cell)).cast<double>();
    const double nearby = std::min(pose_.distance(), 0.15 * static_cast<double>(cloud_->mainBounds.diagonal().norm()));
    const Vector3d forward = pose_.forward();
    pose_.position = point - forward * std::max(0.1, nearby);
    pose_.focus = point;
    centreOn(point);
}

void CloudView::setParallel(bool on) {
    if (pose_.parallel == on) return;
    pose_.parallel = on;
    applyCamera();
    emit parallelChanged(on);
}

void CloudView::setTurntable(bool on) {
    turntable_ = on;
    emit turntableChanged(on);
}

} // namespace edgescan::ui
