// The tool bar.
#include "ui/window/tool_bar.h"

#include "ui/base/elided_label.h"
#include "ui/base/icons.h"
#include "ui/base/themes.h"

#include <QAction>
#include <QCursor>
#include <QMenu>
#include <QPainter>
#include <QStringList>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kSign = 22, kLeastHigh = 34; // px
constexpr double kArrow = 4.0;             // px
constexpr int kLeastWords = 12;            // px: without a prompt no button gives way
constexpr int kForAsked = 300;             // px: the prompt has its place also while there is none
constexpr int kForShortAsked = 200;        // px: next to the first names only
constexpr int kLinesAsked = 2;             // as high as the buttons

/// A button that opens a menu has an arrow in its corner.
class MenuButton : public QToolButton {
    void paintEvent(QPaintEvent* event) override {
        QToolButton::paintEvent(event);
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(isEnabled() ? palette().color(QPalette::ButtonText) : themeInUse().unusable);
        const QPointF tip(width() - kArrow - 2.0, height() - 4.0);
        painter.drawPolygon(QPolygonF(QVector<QPointF>{tip, tip + QPointF(-kArrow, -kArrow), tip + QPointF(kArrow, -kArrow)}));
    }
};

} // namespace

ToolBar::ToolBar(QWidget* parent) : QToolBar(parent), words_(new ElidedLabel(nullptr, kLinesAsked)), wordsPlace_(nullptr) {
    setObjectName("tools");
    setWindowTitle(tr("Tools"));
    setMovable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setIconSize({kSign, kSign});
    // A button that is on has its own background and border, so that colour is not the only sign.
    followColours(*this, [this](const Theme& theme) {
        setStyleSheet(QString("QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 3px 5px; }"
                              "QToolButton:hover { background: %1; border-color: %2; }"
                              "QToolButton:checked { background: %3; color: white; border-color: %4; }"
                              "QToolButton:focus { border: 2px solid %4; padding: 2px 4px; }"
                              "QToolButton:disabled { color: %5; background: transparent; border-color: transparent; }"
                              "QToolButton::menu-indicator { image: none; }")
                          .arg(theme.button.name(), theme.edge.name(), theme.chosen.name(), theme.accent.name(), theme.unusable.name()));
    });
    words_->setObjectName("tool-words");
    words_->setContentsMargins(12, 0, 0, 0);
    // The last widget of the bar: with little space its end is cut off, and without space it is hidden before a button is.
    words_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    words_->setMinimumWidth(kLeastWords);
    wordsPlace_ = addWidget(words_);
}

void ToolBar::add(QAction& action, const char* sign, const QString& word, Word shown) {
    action.setIcon(toolIcon(sign));
    action.setIconVisibleInMenu(false);
    action.setIconText(word); // text of the button; the menu keeps its own text
    const auto updateTip = [&action] {
        const QString key = action.shortcut().toString(QKeySequence::NativeText);
        const QString text = action.text().remove('&').remove(QStringLiteral("…"));
        action.setToolTip(key.isEmpty() ? text : text + " (" + key + ")");
    };
    connect(&action, &QAction::changed, &action, updateTip); // the shortcut and the undo step may change
    updateTip();
    insertAction(wordsPlace_, &action);
    if (auto* button = qobject_cast<QToolButton*>(widgetForAction(&action))) addButton(*button, shown);
}

void ToolBar::add(QMenu* menu, const char* name, const char* sign, const QString& word, const QList<QAction*>& lights) {
    auto* button = new MenuButton;
    menu->setParent(button, menu->windowFlags());
    button->setObjectName(name);
    button->setIcon(toolIcon(sign));
    button->setText(word);
    button->setToolTip(word);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setCheckable(true);
    const auto follow = [button, lights] { button->setChecked(std::ranges::any_of(lights, &QAction::isChecked)); };
    for (QAction* each : lights) connect(each, &QAction::toggled, button, follow);
    connect(button, &QToolButton::toggled, button, follow); // a press alone does not switch it on
    connect(menu, &QMenu::aboutToHide, button, [button] {   // the menu had the mouse: Qt does not see that it left the button
        button->setAttribute(Qt::WA_UnderMouse, button->rect().contains(button->mapFromGlobal(QCursor::pos())));
        button->update();
    });
    follow();
    insertWidget(wordsPlace_, button);
    addButton(*button, Word::Next);
}

void ToolBar::addButton(QToolButton& button, Word shown) {
    button.setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard focus in the view
    button.setMinimumHeight(kLeastHigh);
    button.setAccessibleName(button.text());
    buttons_.push_back({&button, shown});
    fit();
}

void ToolBar::addGap() { insertSeparator(wordsPlace_); }

/// Shows as many names as the width allows; what the prompt says at the moment does not count.
void ToolBar::fit() {
    constexpr int kAround = 16; // px: frame and handle
    const int gap = style()->pixelMetric(QStyle::PM_ToolBarSeparatorExtent, nullptr, this) + 2;
    const auto widthWith = [](QToolButton& button, Qt::ToolButtonStyle look) {
        button.setToolButtonStyle(look);
        return button.sizeHint().width();
    };
    int taken = kAround + gap * static_cast<int>(std::ranges::count_if(actions(), &QAction::isSeparator));
    for (const Button& each : buttons_) taken += widthWith(*each.button, Qt::ToolButtonIconOnly) + 2;
    setMinimumWidth(std::min(taken, most_)); // the badge next to it gives way before a button does
    for (const Word next : {Word::First, Word::Next, Word::Last}) {
        for (const Button& each : buttons_) {
            if (each.shown != next) continue;
            const int icon = each.button->sizeHint().width();
            taken += widthWith(*each.button, Qt::ToolButtonTextBesideIcon) - icon;
            if (taken + (next == Word::First ? kForShortAsked : kForAsked) <= width()) continue;
            each.button->setToolButtonStyle(Qt::ToolButtonIconOnly);
            return;
        }
    }
}

QSize ToolBar::sizeHint() const {
    const QSize own = QToolBar::sizeHint();
    const int rest = parentWidget() == nullptr ? 0 : parentWidget()->width() - reserved_;
    return {std::max(rest, own.width() - words_->sizeHint().width()), own.height()};
}

void ToolBar::reserve(int pixels) {
    if (std::exchange(reserved_, pixels) == pixels) return;
    updateGeometry();
}

void ToolBar::setMost(int pixels) {
    if (std::exchange(most_, pixels) != pixels) fit();
}

void ToolBar::setScanOpen(bool on) {
    for (QAction* each : ofScan_) each->setEnabled(on);
    for (const Button& each : buttons_) {
        if (each.button->menu() != nullptr) each.button->setEnabled(on);
    }
}

void ToolBar::resizeEvent(QResizeEvent* event) {
    fit();
    QToolBar::resizeEvent(event);
}

void ToolBar::showAsked(const QString& words) {
    asked_ = words;
    showWords();
}

void ToolBar::showRockTool(const QString& words) {
    rockTool_ = words;
    showWords();
}

void ToolBar::showSelected(const QString& words) {
    selected_ = words;
    showWords();
}

void ToolBar::showWords() {
    words_->setText(shown());
    words_->setToolTip(shown());
    emit wordsChanged(shown());
}

QString ToolBar::shown() const {
    QStringList all{asked_, rockTool_, selected_};
    all.removeAll(QString());
    return all.join(" · ");
}

} // namespace edgescan::ui

#include "moc_tool_bar.cpp"
