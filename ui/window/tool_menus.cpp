// Rocks and Measure in the menu bar.
#include "ui/window/tool_menus.h"

#include "ui/base/notice_bar.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/viewer.h"

#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>

namespace edgescan::ui {
namespace {

/// A second press of a tool's key ends the tool: said, for the operator may expect it to begin again.
void sayEnded(Viewer& v, const char* text) {
    const QString tool = QObject::tr(text).remove('&');
    v.notice.showHint(v.views.choosesOnly() ? QObject::tr("“%1” has ended; a click selects a rock again.").arg(tool)
                                            : QObject::tr("“%1” has ended; a click pins again.").arg(tool));
}

/// A tool. `on`: true while it is in use.
Command tool(Viewer& v, const char* text, const char* keys, std::function<void()> start, std::function<bool()> on) {
    const auto set = [&v, text, start = std::move(start)](bool wanted) {
        if (wanted) return start();
        v.views.setChoosesOnly(v.rocks.shown());
        if (v.views.tool() != Tool::Pin || v.views.choosesOnly()) sayEnded(v, text);
        v.views.setTool(Tool::Pin);
    };
    return linked(toggle(text, keys, nullptr, false, set), [&v, on = std::move(on)](QAction& action) {
        const auto follow = [&action, on] { action.setChecked(on()); };
        QObject::connect(&v.views, &LinkedViews::toolChanged, &action, follow);
        QObject::connect(&v.measures, &Measures::kindChanged, &action, follow);
        follow();
    });
}

} // namespace

Command rocksMenu(Viewer& v, QMainWindow& window) {
    Rocks& rocks = v.rocks;
    CloudView& cloud = v.views.cloud();
    const auto step = [&rocks](double by) {
        rocks::RockSettings settings = rocks.settings();
        const rocks::RockParameter& level = rocks::rockParameters().front();
        level.set(settings, std::clamp(level.get(settings) + by, level.minimum, level.maximum));
        rocks.change(settings);
    };
    const auto tool = [&v, &rocks](const char* text, const char* keys, RockTool which) {
        const auto set = [&v, &rocks, text, which](bool on) {
            rocks.useTool(on ? which : RockTool::None);
            if (!on) sayEnded(v, text);
        };
        return linked(toggle(text, keys, nullptr, false, set), [&rocks, which](QAction& action) {
            QObject::connect(&rocks, &Rocks::toolChanged, &action, [&action, which](RockTool now) { action.setChecked(now == which); });
        });
    };
    const auto setOver = [&cloud](bool on) { cloud.setEdgesOverFaces(on); };
    const Command edgesOver =
        following(toggle("&Edges over Rocks", "", "rocks/edges", false, setOver), v.legend, &EdgeLegend::overRocksRequested);
    return submenu("&Rocks",
                   {
                       ofDesk(following(ofScan(toggle("&Show Rocks", "K", "rocks/shown", false, [&rocks](bool on) { rocks.setShown(on); })),
                                        rocks, &Rocks::shownChanged)),
                       linked(command("&Largest Rock by Width b", "", [&rocks] { rocks.lookAtLargest(); }),
                              [](QAction& action) { action.setObjectName("rocks-largest"); }),
                       command("Next Sm&aller Rock by Width b", "", [&rocks] { rocks.lookAtNextSmaller(); }),
                       kLine,
                       command("&Merge Rocks", "M", [&rocks] { rocks.mergeSelected(); }),
                       tool("S&plit a Rock", "S", RockTool::Split),
                       tool("Merge al&ong a Line", "J", RockTool::Join),
                       tool("C&ut along a Line", "X", RockTool::Cut),
                       command("&Not a Rock, or a Rock Again", "N", [&rocks] { rocks.toggleChosen(); }),
                       command("Na&me This Rock…", "", [&v] { v.targets.editName(); }),
                       kLine,
                       changing(command("&Finer", ",", [step] { step(-0.5); })),
                       changing(command("&Coarser", ".", [step] { step(0.5); })),
                       edgesOver,
                       kLine,
                       tool("Draw Region of &Interest", "G", RockTool::Region),
                       command("Clear Re&gion of Interest", "", [&rocks] { rocks.clearRegion(); }),
                       kLine,
                       {.made = window.findChild<QDockWidget*>("dock-rock-table")->toggleViewAction()},
                       ofDesk(command("E&xport Rocks…", "", [&rocks] { rocks.askExport(); })), // a cab has it in Export
                   });
}

Command measureMenu(Viewer& v) {
    LinkedViews& views = v.views;
    Measures& measures = v.measures;
    Selection& selection = v.selection;
    const auto usual = [&](const char* text, const char* keys, Tool wanted) {
        const auto start = [&v, &views, wanted] {
            v.rocks.useTool(RockTool::None); // its clicks pin nothing
            if (wanted == Tool::Pin) views.setChoosesOnly(false);
            views.setTool(wanted);
        };
        return tool(v, text, keys, start, [&views, wanted] {
            return views.tool() == wanted && (wanted != Tool::Pin || (views.pinsOnClick() && !views.choosesOnly()));
        });
    };
    const auto measure = [&](const char* text, const char* keys, inspect::MeasureKind kind) {
        Command made = tool(
            v, text, keys, [&measures, kind] { measures.start(kind); }, [&measures, kind] { return measures.kind() == kind; });
        if (kind == inspect::MeasureKind::Distance)
            made.link = [follow = made.link](QAction& action) {
                follow(action);
                action.setWhatsThis(QObject::tr("slope, grade and length of a straight line"));
            };
        return made;
    };
    const auto letGo = [&v] {
        if (const auto chosen = v.targets.chosenMeasure()) return v.targets.removeMeasure(*chosen);
        if (const inspect::PinnedTarget* target = v.targets.active()) v.targets.remove(target->number);
    };
    return submenu("&Measure", {
                                   usual("&Pin", "P", Tool::Pin),
                                   measure("&Distance", "U", inspect::MeasureKind::Distance),
                                   measure("&Vertical", "V", inspect::MeasureKind::Vertical),
                                   measure("&Angle", "A", inspect::MeasureKind::Angle),
                                   measure("&Spans a × b", "Y", inspect::MeasureKind::Spans),
                                   measure("Along S&urface", "Shift+U", inspect::MeasureKind::Path),
                                   measure("Thr&oat Width", "Shift+Y", inspect::MeasureKind::Throat),
                                   command("Se&ction through the Measurement", "", [&v] { v.sections.throughMeasurement(); }),
                                   command("Section th&rough the Rock", "", [&v] { v.sections.throughRock(); }),
                                   usual("&Box", "B", Tool::Box),
                                   usual("&Lasso", "L", Tool::Lasso),
                                   kLine,
                                   command("Na&me This Target", "F2", [&v] { v.targets.editName(); }),
                                   command("Remove This Tar&get", "Del", letGo),
                                   command("Remove All &Targets", "", [&v] { v.targets.removeAll(); }),
                                   command("&Copy This Target", "", [&v] { v.targets.copyCard(); }),
                                   kLine,
                                   command("&Isolate Selected", "I", [&selection] { selection.isolateSelected(); }),
                                   command("&Hide Selected", "Shift+I", [&selection] { selection.hideSelected(); }),
                                   command("Sho&w All", "Ctrl+I", [&selection] { selection.showAll(); }),
                                   command("Clip to Bo&x round Selected", "", [&selection] { selection.clipToSelected(); }),
                                   command("&Range Gate…", "Shift+G", [&selection] { selection.askRangeGate(); }),
                                   command("Hide &Farther than This Cell", "", [&v] { v.selection.hideFartherThan(v.views.marked()); }),
                                   command("Hide Nearer than This Cell", "", [&v] { v.selection.hideNearerThan(v.views.marked()); }),
                                   command("&Zoom to Selected", "Z", [&selection] { selection.zoomTo(); }),
                                   command("Select &Nothing", "", [&selection] { selection.select({}); }),
                                   command("&Export Selected…", "", [&v] { v.exports.askSelected(); }),
                               });
}

} // namespace edgescan::ui
