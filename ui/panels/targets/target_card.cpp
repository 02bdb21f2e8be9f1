// The card of a target.
#include "ui/panels/targets/target_card.h"

#include "ui/base/language/catalogue.h"
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
constexpr const char* kDistanceRow = "Distance";

QString distanceWords(const inspect::CellTarget& target) { return (distanceText(target) + " " + toleranceText(target)).trimmed(); }

// The value of the row when the target was set, if there was one ("▲ no pose" is not one) and it differs now; both as stored.
QString wasOf(const inspect::PinnedTarget& pinned, const std::pair<std::string, std::string>& now) {
    const auto row = std::ranges::find(pinned.asPinned, now.first, &std::pair<std::string, std::string>::first);
    if (row == pinned.asPinned.end() || row->second == now.second || exactText(row->second).startsWith("▲")) return {};
    return TargetCard::tr("was %1").arg(shownName(exactText(row->second)));
}

/// The rows that a slider may change, as stored; `all`: with rows whose value is not computed yet.
std::vector<std::pair<std::string, std::string>> measuredRows(const inspect::CellTarget& target, const TargetSurroundings& around,
                                                              bool all) {
    const SourceTexts words; // people with other languages may read the file
    std::vector<std::pair<std::string, std::string>> rows{{kDistanceRow, distanceWords(target).toStdString()}};
    for (const TargetRow& row : targetRows(target, around)) {
        if (row.measured && (all || row.known)) rows.emplace_back(row.name.toStdString(), row.value.toStdString());
    }
    return rows;
}

} // namespace

TargetCard::TargetCard(QWidget* parent)
    : QFrame(parent), number_(new QLabel), name_(new QLineEdit), note_(new QLineEdit), wholeNote_(new QLabel), lock_(new QToolButton),
      close_(new QToolButton), distance_(new QLabel), tolerance_(new QLabel), lines_(new QVBoxLayout), caveat_(new QLabel),
      why_(new QPushButton(tr("Why"))), measure_(new QPushButton(tr("Measure"))), copy_(new QPushButton(tr("Copy"))) {
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
    QFont large = font();
    large.setPointSizeF(kLarge * large.pointSizeF());
    large.setBold(true);
    distance_->setFont(large);
    tolerance_->setToolTip(
        tr("Two standard deviations of the noise of this scan along the beam. Errors that the scanner makes everywhere are not included."));
    distance_->setToolTip(tolerance_->toolTip());
    caveat_->setText(QObject::tr(rocks::kRockCaveat));
    caveat_->setWordWrap(true);

    auto* head = new QHBoxLayout;
    head->addWidget(number_);
    head->addWidget(name_, 1);
    head->addWidget(lock_);
    head->addWidget(close_);
    auto* number = new QHBoxLayout;
    number->addWidget(distance_);
    tolerance_->setObjectName("target-tolerance");
    tolerance_->setWordWrap(true); // "was 14.944 m ± 0.035 m" does not widen the panel
    tolerance_->setAlignment(Qt::AlignLeft | Qt::AlignBottom);
    number->addWidget(tolerance_, 1);
    lines_->setSpacing(2);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {why_, measure_, copy_}) {
        button->setMinimumWidth(std::max(48, button->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width() + 14));
        buttons->addWidget(button);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(4);
    column->addLayout(head);
    column->addLayout(number);
    column->addLayout(buttons); // above the rows: in sight also where the card must be scrolled
    column->addWidget(note_);
    column->addWidget(wholeNote_);
    column->addLayout(lines_);
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
    const auto compared = measuredRows(*known, around, true);
    auto row = compared.begin();
    const QString was = wasOf(target, *row++);
    distance_->setText(distanceText(*known));
    tolerance_->setText(toleranceText(*known) + (was.isEmpty() ? QString() : "\n" + was));
    const std::vector<TargetRow> rows = targetRows(*known, around);
    for (std::size_t n = 0; n < std::max(rows.size(), rows_.size()); ++n) {
        if (n < rows.size()) setRow(n, rows[n], rows[n].measured ? wasOf(target, *row++) : QString());
        if (n >= rows.size()) {
            rows_[n].first->hide();
            rows_[n].second->hide();
        }
    }
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

void TargetCard::setRow(std::size_t row, const TargetRow& words, const QString& was) {
    if (row == rows_.size()) {
        rows_.emplace_back(new QLabel, new QLabel);
        rows_[row].second->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        rows_[row].second->setWordWrap(true);
        rows_[row].second->setTextInteractionFlags(Qt::TextSelectableByMouse);
        auto* line = new QHBoxLayout; // no columns: a long name does not narrow the numbers of other rows
        line->addWidget(rows_[row].first, 0, Qt::AlignTop);
        line->addWidget(rows_[row].second, 1);
        lines_->addLayout(line);
    }
    const auto& [name, value] = rows_[row];
    name->setText(*words.unit == '\0' ? words.name : QString("%1 [%2]").arg(words.name, words.unit));
    value->setText(was.isEmpty() ? words.value : words.value + "\n" + was);
    for (QLabel* label : {name, value}) {
        label->setToolTip(words.tip);
        label->show();
    }
}

QString TargetCard::text() const {
    const QString title =
        name_->text().isEmpty() ? tr("Target %1").arg(number_->text()) : tr("Target %1: %2").arg(number_->text(), name_->text());
    QStringList lines{title};
    if (!note_->text().isEmpty()) lines << tr("Note") + ": " + note_->text();
    lines << (distance_->text() + " " + tolerance_->text()).trimmed();
    for (const auto& [row, value] : rows_) {
        if (!row->isHidden()) lines << row->text() + ": " + value->text();
    }
    lines << caveat_->text();
    return lines.join('\n');
}

std::vector<std::pair<std::string, std::string>> rowsToStore(const inspect::CellTarget& target, const TargetSurroundings& around) {
    return measuredRows(target, around, false);
}

} // namespace edgescan::ui

#include "moc_target_card.cpp"
