// The card of a target.
#include "ui/panels/targets/target_card.h"

#include "ui/base/flow_layout.h"
#include "ui/base/language/catalogue.h"
#include "ui/base/narrow_button.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr double kLarge = 2.0; // relative to the normal font size, for the main number of the card

/// In English, as in the file, which people with other languages may read.
Facts storedFacts(const inspect::CellTarget& target, const TargetSurroundings& around) {
    const SourceTexts words;
    return targetFacts(target, around);
}

/// The value when the target was set, if there was one ("▲ no pose" is not one) and it differs now.
QString wasOf(const inspect::PinnedTarget& pinned, const Fact& stored) {
    const auto row = std::ranges::find(pinned.asPinned, stored.name.toStdString(), &std::pair<std::string, std::string>::first);
    if (!stored.measured || row == pinned.asPinned.end() || row->second == stored.text().toStdString()) return {};
    const QString was = exactText(row->second);
    return was.startsWith("▲") ? QString() : TargetCard::tr("was %1").arg(shownName(was));
}

} // namespace

TargetCard::TargetCard(QWidget* parent)
    : QFrame(parent), number_(new QLabel), name_(new QLineEdit), note_(new QLineEdit), wholeNote_(new QLabel), lock_(new QToolButton),
      close_(new QToolButton), distance_(new LargeLabel(kLarge)), tolerance_(new QLabel), rows_(new FactList), caveat_(new QLabel),
      why_(new NarrowButton(tr("Why"))), measure_(new NarrowButton(tr("Measure"))), copy_(new NarrowButton(tr("Copy"))) {
    setObjectName("target-card");
    setFrameShape(QFrame::StyledPanel);
    number_->setObjectName("target-number");
    followColours(*number_, [this](const Theme& theme) {
        number_->setStyleSheet(QString("background: %1; color: %2; font-weight: bold; border-radius: 3px; padding: 1px 6px;")
                                   .arg(theme.text.name(), theme.base.name()));
    });
    name_->setObjectName("target-name");
    name_->setPlaceholderText(tr("Target"));
    name_->setMaxLength(static_cast<int>(inspect::kLongestTargetName) / 4); // a character may take four bytes
    name_->setToolTip(tr("Its name: keystone, left shoulder …"));
    note_->setObjectName("target-note");
    note_->setPlaceholderText(tr("Note"));
    note_->setMaxLength(static_cast<int>(inspect::kLongestTargetNote) / 4);
    note_->setToolTip(tr("Your note on it, stored with its name"));
    wholeNote_->setObjectName("target-whole-note");
    wholeNote_->setWordWrap(true);
    wholeNote_->setTextFormat(Qt::PlainText);
    connect(note_, &QLineEdit::textChanged, this, &TargetCard::fitNote);
    lock_->setObjectName("target-lock");
    lock_->setText(tr("Lock"));
    lock_->setCheckable(true);
    lock_->setToolTip(tr("Locked: Del and Remove All do not remove it"));
    close_->setObjectName("target-close");
    close_->setText(QStringLiteral("✕"));
    close_->setAutoRaise(true);
    close_->setToolTip(tr("Remove this target"));
    distance_->setObjectName("target-distance");
    caveat_->setText(QObject::tr(rocks::kRockCaveat));
    caveat_->setWordWrap(true);

    auto* head = new QHBoxLayout;
    head->addWidget(number_);
    head->addWidget(name_, 1);
    head->addWidget(lock_);
    head->addWidget(close_);
    auto* number = new FlowLayout; // a narrow card has "± 0.014 m" on a line of its own
    number->addWidget(distance_);
    tolerance_->setObjectName("target-tolerance");
    tolerance_->setWordWrap(true); // "was 14.944 m ± 0.035 m" does not widen the panel
    number->addWidget(tolerance_);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {why_, measure_, copy_}) buttons->addWidget(button);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    column->addLayout(head);
    column->addLayout(number);
    column->addLayout(buttons); // above the rows: in sight also where the card must be scrolled
    column->addWidget(note_);
    column->addWidget(wholeNote_);
    column->addWidget(rows_);
    column->addWidget(caveat_);

    connect(close_, &QToolButton::clicked, this, &TargetCard::closeRequested);
    connect(lock_, &QToolButton::clicked, this, &TargetCard::lockRequested);
    for (QLineEdit* field : {name_, note_})
        connect(field, &QLineEdit::returnPressed, field, &QWidget::clearFocus); // the next key is a command
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        if (name_->isModified()) emit renamed(name_->text().simplified()); // else a longer name of a file would be cut
    });
    connect(note_, &QLineEdit::editingFinished, this, [this] {
        if (note_->isModified()) emit noted(note_->text().simplified());
    });
    hide();
}

void TargetCard::show(const inspect::PinnedTarget& target, const inspect::CellTarget* known, const TargetSurroundings& around) {
    setVisible(true);
    number_->setText(QString::number(target.number));
    if (!name_->hasFocus()) name_->setText(shownName(exactText(target.name)));
    if (!note_->hasFocus()) note_->setText(shownName(exactText(target.note), note_->maxLength()));
    lock_->setChecked(target.locked);
    lock_->setText(target.locked ? tr("Locked") : tr("Lock"));
    close_->setEnabled(!target.locked);
    if (known == nullptr) return;
    const Facts stored = storedFacts(*known, around);
    Facts facts = targetFacts(*known, around);
    for (std::size_t n = 0; n < facts.size(); ++n) facts[n].was = wasOf(target, stored[n]);
    const Fact& distance = facts.front();
    distance_->setText(distance.value);
    tolerance_->setText(distance.was.isEmpty() ? distance.tolerance : distance.tolerance + "\n" + distance.was);
    for (QLabel* each : {distance_, tolerance_}) each->setToolTip(distance.tip);
    facts.erase(facts.begin());
    rows_->show(facts);
    measure_->setEnabled(known->probe.state == CellState::Valid);
}

/// A note that is longer than its field is shown below it.
void TargetCard::fitNote() {
    constexpr int kMargins = 12; // px, of the field
    const bool fits = note_->fontMetrics().horizontalAdvance(note_->text()) <= note_->width() - kMargins;
    wholeNote_->setText(fits ? QString() : note_->text());
    wholeNote_->setHidden(fits);
}

void TargetCard::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitNote();
}

void TargetCard::editName() {
    name_->setFocus();
    name_->selectAll();
}

QString TargetCard::text() const {
    const QString title =
        name_->text().isEmpty() ? tr("Target %1").arg(number_->text()) : tr("Target %1: %2").arg(number_->text(), name_->text());
    QStringList lines{title};
    if (!note_->text().isEmpty()) lines << tr("Note") + ": " + note_->text();
    lines << (distance_->text() + " " + tolerance_->text()).trimmed();
    lines << rows_->texts() << caveat_->text();
    return lines.join('\n');
}

std::vector<std::pair<std::string, std::string>> rowsToStore(const inspect::CellTarget& target, const TargetSurroundings& around) {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Fact& fact : storedFacts(target, around)) {
        if (fact.measured && fact.known) rows.emplace_back(fact.name.toStdString(), fact.text().toStdString());
    }
    return rows;
}

} // namespace edgescan::ui

#include "moc_target_card.cpp"
