// Minus, number, plus.
#include "ui/panels/cab/stepper.h"

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

Stepper::Stepper(const QString& name, QWidget* parent)
    : QWidget(parent), head_(new QHBoxLayout), name_(new QLabel), less_(new QToolButton), value_(new QLabel), found_(new QLabel),
      more_(new QToolButton) {
    less_->setObjectName("less");
    more_->setObjectName("more");
    value_->setObjectName("stepper-value");
    found_->setObjectName("stepper-found");
    found_->setAlignment(Qt::AlignCenter);
    found_->setTextFormat(Qt::PlainText);
    found_->hide();
    QFont small = font();
    small.setPixelSize(kMeaning);
    found_->setFont(small);
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
    for (const int column : {0, kColumns - 1}) grid->setColumnStretch(column, 1);
    addButton(*less_, -1);
    addButton(*more_, +1);
    setMeaning({}, {});
    showName(name);
}

void Stepper::setMeaning(const QString& ofLess, const QString& ofMore) {
    less_->setText(ofLess.isEmpty() ? QStringLiteral("−") : QStringLiteral("◀")); // "−" would be read as fewer edges
    more_->setText(ofMore.isEmpty() ? QStringLiteral("+") : QStringLiteral("▶"));
    auto* grid = static_cast<QGridLayout*>(layout());
    for (const auto& [words, column] : {std::pair(ofLess, 0), std::pair(ofMore, kColumns / 2)}) {
        const QString name = column == 0 ? "meaning-of-less" : "meaning-of-more";
        if (auto* before = findChild<QLabel*>(name)) {
            before->setText(words);
            before->setHidden(words.isEmpty());
            continue;
        }
        if (words.isEmpty()) continue;
        auto* label = new QLabel(words);
        label->setObjectName(name);
        label->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
        label->setWordWrap(true);
        QFont letters = label->font();
        letters.setPixelSize(kMeaning);
        label->setFont(letters);
        grid->addWidget(label, 2, column, 1, kColumns / 2);
    }
}

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
        emit stepped(direction * stepsAfter(repeats_++));
        if (button.isDown()) return; // the button is still pressed
        repeats_ = 0;
        emit stepEnded();
    });
}

void Stepper::showName(const QString& name) {
    name_->setText(name);
    less_->setAccessibleName(tr("less: %1").arg(name));
    more_->setAccessibleName(tr("more: %1").arg(name));
}

/// The buttons do not move under a finger because the number has a digit less.
void Stepper::showFound(const QString& words) {
    found_->setText(words);
    found_->setHidden(words.isEmpty());
    found_->setMinimumWidth(words.isEmpty() ? 0 : std::max(found_->minimumWidth(), found_->sizeHint().width()));
}

QString Stepper::found() const { return found_->text(); }

void Stepper::showValue(const QString& value) { value_->setText(value); }

QString Stepper::value() const { return value_->text(); }

} // namespace edgescan::ui

#include "moc_stepper.cpp"
