// Buttons for gloves.
#include "ui/panels/cab/glove_buttons.h"

#include "ui/base/icons.h"
#include "ui/base/themes.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

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

constexpr int kWide = 72, kLeastHigh = 48, kMostHigh = 64; // px
constexpr int kSign = 22, kWordPx = 15;

void fitForGloves(QToolButton& button, const char* name) {
    button.setObjectName(name);
    button.setIconSize({kSign, kSign});
    button.setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button.setFocusPolicy(Qt::TabFocus); // a tap leaves the keyboard focus in the view
    button.setMinimumSize(kWide, kLeastHigh);
    button.setMaximumHeight(kMostHigh);
    button.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
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

} // namespace

void makeGloveButton(QToolButton& button, const char* name, const char* sign, const QString& word) {
    button.setIcon(toolIcon(sign));
    button.setText(word);
    button.setAccessibleName(word);
    fitForGloves(button, name);
}

QToolButton* gloveButton(const char* name, const char* sign, const QString& word) {
    auto* button = new QToolButton;
    makeGloveButton(*button, name, sign, word);
    return button;
}

QToolButton* gloveButton(const char* name, QAction& command, const QString& word) {
    auto* button = new QToolButton;
    button->setDefaultAction(&command);
    fitForGloves(*button, name);
    if (word.isEmpty()) return button;
    const auto rename = [button, word] { button->setText(word); };
    QObject::connect(&command, &QAction::changed, button, rename); // which gives the button its own word
    rename();
    return button;
}

void showMenuSign(QToolButton& button) {
    auto* sign = new QLabel("▾");
    sign->setObjectName("menu-sign");
    sign->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* place = new QHBoxLayout(&button);
    place->setContentsMargins(0, 2, 6, 0);
    place->addWidget(sign, 1, Qt::AlignRight | Qt::AlignTop);
}

} // namespace edgescan::ui

#include "moc_glove_buttons.cpp"
