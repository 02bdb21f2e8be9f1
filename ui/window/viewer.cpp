// Who is made of what, and who learns of a new picture when.
#include "ui/window/viewer.h"

#include "ui/base/core_words.h"
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
#include "ui/window/tool_bar.h"

#include <set>

namespace edgescan::ui {
namespace {

struct LeftSweep {
    std::shared_ptr<const Scan> scan;
    PictureSource source;
};

/// Undo holds the sweep again, and its targets are with it.
void offerBack(Viewer& v, const Picture& left) {
    using Step = UndoStep<std::optional<LeftSweep>>;
    const auto show = [&v, stream = left.source.stream, pushed = false](const std::optional<LeftSweep>& sweep) mutable {
        if (!std::exchange(pushed, true)) return true; // the next sweep is on the screen already
        if (v.engine.picture()->source.stream != stream) return false;
        ScannerLink& scanner = v.live.scanner();
        scanner.follow(!sweep);
        if (!sweep) return true;
        PictureSource source = sweep->source;
        source.growth.growing = source.growth.growing && scanner.connected();
        v.engine.follow(sweep->scan, source);
        return true;
    };
    v.undo.push(new Step(stepName("Next Sweep"), LeftSweep{left.detection->scan, left.source}, std::nullopt, show));
    v.notice.showNotice(NoticeBar::Kind::Warning,
                        QObject::tr("Undo brings %1 back with its targets and measurements: the next sweep replaced it.")
                            .arg(scanName(left.detection->scan->name)));
    v.notice.offerUndo(v.undo);
}

void followSweeps(Viewer& v) {
    QObject::connect(&v.engine, &Engine::pictureReady, &v.live, [&v, last = std::shared_ptr<const Picture>()]() mutable {
        const auto left = std::exchange(last, v.engine.picture());
        if (!left || left->source.stream != last->source.stream) return;
        const int before = left->source.growth.sweep, now = last->source.growth.sweep;
        if (before < 0 || now < 0 || before == now) return;
        if (last->source.stream == v.live.scanner().stream() && !v.targets.notebook().empty()) offerBack(v, *left);
        v.views.pin(std::nullopt);
        v.rocks.select({});
    });
}

void followConnections(Viewer& v) {
    struct Scanner {
        QString address;
        std::set<std::uint64_t> streams;          // of its connections
        std::shared_ptr<const Picture> forgotten; // for Undo, which could not read a sweep again
    };
    QObject::connect(&v.live.scanner(), &ScannerLink::connectedChanged, &v.comparing, [&v, scanner = Scanner()](bool connected) mutable {
        if (!connected) return;
        const QString address = QString("%1:%2").arg(v.livePanel.host()).arg(v.livePanel.port());
        if (std::exchange(scanner.address, address) != address) scanner.streams.clear();
        scanner.streams.insert(v.live.scanner().stream());
        const auto a = v.comparing.pictureA();
        if (!a || scanner.streams.contains(a->source.stream)) return;
        scanner.forgotten = a;
        v.comparing.forget();
        v.notice.showNotice(NoticeBar::Kind::Warning,
                            QObject::tr("%1 is no longer compared as A, because it may be of another place. Undo (Ctrl+Z) brings it back.")
                                .arg(scanName(a->detection->scan->name)));
    });
}

/// Cells that were chosen on a sweep are not marked on the next one; a sweep with targets comes back by Undo. A new connection ends the
/// comparison with a picture of another place. To be called before others learn of new pictures.
void followScanner(Viewer& viewer) {
    followSweeps(viewer);
    followConnections(viewer);
}

} // namespace

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
