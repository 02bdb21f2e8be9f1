// Makes, opens, folds and places the docks.
#include "ui/window/docks.h"

#include "ui/base/dock_rail.h"
#include "ui/base/scrolled.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/layers/layers_panel.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/window/viewer.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kPanelsFrom = 1100;     // px of the window's width
constexpr int kTableFrom = 1600;      // px of the window's width: in a narrower one the table of rocks is a tab at the panel of rocks
constexpr int kStackedFrom = 1000;    // px of its height: in a lower one rocks and targets share a place
constexpr int kLeastTable = 234;      // px of height: four rows
constexpr double kTableShare = 0.26;  // of the window's height
constexpr double kPanelHeight = 0.55; // of the column's height, of a panel that opens under another
constexpr double kLeastOfEdges = 0.2; // of it, above several panels
constexpr int kLeastPanel = 240, kMostPanel = 400; // px; narrower panels cut off text
constexpr int kSamePx = 2;                         // widths that differ by less count as equal
constexpr const char* kByHand = "byHand";          // of a dock: "open" or "folded" if the operator opened or folded it
constexpr const char *kEdges = "dock-edges", *kRocks = "dock-rocks", *kTargets = "dock-targets", *kTable = "dock-rock-table",
                     *kLayers = "dock-layers";

constexpr const char* kTogether = "together"; // of a dock: whether it was put at the place of the rocks last

QString byHand(const QDockWidget& dock) { return dock.property(kByHand).toString(); }

} // namespace

Docks::Docks(QMainWindow& window, DockRail& rail, Viewer& viewer)
    : QObject(&window), window_(window), rail_(rail), preferences_(viewer.preferences) {
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    add(tr("Edges"), kEdges, &viewer.panel, Side::Right, kPanelsFrom);
    add(tr("Rocks"), kRocks, scrolled(viewer.rocksPanel), Side::Right, kPanelsFrom);
    add(tr("Targets"), kTargets, scrolled(viewer.targetsPanel), Side::Right, kPanelsFrom);
    add(tr("Layers"), kLayers, scrolled(viewer.layersPanel), Side::Right, kPanelsFrom);
    add(tr("Rock Table"), kTable, &viewer.rockTable, Side::Bottom, kPanelsFrom);
    place();
    for (const char* name : {kRocks, kTargets, kLayers, kTable}) rail_.setWanted(named(name).widget, false);
    named(kEdges).wanted = true;
    connect(&viewer.rocks, &Rocks::shownChanged, this, [this](bool on) {
        want(kTable, on);
        want(kRocks, on);
    });
    connect(&viewer.rocks, &Rocks::selectionChanged, this, [this, &viewer, last = std::vector<std::size_t>()]() mutable {
        const bool other = viewer.rocks.selected() != std::exchange(last, viewer.rocks.selected()); // not the same in a new picture
        if (!other || viewer.rocks.selected().empty() || viewer.views.pinned()) return;
        QDockWidget &targets = *named(kTargets).widget, &rocks = *named(kRocks).widget;
        const bool inFront = !targets.isHidden() && !targets.visibleRegion().isEmpty();
        if (inFront && window_.tabifiedDockWidgets(&targets).contains(&rocks)) rocks.raise(); // the card of the rock, in place of no target
    });
    connect(&viewer.layers, &Layers::shownChanged, this, [this](bool on) { want(kLayers, on); });
    connect(&viewer.targets, &Targets::pinned, this, [this, &viewer] {
        const auto cell = viewer.views.pinned();
        const auto& rocks = viewer.rocks.picture();
        QDockWidget* stays = cell && rocks && rocks->labelAt(*cell) != 0 ? rocksInFront() : nullptr;
        want(kTargets, true);
        if (stays != nullptr) return stays->raise(); // the operator works on rocks: Merge and Split are there
        if (QDockWidget& dock = *named(kTargets).widget; !dock.isHidden()) dock.raise(); // its card, also over the panel of the rocks
    });
}

/// The panel or the table of rocks if it is the tab in front of the targets; null: it is not.
QDockWidget* Docks::rocksInFront() {
    const auto behind = window_.tabifiedDockWidgets(named(kTargets).widget);
    for (const char* name : {kRocks, kTable}) {
        QDockWidget* dock = named(name).widget;
        if (behind.contains(dock) && !dock->isHidden() && !dock->visibleRegion().isEmpty()) return dock;
    }
    return nullptr;
}

