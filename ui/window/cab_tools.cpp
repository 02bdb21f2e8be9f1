// The tools, menus and numbers of cab mode.
#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/rock_columns.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/cab/numbers_side.h"
#include "ui/panels/dialogs/sheets.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/targets/target_words.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QCursor>
#include <QMenu>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kNearHigh = 48;            // px
constexpr std::size_t kMostRemovals = 4; // newest measurements in the menu
constexpr std::size_t kMostPins = 4;     // newest targets in it

using Look = FactRow::Look;

void addText(SideFacts& side, Look look, const char* key, const QString& text, bool underlined = false) {
    if (!text.isEmpty()) side.rows.push_back({look, {.key = key, .value = text, .underlined = underlined}});
}

/// Without a pose the coordinates count from the scanner: a tap on the warning, else on the coordinates, opens the pose.
void addPlace(SideFacts& side, const QStringList& numbers, bool mine) {
    if (!mine) addText(side, Look::Warning, "pose", CabMode::tr("▲ no pose: no E N RL"), true);
    int n = 0;
    for (const char* name : mine ? std::array{"E [m]", "N", "RL"} : std::array{"X [m]", "Y", "Z"}) {
        constexpr std::array kKeys{"x", "y", "z"};
        side.rows.push_back({Look::Short, {.key = kKeys[n], .name = name, .value = numbers[n], .underlined = mine}});
        ++n;
    }
}

void addSize(SideFacts& side, const rocks::Rock& rock) {
    Fact size = sizeFact(rock);
    size.name = CabMode::tr("Rock %1, visible").arg(rock.label);
    side.rows.push_back({Look::Number, size});
}

void addCaveat(SideFacts& side, const rocks::Rock& rock) {
    addText(side, Look::Words, "remarks", (rock.apart.empty() ? QString() : partsText(rock) + " · ") + rockCaveat());
}

/// A tap opens the menu next to the button.
void opens(QToolButton& button, const std::function<QMenu&()>& menu) {
    showMenuSign(button);
    QObject::connect(&button, &QToolButton::clicked, &button,
                     [&button, menu] { menu().popup(button.mapToGlobal(QPoint(button.width() + 8, 0))); });
}

/// A menu of its own.
void opensOwn(QToolButton& button, const std::function<void(QMenu&)>& fill) {
    opens(button, [fill, menu = new QMenu(&button)]() -> QMenu& {
        fill(*menu);
        return *menu;
    });
}

/// Does what the command of the desk does, and is on and enabled with it.
void followCommand(QToolButton& button, QAction& action) {
    button.setCheckable(action.isCheckable());
    const auto update = [&button, &action] {
        button.setChecked(action.isChecked());
        button.setEnabled(action.isEnabled());
        button.setAccessibleName(action.property(kPlainName).isValid() ? action.text().remove('&') : button.text()); // it names the step
    };
    QObject::connect(&action, &QAction::changed, &button, update);
    QObject::connect(&button, &QToolButton::clicked, &action, [&action, update] {
        action.trigger();
        update();
    });
    update();
}

} // namespace

