// Actions of the tools, the corner and the numbers of cab mode.
#include "core/base/tolerance_text.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/parameters.h"
#include "core/inspect/measure/notebook.h"
#include "core/rocks/attributes/rock_columns.h"
#include "ui/base/count_text.h"
#include "ui/base/shown_text.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/numbers_side.h"
#include "ui/panels/cab/stepper.h"
#include "ui/panels/cab/tool_column.h"
#include "ui/panels/cab/zoom_buttons.h"
#include "ui/panels/targets/target_words.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QCheckBox>
#include <QMenu>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kNearHigh = 48; // px

void openNextTo(QMenu& menu, const QToolButton& button) { menu.popup(button.mapToGlobal(QPoint(button.width() + 8, 0))); }

QString metres(double m, int decimals) { return QString::number(m, 'f', decimals); }

void addSize(TargetNumbers& values, const rocks::Rock& rock) {
    values.rock = CabMode::tr("Rock %1, visible").arg(rock.label);
    values.size = CabMode::tr("%1 × %2 m").arg(metres(rock.longestCaliperM, 2), metres(rock.shortestCaliperM, 2));
    values.sizeTolerance = CabMode::tr("± %1 m").arg(metres(shownTolerance(rock.toleranceM, 2), 2));
    values.sizeRemark = (rock.apart.empty() ? QString() : partsText(rock) + " · ") + QObject::tr(rocks::kRockCaveat);
}

void addPlace(TargetNumbers& values, const Eigen::Vector3d& placeM, bool mine, bool pending) {
    int n = 0;
    for (const char* name : mine ? std::array{"E [m]", "N", "RL"} : std::array{"X [m]", "Y", "Z"})
        values.coordinates.emplace_back(name, pending ? QStringLiteral("…") : metres(placeM[n++], 3));
    values.unposed = !mine;
}

} // namespace

