// Searches a window for widgets that are cut off, squeezed or covered.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStringList>
#include <QStyle>
#include <QToolButton>
#include <QWidget>

#include <typeinfo>

namespace edgescan::ui {

/// Inside a scroll area a widget may be out of sight above or below, never to the right.
[[nodiscard]] inline const QAbstractScrollArea* scrollerOf(const QWidget* widget) {
    for (const QWidget* at = widget->parentWidget(); at != nullptr && !at->isWindow(); at = at->parentWidget()) {
        if (const auto* area = qobject_cast<const QAbstractScrollArea*>(at)) return area;
    }
    return nullptr;
}

[[nodiscard]] inline QString wordsOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
    return {};
}

/// Qt puts a dock whose tab is not in front out of the window.
[[nodiscard]] inline bool isBehindATab(const QWidget* widget) {
    const QDockWidget* dock = nullptr;
    for (; dock == nullptr && widget != nullptr; widget = widget->parentWidget()) dock = qobject_cast<const QDockWidget*>(widget);
    const auto* window = dock == nullptr ? nullptr : qobject_cast<const QMainWindow*>(dock->parentWidget());
    return window != nullptr && !window->tabifiedDockWidgets(const_cast<QDockWidget*>(dock)).isEmpty() &&
           !window->rect().intersects(dock->geometry());
}

/// One sentence for each fault.
[[nodiscard]] inline QStringList faultsIn(const QWidget& window) {
    QStringList faults;
    const auto addFault = [&](const QWidget& widget, const QString& what) {
        faults << QString("%1 \"%2\": %3 (%4 x %5)")
                      .arg(widget.objectName().isEmpty() ? widget.metaObject()->className() : widget.objectName(), wordsOf(widget).left(60),
                           what)
                      .arg(widget.width())
                      .arg(widget.height());
    };
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != window.window() || wordsOf(*widget).isEmpty() || isBehindATab(widget)) continue;
        const QRect place(widget->mapTo(&window, QPoint()), widget->size());
        const QAbstractScrollArea* scroller = scrollerOf(widget);
        if (scroller != nullptr) {
            const QRect seen(scroller->viewport()->mapTo(&window, QPoint()), scroller->viewport()->size());
            if ((place.left() < seen.left() - 1 || place.right() > seen.right() + 1))
                addFault(*widget, "stands over the side of its panel");
        } else if (!window.rect().adjusted(-1, -1, 1, 1).contains(place)) {
            addFault(*widget, "stands over the edge of its window");
        }
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            const bool ownWay = typeid(*label) != typeid(QLabel);                                            // it fits its text itself
            const bool mayShrink = ownWay || label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored; // it shortens its text itself
            if (label->wordWrap() ? label->heightForWidth(label->width()) > label->height() + 1
                                  : label->sizeHint().height() > label->height() + 1)
                addFault(*label, QString("%1 high are needed")
                                     .arg(label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height()));
            if (!label->wordWrap() && !mayShrink && label->sizeHint().width() > label->width() + 1)
                addFault(*label, QString("%1 wide are needed").arg(label->sizeHint().width()));
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            const auto* tool = qobject_cast<const QToolButton*>(button);
            if (button->hasHeightForWidth() && button->height() < button->heightForWidth(button->width()))
                addFault(*button, QString("%1 high are needed").arg(button->heightForWidth(button->width())));
            for (const auto* other : button->parentWidget()->findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly)) {
                if (other < button && other->isVisible() && other->geometry().intersects(button->geometry()))
                    addFault(*button, "overlaps " + wordsOf(*other));
            }
            if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) continue;
            const QByteArray kind = button->metaObject()->className();
            if (!kind.startsWith('Q') || kind == "QAbstractButton") continue; // it fits its text itself
            const int words = button->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width();
            if (button->width() < words) addFault(*button, QString("%1 wide are needed").arg(words));
        }
    }
    return faults;
}

} // namespace edgescan::ui
