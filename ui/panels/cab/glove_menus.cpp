// The entry that closes a menu, and its scrolling by taps.
#include "ui/panels/cab/glove_menus.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QScreen>
#include <QStyle>
#include <QWheelEvent>

namespace edgescan::ui {
namespace {

constexpr const char* kTaken = "of-gloves";
constexpr int kScrolledEntries = 5; // by a tap on an arrow

/// The direction of the menu's arrow at this place, if more entries are there: 1 for the upper arrow, -1 for the lower one; else 0.
int arrowAt(const QMenu& menu, const QPoint& at) {
    const QList<QAction*> all = menu.actions();
    if (all.isEmpty() || !menu.isVisible() || !menu.geometry().contains(at)) return 0;
    const int high = menu.style()->pixelMetric(QStyle::PM_MenuScrollerHeight, nullptr, &menu), y = menu.mapFromGlobal(at).y();
    if (y < high && menu.actionGeometry(all.front()).top() < 0) return 1;
    return y >= menu.height() - high && menu.actionGeometry(all.back()).bottom() > menu.height() ? -1 : 0;
}

/// Qt scrolls from a press on an arrow until the pointer leaves it, which a finger does not; and not after an entry opened another menu,
/// which gets the events then.
bool scrollByTap(const QMenu& opened, const QPoint& at) {
    for (QWidget* each : QApplication::topLevelWidgets()) {
        auto* menu = qobject_cast<QMenu*>(each);
        const int way = menu != nullptr && (menu == &opened || !opened.geometry().contains(at)) ? arrowAt(*menu, at) : 0;
        if (way == 0) continue;
        while (QApplication::activePopupWidget() != menu && QApplication::activePopupWidget() != nullptr)
            QApplication::activePopupWidget()->close();
        for (int n = 0; n < kScrolledEntries; ++n) {
            QWheelEvent step(menu->mapFromGlobal(at), at, {}, {0, way * QWheelEvent::DefaultDeltasPerStep}, Qt::NoButton, Qt::NoModifier,
                             Qt::NoScrollPhase, false);
            QApplication::sendEvent(menu, &step);
        }
        return true;
    }
    return false;
}

} // namespace

GloveMenus::GloveMenus(QObject* parent)
    : QObject(parent), close_(new QAction(QStringLiteral("✕ ") + tr("Close"), this)), end_(new QAction(tr("End of the menu"), this)) {
    close_->setObjectName("close-menu");
    end_->setObjectName("end-of-menu");
    end_->setEnabled(false);
}

GloveMenus::~GloveMenus() { setOn(false); }

void GloveMenus::setOn(bool on) {
    on_ = on;
    qApp->removeEventFilter(this);
    if (on) qApp->installEventFilter(this); // for menus that are made later
    for (QWidget* each : QApplication::allWidgets()) {
        auto* menu = qobject_cast<QMenu*>(each);
        if (menu == nullptr) continue;
        menu->setAttribute(Qt::WA_NoMouseReplay, on);
        if (on) take(*menu);
    }
}

bool GloveMenus::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish) { // before it is laid out for the first time
        if (auto* menu = qobject_cast<QMenu*>(watched)) {
            menu->setAttribute(Qt::WA_NoMouseReplay);
            take(*menu);
        }
    }
    const bool press = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (press || event->type() == QEvent::MouseButtonRelease) {
        const auto* menu = qobject_cast<const QMenu*>(watched);
        if (press && menu != nullptr) scrolling_ = scrollByTap(*menu, static_cast<QMouseEvent*>(event)->globalPos());
        return scrolling_ && menu != nullptr; // the release too
    }
    return false;
}

/// The entries are there only while the menu is open: menus are filled and compared without it.
void GloveMenus::take(QMenu& menu) {
    if (menu.property(kTaken).toBool()) return;
    menu.setProperty(kTaken, true);
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
        menu.setAttribute(Qt::WA_NoMouseReplay, on_); // each time: Qt forgets it
        if (on_ && !menu.isEmpty()) menu.insertAction(menu.actions().front(), close_);
        // Where the lower arrow was: a tap too many chooses nothing.
        if (on_ && menu.sizeHint().height() > menu.screen()->availableGeometry().height()) menu.addAction(end_);
    });
    connect(&menu, &QMenu::aboutToHide, this, [this, &menu] {
        for (QAction* each : {close_, end_}) menu.removeAction(each);
    });
}

} // namespace edgescan::ui

#include "moc_glove_menus.cpp"
