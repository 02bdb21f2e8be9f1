// Buttons for gloves.
#include "ui/panels/cab/glove_buttons.h"

#include "core/edges/settings/parameters.h"
#include "ui/base/icons.h"
#include "ui/base/themes.h"
#include "ui/panels/tuning/parameter_row.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
HoldButton::HoldButton(QWidget* parent) : QToolButton(parent) {
    tick_.setInterval(30);
    connect(&tick_, &QTimer::timeout, this, &HoldButton::tick);
    connect(this, &QToolButton::pressed, this, [this] {
        since_.start();
        tick_.start();
    });
    connect(this, &QToolButton::released, this, [this] {
        const bool early = tick_.isActive();
        tick_.stop();
        update();
        if (early) emit releasedEarly();
    });
}

void HoldButton::tick() {
    update();
    if (since_.elapsed() < kHoldMs) return;
    tick_.stop();
    setDown(false);
    emit held();
}

void HoldButton::paintEvent(QPaintEvent* event) {
    QToolButton::paintEvent(event);
    if (!tick_.isActive()) return;
    constexpr int kBar = 5; // px
    const double share = std::min(1.0, static_cast<double>(since_.elapsed()) / kHoldMs);
    QPainter(this).fillRect(QRectF(0, height() - kBar, share * width(), kBar), themeInUse().accent);
}

namespace {

constexpr int kWide = 72, kHigh = 64, kLeastHigh = 48, kBetween = 6, kLeastBetween = 4; // px
constexpr int kSign = 28, kLowSign = 22;
constexpr int kLow = 56; // px: a lower button has a smaller sign, so that its word is whole
constexpr int kWordPx = 15;
constexpr int kFewest = 3; // rows

} // namespace

void makeGloveButton(QToolButton& button, const char* name, const char* sign, const QString& word) {
    button.setObjectName(name);
    button.setIcon(toolIcon(sign));
    button.setIconSize({kSign, kSign});
    button.setText(word);
    button.setAccessibleName(word);
    button.setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button.setFocusPolicy(Qt::TabFocus); // a tap leaves the keyboard focus in the view
    button.setMinimumSize(kWide, kHigh);
    button.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    QFont letters = button.font();
    letters.setPixelSize(kWordPx);
    button.setFont(letters);
    // A button that is on has its own background and border, so that colour is not the only sign.
    followColours(button, [&button](const Theme& theme) {
        button.setStyleSheet(QString("QToolButton { background: %1; color: %2; border: 1px solid %3; border-radius: 6px; padding: 2px; }"
                                     "QToolButton:checked { background: %4; color: white; border: 2px solid %5; }"
                                     "QToolButton:pressed { background: %6; }"
                                     "QToolButton:focus { border: 2px solid %5; }"
                                     "QToolButton:disabled { color: %7; }"
                                     "QToolButton::menu-indicator { image: none; }")
                                 .arg(theme.button.name(), theme.text.name(), theme.edge.name(), theme.chosen.name(), theme.accent.name(),
                                      theme.base.name(), theme.unusable.name()));
    });
}

QToolButton* gloveButton(const char* name, const char* sign, const QString& word) {
    auto* button = new QToolButton;
    makeGloveButton(*button, name, sign, word);
    return button;
}

void showMenuSign(QToolButton& button, bool on) {
    auto* sign = button.findChild<QLabel*>("menu-sign");
    if (sign == nullptr) {
        sign = new QLabel("▾");
        sign->setObjectName("menu-sign");
        sign->setAttribute(Qt::WA_TransparentForMouseEvents);
        auto* place = new QHBoxLayout(&button);
        place->setContentsMargins(0, 2, 6, 0);
        place->addWidget(sign, 1, Qt::AlignRight | Qt::AlignTop);
    }
    sign->setVisible(on);
}

ToolColumn::ToolColumn(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(kBetween, kBetween, kBetween, kBetween);
    grid_->setSpacing(kBetween);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

QToolButton* ToolColumn::add(const char* name, const char* sign, const QString& word) {
    buttons_.push_back(gloveButton(name, sign, word));
    layOut();
    return buttons_.back();
}

void ToolColumn::setFoot(std::vector<QToolButton*> buttons) {
    foot_ = std::move(buttons);
    layOut();
}

/// The height of three tools: the other tools go into more columns.
QSize ToolColumn::minimumSizeHint() const { return {grid_->minimumSize().width(), kFewest * (kLeastHigh + kBetween) + kBetween}; }

void ToolColumn::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layOut();
}

/// As few columns as the height has room for, all with the same number of buttons.
void ToolColumn::layOut() {
    const int foot = static_cast<int>(foot_.size()), all = static_cast<int>(buttons_.size()) + foot;
    const int most = std::max(kFewest, (height() - kLeastBetween) / (kLeastHigh + kLeastBetween));
    const int columns = (all + most - 1) / most, rows = (all + columns - 1) / columns;
    const int between = rows * (kLeastHigh + kBetween) + kBetween <= height() ? kBetween : kLeastBetween;
    const int high = std::clamp((height() - between) / rows - between, kLeastHigh, kHigh), sign = high < kLow ? kLowSign : kSign;
    grid_->setContentsMargins(kBetween, between, kBetween, between);
    grid_->setVerticalSpacing(between);
    for (const auto* some : {&buttons_, &foot_}) {
        for (QToolButton* each : *some) {
            each->setFixedHeight(high);
            each->setIconSize({sign, sign});
        }
    }
    if (std::pair(rows, all) == laidOut_) return;
    laidOut_ = {rows, all};
    // The foot is at the bottom of the only column, or one of it at the bottom of each column.
    const auto toolsIn = [&](int column) { return columns == 1 ? rows - foot : rows - (column < foot ? 1 : 0); };
    int row = 0, column = 0;
    for (QToolButton* each : buttons_) {
        if (row == toolsIn(column)) row = 0, ++column;
        grid_->addWidget(each, row++, column, Qt::AlignTop);
    }
    for (int n = 0; n < grid_->rowCount(); ++n) grid_->setRowStretch(n, 0);
    grid_->setRowStretch(std::max(0, rows - (columns == 1 ? foot : 1) - 1), 1); // that of the last tool
    for (int n = 0; n < foot; ++n)
        grid_->addWidget(foot_[static_cast<std::size_t>(n)], columns == 1 ? rows - 1 - n : rows - 1, columns == 1 ? 0 : n);
}

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

#include "moc_glove_buttons.cpp"
