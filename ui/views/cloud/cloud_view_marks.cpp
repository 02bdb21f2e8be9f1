// The operator's marks over the cloud: targets, measurements, a selection, hidden cells.
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/views/cloud/cloud_scene.h"
#include "ui/views/cloud/cloud_view.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr double kArrowReach = 30.0; // px: of a finger

} // namespace

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
