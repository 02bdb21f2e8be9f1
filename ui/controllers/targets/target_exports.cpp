// Exports of targets: table and drawing.
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/targets/targets.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/engine/worker_bridge/preferences.h"

#include <QDir>

namespace edgescan::ui {

void Targets::askExport() {
    if (!engine_.picture() || notebook_.targets.empty()) return; // the command is off, and says why
    const Scan& scan = *engine_.picture()->detection->scan;
    SaveQuestion question;
    question.title = tr("Export %1").arg(targetCount(notebook_.targets.size()));
    question.filters = QStringList{tr("Table (*.csv)"), tr("Drawing (*.dxf)")};
    question.extension = ".csv";
    const QString name = shownName(exactText(scan.name), 80).replace(' ', '-').replace('/', '-') + "_targets" +
                         frameTail(files::usualFrame(scan)) + question.extension;
    question.place = QDir(preferences_.folder("exports")).filePath(name);
    question.files = withItsRecord;
    const QString path = askWhereToSave(notice_.window(), question);
    if (!path.isEmpty()) exportTo(path);
}

void Targets::exportTo(const QString& path) {
    if (!engine_.picture() || notebook_.targets.empty()) return;
    exports::ExportOptions options;
    options.frame = files::usualFrame(*engine_.picture()->detection->scan);
    options.targets = std::make_shared<const std::vector<inspect::PinnedTarget>>(notebook_.targets);
    engine_.save(exports::ExportContent::Targets, path, options);
}

} // namespace edgescan::ui
