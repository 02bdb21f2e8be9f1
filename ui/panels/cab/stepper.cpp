// Minus, number, plus.
#include "ui/panels/cab/stepper.h"

#include "core/edges/settings/parameters.h"
#include "ui/panels/tuning/parameter_row.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kStepperHigh = 64, kLetters = 24, kValue = 20, kLineGap = 4, kMeaning = 15; // px
constexpr int kStepperLeast = 48; // px: a narrow side has its scroll bar next to them
constexpr int kColumns = 4;       // two below each of the words, the inner ones for what was found
constexpr int kFirstRepeatMs = 400, kRepeatMs = 90;

// The steps grow, so that a large change takes few repeats.
int stepsAfter(int repeats) { return repeats < 12 ? 1 : repeats < 30 ? 5 : 25; }

} // namespace

Stepper::Stepper(ParameterRow& row, QWidget* parent)
    : QWidget(parent), head_(new QHBoxLayout), name_(new QLabel), less_(new QToolButton), value_(new QLabel), found_(new QLabel),
      more_(new QToolButton), ofLess_(new QLabel(tr("More edges"))), ofMore_(new QLabel(tr("Fewer edges"))) {
    less_->setObjectName("less");
    more_->setObjectName("more");
    value_->setObjectName("stepper-value");
    found_->setObjectName("stepper-found");
    found_->setAlignment(Qt::AlignCenter);
    found_->setTextFormat(Qt::PlainText);
    found_->hide();
    QFont small = font();
    small.setPixelSize(kMeaning);
    ofLess_->setObjectName("meaning-of-less");
    ofMore_->setObjectName("meaning-of-more");
    for (QLabel* each : {found_, ofLess_, ofMore_}) each->setFont(small);
    QFont bold = font();
    bold.setBold(true);
    bold.setPixelSize(kLetters);
    for (QWidget* each : std::initializer_list<QWidget*>{less_, value_, more_}) each->setFont(bold);
    bold.setPixelSize(kValue);
    value_->setFont(bold);
    // The value has a line of its own: between the buttons a narrow screen had no room for "39 mm auto", and half a value misleads.
    for (QLabel* each : {name_, value_}) {
        each->setWordWrap(true);
        each->setTextFormat(Qt::PlainText);
    }
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kLineGap);
    grid->setVerticalSpacing(kLineGap);
    auto* words = new QVBoxLayout;
    words->setSpacing(kLineGap);
    words->addWidget(name_);
    words->addWidget(value_);
    head_->addLayout(words, 1);
    grid->addLayout(head_, 0, 0, 1, kColumns);
    grid->addWidget(less_, 1, 0);
    grid->addWidget(found_, 1, 1, 1, 2);
    grid->addWidget(more_, 1, kColumns - 1);
    for (const auto& [label, column] : {std::pair(ofLess_, 0), std::pair(ofMore_, kColumns / 2)}) {
        label->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
        label->setWordWrap(true);
        grid->addWidget(label, 2, column, 1, kColumns / 2);
    }
    for (const int column : {0, kColumns - 1}) grid->setColumnStretch(column, 1);
    addButton(*less_, -1);
    addButton(*more_, +1);
    follow(row);
}

void Stepper::follow(ParameterRow& row) {
    if (row_ == &row) return;
    if (row_ != nullptr) row_->disconnect(this);
    row_ = &row;
    connect(row_, &ParameterRow::shown, this, &Stepper::showValue);
    const edges::Parameter& p = row.parameter();
    const QString name = QObject::tr(p.label);
    name_->setText(name);
    less_->setAccessibleName(tr("less: %1").arg(name));
    more_->setAccessibleName(tr("more: %1").arg(name));
    const bool threshold = p.feeds == edges::Stage::Threshold;
    less_->setText(threshold ? QStringLiteral("◀") : QStringLiteral("−")); // "−" would be read as fewer edges
    more_->setText(threshold ? QStringLiteral("▶") : QStringLiteral("+"));
    for (QLabel* each : {ofLess_, ofMore_}) each->setHidden(!threshold);
    showValue();
}

void Stepper::showValue() { value_->setText(row_->valueText()); }

void Stepper::setAside(QToolButton* button) { head_->addWidget(button, 0, Qt::AlignTop); }

void Stepper::addButton(QToolButton& button, int direction) {
    button.setMinimumWidth(kStepperLeast);
    button.setFixedHeight(kStepperHigh);
    button.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button.setFocusPolicy(Qt::TabFocus);
    button.setAutoRepeat(true);
    button.setAutoRepeatDelay(kFirstRepeatMs);
    button.setAutoRepeatInterval(kRepeatMs);
    connect(&button, &QToolButton::clicked, this, [this, &button, direction] {
        row_->step(direction * stepsAfter(repeats_++));
        if (button.isDown()) return; // the button is still pressed
        repeats_ = 0;
        emit row_->dragEnded();
    });
}

/// The buttons do not move under a finger because the number has a digit less.
void Stepper::showFound(const QString& words) {
    found_->setText(words);
    found_->setHidden(words.isEmpty());
    found_->setMinimumWidth(words.isEmpty() ? 0 : std::max(found_->minimumWidth(), found_->sizeHint().width()));
}

QString Stepper::value() const { return row_->valueText(); }

} // namespace edgescan::ui

#include "moc_stepper.cpp"
