// The mouse in the three views: pointing, clicks, menus and boxes.
#include "ui/base/count_text.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QCursor>
#include <QGuiApplication>
#include <QMenu>
#include <QPolygonF>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace edgescan::ui {

void LinkedViews::setTool(Tool tool) {
    tool_ = tool;
    const DragTool drag = tool == Tool::Box ? DragTool::Box : tool == Tool::Lasso ? DragTool::Lasso : DragTool::Move;
    for (ImageView* view : images_) view->setDragTool(drag);
    cloud_.setDragTool(drag);
    emit toolChanged();
}

void LinkedViews::setPinsOnClick(bool on) {
    if (std::exchange(pinsOnClick_, on) != on) emit toolChanged();
}

void LinkedViews::setChoosesOnly(bool on) {
    if (std::exchange(choosesOnly_, on) != on) emit toolChanged();
}

void LinkedViews::linkImages() {
    for (ImageView* view : images_) {
        connect(view, &ImageView::hovered, this, [this, view](int line, int beam) {
            if (const auto cell = visibleCellAt(*view, line, beam)) hover(cell, view);
        });
        connect(view, &ImageView::hoverLeft, this, [this, view] { hover(std::nullopt, view); });
        connect(view, &ImageView::clicked, this, [this, view](int line, int beam) {
            if (refusesClicks(*view)) return;
            if (const auto cell = visibleCellAt(*view, line, beam)) clickAt(*cell);
        });
        connect(view, &ImageView::markClicked, this, [this, view](const MarkName& mark, int line, int beam) {
            if (!refusesClicks(*view)) clickMark(mark, line < 0 ? std::nullopt : visibleCellAt(*view, line, beam));
        });
        connect(view, &ImageView::outlined, this, [this, view](const QPolygonF& corners, Qt::KeyboardModifiers modifiers) {
            if (!refusesClicks(*view)) emit imageOutlined(corners, modifiers);
        });
        connect(view, &ImageView::menuRequested, this,
                [this, view](int line, int beam, const QPoint& position) { openMenuAt(position, visibleCellAt(*view, line, beam)); });
        connect(view, &ImageView::boxSelected, this, &LinkedViews::lookAtBox);
        connect(view, &ImageView::windowLevelDragged, this, &LinkedViews::changeRangeWindow);
    }
}

/// A pixel of a small edge map shows several cells: the nearest edge among them is what is seen there.
std::optional<std::size_t> LinkedViews::visibleCellAt(const ImageView& view, int line, int beam) const {
    const auto cell = cellAt(line, beam);
    const QSizeF pixels = view.viewPort()->cellSize(view.size());
    const bool drawsEdges = &view == images_[1] || scene_.overGray != nullptr;
    if (!cell || !drawsEdges || std::min(pixels.width(), pixels.height()) >= 1.0) return cell;
    const auto edge = edges::nearestEdge(*shown()->detection->mask, *cell, static_cast<int>(1.0 / pixels.height()),
                                         static_cast<int>(1.0 / pixels.width()), pixels.height() / pixels.width());
    return edge ? edge : cell;
}

void LinkedViews::linkCloud() {
    connect(&cloud_, &CloudView::refitted, this, [this] { fittedCamera_ = cloud_.camera(); });
    connect(&cloud_, &CloudView::hovered, this, [this](qint64 cell) { hover(static_cast<std::size_t>(cell), &cloud_); });
    connect(&cloud_, &CloudView::hoverLeft, this, [this] { hover(std::nullopt, &cloud_); });
    connect(&cloud_, &CloudView::clicked, this, [this](qint64 cell) {
        if (!refusesClicks(cloud_)) clickAt(static_cast<std::size_t>(cell));
    });
    connect(&cloud_, &CloudView::markClicked, this, [this](const MarkName& mark, qint64 behind, QPointF pixel) {
        if (refusesClicks(cloud_)) return;
        if (!clickMark(mark, behind < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(behind)))) clickHole(pixel);
    });
    connect(&cloud_, &CloudView::missed, this, &LinkedViews::clickHole);
    connect(&cloud_, &CloudView::outlined, this, [this](const QPolygonF& corners, Qt::KeyboardModifiers modifiers) {
        if (!refusesClicks(cloud_)) emit cloudOutlined(corners, modifiers);
    });
    connect(&cloud_, &CloudView::contextMenuRequested, this, [this](const QPoint& position, qint64 cell) {
        openMenuAt(position, cell >= 0 && !coarse_ ? std::optional(static_cast<std::size_t>(cell)) : std::nullopt);
    });
}

/// No point is at this pixel of the cloud: a measurement takes the cell of the hole, other tools say so.
void LinkedViews::clickHole(QPointF pixel) {
    const auto hole = tool_ == Tool::Measure ? cloud_.holeAt(pixel) : std::nullopt;
    if (hole && !refusesClicks(cloud_)) return clickAt(*hole);
    QToolTip::showText(QCursor::pos(), tr("The scanner did not measure this place, or its point is hidden. Click the rock next to it."),
                       &cloud_);
}

QString LinkedViews::onlyOfB() { return tr("A is shown; go back to B to pin or to measure."); }

/// Says so. The tip is at the pointer, also for a click by a key.
bool LinkedViews::refusesClicks(QWidget& view) const {
    const QString why = coarse_     ? tr("Cells can be clicked when the whole scan is here: this is a coarse picture of it.")
                        : flipped() ? onlyOfB()
                                    : QString();
    if (why.isEmpty()) return false;
    QToolTip::showText(QCursor::pos(), why, &view);
    return true;
}

bool LinkedViews::isTarget(std::size_t cell) const {
    return std::ranges::any_of(marks_.targets, [cell](const TargetMark& mark) { return mark.isTarget && mark.cell == cell; });
}

