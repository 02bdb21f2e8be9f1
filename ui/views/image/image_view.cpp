// Shows one lines x beams image.
#include "ui/views/image/image_view.h"

#include "ui/base/marks.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QResizeEvent>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr double kRing = 7.0;     // radius, px
constexpr int kFromRim = 8;       // px
constexpr int kRoomForTags = 420; // px of the view: in a smaller view targets show only their numbers
const QColor kLostDash(242, 181, 74);
const QColor kToComeHatch(62, 65, 70);
constexpr double kFaded = 0.45;      // opacity of faces of an older picture
const QColor kTrail(86, 180, 233);   // its frames separate it from edges as well
constexpr double kLeastFramed = 4.0; // px of a cell: frames round smaller cells would cover them

QPen dark(double width) { return {QColor(0, 0, 0, 170), width}; }
QPen light(Qt::PenStyle style = Qt::SolidLine) { return {QColor(255, 255, 255, 190), 1.0, style}; }

void drawRing(QPainter& painter, QPointF at) {
    painter.setBrush(Qt::NoBrush);
    strokeTwice(painter, QPen(Qt::black, 4.0), QPen(Qt::white, 2.0), [&] { painter.drawEllipse(at, kRing, kRing); });
    painter.setPen(QPen(Qt::black, 1.0));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, 1.8, 1.8);
}

} // namespace

ImageView::ImageView(std::shared_ptr<ViewPort> viewPort, QWidget* parent)
    : QWidget(parent), viewPort_(viewPort ? std::move(viewPort) : std::make_shared<ViewPort>()), fit_(new QToolButton(this)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setContextMenuPolicy(Qt::PreventContextMenu); // the right button drags window and level
    setCursor(Qt::CrossCursor);
    connect(viewPort_.get(), &ViewPort::changed, this, qOverload<>(&QWidget::update));
    connect(viewPort_.get(), &ViewPort::changed, this, &ImageView::offerFit);
    fit_->setObjectName("fit-images");
    fit_->setFocusPolicy(Qt::NoFocus);
    fit_->setCursor(Qt::ArrowCursor);
    fit_->setToolTip(tr("Show the whole images"));
    fit_->hide();
    connect(fit_, &QToolButton::clicked, viewPort_.get(), &ViewPort::fit);
}

ImageView::~ImageView() {
    viewPort_->disconnect(this);
    viewPort_->forgetView(this);
}

void ImageView::setImage(std::shared_ptr<const QImage> image, Shrink shrink) {
    if (image == picture_.image() && shrink == picture_.shrink()) return;
    picture_ = Pyramid(std::move(image), shrink);
    if (!picture_.empty()) viewPort_->setImageSize(picture_.image()->size());
    offerFit();
    update();
}

/// At the lower left, while a part of the image is shown.
void ImageView::offerFit() {
    const bool isPart = !picture_.empty() && !viewPort_->fitted();
    if (isPart) {
        fit_->setText(tr("Zoomed %1 × · Fit").arg(viewPort_->magnification(), 0, 'f', 1));
        fit_->adjustSize();
        fit_->move(kFromRim, height() - kFromRim - fit_->height());
    }
    fit_->setVisible(isPart);
}

void ImageView::setOverlay(std::shared_ptr<const QImage> image, double opacity, Shrink shrink) {
    const bool same = image == overlay_.image() && shrink == overlay_.shrink();
    if (same && opacity == overlayOpacity_) return;
    if (!same) overlay_ = Pyramid(std::move(image), shrink);
    overlayOpacity_ = std::clamp(opacity, 0.0, 1.0);
    update();
}

void ImageView::setFaces(std::shared_ptr<const QImage> faces, bool faded) {
    const bool same = faces == faces_.image();
    if (same && faded == facesFaded_) return;
    if (!same) faces_ = Pyramid(std::move(faces), Shrink::Average);
    facesFaded_ = faded;
    update();
}

void ImageView::setOutline(std::vector<QLine> sides) {
    if (sides == outline_) return;
    outline_ = std::move(sides);
    update();
}

void ImageView::setTip(const QPoint& cell, const QString& text) {
    if (cell == tipCell_ && text == tip_) return;
    tipCell_ = cell;
    tip_ = text;
    update();
}

