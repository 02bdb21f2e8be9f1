// Heights that depend on the width.
#include "ui/base/scrolled.h"

#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kMostFree = 60; // px below the last whole row

class Area : public QScrollArea {
public:
    using QScrollArea::setViewportMargins;
};

class FollowsWidth : public QObject {
public:
    FollowsWidth(Area& area, QWidget& panel) : QObject(&area), area_(area), panel_(panel) {
        for (QObject* each : {static_cast<QObject*>(&area), static_cast<QObject*>(&panel)}) each->installEventFilter(this);
        follow();
    }

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) follow();
        return false;
    }

private:
    void follow() {
        const QLayout& layout = *panel_.layout();
        area_.setMinimumWidth(layout.minimumSize().width() + area_.verticalScrollBar()->sizeHint().width());
        const int height = layout.hasHeightForWidth() ? layout.heightForWidth(panel_.width()) : 0;
        panel_.setMinimumHeight(std::max(height, layout.minimumSize().height()));
        endWithRow();
    }
    /// What is seen before any scrolling ends with a whole row.
    void endWithRow() {
        const int room = area_.contentsRect().height();
        int end = room;
        if (panel_.minimumHeight() > room) {
            const auto rows = panel_.findChildren<QWidget*>();
            const auto cut = [&](const QWidget* row) {
                const int top = row->mapTo(&panel_, QPoint()).y();
                return row->isVisibleTo(&panel_) && row->layout() == nullptr && top < end && top + row->height() > end;
            };
            for (auto row = std::ranges::find_if(rows, cut); row != rows.end(); row = std::ranges::find_if(rows, cut))
                end = (*row)->mapTo(&panel_, QPoint()).y();
        }
        area_.setViewportMargins(0, 0, 0, room - end <= kMostFree ? room - end : 0);
    }

    Area& area_;
    QWidget& panel_;
};

} // namespace

QScrollArea* scrolled(QWidget& panel) {
    auto* area = new Area;
    area->setWidget(&panel);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    new FollowsWidth(*area, panel);
    return area;
}

} // namespace edgescan::ui