void LinkedViews::openMenuAt(const QPoint& position, std::optional<std::size_t> cell) {
    if (!cell || flipped()) return openMenu(position, std::nullopt);
    openMenu(position, isTarget(*cell) ? inspect::exactly(*cell) : nearSideCell(*cell));
}

void LinkedViews::openMenu(const QPoint& position, const std::optional<inspect::ClickedCell>& click) {
    QMenu menu;
    menu.setObjectName("cell-menu");
    if (click) {
        const std::size_t cell = click->clicked;
        emit cellMenuOpens(menu, *click);
        if (pinned_ != cell && pinned_ != click->cell) menu.addAction(tr("&Pin this cell"), this, [this, click] { pinByClick(*click); });
        QAction* fly = menu.addAction(tr("&Fly to this point"), this, [this, cell] { cloud_.flyTo(static_cast<qint64>(cell)); });
        fly->setEnabled(shown() && shown()->cloud->drawable(cell));
        menu.addSeparator();
    }
    menu.addAction(tr("View from &scanner"), &cloud_, &CloudView::viewFromScanner);
    menu.addAction(tr("F&it the cloud"), &cloud_, &CloudView::zoomToFit);
    if (!gray().viewPort()->fitted()) menu.addAction(tr("Fit the &images"), this, [this] { gray().viewPort()->fit(); });
    menu.exec(position);
}

/// Shift takes the clicked cell itself, whatever is near.
void LinkedViews::clickAt(std::size_t cell) {
    click(QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier) ? inspect::exactly(cell) : nearSideCell(cell));
}

/// A click on a target, or on its label, chooses it. Tools take the cell of a target where its ring is clicked, and otherwise what is
/// behind the mark: a label may be far from its cell, and moves. Why explains what is in the ring unless its centre is clicked.
/// False: the click is about what is behind the mark, where nothing was measured.
bool LinkedViews::clickMark(const MarkName& mark, std::optional<std::size_t> behind) {
    const bool whole = mark.which < marks_.measures.size() && !marks_.measures[mark.which].label.isEmpty();
    constexpr double kCentre = 4.0; // px
    const auto apart = tool_ == Tool::Why && !mark.isMeasure && behind ? pixelsBetween(mark.which, *behind) : std::nullopt;
    if (pinsOnClick_ && choosesOnly_ && !mark.isMeasure && tool_ == Tool::Pin)
        pin(mark.which);
    else if (apart && *apart > kCentre)
        clickAt(*behind);
    else if (pinsOnClick_ && !mark.isMeasure && (tool_ == Tool::Pin || !mark.byLabel))
        click(inspect::exactly(mark.which));
    else if (whole && tool_ == Tool::Pin && pinsOnClick_)
        emit measureClicked(mark.which);
    else if (behind)
        clickAt(*behind);
    else
        return false;
    return true;
}

bool LinkedViews::clickPins() const {
    const Qt::KeyboardModifiers keys = QGuiApplication::keyboardModifiers();
    return tool_ == Tool::Pin && pinsOnClick_ && !keys.testFlag(Qt::ControlModifier) && (!choosesOnly_ || keys.testFlag(Qt::ShiftModifier));
}

void LinkedViews::click(const inspect::ClickedCell& click) {
    if (refusesClicks(gray())) return;
    if (clickPins())
        pinByClick(click);
    else
        for (ImageView* view : images_) view->setCrosshair(pinned_ ? std::optional(placeOf(*pinned_)) : std::nullopt);
    emit clicked(click);
}

/// All three views zoom to the content of the box; the box stays drawn until Esc.
void LinkedViews::lookAtBox(const QRect& cells) {
    if (!shown()) return;
    const Scan& scan = *shown()->detection->scan;
    const QRect inside = cells.intersected(QRect(0, 0, scan.beams(), scan.lines()));
    if (inside.isEmpty()) return;
    box_ = inside;
    for (ImageView* view : images_) view->setBox(inside);
    gray().viewPort()->fitTo(QRectF(inside));
    if (const auto points = showBox(); !points.empty()) cloud_.zoomToCells(points);
}

/// Returns the points in the box; its text is of the picture that is shown.
std::vector<std::uint32_t> LinkedViews::showBox() {
    std::vector<std::uint32_t> held;
    if (!box_ || !shown()) return held;
    const Scan& scan = *shown()->detection->scan;
    const QRect inside = box_->intersected(QRect(0, 0, scan.beams(), scan.lines()));
    std::size_t edges = 0;
    double nearest = 0.0, farthest = 0.0;
    for (int line = inside.top(); line <= inside.bottom(); ++line) {
        for (int beam = inside.left(); beam <= inside.right(); ++beam) {
            const std::size_t k = scan.rangeMm.index(line, beam);
            edges += (*shown()->detection->mask)[k] != 0 ? 1 : 0;
            if (scan.state[k] != CellState::Valid) continue;
            const double range = static_cast<double>(scan.rangeMm[k]) / 1000.0;
            nearest = held.empty() ? range : std::min(nearest, range);
            farthest = held.empty() ? range : std::max(farthest, range);
            held.push_back(static_cast<std::uint32_t>(k));
        }
    }
    QString words = tr("box of %1 × %2 cells: %3 points, %4 edge cells")
                        .arg(inside.height())
                        .arg(inside.width())
                        .arg(countText(held.size()), countText(edges));
    if (!held.empty()) words += tr(", ranges %1 to %2 m").arg(nearest, 0, 'f', 2).arg(farthest, 0, 'f', 2);
    emit boxed(words);
    return held;
}

} // namespace edgescan::ui
