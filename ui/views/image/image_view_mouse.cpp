// The mouse of an image view.
#include "ui/views/image/image_view.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
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
