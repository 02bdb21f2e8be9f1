// The mouse in linked views, and the pictures of a sweep that grows.
#include "core/base/order_statistic.h"
#include "core/scan/grid/mean_step.h"
#include "core/scan/grid/scan.h"
#include "ui/base/count_text.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_geometry.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QCursor>
#include <QGuiApplication>
#include <QMenu>
#include <QPolygonF>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

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

namespace {

constexpr int kCoarseSide = 33;     // lines and beams of the coarse cloud
constexpr double kHalfTurn = 180.0; // degrees

float medianRange(const Scan& scan) {
    std::vector<float> ranges;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state.cells[k] == CellState::Valid) ranges.push_back(scan.rangeMm.cells[k]);
    }
    return median(std::move(ranges));
}

/// A coarse cloud in the directions of all lines of a sweep, at the median range of its first ones: a view that shows it need not move
/// while the sweep grows. `expectedLines` 0: not known, half a turn. Null: fewer than two lines, or no line angles.
std::shared_ptr<const CloudGeometry> wholeSweep(const Scan& scan, int expectedLines) {
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr || scan.placement || polar->lineDeg.size() < 2 || polar->beamDeg.size() < 2) return nullptr;
    const double step = meanStepDeg(polar->lineDeg);
    const float range = medianRange(scan);
    if (!std::isfinite(step) || step == 0.0 || range <= 0.0F) return nullptr;
    const double lines = expectedLines > 0 ? expectedLines : std::max<double>(scan.lines(), 1.0 + kHalfTurn / std::abs(step));
    PolarGeometry coarse{{}, {}, polar->axis, polar->lineDirection};
    for (int n = 0; n < kCoarseSide; ++n) {
        const double share = n / (kCoarseSide - 1.0);
        coarse.lineDeg.push_back(polar->lineDeg.front() + share * step * (lines - 1.0));
        coarse.beamDeg.push_back(std::lerp(polar->beamDeg.front(), polar->beamDeg.back(), share));
    }
    Scan whole;
    whole.rangeMm = Grid<float>(kCoarseSide, kCoarseSide, range);
    whole.state = Grid<CellState>(kCoarseSide, kCoarseSide, CellState::Valid);
    whole.geometry = std::move(coarse);
    return makeCloudGeometry(whole);
}

constexpr double kSeen = 0.1;     // share of the points: half a turn in a narrow cloud has .15
constexpr double kMuchMore = 1.2; // times
constexpr int kLinesToFit = 8;    // of a growing sweep: if their places are not known by now, the view stays where it is

/// The lines of a growing sweep got other places: its axis showed in the ranges, or the operator gave angles.
bool turnsOtherwise(const Scan& before, const Scan& now) {
    constexpr double kSameStep = 0.01; // share of the step
    constexpr double kSameStart = 1.0; // degrees
    const auto *a = std::get_if<PolarGeometry>(&before.geometry), *b = std::get_if<PolarGeometry>(&now.geometry);
    if (a == nullptr || b == nullptr || a->lineDeg.size() < 2 || b->lineDeg.size() < 2) return false;
    const double stepOfA = a->lineDirection * meanStepDeg(a->lineDeg), stepOfB = b->lineDirection * meanStepDeg(b->lineDeg);
    return a->axis != b->axis || std::abs(stepOfA - stepOfB) > kSameStep * std::abs(stepOfA) ||
           std::abs(a->lineDeg.front() - b->lineDeg.front()) > kSameStart;
}

} // namespace

/// Another sweep has directions of its own after a part of one, and a view of its own then, and where its first lines are outside of the
/// view. So has a sweep whose lines got other places. A view that the operator moved stays.
void LinkedViews::followSweep(const Picture& last, bool untouched) {
    const Growth &before = last.source.growth, &now = shown()->source.growth;
    const bool isAnother = before.sweep != now.sweep;
    const bool wasPart = isAnother && last.detection->scan->lines() < std::max(1, before.expectedLines);
    const bool hasOtherPlaces = !isAnother && now.growing && turnsOtherwise(*last.detection->scan, *shown()->detection->scan);
    const bool wasPlaced = last.detection->scan->placement != nullptr, isPlaced = shown()->detection->scan->placement != nullptr;
    if (wasPart || hasOtherPlaces || wasPlaced != isPlaced) cloud_.setAxes(std::nullopt);
    nameDirections();
    if (!untouched) return;
    if (wasPart || hasOtherPlaces || (isAnother && cloud_.shareInPicture() < kSeen)) {
        fitted_ = false;
        framedLines_ = 0;
    }
    fitToSweep();
}

/// Of the engine's picture, also while another one is shown. A sweep has those of the whole sweep, from its beginning to its end and in the
/// next sweep: the mean direction of its points turns while it grows, and one view would be Top at first and then Front.
void LinkedViews::nameDirections() {
    const Growth& growth = picture_->source.growth;
    const Scan& scan = *picture_->detection->scan;
    if (growth.sweep >= 0 && cloud_.axesSet() && !scan.placement) return;
    if (!growth.growing || scan.placement) return cloud_.setAxes(picture_->cloud->axes);
    if (const auto whole = wholeSweep(scan, growth.expectedLines)) cloud_.setAxes(whole->axes);
}

/// The view moves only where it shows, or would soon show, a small part of them.
void LinkedViews::frameFirstLines(const CameraPose& before) {
    const int lines = shown()->detection->scan->lines();
    cloud_.setCamera(before);
    if (lines < 2 * framedLines_ && cloud_.shareInPicture() >= kSeen) return;
    framedLines_ = lines;
    cloud_.viewFromScanner();
}

/// Its first lines were at other ranges, or at the angles of a part: the view moves if it shows much more of the points then.
void LinkedViews::showEndOfSweep() {
    const CameraPose before = cloud_.camera();
    const double share = cloud_.shareInPicture();
    cloud_.viewFromScanner();
    if (cloud_.shareInPicture() < kMuchMore * share) cloud_.setCamera(before);
}

/// Once, as soon as the place of its lines is known: the view shows what is to come, and does not move while it comes. A sweep may begin
/// far at a side, outside of that view: it shows the first lines until enough of what came is in it.
void LinkedViews::fitToSweep() {
    const Growth& growth = shown()->source.growth;
    if (!fitted_ && growth.growing) {
        const auto whole = wholeSweep(*shown()->detection->scan, growth.expectedLines);
        const CameraPose before = cloud_.camera();
        if (whole) cloud_.frameFromScanner(*whole);
        fitted_ = whole ? cloud_.shareInPicture() >= kSeen : shown()->detection->scan->lines() >= kLinesToFit;
        if (whole && !fitted_) frameFirstLines(before);
    } else {
        if (!fitted_ && framedLines_ > 0) cloud_.viewFromScanner(); // the sweep ended before
        if (growth.sweep >= 0 && !growth.growing) showEndOfSweep();
        fitted_ = true;
    }
    fittedCamera_ = cloud_.camera();
}

} // namespace edgescan::ui
