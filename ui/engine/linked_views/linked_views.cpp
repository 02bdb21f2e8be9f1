// Shows a picture in images and cloud, and links pointing at a cell in one view with the other views.
#include "ui/engine/linked_views/linked_views.h"

#include "ui/base/cell_marks.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QGuiApplication>
#include <QMenu>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {

LinkedViews::LinkedViews(const Engine& engine, ImageView& gray, ImageView& edges, CloudView& cloud)
    : engine_(engine), images_{&gray, &edges}, cloud_(cloud) {
    for (ImageView* view : images_) view->setNote(tr("Open a scan: Ctrl+O, or drop a file here"));
    cloud_.setPointSizeFollows(true);
    linkImages();
    linkCloud();
}

void LinkedViews::linkImages() {
    for (ImageView* view : images_) {
        connect(view, &ImageView::hovered, this, [this, view](int line, int beam) {
            if (const auto cell = cellAt(line, beam)) hover(cell, view);
        });
        connect(view, &ImageView::hoverLeft, this, [this, view] { hover(std::nullopt, view); });
        connect(view, &ImageView::clicked, this, [this](int line, int beam) {
            if (const auto cell = cellAt(line, beam)) click(*cell);
        });
        connect(view, &ImageView::outlined, this, &LinkedViews::imageOutlined);
        connect(view, &ImageView::cleared, this, &LinkedViews::clearPin);
        connect(view, &ImageView::menuRequested, this,
                [this](int line, int beam, const QPoint& position) { showCellMenu(position, cellAt(line, beam)); });
        connect(view, &ImageView::boxSelected, this, &LinkedViews::lookAtBox);
        connect(view, &ImageView::windowLevelDragged, this, &LinkedViews::changeRangeWindow);
    }
}

void LinkedViews::linkCloud() {
    connect(&cloud_, &CloudView::hovered, this, [this](qint64 cell) { hover(static_cast<std::size_t>(cell), &cloud_); });
    connect(&cloud_, &CloudView::hoverLeft, this, [this] { hover(std::nullopt, &cloud_); });
    connect(&cloud_, &CloudView::clicked, this, [this](qint64 cell) { click(static_cast<std::size_t>(cell)); });
    connect(&cloud_, &CloudView::outlined, this, &LinkedViews::cloudOutlined);
    connect(&cloud_, &CloudView::contextMenuRequested, this, [this](const QPoint& position, qint64 cell) {
        showCellMenu(position, cell >= 0 ? std::optional(static_cast<std::size_t>(cell)) : std::nullopt);
    });
}

// The same menu in every view: the actions for a cell do not depend on the view.
void LinkedViews::showCellMenu(const QPoint& position, std::optional<std::size_t> cell) {
    QMenu menu;
    menu.setObjectName("cell-menu");
    if (cell) {
        emit cellMenuOpens(menu, *cell);
        if (pinned_ == cell)
            menu.addAction(tr("&Let go of this cell"), this, &LinkedViews::clearPin);
        else
            menu.addAction(tr("&Pin this cell"), this, [this, cell] { pin(cell); });
        QAction* fly = menu.addAction(tr("&Fly to this point"), this, [this, cell] { cloud_.flyTo(static_cast<qint64>(*cell)); });
        fly->setEnabled(shown_ && shown_->cloud->drawable(*cell));
        menu.addSeparator();
    }
    menu.addAction(tr("View from &scanner"), &cloud_, &CloudView::viewFromScanner);
    menu.addAction(tr("F&it"), &cloud_, &CloudView::zoomToFit);
    menu.exec(position);
}

/// Ctrl selects several rocks and pins no cell.
void LinkedViews::click(std::size_t cell) {
    const Qt::KeyboardModifiers modifiers = QGuiApplication::keyboardModifiers();
    if (tool_ == Tool::Pin && !modifiers.testFlag(Qt::ControlModifier)) return pinByClick(cell);
    for (ImageView* view : images_) view->setCrosshair(pinned_ ? std::optional(placeOf(*pinned_)) : std::nullopt);
    if (tool_ != Tool::Pin) emit picked(cell, modifiers);
}

void LinkedViews::setTool(Tool tool) {
    tool_ = tool;
    const DragTool drag = tool == Tool::Box ? DragTool::Box : tool == Tool::Lasso ? DragTool::Lasso : DragTool::Move;
    for (ImageView* view : images_) {
        view->setDragTool(drag);
        view->setClearsOnEscape(tool == Tool::Pin);
    }
    cloud_.setDragTool(drag);
    emit toolChanged();
}

