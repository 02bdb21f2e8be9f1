// The tools of cab mode, and which panel it shows.
#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "ui/base/scrolled.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/parameter_row.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"
#include "ui/window/tool_bar.h"

#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>

#include <functional>
#include <utility>

namespace edgescan::ui {
namespace {

/// A tap opens the menu next to the button.
void opens(QToolButton& button, const std::function<QMenu&()>& menu) {
    showMenuSign(button);
    QObject::connect(&button, &QToolButton::clicked, &button,
                     [&button, menu] { menu().popup(button.mapToGlobal(QPoint(button.width() + 8, 0))); });
}

/// Looks as this button of the tool bar, and opens its menu.
QToolButton* menuButton(const char* name, const ToolBar& tools, const char* ofBar) {
    const auto& bar = *tools.findChild<QToolButton*>(ofBar);
    auto* button = new QToolButton;
    makeGloveButton(*button, name, "", bar.text());
    button->setIcon(bar.icon());
    button->setCheckable(true);
    const auto follow = [button, &bar] { button->setChecked(bar.isChecked()); }; // a press alone does not switch it
    QObject::connect(button, &QToolButton::clicked, button, follow);
    QObject::connect(&bar, &QToolButton::toggled, button, follow);
    opens(*button, [&bar]() -> QMenu& { return *bar.menu(); });
    return button;
}

} // namespace

void CabMode::addTools() {
    Viewer& v = window_.viewer();
    const QList<KeyedCommand> commands = keyedCommands(window_.actions());
    const auto add = [this](QToolButton* button) {
        frame_->addTool(button);
        return button;
    };
    const auto ofDesk = [&commands](const char* name, const char* id, const QString& word = {}) {
        return gloveButton(name, actionOf(commands, id), word);
    };
    connect(add(ofDesk("cab-pin", "Measure/Pin")), &QToolButton::clicked, &v.explanation, &Explanation::closeCard);
    ofScan_.push_back(add(menuButton("cab-measure", v.tools, "tool-measure")));
    add(ofDesk("cab-rocks", "Rocks/Show Rocks"));
    QToolButton* rock = add(gloveButton("cab-rock", "rock", tr("Rock…")));
    rock->setAccessibleName(tr("What can be done with rocks"));
    opens(*rock, [this]() -> QMenu& { return menuWith("Rocks/Largest Rock by Width b"); });
    connect(&v.rocks, &Rocks::shownChanged, this, [this](bool on) {
        if (on_ && on) window_.viewer().measures.stop(); // a tap would set a point
    });
    add(menuButton("cab-compare", v.tools, "tool-compare"));
    add(ofDesk("cab-why", "Edges/Why Is This Cell an Edge or Not?"));
    add(ofDesk("cab-scanner", "View/Look from/From Scanner", tr("Scanner")));
    connect(&menuWith(kDirection), &QMenu::triggered, this, &CabMode::showCloud);
    add(ofDesk("cab-fit", "View/Fit All Views"));
    QToolButton* images = add(gloveButton("cab-images", "images", tr("Views")));
    opens(*images, [this, menu = new QMenu(images)]() -> QMenu& {
        fillViews(*menu);
        return *menu;
    });
    tune_->setCheckable(true);
    connect(add(tune_), &QToolButton::clicked, this, &CabMode::showPanel);
    add(ofDesk("cab-redo", "Edit/Redo"));
    addUndo();
    showMenuSign(*frame_->head().menu());
    frame_->addBelowPanel(ofDesk("cab-report", "File/Report"));
    QToolButton* out = menuButton("cab-export", v.tools, "tool-export");
    frame_->addBelowPanel(out);
    ofScan_.insert(ofScan_.end(), {rock, images, tune_, out});
}

/// Of a measurement that is being made Undo takes back the last point.
void CabMode::addUndo() {
    QToolButton* undo = gloveButton("cab-undo", "undo", tr("Undo"));
    QAction& last = actionOf(keyedCommands(window_.actions()), "Edit/Undo");
    Measures& measures = window_.viewer().measures;
    connect(undo, &QToolButton::clicked, this, [&last, &measures] {
        if (!measures.removeLastPick()) last.trigger();
    });
    const auto update = [undo, &last, &measures] {
        const bool picked = !measures.picked().empty();
        undo->setEnabled(picked || last.isEnabled());
        undo->setAccessibleName(picked ? tr("Take the last point back") : last.text().remove('&'));
    };
    // Of what ends first: the stack is cleared when the window goes, after the measures.
    connect(&last, &QAction::changed, &measures, update);
    connect(&measures, &Measures::asked, undo, update);
    update();
    frame_->addTool(undo);
}

/// The settings while Tune is on, else that of what was chosen last. A new choice is scrolled into sight.
void CabMode::showPanel() {
    if (!on_) return;
    Viewer& v = window_.viewer();
    const rocks::Rock* const rock = chosenRock();
    const inspect::PinnedTarget* const target = v.targets.active();
    const auto measure = v.targets.chosenMeasure();
    enum Place { OfEdges, OfRocks, OfTargets };
    const bool ofRocks = rock != nullptr || (v.rocks.shown() && v.targets.notebook().empty());
    const Place place = tune_->isChecked() ? OfEdges : !measure && ofRocks ? OfRocks : OfTargets;
    QWidget& chosen = place == OfEdges
                          ? static_cast<QWidget&>(*v.panel.row(edges::sweptParameter(v.engine.settings().method).key)->number())
                      : place == OfRocks ? v.rocksPanel.card()
                      : measure          ? static_cast<QWidget&>(*v.targetsPanel.measures())
                                         : v.targetsPanel.card();
    frame_->showPanel(place, v.views.flipped());
    const QString now = QString("%1 %2 %3 %4")
                            .arg(place)
                            .arg(rock != nullptr ? rock->cell : 0)
                            .arg(target != nullptr ? target->number : 0)
                            .arg(measure ? *measure + 1 : 0);
    if (std::exchange(shown_, now) == now) return;
    QMetaObject::invokeMethod(
        this, [&chosen] { scrollTo(chosen, true); }, Qt::QueuedConnection); // after it is laid out
}

/// The selected rock, if it is not that of the target.
const rocks::Rock* CabMode::chosenRock() const {
    const Rocks& rocks = window_.viewer().rocks;
    const rocks::Rock* chosen = rocks.picture() && !rocks.selected().empty() ? rocks.picture()->rockAt(rocks.selected().back()) : nullptr;
    const inspect::PinnedTarget* target = window_.viewer().targets.active();
    return chosen != nullptr && target != nullptr && rocks.picture()->labelAt(target->cell) == chosen->label ? nullptr : chosen;
}

QMenu& CabMode::menuWith(const char* id) const { return *qobject_cast<QMenu*>(actionOf(keyedCommands(window_.actions()), id).parent()); }

} // namespace edgescan::ui
