// The window's dialogs for files, and what goes to the clipboard.
#include "ui/main/main_window.h"

#include "core/base/whole_file.h"
#include "core/formats/formats.h"
#include "core/georef/placed_points.h"
#include "core/settings/command_text.h"
#include "ui/base/notice_bar.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/status_line.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDate>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

#include <QStandardPaths>
#include <QUrl>

#include <span>

namespace edgescan::ui {
namespace {

// One entry of a dialog, empty where a format has no extensions of that kind.
QString filterOf(const Format& format, const std::vector<const char*>& extensions) {
    QStringList patterns;
    for (const char* extension : extensions) patterns << QString("*") + extension;
    return patterns.isEmpty() ? QString() : QString("%1 (%2)").arg(format.title, patterns.join(' '));
}

// "All supported" first, then one entry per kind.
QString openFilters() {
    QStringList all;
    QStringList filters;
    for (const Format& format : formats()) {
        for (const char* extension : format.reads) all << QString("*") + extension;
        filters << filterOf(format, format.reads);
    }
    filters.removeAll(QString());
    return QObject::tr("All supported (%1)").arg(all.join(' ')) + ";;" + filters.join(";;") + ";;" + QObject::tr("All files (*)");
}

bool isImage(Session::Export what) { return what != Session::Export::EdgeCloud && what != Session::Export::FullCloud; }

const char* nameTail(Session::Export what) {
    switch (what) {
    case Session::Export::EdgeCloud:
        return "edges";
    case Session::Export::FullCloud:
        return "cloud";
    case Session::Export::EdgeImage:
        return "edge-map";
    case Session::Export::GrayImage:
        return "gray";
    case Session::Export::RangeImage:
        return "range";
    }
    return "";
}

} // namespace

void MainWindow::askOpen() {
    const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Open scan"), memory_.folder("scans"), openFilters());
    openSeries(paths);
}

void MainWindow::stepInSeries(int step) {
    const int place = seriesPlace_ + step;
    if (place < 0 || place >= series_.size()) {
        notice_->showNotice(NoticeBar::Kind::Warning,
                            step > 0 ? tr("This is the last file of the series.") : tr("This is the first file of the series."));
        return;
    }
    seriesPlace_ = place;
    session_.open(series_[place], openOptions_);
}

void MainWindow::askExport(Session::Export what) {
    if (!shown_) {
        notice_->showNotice(NoticeBar::Kind::Warning, tr("There is nothing to export yet: open a scan first."));
        return;
    }
    ExportDialog dialog(shown_->detection, contentOf(what), this);
    if (dialog.exec() != QDialog::Accepted) return;
    what = exportOf(dialog.content());
    const Detection& detection = *shown_->detection;
    const QString kind = isImage(what) ? "images" : "exports";
    const QString extension = isImage(what) ? ".png" : memory_.text("export/extension", ".pcd");
    const QString name =
        QString("%1_%2_L%3_K%4_%5%6%7")
            .arg(QString::fromStdString(detection.scan->name).replace(' ', '-'), nameTail(what))
            .arg(detection.settings.lower)
            .arg(detection.settings.kernel)
            .arg(QDate::currentDate().toString(Qt::ISODate), isImage(what) ? "" : frameTail(dialog.options().frame), extension);
    QStringList filters;
    QString usual;
    if (isImage(what))
        filters << tr("PNG picture (*.png)");
    else
        for (const Format& each : formats()) {
            if (each.write == nullptr) continue;
            filters << filterOf(each, each.writes);
            if (each.writes.front() == extension) usual = filters.back();
        }
    const QString title = isImage(what) ? tr("Export") : tr("Export %1 points").arg(dialog.count());
    QString path = QFileDialog::getSaveFileName(this, title, QDir(memory_.folder(kind)).filePath(name), filters.join(";;"), &usual);
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += extension;
    session_.save(what, path, dialog.options());
}

void MainWindow::tellSaved(Session::Export what, const QString& path, qint64 count) {
    memory_.keepFolder(isImage(what) ? "images" : "exports", path);
    if (!isImage(what)) memory_.keep("export/extension", "." + QFileInfo(path).suffix());
    memory_.write();
    const char* things = what == Session::Export::EdgeCloud ? "edge points" : what == Session::Export::FullCloud ? "points" : "cells";
    notice_->showNotice(NoticeBar::Kind::Done,
                        tr("Saved %1: %2 %3, %4 kB.").arg(path).arg(count).arg(things).arg((QFileInfo(path).size() + 999) / 1000));
    notice_->offer(tr("Open folder"), [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath())); });
}

void MainWindow::askOpenPreset() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open preset"), memory_.folder("presets"), tr("EdgeScan presets (*.json)"));
    if (path.isEmpty()) return;
    memory_.keepFolder("presets", path);
    const Result<Preset> preset = findPreset(path.toStdString());
    if (preset)
        usePreset(*preset);
    else
        notice_->showNotice(NoticeBar::Kind::Error, QString::fromStdString(preset.error().sentence()));
}

void MainWindow::askSavePreset() {
    QString path = QFileDialog::getSaveFileName(this, tr("Save preset"), memory_.folder("presets"), tr("EdgeScan presets (*.json)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += ".json";
    memory_.keepFolder("presets", path);
    const Preset preset{QFileInfo(path).completeBaseName().toStdString(), "", session_.settings(), path.toStdString()};
    const Result<Done> written = writeWholeFile(path.toStdString(), presetText(preset));
    if (written)
        usePreset(preset);
    else
        notice_->showNotice(NoticeBar::Kind::Error, QString::fromStdString(written.error().sentence()));
}

void MainWindow::saveScreenshot() {
    QString path = QFileDialog::getSaveFileName(this, tr("Save screenshot"), QDir(memory_.folder("images")).filePath("edgescan.png"),
                                                tr("PNG picture (*.png)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += ".png";
    memory_.keepFolder("images", path);
    if (const Result<Done> written = saveScreenshotTo(path); !written) {
        notice_->showNotice(NoticeBar::Kind::Error, QString::fromStdString(written.error().sentence()));
        return;
    }
    notice_->showNotice(NoticeBar::Kind::Done, tr("Saved %1.").arg(path));
}

Result<Done> MainWindow::saveScreenshotTo(const QString& path) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    screenshot().save(&buffer, "PNG");
    return writeWholeFile(path.toStdString(), std::as_bytes(std::span(png.constData(), static_cast<std::size_t>(png.size()))));
}

void MainWindow::copyProbe() { QGuiApplication::clipboard()->setText(status_->probeShown()); }

void MainWindow::copyCommand() {
    if (!shown_ || shown_->detection->scan->path.empty()) return;
    const QString path = QFileInfo(QString::fromStdString(shown_->detection->scan->path)).absoluteFilePath();
    // Beside this program where it is not on the PATH.
    const QString beside = QCoreApplication::applicationDirPath() + "/edgescan-cli";
    const QString program = QStandardPaths::findExecutable("edgescan-cli").isEmpty() && QFileInfo::exists(beside) ? beside : "edgescan-cli";
    QGuiApplication::clipboard()->setText(QString::fromStdString(
        detectCommand(program.toStdString(), path.toStdString(), readingFlags(openOptions_), shown_->detection->settings)));
    notice_->showNotice(NoticeBar::Kind::Done, QGuiApplication::clipboard()->text());
}

} // namespace edgescan::ui
