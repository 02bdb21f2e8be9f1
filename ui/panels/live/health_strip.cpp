// The health of a live scan in one row.
#include "ui/panels/live/health_strip.h"

#include "ui/base/shown_text.h"
#include "ui/panels/live/state_badge.h"

#include <QHBoxLayout>
#include <QLabel>

namespace edgescan::ui {

HealthStrip::HealthStrip(QWidget* parent)
    : QWidget(parent), badge_(new StateBadge), lines_(new QLabel), lost_(new QLabel), noReturn_(new QLabel), remark_(new StateBadge),
      window_(new StateBadge), device_(new StateBadge), pose_(new QLabel), end_(new QLabel), recording_(new StateBadge),
      sentence_(new QLabel) {
    badge_->setObjectName("live-badge");
    lines_->setObjectName("live-lines");
    lost_->setObjectName("live-lost");
    remark_->setObjectName("live-remark");
    sentence_->setObjectName("live-sentence");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    row->setSpacing(10);
    for (QWidget* each :
         std::initializer_list<QWidget*>{badge_, lines_, lost_, noReturn_, remark_, window_, device_, pose_, end_, recording_})
        row->addWidget(each);
    row->addWidget(sentence_, 1);
    row->addStretch(0);
    // A long sentence must not push the window wider; it is whole in the tool tip.
    sentence_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    for (QLabel* label : {lines_, lost_, noReturn_, pose_, end_, sentence_}) label->setTextFormat(Qt::PlainText);
    for (QLabel* label : {lines_, lost_, noReturn_, pose_, end_}) label->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    showHealth(LiveHealth{});
}

void HealthStrip::showHealth(const LiveHealth& health, Picture picture) {
    shown_ = health;
    const auto tell = [](QLabel* label, const std::string& text) {
        const QString words = shownText(text);
        if (label->text() != words) label->setText(words);
        label->setVisible(!text.empty());
    };
    const auto badge = [](StateBadge* each, StateBadge::Sign sign, const std::string& text) {
        each->showState(sign, shownText(text));
        each->setVisible(!text.empty());
    };
    // Green is only what is seen growing now; what is wrong with the scanner goes before all else.
    const bool aside = health.liveness == Liveness::Live && picture != Picture::Follows;
    badge(badge_, aside ? StateBadge::Sign::Waiting : signOf(health.liveness),
          !aside                     ? health.badge
          : picture == Picture::Held ? tr("HELD").toStdString()
                                     : tr("CONNECTED, another picture is shown").toStdString());
    tell(lines_, health.lines);
    tell(lost_, health.lost);
    lost_->setToolTip(tr("Lines whose telegrams never came; hatched in the images"));
    tell(noReturn_, health.noReturn);
    badge(remark_, signOf(health.telegrams), health.remark);
    QStringList remarks;
    for (const std::string& sentence : health.remarks) remarks << shownText(sentence);
    remark_->setToolTip(remarks.join('\n'));
    badge(window_, signOf(health.window), health.contamination);
    // A device that is well needs no badge of its own.
    badge(device_, signOf(health.device), health.device == Condition::Good ? std::string() : health.deviceState);
    tell(pose_, health.lines.empty() ? std::string() : health.pose);
    tell(end_, health.end);
    badge(recording_, signOf(health.recorded), health.recording);
    tell(sentence_, health.liveness == Liveness::Live ? std::string() : health.sentence);
    sentence_->setToolTip(shownText(health.sentence));
}

} // namespace edgescan::ui
