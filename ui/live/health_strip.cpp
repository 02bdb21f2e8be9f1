// The health of a live scan in one row.
#include "ui/live/health_strip.h"

#include "ui/live/state_badge.h"

#include <QHBoxLayout>
#include <QLabel>

namespace edgescan::ui {

HealthStrip::HealthStrip(QWidget* parent)
    : QWidget(parent), badge_(new StateBadge), lines_(new QLabel), lost_(new QLabel), noReturn_(new QLabel), window_(new StateBadge),
      device_(new StateBadge), pose_(new QLabel), end_(new QLabel), recording_(new StateBadge), sentence_(new QLabel) {
    badge_->setObjectName("live-badge");
    lines_->setObjectName("live-lines");
    lost_->setObjectName("live-lost");
    sentence_->setObjectName("live-sentence");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    row->setSpacing(10);
    for (QWidget* each : std::initializer_list<QWidget*>{badge_, lines_, lost_, noReturn_, window_, device_, pose_, end_, recording_})
        row->addWidget(each);
    row->addWidget(sentence_, 1);
    row->addStretch(0);
    // A long sentence must not push the window wider; it is whole in the tool tip.
    sentence_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    for (QLabel* label : {lines_, lost_, noReturn_, pose_, end_, sentence_}) label->setTextFormat(Qt::PlainText);
    for (QLabel* label : {lines_, lost_, noReturn_, pose_, end_}) label->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    showHealth(LiveHealth{});
}

void HealthStrip::showHealth(const LiveHealth& health) {
    shown_ = health;
    const auto tell = [](QLabel* label, const std::string& text) {
        const QString words = QString::fromStdString(text);
        if (label->text() != words) label->setText(words);
        label->setVisible(!text.empty());
    };
    const auto badge = [](StateBadge* each, StateBadge::Sign sign, const std::string& text) {
        each->showState(sign, QString::fromStdString(text));
        each->setVisible(!text.empty());
    };
    badge(badge_, signOf(health.liveness), health.badge);
    tell(lines_, health.lines);
    tell(lost_, health.lost);
    lost_->setToolTip(tr("Lines whose telegrams never came; hatched in the images"));
    tell(noReturn_, health.noReturn);
    badge(window_, signOf(health.window), health.contamination);
    // A device that is well needs no badge of its own.
    badge(device_, signOf(health.device), health.device == Condition::Good ? std::string() : health.deviceState);
    tell(pose_, health.lines.empty() ? std::string() : health.pose);
    tell(end_, health.end);
    badge(recording_, signOf(health.recorded), health.recording);
    tell(sentence_, health.liveness == Liveness::Live ? std::string() : health.sentence);
    sentence_->setToolTip(QString::fromStdString(health.sentence));
}

} // namespace edgescan::ui