void CabMode::addTools() {
    ToolColumn& column = frame_->tools();
    LinkedViews& views = window_.viewer().views;
    QToolButton* pin = column.add("cab-pin", "pin", tr("Pin"));
    pin->setCheckable(true);
    connect(pin, &QToolButton::clicked, this, [this](bool on) {
        Viewer& viewer = window_.viewer();
        viewer.measures.stop();
        viewer.rocks.useTool(RockTool::None);
        viewer.views.setChoosesOnly(!on && viewer.rocks.shown()); // first: the tool says so
        viewer.views.setTool(Tool::Pin);
        viewer.explanation.closeCard();
    });
    QToolButton* measure = column.add("cab-measure", "measure", tr("Measure"));
    measure->setCheckable(true);
    auto* kinds = new QMenu(measure);
    const auto followTool = [this, pin, measure] {
        const LinkedViews& shown = window_.viewer().views;
        pin->setChecked(shown.tool() == Tool::Pin && !shown.choosesOnly() && window_.viewer().rocks.tool() == RockTool::None);
        measure->setChecked(window_.viewer().measures.kind().has_value());
    };
    connect(measure, &QToolButton::clicked, this, [this, kinds, measure, followTool] {
        followTool(); // the chosen tool determines which button is on
        fillMeasures(*kinds);
        openNextTo(*kinds, *measure);
    });
    connect(&views, &LinkedViews::toolChanged, this, followTool);
    connect(&window_.viewer().measures, &Measures::kindChanged, this, followTool);
    connect(&window_.viewer().rocks, &Rocks::toolChanged, this, followTool);
    followTool();
    QToolButton* rocks = column.add("cab-rocks", "rocks", tr("Rocks"));
    rocks->setCheckable(true);
    connect(rocks, &QToolButton::clicked, &window_.viewer().rocks, &Rocks::setShown);
    QToolButton* rock = column.add("cab-rock", "rock", tr("Rock…"));
    rock->setAccessibleName(tr("What can be done with rocks"));
    connect(rock, &QToolButton::clicked, this, [this, rock] { openNextTo(menuWith("Rocks/Largest Rock by Width b"), *rock); });
    const auto followRocks = [this, rocks, rock](bool on) {
        rocks->setChecked(on);
        rock->setEnabled(on);
        if (on_ && on) window_.viewer().measures.stop(); // a tap would set a point
    };
    connect(&window_.viewer().rocks, &Rocks::shownChanged, rocks, followRocks);
    followRocks(window_.viewer().rocks.shown());
    QToolButton* compare = column.add("cab-compare", "ab", tr("A/B"));
    connect(compare, &QToolButton::clicked, this, [this, compare] { openNextTo(menuWith("Edges/Compare A/B/Keep This as A"), *compare); });
    QToolButton* why = column.add("cab-why", "why", tr("Why"));
    why->setCheckable(true);
    const auto followWhy = [this, why] { why->setChecked(window_.viewer().views.tool() == Tool::Why); }; // it waits for a tap
    connect(why, &QToolButton::clicked, this, [this, followWhy] {
        LinkedViews& shown = window_.viewer().views;
        shown.tool() == Tool::Why ? shown.setTool(Tool::Pin) : window_.viewer().explanation.explainMarked();
        followWhy();
    });
    connect(&views, &LinkedViews::toolChanged, why, followWhy);
    QToolButton* scanner = column.add("cab-scanner", "view-from-scanner", tr("Scanner"));
    connect(scanner, &QToolButton::clicked, this, [this] {
        showLarge(Large::Cloud);
        window_.viewer().views.cloud().viewFromScanner();
    });
    QToolButton* fit = column.add("cab-fit", "fit", tr("Fit"));
    connect(fit, &QToolButton::clicked, this, &CabMode::fit);
    QToolButton* images = column.add("cab-images", "images", tr("Views"));
    auto* choices = new QMenu(images);
    connect(images, &QToolButton::clicked, this, [this, choices, images] {
        fillViews(*choices);
        openNextTo(*choices, *images);
    });
    remove_ = column.add("cab-remove", "remove", tr("Remove"));
    auto* shown = new QMenu(remove_);
    connect(remove_, &QToolButton::clicked, this, [this, shown] {
        fillRemoval(*shown, false);
        openNextTo(*shown, *remove_);
    });
    column.setFoot({undoButton(), redoButton()});
    const char* const ofScans[] = {"cab-pin", "cab-measure", "cab-rocks", "cab-why", "cab-scanner", "cab-fit", "cab-images"};
    for (const char* name : ofScans) ofScan_.push_back(column.findChild<QToolButton*>(name));
    for (QToolButton* each : {measure, rock, compare, images, remove_, frame_->head().menu()}) showMenuSign(*each);
    addSideButtons();
}

/// Of a measurement that is being made it takes back the last point.
QToolButton* CabMode::undoButton() {
    QToolButton* undo = gloveButton("cab-undo", "undo", tr("Undo"));
    QUndoStack& stack = window_.viewer().undo;
    Measures& measures = window_.viewer().measures;
    connect(undo, &QToolButton::clicked, this, [&stack, &measures] {
        if (!measures.removeLastPick()) stack.undo();
    });
    const auto follow = [undo, &stack, &measures] {
        const QString step = stack.undoText();
        undo->setEnabled(!measures.picked().empty() || stack.canUndo());
        undo->setAccessibleName(!measures.picked().empty() ? tr("Take the last point back")
                                : step.isEmpty()           ? tr("Undo")
                                                           : tr("Undo: %1").arg(step));
        undo->setToolTip(undo->accessibleName());
    };
    // Of what ends first: the stack is cleared when the window goes, after the measures.
    connect(&stack, &QUndoStack::canUndoChanged, &measures, follow);
    connect(&stack, &QUndoStack::undoTextChanged, &measures, follow);
    connect(&measures, &Measures::asked, undo, follow);
    follow();
    return undo;
}

QToolButton* CabMode::redoButton() {
    QToolButton* redo = gloveButton("cab-redo", "redo", tr("Redo"));
    QUndoStack& stack = window_.viewer().undo;
    connect(redo, &QToolButton::clicked, &stack, &QUndoStack::redo);
    const auto follow = [redo, &stack] {
        redo->setEnabled(stack.canRedo());
        redo->setAccessibleName(stack.canRedo() ? tr("Redo: %1").arg(stack.redoText()) : tr("Redo"));
        redo->setToolTip(redo->accessibleName());
    };
    connect(&stack, &QUndoStack::canRedoChanged, redo, follow);
    connect(&stack, &QUndoStack::redoTextChanged, redo, follow);
    follow();
    return redo;
}

