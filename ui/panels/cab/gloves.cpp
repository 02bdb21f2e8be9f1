// Menus and scrolling by taps and swipes.
#include "ui/panels/cab/gloves.h"

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QScreen>
#include <QScroller>
#include <QStyle>
#include <QWheelEvent>

#include <algorithm>
#include <cstdlib>
#include <utility>

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
    if (area.window()->windowType() == Qt::Popup) return;
    if (auto* list = qobject_cast<QAbstractItemView*>(&area)) list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    QScroller::grabGesture(area.viewport(), QScroller::LeftMouseButtonGesture);
    QScroller* scroller = QScroller::scroller(area.viewport());
    QScrollerProperties manner = scroller->scrollerProperties();
    for (const auto metric : {QScrollerProperties::HorizontalOvershootPolicy, QScrollerProperties::VerticalOvershootPolicy})
        manner.setScrollMetric(metric, QScrollerProperties::OvershootAlwaysOff);
    scroller->setScrollerProperties(manner);
}

namespace {

constexpr const char* kTaken = "of-gloves";
constexpr int kScrolledEntries = 5; // by a tap on an arrow
constexpr int kSwipePx = 20;        // up or down from the press: farther than a tap slips

/// The direction of the menu's arrow at this place, if more entries are there: 1 for the upper arrow, -1 for the lower one; else 0.
int arrowAt(const QMenu& menu, const QPoint& at) {
    const QList<QAction*> all = menu.actions();
    if (all.isEmpty() || !menu.isVisible() || !menu.geometry().contains(at)) return 0;
    const int high = menu.style()->pixelMetric(QStyle::PM_MenuScrollerHeight, nullptr, &menu), y = menu.mapFromGlobal(at).y();
    if (y < high && menu.actionGeometry(all.front()).top() < 0) return 1;
    return y >= menu.height() - high && menu.actionGeometry(all.back()).bottom() > menu.height() ? -1 : 0;
}

bool isLong(const QMenu& menu) { return menu.sizeHint().height() > menu.screen()->availableGeometry().height(); }

/// The menu under a finger: an entry may have opened another menu, which gets the events of the first one.
QMenu* menuAt(QMenu& opened, const QPoint& at) {
    if (opened.geometry().contains(at)) return &opened;
    for (QWidget* each : QApplication::topLevelWidgets()) {
        auto* menu = qobject_cast<QMenu*>(each);
        if (menu != nullptr && menu->isVisible() && menu->geometry().contains(at)) return menu;
    }
    return nullptr;
}

/// Towards the first entry with 1, the last with -1. Closes the menus that it opened.
void scroll(QMenu& menu, const QPoint& at, int way, int entries) {
    while (QApplication::activePopupWidget() != &menu && QApplication::activePopupWidget() != nullptr)
        QApplication::activePopupWidget()->close();
    for (int n = 0; n < entries; ++n) {
        QWheelEvent step(menu.mapFromGlobal(at), at, {}, {0, way * QWheelEvent::DefaultDeltasPerStep}, Qt::NoButton, Qt::NoModifier,
                         Qt::NoScrollPhase, false);
        QApplication::sendEvent(&menu, &step);
    }
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
        if (on) addMenu(*menu);
    }
}

bool GloveMenus::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish) { // before it is laid out for the first time
        if (auto* menu = qobject_cast<QMenu*>(watched)) {
            menu->setAttribute(Qt::WA_NoMouseReplay);
            addMenu(*menu);
        }
    }
    const bool mouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick ||
                       event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonRelease;
    auto* menu = mouse ? qobject_cast<QMenu*>(watched) : nullptr;
    return menu != nullptr && readMouse(*menu, *static_cast<QMouseEvent*>(event));
}

/// Qt scrolls from a press on an arrow until the pointer leaves it, which a finger does not; and a swipe over entries carries out the last.
bool GloveMenus::readMouse(QMenu& opened, const QMouseEvent& event) {
    const QPoint at = event.globalPos();
    if (event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick) {
        pressed_ = menuAt(opened, at);
        from_ = at;
        const int way = pressed_ ? arrowAt(*pressed_, at) : 0;
        scrolling_ = way != 0;
        if (scrolling_) scroll(*pressed_, at, way, kScrolledEntries);
        return scrolling_;
    }
    if (event.type() == QEvent::MouseMove && event.buttons() != Qt::NoButton && pressed_) swipe(at.y());
    if (event.type() != QEvent::MouseButtonRelease) return scrolling_;
    pressed_ = nullptr;
    return std::exchange(scrolling_, false);
}

/// The entries follow the finger by whole ones.
void GloveMenus::swipe(int y) {
    if (!scrolling_ && std::abs(y - from_.y()) < kSwipePx) return;
    if (!std::exchange(scrolling_, true)) pressed_->setActiveAction(nullptr);
    const int high = std::max(1, pressed_->actionGeometry(pressed_->actions().front()).height()), entries = (y - from_.y()) / high;
    if (entries == 0 || !isLong(*pressed_)) return;
    scroll(*pressed_, {from_.x(), pressed_->geometry().center().y()}, entries > 0 ? 1 : -1, std::abs(entries));
    from_.ry() += entries * high;
}

/// The entries are there only while the menu is open: menus are filled and compared without it.
void GloveMenus::addMenu(QMenu& menu) {
    if (menu.property(kTaken).toBool()) return;
    menu.setProperty(kTaken, true);
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
        menu.setAttribute(Qt::WA_NoMouseReplay, on_); // each time: Qt forgets it
        if (on_ && !menu.isEmpty()) menu.insertAction(menu.actions().front(), close_);
        // Where the lower arrow was: a tap too many chooses nothing.
        if (on_ && isLong(menu)) menu.addAction(end_);
    });
    connect(&menu, &QMenu::aboutToHide, this, [this, &menu] {
        for (QAction* each : {close_, end_}) menu.removeAction(each);
    });
}

} // namespace edgescan::ui

#include "moc_gloves.cpp"
