// Shows a picture in images and cloud. The mouse is in linked_views_mouse.cpp.
#include "ui/engine/linked_views/linked_views.h"

#include "core/edges/gray/gray.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

/// The same measurement of the same file, perhaps with another place in the mine.
bool sameRanges(const Scan& a, const Scan& b) {
    const auto equal = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.name == b.name && a.lines() == b.lines() && a.beams() == b.beams() &&
           std::ranges::equal(a.rangeMm.cells, b.rangeMm.cells, equal);
}

QString openSomething() { return LinkedViews::tr("Open a scan: Ctrl+O, or drop a file here"); }

/// "2.4", "18"
QString millions(std::size_t cells) {
    const double of = static_cast<double>(cells) * 1e-6;
    return QString::number(of, 'f', of < 10.0 ? 1 : 0);
}

} // namespace

LinkedViews::LinkedViews(const Engine& engine, ImageView& gray, ImageView& edges, CloudView& cloud)
    : engine_(engine), images_{&gray, &edges}, cloud_(cloud) {
    for (ImageView* view : images_) view->setNote(openSomething());
    connect(&engine_, &Engine::coarseChanged, this, &LinkedViews::followCoarse);
    connect(&engine_, &Engine::borderedReady, this, [this] {
        state_.bordered = engine_.bordered();
        draw();
    });
    cloud_.setPointSizeFollows(true);
    linkImages();
    linkCloud();
}

void LinkedViews::setOutline(const std::vector<QLine>& sides, std::vector<std::uint32_t> cells) {
    for (ImageView* view : images_) view->setOutline(sides);
    cloud_.setOutline(cells.empty() ? nullptr : std::make_shared<const std::vector<std::uint32_t>>(std::move(cells)));
}

void LinkedViews::setMarks(CellMarks marks) {
    marks_ = std::move(marks);
    showMarks();
}

void LinkedViews::setCut(std::vector<std::vector<std::size_t>> cut) {
    if (cut == cut_) return;
    cut_ = std::move(cut);
    showMarks();
}

void LinkedViews::showMarks() {
    CellMarks shown = flipped() ? CellMarks{} : marks_;
    if (!flipped()) shown.cut = cut_;
    if (!flipped()) shown.targets.insert(shown.targets.end(), explained_.begin(), explained_.end());
    for (ImageView* view : images_) view->setMarks(shown);
    cloud_.setMarks(shown);
}

void LinkedViews::followCoarse() {
    coarse_ = engine_.coarse();
    if (coarse_) return showCoarse();
    for (ImageView* view : images_) {
        view->setImage(nullptr);
        view->setNote(openSomething());
    }
    cloud_.setCloud(nullptr, nullptr);
    cloud_.setNote(QString());
}

void LinkedViews::showCoarse() {
    const edges::Detection& detection = *coarse_->detection;
    applyAspect();
    gray().setImage(state_.window ? std::make_shared<const QImage>(grayPicture(detection, state_.window, detection.scan->lines()))
                                  : coarse_->gray);
    cloud_.setCloud(detection.scan, coarse_->cloud);
    fittedCamera_ = cloud_.camera();
    const QString note = tr("Coarse picture of %1 million cells, the rest is coming").arg(millions(coarse_->cells));
    gray().setNote(note);
    cloud_.setNote(note);
    edges().setNote(tr("The edges come with the rest of the scan"));
}

void LinkedViews::followPicture() {
    flipTo(nullptr);
    const std::shared_ptr<const Picture> last = std::exchange(picture_, engine_.picture());
    state_.bordered = nullptr;
    if (!last || last->source.stream != picture_->source.stream)
        showNewScan(last != nullptr && sameRanges(*last->detection->scan, *picture_->detection->scan) ? last.get() : nullptr);
    else if (last->detection->scan != picture_->detection->scan)
        showMoreLines(*last);
    draw();
    showBox();
    hover(hovered_, nullptr);
}

