// The mouse and the camera of the cloud.
#include "ui/views/cloud/cloud_view.h"

#include "ui/views/cloud/cloud_scene.h"

#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace edgescan::ui {
namespace {

using Eigen::Vector3d;

constexpr double kPickPx = 8.0;
constexpr double kNextToEdgePx = 2.0; // the dark outline of a drawn edge, and a pixel more
constexpr double kSameCursorPx = 3.0;
constexpr int kShowCentreMs = 600;
constexpr double kZoomPerNotch = 1.2;
constexpr double kClipPerNotch = 0.02, kMostClipped = 0.98; // of the depth

} // namespace

bool CloudView::event(QEvent* event) {
    if (touch_.read(event)) return true;
    // Bypasses VTK's interactor, which would handle the mouse too.
    const bool taken = QOpenGLWidget::event(event);
    if (event->type() == QEvent::ScreenChangeInternal) fitPane(); // another screen, perhaps with other pixels
    return taken;
}

void CloudView::pinch(QPointF middle, QPointF shift, double factor) {
    const Vector3d anchor = anchorAt(middle - shift); // the point between the fingers stays between them
    pose_ = panned(pose_, anchor, shift.x(), shift.y(), height());
    pose_ = zoomed(pose_, anchor, std::clamp(factor, 0.5, 2.0));
    moved();
}

Vector3d CloudView::anchorAt(QPointF pixel) const {
    if (const auto cell = cellAt(pixel)) return cloud_->point(*cell).cast<double>();
    const double x = 2.0 * pixel.x() / std::max(1, width()) - 1.0;
    const double y = 1.0 - 2.0 * pixel.y() / std::max(1, height());
    const double depth = pose_.forward().dot(centre_ - pose_.position);
    return underCursor(pose_, x, y, depth > 0.0 ? depth : pose_.distance(), aspect());
}

/// Of an edge that is drawn over the pixel, or whose dark outline is next to it: several points may be nearer, far behind the edge.
std::optional<std::uint32_t> CloudView::edgeAt(QPointF pixel) const {
    if (!edgesDrawn() || edges_.all == nullptr) return std::nullopt;
    const double dpr = devicePixelRatioF();
    return pickDrawnOver(*cloud_, screenView(), pixel.x() * dpr, pixel.y() * dpr, pixelsOfEdge() / 2.0 + kNextToEdgePx * dpr, *edges_.all);
}

std::optional<std::uint32_t> CloudView::cellAt(QPointF pixel) const {
    if (!cloud_) return std::nullopt;
    const double dpr = devicePixelRatioF();
    const auto edge = edgeAt(pixel);
    const auto cell = edge ? edge : pickPoint(*cloud_, screenView(), pixel.x() * dpr, pixel.y() * dpr, kPickPx * dpr);
    // What a layer covers is not what the operator points at.
    return cell && !layers_.empty() && layerInFront(pixel, cell) ? std::nullopt : cell;
}

std::optional<std::uint32_t> CloudView::holeAt(QPointF pixel) const {
    constexpr double kReachPx = 4.0 * kPickPx; // cells without a return may be drawn far apart
    const double dpr = devicePixelRatioF();
    const auto cell = pickVoid(*cloud_, CartesianTables(*scan_), screenView(), pixel.x() * dpr, pixel.y() * dpr, kReachPx * dpr);
    return cell && scan_->state[*cell] != CellState::Valid ? cell : std::nullopt; // not a hidden point
}

void CloudView::mousePressEvent(QMouseEvent* event) {
    setFocus(Qt::MouseFocusReason);
    if (drag_ != DragAction::None) return; // a second button during a drag is ignored
    drag_ = dragAction(event->button(), event->modifiers(), mousePreset_);
    press_.begin(*event);
    if (event->button() == Qt::LeftButton && tool_ != DragTool::Move && drag_ != DragAction::None) drag_ = DragAction::Select;
    dragged_.clear();
    if (drag_ == DragAction::Rotate && cloud_) turnAxis_ = turntableAxis(pose_, axes().up, cloud_->scannerView.up);
    if (drag_ == DragAction::Pan || drag_ == DragAction::Zoom) dragAnchor_ = anchorAt(press_.from);
}

void CloudView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = place(*event);
    if (drag_ == DragAction::None) {
        pointer_ = at;
        pointAt(cellAt(at));
        return;
    }
    if (!press_.travels(at)) return;
    pointer_.reset();
    pointAt(std::nullopt);
    drag(at);
    press_.last = at;
}

void CloudView::selectTo(QPointF at) {
    if (tool_ == DragTool::Box) {
        dragged_ = QPolygonF(QRectF(press_.from, at).normalized());
        dragged_.removeLast(); // removes the closing corner
    } else {
        if (dragged_.isEmpty()) dragged_ << press_.from;
        dragged_ << at;
    }
    updateOverlay();
}

