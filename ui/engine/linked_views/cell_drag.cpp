// Handles drags and the wheel for a tool before the views get them.
#include "ui/engine/linked_views/cell_drag.h"

#include "ui/base/gestures.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"

#include <QWheelEvent>

#include <cmath>

namespace edgescan::ui {

CellDrag::CellDrag(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {
    for (QWidget* view :
         {static_cast<QWidget*>(&views.gray()), static_cast<QWidget*>(&views.edges()), static_cast<QWidget*>(&views.cloud())})
        view->installEventFilter(this);
}

void CellDrag::want(Wanted what) {
    wanted_ = what;
    down_ = false;
    turned_ = 0.0;
    cells_.clear();
    views_.cloud().setDrawn({});
    for (QWidget* view :
         {static_cast<QWidget*>(&views_.gray()), static_cast<QWidget*>(&views_.edges()), static_cast<QWidget*>(&views_.cloud())}) {
        if (what == Wanted::Drag)
            view->setCursor(Qt::CrossCursor);
        else
            view->unsetCursor();
    }
}

bool CellDrag::eventFilter(QObject* watched, QEvent* event) {
    if (wanted_ == Wanted::Nothing) return false;
    if (wanted_ == Wanted::Wheel) return readWheel(*event);
    return readMouse(*qobject_cast<QWidget*>(watched), *event);
}

std::optional<QPoint> CellDrag::cellUnder(const QWidget& view, QPointF at) const {
    if (const auto* image = qobject_cast<const ImageView*>(&view)) return image->cellAt(at);
    const auto cell = views_.cloud().cellAt(at);
    return cell ? std::optional(views_.placeOf(*cell)) : std::nullopt;
}

bool CellDrag::readMouse(QWidget& view, QEvent& event) {
    const QEvent::Type type = event.type();
    if (type != QEvent::MouseButtonPress && type != QEvent::MouseMove && type != QEvent::MouseButtonRelease) return false;
    const auto& mouse = static_cast<QMouseEvent&>(event);
    if (type == QEvent::MouseButtonPress) {
        if (mouse.button() != Qt::LeftButton) return false;
        down_ = true;
        cells_.clear();
        drawn_.clear();
    }
    if (!down_) return false;
    const auto cell = cellUnder(view, place(mouse));
    if (&view == &views_.cloud()) views_.cloud().setDrawn(drawn_ << place(mouse));
    if (cell && (cells_.empty() || cells_.back() != *cell)) {
        cells_.push_back(*cell);
        emit drawn(cells_);
    }
    if (type == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton) {
        down_ = false;
        views_.cloud().setDrawn({});
        emit finished(std::exchange(cells_, {}));
    }
    return true;
}

bool CellDrag::readWheel(QEvent& event) {
    if (event.type() != QEvent::Wheel) return false;
    turned_ += notches(static_cast<QWheelEvent&>(event));
    const double whole = std::trunc(turned_); // wheels without notches send small fractions
    turned_ -= whole;
    if (whole != 0) emit stepped(static_cast<int>(whole));
    event.accept();
    return true;
}

} // namespace edgescan::ui

#include "moc_cell_drag.cpp"