void CabMode::addTools() {
    ToolColumn& column = frame_->tools();
    Viewer& v = window_.viewer();
    const QList<KeyedCommand> commands = keyedCommands(window_.actions());
    QToolButton* pin = column.add("cab-pin", "pin", tr("Pin"));
    followCommand(*pin, actionOf(commands, "Measure/Pin"));
    connect(pin, &QToolButton::clicked, &v.explanation, &Explanation::closeCard);
    QToolButton* measure = column.add("cab-measure", "measure", tr("Measure"));
    measure->setCheckable(true);
    const auto followKind = [measure, &v] { measure->setChecked(v.measures.kind().has_value()); }; // a press alone does not switch it
    connect(measure, &QToolButton::clicked, measure, followKind);
    connect(&v.measures, &Measures::kindChanged, measure, followKind);
    opensOwn(*measure, [this](QMenu& menu) { fillMeasures(menu); });
    QToolButton* rocks = column.add("cab-rocks", "rocks", tr("Rocks"));
    rocks->setCheckable(true);
    connect(rocks, &QToolButton::clicked, &v.rocks, &Rocks::setShown);
    QToolButton* rock = column.add("cab-rock", "rock", tr("Rock…"));
    rock->setAccessibleName(tr("What can be done with rocks"));
    opens(*rock, [this]() -> QMenu& { return menuWith("Rocks/Largest Rock by Width b"); });
    const auto followRocks = [this, rocks, rock](bool on) {
        rocks->setChecked(on);
        rock->setEnabled(on);
        if (on_ && on) window_.viewer().measures.stop(); // a tap would set a point
    };
    connect(&v.rocks, &Rocks::shownChanged, rocks, followRocks);
    followRocks(v.rocks.shown());
    opens(*column.add("cab-compare", "ab", tr("A/B")), [this]() -> QMenu& { return menuWith("Edges/Compare A/B/Keep This as A"); });
    QToolButton* why = column.add("cab-why", "why", tr("Why"));
    why->setCheckable(true);
    const auto followWhy = [why, &v] { why->setChecked(v.views.tool() == Tool::Why); }; // it waits for a tap
    connect(why, &QToolButton::clicked, this, [&v, followWhy] {
        v.views.tool() == Tool::Why ? v.views.setTool(Tool::Pin) : v.explanation.explainMarked();
        followWhy();
    });
    connect(&v.views, &LinkedViews::toolChanged, why, followWhy);
    QToolButton* scanner = column.add("cab-scanner", "view-from-scanner", tr("Scanner"));
    connect(scanner, &QToolButton::clicked, this, [this] {
        showLarge(Large::Cloud);
        window_.viewer().views.cloud().viewFromScanner();
    });
    QToolButton* fit = column.add("cab-fit", "fit", tr("Fit"));
    connect(fit, &QToolButton::clicked, this, &CabMode::fit);
    QToolButton* images = column.add("cab-images", "images", tr("Views"));
    opensOwn(*images, [this](QMenu& menu) { fillViews(menu); });
    remove_ = column.add("cab-remove", "remove", tr("Remove"));
    opensOwn(*remove_, [this](QMenu& menu) { fillRemoval(menu, false); });
    showMenuSign(*frame_->head().menu());
    addUndo();
    addSideButtons();
    ofScan_.insert(ofScan_.end(), {measure, rocks, why, scanner, fit, images});
}

/// Of a measurement that is being made Undo takes back the last point.
void CabMode::addUndo() {
    const QList<KeyedCommand> commands = keyedCommands(window_.actions());
    QToolButton* redo = gloveButton("cab-redo", "redo", tr("Redo"));
    followCommand(*redo, actionOf(commands, "Edit/Redo"));
    QToolButton* undo = gloveButton("cab-undo", "undo", tr("Undo"));
    QAction& last = actionOf(commands, "Edit/Undo");
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
    frame_->tools().setFoot({undo, redo});
}

void CabMode::addSideButtons() {
    const QList<KeyedCommand> commands = keyedCommands(window_.actions());
    NumbersSide& side = frame_->side();
    QToolButton* tune = gloveButton("cab-tune", "tune", tr("Tune"));
    tune->setCheckable(true);
    // In the head of the settings, and where a low screen has room next to the number that is changed most.
    QToolButton* usual = gloveButton("cab-default", "usual", tr("Default"));
    QToolButton* near = gloveButton("cab-default-near", "usual", tr("Default"));
    near->setToolButtonStyle(Qt::ToolButtonTextOnly);
    near->setMinimumHeight(kNearHigh);
    side.mainStepper()->setAside(near);
    QToolButton* classes = gloveButton("cab-classes", "layers", QObject::tr("Classes"));
    QToolButton* report = gloveButton("cab-report", "report", tr("Report"));
    for (const auto& [button, command] : {std::pair(usual, "Edges/Restore the Default Settings"),
                                          {near, "Edges/Restore the Default Settings"},
                                          {classes, "View/Edges by Class"},
                                          {report, "File/Report"}})
        followCommand(*button, actionOf(commands, command));
    for (QToolButton* each : {usual, classes}) side.addSettingsButton(each);
    QToolButton* out = gloveButton("cab-export", "export", tr("Export"));
    opens(*out, [this]() -> QMenu& { return *window_.findChild<QToolButton*>("tool-export")->menu(); });
    side.addTune(tune);
    for (QToolButton* each : {report, out}) side.addButton(each);
    for (QWidget* each : std::initializer_list<QWidget*>{tune, usual, classes, out, side.mainStepper()}) ofScan_.push_back(each);
}

