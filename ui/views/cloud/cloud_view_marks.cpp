// What somebody put over the cloud: targets, measurements, a selection, cells that are hidden.
#include "ui/views/cloud/cloud_scene.h"
#include "ui/views/cloud/cloud_view.h"

namespace edgescan::ui {

void CloudView::setSelection(std::shared_ptr<const CellIndices> cells) {
    if (cells == selection_) return;
    selection_ = std::move(cells);
    scene_->setSelection(selection_);
    requestFrame();
}

/// The points stay where they are in the memory; what is hidden is no part of the drawing order, and no point to be picked.
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

/// All that belongs to the cells of the cloud anew, as it was.
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
    const GroundGrid grid = ground_ && whole_ ? groundOf(*whole_) : GroundGrid{}; // none of a cloud without a point
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

/// Whether something lies before a point costs a look at all near it: of a crowd of targets only the active one is asked.
const ScreenMarks& CloudView::marksOnScreen() {
    if (screenMarks_) return *screenMarks_; // a mouse that moves over the points moves none of them
    const ScreenView view = screenView();
    screenMarks_ = screenMarks(marks_, [&](std::size_t cell) -> std::optional<MarkPlace> {
        const auto k = static_cast<std::uint32_t>(cell);
        const auto at = pixelOf(k);
        if (!at) return std::nullopt;
        const bool ask = marks_.targets.size() <= kMarksAsked || marked_ == k;
        return MarkPlace{*at, ask && isPointHidden(*cloud_, view, k)};
    });
    return *screenMarks_;
}

} // namespace edgescan::ui
