// The tool bar, and the table of its buttons.
#include "ui/window/tool_bar.h"

#include "ui/base/elided_label.h"
#include "ui/base/icons.h"
#include "ui/base/themes.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QCursor>
#include <QMenu>
#include <QPainter>
#include <QStringList>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

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

namespace {

/// A row without a command is a gap.
struct ToolRow {
    const char* command = nullptr; ///< its untranslated name: menu and text of the source
    const char* sign = nullptr;
    const char* word = nullptr;
    ToolBar::Word shown = ToolBar::Word::Next;
    bool ofScan = false; ///< disabled before a scan is open
};

constexpr bool kOfScan = true;

constexpr std::array kBefore{
    ToolRow{"File/Open", "open", QT_TRANSLATE_NOOP("QObject", "Open"), ToolBar::Word::First},
    ToolRow{"File/Connect to Scanner", "connect", QT_TRANSLATE_NOOP("QObject", "Connect"), ToolBar::Word::First},
    ToolRow{},
    ToolRow{"Edit/Undo", "undo", QT_TRANSLATE_NOOP("QObject", "Undo"), ToolBar::Word::Last},
    ToolRow{"Edit/Redo", "redo", QT_TRANSLATE_NOOP("QObject", "Redo"), ToolBar::Word::Last},
    ToolRow{},
    ToolRow{"Measure/Pin", "pin", QT_TRANSLATE_NOOP("QObject", "Pin"), ToolBar::Word::Next, kOfScan},
};
constexpr std::array kBehind{
    ToolRow{"Edges/Why Is This Cell an Edge or Not?", "why", QT_TRANSLATE_NOOP("QObject", "Why"), ToolBar::Word::Next, kOfScan},
    ToolRow{},
    ToolRow{"View/Look from/From Scanner", "view-from-scanner", QT_TRANSLATE_NOOP("QObject", "Scanner view"), ToolBar::Word::Last, kOfScan},
    ToolRow{"View/Fit All Views", "fit", QT_TRANSLATE_NOOP("QObject", "Fit"), ToolBar::Word::Last, kOfScan},
    ToolRow{},
    ToolRow{"Rocks/Show Rocks", "rocks", QT_TRANSLATE_NOOP("QObject", "Rocks"), ToolBar::Word::Next, kOfScan},
};
constexpr std::array kLast{
    ToolRow{"File/Report", "report", QT_TRANSLATE_NOOP("QObject", "Report"), ToolBar::Word::Next, kOfScan},
    ToolRow{},
    ToolRow{"View/Cab Mode", "cab-mode", QT_TRANSLATE_NOOP("QObject", "Cab")},
};

/// An entry of a button's menu; an empty text is a separator.
struct MenuRow {
    const char* name;
    const char* sign;
    const char* word;
    std::vector<const char*> commands;
    std::vector<const char*> lights; ///< commands that highlight the button while they are on
};

const std::vector<const char*> kWaysToMeasure{"Measure/Distance",    "Measure/Vertical",      "Measure/Angle",
                                              "Measure/Spans a × b", "Measure/Along Surface", "Measure/Throat Width"};
const MenuRow kMeasures{"tool-measure", "measure", QT_TRANSLATE_NOOP("QObject", "Measure"), kWaysToMeasure, kWaysToMeasure};
const MenuRow kSelections{"tool-select",
                          "select",
                          QT_TRANSLATE_NOOP("QObject", "Select"),
                          {"Measure/Box", "Measure/Lasso", "", "Measure/Zoom to Selected", "Measure/Isolate Selected",
                           "Measure/Hide Selected", "Measure/Show All", "", "Measure/Range Gate", "Measure/Export Selected"},
                          {"Measure/Box", "Measure/Lasso"}};
const MenuRow kCompares{"tool-compare",
                        "ab",
                        QT_TRANSLATE_NOOP("QObject", "A/B"),
                        {"Edges/Compare A/B/Keep This as A", "Edges/Compare A/B/Compare with Earlier Scan",
                         "Edges/Compare A/B/Exchange A and B", "Edges/Compare A/B/Demo before and after a Blast", "",
                         "Edges/Compare A/B/Show A", "Edges/Compare A/B/Show What Changed", "Edges/Compare A/B/Next Changed Region",
                         "Edges/Compare A/B/Previous Changed Region", "", "Edges/Compare A/B/Forget A"},
                        {"Edges/Compare A/B/Show A"}};

const MenuRow kExports{"tool-export",
                       "export",
                       QT_TRANSLATE_NOOP("QObject", "Export"),
                       {"File/Export/Edge Cloud", "File/Export/Edge Drawing (DXF)", "File/Export/Full Cloud", "File/Export/Selected Cells",
                        "File/Export/Targets", "Rocks/Export Rocks", "", "File/Export/Edge Image", "File/Export/Gray Image",
                        "File/Export/Range Image", "File/Screenshot", "", "File/Report"},
                       {}};

template <class Rows>
void addRows(ToolBar& bar, const QList<KeyedCommand>& commands, const Rows& rows) {
    for (const ToolRow& row : rows) {
        if (row.command == nullptr) {
            bar.addGap();
            continue;
        }
        bar.add(actionOf(commands, row.command), row.sign, QObject::tr(row.word), row.shown);
        if (row.ofScan) bar.needsScan(actionOf(commands, row.command));
    }
}

void addMenu(ToolBar& bar, const QList<KeyedCommand>& commands, const MenuRow& row) {
    auto* menu = new QMenu;
    for (const char* id : row.commands) {
        if (*id == '\0')
            menu->addSeparator();
        else
            menu->addAction(&actionOf(commands, id));
    }
    menu->setToolTipsVisible(true); // why a command is off
    QList<QAction*> lights;
    for (const char* id : row.lights) lights << &actionOf(commands, id);
    bar.add(menu, row.name, row.sign, QObject::tr(row.word), lights);
}

} // namespace

void addToolButtons(MainWindow& window) {
    const QList<KeyedCommand> commands = keyedCommands(window.actions());
    ToolBar& bar = window.viewer().tools;
    addRows(bar, commands, kBefore);
    for (const MenuRow* row : {&kMeasures, &kSelections}) addMenu(bar, commands, *row);
    addRows(bar, commands, kBehind);
    addMenu(bar, commands, kCompares);
    bar.addGap();
    addMenu(bar, commands, kExports);
    addRows(bar, commands, kLast);
    for (const KeyedCommand& command : commands) { // the menus whose commands have no meaning without a scan
        const auto isOf = [&command](const char* menu) { return command.id.startsWith(menu); };
        const bool ofTargets = command.id == "File/Export/Targets"; // off also while there are none
        if ((isOf("Rocks/") || isOf("Measure/") || isOf("File/Export/")) && !ofTargets) bar.needsScan(*command.action);
    }
    bar.setScanOpen(false);
    QObject::connect(&window, &MainWindow::pictureShown, &bar, [&bar] { bar.setScanOpen(true); });
}

} // namespace edgescan::ui

#include "moc_tool_bar.cpp"