void CabMode::showSettings() {
    if (!on_) return;
    const auto& picture = window_.viewer().engine.picture();
    const QString edges = window_.viewer().views.flipped() ? tr("in B") : EdgeLegend::tr("Edges"); // as in the legend
    frame_->side().showMain(*window_.viewer().panel.row(edges::sweptParameter(window_.viewer().engine.settings().method).key),
                            picture == nullptr ? QString() : countText(picture->detection->edges->size()) + '\n' + edges);
}

SideFacts CabMode::ofRock(const rocks::Rock& rock) const {
    SideFacts side;
    const auto others = static_cast<int>(window_.viewer().rocks.selected().size()) - 1;
    const RockPicture& picture = *window_.viewer().rocks.picture();
    const bool isTarget = std::ranges::any_of(window_.viewer().targets.notebook().targets, [&](const inspect::PinnedTarget& target) {
        return picture.labelAt(target.cell) == rock.label;
    });
    side.title = tr("Rock %1").arg(rock.label) + '\n' +
                 (others > 0 ? tr("and %1 more selected").arg(others)
                  : isTarget ? QString()
                             : tr("not a target"));
    side.rows.push_back({Look::Number, distanceFact(rock)});
    addSize(side, rock); // above the coordinates: a low screen shows it at once
    const bool placed = picture.detection->scan->placement != nullptr;
    const rocks::RockRows rows(picture.study, placed ? CoordinateFrame::Mine : CoordinateFrame::Scanner); // the middle, as in the table
    const bool pending = window_.viewer().engine.placePending();
    addPlace(side, pending ? QStringList{"…", "…", "…"} : numbersOf(rows.of(rock).centreM), placed);
    addCaveat(side, rock);
    return side;
}

SideFacts CabMode::ofMeasure(std::size_t place) const {
    const auto& measures = window_.viewer().targets.notebook().measures;
    const MeasureWords words = window_.viewer().targets.wordsOf(measures[place]);
    Fact length{"distance", words.kind, window_.viewer().targets.settled() ? words.value : QStringLiteral("…")};
    if (length.value.count("±") == 1) { // several lengths have one each
        length.tolerance = "± " + length.value.section(" ± ", 1);
        length.value = length.value.section(" ± ", 0, 0);
    }
    SideFacts side;
    side.title = exactText(inspect::measureName(measures[place])) + '\n' + tr("%1 of %2").arg(place + 1).arg(measures.size());
    side.rows.push_back({Look::Number, length});
    addText(side, Look::Warning, "warned", words.warnings.join('\n'));
    addText(side, Look::Words, "remarks", words.remarks.join('\n'));
    return side;
}

