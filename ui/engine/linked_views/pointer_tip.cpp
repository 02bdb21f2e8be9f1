// Shows and hides the text at the pointer.
#include "ui/engine/linked_views/pointer_tip.h"

#include "ui/engine/linked_views/linked_views.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"

#include <QApplication>
#include <QEvent>

namespace edgescan::ui {

PointerTip::PointerTip(LinkedViews& views) : views_(views) {
    for (const auto changed : {&LinkedViews::toolChanged, &LinkedViews::picturesChanged}) connect(&views, changed, this, &PointerTip::hide);
}

void PointerTip::show(std::size_t cell, const QString& text, const QObject* from) {
    for (ImageView* view : {&views_.gray(), &views_.edges()}) {
        const bool isHere = view == from || (from == nullptr && view->underMouse());
        view->setTip(isHere ? views_.placeOf(cell) : QPoint(), isHere ? text : QString());
    }
    views_.cloud().setTip(text);
    QApplication::instance()->installEventFilter(this); // a key may be a command of the window: no view gets it
}

void PointerTip::hide() {
    QApplication::instance()->removeEventFilter(this);
    for (ImageView* view : {&views_.gray(), &views_.edges()}) view->setTip({}, QString());
    views_.cloud().setTip(QString());
}

bool PointerTip::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool isView = watched == &views_.gray() || watched == &views_.edges() || watched == &views_.cloud();
    if (type == QEvent::MouseButtonPress || type == QEvent::ShortcutOverride || type == QEvent::KeyPress ||
        (isView && (type == QEvent::Leave || type == QEvent::Hide || type == QEvent::Resize)))
        hide();
    return false;
}

} // namespace edgescan::ui