void ImageView::setMarkedCell(std::optional<QPoint> cell) {
    if (cell == marked_) return;
    marked_ = cell;
    update();
}

void ImageView::setCrosshair(std::optional<QPoint> cell) {
    if (cell == crosshair_) return;
    crosshair_ = cell;
    update();
}

void ImageView::setBox(std::optional<QRect> cells) {
    if (cells == box_) return;
    box_ = cells;
    update();
}

void ImageView::setTrail(EdgeTrail trail) {
    if (trail.cells.empty() && trail_.cells.empty()) return;
    trail_ = std::move(trail);
    update();
}

void ImageView::setMarks(CellMarks marks) {
    if (marks == marks_) return;
    marks_ = std::move(marks);
    update();
}

void ImageView::setSelection(std::shared_ptr<const QImage> selection) {
    if (selection == selection_.image()) return;
    selection_ = Pyramid(std::move(selection), Shrink::Average);
    update();
}

void ImageView::setDragTool(DragTool tool) { tool_ = tool; }

void ImageView::setLost(std::vector<QRect> areas) {
    if (areas == lost_) return;
    lost_ = std::move(areas);
    update();
}

void ImageView::setToCome(const QRect& area) {
    if (std::exchange(toCome_, area) != area) update();
}

void ImageView::setCovered(int pixels) {
    if (std::exchange(covered_, pixels) != pixels) update();
}

void ImageView::setNote(const QString& note) {
    note_ = note;
    update();
}

void ImageView::setPictureFrame(const PictureFrame& frame) {
    if (std::exchange(pictureFrame_, frame) != frame) update();
}

void ImageView::setBackground(const QColor& colour) {
    background_ = colour;
    update();
}

void ImageView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (isVisible()) viewPort_->setViewSize(this, size());
    offerFit();
}

void ImageView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    viewPort_->setViewSize(this, size());
}

// A hidden view must not limit the size of the picture in the visible views.
void ImageView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    viewPort_->forgetView(this);
}

std::optional<QPoint> ImageView::cellAt(QPointF pixel) const {
    if (picture_.empty()) return std::nullopt;
    const QPointF at = viewPort_->toCell(pixel, size());
    const QPoint cell(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
    if (!picture_.image()->rect().contains(cell)) return std::nullopt;
    return cell;
}

QRectF ImageView::toPixels(const QRectF& cells) const {
    return QRectF(viewPort_->toPixel(cells.topLeft(), size()), viewPort_->toPixel(cells.bottomRight(), size())).normalized();
}

void ImageView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), background_);
    drawPyramid(painter, picture_);
    if (!toCome_.isEmpty()) painter.fillRect(toPixels(QRectF(toCome_)), QBrush(kToComeHatch, Qt::BDiagPattern));
    drawLost(painter);
    if (!faces_.empty()) {
        painter.setOpacity(facesFaded_ ? kFaded : 1.0);
        drawPyramid(painter, faces_);
        painter.setOpacity(1.0);
    }
    if (!overlay_.empty() && overlayOpacity_ > 0.0) {
        painter.setOpacity(overlayOpacity_);
        drawPyramid(painter, overlay_);
        painter.setOpacity(1.0);
    }
    if (!selection_.empty()) drawPyramid(painter, selection_);
    drawMarks(painter);
    const QRect plate = drawPictureFrame(painter, rect(), pictureFrame_, QRect(width() - covered_, 0, covered_, height()));
    drawTexts(painter);
    drawRings(painter, plate); // above the texts
    drawTip(painter);
}

