// Exports of rocks: table, report, labels, outlines, hulls.
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/rocks/rock_table.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <string>
#include <vector>

namespace edgescan::ui {
namespace {

// The extension determines the content of the file.
struct RockFile {
    const exports::ExportKind* kind;
    const exports::ExportFile* file;
};

// The table is first: it is the file that people use most.
const std::vector<RockFile>& rockFiles() {
    static const std::vector<RockFile> kFiles = [] {
        std::vector<RockFile> files;
        for (const exports::ExportKind& kind : exports::exportKinds()) {
            for (const exports::ExportFile& file : kind.files) {
                if (file.title != nullptr) files.push_back({&kind, &file});
            }
        }
        std::ranges::stable_partition(files, [](const RockFile& each) { return each.kind->content == exports::ExportContent::RockTable; });
        return files;
    }();
    return kFiles;
}

const RockFile* rockFileOf(const QString& path) {
    const std::string extension = "." + QFileInfo(path).suffix().toLower().toStdString();
    const auto found = std::ranges::find_if(rockFiles(), [&](const RockFile& each) { return extension == each.file->extension; });
    return found == rockFiles().end() ? nullptr : &*found;
}

} // namespace

void Rocks::askExport(bool all) {
    if (!picture_) {
        notice_.showHint(tr("There is nothing to export yet: show the rocks of a scan first."));
        return;
    }
    SaveQuestion question;
    const std::size_t count = picture_->study.rocks.size();
    const auto listed = all ? std::nullopt : table_.listed();
    question.title = listed && listed->size() < count ? tr("Export %1 of %2").arg(listed->size()).arg(rockCount(count))
                                                      : tr("Export %1").arg(rockCount(count));
    for (const RockFile& each : rockFiles())
        question.filters << QString("%1 (*%2)").arg(QObject::tr(each.file->title), each.file->extension);
    question.extension = rockFiles().front().file->extension;
    const QString name = shownName(exactText(picture_->detection->scan->name), 80).replace(' ', '-').replace('/', '-') + "_rocks" +
                         frameTail(files::usualFrame(*picture_->detection->scan));
    question.place = QDir(preferences_.folder("exports")).filePath(name + question.extension);
    question.files = withItsRecord;
    const QString path = askWhereToSave(notice_.window(), question);
    if (!path.isEmpty()) exportTo(path, all);
}

void Rocks::exportTo(const QString& path, bool all) {
    const RockFile* file = rockFileOf(path);
    if (file == nullptr) {
        QStringList endings;
        for (const RockFile& each : rockFiles()) endings << each.file->extension + 1; // without its dot
        notice_.showNotice(NoticeBar::Kind::Error, tr("%1 was not written: give it one of the endings %2.").arg(path, endings.join(", ")));
        return;
    }
    whenKnown(path, [this, path, file, all] {
        exports::ExportOptions options;
        if (file->file->coordinates != exports::ExportFile::Coordinates::None)
            options.frame = files::usualFrame(*picture_->detection->scan);
        options.rocks = std::shared_ptr<const rocks::Study>(picture_, &picture_->study);
        if (auto listed = all ? std::nullopt : table_.listed()) {
            auto study = std::make_shared<rocks::Study>(picture_->study);
            study->listed = std::move(listed);
            options.rocks = std::move(study);
        }
        if (!pinnedTargets_.empty()) options.targets = std::make_shared<const std::vector<inspect::PinnedTarget>>(pinnedTargets_);
        engine_.save(file->kind->content, path, options);
    });
}

void Rocks::whenKnown(const QString& path, std::function<void()> write) {
    if (picture_ && !behind()) return write();
    const auto cancel = [this, path] { std::erase_if(waiting_, [&](const Waiting& each) { return each.path == path; }); };
    waiting_.push_back(
        {path, std::move(write), engine_.works().start(tr("%1 waits for the rocks").arg(QFileInfo(path).fileName()), cancel)});
    if (!on_ || !(working() || nextOfSweep_.isActive())) refuseWaiting(); // nothing would end the wait
}

void Rocks::writeWaiting() {
    if (!picture_ || behind()) return;
    for (const Waiting& each : std::exchange(waiting_, {})) each.write();
}

void Rocks::refuseWaiting() {
    for (const Waiting& each : std::exchange(waiting_, {}))
        notice_.showNotice(NoticeBar::Kind::Warning, tr("%1 was not written: its rocks are not known.").arg(each.path));
}

} // namespace edgescan::ui