SideFacts CabMode::ofTarget(const inspect::PinnedTarget& target) const {
    const Targets& targets = window_.viewer().targets;
    const auto& all = targets.notebook().targets;
    SideFacts side;
    side.title = (target.name.empty() ? tr("Target %1").arg(target.number) : shownName(exactText(target.name), 20)) +
                 QString::fromUtf8("\u00a0▾\n") + // a tap on it opens its menu
                 tr("%1 of %2").arg(1 + (&target - all.data())).arg(all.size());
    side.locked = target.locked;
    const auto known = targets.known().targets.find(target.cell);
    if (known == targets.known().targets.end()) return side;
    const TargetSurroundings around = targets.around(target.cell);
    const Facts facts = targetFacts(known->second, around);
    side.rows.push_back({Look::Number, facts.front()});
    const Fact* mine = factOf(facts, "mine");
    const bool placed = mine != nullptr && !mine->numbers.isEmpty();
    if (mine != nullptr) addPlace(side, (placed ? mine : factOf(facts, "place"))->numbers, placed);
    const QString clicked = targets.clickOf(target);
    if (clicked.contains("▲")) addText(side, Look::Warning, "warned", clicked.mid(clicked.indexOf("▲")));
    const auto addLine = [&side](const Fact& fact) { side.rows.push_back({Look::Line, fact}); };
    if (around.rock != nullptr) {
        addSize(side, *around.rock);
        addCaveat(side, *around.rock);
    } else {
        const Fact* rock = factOf(facts, "rock");
        addLine(rock != nullptr ? *rock : Fact{"rock", tr("Rock, visible"), tr("tap Rocks to measure it")});
    }
    if (!target.note.empty()) addLine({"note", tr("Note"), shownName(exactText(target.note))});
    if (mine == nullptr) return side; // nothing was measured there
    for (const char* key : {"resolves", "surface", "edge"}) addLine(*factOf(facts, key));
    return side;
}

/// The selected rock, if it is not that of the target.
const rocks::Rock* CabMode::chosenRock() const {
    const Rocks& rocks = window_.viewer().rocks;
    const rocks::Rock* chosen = rocks.picture() && !rocks.selected().empty() ? rocks.picture()->rockAt(rocks.selected().back()) : nullptr;
    const inspect::PinnedTarget* target = window_.viewer().targets.active();
    return chosen != nullptr && target != nullptr && rocks.picture()->labelAt(target->cell) == chosen->label ? nullptr : chosen;
}

/// Goes over the targets and then over the measurements, cyclically.
void CabMode::step(int by) {
    Targets& targets = window_.viewer().targets;
    const inspect::Notebook& notebook = targets.notebook();
    const inspect::PinnedTarget* const target = targets.active();
    const auto chosen = targets.chosenMeasure();
    const auto pins = static_cast<int>(notebook.targets.size()), all = pins + static_cast<int>(notebook.measures.size());
    if (all == 0) return;
    const int now = chosen              ? pins + static_cast<int>(*chosen)
                    : target != nullptr ? static_cast<int>(target - notebook.targets.data())
                    : by > 0            ? -1
                                        : 0;
    const int next = ((now + by) % all + all) % all;
    if (next >= pins) return targets.chooseMeasure(static_cast<std::size_t>(next - pins));
    window_.viewer().views.pin(notebook.targets[static_cast<std::size_t>(next)].cell);
    window_.viewer().rocks.selectPinned(); // if it was chosen already
}

/// What is shown while nothing is chosen.
SideFacts CabMode::ofNothing() const {
    const Targets& targets = window_.viewer().targets;
    const bool pins = !targets.notebook().targets.empty();
    const QString note = window_.viewer().targetsPanel.note();
    const QString tap = window_.viewer().views.choosesOnly()
                            ? tr("Tap a rock in the cloud: its distance and its size are shown here. To set a target, tap Pin first.")
                            : tr("Tap a rock in the cloud: its distance and its size are shown here. A drag turns the cloud, two "
                                 "fingers move it.");
    SideFacts side;
    side.title = pins ? targetCount(targets.notebook().targets.size()) : tr("No target");
    const QString hint = window_.viewer().measures.kind() ? tr("Tap the ends of the measurement: its length is shown here.")
                         : pins                           ? tr("Tap a target, or an arrow above: its distance and its size are shown here.")
                         : !targets.notebook().empty()    ? tr("The arrows above show the measurements.") + "\n\n" + tap
                                                          : (note.isEmpty() ? QString() : note + "\n\n") + tap;
    addText(side, Look::Words, "hint", hint);
    return side;
}

