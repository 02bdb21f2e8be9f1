// Mouse and wheel of the rock tools: choosing segments of a rock, lines, the region of interest.
#include "core/rocks/selection/region_of_interest.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"

#include <algorithm>
#include <array>

namespace edgescan::ui {
namespace {

CellDrag::Wanted wantedBy(RockTool tool) {
    if (tool == RockTool::None) return CellDrag::Wanted::Nothing;
    return tool == RockTool::Split ? CellDrag::Wanted::Wheel : CellDrag::Wanted::Drag;
}

} // namespace

QString promptOf(RockTool tool) {
    switch (tool) {
    case RockTool::None:
        return {};
    case RockTool::Split:
        return Rocks::tr("Split: click the part that is a rock of its own (wheel: smaller or larger)");
    case RockTool::Join:
        return Rocks::tr("Merge: drag a line across the rocks, or click the one that belongs to the selected rock");
    case RockTool::Cut:
        return Rocks::tr("Cut: drag a line through the rock, or click both its ends");
    case RockTool::Region:
        return Rocks::tr("Region: drag a line around it");
    }
    return {};
}

void Rocks::useTool(RockTool tool) {
    if (tool != RockTool::None && (!on_ || !picture_)) tool = RockTool::None;
    if (tool != RockTool::None && views_.tool() != Tool::Pin) views_.setTool(Tool::Pin); // one tool at a time
    const RockTool before = std::exchange(tool_, tool);
    if (before != tool) {
        cutFrom_.reset();
        drag_.want(wantedBy(tool));
        views_.setPinsOnClick(tool == RockTool::None); // a click of a tool changes rocks and no target
        views_.setTrail({});
        familyPicture_ = nullptr;
        tip_.hide(); // what it says belongs to the tool
        if (before == RockTool::Split) showSelection();
    }
    emit toolChanged(tool_); // also if it was refused: a pressed switch goes back
}

void Rocks::choosePieceAt(std::size_t cell) {
    const Grid<std::uint32_t>& leaf = picture_->study.segmentation->segment;
    if (familyPicture_ == picture_ && leaf[familyCell_] == leaf[cell]) return;
    const rocks::Study& study = picture_->study;
    family_ = rocks::wheelPiecesAt(*study.segmentation, *study.tree, study.settings.level, static_cast<std::uint32_t>(cell), study.edits);
    familyPicture_ = picture_;
    familyCell_ = cell;
    piece_ = family_.split;
}

void Rocks::stepPiece(int by) {
    if (familyPicture_ == nullptr || familyPicture_ != picture_ || family_.nested.pieces.empty()) return;
    const int last = static_cast<int>(family_.nested.pieces.size()) - 1;
    piece_ = static_cast<std::size_t>(std::clamp(static_cast<int>(piece_) + by, 0, last));
    showPiece(nullptr);
}

// Shows the segment's outline in all views, and the effect of a click.
void Rocks::showPiece(const QObject* from) {
    if (family_.nested.pieces.empty()) return;
    const rocks::NestedPiece& piece = family_.nested.pieces[piece_];
    const Grid<std::uint32_t>& leaf = picture_->study.segmentation->segment;
    std::vector<std::uint8_t> isOfPiece(picture_->study.segmentation->sums.size(), 0);
    for (const std::uint32_t n : piece.segments) isOfPiece[n] = 1;
    Grid<std::uint32_t> mask(leaf.lines, leaf.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = isOfPiece[leaf[k]];
    RockOutline outline = outlineOf(mask, 1);
    QString does = tr("the whole piece as it is");
    if (piece_ < family_.nested.region) does = tr("a click splits it off");
    if (piece_ > family_.nested.region) does = tr("larger than the rock: a click merges it");
    const bool smallest = piece_ == 0, largest = piece_ + 1 == family_.nested.pieces.size();
    const QString wheel = smallest && largest ? tr("no smaller and no larger part")
                          : smallest          ? tr("wheel: larger (this is the smallest part)")
                          : largest           ? tr("wheel: smaller (this is the largest piece)")
                                              : tr("wheel: smaller or larger");
    const QString tip = tr("%1 cells, %2").arg(countText(piece.cells), does) + QStringLiteral(" · ") + wheel;
    views_.setOutline(outline.sides, std::move(outline.cells));
    tip_.show(familyCell_, tip, from);
}

void Rocks::splitAt(std::size_t cell) {
    if (picture_->regionAt(cell) == nullptr) {
        useTool(RockTool::None);
        notice_.showHint(tr("Nothing was split: click on a rock, on the part that is a rock of its own."));
        return;
    }
    choosePieceAt(cell);
    const bool isLarger = piece_ > family_.nested.region;
    rocks::Edit edit = family_.nested.pieces[piece_].edit;
    auto joinedSplit = rocks::editsOfSplit(*picture_->study.segmentation, family_, piece_);
    useTool(RockTool::None);
    if (joinedSplit) { // all edits of these rocks but the joins: a later one is not in it
        if (picture_->study.edits != edits_)
            return notice_.showHint(tr("The rocks are still being computed: split again when they are here."));
        select({cell});
        return pushEdits(stepName("split of a rock"), std::move(*joinedSplit), rocks::EditKind::Part);
    }
    if (edit.cells.empty()) {
        notice_.showHint(tr(
            "Nothing was split: this rock is one piece without a line that separates parts. Cut along a Line splits it where you draw."));
        return;
    }
    select({cell});
    std::vector<rocks::Edit> added{std::move(edit)};
    if (isLarger) return push(stepName("merge of rocks"), std::move(added));
    // The operator says that the part is a rock of its own: alone it may look like a wall.
    if (picture_->labelAt(cell) != 0) added.push_back({rocks::EditKind::Rock, {static_cast<std::uint32_t>(cell)}});
    push(stepName("split of a rock"), std::move(added));
}

/// Two clicks are the ends of a straight line, as of a measurement. False: this click was the first one.
bool Rocks::completesCut(std::vector<QPoint>& cells) {
    constexpr std::size_t kMostOfClick = 2; // cells that a hand may touch
    if (tool_ != RockTool::Cut || cells.empty() || cells.size() > kMostOfClick) return true;
    if (!cutFrom_) {
        cutFrom_ = cells.front();
        notice_.showHint(tr("Click the other end of the line, past the other side of the rock."));
        return false;
    }
    cells = {*cutFrom_, cells.back()};
    return true;
}

void Rocks::applyStroke(std::vector<QPoint> cells) {
    if (!completesCut(cells)) return;
    const RockTool tool = tool_;
    useTool(RockTool::None);
    if (!picture_) return;
    if (tool == RockTool::Region) return applyRegion(cells);
    rocks::CutLine stroke;
    for (const QPoint& cell : cells) stroke.push_back(static_cast<std::uint32_t>(picture_->labels.index(cell.y(), cell.x())));
    if (!cells.empty() && !picture_->labels.contains(cells.back().y(), cells.back().x())) stroke.clear(); // of a sweep that grew meanwhile
    if (tool == RockTool::Join) applyJoin(stroke);
    if (tool == RockTool::Cut)
        cutter_.ask({picture_, std::move(stroke), stream_, chosen() ? std::optional(static_cast<std::uint32_t>(*chosen())) : std::nullopt});
}

void Rocks::applyCut(const CutAsked& asked, const std::vector<rocks::Edit>& cut) {
    if (asked.stream != stream_) return; // the cells are of another scan
    if (!cut.empty()) {
        const rocks::Edit& part = cut.back();
        const auto* whole = asked.of->regionAt(part.cells.front());
        const bool isSelected = selected_.size() == 1 && asked.of->regionAt(selected_.front()) == whole;
        if (part.kind == rocks::EditKind::Whole && !isSelected) select({part.cells.front()}); // the card shows what was cut
        return push(stepName("cut of a rock"), cut);
    }
    notice_.showHint(tr("Nothing was cut: draw the line through a rock, from one side to the other. Each part needs %1 cells.")
                         .arg(rocks::kFewestSplit));
    writeWaiting();
}

void Rocks::applyJoin(const rocks::CutLine& stroke) {
    const rocks::Study& study = picture_->study;
    auto join = rocks::joinAlong(*study.segmentation, study.map, stroke);
    if (!join && !stroke.empty() && chosen()) {
        const std::array<std::uint32_t, 2> cells{static_cast<std::uint32_t>(*chosen()), stroke.back()};
        join = rocks::joinOf(*study.segmentation, study.map, cells);
    }
    if (join) return push(stepName("merge of rocks"), {std::move(*join)});
    notice_.showHint(tr("Nothing was merged: draw the line from one rock over the crack into the next."));
}

void Rocks::applyRegion(const std::vector<QPoint>& cells) {
    std::vector<rocks::RegionCorner> drawn;
    for (const QPoint& cell : cells) drawn.push_back({cell.y(), cell.x()});
    OperatorEdits after = operatorEdits();
    after.region = rocks::regionOfDrawing(drawn);
    if (after.region.empty())
        notice_.showHint(tr("There is no region yet: draw the line round what counts, in one of the images."));
    else
        pushOperatorEdits(stepName("region of interest"), std::move(after));
}

void Rocks::clearRegion() {
    if (settings_.region.empty()) return;
    OperatorEdits after = operatorEdits();
    after.region.clear();
    pushOperatorEdits(stepName("region of interest"), std::move(after));
}

} // namespace edgescan::ui
