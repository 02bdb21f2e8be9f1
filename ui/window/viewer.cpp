// Who is made of what, and who learns of a new picture when.
#include "ui/window/viewer.h"

#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/confidence/confidence_legend.h"
#include "ui/panels/layers/layers_panel.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/scale_plate.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/views/image/image_view.h"
#include "ui/window/scanner_changes.h"
#include "ui/window/tool_bar.h"

namespace edgescan::ui {

Viewer::Viewer(Preferences& ofPerson)
    : preferences(ofPerson), gray(*new ImageView), edges(*new ImageView(gray.viewPort())), cloud(*new CloudView),
      scalePlate(*new ScalePlate(&cloud)), viewCube(*new ViewCube(&cloud)), panel(*new EdgesPanel), livePanel(*new LivePanel),
      timeline(*new Timeline), rocksPanel(*new RocksPanel), rockTable(*new RockTable), targetsPanel(*new TargetsPanel),
      layersPanel(*new LayersPanel), tools(*new ToolBar), origin(*new StateBadge), notice(*new NoticeBar), statusLine(*new StatusLine),
      warnings(*new WarningButton), legend(*new EdgeLegend), changeLegend(*new ChangeLegend), confidenceLegend(*new ConfidenceLegend),
      rangeWindow(*new RangeWindow), views(engine, gray, edges, cloud), files(engine, notice, preferences, undo),
      opening(engine, files, notice), exports(engine, files, notice, preferences), tuning(engine, panel, notice, preferences, undo),
      live(engine, livePanel, timeline, views, files, notice, preferences), explanation(views, notice),
      rocks(engine, views, rocksPanel, rockTable, notice, preferences, undo),
      targets(engine, views, rocks, targetsPanel, notice, preferences, undo), measures(views, targets, notice),
      selection(engine, views, rocks, notice, undo), sections(engine, views, rocks, targets, notice, preferences),
      comparing(engine, views, changeLegend, files, notice, preferences, undo),
      layers(engine, views, files, targets, layersPanel, notice, preferences, undo),
      confidence(engine, views, targets, confidenceLegend, preferences), markedEdges(engine, views, targets, undo, notice),
      look(engine, views, scalePlate, rangeWindow, preferences), savedViews(views, notice),
      report(engine, files, rocks, targets, comparing, notice, preferences), audit(preferences.dataFolder(), engine, views, undo, notice) {
    followScanner(*this);
    followPictures();
}

/// Who learns of a new picture, in this order; the window and the sessions come last.
void Viewer::followPictures() {
    const auto next = [this](auto& part, auto follow) { QObject::connect(&engine, &Engine::pictureReady, &part, follow); };
    next(views, &LinkedViews::followPicture); // the others draw over it
    next(tuning, &Tuning::followPicture);
    next(live, &Live::followPicture);
    // A sweep that is held in its middle does not grow on the screen.
    const auto count = [this] { tuning.count(live.grows()); };
    next(tuning, count);
    QObject::connect(&live, &Live::growthChanged, &tuning, count);
    next(explanation, &Explanation::followPicture);
    next(rocks, &Rocks::followPicture);
    next(targets, &Targets::followPicture);
    next(selection, &Selection::followPicture);
    next(comparing, &Comparing::followPicture);
    next(layers, &Layers::followPicture);
    next(confidence, &Confidence::followPicture);
    next(markedEdges, &MarkedEdges::followPicture);
    next(look, &ScanLook::followPicture);
    // What is written is of B: A is not on the screen meanwhile.
    QObject::connect(&exports, &Exports::asked, &comparing, [this] { comparing.flip(false); });
    QObject::connect(&report, &ScanReport::asked, &comparing, [this] { comparing.flip(false); });
    QObject::connect(&comparing, &Comparing::begun, &rocks, [this] { rocks.setShown(false); }); // faces cover what changed
    const auto drop = [this] {
        if (!engine.behind()) dropStepsOfOtherScans(undo); // the scan of a step may be on its way to the screen
    };
    QObject::connect(&engine, &Engine::pictureReady, &undo, drop, Qt::QueuedConnection); // after all
    QObject::connect(&undo, &QUndoStack::indexChanged, &undo, drop, Qt::QueuedConnection);
}

} // namespace edgescan::ui
