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

SessionScan::Kind kindOf(std::optional<bool> demo) {
    if (!demo) return SessionScan::Kind::File;
    return *demo ? SessionScan::Kind::DemoAfterBlast : SessionScan::Kind::Demo;
}

SessionScan scanIn(const QString& path, std::optional<bool> demo, const ReadingOptions& reading, const Scan& scan) {
    SessionScan of;
    of.kind = kindOf(demo);
    of.path = absolutePath(path.toStdString());
    of.identity = notebookScan(scan);
    of.reading = kept(reading);
    return of;
}

std::optional<EarlierScan> keptOf(const Comparing& comparing) {
    const std::optional<KeptFrom>& from = comparing.keptFrom();
    if (!from || !comparing.kept()) return std::nullopt;
    return EarlierScan{scanIn(from->path, from->demo, from->reading, *comparing.kept()->detection->scan), from->settings};
}

/// Empty: it cannot be opened again.
std::optional<SessionScan> scanOf(const Desk& desk, const Picture& picture) {
    const Scan& scan = *picture.detection->scan;
    if (picture.source.growth.sweep >= 0) {
        const QString recording = desk.live.recordingOf(picture.source.stream);
        if (recording.isEmpty() || scan.lines() == 0) return std::nullopt;
        NotebookScan identity = notebookScan(scan);
        identity.sha256.clear(); // of a growing file
        SessionScan of;
        of.kind = SessionScan::Kind::Recording;
        of.path = absolutePath(recording.toStdString());
        of.identity = std::move(identity);
        of.head = scanHead(scan);
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

std::optional<ViewerState> taken(const Desk& desk) {
    const std::shared_ptr<const Picture>& picture = desk.engine.picture();
    if (!picture) return std::nullopt;
    auto of = scanOf(desk, *picture);
    if (!of) return std::nullopt;
    ViewerState state;
    state.scan = std::move(*of);
    state.settings = desk.engine.settings();
    const Preset& preset = desk.panel.preset();
    state.preset = preset.path.empty() ? preset.name : preset.path;
    state.notebook = desk.targets.notebook();
    if (const PinnedTarget* active = desk.targets.active()) state.active = active->cell;
    state.selected = runsOf(desk.selection.cells());
    state.hidden = runsOf(desk.selection.hidden());
    if (desk.rocks.shown()) state.rocks = RockPreset{desk.rocks.settings(), desk.rocks.edits(), state.scan.identity.sha256};
    state.marks = desk.marked.marks();
    state.kept = keptOf(desk.comparing);
    const CameraPose pose = desk.views.cloud().camera();
    state.camera = SessionCamera{pose.position, pose.focus, pose.up, pose.viewAngleDeg, pose.parallel};
    if (const ViewPort& port = *desk.views.gray().viewPort(); !port.fitted())
        state.images = SessionImages{port.centre().x(), port.centre().y(), port.zoom()};
    forSwitches(desk.window, [&](const QAction& action, const std::string& key) { state.switches[key] = action.isChecked(); });
    state.looks = looksOf(desk);
    state.layout = desk.layout();
    return state;
}

void layOut(const Desk& desk, const ViewerState& state) {
    if (const auto preset = findPreset(state.preset); preset && !state.preset.empty()) desk.panel.setPreset(*preset);
    desk.tuning.useSettings(state.settings);
    forSwitches(desk.window, [&](QAction& action, const std::string& key) {
        if (const auto found = state.switches.find(key); found != state.switches.end() && found->second != action.isChecked())
            action.trigger();
    });
    useLooks(desk, state.looks);
    desk.useLayout(state.layout);
}

bool isShown(const Desk& desk, const SessionScan& scan) {
    if (!desk.engine.picture()) return false;
    const Scan& shown = *desk.engine.picture()->detection->scan;
    if (scan.kind == SessionScan::Kind::Recording)
        return shown.beams() == scan.identity.beams && scanHead(shown, scan.head.lines) == scan.head &&
               (scan.identity.sha256.empty() || shown.sha256 == scan.identity.sha256);
    return shown.sha256 == scan.identity.sha256 && shown.lines() == scan.identity.lines && shown.beams() == scan.identity.beams;
}

void layOutOnScan(const Desk& desk, const ViewerState& whole) {
    const std::size_t cells = desk.engine.picture()->detection->scan->cells();
    const ViewerState state = cutTo(whole, cells);
    desk.targets.restore(state.notebook);
    desk.selection.restore(cellsOf(state.selected, cells), cellsOf(state.hidden, cells));
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
        const SessionCamera& camera = *state.camera;
        desk.views.cloud().setCamera({camera.position, camera.focus, camera.up, camera.viewAngleDeg, camera.parallel});
    }
    useLooksOfScan(desk, state.looks);
    if (state.kept) {
        const SessionScan& scan = state.kept->scan;
        std::optional<bool> demo;
        if (scan.kind != SessionScan::Kind::File) demo = scan.kind == SessionScan::Kind::DemoAfterBlast;
        desk.comparing.restore(
            {exactText(scan.path.string()), demo, scan.reading, state.kept->settings, scan.identity.sha256, scan.identity.name});
    } else if (desk.comparing.kept()) {
        desk.comparing.forget();
    }
}

} // namespace edgescan::ui
