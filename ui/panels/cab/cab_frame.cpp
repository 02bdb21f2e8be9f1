// The head, the tools, the central area and the panel of cab mode.
#include "ui/panels/cab/cab_frame.h"

#include "ui/base/elided_label.h"
#include "ui/panels/cab/glove_buttons.h"

#include <QDateTime>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kClockMs = 1000;
constexpr int kLeastName = 84;      // px
constexpr int kFactsPx = 15;        // of two lines
constexpr double kBadgeShare = 0.2; // of the width
constexpr int kNarrowestBadge = 150, kWidestBadge = 300;
constexpr int kBetweenTools = 8; // px
constexpr int kGloveSide = 48, kBetweenButtons = 4;
constexpr double kSideShare = 0.225; // of the width
constexpr int kNarrowestSide = 236, kWidestSide = 400;

int wideOf(const QWidget* each) { return std::max(each->minimumSizeHint().width(), each->minimumWidth()) + kBetweenTools; }

} // namespace

CabHead::CabHead(QWidget* badge, QWidget* parent)
    : QWidget(parent), menu_(gloveButton("cab-menu", "menu", tr("Menu"))), open_(gloveButton("cab-open", "open", tr("Open"))),
      connect_(gloveButton("cab-connect", "connect", tr("Connect"))), name_(new QLabel), facts_(new ElidedLabel(nullptr, 2)),
      cancel_(gloveButton("cab-cancel", "fold", tr("Cancel"))), warnings_(gloveButton("cab-warnings", "why", QString())),
      clock_(new QLabel), leave_(new HoldButton), badge_(badge) {
    makeGloveButton(*leave_, "cab-leave", "lock", tr("Hold to leave"));
    leave_->setAccessibleName(tr("Hold for one second to leave cab mode"));
    leave_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed); // its words are never shortened
    cancel_->hide();
    QSizePolicy stays = warnings_->sizePolicy(); // warnings come and go: nothing next to them moves
    stays.setRetainSizeWhenHidden(true);
    warnings_->setSizePolicy(stays);
    warnings_->hide();
    for (QLabel* each : std::initializer_list<QLabel*>{name_, facts_}) {
        each->setTextFormat(Qt::PlainText);
        each->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long name must not widen the window
    }
    name_->setMinimumWidth(kLeastName);
    name_->setObjectName("cab-name");
    facts_->setObjectName("cab-facts");
    clock_->setObjectName("cab-clock");
    clock_->setAlignment(Qt::AlignCenter);
    QFont bold = name_->font();
    bold.setBold(true);
    name_->setFont(bold);
    QFont small = facts_->font();
    small.setPixelSize(kFactsPx);
    facts_->setFont(small);
    facts_->setMinimumHeight(2 * QFontMetrics(small).height());
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(name_);
    words->addWidget(facts_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(kBetweenTools);
    for (QWidget* each : std::initializer_list<QWidget*>{menu_, open_, connect_}) row->addWidget(each);
    row->addLayout(words, 1);
    for (QWidget* each : std::initializer_list<QWidget*>{cancel_, warnings_, badge, clock_, leave_}) row->addWidget(each);
    auto* tick = new QTimer(this);
    tick->setInterval(kClockMs);
    connect(tick, &QTimer::timeout, this, &CabHead::showClock);
    tick->start();
    showClock();
}

void CabHead::showClock() { clock_->setText(QDateTime::currentDateTimeUtc().toString("hh:mm") + "\nUTC"); }

void CabHead::showScan(const QString& name, const QString& facts) {
    scan_ = name;
    scanFacts_ = facts;
    fit();
}

void CabHead::showWork(const QString& text) {
    work_ = text;
    cancel_->setHidden(text.isEmpty());
    fit();
}

QSize CabHead::minimumSizeHint() const {
    return {menu_->sizeHint().width() + leave_->sizeHint().width() + kLeastName, layout()->totalMinimumSize().height()};
}

/// What is always there or may come: the way out, the warnings, Cancel, and the badge, which says what the picture is.
int CabHead::reservedWidth() const {
    int wide = kLeastName + badge_->maximumWidth() + kBetweenTools;
    for (const QWidget* each : std::initializer_list<const QWidget*>{menu_, leave_, cancel_, warnings_}) wide += wideOf(each);
    return wide;
}

