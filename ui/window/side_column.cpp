// Lays out the column at the side of the views.
#include "ui/window/side_column.h"

#include <QBoxLayout>
#include <QEvent>
#include <QScrollBar>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kAround = 6, kBetween = 10, kBetweenInStrip = 4; // px
constexpr double kWide = 13.0;                                 // heights of its letters: 220 px with the usual font
constexpr double kMostOfHeight = 0.5;                          // of the window, a strip that is unfolded

} // namespace

SideColumn::SideColumn(QWidget* parent) : QScrollArea(parent), rows_(new QBoxLayout(QBoxLayout::TopToBottom)) {
    setObjectName("side-column");
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus); // the keyboard focus stays in the views
    setWidgetResizable(true);
    auto* content = new QWidget;
    content->setLayout(rows_);
    rows_->addStretch(1);
    setWidget(content); // with the ground of the window
    content->installEventFilter(this);
    verticalScrollBar()->installEventFilter(this);
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, [this](int /*least*/, int most) {
        if (strip_) verticalScrollBar()->setValue(most);
    });
    setStrip(false);
}

void SideColumn::add(QWidget& part) {
    rows_->insertWidget(rows_->count() - 1, &part);
    setStrip(strip_);
}

void SideColumn::setStrip(bool on) {
    strip_ = on;
    rows_->setSpacing(on ? kBetweenInStrip : kBetween);
    for (int n = 0; n + 1 < rows_->count(); ++n) { // a column gives each part its width; a strip unfolds upwards
        QWidget& part = *rows_->itemAt(n)->widget();
        rows_->setAlignment(&part, on ? Qt::AlignBottom : Qt::Alignment());
        part.setSizePolicy(on ? QSizePolicy::Preferred : QSizePolicy::Ignored, part.sizePolicy().verticalPolicy());
    }
    rows_->setDirection(on ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    on ? setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed) : setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    keepWidth();
    updateGeometry();
}

QSize SideColumn::sizeHint() const {
    if (!strip_) return {static_cast<int>(kWide * fontMetrics().height()), 0};
    return {0, std::min(widget()->sizeHint().height(), static_cast<int>(kMostOfHeight * window()->height()))};
}

/// A legend in a strip came, went or unfolded. In a column texts have the same width with and without a scroll bar: their lines stay.
bool SideColumn::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest && strip_) updateGeometry();
    if (watched == verticalScrollBar() && (event->type() == QEvent::Show || event->type() == QEvent::Hide)) keepWidth();
    return QScrollArea::eventFilter(watched, event);
}

void SideColumn::keepWidth() {
    const int right = strip_ || verticalScrollBar()->isVisible() ? 0 : verticalScrollBar()->sizeHint().width();
    rows_->setContentsMargins(kAround, kAround, right, kAround);
}

} // namespace edgescan::ui
