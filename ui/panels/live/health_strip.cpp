// The health of a live scan in one row.
#include "ui/panels/live/health_strip.h"

#include "ui/base/core_words.h"
#include "ui/base/elided_label.h"
#include "ui/base/flow_layout.h"
#include "ui/base/shown_text.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/sweep_bar.h"

#include <QLabel>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QTimer>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr int kStripRim = 2, kStripGap = 10; // px
constexpr int kNarrowStrip = 700;            // px: of a cab, which has room for one row of what nothing else shows
constexpr int kLeastBar = 60;                // px
constexpr int kEmptyMs = 3000;

} // namespace

HealthStrip::HealthStrip(QWidget* parent)
    : QWidget(parent), badge_(new StateBadge), lines_(new QLabel), bar_(new SweepBar), lost_(new QLabel), noReturn_(new QLabel),
      remark_(new StateBadge), window_(new StateBadge), device_(new StateBadge), pose_(new QLabel), end_(new QLabel),
      recording_(new StateBadge), sentence_(new ElidedLabel) {
    for (StateBadge* each : {badge_, remark_, window_, device_, recording_}) each->setShrinks();
    badge_->setObjectName("live-badge");
    lines_->setObjectName("live-lines");
    lost_->setObjectName("live-lost");
    noReturn_->setObjectName("live-no-return");
    remark_->setObjectName("live-remark");
    recording_->setObjectName("live-recording");
    sentence_->setObjectName("live-sentence");
    bar_->setMinimumWidth(kLeastBar);
    auto* row = new FlowLayout(this);
    row->setContentsMargins(0, kStripRim, 6, kStripRim);
    row->setSpacing(kStripGap);
    QFont bold = lines_->font();
    bold.setBold(true);
    for (QLabel* label : {lines_, end_}) label->setFont(bold);
    for (QWidget* each :
         std::initializer_list<QWidget*>{badge_, lines_, bar_, end_, lost_, noReturn_, remark_, window_, device_, pose_, recording_})
        row->addWidget(each);
    row->addWidget(sentence_);
    // A long sentence must not widen the window; the tool tip shows all of it.
    sentence_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    for (QLabel* label : {lines_, lost_, noReturn_, pose_, end_, sentence_}) label->setTextFormat(Qt::PlainText);
    for (QLabel* label : {lines_, lost_, noReturn_, pose_, end_}) label->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    auto* empty = new QTimer(this); // a row that was empty for so long is given back
    empty->setObjectName("live-empty-row");
    empty->setSingleShot(true);
    empty->setInterval(kEmptyMs);
    connect(empty, &QTimer::timeout, this, [this] {
        kept_ = 0;
        keepHeight();
    });
    showHealth(files::LiveHealth{});
}

