// The demo draw-bell.
#include "ui/engine/worker_bridge/demo_scan.h"

#include "core/base/version.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/sim/simulate.h"
#include "ui/base/shown_text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace edgescan::ui {
namespace {

QString cachedPath(bool afterBlast) {
    // The name contains the version: a newer program simulates its own bell.
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/edgescan/demo-hangup-" +
           (afterBlast ? "after-" : "") + version() + ".json";
}

} // namespace

Result<Scan> demoScan(const std::function<bool(const char* stage, double fraction)>& progress, bool afterBlast) {
    const std::string path = exactBytes(cachedPath(afterBlast));
    const char* name = afterBlast ? "demo draw-bell after the blast" : "demo draw-bell";
    if (QFile::exists(cachedPath(afterBlast))) {
        ReadingOptions options;
        options.progress = progress;
        Result<Scan> cached = files::openScan(path, options);
        if (cached && cached->lines() == sim::SimulationSettings{}.lines) {
            cached->name = name;
            return cached;
        }
    }
    sim::SimulationSettings settings;
    settings.afterBlast = afterBlast;
    Result<sim::Simulation> simulation = sim::simulate(settings, [&](double fraction) { return progress("casting beams", fraction); });
    if (!simulation) return simulation.error();
    // Without a cache the demo works too; it only takes longer the next time.
    QDir().mkpath(QFileInfo(cachedPath(afterBlast)).path());
    if (const auto saved = files::saveScan(simulation->scan, path); saved) {
        if (Result<Scan> reread = files::openScan(path); reread) simulation->scan = std::move(*reread);
    }
    simulation->scan.name = name;
    return std::move(simulation->scan);
}

} // namespace edgescan::ui