void CabMode::showNumbers() {
    if (!on_) return;
    const Targets& targets = window_.viewer().targets;
    const inspect::PinnedTarget* const target = targets.active();
    const rocks::Rock* const rock = chosenRock();
    const auto measure = targets.chosenMeasure();
    const bool some = measure || rock != nullptr || target != nullptr;
    SideFacts side = measure ? ofMeasure(*measure) : rock != nullptr ? ofRock(*rock) : target != nullptr ? ofTarget(*target) : ofNothing();
    const std::size_t entries = targets.notebook().targets.size() + targets.notebook().measures.size();
    side.arrows = entries > (some && (measure || rock == nullptr) ? 1U : 0U);
    if (window_.viewer().views.flipped() && some) side.title = "B: " + side.title; // while A is in the views
    frame_->side().show(side);
    remove_->setEnabled(entries > 0);
}

QMenu& CabMode::menuWith(const QString& id) const { return *qobject_cast<QMenu*>(actionOf(keyedCommands(window_.actions()), id).parent()); }

/// A menu, not one tap: a glove must not remove what it did not mean. What is chosen is alone in it, until the operator asks for others.
void CabMode::fillRemoval(QMenu& menu, bool all) {
    menu.clear();
    Targets& targets = window_.viewer().targets;
    const auto& pins = targets.notebook().targets;
    const std::vector<QString> measures = targets.measuresInWords();
    const auto addTarget = [&](const inspect::PinnedTarget& target) {
        const QString words = tr("Target %1").arg(targets.inWords(target));
        QAction* removal = menu.addAction((target.locked ? tr("Locked: %1") : tr("Remove: %1")).arg(words).replace('&', "&&"), &targets,
                                          [&targets, number = target.number] { targets.remove(number); });
        removal->setEnabled(!target.locked);
    };
    const auto addMeasure = [&](std::size_t n) {
        menu.addAction(tr("Remove: %1").arg(measures[n].simplified()), &targets, [&targets, n] { targets.removeMeasure(n); });
    };
    const inspect::PinnedTarget* target = targets.active();
    const auto measure = targets.chosenMeasure();
    if (!all && (measure || target != nullptr)) {
        measure ? addMeasure(*measure) : addTarget(*target);
        if (pins.size() + measures.size() == 1) return;
        const auto showOthers = [this, &menu] {
            fillRemoval(menu, true);
            menu.popup(menu.pos());
        };
        menu.addAction(tr("Others…"), this, [this, showOthers] { QMetaObject::invokeMethod(this, showOthers, Qt::QueuedConnection); });
        return;
    }
    std::for_each(pins.rbegin(), pins.rbegin() + static_cast<std::ptrdiff_t>(std::min(pins.size(), kMostPins)), addTarget);
    for (std::size_t n = measures.size(); n-- > measures.size() - std::min(measures.size(), kMostRemovals);) addMeasure(n);
}

void CabMode::fillMeasures(QMenu& menu) {
    menu.clear();
    Measures& measures = window_.viewer().measures;
    for (const inspect::MeasureTraits& each : inspect::measureTraits()) {
        if (!each.inViews) continue;
        const QString name = QObject::tr(each.label);
        if (measures.kind() == each.kind) // at its place: the other rows do not move
            menu.addAction(tr("End measuring") + ": " + name, &measures, &Measures::stop);
        else
            menu.addAction(name, &measures, [&measures, kind = each.kind] { measures.start(kind); });
    }
    menu.addSeparator();
    for (const char* section : {"Measure/Section through the Measurement", "Measure/Section through the Rock"})
        menu.addAction(&actionOf(keyedCommands(window_.actions()), section));
}

/// Of the target in the title: the entries that a click on it has in the views.
void CabMode::openTitleMenu() {
    const inspect::PinnedTarget* const target = window_.viewer().targets.active();
    if (target == nullptr || chosenRock() != nullptr || window_.viewer().targets.chosenMeasure()) return;
    auto* menu = new QMenu(&window_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    window_.viewer().targets.addEntriesOf(*menu, target->number);
    menu->popup(QCursor::pos());
}

} // namespace edgescan::ui
