// Exports, screenshots, and the command line that gives the same.
#include "ui/control/exports.h"

#include "core/base/whole_file.h"
#include "core/georef/placed_points.h"
#include "core/settings/command_text.h"
#include "ui/base/notice_bar.h"
#include "ui/control/file_filters.h"
#include "ui/control/files.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/session/memory.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDate>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <span>

namespace edgescan::ui {
namespace {

struct ContentNames {
    ExportContent content;
    const char* tail;   // of the file's name
    const char* things; // what is counted
};
constexpr std::array<ContentNames, 5> kNames{{{ExportContent::EdgeCloud, "edges", "edge points"},
                                              {ExportContent::FullCloud, "cloud", "points"},
                                              {ExportContent::EdgeImage, "edge-map", "cells"},
                                              {ExportContent::GrayImage, "gray", "cells"},
                                              {ExportContent::RangeImage, "range", "cells"}}};

const ContentNames& namesOf(ExportContent content) { return *std::ranges::find(kNames, content, &ContentNames::content); }

} // namespace

Result<Done> savePng(const QImage& image, const QString& path) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return writeWholeFile(path.toStdString(), std::as_bytes(std::span(png.constData(), static_cast<std::size_t>(png.size()))));
}

Exports::Exports(Session& session, const Files& files, NoticeBar& notice, Memory& memory)
    : session_(session), files_(files), notice_(notice), memory_(memory) {
    connect(&session_, &Session::saved, this, &Exports::tellSaved);
}

void Exports::ask(ExportContent wanted) {
    if (!session_.picture()) {
        notice_.showNotice(NoticeBar::Kind::Warning, tr("There is nothing to export yet: open a scan first."));
        return;
    }
    const std::shared_ptr<const Detection> detection = session_.picture()->detection;
    ExportDialog dialog(detection, wanted, notice_.window());
    if (dialog.exec() != QDialog::Accepted) return;
    const bool cloud = isCloud(dialog.content());
    const QString extension = cloud ? memory_.text("export/extension", ".pcd") : ".png";
    const QString name = QString("%1_%2_L%3_K%4_%5%6%7")
                             .arg(QString::fromStdString(detection->scan->name).replace(' ', '-'), namesOf(dialog.content()).tail)
                             .arg(detection->settings.lower)
                             .arg(detection->settings.kernel)
                             .arg(QDate::currentDate().toString(Qt::ISODate), cloud ? frameTail(dialog.options().frame) : "", extension);
    QStringList filters;
    QString usual;
    if (!cloud)
        filters << tr("PNG picture (*.png)");
    else
        for (const Format& each : formats()) {
            if (each.write == nullptr) continue;
            filters << filterOf(each, each.writes);
            if (each.writes.front() == extension) usual = filters.back();
        }
    const QString title = cloud ? tr("Export %1 points").arg(dialog.count()) : tr("Export");
    const QString place = QDir(memory_.folder(cloud ? "exports" : "images")).filePath(name);
    QString path = QFileDialog::getSaveFileName(notice_.window(), title, place, filters.join(";;"), &usual);
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += extension;
    session_.save(dialog.content(), path, dialog.options());
}

void Exports::tellSaved(ExportContent what, const QString& path, qint64 count) {
    memory_.keepFolder(isCloud(what) ? "exports" : "images", path);
    if (isCloud(what)) memory_.keep("export/extension", "." + QFileInfo(path).suffix());
    notice_.tellSaved(path, QString("%1 %2").arg(count).arg(namesOf(what).things));
}

void Exports::askScreenshot(const QImage& image) {
    QString path = QFileDialog::getSaveFileName(notice_.window(), tr("Save screenshot"),
                                                QDir(memory_.folder("images")).filePath("edgescan.png"), tr("PNG picture (*.png)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += ".png";
    memory_.keepFolder("images", path);
    if (const Result<Done> written = savePng(image, path); !written)
        notice_.tell(written.error());
    else
        notice_.showNotice(NoticeBar::Kind::Done, tr("Saved %1.").arg(path));
}

void Exports::copyCommand() {
    if (!session_.picture() || session_.picture()->detection->scan->path.empty()) return;
    const Detection& detection = *session_.picture()->detection;
    const QString path = QFileInfo(QString::fromStdString(detection.scan->path)).absoluteFilePath();
    // Beside this program where it is not on the PATH.
    const QString beside = QCoreApplication::applicationDirPath() + "/edgescan-cli";
    const QString program = QStandardPaths::findExecutable("edgescan-cli").isEmpty() && QFileInfo::exists(beside) ? beside : "edgescan-cli";
    QGuiApplication::clipboard()->setText(QString::fromStdString(
        detectCommand(program.toStdString(), path.toStdString(), readingFlags(files_.options()), detection.settings)));
    notice_.showNotice(NoticeBar::Kind::Done, QGuiApplication::clipboard()->text());
}

} // namespace edgescan::ui
