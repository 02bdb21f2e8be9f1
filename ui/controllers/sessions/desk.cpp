// From the controllers to one value and back.
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

SittingScan::Kind kindOf(std::optional<bool> demo) {
    if (!demo) return SittingScan::Kind::File;
    return *demo ? SittingScan::Kind::DemoAfterBlast : SittingScan::Kind::Demo;
}

SittingScan scanIn(const QString& path, std::optional<bool> demo, const ReadingOptions& reading, const Scan& scan) {
    SittingScan of;
    of.kind = kindOf(demo);
    of.path = absolutePath(path.toStdString());
    of.identity = notebookScan(scan);
    of.reading = kept(reading);
    return of;
}

std::optional<SittingKept> keptOf(const Comparing& comparing) {
    const std::optional<KeptFrom>& from = comparing.keptFrom();
    if (!from || !comparing.kept()) return std::nullopt;
    return SittingKept{scanIn(from->path, from->demo, from->reading, *comparing.kept()->detection->scan), from->settings};
}

/// Empty: it can not be opened again.
std::optional<SittingScan> scanOf(const Desk& desk, const Picture& picture) {
    const Scan& scan = *picture.detection->scan;
    if (picture.source.growth.sweep >= 0) {
        const QString recording = desk.live.recordingOf(picture.source.stream);
        if (recording.isEmpty() || scan.lines() == 0) return std::nullopt;
        NotebookScan identity = notebookScan(scan);
        identity.sha256.clear(); // of a file that grows
        SittingScan of;
        of.kind = SittingScan::Kind::Recording;
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

std::optional<Sitting> taken(const Desk& desk) {
    const std::shared_ptr<const Picture>& picture = desk.session.picture();
    if (!picture) return std::nullopt;
    auto of = scanOf(desk, *picture);
    if (!of) return std::nullopt;
    Sitting sitting;
    sitting.scan = std::move(*of);
    sitting.settings = desk.session.settings();
    const Preset& preset = desk.panel.preset();
    sitting.preset = preset.path.empty() ? preset.name : preset.path;
    sitting.notebook = desk.targets.notebook();
    if (const PinnedTarget* active = desk.targets.active()) sitting.active = active->cell;
    sitting.selected = runsOf(desk.selection.cells());
    sitting.hidden = runsOf(desk.selection.hidden());
    if (desk.rocks.shown()) sitting.rocks = RockPreset{desk.rocks.settings(), desk.rocks.edits(), sitting.scan.identity.sha256};
    sitting.marks = desk.marked.marks();
    sitting.kept = keptOf(desk.comparing);
    const CameraPose pose = desk.views.cloud().camera();
    sitting.camera = SittingCamera{pose.position, pose.focus, pose.up, pose.viewAngleDeg, pose.parallel};
    if (const ViewPort& port = *desk.views.gray().viewPort(); !port.fitted())
        sitting.images = SittingImages{port.centre().x(), port.centre().y(), port.zoom()};
    forSwitches(desk.window, [&](const QAction& action, const std::string& key) { sitting.switches[key] = action.isChecked(); });
    sitting.looks = looksOf(desk);
    sitting.layout = desk.layout();
    return sitting;
}

void layOut(const Desk& desk, const Sitting& sitting) {
    if (const auto preset = findPreset(sitting.preset); preset && !sitting.preset.empty()) desk.panel.setPreset(*preset);
    desk.tuning.useSettings(sitting.settings);
    forSwitches(desk.window, [&](QAction& action, const std::string& key) {
        if (const auto found = sitting.switches.find(key); found != sitting.switches.end() && found->second != action.isChecked())
            action.trigger();
    });
    useLooks(desk, sitting.looks);
    desk.useLayout(sitting.layout);
}

bool isShown(const Desk& desk, const SittingScan& scan) {
    if (!desk.session.picture()) return false;
    const Scan& shown = *desk.session.picture()->detection->scan;
    if (scan.kind == SittingScan::Kind::Recording)
        return shown.beams() == scan.identity.beams && scanHead(shown, scan.head.lines) == scan.head &&
               (scan.identity.sha256.empty() || shown.sha256 == scan.identity.sha256);
    return shown.sha256 == scan.identity.sha256 && shown.lines() == scan.identity.lines && shown.beams() == scan.identity.beams;
}

void layOutOnScan(const Desk& desk, const Sitting& whole) {
    const std::size_t cells = desk.session.picture()->detection->scan->cells();
    const Sitting sitting = cutTo(whole, cells);
    desk.targets.restore(sitting.notebook);
    desk.selection.restore(cellsOf(sitting.selected, cells), cellsOf(sitting.hidden, cells));
    desk.marked.restore(sitting.marks);
    if (sitting.rocks) desk.rocks.restore(*sitting.rocks);
    if (sitting.active) desk.views.pin(*sitting.active);
    ViewPort& port = *desk.views.gray().viewPort();
    if (sitting.images) {
        const QPointF centre(sitting.images->beam, sitting.images->line);
        port.zoomAt(centre, sitting.images->zoom / port.zoom());
        port.centreOn(centre);
    } else {
        port.fit();
    }
    if (sitting.camera) {
        const SittingCamera& camera = *sitting.camera;
        desk.views.cloud().setCamera({camera.position, camera.focus, camera.up, camera.viewAngleDeg, camera.parallel});
    }
    useLooksOfScan(desk, sitting.looks);
    if (sitting.kept) {
        const SittingScan& scan = sitting.kept->scan;
        std::optional<bool> demo;
        if (scan.kind != SittingScan::Kind::File) demo = scan.kind == SittingScan::Kind::DemoAfterBlast;
        desk.comparing.restore(
            {exactText(scan.path.string()), demo, scan.reading, sitting.kept->settings, scan.identity.sha256, scan.identity.name});
    } else if (desk.comparing.kept()) {
        desk.comparing.forget();
    }
}

} // namespace edgescan::ui