void Docks::add(const QString& title, const char* name, QWidget* content, Side side, int opensFrom) {
    auto* dock = new QDockWidget(title, &window_);
    dock->setObjectName(name);
    dock->setProperty(kByHand, preferences_.text("window/" + dock->objectName()));
    dock->setWidget(content);
    docks_.push_back({dock, side, opensFrom});
    // Before Qt hides it: a dock behind another tab comes to the front, and only the one in front is folded.
    connect(dock->toggleViewAction(), &QAction::toggled, this, [this, dock](bool open) {
        if (!open && !dock->isHidden()) behindTab_ = dock->visibleRegion().isEmpty() ? dock : nullptr;
    });
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool open) {
        if (locked()) return emit changed(); // the table of a cab
        const bool front = open || std::exchange(behindTab_, nullptr) == dock;
        keep(*dock, front ? "open" : "folded");
        emit changed();
        if (front && !dock->isHidden()) dock->raise();
    });
    rail_.add(dock);
    dock->hide();
}

void Docks::keep(QDockWidget& dock, const QString& byHand) {
    dock.setProperty(kByHand, byHand);
    preferences_.keep("window/" + dock.objectName(), byHand);
}

Docks::Dock& Docks::named(const char* name) {
    return *std::ranges::find_if(docks_, [name](const Dock& dock) { return dock.widget->objectName() == name; });
}

void Docks::want(const char* name, bool on) {
    Dock& dock = named(name);
    if (std::exchange(dock.wanted, on) == on) return;
    if (!on && byHand(*dock.widget) == "open") keep(*dock.widget, QString()); // opened for what is gone
    if (dock.side == Side::Right) rail_.setWanted(dock.widget, on); // the table has its tab: a rail for it would take the images' room
    emit changed();
    if (on && !dock.widget->isHidden()) dock.widget->raise();
}

Docks::Side Docks::sideOf(const Dock& dock) const {
    return dock.side == Side::Bottom && window_.width() >= kTableFrom ? Side::Bottom : Side::Right;
}

bool Docks::isOpenAt(const Dock& dock, int width, int most) const {
    if (locked()) return false;
    const QString hand = byHand(*dock.widget);
    if (!hand.isEmpty()) return hand == "open";
    const bool room = sideOf(dock) == Side::Bottom || std::max(kLeastPanel, dock.widget->minimumSizeHint().width()) <= most;
    return dock.wanted && width >= dock.opensFrom && room;
}

void Docks::fit(int most) {
    stack();
    for (Dock& dock : docks_) {
        const bool open = isOpenAt(dock, window_.width(), most);
        if (dock.widget->isHidden() != open) continue;
        dock.widget->setVisible(open);
        if (open && sideOf(dock) == Side::Right) restacked_ = restacked_ || dock.widget->objectName() != kEdges;
    }
    setTableHeight();
    if (std::exchange(restacked_, false)) shareHeight();
    showTitles();
}

bool Docks::tableIsBelow() {
    const Dock& table = named(kTable);
    return sideOf(table) == Side::Bottom && !table.widget->isHidden() && !table.widget->isFloating();
}

/// A dock that has just opened gets its height only after the layout. A height for which there is no room is not asked for without end.
void Docks::setTableHeight() {
    constexpr int kTries = 3;
    if (!tableIsBelow()) {
        arrangedTable_ = 0;
        return;
    }
    const int usual = std::max(kLeastTable, static_cast<int>(kTableShare * window_.height()));
    const int wanted = draggedTable_ > 0 ? std::min(draggedTable_, window_.height() / 2) : usual;
    if (std::exchange(arrangedTable_, wanted) != wanted) triesOfTable_ = kTries;
    QDockWidget* table = named(kTable).widget;
    if (held_ || triesOfTable_ == 0 || std::abs(table->height() - wanted) <= kSamePx) return;
    --triesOfTable_;
    window_.resizeDocks({table}, {wanted}, Qt::Vertical);
}

/// Px of height that the dock needs so that its panel does not scroll.
int Docks::neededHeight(const QDockWidget& dock) const {
    const auto* area = qobject_cast<const QScrollArea*>(dock.widget());
    if (area == nullptr) area = dock.widget()->findChild<const QScrollArea*>();
    if (area == nullptr) return dock.minimumSizeHint().height();
    const QLayout& content = *area->widget()->layout();
    const int wide = usualWidth(dock) - area->verticalScrollBar()->sizeHint().width();
    constexpr int kBorder = 8; // px, of the dock
    return kBorder + dock.titleBarWidget()->sizeHint().height() +
           (content.hasHeightForWidth() ? content.totalHeightForWidth(wide) : content.totalSizeHint().height());
}

