// Opening files, one after the other and again.
#include "ui/control/files.h"

#include "core/georef/placed_points.h"
#include "core/straighten/straighten_scan.h"
#include "ui/base/notice_bar.h"
#include "ui/control/file_filters.h"
#include "ui/session/memory.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include <algorithm>

namespace edgescan::ui {
namespace {

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

} // namespace

Files::Files(Session& session, NoticeBar& notice, Memory& memory) : session_(session), notice_(notice), memory_(memory) {
    connect(&session_, &Session::opened, this, &Files::noteOpened);
    connect(&session_, &Session::streamChanged, this, &Files::tellWarnings);
}

void Files::open(const QStringList& paths, const ReadingOptions& options) {
    if (paths.isEmpty()) return;
    series_ = paths;
    place_ = 0;
    setOptions(options);
    session_.open(paths.front(), options);
}

void Files::openDemo() {
    series_.clear();
    setOptions({});
    session_.openDemo();
}

void Files::ask() { open(QFileDialog::getOpenFileNames(notice_.window(), tr("Open scan"), memory_.folder("scans"), openFilters())); }

void Files::reload() {
    if (!path_.isEmpty()) session_.open(path_, options_);
}

void Files::step(int files) {
    const int place = place_ + files;
    if (place < 0 || place >= series_.size()) {
        notice_.showNotice(NoticeBar::Kind::Warning,
                           files > 0 ? tr("This is the last file of the series.") : tr("This is the first file of the series."));
        return;
    }
    place_ = place;
    session_.open(series_[place], options_);
}

void Files::setOptions(const ReadingOptions& options) {
    options_ = options;
    emit straightened(options.straighten);
}

void Files::straighten(bool wanted) {
    if (path_.isEmpty()) {
        emit straightened(false);
        notice_.showNotice(NoticeBar::Kind::Warning,
                           tr("There is no file on the screen whose beams could be straightened: open one first."));
        return;
    }
    options_.straighten = wanted;
    emit straightened(wanted);
    reload();
}

void Files::leave() {
    series_.clear();
    path_.clear();
    setOptions({});
    notice_.hide();
}

void Files::noteOpened(const QString& path) {
    path_ = path;
    notice_.hide();
    if (path.isEmpty()) return;
    memory_.keepRecentFile(path);
    memory_.keepFolder("scans", path);
}

void Files::tellWarnings() {
    const Picture& picture = *session_.picture();
    const Scan& scan = *picture.detection->scan;
    QStringList warnings;
    for (const std::string& warning : scan.warnings) warnings << QString::fromStdString(warning);
    for (const std::string& warning : placeWarnings(scan)) warnings << QString::fromStdString(warning);
    // Of a live scan the health strip tells.
    if (warnings.isEmpty() || picture.source.growth.growing) return;
    notice_.showNotice(NoticeBar::Kind::Warning, warnings.join("\n"));
    if (std::ranges::any_of(scan.warnings, tellsOfDisplacement) && !path_.isEmpty())
        notice_.offer(tr("Straighten beams"), [this] { straighten(true); });
}

void Files::fillRecent(QMenu& menu) {
    menu.clear();
    const QStringList files = memory_.recentFiles();
    for (const QString& path : files) {
        QAction* action =
            menu.addAction(QFileInfo(path).fileName() + "  -  " + QFileInfo(path).path(), this, [this, path] { open({path}); });
        action->setEnabled(QFileInfo::exists(path));
    }
    if (files.isEmpty()) menu.addAction(tr("No file yet"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(tr("Clear"), this, [this] { memory_.forgetRecentFiles(); });
}

QString Files::placeInSeries() const { return series_.size() > 1 ? tr(" (%1 of %2)").arg(place_ + 1).arg(series_.size()) : QString(); }

} // namespace edgescan::ui