void LinkedViews::put(Overlay overlay) {
    const auto n = static_cast<std::size_t>(overlay.name);
    overlays_[n] = std::move(overlay);
    draw();
}

void LinkedViews::remove(OverlayName name) {
    auto& overlay = overlays_[static_cast<std::size_t>(name)];
    if (!overlay) return;
    overlay.reset();
    draw();
}

void LinkedViews::draw() {
    if (picture_ && cloud_.scan() != shown()->detection->scan) return; // it is drawn when the cloud has its points
    scene_ = sceneOf(state_, picture_, overlays_, scene_);
    if (scene_.picture) applyScene();
    emit picturesChanged();
}

void LinkedViews::applyScene() {
    gray().setImage(scene_.gray);
    gray().setOverlay(scene_.overGray, 1.0);
    edges().setImage(scene_.edgeMap, Shrink::Lines);
    for (ImageView* view : images_) {
        view->setFaces(scene_.faces, scene_.facesFaded);
        view->setLost(scene_.picture->lost);
        view->setToCome(linesToCome(*scene_.picture));
    }
    if (cloud_.edgeColours() != scene_.colours) cloud_.setEdgeColours(scene_.colours);
    if (cloud_.edgesByClass() != scene_.byClass) cloud_.setEdgesByClass(scene_.byClass);
    cloud_.setEdges(scene_.cells);
    cloud_.setFaces(scene_.points, scene_.edgesOverPoints ? CloudView::EdgesOver::Always : CloudView::EdgesOver::AsAsked);
}

void LinkedViews::flipTo(std::shared_ptr<const Picture> other) {
    if (!picture_ || state_.flippedTo == other) return;
    state_.flippedTo = std::move(other);
    // The cloud drops all overlays of the previous cloud; overlays of cells are valid for both clouds.
    const auto selection = cloud_.selection();
    const auto hidden = cloud_.hidden();
    const auto outline = cloud_.outline();
    cloud_.setFrameOf(flipped() ? picture_->detection->scan : nullptr);
    if (cloud_.scan() != shown()->detection->scan) {
        cloud_.setCloud(shown()->detection->scan, shown()->cloud, CloudView::Camera::Keep);
        nameDirections();
        if (hidden) cloud_.setHidden(hidden);
        cloud_.setSelection(selection);
        cloud_.setOutline(outline);
    }
    draw();
    showMarks();
    showBox();
    hover(hovered_, nullptr);
    emit flippedChanged(flipped());
}

/// `same`: the picture before it, if it has the same cells; null: cells of the old scan have no meaning in the new one.
void LinkedViews::showNewScan(const Picture* same) {
    if (same == nullptr) {
        hovered_.reset();
        setExplained({});
        pin(std::nullopt);
    }
    const bool replacesCoarse = std::exchange(coarse_, nullptr) != nullptr;
    const bool stays = same != nullptr && !replacesCoarse && areAtSamePlaces(*same->cloud, *shown()->cloud); // it got or lost a pose
    if (!windowKept_ && !stays) setRangeWindow(std::nullopt);
    applyAspect();
    ViewPort& viewPort = *gray().viewPort();
    if (replacesCoarse) {
        viewPort.setFinerImage(shown()->gray->size());
        cloud_.setNote(QString());
    } else if (!stays) {
        viewPort.setImageSize(shown()->gray->size());
        viewPort.fit();
    }
    const bool turned = replacesCoarse && cloud_.camera() != fittedCamera_;
    setOutline({}, {});
    cloud_.setAxes(std::nullopt);
    cloud_.setCloud(shown()->detection->scan, shown()->cloud, turned || stays ? CloudView::Camera::Keep : CloudView::Camera::Reset);
    nameDirections();
    if (!stays) {
        fitted_ = turned;
        framedLines_ = 0;
        fitToSweep();
    }
    box_.reset();
    emit boxed(QString());
    for (ImageView* view : images_) {
        view->setNote(asked_);
        view->setBox(std::nullopt);
    }
    emit newScanShown(stays);
}

