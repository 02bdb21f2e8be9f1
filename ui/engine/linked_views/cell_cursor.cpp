// A cursor that keys move and click.
#include "ui/engine/linked_views/cell_cursor.h"

#include "core/edges/edgescan_plus/range_field.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QKeyEvent>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kLongStep = 10; // cells

QPoint stepOf(int key) {
    switch (key) {
    case Qt::Key_Left:
        return {-1, 0};
    case Qt::Key_Right:
        return {1, 0};
    case Qt::Key_Up:
        return {0, -1};
    case Qt::Key_Down:
        return {0, 1};
    default:
        return {};
    }
}

} // namespace

CellCursor::CellCursor(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {
    setObjectName("cell-cursor");
    for (ImageView* view : {&views_.gray(), &views_.edges()}) {
        view->installEventFilter(this);
        // The mouse sets the cursor's position.
        connect(view, &ImageView::hovered, this, [this](int line, int beam) { at_ = QPoint(beam, line); });
    }
    connect(&views_, &LinkedViews::newScanShown, this, [this] { at_.reset(); });
}

bool CellCursor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !views_.shown()) return false;
    auto* view = static_cast<ImageView*>(watched);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (QPoint step = stepOf(key->key()); !step.isNull()) {
        step = view->viewPort()->toScreen().inverted().map(step); // as it is seen
        moveBy(*view, key->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier) ? step * kLongStep : step);
        return true;
    }
    if ((key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter) || !at_) return false;
    // A key hits the very cell, which a finger or a mouse may miss.
    if (const auto cell = views_.cellAt(at_->y(), at_->x())) views_.click(inspect::exactly(*cell));
    return true;
}

void CellCursor::moveBy(ImageView& view, QPoint step) {
    const Scan& scan = *views_.shown()->detection->scan;
    if (scan.cells() == 0) return;
    const QPoint from = at_ ? *at_ : views_.pinned() ? views_.placeOf(*views_.pinned()) : QPoint(scan.beams() / 2, scan.lines() / 2);
    const QPoint to(std::clamp(from.x() + step.x(), 0, scan.beams() - 1), std::clamp(from.y() + step.y(), 0, scan.lines() - 1));
    const QPointF middle = QPointF(to) + QPointF(0.5, 0.5);
    if (!QRectF(view.rect()).contains(view.viewPort()->toPixel(middle, view.size()))) view.viewPort()->centreOn(middle);
    emit view.hovered(to.y(), to.x());
    view.setMarkedCell(to); // the other views have it already
}

} // namespace edgescan::ui

#include "moc_cell_cursor.cpp"
