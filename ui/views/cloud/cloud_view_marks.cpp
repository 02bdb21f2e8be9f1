// What is over the cloud: targets, measurements, a selection, hidden cells, other scans.
#include "core/base/order_statistic.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/views/cloud/cloud_scene.h"
#include "ui/views/cloud/cloud_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr double kLayerPickPx = 8.0;
constexpr double kInFrontM = 0.05; // of surfaces that both scans see, neither is in front

Box3f placed(const Box3f& box, const RigidTransform& place) {
    Box3f out;
    for (int n = 0; n < 8 && !box.isEmpty(); ++n) {
        const Eigen::Vector3d corner = box.corner(static_cast<Box3f::CornerType>(n)).cast<double>();
        out.extend((place * corner).cast<float>());
    }
    return out;
}

Eigen::Matrix4d matrixOf(const RigidTransform& place) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = place.rotation;
    matrix.topRightCorner<3, 1>() = place.translationM;
    return matrix;
}

constexpr double kArrowReach = 30.0; // px: of a finger

} // namespace

void CloudView::setLayers(std::vector<CloudLayer> layers) {
    if (layers == layers_) return;
    const bool others = layers.size() != layers_.size();
    layers_ = std::move(layers);
    placeLayers();
    if (others) guessBudget();
    moved();
}

/// By the origin of the shown cloud.
void CloudView::placeLayers() {
    const Eigen::Vector3d origin = cloud_ ? cloud_->originM : Eigen::Vector3d::Zero();
    layersBounds_ = {};
    layersMain_ = {};
    for (const CloudLayer& layer : layers_) {
        layersBounds_.extend(placed(layer.cloud->bounds, layer.local(origin)));
        layersMain_.extend(placed(layer.cloud->mainBounds, layer.local(origin)));
    }
    scene_->setLayers(layers_, origin);
}

/// The layer whose point is drawn in front of the cell's point, or in front of nothing.
std::optional<int> CloudView::layerInFront(QPointF pixel, const std::optional<std::uint32_t>& of) const {
    const ScreenView view = screenView();
    const double dpr = devicePixelRatioF();
    std::optional<int> found;
    const auto depthOf = [this](const Eigen::Vector3d& p) { return pose_.forward().dot(p - pose_.position); };
    double depth = of ? depthOf(cloud_->point(*of).cast<double>()) - kInFrontM : std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < layers_.size(); ++n) {
        const CloudLayer& layer = layers_[n];
        const RigidTransform local = layer.local(cloud_->originM);
        ScreenView there = view;
        there.worldToClip = view.worldToClip * matrixOf(local);
        const auto cell = pickPoint(*layer.cloud, there, pixel.x() * dpr, pixel.y() * dpr, kLayerPickPx * dpr);
        if (!cell) continue;
        const double at = depthOf(local * layer.cloud->point(*cell).cast<double>());
        if (at >= depth) continue;
        depth = at;
        found = static_cast<int>(n);
    }
    return found;
}

void CloudView::keepReady(const std::shared_ptr<const CloudGeometry>& cloud) {
    scene_->keepReady(cloud);
    requestFrame();
}

void CloudView::lookAtCells(const CellIndices& cells) {
    if (!cloud_) return;
    constexpr double kRim = 0.04, kAround = 0.35;
    constexpr float kLeastShare = 0.06F; // of the cloud: a small rock is recognised by what is around it
    std::array<std::vector<float>, 3> places;
    for (const std::uint32_t k : cells) {
        if (!cloud_->drawable(k)) continue;
        for (int axis = 0; axis < 3; ++axis) places[static_cast<std::size_t>(axis)].push_back(cloud_->point(k)[axis]);
    }
    if (places[0].empty()) return;
    Eigen::Vector3f least, most;
    for (int axis = 0; axis < 3; ++axis) {
        auto& values = places[static_cast<std::size_t>(axis)];
        least[axis] = quantile(values, kRim);
        most[axis] = quantile(values, 1.0 - kRim);
    }
    const float sizeM = (most - least).maxCoeff(), leastM = kLeastShare * cloud_->mainBounds.diagonal().norm();
    const Eigen::Vector3f around = Eigen::Vector3f::Constant(std::max(static_cast<float>(kAround) * sizeM, 0.5F * (leastM - sizeM)));
    const Box3f box(least - around, most + around);
    pose_ = lookingAtFrom(cloud_->sensor.cast<double>(), box, cloud_->scannerView.up, pose_, aspect());
    centre_ = pose_.focus;
    applyCamera();
}

void CloudView::centreOn(const Eigen::Vector3d& point) {
    pose_ = centredOn(pose_, point);
    centre_ = point;
    applyCamera();
}

std::function<bool(QPointF)> CloudView::freePixels() const {
    return [plates = overlay_->platesOver(), view = QRectF(rect())](QPointF pixel) {
        return view.contains(pixel) && std::ranges::none_of(plates, [&](const QRectF& plate) { return plate.contains(pixel); });
    };
}

