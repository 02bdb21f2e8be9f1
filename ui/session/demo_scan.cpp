// The demo draw-bell.
#include "ui/session/demo_scan.h"

#include "core/base/version.h"
#include "core/io/open_scan.h"
#include "core/io/save_scan.h"
#include "core/sim/simulate.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace edgescan::ui {
namespace {

QString cachedPath() {
    // The version is in the name: a newer program draws its own bell.
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/edgescan/demo-hangup-" + version() + ".json";
}

} // namespace

Result<Scan> demoScan(const std::function<bool(const char* stage, double fraction)>& progress) {
    const std::string path = cachedPath().toStdString();
    if (QFile::exists(cachedPath())) {
        ReadingOptions options;
        options.progress = progress;
        Result<Scan> cached = openScan(path, options);
        if (cached && cached->lines() == SimulationSettings{}.lines) {
            cached->name = "demo draw-bell";
            return cached;
        }
    }
    Result<Simulation> simulation = simulate({}, [&](double fraction) { return progress("casting beams", fraction); });
    if (!simulation) return simulation.error();
    // Without a cache the demo works all the same, only not as fast the next time.
    QDir().mkpath(QFileInfo(cachedPath()).path());
    if (const auto saved = saveScan(simulation->scan, path); saved) {
        if (Result<Scan> reread = openScan(path); reread) simulation->scan = std::move(*reread);
    }
    simulation->scan.name = "demo draw-bell";
    return std::move(simulation->scan);
}

} // namespace edgescan::ui