/// Where all have room, none scrolls while another has an empty part; else the settings of edges do first, and each other has its share:
/// the card of a rock comes later. That of a target always has it.
void Docks::shareHeight() {
    QList<QDockWidget*> places;
    for (QDockWidget* dock : openAtRight()) {
        const auto together = window_.tabifiedDockWidgets(dock);
        if (std::ranges::none_of(places, [&](QDockWidget* place) { return together.contains(place); })) places << dock;
    }
    if (places.size() < 2) return;
    const int others = static_cast<int>(places.size()) - 1;
    const double ofEdges = others > 1 ? kLeastOfEdges : 1.0 - kPanelHeight;
    QDockWidget* targets = named(kTargets).widget;
    const int room = window_.statusBar()->y() - window_.centralWidget()->y(), share = static_cast<int>((1.0 - ofEdges) / others * room);
    int left = room;
    QList<int> needed;
    for (QDockWidget* place : places) {
        const bool hasTargets = place == targets || (!targets->isHidden() && window_.tabifiedDockWidgets(targets).contains(place));
        needed << std::max(neededHeight(*place), hasTargets && place != places.front() ? share : 0);
        left -= needed.back();
    }
    for (int n = 1; left < 0 && n <= others; ++n) {
        left -= std::max(0, share - needed[n]);
        needed[n] = std::max(needed[n], share);
    }
    const int given = std::clamp(-left, 0, std::max(0, needed.front() - static_cast<int>(ofEdges * room)));
    needed.front() -= given;
    for (int n = 1; n <= others; ++n) needed[n] += (left + given) / others;
    window_.resizeDocks(places, needed, Qt::Vertical);
}

/// A tab says the title already: the row below it names its button.
void Docks::showTitles() {
    for (const Dock& dock : docks_) {
        const auto others = window_.tabifiedDockWidgets(dock.widget);
        const bool tab = std::ranges::any_of(others, [](const QDockWidget* other) { return !other->isHidden(); });
        const bool below = tab && !dock.widget->isHidden();
        if (auto* title = dock.widget->titleBarWidget()->findChild<QLabel*>())
            title->setText((below ? QString() : dock.widget->windowTitle()) + (ofB_ ? QString(" · B") : QString()));
        if (auto* fold = dock.widget->titleBarWidget()->findChild<QToolButton*>()) {
            fold->setText(locked() ? "✕ " + tr("Close") : below ? tr("Hide panel") + " »" : QString("»"));
            fold->setAutoRaise(!below && !locked()); // with a frame, so that it is not read as a heading
        }
    }
}

void Docks::showOfB(bool on) {
    ofB_ = on;
    showTitles();
}

int Docks::usualWidth(const QDockWidget& dock) const {
    const int usual = static_cast<int>(std::lround(268 + 0.1656 * (window_.width() - 1280)));
    return std::max(std::clamp(usual, kLeastPanel, kMostPanel), dock.minimumSizeHint().width());
}

std::vector<QDockWidget*> Docks::openAtRight() const {
    std::vector<QDockWidget*> open;
    for (const Dock& dock : docks_) {
        if (sideOf(dock) == Side::Right && !dock.widget->isHidden() && !dock.widget->isFloating()) open.push_back(dock.widget);
    }
    return open;
}

int Docks::setWidths(int most) {
    const std::vector<QDockWidget*> open = openAtRight();
    const int rail = rail_.isHidden() ? 0 : rail_.sizeHint().width();
    if (open.empty()) return rail;
    int usual = 0;
    for (const QDockWidget* dock : open) usual = std::max(usual, usualWidth(*dock));
    const int now = widthNow();
    const int around = rail + window_.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, &window_);
    if (held_) {                                                // the panel follows the pointer; it gets no other width under it
        if (std::abs(now - heldFrom_) > kSamePx) heldFrom_ = 0; // also if it comes back there
        if (heldFrom_ == 0) dragged_ = std::min(now, most);
        return now + around;
    }
    // no operator wants a panel that cuts off text, or one that takes the cloud's room
    arranged_ = dragged_ >= kLeastPanel && dragged_ <= most ? dragged_ : usual;
    if (std::abs(now - arranged_) > kSamePx) {
        for (QDockWidget* dock : open) window_.resizeDocks({dock}, {arranged_}, Qt::Horizontal); // its width changes later
    }
    return arranged_ + around;
}