void ImageView::drawPyramid(QPainter& painter, Pyramid& pyramid) const {
    if (pyramid.empty()) return;
    const QSizeF cell = viewPort_->cellSize(size()) * devicePixelRatioF();
    const double scale = std::min(cell.width(), cell.height());
    // For lines the level whose pixels are at least as large as those of the screen: drawn smaller, they would lose their light.
    const double forLevel = pyramid.shrink() == Shrink::Lines && scale < 1.0 ? scale / 2.0 : scale;
    const QImage& image = pyramid.level(pyramidLevel(forLevel));
    const QSizeF full = pyramid.image()->size();
    // For odd sizes the last pixel of a level covers fewer cells; therefore cells per pixel is a power of two, not the quotient of the
    // sizes.
    const double cellsPerPixel =
        std::exp2(std::ceil(std::log2(std::max(full.width() / image.width(), full.height() / image.height())) - 1e-9));

    const QPointF topLeft = viewPort_->toCell({0.0, 0.0}, size());
    const QPointF bottomRight = viewPort_->toCell(QPointF(width(), height()), size());
    QRectF seen = QRectF(topLeft, bottomRight).normalized().intersected(QRectF({0.0, 0.0}, full));
    if (seen.isEmpty()) return;
    // Whole pixels of the level; otherwise drawImage would shift the picture by fractions of a cell.
    const QRect source =
        QRectF(seen.topLeft() / cellsPerPixel, seen.bottomRight() / cellsPerPixel).toAlignedRect().intersected(image.rect());
    QRectF cells(QPointF(source.topLeft()) * cellsPerPixel, QSizeF(source.size()) * cellsPerPixel);
    const QRectF target = toPixels(cells);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale < 1.0 && pyramid.shrink() != Shrink::Lines);
    painter.save();
    painter.setClipRect(toPixels(QRectF({0.0, 0.0}, full)));
    const QTransform& turn = viewPort_->toScreen();
    const QPointF middle = turn.isIdentity() ? QPointF() : target.center();
    painter.setTransform(turn * QTransform::fromTranslate(middle.x(), middle.y()), true);
    painter.drawImage(turn.inverted().mapRect(target.translated(-middle)), image, source);
    painter.restore();
}

/// In pixels of the view: a hatch of cells would become one even colour in a small picture.
void ImageView::drawLost(QPainter& painter) const {
    constexpr double kBetween = 6.0; // px
    QVector<QLineF> dashes;
    for (const QRect& area : lost_) {
        const QRectF at = toPixels(QRectF(area)).intersected(QRectF(rect()));
        if (at.width() <= 0.0 || at.height() <= 0.0) continue;
        const int rows = std::max(1, static_cast<int>(at.height() / kBetween));
        for (int row = 0; row < rows; ++row) {
            const double y = at.top() + (row + 0.5) * at.height() / rows;
            dashes << QLineF(at.left(), y, at.right(), y);
        }
    }
    QPen amber(kLostDash, 1.0);
    amber.setDashPattern({5.0, 5.0});
    painter.setPen(amber);
    painter.drawLines(dashes);
}

void ImageView::drawTrail(QPainter& painter) const {
    const QRectF seen = QRectF(rect()).adjusted(-20, -20, 20, 20);
    QVector<QRect> frames;
    const bool framed = std::min(viewPort_->cellSize(size()).width(), viewPort_->cellSize(size()).height()) >= kLeastFramed;
    for (const QPoint& cell : framed ? trail_.cells : std::vector<QPoint>()) {
        const QRectF frame = toPixels(QRectF(cell, QSizeF(1, 1))).adjusted(-1, -1, 1, 1);
        if (seen.intersects(frame)) frames.append(frame.toAlignedRect());
    }
    painter.setRenderHint(QPainter::Antialiasing, false); // chains have thousands of cells
    painter.setBrush(Qt::NoBrush);
    strokeTwice(painter, dark(3.0), QPen(kTrail, 1.0), [&] { painter.drawRects(frames); });
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF way;
    for (const QPoint& cell : trail_.way) way << viewPort_->toPixel(QPointF(cell) + QPointF(0.5, 0.5), size());
    strokeTwice(painter, dark(3.0), light(), [&] { painter.drawPolyline(way); });
}

void ImageView::drawOutline(QPainter& painter) const {
    QVector<QLineF> sides;
    for (const QLine& side : outline_)
        sides << QLineF(viewPort_->toPixel(QPointF(side.p1()), size()), viewPort_->toPixel(QPointF(side.p2()), size()));
    painter.setRenderHint(QPainter::Antialiasing, false); // outlines have thousands of sides
    strokeTwice(painter, dark(4.0), QPen(Qt::white, 2.0), [&] { painter.drawLines(sides); });
    painter.setRenderHint(QPainter::Antialiasing);
}