void LinkedViews::setMarks(const CellMarks& marks) {
    for (ImageView* view : images_) view->setMarks(marks);
    cloud_.setMarks(marks);
}

/// All three views zoom to the content of the box; the box stays drawn until Esc.
void LinkedViews::lookAtBox(const QRect& cells) {
    if (!shown_) return;
    const Scan& scan = *shown_->detection->scan;
    const QRect inside = cells.intersected(QRect(0, 0, scan.beams(), scan.lines()));
    if (inside.isEmpty()) return;
    for (ImageView* view : images_) view->setBox(inside);
    std::vector<std::uint32_t> held;
    std::size_t edges = 0;
    double nearest = 0.0, farthest = 0.0;
    for (int line = inside.top(); line <= inside.bottom(); ++line) {
        for (int beam = inside.left(); beam <= inside.right(); ++beam) {
            const std::size_t k = scan.rangeMm.index(line, beam);
            edges += (*shown_->detection->mask)[k] != 0 ? 1 : 0;
            if (scan.state[k] != CellState::Valid) continue;
            const double range = static_cast<double>(scan.rangeMm[k]) / 1000.0;
            nearest = held.empty() ? range : std::min(nearest, range);
            farthest = held.empty() ? range : std::max(farthest, range);
            held.push_back(static_cast<std::uint32_t>(k));
        }
    }
    gray().viewPort()->fitTo(QRectF(inside));
    if (!held.empty()) cloud_.zoomToCells(held);
    QString words =
        tr("box of %1 × %2 cells: %3 points, %4 edge cells").arg(inside.height()).arg(inside.width()).arg(held.size()).arg(edges);
    if (!held.empty()) words += tr(", ranges %1 to %2 m").arg(nearest, 0, 'f', 2).arg(farthest, 0, 'f', 2);
    emit boxed(words);
}

void LinkedViews::followPicture() {
    if (flipped_) flipTo(nullptr);
    const std::shared_ptr<const Picture> last = std::exchange(shown_, engine_.picture());
    const bool newScan = !last || last->detection->scan != shown_->detection->scan;
    if (!last || last->source.stream != shown_->source.stream)
        showNewScan();
    else if (newScan)
        showMoreLines(*last);
    if (instead_ && (newScan || instead_->map->size() != shown_->edges->size())) instead_ = nullptr;
    drawShown();
}

void LinkedViews::drawShown() {
    showRanges();
    setOverlay(overlay_);
    showEdgeMap();
    showEdgesOfCloud();
    hover(hovered_, nullptr);
}

void LinkedViews::showEdgesOfCloud() {
    const EdgesInstead* instead = insteadNow();
    const EdgeColours& colours = instead != nullptr ? instead->colours : colours_;
    if (cloud_.edgeColours() != colours) cloud_.setEdgeColours(colours);
    if (cloud_.edgesByClass() != (instead != nullptr || byClass_)) cloud_.setEdgesByClass(!cloud_.edgesByClass());
    if (shown_) cloud_.setEdges(instead != nullptr ? instead->cells : shown_->edgeCells);
    if (instead != nullptr && instead->points) cloud_.setFaces(instead->points, CloudView::EdgesOver::Always);
}

void LinkedViews::setEdgesInstead(std::shared_ptr<const EdgesInstead> instead) {
    if (instead && (!shown_ || instead->map->size() != shown_->edges->size())) return;
    const bool facesWere = instead_ && instead_->points && cloud_.faces() == instead_->points;
    instead_ = std::move(instead);
    if (facesWere && !(instead_ && instead_->points)) cloud_.setFaces(nullptr);
    if (!shown_ || flipped_) return;
    setOverlay(overlay_);
    showEdgeMap();
    showEdgesOfCloud();
}

void LinkedViews::flipTo(std::shared_ptr<const Picture> other) {
    if (!shown_ || flipped_ == other) return;
    if (!flipped_) own_ = shown_;
    flipped_ = std::move(other);
    shown_ = flipped_ ? flipped_ : std::exchange(own_, nullptr);
    // The cloud drops all overlays of the previous cloud; overlays of cells are valid for both clouds.
    const auto selection = cloud_.selection();
    const auto hidden = cloud_.hidden();
    if (cloud_.scan() != shown_->detection->scan) {
        cloud_.setCloud(shown_->detection->scan, shown_->cloud, CloudView::Camera::Keep);
        if (hidden) cloud_.setHidden(hidden);
        cloud_.setSelection(selection);
    } else if (flipped_) {
        cloud_.setFaces(nullptr);
    }
    drawShown();
}

