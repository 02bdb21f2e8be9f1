// Tools in a column.
#include "ui/panels/cab/tool_column.h"

#include "ui/base/icons.h"
#include "ui/base/themes.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace edgescan::ui {
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

} // namespace edgescan::ui

#include "moc_tool_column.cpp"
