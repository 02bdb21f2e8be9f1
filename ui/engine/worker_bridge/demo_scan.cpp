// The demo draw-bell.
#include "ui/engine/worker_bridge/demo_scan.h"

#include "core/files/open_save/open_scan.h"
#include "ui/base/shown_text.h"

#include <QCoreApplication>

namespace edgescan::ui {

Result<Scan> demoScan(const std::function<bool(const char* stage, double fraction)>& progress, bool afterBlast) {
    ReadingOptions options;
    options.progress = progress;
    const QString name = afterBlast ? "demo-after-blast.json" : "demo.json", folder = "/../share/edgescan/demo/";
    Result<Scan> scan = files::openScan(exactBytes(QCoreApplication::applicationDirPath() + folder + name), options);
    if (scan) scan->name = afterBlast ? "demo draw-bell after the blast" : "demo draw-bell";
    return scan;
}

} // namespace edgescan::ui