int Docks::widthNow() const {
    int now = 0;
    for (const QDockWidget* dock : openAtRight()) now = std::max(now, dock->width());
    return now;
}

void Docks::setHeld(bool on) {
    if (on) heldFrom_ = widthNow();
    if (std::exchange(held_, on) == on || on || !tableIsBelow()) return;
    const int high = named(kTable).widget->height();
    if (std::abs(high - arrangedTable_) > kSamePx) draggedTable_ = high;
}

void Docks::place() {
    for (const Dock& dock : docks_) {
        dock.widget->setProperty(kTogether, {});
        dock.widget->setFloating(false);
        window_.addDockWidget(dock.side == Side::Right ? Qt::RightDockWidgetArea : Qt::BottomDockWidgetArea, dock.widget);
    }
    stack();
}

/// On a low window one whole card is easier to read than a third of each; in a narrow one the table would take the images' room.
void Docks::stack() {
    stackOnRocks(*named(kTargets).widget, window_.height() < kStackedFrom, Qt::RightDockWidgetArea);
    stackOnRocks(*named(kLayers).widget, window_.height() < kStackedFrom, Qt::RightDockWidgetArea);
    stackOnRocks(*named(kTable).widget, sideOf(named(kTable)) == Side::Right, Qt::BottomDockWidgetArea);
}

void Docks::stackOnRocks(QDockWidget& dock, bool together, Qt::DockWidgetArea otherwise) {
    QDockWidget& rocks = *named(kRocks).widget;
    if (rocks.isFloating() || dock.isFloating()) return;
    const bool seen = !rocks.isHidden() && !dock.isHidden(); // Qt lists docks at one place only while both are open
    if (seen ? window_.tabifiedDockWidgets(&rocks).contains(&dock) == together : dock.property(kTogether) == QVariant(together)) return;
    dock.setProperty(kTogether, together);
    const bool open = !dock.isHidden();
    restacked_ = true;
    if (together)
        window_.tabifyDockWidget(&rocks, &dock);
    else
        window_.addDockWidget(otherwise, &dock);
    dock.setVisible(open);
    if (!rocks.isHidden()) rocks.raise();
}

void Docks::reset() {
    for (const Dock& dock : docks_) keep(*dock.widget, QString());
    dragged_ = draggedTable_ = 0;
    place();
    restacked_ = true;
    emit changed();
}

void Docks::wantOpen() {
    for (Dock& dock : docks_) {
        if (dock.widget->isHidden() || std::exchange(dock.wanted, true)) continue;
        rail_.setWanted(dock.widget, true);
    }
}

void Docks::setLocked(DockLock by, bool on) {
    QDockWidget* table = named(kTable).widget;
    const bool changes = on != locks_.contains(by);
    if (changes && by == DockLock::Cab) { // see cover()
        on ? window_.removeDockWidget(table) : window_.addDockWidget(Qt::BottomDockWidgetArea, table);
        table->setProperty(kTogether, {});
    }
    if (on)
        locks_.insert(by);
    else
        locks_.erase(by);
    rail_.setLocked(locked());
    for (const Dock& dock : docks_) {
        const bool ofCab = dock.widget == table && !locks_.contains(DockLock::Start);
        dock.widget->toggleViewAction()->setEnabled(!locked() || ofCab);
        if (locked()) dock.widget->hide();
    }
    showTitles();
    if (!locked()) emit changed();
}

void Docks::lend(QStackedWidget& stack, bool on) {
    for (const char* name : {kEdges, kRocks, kTargets}) {
        QDockWidget& dock = *named(name).widget;
        QWidget* panel = on ? dock.widget() : stack.widget(0);
        on ? static_cast<void>(stack.addWidget(panel)) : dock.setWidget(panel);
        panel->setWindowTitle(dock.windowTitle());
        if (on) continue;
        panel->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
        panel->show(); // the stack hid it
    }
}

/// A dock would take the room of the cab's views and panel. The table covers the views until it is closed.
void Docks::cover(const QRect& views) {
    QDockWidget* table = named(kTable).widget;
    if (!locked() || table->isHidden()) return;
    table->setGeometry(views);
    table->setAutoFillBackground(true); // as a child of the window it has none
    table->raise();
}

} // namespace edgescan::ui

#include "moc_docks.cpp"
