// The commands of all menus.
#include "ui/window/menus.h"

#include "core/edges/settings/presets.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/files/placing.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/command_palette.h"
#include "ui/panels/dialogs/sheets.h"
#include "ui/panels/keys/commands.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/gl_check.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/view_choices.h"
#include "ui/window/viewer.h"

#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>
#include <string_view>

namespace edgescan::ui {
namespace {

Command compareMenu(Comparing& comparing) {
    const auto whileKept = onlyWhile(comparing, &Comparing::pictureAChanged);
    const auto flipped = [&comparing, whileKept](QAction& action) {
        whileKept(action);
        QObject::connect(&comparing, &Comparing::flipped, &action, &QAction::setChecked);
    };
    return submenu(
        "Compare &A/B",
        {
            command("&Keep This as A", "Shift+A", [&comparing] { comparing.keep(); }),
            command("&Compare with Earlier Scan…", "", [&comparing] { comparing.askScan(); }),
            linked(command("Exchange A and &B", "", [&comparing] { comparing.swap(); }), whileKept),
            command("&Demo before and after a Blast", "", [&comparing] { comparing.openDemoPair(); }),
            kLine,
            linked(toggle("Show &A", "", nullptr, false, [&comparing](bool on) { comparing.flip(on); }), flipped),
            linked(toggle("Show What &Changed", "Shift+D", nullptr, true, [&comparing](bool on) { comparing.setDifferenceShown(on); }),
                   [&comparing, whileKept](QAction& action) {
                       whileKept(action);
                       action.setChecked(true);
                       action.setProperty(kInSessions, "compare/changes");
                       QObject::connect(&comparing, &Comparing::differenceShownChanged, &action, &QAction::setChecked);
                   }),
            linked(toggle("&Colour by Distance from A", "", nullptr, false, [&comparing](bool on) { comparing.setByDistance(on); }),
                   [&comparing](QAction& action) {
                       action.setObjectName("compare-distance");
                       QObject::connect(&comparing, &Comparing::byDistanceChanged, &action, &QAction::setChecked);
                   }),
            linked(command("&Next Changed Region", "Shift+N", [&comparing] { comparing.nextRegion(); }), whileKept),
            linked(command("&Previous Changed Region", "Shift+B", [&comparing] { comparing.previousRegion(); }), whileKept),
            kLine,
            linked(command("&Forget A", "", [&comparing] { comparing.forget(); }), whileKept),
        });
}

/// The switch of edge confidence.
Command confidenceCommand(Confidence& confidence) {
    return linked(toggle("Edge Con&fidence", "Shift+W", nullptr, false, [&confidence](bool on) { confidence.setOn(on); }),
                  [](QAction& action) {
                      action.setObjectName("edge-confidence");
                      action.setProperty(kInSessions, "edges/confidence");
                      action.setToolTip(QObject::tr("Colours and sizes of edges by how many settings near these find them too"));
                  });
}

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
                       following(ofScan(toggle("&Show Rocks", "K", "rocks/shown", false, [&rocks](bool on) { rocks.setShown(on); })), rocks,
                                 &Rocks::shownChanged),
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

/// Disabled while there are no targets; its tip says so.
Command targetsExport(Viewer& v, Command asks) {
    return linked(std::move(asks), [&v](QAction& action) {
        const auto follow = [&v, &action] {
            const bool some = !v.targets.notebook().targets.empty();
            action.setEnabled(some);
            action.setToolTip(some ? QString() : QObject::tr("There are no targets yet: pin a cell first."));
        };
        QObject::connect(&v.targets, &Targets::cardChanged, &action, follow);
        if (auto* menu = qobject_cast<QMenu*>(action.parent())) menu->setToolTipsVisible(true);
        follow();
    });
}

Command fileMenu(Viewer& v, const WindowCommands& commands) {
    std::vector<Command> exports;
    for (const exports::ExportKind& kind : exports::exportKinds()) {
        if (kind.window.menu == nullptr) continue;
        Command asks = command(kind.window.menu, kind.window.keys, [&v, content = kind.content] { v.exports.ask(content); });
        exports.push_back(kind.content == exports::ExportContent::Targets ? targetsExport(v, std::move(asks)) : std::move(asks));
        if (kind.content == exports::ExportContent::EdgeCloud)
            exports.push_back(command("Edge &Drawing (DXF)…", "", [&v, content = kind.content] { v.exports.ask(content, ".dxf"); }));
    }
    exports.push_back(command("&Selected Cells…", "", [&v] { v.exports.askSelected(); }));
    Command recent = submenu("Open &Recent", {});
    recent.fill = [&v](QMenu& menu) { v.files.fillRecent(menu); };
    Command menu =
        submenu("&File", {
                             command("&Open…", "Ctrl+O", [&v] { v.files.ask(); }),
                             recent,
                             command("Open &Demo Draw-Bell", "", [&v] { v.files.openDemo(); }),
                             command("Demo before and after a &Blast", "", [&v] { v.comparing.openDemoPair(); }),
                             command("&Connect to Scanner…", "Ctrl+L", [&v] { v.live.panel().toggleAddress(); }),
                             command("Re&load", "F5", [&v] { v.files.reload(); }),
                             kLine,
                             submenu("&Export", exports),
                             command("Re&port…", "", [&v] { v.report.ask(); }),
                             command("&Screenshot…", "F12", [&v, shot = commands.screenshot] { v.exports.askScreenshot(shot()); }),
                             command("&Copy as Command", "", [&v] { v.exports.copyCommand(); }),
                             kLine,
                             command("&Quit", "Ctrl+Q", commands.quit),
                         });
    menu.submenu.insert(menu.submenu.begin() + 6, commands.sessions.begin(), commands.sessions.end()); // after the commands that open scans
    return menu;
}

Command editMenu(Viewer& v, QMainWindow& window) {
    Command undo{.keys = "Ctrl+Z", .made = v.undo.createUndoAction(&window, QObject::tr("&Undo"))};
    Command redo{.keys = "Ctrl+Y; Ctrl+Shift+Z", .made = v.undo.createRedoAction(&window, QObject::tr("&Redo"))};
    undo.made->setObjectName("Undo"); // their texts name the step
    redo.made->setObjectName("Redo");
    undo.made->setProperty(kPlainName, QObject::tr("&Undo"));
    redo.made->setProperty(kPlainName, QObject::tr("&Redo"));
    const auto copyProbe = [&v] { QGuiApplication::clipboard()->setText(v.statusLine.probeShown()); };
    return submenu("&Edit", {undo, redo, kLine, command("&Copy Probe Values", "Ctrl+C", copyProbe)});
}

std::vector<Command> edgeLook(Viewer& v) {
    LinkedViews& views = v.views;
    EdgeLegend& legend = v.legend;
    const auto setColourBlind = [&](bool on) {
        const EdgeColours& colours = on ? kColourBlindColours : kUsualColours;
        views.setEdgeColours(colours);
        legend.showColours(colours);
    };
    const auto setByClass = [&](bool on) {
        views.setEdgesByClass(on);
        legend.showByClass(on);
    };
    const auto setEdges = [&](bool on) {
        views.cloud().setEdgesVisible(on);
        legend.showEdges(on);
    };
    return {
        following(toggle("&Edge Points", "E", "view/edge-points", true, setEdges), legend, &EdgeLegend::edgesRequested),
        following(toggle("Edges &by Class", "C", "view/edge-classes", false, setByClass), legend, &EdgeLegend::byClassRequested),
        // A cab always shows them in its large image.
        ofDesk(toggle("Edges &over Range Image", "O", "view/overlay", false, [&views](bool on) { views.setEdgesOverImage(on); })),
        toggle("&Colour-Blind Edge Colours", "Shift+C", "view/colour-blind", false, setColourBlind),
    };
}

Command imagesMenu(LinkedViews& views) {
    const auto preset = [&images = *views.gray().viewPort()](const char* text, const char* key, bool ViewPort::Turn::*part) {
        return ofScan(toggle(text, "", key, false, [&images, part](bool on) {
            ViewPort::Turn turn = images.turn();
            turn.*part = on;
            images.setTurn(turn);
        }));
    };
    return submenu("I&mages", {toggle("True &Angle Aspect", "", "view/true-angles", false, [&views](bool on) { views.setTrueAngles(on); }),
                               kLine, preset("Turn by a &Quarter", "view/images-quarter", &ViewPort::Turn::quarter),
                               preset("Turn by a &Half", "view/images-half", &ViewPort::Turn::half),
                               preset("&Mirror", "view/images-mirrored", &ViewPort::Turn::mirrored)});
}

Command directions(CloudView& cloud) {
    return submenu("Loo&k from", {
                                     command("From &Scanner", "0", [&cloud] { cloud.viewFromScanner(); }),
                                     command("&Front", "1", [&cloud] { cloud.viewFront(); }),
                                     command("&Back", "Shift+1", [&cloud] { cloud.viewBack(); }),
                                     command("&Right", "3", [&cloud] { cloud.viewRight(); }),
                                     command("&Left", "Shift+3", [&cloud] { cloud.viewLeft(); }),
                                     command("&Top (from Above)", "7", [&cloud] { cloud.viewTop(); }),
                                     command("Botto&m (from Below)", "Shift+7", [&cloud] { cloud.viewBottom(); }),
                                     command("&Isometric", "9", [&cloud] { cloud.viewIsometric(); }),
                                 });
}

Command savedViews(SavedViews& saved) {
    Command menu = submenu("Sto&red Views", {});
    const auto add = [&](const QString& shown, const QString& name, const QString& keys, void (SavedViews::*act)(int)) {
        for (int number = 1; number <= SavedViews::kMost; ++number) {
            menu.submenu.push_back({.text = shown.arg(number),
                                    .keys = keys + QString::number(number),
                                    .run = [&saved, act, number] { (saved.*act)(number); },
                                    .source = name + QString::number(number)});
        }
    };
    add(QObject::tr("View &%1"), "Stored View ", "Alt+", &SavedViews::recall);
    menu.submenu.push_back(kLine);
    add(QObject::tr("Store as View &%1"), "Store as View ", "Ctrl+", &SavedViews::store);
    return menu;
}

/// How the cloud is drawn and turned.
Command cloudLook(Viewer& v, QMainWindow& window) {
    CloudView& cloud = v.cloud;
    return submenu("Clou&d",
                   {
                       following(toggle("&Orthographic", "5", "view/orthographic", false, [&cloud](bool on) { cloud.setParallel(on); }),
                                 cloud, &CloudView::parallelChanged),
                       toggle("T&urntable", "T", "view/turntable", true, [&cloud](bool on) { cloud.setTurntable(on); }),
                       kLine,
                       toggle("&Dim Cloud under Edges", "D", "view/dim-cloud", true, [&cloud](bool on) { cloud.setCloudDimmed(on); }),
                       toggle("Depth S&hading", "Q", "view/shading", true, [&cloud](bool on) { cloud.setShaded(on); }),
                       toggle("&Ground Grid", "Shift+K", "view/ground-grid", false, [&cloud](bool on) { cloud.setGround(on); }),
                       toggle("Vie&w Cube", "", "view/cube", true, [&cube = v.viewCube](bool on) { cube.setWanted(on); }),
                       colourMenu(window, v.look),
                       kLine,
                       command("Point Size &+", "]", [&cloud] { cloud.largerPoints(); }),
                       command("Point Size &-", "[", [&cloud] { cloud.smallerPoints(); }),
                       command("Point Size by &Spacing", "", [&cloud] { cloud.setPointSizeFollows(true); }),
                   });
}

Command panelMenu(QMainWindow& window) {
    Command menu = submenu("&Panels", {});
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) menu.submenu.push_back({.made = dock->toggleViewAction()});
    return menu;
}

/// At most twenty entries: what is used daily; the rest is in submenus.
Command viewMenu(Viewer& v, QMainWindow& window, const WindowCommands& commands) {
    LinkedViews& views = v.views;
    Command menu = submenu("&View", {
                                        directions(v.cloud),
                                        savedViews(v.savedViews),
                                        command("Fit All Vi&ews", "R; Home", [&views] { views.fitAll(); }),
                                        command("&Zoom In", "+; =", [&views] { views.zoomBy(1.25); }),
                                        command("Zoom O&ut", "-", [&views] { views.zoomBy(0.8); }),
                                        ofDesk(command("Fl&y to Point under Cursor", "F", [&views] { views.flyToHovered(); })),
                                        kLine,
                                    });
    const auto add = [&menu](const std::vector<Command>& more) { menu.submenu.insert(menu.submenu.end(), more.begin(), more.end()); };
    add(edgeLook(v));
    add({kLine, cloudLook(v, window), imagesMenu(views), kLine, ofDesk(panelMenu(window)), ofDesk(commands.shares),
         ofDesk(command("Reset &Layout", "", commands.resetLayout)), kLine, ofDesk(mouseMenu(window, v.cloud, v.preferences)),
         themeMenu(window, v.preferences), languageMenu(window, v.preferences, v.notice), commands.cab,
         command("Full Scree&n", "F11", [&window] { window.isFullScreen() ? window.showNormal() : window.showFullScreen(); })});
    return menu;
}

Command placeCommand(Viewer& v, QMainWindow& window) {
    auto* placing = new Placing(v.engine, v.files, v.notice, v.preferences, v.undo, &window);
    placing->setObjectName("placing");
    return command("P&ose and Mounting…", "Ctrl+P", [&v, placing] { v.live.showWhole(placing, [placing] { placing->show(); }); });
}

Command scanMenu(Viewer& v, QMainWindow& window) {
    Files& files = v.files;
    Live& live = v.live;
    const auto connected = onlyWhile(live.scanner(), &ScannerLink::connectedChanged);
    const auto playable = onlyWhile(live.timeline(), &Timeline::activeChanged);
    const auto step = [&](const char* text, const char* keys, int lines) {
        return linked(command(text, keys, [&live, lines] { live.timeline().stepBy(lines); }), playable);
    };
    const auto showProperties = [&v, &window] {
        if (v.engine.picture()) showScanProperties(&window, *v.engine.picture()->detection->scan);
    };
    const auto switchOf = [&files](const char* key) { // of the table of reading options
        return [&files, key](QAction& action) {
            const auto option =
                std::ranges::find_if(readingOptionTable(), [key](const ReadingOption& row) { return key == std::string_view(row.key); });
            action.setObjectName(key);
            action.setToolTip(QObject::tr(option->help));
            QObject::connect(&files, &Files::optionsChanged, &action,
                             [&action, get = option->get](const ReadingOptions& now) { action.setChecked(!get(now).empty()); });
        };
    };
    const auto stepScan = [&files, &live](int by) { // of the recording, else of the folder
        if (!live.timeline().stepSweep(by)) files.step(by);
    };
    return submenu("&Scan", {
                                command("&Next Scan", "PgDown", [stepScan] { stepScan(1); }),
                                command("Pre&vious Scan", "PgUp", [stepScan] { stepScan(-1); }),
                                command("&Add a Scan as a Layer…", "", [&v] { v.layers.ask(); }),
                                kLine,
                                linked(command("&Record", "Ctrl+R", [&live] { live.record(!live.scanner().recording()); }), connected),
                                linked(command("&Keep Last Minute", "Ctrl+K", [&live] { live.keepLastMinute(); }), connected),
                                linked(command("S&weep…", "", [&live] { live.panel().askSweep(); }), connected),
                                habit(toggle("&Hold First Sweep of a Connection at Its End", "", "live/hold", true,
                                             [&live](bool on) { live.scanner().setHoldAtEnd(on); })),
                                command("Recordings &Folder…", "", [&live] { live.askRecordingFolder(); }),
                                kLine,
                                linked(command("P&lay or Pause", "Space", [&live] { live.timeline().togglePlay(); }), playable),
                                step("Next Line", "Right", 1),
                                step("Previous Line", "Left", -1),
                                step("Ten Lines Forward", "Shift+Right", 10),
                                step("Ten Lines Back", "Shift+Left", -10),
                                kLine,
                                linked(toggle("&Straighten Beams", "", nullptr, false, [&files](bool on) { files.straighten(on); }),
                                       switchOf("straighten")),
                                linked(toggle("Keep Repeate&d Values", "", nullptr, false, [&files](bool on) { files.keepRepeated(on); }),
                                       switchOf("keep-repeated")),
                                command("&How the Scan Is Read…", "", [&files] { files.askReading(); }),
                                placeCommand(v, window),
                                command("Does This Look &Right?", "", [&v] { v.opening.show(); }),
                                command("&Properties…", "", showProperties),
                            });
}

Command edgesMenu(Viewer& v) {
    Tuning& tuning = v.tuning;
    EdgesPanel& panel = v.panel;
    Command presets = submenu("&Presets", {});
    for (const edges::Preset& preset : edges::builtInPresets())
        presets.submenu.push_back(
            linked({.text = presetName(preset.name), .run = [&tuning, preset] { tuning.usePreset(preset); }, .source = preset.name.c_str()},
                   [preset](QAction& action) { action.setToolTip(QObject::tr(preset.help.c_str())); }));
    presets.submenu.push_back(kLine);
    presets.submenu.push_back(command("&Open…", "", [&tuning] { tuning.askOpenPreset(); }));
    presets.submenu.push_back(command("&Save…", "", [&tuning] { tuning.askSavePreset(); }));
    const auto followLock = [&panel](QAction& action) {
        action.setChecked(panel.ratioLocked());
        QObject::connect(&panel, &EdgesPanel::ratioLockChanged, &action, &QAction::setChecked);
    };
    const auto followWhy = [&v](QAction& action) { // pressed while a click explains
        const auto follow = [&v, &action] { action.setChecked(v.views.tool() == Tool::Why); };
        QObject::connect(&v.views, &LinkedViews::toolChanged, &action, follow);
        QObject::connect(&action, &QAction::triggered, &action, follow); // a press alone does not switch it
    };
    const auto followBorders = [&v](QAction& action) {
        const auto follow = [&v, &action] { action.setChecked(v.engine.settings().rockBorders); };
        QObject::connect(&v.engine, &Engine::settingsChanged, &action, follow);
        follow();
    };
    return submenu(
        "&Edges",
        {
            presets,
            compareMenu(v.comparing),
            linked(toggle("&Lock upper = 3 × lower", "", nullptr, true, [&panel](bool on) { panel.setRatioLocked(on); }), followLock),
            linked(toggle("&Only Rock Borders", "", nullptr, false, [&v](bool on) { v.tuning.setParameter("rock-borders", on ? 1 : 0); }),
                   followBorders),
            command("This &Is an Edge", "Shift+E", [&v] { v.markedEdges.mark(v.views.marked(), true); }),
            command("This Is &Not an Edge", "Shift+X", [&v] { v.markedEdges.mark(v.views.marked(), false); }),
            command("Settings for These &Marks…", "", [&v] { v.markedEdges.propose(); }),
            command("Clear the Mar&ks", "", [&v] { v.markedEdges.clear(); }),
            linked(toggle("&Why Is This Cell an Edge or Not?", "W", nullptr, false, [&v](bool) { v.explanation.explainMarked(); }),
                   followWhy),
            confidenceCommand(v.confidence),
            command("&Reset to Preset", "", [&v] { v.tuning.usePreset(v.panel.preset()); }),
            command("Restore the &Default Settings", "Ctrl+D", [&v] { emit v.statusLine.resetRequested({}); }),
        });
}

} // namespace

std::vector<Command> menusOf(Viewer& viewer, QMainWindow& window, const WindowCommands& commands) {
    const auto showKeys = [&window] { showShortcuts(&window, window.actions()); };
    return {fileMenu(viewer, commands),
            editMenu(viewer, window),
            viewMenu(viewer, window, commands),
            scanMenu(viewer, window),
            edgesMenu(viewer),
            rocksMenu(viewer, window),
            measureMenu(viewer),
            submenu("&Help", {ofDesk(command("&Find a Command…", "Ctrl+Shift+P", [&window] { runFromPalette(&window, window.actions()); })),
                              command("&Manual", "F1", commands.manual), ofDesk(command("&Keys and Mouse", "H; ?", showKeys)),
                              ofDesk(command("&Tour", "", commands.tour)), // it shows what a cab does not have
                              command("&About EdgeScan", "", [&window] { showAbout(&window, checkGl().renderer); })})};
}

} // namespace edgescan::ui
