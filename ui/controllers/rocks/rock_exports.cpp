// Exports of rocks: table, report, labels, outlines, hulls.
#include "core/files/open_save/sidecar_grid.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/engine/worker_bridge/memory.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>

namespace edgescan::ui {
namespace {

// The extension determines the content of the file.
struct RockFile {
    const char* extension;
    exports::ExportContent content;
    const char* title;
    bool hasFrame; // it contains coordinates
};
constexpr std::array<RockFile, 7> kRockFiles{{
    {"csv", exports::ExportContent::RockTable, QT_TRANSLATE_NOOP("QObject", "Table, one row per rock"), true},
    {"json", exports::ExportContent::RockReport, QT_TRANSLATE_NOOP("QObject", "Report with settings and edits"), true},
    {"png", exports::ExportContent::RockLabels, QT_TRANSLATE_NOOP("QObject", "Labels as a 16-bit picture"), false},
    {"dxf", exports::ExportContent::RockOutlines, QT_TRANSLATE_NOOP("QObject", "Outlines in space"), true},
    {"geojson", exports::ExportContent::RockOutlines, QT_TRANSLATE_NOOP("QObject", "Outlines in the picture"), false},
    {"ply", exports::ExportContent::RockHulls, QT_TRANSLATE_NOOP("QObject", "Convex hulls of the visible points"), true},
    {"obj", exports::ExportContent::RockHulls, QT_TRANSLATE_NOOP("QObject", "Convex hulls of the visible points"), true},
}};

const RockFile* rockFileOf(const QString& path) {
    const QString extension = QFileInfo(path).suffix().toLower();
    const auto found =
        std::find_if(kRockFiles.begin(), kRockFiles.end(), [&](const RockFile& file) { return extension == file.extension; });
    return found == kRockFiles.end() ? nullptr : &*found;
}

} // namespace

void Rocks::askExport() {
    if (!picture_) {
        notice_.showNotice(NoticeBar::Kind::Warning, tr("There is nothing to export yet: show the rocks of a scan first."));
        return;
    }
    SaveQuestion question;
    question.title = tr("Export %1 rocks").arg(picture_->study.rocks.size());
    for (const RockFile& file : kRockFiles) question.filters << QString("%1 (*.%2)").arg(QObject::tr(file.title), file.extension);
    question.extension = QString(".") + kRockFiles.front().extension;
    const QString name = shownName(exactText(picture_->detection->scan->name), 80).replace(' ', '-').replace('/', '-') + "_rocks";
    question.place = QDir(memory_.folder("exports")).filePath(name + question.extension);
    // The provenance record of the file is replaced too.
    question.files = [](const QString& path) { return QStringList{path, exactText(files::sidecarPath(path.toStdString()).string())}; };
    const QString path = askWhereToSave(notice_.window(), question);
    if (!path.isEmpty()) exportTo(path);
}

void Rocks::exportTo(const QString& path) {
    const RockFile* file = rockFileOf(path);
    if (file == nullptr) {
        notice_.showNotice(NoticeBar::Kind::Error,
                           tr("%1 was not written: give it one of the endings csv, json, png, dxf, geojson, ply, obj.").arg(path));
        return;
    }
    if (!picture_ || behind()) {
        notice_.showNotice(NoticeBar::Kind::Warning, tr("%1 was not written: the rocks are still being worked out; try again.").arg(path));
        return;
    }
    exports::ExportOptions options;
    if (file->hasFrame) options.frame = usualFrame(*picture_->detection->scan);
    options.rocks = std::shared_ptr<const rocks::Study>(picture_, &picture_->study);
    engine_.save(file->content, path, options);
}

} // namespace edgescan::ui