/// More lines of the same scan: the views stay where they are.
void LinkedViews::showMoreLines(const Picture& last) {
    const Scan& scan = *shown()->detection->scan;
    const auto gone = [&](const std::optional<std::size_t>& cell) {
        return cell && (*cell >= scan.cells() || scan.beams() != last.detection->scan->beams());
    };
    if (gone(hovered_)) hovered_.reset();
    if (gone(pinned_)) pin(std::nullopt);
    setOutline({}, {}); // the cloud drops it too
    const bool untouched = cloud_.camera() == fittedCamera_;
    cloud_.setCloud(shown()->detection->scan, shown()->cloud, CloudView::Camera::Keep);
    followSweep(last, untouched);
}

std::optional<std::size_t> LinkedViews::cellAt(int line, int beam) const {
    if (!shown() || line >= shown()->detection->scan->lines()) return std::nullopt;
    return shown()->detection->scan->rangeMm.index(line, beam);
}

QPoint LinkedViews::placeOf(std::size_t cell) const {
    const auto beams = static_cast<std::size_t>(shown()->detection->scan->beams());
    return {static_cast<int>(cell % beams), static_cast<int>(cell / beams)};
}

void LinkedViews::hover(std::optional<std::size_t> cell, const QObject* from) {
    if (!shown()) return;
    hovered_ = cell;
    if (cell && from != nullptr) hoveredIn_ = from;
    const auto mark = marked();
    for (ImageView* view : images_) view->setMarkedCell(mark && view != from ? std::optional(placeOf(*mark)) : std::nullopt);
    cloud_.setMarkedCell(mark ? std::optional(static_cast<std::uint32_t>(*mark)) : std::nullopt);
    emit probed(mark ? std::optional(edges::probeCell(*shown()->detection, *mark)) : std::nullopt);
}

void LinkedViews::pin(std::optional<std::size_t> cell) {
    if (cell && (!shown() || *cell >= shown()->detection->scan->cells())) return; // a cell of a closed scan
    const bool another = std::exchange(pinned_, cell) != cell;
    for (ImageView* view : images_) view->setCrosshair(cell ? std::optional(placeOf(*cell)) : std::nullopt);
    hover(hovered_, nullptr);
    if (another) emit pinChanged(cell);
}

std::optional<double> LinkedViews::pixelsBetween(std::size_t a, std::size_t b) const {
    if (hoveredIn_ == &cloud_) {
        const auto from = cloud_.pixelOf(static_cast<std::uint32_t>(a)), to = cloud_.pixelOf(static_cast<std::uint32_t>(b));
        return from && to ? std::optional(std::hypot(to->x() - from->x(), to->y() - from->y())) : std::nullopt;
    }
    const QPointF way = placeOf(b) - placeOf(a);
    const QSizeF cell = images_.front()->viewPort()->cellSize();
    return std::hypot(way.x() * cell.width(), way.y() * cell.height());
}

QVector<QPoint> LinkedViews::onScreen(std::size_t cell) const {
    QVector<QPoint> places;
    const auto add = [&](const QWidget& view, const std::optional<QPointF>& at) {
        if (at && view.isVisible() && view.rect().contains(at->toPoint())) places << view.mapToGlobal(at->toPoint());
    };
    add(cloud_, cloud_.pixelOf(static_cast<std::uint32_t>(cell)));
    for (const ImageView* view : images_) add(*view, view->viewPort()->toPixel(placeOf(cell) + QPointF(0.5, 0.5), view->size()));
    return places;
}

inspect::ClickedCell LinkedViews::nearSideCell(std::size_t clicked) const {
    const edges::Detection& detection = *shown()->detection;
    const auto cell = static_cast<std::uint32_t>(clicked);
    // A target is on the edge that was clicked; lengths are between surfaces.
    return tool_ == Tool::Pin ? inspect::nearSideEdge(*detection.scan, *detection.mask, cell)
                              : inspect::nearSideCell(*detection.scan, cell);
}

void LinkedViews::pinByClick(const inspect::ClickedCell& click) {
    byClick_ = click;
    pin(click.cell);
    byClick_.reset();
}