void CloudView::drag(QPointF at) {
    if (drag_ == DragAction::Select) return selectTo(at);
    const QPointF by = at - press_.last;
    if (drag_ == DragAction::Rotate) {
        const double perPixel = std::numbers::pi / std::max(1, height());
        const double right = by.x() * perPixel;
        const double up = -by.y() * perPixel;
        pose_ = turntable_ ? turned(pose_, centre_, turnAxis_, right, up) : tumbled(pose_, centre_, right, up);
        showFocus();
    } else if (drag_ == DragAction::Pan) {
        pose_ = panned(pose_, dragAnchor_, by.x(), by.y(), height());
    } else if (drag_ == DragAction::Zoom) {
        pose_ = zoomed(pose_, dragAnchor_, std::pow(1.008, -by.y()));
    } else if (drag_ == DragAction::Roll) {
        const QPointF middle = QRectF(rect()).center();
        const double degrees = QLineF(middle, press_.last).angleTo(QLineF(middle, at)); // counter-clockwise, 0 .. 360
        pose_ = rolled(pose_, std::remainder(degrees, 360.0) * std::numbers::pi / 180.0);
    }
    moved();
}

void CloudView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != press_.button || drag_ == DragAction::None) return;
    const QPointF at = place(*event);
    const bool click = !press_.travelled;
    const bool selected = std::exchange(drag_, DragAction::None) == DragAction::Select && !click;
    if (selected) {
        const QPolygonF corners = std::exchange(dragged_, {});
        updateOverlay();
        emit outlined(corners, event->modifiers());
        return;
    }
    if (!click) {
        scene_->hideFocus();
        moved();
        return;
    }
    if (event->button() == Qt::LeftButton && followArrow(at)) return;
    const auto cell = cellAt(at);
    const auto behind = cell ? static_cast<qint64>(*cell) : -1;
    const auto mark = markUnder(at);
    if (mark && choosesMarks(*event)) return emit markClicked(*mark, behind, at);
    if (event->button() == Qt::LeftButton && cell) emit clicked(*cell);
    if (event->button() == Qt::LeftButton && !cell && cloud_) {
        const auto layer = layerInFront(at, std::nullopt);
        layer ? emit layerClicked(*layer) : emit missed(at);
    }
    if (event->button() == Qt::MiddleButton) setRotationCentre(at);
    if (event->button() == Qt::RightButton) {
        emit contextMenuRequested(mapToGlobal(at.toPoint()), mark && !mark->isMeasure ? static_cast<qint64>(mark->which) : behind);
    }
}

void CloudView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) setRotationCentre(place(*event));
}

void CloudView::setRotationCentre(QPointF pixel) {
    const auto cell = cellAt(pixel);
    if (!cell) return;
    centre_ = cloud_->point(*cell).cast<double>();
    showFocus(); // until the camera rests
    moved(kShowCentreMs);
}

void CloudView::wheelEvent(QWheelEvent* event) {
    event->accept();
    const double steps = notches(*event);
    if (steps == 0.0) return;
    const WheelAction action = wheelAction(event->modifiers());
    if (action == WheelAction::Zoom) wheelZoom(event->position(), wheelReversed_ ? -steps : steps);
    if (action == WheelAction::PointSize) changePointSize(steps > 0.0 ? 1 : -1);
    if (action == WheelAction::NearClip) wheelClip(clip_.nearShare, steps);
    if (action == WheelAction::FarClip) wheelClip(clip_.farShare, -steps);
}

void CloudView::wheelZoom(QPointF pixel, double notches) {
    // One anchor for a series of wheel steps; otherwise the picture would drift when the nearest point changes.
    if (!restTimer_.isActive() || QLineF(pixel, wheelAt_).length() > kSameCursorPx) wheelAnchor_ = anchorAt(pixel);
    wheelAt_ = pixel;
    pose_ = zoomed(pose_, wheelAnchor_, std::pow(kZoomPerNotch, notches));
    moved();
}

void CloudView::wheelClip(double& share, double notches) {
    share = std::clamp(share + kClipPerNotch * notches, 0.0, kMostClipped);
    moved();
}

void CloudView::setClip(const CloudClip& clip) {
    clip_ = {std::clamp(clip.nearShare, 0.0, kMostClipped), std::clamp(clip.farShare, 0.0, kMostClipped)};
    applyCamera();
}

void CloudView::pointAt(std::optional<std::uint32_t> cell) {
    if (std::exchange(hoveredCell_, cell) == cell) return;
    if (cell)
        emit hovered(*cell);
    else
        emit hoverLeft();
}

/// A key may have moved the cloud under the pointer.
void CloudView::pointAgain() {
    if (pointer_) pointAt(cellAt(*pointer_));
}

void CloudView::leaveEvent(QEvent* event) {
    QVTKOpenGLNativeWidget::leaveEvent(event);
    pointer_.reset();
    pointAt(std::nullopt);
}

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