/// Open, connect and the clock are there while they have room, and in the menu otherwise. Only the width decides: no button moves because a
/// word, a warning or a progress came.
void CabHead::fit() {
    const QMargins around = layout()->contentsMargins();
    const int wide = width();
    badge_->setFixedWidth(std::clamp(static_cast<int>(kBadgeShare * wide), kNarrowestBadge, kWidestBadge));
    reservedWidth_ = reservedWidth();
    int left = wide - around.left() - around.right() - reservedWidth_;
    for (QWidget* each : std::initializer_list<QWidget*>{open_, connect_, clock_}) {
        const bool fits = wideOf(each) <= left;
        each->setVisible(fits);
        if (width() != wide) return;                     // the window was resized by it, and all this was done for the new width
        left -= fits ? wideOf(each) : std::max(0, left); // in this order
    }
    layout()->activate(); // the labels have their new widths
    name_->setText(name_->fontMetrics().elidedText(scan_, Qt::ElideRight, std::max(40, name_->width())));
    name_->setToolTip(scan_);
    facts_->setText(work_.isEmpty() ? scanFacts_ : work_);
    facts_->setToolTip(facts_->text());
}

void CabHead::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

/// Another font or language.
bool CabHead::event(QEvent* event) {
    const bool used = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest && reservedWidth() != reservedWidth_) fit();
    return used;
}

CabFrame::CabFrame(QWidget* middle, QWidget* badge)
    : head_(new CabHead(badge)), tools_(new QWidget), side_(new QWidget), toolsGrid_(new QGridLayout(tools_)), ofB_(new QLabel),
      panels_(new QStackedWidget), foot_(new QHBoxLayout), leastWide_(new QSpacerItem(kNarrowestSide, 0)) {
    toolsGrid_->setContentsMargins(kBetweenButtons, kBetweenButtons, kBetweenButtons, kBetweenButtons);
    toolsGrid_->setSpacing(kBetweenButtons);
    tools_->setMinimumHeight(kGloveSide); // a lower window has two columns
    ofB_->setObjectName("cab-of-b");
    ofB_->hide();
    auto* column = new QVBoxLayout(side_);
    column->setContentsMargins(kBetweenButtons, 0, kBetweenButtons, kBetweenButtons);
    column->addItem(leastWide_);
    column->addWidget(ofB_);
    column->addWidget(panels_, 1);
    column->addLayout(foot_);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    grid->addWidget(head_, 0, 0, 1, 3);
    grid->addWidget(tools_, 1, 0);
    grid->addWidget(middle, 1, 1);
    grid->addWidget(side_, 1, 2);
    grid->setColumnStretch(1, 1000);
    grid->setColumnStretch(2, 1); // as wide as its panels need
    grid->setRowStretch(1, 1);
    setCab(false);
}

void CabFrame::setCab(bool on) {
    for (QWidget* each : std::initializer_list<QWidget*>{head_, tools_, side_}) each->setVisible(on);
}

void CabFrame::addTool(QToolButton* button) {
    buttons_.push_back(button);
    layTools();
}

void CabFrame::addBelowPanel(QToolButton* button) { foot_->addWidget(button); }

void CabFrame::showPanel(int place, bool ofB) {
    panels_->setCurrentIndex(place);
    panels_->widget(0)->setSizePolicy(place == 0 ? QSizePolicy::Preferred : QSizePolicy::Ignored, QSizePolicy::Preferred); // the widest
    ofB_->setText(panels_->currentWidget()->windowTitle() + " · B");
    ofB_->setVisible(ofB);
}

void CabFrame::layTools() {
    const int all = static_cast<int>(buttons_.size()), high = height() - head_->sizeHint().height();
    const int columns = high >= all * (kGloveSide + kBetweenButtons) + kBetweenButtons ? 1 : 2;
    for (int n = 0; n < all; ++n) toolsGrid_->addWidget(buttons_[static_cast<std::size_t>(n)], n / columns, n % columns);
}

void CabFrame::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layTools();
    leastWide_->changeSize(std::clamp(static_cast<int>(kSideShare * event->size().width()), kNarrowestSide, kWidestSide), 0);
    side_->layout()->invalidate();
}

} // namespace edgescan::ui

#include "moc_cab_frame.cpp"
