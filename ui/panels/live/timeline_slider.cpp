// The slider of the timeline.
#include "ui/panels/live/timeline_slider.h"

#include "ui/base/themes.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>

namespace edgescan::ui {

TimelineSlider::TimelineSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) { setMinimumWidth(200); }

void TimelineSlider::setMarks(std::vector<int> positions) {
    marks_ = std::move(positions);
    update();
}

int TimelineSlider::pixelOf(int position) const {
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
    return handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), position, width() - handle);
}

void TimelineSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    QPainter painter(this);
    painter.setPen(QPen(themeInUse().warn, 2.0));
    for (const int mark : marks_) {
        const int x = pixelOf(mark);
        painter.drawLine(x, 0, x, 4);
    }
}

/// A click moves the slider there, not by one page.
void TimelineSlider::mousePressEvent(QMouseEvent* event) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    if (event->button() == Qt::LeftButton && !handle.contains(event->pos())) {
        const int length = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
        setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), event->pos().x() - length / 2, width() - length));
    }
    QSlider::mousePressEvent(event);
}

} // namespace edgescan::ui

#include "moc_timeline_slider.cpp"