void ImageView::drawTip(QPainter& painter) const {
    if (tip_.isEmpty()) return;
    const QPoint at = viewPort_->toPixel(QPointF(tipCell_) + QPointF(0.5, 0.5), size()).toPoint();
    drawTipAt(painter, rect(), at, tip_);
}

void ImageView::drawMarks(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (!outline_.empty()) drawOutline(painter);
    if (!trail_.cells.empty()) drawTrail(painter);
    painter.setBrush(Qt::NoBrush);
    if (crosshair_) {
        const QPointF at = viewPort_->toPixel(QPointF(*crosshair_) + QPointF(0.5, 0.5), size());
        const double gap = std::max(6.0, 0.75 * std::max(viewPort_->cellSize(size()).width(), viewPort_->cellSize(size()).height()));
        strokeTwice(painter, dark(3.0), light(), [&] {
            painter.drawLine(QPointF(0, at.y()), QPointF(at.x() - gap, at.y()));
            painter.drawLine(QPointF(at.x() + gap, at.y()), QPointF(width(), at.y()));
            painter.drawLine(QPointF(at.x(), 0), QPointF(at.x(), at.y() - gap));
            painter.drawLine(QPointF(at.x(), at.y() + gap), QPointF(at.x(), height()));
        });
    }
    if (box_) strokeTwice(painter, dark(3.0), light(), [&] { painter.drawRect(toPixels(QRectF(*box_))); });
    if (drag_ == Drag::Box && press_.travelled) {
        strokeTwice(painter, dark(3.0), light(Qt::DashLine),
                    [&] { painter.drawRect(toPixels(QRectF(boxCells(press_.from, press_.last)))); });
    }
    if (drag_ == Drag::Select && press_.travelled) drawDragged(painter);
}

/// With the tags, which avoid the texts. `plate`: of the picture's frame.
void ImageView::drawRings(QPainter& painter, const QRect& plate) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (marked_) drawRing(painter, viewPort_->toPixel(QPointF(*marked_) + QPointF(0.5, 0.5), size())); // below the digits of the marks
    const auto beams = static_cast<std::size_t>(picture_.empty() ? 1 : picture_.image()->width());
    const auto placeOf = [&](std::size_t cell) -> std::optional<QPointF> {
        const QPointF at(static_cast<double>(cell % beams) + 0.5, static_cast<double>(cell / beams) + 0.5);
        return viewPort_->toPixel(at, size());
    };
    screenMarks_ = screenMarks(marks_, placeOf, width() < kRoomForTags);
    std::vector<QRectF> plates{QRectF(plate)}; // and buttons of a cab
    for (const QWidget* each : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (each->isVisible()) plates.emplace_back(each->geometry());
    }
    tags_ = drawScreenMarks(painter, rect(), screenMarks_, plates, texts_);
}

void ImageView::drawDragged(QPainter& painter) const {
    QPolygonF pixels;
    for (const QPointF& corner : way_) pixels << viewPort_->toPixel(corner, size());
    strokeTwice(painter, dark(3.0), light(Qt::DashLine), [&] { painter.drawPolygon(pixels); });
}

void ImageView::drawTexts(QPainter& painter) {
    const QRect inner = rect().adjusted(11, 8, -11, -8);
    const Qt::Alignment place = picture_.empty() ? Qt::AlignCenter : Qt::AlignRight | Qt::AlignTop;
    texts_ = {QRectF(drawLabel(painter, inner.adjusted(0, 0, -covered_, 0), place, note_))};
}

namespace {

constexpr double kZoomPerNotch = 1.25;

} // namespace

bool ImageView::event(QEvent* event) { return touch_.read(event) || QWidget::event(event); }

void ImageView::pinch(QPointF middle, QPointF shift, double factor) {
    viewPort_->panPixels(shift, size());
    viewPort_->zoomAt(viewPort_->toCell(middle, size()), std::clamp(factor, 0.5, 2.0));
}

