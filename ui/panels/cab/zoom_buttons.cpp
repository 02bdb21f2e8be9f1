// Zooms by taps.
#include "ui/panels/cab/zoom_buttons.h"

#include <QBoxLayout>
#include <QEvent>
#include <QToolButton>

#include <algorithm>
#include <tuple>

namespace edgescan::ui {
namespace {

constexpr int kSide = 52, kInset = 4, kRightEdge = 12, kBelowCorner = 8; // px
constexpr int kSignPx = 26;
constexpr double kZoomStep = 1.25;

} // namespace

ZoomButtons::ZoomButtons() : buttons_(new QBoxLayout(QBoxLayout::TopToBottom, this)) {
    setObjectName("cab-zoom");
    buttons_->setContentsMargins(kInset, kInset, kInset, kInset);
    buttons_->setSpacing(kInset);
    for (const auto& [name, sign, words, factor] :
         {std::tuple("cab-zoom-in", "+", tr("Zoom in"), kZoomStep), {"cab-zoom-out", "−", tr("Zoom out"), 1.0 / kZoomStep}}) {
        auto* button = new QToolButton;
        button->setObjectName(name);
        button->setText(QString::fromUtf8(sign));
        button->setAccessibleName(words);
        button->setFixedSize(kSide, kSide);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRepeat(true);
        QFont letters = button->font();
        letters.setPixelSize(kSignPx);
        letters.setBold(true);
        button->setFont(letters);
        connect(button, &QToolButton::clicked, this, [this, by = factor] { emit zoomed(by); });
        buttons_->addWidget(button);
    }
    adjustSize();
    hide();
}

void ZoomButtons::setOver(QWidget& view, QWidget& corner) {
    for (QWidget* each : {parentWidget(), corner_}) {
        if (each != nullptr) each->removeEventFilter(this);
    }
    corner_ = &corner;
    const bool wanted = wanted_;
    setParent(&view); // hides it
    wanted_ = wanted;
    for (QWidget* each : {&view, &corner}) each->installEventFilter(this);
    place();
}

void ZoomButtons::setVisible(bool on) {
    constexpr int kLeastHeight = 220; // px
    wanted_ = on;
    ViewPlate::setVisible(on && parentWidget() != nullptr && parentWidget()->height() >= kLeastHeight);
}

bool ZoomButtons::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move) place();
    return ViewPlate::eventFilter(watched, event);
}

/// In the middle of the right edge, or lower where the picture in the corner reaches that far. It stays there while the picture is off. A
/// low view has them in a row, until it is much higher: a row more or less of the live strip does not turn them.
void ZoomButtons::place() {
    constexpr int kLow = 370, kMuchHigher = 30; // px
    const int low = buttons_->direction() == QBoxLayout::LeftToRight ? kLow + kMuchHigher : kLow;
    buttons_->setDirection(parentWidget()->height() < low ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    buttons_->activate(); // else it has the least height of a column, from before it had a view
    const QSize room = parentWidget()->size(), own = sizeHint();
    const int top = std::max((room.height() - own.height()) / 2, corner_->geometry().bottom() + kBelowCorner);
    setGeometry(QRect(QPoint(room.width() - kRightEdge - own.width(), top), own));
    raise();
    setVisible(wanted_);
}

} // namespace edgescan::ui

#include "moc_zoom_buttons.cpp"
