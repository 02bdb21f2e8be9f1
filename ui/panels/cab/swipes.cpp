// Scrolls by swipes.
#include "ui/panels/cab/swipes.h"

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QApplication>
#include <QEvent>
#include <QScroller>

namespace edgescan::ui {

Swipes::~Swipes() { setOn(false); }

void Swipes::setOn(bool on) {
    qApp->removeEventFilter(this);
    if (on) qApp->installEventFilter(this); // for those that are made later
    for (QWidget* each : QApplication::allWidgets()) {
        auto* area = qobject_cast<QAbstractScrollArea*>(each);
        if (area != nullptr) on ? grab(*area) : giveBack(*area);
    }
}

bool Swipes::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish) {
        if (auto* area = qobject_cast<QAbstractScrollArea*>(watched)) grab(*area);
    }
    return false;
}

void Swipes::giveBack(QAbstractScrollArea& area) {
    QScroller::ungrabGesture(area.viewport());
    if (auto* list = qobject_cast<QAbstractItemView*>(&area)) list->resetVerticalScrollMode();
}

void Swipes::grab(QAbstractScrollArea& area) {
    if (area.window()->windowType() == Qt::Popup || area.property(kPaged).toBool()) return;
    if (auto* list = qobject_cast<QAbstractItemView*>(&area)) list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    QScroller::grabGesture(area.viewport(), QScroller::LeftMouseButtonGesture);
    QScroller* scroller = QScroller::scroller(area.viewport());
    QScrollerProperties manner = scroller->scrollerProperties();
    for (const auto metric : {QScrollerProperties::HorizontalOvershootPolicy, QScrollerProperties::VerticalOvershootPolicy})
        manner.setScrollMetric(metric, QScrollerProperties::OvershootAlwaysOff);
    scroller->setScrollerProperties(manner);
}

} // namespace edgescan::ui

#include "moc_swipes.cpp"