void ImageView::mousePressEvent(QMouseEvent* event) {
    if (drag_ != Drag::None) return; // a second button during a drag is ignored
    press_.begin(*event);
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    const bool selects = tool_ != DragTool::Move && !picture_.empty();
    if (press_.button == Qt::LeftButton) drag_ = selects ? Drag::Select : shift && !picture_.empty() ? Drag::Box : Drag::Pan;
    way_.clear();
    if (press_.button == Qt::MiddleButton) drag_ = Drag::Pan;
    if (press_.button == Qt::RightButton) drag_ = Drag::WindowLevel;
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = place(*event);
    pointAt(cellAt(at));
    if (drag_ == Drag::None || !press_.travels(at)) return;
    if (drag_ == Drag::Pan) viewPort_->panPixels(at - press_.last, size());
    if (drag_ == Drag::Box) update();
    if (drag_ == Drag::Select) selectTo(at);
    if (drag_ == Drag::WindowLevel) {
        const QPoint by = at.toPoint() - press_.last.toPoint();
        if (!by.isNull()) emit windowLevelDragged(by.x(), by.y());
    }
    press_.last = at;
}

/// A box contains whole cells; a lasso follows the mouse.
void ImageView::selectTo(QPointF at) {
    if (tool_ == DragTool::Box) {
        way_ = QPolygonF(QRectF(boxCells(press_.from, at)));
        way_.removeLast(); // removes the closing corner
    } else {
        if (way_.isEmpty()) way_ << viewPort_->toCell(press_.from, size());
        way_ << viewPort_->toCell(at, size());
    }
    update();
}

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != press_.button || drag_ == Drag::None) return;
    const Drag was = drag_;
    drag_ = Drag::None;
    if (press_.travelled) {
        if (was == Drag::WindowLevel) emit windowLevelFinished();
        if (was == Drag::Box) {
            setBox(boxCells(press_.from, press_.last));
            update();
            emit boxSelected(*box_);
        }
        if (was == Drag::Select) {
            update();
            emit outlined(std::exchange(way_, {}), event->modifiers());
        }
        return;
    }
    const auto cell = cellAt(place(*event));
    const auto mark = markAt(screenMarks_, tags_, place(*event), touch_.mouseIsFinger());
    if (mark && choosesMarks(*event)) return emit markClicked(*mark, cell ? cell->y() : -1, cell ? cell->x() : -1);
    if (!cell) return;
    if (event->button() == Qt::RightButton) {
        const int beams = picture_.image()->width(), of = mark && !mark->isMeasure ? static_cast<int>(mark->which) : -1;
        const QPoint asked = of < 0 ? *cell : QPoint(of % beams, of / beams);
        emit menuRequested(asked.y(), asked.x(), mapToGlobal(place(*event).toPoint()));
    }
    if (event->button() != Qt::LeftButton) return;
    setCrosshair(cell);
    emit clicked(cell->y(), cell->x());
}

void ImageView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) viewPort_->fit();
}

void ImageView::wheelEvent(QWheelEvent* event) {
    event->accept();
    viewPort_->zoomAt(viewPort_->toCell(event->position(), size()), std::pow(kZoomPerNotch, notches(*event)));
    pointAt(cellAt(event->position())); // the cell under the cursor may have changed
}

QRect ImageView::boxCells(QPointF from, QPointF to) const {
    const QRect all = picture_.image()->rect();
    const auto inside = [&](QPointF pixel) {
        const QPointF at = viewPort_->toCell(pixel, size());
        return QPoint(std::clamp(static_cast<int>(std::floor(at.x())), all.left(), all.right()),
                      std::clamp(static_cast<int>(std::floor(at.y())), all.top(), all.bottom()));
    };
    const QPoint a = inside(from);
    const QPoint b = inside(to);
    return {QPoint(std::min(a.x(), b.x()), std::min(a.y(), b.y())), QPoint(std::max(a.x(), b.x()), std::max(a.y(), b.y()))};
}

void ImageView::pointAt(std::optional<QPoint> cell) {
    if (std::exchange(hoveredCell_, cell) == cell) return;
    if (cell)
        emit hovered(cell->y(), cell->x());
    else
        emit hoverLeft();
}

void ImageView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    pointAt(std::nullopt);
}

} // namespace edgescan::ui

#include "moc_image_view.cpp"
