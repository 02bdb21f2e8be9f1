// Exports, screenshots, and the command line that gives the same.
#include "ui/controllers/files/exports.h"

#include "core/base/whole_file.h"
#include "core/edges/settings/command_text.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/inspect/measure/notebook.h"
#include "core/scan/georef/placed_points.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/files/file_filters.h"
#include "ui/controllers/files/files.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/export_dialog.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDate>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QStandardPaths>

#include <algorithm>
#include <span>

namespace edgescan::ui {
namespace {

// "bell_edges_canny_lower-threshold6_2026-11-20_LOCAL": what the edges were found with, in the words of the window.
QString exportName(const edges::Detection& detection, exports::ExportContent content, CoordinateFrame frame) {
    const exports::ExportKind::InWindow& names = exports::exportKind(content).window;
    QStringList parts{shownName(exactText(detection.scan->name), 80).replace(' ', '-').replace('/', '-'), names.tail};
    const edges::Settings& settings = detection.settings;
    const edges::Parameter& swept = edges::sweptParameter(settings.method);
    if (names.namesMethod)
        parts << edges::traitsOf(settings.method).key
              << QString(swept.label).toLower().replace(' ', '-') + exactText(edges::formatValue(swept, swept.get(settings)));
    parts << QDate::currentDate().toString(Qt::ISODate);
    return parts.join('_') + (exports::exportKind(content).holds == exports::ExportKind::Holds::Picture ? "" : frameTail(frame));
}

/// What a file holds, in the language of the window.
QString contentText(exports::ExportContent what, qint64 count) {
    using Counts = exports::ExportKind::Counts;
    const QString many = countText(count);
    if (what == exports::ExportContent::Section)
        return count == 0 ? Exports::tr("a section") : Exports::tr("a section of %1").arg(rockCount(static_cast<std::size_t>(count)));
    switch (exports::exportKind(what).counts) {
    case Counts::EdgePoints:
        return Exports::tr("%1 edge points").arg(many);
    case Counts::Points:
        return Exports::tr("%1 points").arg(many);
    case Counts::Cells:
        return Exports::tr("%1 cells").arg(many);
    case Counts::Rocks:
        return rockCount(static_cast<std::size_t>(count));
    case Counts::Targets:
        break;
    }
    return targetCount(static_cast<std::size_t>(count));
}

} // namespace

Result<Done> savePng(const QImage& image, const QString& path) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return writeWholeFile(exactBytes(path), std::as_bytes(std::span(png.constData(), static_cast<std::size_t>(png.size()))));
}

Exports::Exports(Engine& engine, const Files& files, NoticeBar& notice, Preferences& preferences)
    : engine_(engine), files_(files), notice_(notice), preferences_(preferences) {
    connect(&engine_, &Engine::saved, this, &Exports::reportSaved);
}

void Exports::ask(exports::ExportContent wanted, const QString& extension) { askOf(wanted, false, extension); }

void Exports::setSelection(const std::vector<std::uint32_t>& cells) {
    selection_ = cells.empty() ? nullptr : std::make_shared<const std::vector<std::uint32_t>>(cells);
}

void Exports::askSelected() {
    if (selection_) return askOf(exports::ExportContent::FullCloud, true);
    notice_.showHint(tr("Nothing is selected yet: drag a box (B) or a lasso (L) over a view first."));
}

void Exports::askOf(exports::ExportContent wanted, bool selectedOnly, const QString& extension) {
    if (!engine_.picture()) {
        notice_.showHint(tr("There is nothing to export yet: open a scan first."));
        return;
    }
    emit asked();
    const std::shared_ptr<const edges::Detection> detection = engine_.picture()->detection;
    ExportDialog dialog(detection, wanted, {selection_, selectedOnly}, notice_.window());
    const auto targets = std::make_shared<const TargetList>(targets_ ? targets_() : TargetList());
    dialog.offerTargets(targets->size());
    std::vector<ExportDialog::Format> formats;
    for (const files::Format& each : files::formats()) {
        if (each.write == nullptr) continue;
        for (const char* end : each.writes) formats.push_back({filterOf(each, {end}), end, each.drawsEdges});
    }
    dialog.offerFormats(formats, extension.isEmpty() ? preferences_.text("export/extension", ".pcd") : extension);
    if (dialog.exec() != QDialog::Accepted) return;
    SaveQuestion question;
    question.title = exports::isCloud(dialog.content())                    ? tr("Export %1 points").arg(countText(dialog.count()))
                     : dialog.content() == exports::ExportContent::Targets ? tr("Export targets: %1").arg(targets->size())
                                                                           : tr("Export");
    question.extension = dialog.extension();
    exports::ExportOptions options = dialog.options();
    if (dialog.content() == exports::ExportContent::Targets) options.targets = targets;
    QString name = exportName(*detection, dialog.content(), options.frame);
    if (options.selection) name += "_selected";
    question.place = QDir(preferences_.folder("exports")).filePath(name + question.extension);
    question.filters = dialog.filters();
    question.files = withItsRecord;
    const QString path = askWhereToSave(notice_.window(), question);
    if (!path.isEmpty()) engine_.save(dialog.content(), path, options);
}

void Exports::reportSaved(exports::ExportContent what, const QString& path, qint64 count, const QString& coordinates) {
    preferences_.keepFolder("exports", path);
    if (exports::isCloud(what)) preferences_.keep("export/extension", "." + QFileInfo(path).suffix());
    notice_.showSaved(path, contentText(what, count), coordinates);
}

void Exports::askScreenshot(const QImage& image) {
    const QString time = QDateTime::currentDateTimeUtc().toString("yyyy-MM-dd'T'HHmmss'Z'");
    const QString path = askWhereToSave(
        notice_.window(),
        {tr("Save screenshot"), QDir(preferences_.folder("exports")).filePath("edgescan_" + time + ".png"), {tr("PNG picture (*.png)")}});
    if (path.isEmpty()) return;
    preferences_.keepFolder("exports", path);
    if (const Result<Done> written = saveScreenshot(image, path); !written)
        notice_.showError(written.error());
    else
        notice_.showSaved(path, tr("a picture of the window"));
}

Result<Done> Exports::saveScreenshot(const QImage& image, const QString& path) {
    return savePng(carry_ ? carry_(image, path) : image, path);
}

void Exports::copyCommand() {
    if (!engine_.picture() || engine_.picture()->detection->scan->path.empty()) return;
    const edges::Detection& detection = *engine_.picture()->detection;
    const QString path = absolutePath(exactText(detection.scan->path));
    // If it is not on the PATH: in the folder of this program.
    const QString beside = QCoreApplication::applicationDirPath() + "/edgescan-cli";
    const QString program = QStandardPaths::findExecutable("edgescan-cli").isEmpty() && QFileInfo::exists(beside) ? beside : "edgescan-cli";
    QGuiApplication::clipboard()->setText(
        exactText(edges::detectCommand(exactBytes(program), exactBytes(path), readingFlags(files_.options()), detection.settings)));
    notice_.showNotice(NoticeBar::Kind::Done, QGuiApplication::clipboard()->text());
}

} // namespace edgescan::ui

#include "moc_exports.cpp"
