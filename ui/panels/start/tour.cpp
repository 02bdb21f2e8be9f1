// The texts of the steps.
#include "ui/panels/start/tour.h"

#include "ui/base/flow_layout.h"
#include "ui/base/themes.h"

#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kLeastText = 320; // px

struct TourStep {
    QString text, button;
};

TourStep tourStep(int step) {
    switch (step) {
    case 0:
        return {Tour::tr("Open a scan or connect the scanner. The demo needs neither: it is a hung-up draw-bell."),
                Tour::tr("Open the demo")};
    case 1:
        return {Tour::tr("Drag turns the cloud, the middle button moves it, the wheel zooms. A click marks a cell in cloud, range image "
                         "and edge map; its card has distance and coordinates."),
                Tour::tr("View from the scanner")};
    case 2:
        return {Tour::tr("Change Edge strength first. The curve under it shows the number of edge cells for every value. Where it is flat, "
                         "the edges depend little on it."),
                Tour::tr("Show the edges panel")};
    case 3:
        return {Tour::tr("EdgeScan finds rocks from the edges, with visible sizes and a confidence. The table lists them. A click selects "
                         "a rock in all views."),
                Tour::tr("Show the rocks")};
    default:
        return {Tour::tr("The tools above measure and compare scans. File exports edges, clouds and a report. Help shows all keys, and "
                         "this tour again."),
                Tour::tr("Show the keys")};
    }
}

QToolButton* tourButton(const char* name, const QString& text = {}) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    return button;
}

} // namespace

Tour::Tour(QWidget* parent)
    : QFrame(parent), number_(new QLabel), text_(new QLabel), try_(tourButton("tour-try")), back_(tourButton("tour-back", tr("Back"))),
      next_(tourButton("tour-next")), end_(tourButton("tour-end", tr("End the tour"))) {
    setObjectName("tour");
    QFont bold = number_->font();
    bold.setBold(true);
    number_->setFont(bold);
    text_->setObjectName("tour-text");
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    text_->setMinimumWidth(kLeastText); // where the buttons leave less, they are below it
    auto* row = new FlowLayout(this);
    row->setContentsMargins(10, 4, 6, 4);
    row->addWidget(number_);
    row->addWidget(text_);
    for (QToolButton* button : {try_, back_, next_, end_}) row->addWidget(button);
    connect(try_, &QToolButton::clicked, this, [this] {
        if (step_ > 0) tick(step_); // the first one is done with the picture
        emit tryRequested(step_);
    });
    connect(back_, &QToolButton::clicked, this, [this] { showStep(step_ - 1); });
    connect(next_, &QToolButton::clicked, this, [this] { step_ + 1 < kSteps ? showStep(step_ + 1) : end(); });
    connect(end_, &QToolButton::clicked, this, &Tour::end);
    followColours(*this, [this](const Theme& theme) {
        setStyleSheet(
            QString("#tour { background: %1; border: none; border-left: 6px solid %2; }").arg(theme.panel.name(), theme.accent.name()));
    });
    hide();
}

void Tour::start() {
    running_ = true;
    showStep(0);
    show();
}

void Tour::end() {
    if (!running_) return;
    running_ = false;
    hide();
}

void Tour::showStep(int step) {
    step_ = std::clamp(step, 0, kSteps - 1);
    const TourStep shown = tourStep(step_);
    number_->setText((done_[static_cast<std::size_t>(step_)] ? "✓ " : "") + tr("%1 of %2").arg(step_ + 1).arg(kSteps));
    text_->setText(shown.text);
    try_->setText(shown.button);
    try_->setEnabled(step_ > 0 || !opening_);
    back_->setEnabled(step_ > 0);
    next_->setText(step_ + 1 < kSteps ? tr("Next") : tr("Done"));
    end_->setVisible(step_ + 1 < kSteps);
}

void Tour::tick(int step) {
    done_[static_cast<std::size_t>(step)] = true;
    showStep(step_);
}

void Tour::setOpening(bool on) {
    if (std::exchange(opening_, on) != on) showStep(step_);
}

} // namespace edgescan::ui

#include "moc_tour.cpp"