void LinkedViews::showEdgeMap() {
    if (!shown_) return;
    const bool coloured = byClass_ && shown_->detection->classes;
    if (insteadNow() != nullptr)
        edges().setImage(instead_->map, Shrink::KeepBrightest);
    else
        edges().setImage(coloured ? std::make_shared<const QImage>(classPicture(*shown_, colours_)) : shown_->edges, Shrink::KeepBrightest);
    emit picturesChanged();
}

void LinkedViews::showNewScan() {
    // Cells of the old scan have no meaning in the new one.
    hovered_.reset();
    pin(std::nullopt);
    if (!windowKept_) setRangeWindow(std::nullopt);
    applyAspect();
    ViewPort& viewPort = *gray().viewPort();
    if (viewPort.imageSize() != shown_->gray->size()) {
        viewPort.setImageSize(shown_->gray->size());
        viewPort.fit();
    }
    cloud_.setCloud(shown_->detection->scan, shown_->cloud);
    noteFit();
    for (ImageView* view : images_) {
        view->setNote(QString());
        view->setBox(std::nullopt);
    }
    emit newScanShown();
}

/// More lines of the same scan: the views stay where they are. A camera that the operator did not move is fitted again when the cloud has
/// doubled.
void LinkedViews::showMoreLines(const Picture& last) {
    const Scan& scan = *shown_->detection->scan;
    const auto gone = [&](const std::optional<std::size_t>& cell) {
        return cell && (*cell >= scan.cells() || scan.beams() != last.detection->scan->beams());
    };
    if (gone(hovered_)) hovered_.reset();
    if (gone(pinned_)) pin(std::nullopt);
    const bool untouched = cloud_.camera() == fittedCamera_;
    const bool doubled = scan.lines() >= 2 * fittedLines_ || scan.lines() < fittedLines_ || !shown_->source.growth.growing;
    cloud_.setCloud(shown_->detection->scan, shown_->cloud, untouched && doubled ? CloudView::Camera::Reset : CloudView::Camera::Keep);
    if (doubled && untouched) noteFit();
}

void LinkedViews::noteFit() {
    fittedCamera_ = cloud_.camera();
    fittedLines_ = shown_->detection->scan->lines();
}

std::optional<std::size_t> LinkedViews::cellAt(int line, int beam) const {
    if (!shown_ || line >= shown_->detection->scan->lines()) return std::nullopt;
    return shown_->detection->scan->rangeMm.index(line, beam);
}

QPoint LinkedViews::placeOf(std::size_t cell) const {
    const auto beams = static_cast<std::size_t>(shown_->detection->scan->beams());
    return {static_cast<int>(cell % beams), static_cast<int>(cell / beams)};
}

void LinkedViews::hover(std::optional<std::size_t> cell, const QObject* from) {
    if (!shown_) return;
    hovered_ = cell;
    const auto mark = marked();
    for (ImageView* view : images_) view->setMarkedCell(mark && (pinned_ || view != from) ? std::optional(placeOf(*mark)) : std::nullopt);
    cloud_.setMarkedCell(mark ? std::optional(static_cast<std::uint32_t>(*mark)) : std::nullopt);
    emit probed(mark ? std::optional(edges::probeCell(*shown_->detection, *mark)) : std::nullopt);
}

void LinkedViews::pin(std::optional<std::size_t> cell) {
    if (cell && (!shown_ || *cell >= shown_->detection->scan->cells())) return; // a cell of a closed scan
    const bool another = std::exchange(pinned_, cell) != cell;
    for (ImageView* view : images_) view->setCrosshair(cell ? std::optional(placeOf(*cell)) : std::nullopt);
    hover(hovered_, nullptr);
    if (another) emit pinChanged(cell);
}

void LinkedViews::pinByClick(std::size_t cell) {
    byClick_ = true;
    pin(cell);
    byClick_ = false;
}

void LinkedViews::clearPin() {
    const std::optional<std::size_t> was = pinned_;
    pin(std::nullopt);
    for (ImageView* view : images_) view->setBox(std::nullopt);
    emit boxed(QString());
    if (was) emit pinCleared(*was);
}

void LinkedViews::flyToHovered() {
    if (hovered_) cloud_.flyTo(static_cast<qint64>(*hovered_));
}