void CabMode::addSideButtons() {
    QToolButton* tune = gloveButton("cab-tune", "tune", tr("Tune"));
    tune->setCheckable(true);
    // In the head of the settings, and where a low screen has room next to the number that is changed most.
    QToolButton* usual = gloveButton("cab-default", "usual", tr("Default"));
    QToolButton* near = gloveButton("cab-default-near", "usual", tr("Default"));
    near->setToolButtonStyle(Qt::ToolButtonTextOnly);
    near->setMinimumHeight(kNearHigh);
    for (QToolButton* each : {usual, near})
        connect(each, &QToolButton::clicked, this, [this] { window_.viewer().tuning.usePreset(edges::builtInPresets().front()); });
    frame_->side().mainStepper()->setAside(near);
    QToolButton* classes = gloveButton("cab-classes", "layers", QObject::tr("Classes"));
    classes->setCheckable(true);
    connect(classes, &QToolButton::clicked, &window_.viewer().legend, &EdgeLegend::byClassRequested);
    connect(window_.viewer().legend.byClass(), &QCheckBox::toggled, classes, &QToolButton::setChecked);
    for (QToolButton* each : {usual, classes}) frame_->side().addSettingsButton(each);
    QToolButton* report = gloveButton("cab-report", "report", tr("Report"));
    connect(report, &QToolButton::clicked, this, [this] { window_.viewer().report.ask(); });
    QToolButton* out = gloveButton("cab-export", "export", tr("Export"));
    connect(out, &QToolButton::clicked, this, [this, out] { openNextTo(*window_.findChild<QToolButton*>("tool-export")->menu(), *out); });
    showMenuSign(*out);
    frame_->side().addTune(tune);
    for (QToolButton* each : {report, out}) frame_->side().addButton(each);
    for (QWidget* each : std::initializer_list<QWidget*>{tune, usual, classes, report, out, frame_->side().mainStepper()})
        ofScan_.push_back(each);
}

void CabMode::showSettings() {
    if (!on_) return;
    const edges::Settings& settings = window_.viewer().engine.settings();
    const edges::Parameter& first = edges::sweptParameter(settings.method);
    std::vector<SteppedSetting> shown;
    const auto add = [&](const edges::Parameter& p) {
        shown.push_back({p.key, QObject::tr(p.label), window_.viewer().panel.valueText(p.key)});
    };
    add(first);
    if (const auto& picture = window_.viewer().engine.picture())
        shown.back().found = countText(picture->detection->edges->size()) + '\n' +
                             (window_.viewer().views.flipped() ? tr("in B") : EdgeLegend::tr("Edges")); // as in the legend
    for (const edges::Parameter& p : edges::parameters()) {
        if (p.usedBy(settings) && !p.several && &p != &first) add(p);
    }
    frame_->side().showSettings(shown);
}

TargetNumbers CabMode::ofRock(const rocks::Rock& rock) const {
    TargetNumbers values;
    const auto others = static_cast<int>(window_.viewer().rocks.selected().size()) - 1;
    values.title = tr("Rock %1").arg(rock.label);
    const RockPicture& picture = *window_.viewer().rocks.picture();
    const bool isTarget = std::ranges::any_of(window_.viewer().targets.notebook().targets, [&](const inspect::PinnedTarget& target) {
        return picture.labelAt(target.cell) == rock.label;
    });
    values.place = others > 0 ? tr("and %1 more selected").arg(others) : isTarget ? QString() : tr("not a target");
    values.distance = tr("%1 m").arg(rock.distanceM, 0, 'f', 2);
    values.tolerance = tr("median of its cells"); // which has no ± of its own
    const bool placed = picture.detection->scan->placement != nullptr;
    const rocks::RockRows rows(picture.study, placed ? CoordinateFrame::Mine : CoordinateFrame::Scanner); // the middle, as in the table
    addPlace(values, rows.of(rock).centreM, placed, window_.viewer().engine.placePending());
    addSize(values, rock);
    values.ofRock = true;
    return values;
}

