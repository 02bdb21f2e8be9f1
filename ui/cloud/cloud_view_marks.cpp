// What somebody put over the cloud: targets, measurements, a selection, cells that are hidden.
#include "ui/cloud/cloud_scene.h"
#include "ui/cloud/cloud_view.h"

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
    pointAt(std::nullopt);
    showParts();
    guessBudget();
    restTimer_.start(kRestMs);
    updateOverlay();
    requestFrame();
}

/// All that belongs to the cells of the cloud anew, as it was.
void CloudView::showParts() {
    scene_->setCloud(cloud_);
    scene_->setEdges(edges_);
    scene_->setFaces(faces_);
    scene_->setOutline(outline_);
    scene_->setSelection(selection_);
    applyColours();
}

void CloudView::setDragTool(DragTool tool) { tool_ = tool; }

void CloudView::setMarks(CellMarks marks) {
    if (marks == marks_) return;
    marks_ = std::move(marks);
    updateOverlay();
}

/// Whether something lies before a point costs a look at all near it: of a crowd of targets only the active one is asked.
ScreenMarks CloudView::marksOnScreen() const {
    constexpr std::size_t kCrowd = 20;
    const ScreenView view = screenView();
    return screenMarks(marks_, [&](std::size_t cell) -> std::optional<MarkPlace> {
        const auto k = static_cast<std::uint32_t>(cell);
        const auto at = pixelOf(k);
        if (!at) return std::nullopt;
        const bool ask = marks_.targets.size() <= kCrowd || marked_ == k;
        return MarkPlace{*at, ask && isPointHidden(*cloud_, view, k)};
    });
}

} // namespace edgescan::ui
