// The entry that closes a menu.
#include "ui/panels/cab/glove_menus.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMenu>

namespace edgescan::ui {
namespace {

constexpr const char* kTaken = "of-gloves";

} // namespace

GloveMenus::GloveMenus(QObject* parent) : QObject(parent), close_(new QAction(QStringLiteral("✕ ") + tr("Close"), this)) {
    close_->setObjectName("close-menu");
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
    return false;
}

/// The entry is there only while the menu is open: menus are filled and compared without it.
void GloveMenus::take(QMenu& menu) {
    if (menu.property(kTaken).toBool()) return;
    menu.setProperty(kTaken, true);
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
        menu.setAttribute(Qt::WA_NoMouseReplay, on_); // each time: Qt forgets it
        if (on_ && !menu.isEmpty()) menu.insertAction(menu.actions().front(), close_);
    });
    connect(&menu, &QMenu::aboutToHide, this, [this, &menu] { menu.removeAction(close_); });
}

} // namespace edgescan::ui

#include "moc_glove_menus.cpp"