TargetNumbers CabMode::ofMeasure(std::size_t place) const {
    const auto& measures = window_.viewer().targets.notebook().measures;
    const MeasureWords words = window_.viewer().targets.wordsOf(measures[place]);
    TargetNumbers values;
    values.title = exactText(inspect::measureName(measures[place]));
    values.place = tr("%1 of %2").arg(place + 1).arg(measures.size());
    values.distanceName = words.kind;
    const bool one = words.value.count("±") == 1; // several lengths have one each
    values.distance = !window_.viewer().targets.settled() ? QStringLiteral("…") : one ? words.value.section(" ± ", 0, 0) : words.value;
    values.tolerance = one ? "± " + words.value.section(" ± ", 1) : QString();
    values.warned = words.warnings.join('\n');
    values.sizeRemark = words.remarks.join('\n');
    return values;
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

TargetNumbers CabMode::numbers() const {
    const Targets& targets = window_.viewer().targets;
    const auto& all = targets.notebook().targets;
    const inspect::PinnedTarget* target = targets.active();
    const rocks::Rock* const rock = chosenRock();
    const auto chosen = targets.chosenMeasure();
    TargetNumbers values = chosen ? ofMeasure(*chosen) : rock != nullptr ? ofRock(*rock) : TargetNumbers{};
    values.choosesOnly = window_.viewer().views.choosesOnly();
    values.targets = static_cast<int>(all.size());
    values.measures = static_cast<int>(targets.notebook().measures.size());
    values.only = (chosen || (rock == nullptr && target != nullptr)) && values.targets + values.measures == 1;
    values.measuring = window_.viewer().measures.kind().has_value();
    values.note = window_.viewer().targetsPanel.note();
    if (chosen || rock != nullptr || target == nullptr) return values;
    values.title = (target->name.empty() ? tr("Target %1").arg(target->number) : shownName(exactText(target->name), 20)) +
                   QString::fromUtf8("\u00a0▾"); // a tap on it opens its menu
    values.opens = true;
    values.place = tr("%1 of %2").arg(1 + (target - all.data())).arg(all.size());
    values.locked = target->locked;
    const auto known = targets.known().targets.find(target->cell);
    if (known == targets.known().targets.end()) return values;
    const inspect::CellTarget& cell = known->second;
    const TargetSurroundings around = targets.around(target->cell);
    values.distance = distanceText(cell);
    values.tolerance = toleranceText(cell);
    values.rock = around.rocksShown && around.rocksKnown ? tr("Rock") : tr("Rock, visible");
    values.size = QStringLiteral("–");
    if (around.rock != nullptr) {
        addSize(values, *around.rock);
    } else {
        values.sizeRemark = !around.rocksShown  ? tr("tap Rocks to measure it")
                            : around.rocksKnown ? tr("no rock here")
                                                : tr("being computed …");
    }
    if (!target->note.empty()) values.rows.emplace_back(tr("Note"), shownName(exactText(target->note)));
    if (cell.probe.state != CellState::Valid) return values;
    addPlace(values, cell.probe.mineM.value_or(cell.probe.pointM), cell.probe.mineM.has_value(), around.placePending);
    if (const QString clicked = targets.clickOf(*target); clicked.contains("▲")) values.warned = clicked.mid(clicked.indexOf("▲"));
    for (const TargetRow& row : targetRows(cell, around)) {
        if (QStringList{QObject::tr("Surface"), QObject::tr("Resolves"), QObject::tr("Edge")}.contains(row.name))
            values.rows.emplace_back(row.name, row.value);
    }
    return values;
}

void CabMode::showNumbers() {
    if (!on_) return;
    TargetNumbers shown = numbers();
    if (window_.viewer().views.flipped() && !shown.title.isEmpty()) shown.title = "B: " + shown.title; // while A is in the views
    frame_->side().showNumbers(shown);
    remove_->setEnabled(!window_.viewer().targets.notebook().empty());
}

} // namespace edgescan::ui
