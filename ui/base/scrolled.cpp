// Heights that depend on the width.
#include "ui/base/scrolled.h"

#include <QEvent>
#include <QFontMetrics>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace edgescan::ui {
namespace {

class FollowsWidth : public QObject {
public:
    FollowsWidth(QScrollArea& area, QWidget& panel) : QObject(&area), area_(area), panel_(panel) {
        panel.installEventFilter(this);
        follow();
    }

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) follow();
        return false;
    }

private:
    void follow() {
        QLayout& layout = *panel_.layout();
        area_.setMinimumWidth(layout.minimumSize().width() + area_.verticalScrollBar()->sizeHint().width());
        const int height = layout.hasHeightForWidth() ? layout.heightForWidth(panel_.width()) : 0;
        panel_.setMinimumHeight(std::max(height, layout.minimumSize().height()));
        layout.setGeometry(panel_.contentsRect()); // Qt loses a change of size that is made while a hidden panel gets its last one
    }

    QScrollArea& area_;
    QWidget& panel_;
};

} // namespace

QScrollArea* scrolled(QWidget& panel) {
    auto* area = new QScrollArea;
    area->setWidget(&panel);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->verticalScrollBar()->setSingleStep(3 * panel.fontMetrics().lineSpacing()); // about a row of a form
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    new FollowsWidth(*area, panel);
    return area;
}

void scrollTo(QWidget& widget, bool top) {
    for (QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
        auto* area = qobject_cast<QScrollArea*>(up);
        if (area == nullptr) continue;
        if (top)
            area->verticalScrollBar()->setValue(widget.mapTo(area->widget(), QPoint()).y());
        else
            area->ensureWidgetVisible(&widget);
    }
}

} // namespace edgescan::ui