void CloudView::setSelection(std::shared_ptr<const CellIndices> cells) {
    if (cells == selection_) return;
    selection_ = std::move(cells);
    scene_->setSelection(selection_);
    requestFrame();
}

/// The points stay in the graphics memory. Hidden cells leave the drawing order and cannot be picked.
void CloudView::setHidden(std::shared_ptr<const std::vector<std::uint8_t>> hidden) {
    if (hidden == hidden_) return;
    hidden_ = std::move(hidden);
    cloud_ = whole_ && hidden_ ? withoutHidden(*whole_, *hidden_) : whole_;
    screenMarks_.reset();
    pointAt(std::nullopt);
    showParts();
    guessBudget();
    restTimer_.start(kRestMs);
    updateOverlay();
    requestFrame();
    emit pointsChanged();
}

/// Applies all layers of the cloud's cells again, without a change.
void CloudView::showParts() {
    scene_->setCloud(cloud_);
    scene_->setEdges(edges_);
    scene_->setFaces(pointColours());
    scene_->setOutline(outline_);
    scene_->setSelection(selection_);
    applyColours();
}

void CloudView::setColours(std::shared_ptr<const CloudGeometry> of, std::shared_ptr<const CellIndices> colours) {
    const auto before = pointColours();
    colouredCloud_ = std::move(of);
    colours_ = std::move(colours);
    if (pointColours() == before) return;
    scene_->setFaces(pointColours());
    requestFrame();
}

std::shared_ptr<const CloudView::CellIndices> CloudView::pointColours() const {
    return faces_ ? faces_ : whole_ && whole_ == colouredCloud_ ? colours_ : nullptr;
}

void CloudView::setGround(bool on) {
    ground_ = on;
    showGround();
    requestFrame();
}

void CloudView::showGround() {
    const GroundGrid grid = ground_ && whole_ ? groundOf(*whole_) : GroundGrid{}; // no grid for a cloud without points
    groundStepM_ = grid.stepM;
    scene_->setGround(grid);
}

void CloudView::setDragTool(DragTool tool) { tool_ = tool; }

void CloudView::setMarks(CellMarks marks) {
    if (marks == marks_) return;
    marks_ = std::move(marks);
    screenMarks_.reset();
    updateOverlay();
}

/// Of another view the cell under the pointer, else what the operator chose.
std::optional<std::uint32_t> CloudView::chosenCell() const {
    if (marked_ && !hoveredCell_) return marked_;
    if (const auto target = std::ranges::find_if(marks_.targets, &TargetMark::active); target != marks_.targets.end())
        return static_cast<std::uint32_t>(target->cell);
    const auto measure = std::ranges::find_if(marks_.measures, &MeasureMark::active);
    if (measure != marks_.measures.end() && !measure->cells.empty()) return static_cast<std::uint32_t>(measure->cells.front());
    return marked_;
}

/// A point behind the camera is reached by turning the same way as to one in front of it.
std::optional<QPointF> CloudView::wayOutTo(std::uint32_t cell) const {
    if (!cloud_ || !cloud_->drawable(cell)) return std::nullopt;
    const Eigen::Vector3d by = cloud_->point(cell).cast<double>() - pose_.position;
    if (pose_.parallel || by.dot(pose_.forward()) > 0.0) {
        const ScreenPoint at = toScreen(screenView(), cloud_->point(cell));
        if (QRectF(rect()).contains(QPointF(at.x, at.y) / devicePixelRatioF())) return std::nullopt;
    }
    const QPointF way(by.dot(pose_.right()), -by.dot(pose_.right().cross(pose_.forward())));
    const double length = std::hypot(way.x(), way.y());
    return length > 0.0 ? way / length : QPointF(0.0, 1.0);
}

bool CloudView::followArrow(QPointF pixel) {
    const auto arrow = overlay_->arrow();
    const auto cell = chosenCell();
    if (!arrow || !cell || QLineF(arrow->center(), pixel).length() > kArrowReach) return false;
    flyTo(*cell);
    return true;
}

std::optional<MarkName> CloudView::markUnder(QPointF pixel) const {
    return markAt(overlay_->marks().marks, overlay_->tags(), pixel, touch_.mouseIsFinger());
}

/// Testing whether a point is hidden visits all points near it. With many targets only the active one is tested.
const ScreenMarks& CloudView::marksOnScreen() {
    if (screenMarks_) return *screenMarks_; // moving the mouse over the points does not change them
    const ScreenView view = screenView();
    const auto isHidden = [&](std::size_t cell) {
        const auto k = static_cast<std::uint32_t>(cell);
        return (marks_.targets.size() <= kMarksAsked || marked_ == k) && isPointHidden(*cloud_, view, k);
    };
    screenMarks_ = screenMarks(
        marks_, [&](std::size_t cell) { return pixelOf(static_cast<std::uint32_t>(cell)); }, false, isHidden);
    return *screenMarks_;
}

} // namespace edgescan::ui
