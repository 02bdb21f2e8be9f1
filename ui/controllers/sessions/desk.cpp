// Converts between the controllers and one value.
#include "ui/controllers/sessions/desk.h"

#include "core/edges/settings/presets.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/live.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/sessions/looks.h"
#include "ui/controllers/targets/marked_edges.h"
#include "ui/controllers/targets/selection.h"
#include "ui/controllers/targets/targets.h"
#include "ui/controllers/tuning.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/panels/keys/commands.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QAction>
#include <QFileInfo>

namespace edgescan::ui {
namespace {

std::filesystem::path absolutePath(const std::string& path) {
    return path.empty() ? std::filesystem::path() : std::filesystem::absolute(path).lexically_normal();
}

ReadingOptions kept(ReadingOptions reading) {
    reading.pose = absolutePath(reading.pose).string();
    reading.calibration = absolutePath(reading.calibration).string();
    reading.progress = nullptr;
    return reading;
}

inspect::SessionScan::Kind kindOf(std::optional<bool> demo) {
    if (!demo) return inspect::SessionScan::Kind::File;
    return *demo ? inspect::SessionScan::Kind::DemoAfterBlast : inspect::SessionScan::Kind::Demo;
}

inspect::SessionScan scanIn(const QString& path, std::optional<bool> demo, const ReadingOptions& reading, const Scan& scan) {
    inspect::SessionScan of;
    of.kind = kindOf(demo);
    of.path = absolutePath(path.toStdString());
    of.identity = inspect::notebookScan(scan);
    of.reading = kept(reading);
    return of;
}

std::optional<inspect::EarlierScan> keptOf(const Comparing& comparing) {
    const std::optional<SourceOfA>& from = comparing.sourceOfA();
    if (!from || !comparing.pictureA()) return std::nullopt;
    return inspect::EarlierScan{scanIn(from->path, from->demo, from->reading, *comparing.pictureA()->detection->scan), from->settings};
}

/// Empty: it cannot be opened again.
std::optional<inspect::SessionScan> scanOf(const Desk& desk, const Picture& picture) {
    const Scan& scan = *picture.detection->scan;
    if (picture.source.growth.sweep >= 0) {
        const QString recording = desk.live.recordingOf(picture.source.stream);
        if (recording.isEmpty() || scan.lines() == 0) return std::nullopt;
        inspect::NotebookScan identity = inspect::notebookScan(scan);
        identity.sha256.clear(); // of a growing file
        inspect::SessionScan of;
        of.kind = inspect::SessionScan::Kind::Recording;
        of.path = absolutePath(recording.toStdString());
        of.identity = std::move(identity);
        of.head = inspect::scanHead(scan);
        return of;
    }
    if (scan.sha256.empty() || (desk.files.path().isEmpty() && !desk.files.demo())) return std::nullopt;
    return scanIn(desk.files.path(), desk.files.demo(), desk.files.options(), scan);
}

template <class Act>
void forSwitches(const QWidget& window, const Act& act) {
    for (QAction* action : window.actions()) {
        const QVariant key = action->property(kInSessions);
        if (key.isValid()) act(*action, key.toString().toStdString());
    }
}

} // namespace

std::optional<inspect::ViewerState> taken(const Desk& desk) {
    const std::shared_ptr<const Picture>& picture = desk.engine.picture();
    if (!picture) return std::nullopt;
    auto of = scanOf(desk, *picture);
    if (!of) return std::nullopt;
    inspect::ViewerState state;
    state.scan = std::move(*of);
    state.settings = desk.engine.settings();
    const edges::Preset& preset = desk.panel.preset();
    state.preset = preset.path.empty() ? preset.name : preset.path;
    state.notebook = desk.targets.notebook();
    if (const inspect::PinnedTarget* active = desk.targets.active()) state.active = active->cell;
    state.selected = inspect::runsOf(desk.selection.cells());
    state.hidden = inspect::runsOf(desk.selection.hidden());
    if (desk.rocks.shown()) state.rocks = rocks::Preset{desk.rocks.settings(), desk.rocks.edits(), state.scan.identity.sha256};
    state.marks = desk.marked.marks();
    state.kept = keptOf(desk.comparing);
    const CameraPose pose = desk.views.cloud().camera();
    state.camera = inspect::SessionCamera{pose.position, pose.focus, pose.up, pose.viewAngleDeg, pose.parallel};
    if (const ViewPort& port = *desk.views.gray().viewPort(); !port.fitted())
        state.images = inspect::SessionImages{port.centre().x(), port.centre().y(), port.zoom()};
    forSwitches(desk.window, [&](const QAction& action, const std::string& key) { state.switches[key] = action.isChecked(); });
    state.looks = looksOf(desk);
    state.layout = desk.layout();
    return state;
}

void layOut(const Desk& desk, const inspect::ViewerState& state) {
    if (const auto preset = edges::findPreset(state.preset); preset && !state.preset.empty()) desk.panel.setPreset(*preset);
    desk.tuning.useSettings(state.settings);
    forSwitches(desk.window, [&](QAction& action, const std::string& key) {
        if (const auto found = state.switches.find(key); found != state.switches.end() && found->second != action.isChecked())
            action.trigger();
    });
    useLooks(desk, state.looks);
    desk.useLayout(state.layout);
}

bool isShown(const Desk& desk, const inspect::SessionScan& scan) {
    if (!desk.engine.picture()) return false;
    const Scan& shown = *desk.engine.picture()->detection->scan;
    if (scan.kind == inspect::SessionScan::Kind::Recording)
        return shown.beams() == scan.identity.beams && inspect::scanHead(shown, scan.head.lines) == scan.head &&
               (scan.identity.sha256.empty() || shown.sha256 == scan.identity.sha256);
    return shown.sha256 == scan.identity.sha256 && shown.lines() == scan.identity.lines && shown.beams() == scan.identity.beams;
}

void layOutOnScan(const Desk& desk, const inspect::ViewerState& whole) {
    const std::size_t cells = desk.engine.picture()->detection->scan->cells();
    const inspect::ViewerState state = inspect::cutTo(whole, cells);
    desk.targets.restore(state.notebook);
    desk.selection.restore(inspect::cellsOf(state.selected, cells), inspect::cellsOf(state.hidden, cells));
    desk.marked.restore(state.marks);
    if (state.rocks) desk.rocks.restore(*state.rocks);
    if (state.active) desk.views.pin(*state.active);
    ViewPort& port = *desk.views.gray().viewPort();
    if (state.images) {
        const QPointF centre(state.images->beam, state.images->line);
        port.zoomAt(centre, state.images->zoom / port.zoom());
        port.centreOn(centre);
    } else {
        port.fit();
    }
    if (state.camera) {
        const inspect::SessionCamera& camera = *state.camera;
        desk.views.cloud().setCamera({camera.position, camera.focus, camera.up, camera.viewAngleDeg, camera.parallel});
    }
    useLooksOfScan(desk, state.looks);
    if (state.kept) {
        const inspect::SessionScan& scan = state.kept->scan;
        std::optional<bool> demo;
        if (scan.kind != inspect::SessionScan::Kind::File) demo = scan.kind == inspect::SessionScan::Kind::DemoAfterBlast;
        desk.comparing.restore(
            {exactText(scan.path.string()), demo, scan.reading, state.kept->settings, scan.identity.sha256, scan.identity.name});
    } else if (desk.comparing.pictureA()) {
        desk.comparing.forget();
    }
}

} // namespace edgescan::ui
