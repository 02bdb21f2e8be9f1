// A button that must be held for a second.
#include "ui/panels/cab/hold_button.h"

#include "ui/base/themes.h"

#include <QPainter>

#include <algorithm>

namespace edgescan::ui {

HoldButton::HoldButton(QWidget* parent) : QToolButton(parent) {
    tick_.setInterval(30);
    connect(&tick_, &QTimer::timeout, this, &HoldButton::tick);
    connect(this, &QToolButton::pressed, this, [this] {
        since_.start();
        tick_.start();
    });
    connect(this, &QToolButton::released, this, [this] {
        const bool early = tick_.isActive();
        tick_.stop();
        update();
        if (early) emit releasedEarly();
    });
}

void HoldButton::tick() {
    update();
    if (since_.elapsed() < kHoldMs) return;
    tick_.stop();
    setDown(false);
    emit held();
}

void HoldButton::paintEvent(QPaintEvent* event) {
    QToolButton::paintEvent(event);
    if (!tick_.isActive()) return;
    constexpr int kBar = 5; // px
    const double share = std::min(1.0, static_cast<double>(since_.elapsed()) / kHoldMs);
    QPainter(this).fillRect(QRectF(0, height() - kBar, share * width(), kBar), themeInUse().accent);
}

} // namespace edgescan::ui

#include "moc_hold_button.cpp"