void LinkedViews::clearPin() {
    pin(std::nullopt);
    box_.reset();
    for (ImageView* view : images_) view->setBox(std::nullopt);
    emit boxed(QString());
}

void LinkedViews::pointAt(std::optional<std::size_t> cell) { hover(cell, nullptr); }

void LinkedViews::flyToHovered() {
    if (hovered_) cloud_.flyTo(static_cast<qint64>(*hovered_));
}

void LinkedViews::setTrail(const EdgeTrail& trail) {
    for (ImageView* view : images_) view->setTrail(trail);
}

void LinkedViews::setExplained(const std::vector<std::pair<std::size_t, QString>>& cells) {
    explained_.clear();
    for (const auto& [cell, words] : cells) explained_.push_back({cell, words, words, false, {}, false});
    showMarks();
}

void LinkedViews::setNote(const QString& note) {
    note_ = note;
    showNote();
}

void LinkedViews::setAsked(const QString& words) {
    asked_ = words;
    showNote();
}

void LinkedViews::showNote() {
    const QString both = asked_.isEmpty() || note_.isEmpty() ? asked_ + note_ : asked_ + " · " + note_;
    for (ImageView* view : images_) view->setNote(both);
    cloud_.setNote(both.isEmpty() || shapeNote_.isEmpty() ? both + shapeNote_ : both + "\n" + shapeNote_);
}

void LinkedViews::setShapeNote(const QString& note) {
    if (std::exchange(shapeNote_, note) != note) showNote();
}

void LinkedViews::setPictureFrame(const PictureFrame& frame) {
    for (ImageView* view : images_) view->setPictureFrame(frame);
    cloud_.setPictureFrame(frame);
}

void LinkedViews::setEdgesOverImage(bool on) {
    edgesAsked_ = on;
    state_.edgesOverImage = edgesAsked_ || onlyImage_;
    draw();
}

void LinkedViews::setOnlyImage(bool on) {
    onlyImage_ = on;
    setEdgesOverImage(edgesAsked_);
}

void LinkedViews::setEdgesByClass(bool on) {
    state_.byClass = on;
    draw();
}

void LinkedViews::setEdgeColours(const EdgeColours& colours) {
    state_.colours = colours;
    draw();
    emit edgeColoursChanged();
}

void LinkedViews::setTrueAngles(bool on) {
    trueAngles_ = on;
    applyAspect();
}

void LinkedViews::fitAll() {
    cloud_.setClip({});
    cloud_.zoomToFit();
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
    if (!shown()) return;
    const edges::GrayScale& scale = shown()->detection->gray->scale;
    const double perPixel = std::max(1e-3, (scale.farMm - scale.nearMm) / 1000.0 / 255.0);
    const RangeSpan now = rangesShown();
    const double centre = std::max(0.0, (now.nearM + now.farM) / 2 + level * perPixel);
    const double half = std::clamp((now.farM - now.nearM + window * perPixel) / 2, 2 * perPixel, 255 * perPixel);
    setRangeWindow(RangeSpan{std::max(0.0, centre - half), centre + half});
}

void LinkedViews::setRangeWindow(const std::optional<RangeSpan>& window) {
    if (state_.window == window) return;
    state_.window = window;
    draw();
    emit rangeWindowChanged();
}

RangeSpan LinkedViews::rangesShown() const {
    if (state_.window || !shown()) return state_.window.value_or(RangeSpan{});
    const edges::GrayScale& scale = shown()->detection->gray->scale;
    return {scale.nearMm / 1000.0, std::max(scale.farMm, scale.nearMm + 1.0) / 1000.0};
}

void LinkedViews::applyAspect() {
    const edges::Detection* detection = coarse_ ? coarse_->detection.get() : shown() ? shown()->detection.get() : nullptr;
    const auto* polar = detection != nullptr ? std::get_if<PolarGeometry>(&detection->scan->geometry) : nullptr;
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

#include "moc_linked_views.cpp"