void LinkedViews::setTrail(const EdgeTrail& trail) {
    for (ImageView* view : images_) view->setTrail(trail);
}

void LinkedViews::setNote(const QString& note) {
    for (ImageView* view : images_) view->setNote(note);
    cloud_.setNote(note);
}

void LinkedViews::setStale(const QString& why) {
    for (ImageView* view : images_) view->setStale(why);
    cloud_.setStale(why);
}

void LinkedViews::setOverlay(bool on) {
    overlay_ = on;
    if (shown_ && insteadNow() != nullptr) return gray().setOverlay(on || !instead_->overlayAsAsked ? instead_->overlay : nullptr, 1.0);
    if (!on || !shown_) return gray().setOverlay(nullptr, 1.0);
    const bool asMade = !byClass_ && colours_ == kUsualColours;
    gray().setOverlay(asMade ? shown_->overlay
                             : std::make_shared<const QImage>(edgeOverlay(*shown_->detection, colours_, byClass_, shown_->gray->height())),
                      1.0);
}

void LinkedViews::setEdgesByClass(bool on) {
    byClass_ = on;
    showEdgesOfCloud();
    showEdgeMap();
    setOverlay(overlay_);
}

void LinkedViews::setEdgeColours(const EdgeColours& colours) {
    colours_ = colours;
    showEdgesOfCloud();
    showEdgeMap();
    setOverlay(overlay_);
    emit edgeColoursChanged();
}

void LinkedViews::setTrueAngles(bool on) {
    trueAngles_ = on;
    applyAspect();
}

void LinkedViews::resetView() {
    cloud_.resetView();
    gray().viewPort()->fit();
    if (!windowKept_) setRangeWindow(std::nullopt);
}

void LinkedViews::zoomBy(double factor) {
    if (cloud_.hasFocus()) return cloud_.setCamera(zoomed(cloud_.camera(), cloud_.camera().focus, factor));
    ViewPort& port = *gray().viewPort();
    const std::optional<std::size_t> cell = marked();
    port.zoomAt(cell ? QPointF(placeOf(*cell)) + QPointF(0.5, 0.5) : port.centre(), factor);
}

/// As in medical viewers: a drag to the right widens the window, a drag downwards darkens the picture. One pixel is one gray level of the
/// method's scale.
void LinkedViews::changeRangeWindow(int window, int level) {
    if (!shown_) return;
    const edges::GrayScale& scale = shown_->detection->gray->scale;
    const double perPixel = std::max(1e-3, (scale.farMm - scale.nearMm) / 1000.0 / 255.0);
    const RangeSpan now = rangesShown();
    const double centre = std::max(0.0, (now.nearM + now.farM) / 2 + level * perPixel);
    const double half = std::clamp((now.farM - now.nearM + window * perPixel) / 2, 2 * perPixel, 255 * perPixel);
    setRangeWindow(RangeSpan{std::max(0.0, centre - half), centre + half});
}

void LinkedViews::setRangeWindow(const std::optional<RangeSpan>& window) {
    if (window_ == window) return;
    window_ = window;
    showRanges();
    emit rangeWindowChanged();
}

RangeSpan LinkedViews::rangesShown() const {
    if (window_ || !shown_) return window_.value_or(RangeSpan{});
    const edges::GrayScale& scale = shown_->detection->gray->scale;
    return {scale.nearMm / 1000.0, std::max(scale.farMm, scale.nearMm + 1.0) / 1000.0};
}

void LinkedViews::showRanges() {
    if (!shown_) return;
    gray().setImage(window_ ? std::make_shared<const QImage>(grayPicture(*shown_->detection, window_, shown_->gray->height()))
                            : shown_->gray);
    emit picturesChanged();
}

void LinkedViews::applyAspect() {
    const auto* polar = shown_ ? std::get_if<PolarGeometry>(&shown_->detection->scan->geometry) : nullptr;
    if (!trueAngles_ || polar == nullptr || polar->beamDeg.size() < 2 || polar->lineDeg.size() < 2) {
        gray().viewPort()->setSquarePixels();
        return;
    }
    const auto step = [](const std::vector<double>& deg) {
        return std::abs(deg.back() - deg.front()) / static_cast<double>(deg.size() - 1);
    };
    gray().viewPort()->setTrueAngle(step(polar->beamDeg), step(polar->lineDeg));
}

} // namespace edgescan::ui
