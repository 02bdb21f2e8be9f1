// The entry that closes a menu, and its scrolling by taps.
#include "ui/panels/cab/glove_menus.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QScreen>
#include <QTimer>

namespace edgescan::ui {
namespace {

constexpr const char* kTaken = "of-gloves";
constexpr int kScrolledMs = 280; // by a tap on an arrow: about five entries

/// Qt scrolls a menu from a press on its arrow until the pointer leaves the arrow, which a finger does not.
void endScrolling(QMenu& menu, const QPoint& at) {
    const QList<QAction*> all = menu.actions();
    if (all.isEmpty()) return;
    QAction* active = menu.activeAction();
    const bool whole = menu.actionGeometry(all.front()).top() >= 0 && menu.actionGeometry(all.back()).bottom() <= menu.height();
    if (whole || (active != nullptr && menu.actionGeometry(active).contains(at))) return;
    QTimer::singleShot(kScrolledMs, &menu, [&menu] {
        const QAction* now = menu.activeAction();
        const bool opened = now != nullptr && now->menu() != nullptr && now->menu()->isVisible();
        if (!menu.isVisible() || opened || QGuiApplication::mouseButtons() != Qt::NoButton) return;
        const QPointF away(-10000.0, -10000.0);
        QMouseEvent leave(QEvent::MouseMove, away, away, away, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&menu, &leave);
    });
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
    if (event->type() == QEvent::MouseButtonRelease) {
        if (auto* menu = qobject_cast<QMenu*>(watched)) endScrolling(*menu, static_cast<QMouseEvent*>(event)->pos());
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
