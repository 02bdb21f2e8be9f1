// A dark plate over a view.
#include "ui/base/view_plate.h"

#include "ui/base/themes.h"

#include <QMouseEvent>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kLeastContent = 44;  // px of height: a title of two lines
constexpr int kTextsOfView = 50;   // px: margins of the view, and its texts at the top
constexpr int kGap = 4, kSide = 8; // px

/// Px of the whole rows of the content within this height.
int wholeRows(QWidget& content, int most) {
    content.resize(content.sizeHint());
    if (content.layout() != nullptr) content.layout()->activate();
    const auto rows = content.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
    int end = most;
    const auto isCut = [&](const QWidget* each) {
        return each->isVisibleTo(&content) && each->y() < end && each->geometry().bottom() >= end;
    };
    for (auto cut = std::ranges::find_if(rows, isCut); cut != rows.end(); cut = std::ranges::find_if(rows, isCut)) end = (*cut)->y();
    return end > 0 ? end : most;
}

} // namespace

ViewPlate::ViewPlate(QWidget* parent) : QFrame(parent) { setPalette(viewPalette()); }

void ViewPlate::mousePressEvent(QMouseEvent* event) { event->accept(); }

void ViewPlate::setContent(QWidget& content, QLayout* foot) {
    area_ = new QScrollArea(this);
    area_->setFrameShape(QFrame::NoFrame);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area_->setFocusPolicy(Qt::NoFocus); // the keyboard focus stays in the view
    area_->setWidgetResizable(true);
    area_->setWidget(&content);
    for (QWidget* each : {area_->viewport(), &content}) each->setAutoFillBackground(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSide, kSide - 2, kSide, kSide - 2);
    column->setSpacing(kGap);
    column->addWidget(area_);
    if (foot != nullptr) column->addLayout(foot);
    foot_ = foot;
}

void ViewPlate::fitInto(int height) {
    if (std::exchange(room_, height) != height) fitContent();
}

void ViewPlate::fitContent() {
    if (area_ != nullptr) {
        const QSize content = area_->widget()->sizeHint();
        const QMargins around = layout()->contentsMargins();
        const int foot = foot_ == nullptr ? 0 : foot_->sizeHint().height() + kGap;
        const int most = std::max(kLeastContent, room_ - kTextsOfView - around.top() - around.bottom() - foot);
        const bool whole = content.height() <= most;
        area_->setFixedSize(content.width() + (whole ? 0 : area_->verticalScrollBar()->sizeHint().width()),
                            whole ? content.height() : wholeRows(*area_->widget(), most));
        layout()->activate();
    }
    adjustSize();
    if (parentWidget() != nullptr && parentWidget()->layout() != nullptr) parentWidget()->layout()->activate(); // it grows upwards
}

void ViewPlate::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(0x63, 0x68, 0x6e));
    painter.setBrush(QColor(0x1b, 0x1d, 0x1f));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

} // namespace edgescan::ui

#include "moc_view_plate.cpp"