void HealthStrip::showHealth(const files::LiveHealth& health, Picture picture, const QString& note) {
    shown_ = health;
    picture_ = picture;
    note_ = note;
    const bool narrow = isNarrow();
    const auto showText = [](QLabel* label, const std::string& text, bool firstPart = false) {
        const QString words = firstPart ? coreWords(text).section(':', 0, 0).trimmed() : coreWords(text);
        if (label->text() != words) label->setText(words);
        label->setVisible(!text.empty());
    };
    // Green is only for what is so now.
    const bool present = health.liveness == files::Liveness::Live;
    const auto badge = [present](StateBadge* each, StateBadge::Sign sign, const QString& words, bool shown = true) {
        each->showState(sign == StateBadge::Sign::Good && !present ? StateBadge::Sign::Off : sign, words);
        each->setToolTip(words); // a narrow strip cuts it
        each->setVisible(shown && !words.isEmpty());
    };
    // A fault of the scanner has priority over the picture's relation to it.
    const bool notFollowing = health.liveness == files::Liveness::Live && picture != Picture::Follows;
    const bool other = notFollowing && picture == Picture::Other;
    // The badge at the head of a cab says the same.
    const bool inHead =
        notFollowing ? picture == Picture::Held : picture == Picture::Follows || health.liveness == files::Liveness::Stopped;
    badge(badge_, notFollowing ? StateBadge::Sign::Waiting : signOf(health.liveness),
          !notFollowing              ? coreWords(health.badge)
          : picture == Picture::Held ? tr("HELD")
                                     : tr("ANOTHER PICTURE"),
          !brief_ || !inHead);
    if (other) badge_->setToolTip(tr("CONNECTED, another picture is shown"));
    // Always with its sweep: a held picture counts the lines of another one.
    const bool heldNarrow = narrow && notFollowing && picture == Picture::Held;
    QString lines = coreWords(health.lines);
    if (notFollowing && lines.section(' ', 0, 0).contains('/')) lines = lines.section(' ', 0, 0); // "93/120", which is in one row
    if (!lines.isEmpty() && health.sweep > 0)
        lines = (notFollowing && !narrow ? tr("now sweep %1: %2") : tr("sweep %1: %2")).arg(health.sweep).arg(lines);
    lines_->setText(lines);
    reserveWidths();
    // The head of a cab has those of the picture, which follow a little later: two counts would contradict each other.
    lines_->setVisible(!lines.isEmpty() && (!brief_ || (narrow ? heldNarrow : picture != Picture::Follows)));
    bar_->showRows(health.row, heldNarrow || (narrow && inHead && !present) ? 0 : health.rows, health.lostRows);
    showText(lost_, health.lost, narrow); // the bar shows where
    lost_->setToolTip(tr("Lines whose telegrams did not arrive: dashes in the images"));
    // Of a sweep that is not shown: Hold would give the strip another row.
    const std::string share = brief_ || notFollowing ? std::string() : health.noReturn;
    // A narrow row is for the cause of a loss.
    badge(remark_, signOf(health.telegrams), coreWords(health.remark), !narrow || health.liveness != files::Liveness::Lost);
    QStringList remarks;
    for (const std::string& sentence : health.remarks) remarks << coreSentence(scannersWarning(shownText(sentence)));
    remark_->setToolTip(remarks.join('\n'));
    badge(window_, signOf(health.window), coreWords(health.contamination), !brief_ || health.window != files::Condition::Good);
    // A device without faults has no badge.
    badge(device_, signOf(health.device), coreWords(health.deviceState), health.device != files::Condition::Good);
    showText(pose_, health.lines.empty() || brief_ || notFollowing ? std::string() : health.pose);
    showText(end_, narrow && notFollowing ? std::string() : health.end);
    end_->setVisible(end_->minimumWidth() > 0 || !end_->text().isEmpty()); // it has its place before it is known
    // While nothing is wrong with it, the recording is shown next to its button; in a cab, which has no room there, here.
    const bool recordsWell = health.recorded == files::Condition::Good;
    const QString recording = coreWords(health.recording);
    badge(recording_, signOf(health.recorded), narrow && recordsWell ? recording.section(' ', -2) : recording, !recordsWell || brief_);
    QString ofScanner = present ? QString() : coreSentence(health.sentence);
    static const QRegularExpression address("^\\S+: ");
    const QString whole = ofScanner;
    if (narrow) ofScanner.remove(address); // the cause is seen
    const QString sentence = ofScanner.isEmpty() ? note : ofScanner;
    if (sentence_->text() != sentence) sentence_->setText(sentence);
    const bool ofBadge =
        ofScanner.isEmpty() && picture == Picture::Held && (brief_ || present); // a row that comes with Hold would move the pictures
    if (ofBadge) badge_->setToolTip(note);
    sentence_->setVisible(!sentence.isEmpty() && !ofBadge);
    sentence_->setToolTip(whole.isEmpty() ? note : whole);
    // Last: it takes no row for itself. The legend has the number of these cells, and Hold, which leaves it out, would move the pictures.
    noReturn_->setText(coreWords(share));
    noReturn_->setVisible(!share.empty() && !static_cast<const FlowLayout*>(layout())->isHigherWith(*noReturn_, width()));
    keepHeight();
}

/// Hold and the next sweep give badge, lines, remark and end other words, and the lines get more digits: none may take another row.
void HealthStrip::reserveWidths() {
    const bool lives = shown_.liveness == files::Liveness::Live && !brief_;
    badge_->setMinimumWidth(lives ? std::max(badge_->widthFor(coreWords("LIVE")), badge_->widthFor(tr("HELD"))) : 0);
    const QString most = QString("%1/%1").arg(shown_.rows);
    const auto wide = [this](const QString& text) { return lines_->fontMetrics().horizontalAdvance(text); };
    const int widest = std::max(wide(tr("sweep %1: %2").arg(shown_.sweep).arg(coreWords((most + " lines").toStdString()))),
                                wide(tr("now sweep %1: %2").arg(shown_.sweep).arg(most)));
    lines_->setMinimumWidth(lives && shown_.rows > 0 && shown_.sweep > 0 ? widest : 0);
    remark_->setMinimumWidth(lives && !shown_.remark.empty() ? remark_->widthFor(coreWords("FIRST ANGLE ASSUMED")) : 0);
    end_->setMinimumWidth(lives && shown_.rows > 0 ? end_->fontMetrics().horizontalAdvance(coreWords("119 s left")) : 0);
}

void HealthStrip::setSteady(bool on) {
    steady_ = on;
    kept_ = 0;
    keepHeight();
}

void HealthStrip::keepHeight() {
    const int row = badge_->sizeHint().height() + 2 * kStripRim;
    kept_ = steady_ ? std::max({kept_, row, heightForWidth(width())}) : 0;
    setMinimumHeight(kept_);
    auto* empty = findChild<QTimer*>("live-empty-row");
    if (empty == nullptr) return; // not yet
    const bool isEmpty = steady_ && std::max(row, heightForWidth(width())) < kept_;
    if (!isEmpty)
        empty->stop();
    else if (!empty->isActive())
        empty->start();
}

void HealthStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->size().width() == event->oldSize().width()) return;
    kept_ = 0;
    showHealth(files::LiveHealth(shown_), picture_, QString(note_));
}

bool HealthStrip::isNarrow() const { return brief_ && width() < kNarrowStrip; }

void HealthStrip::setBrief(bool on) {
    brief_ = on;
    showHealth(files::LiveHealth(shown_), picture_, QString(note_));
}

} // namespace edgescan::ui

#include "moc_health_strip.cpp"
