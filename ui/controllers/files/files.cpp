// Opens files, a series of files, and the same file again.
#include "ui/controllers/files/files.h"

#include "core/files/open_save/pose_sidecar.h"
#include "core/files/point_tables/repeated_values.h"
#include "core/scan/angle_correction/straighten_scan.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/file_filters.h"
#include "ui/controllers/files/source.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/reading_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QUrl>

#include <algorithm>
#include <filesystem>
#include <unistd.h>

namespace edgescan::ui {
namespace {

constexpr const char* kNoFile =
    QT_TRANSLATE_NOOP("QObject", "There is no file on the screen that could be read in another way: open one first.");

/// A file next to a scan that is not a scan: a record, a pose, edits of rocks.
bool isSidecar(const std::string& name) {
    return name.ends_with(".provenance.json") || name.ends_with(".rocks.json") || files::isPoseSidecar(name);
}

constexpr int kWrittenMs = 500;

/// The file and, of a raw grid, that of its numbers; none if the file is not there.
std::vector<std::filesystem::path> filesOf(const QString& path) {
    std::vector<std::filesystem::path> all;
    std::filesystem::path file = exactBytes(path);
    for (const std::filesystem::path& each :
         {file, file.extension() == ".json" ? file.replace_extension(".u16") : std::filesystem::path()}) {
        std::error_code none;
        if (each.empty() || !std::filesystem::is_regular_file(each, none)) break;
        all.push_back(each);
    }
    return all;
}

/// Their sizes and times; empty: there is none.
std::string stampOf(const QString& path) {
    std::string stamp;
    std::error_code none;
    for (const std::filesystem::path& each : filesOf(path)) {
        stamp += std::to_string(std::filesystem::file_size(each, none)) + " " +
                 std::to_string(std::filesystem::last_write_time(each, none).time_since_epoch().count()) + " ";
    }
    return stamp;
}

/// For a dialog: without the sidecars.
class WithoutSidecars : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        return !isSidecar(exactBytes(sourceModel()->index(row, 0, parent).data(QFileSystemModel::FileNameRole).toString()));
    }
};

/// The scans in its folder, by name, including the file itself; other files of a scan (records, settings) are skipped.
QStringList scansInFolder(const QString& path) {
    QStringList patterns;
    for (const files::Format& format : files::formats()) {
        for (const char* extension : format.reads) patterns << QString("*") + extension;
    }
    namespace fs = std::filesystem;
    const fs::path own = exactBytes(absolutePath(path));
    QStringList names;
    std::error_code problem;
    for (fs::directory_iterator entry(own.parent_path(), problem); !problem && entry != fs::directory_iterator();
         entry.increment(problem)) {
        const std::string name = entry->path().filename().string();
        std::error_code gone;
        if (name.starts_with('.') || !entry->is_regular_file(gone) || ::access(entry->path().c_str(), R_OK) != 0) continue;
        if (!QDir::match(patterns, exactText(name))) continue;
        // A raw grid is a description and a file of numbers: the opened one of both counts.
        const bool part = entry->path().extension() == ".u16" || isSidecar(name);
        if (!part || entry->path().filename() == own.filename()) names << exactText(name);
    }
    names.sort();
    for (QString& name : names) name = exactText((own.parent_path() / exactBytes(name)).string());
    return names;
}

} // namespace

Files::Files(Engine& engine, NoticeBar& notice, Preferences& preferences, QUndoStack& undo)
    : engine_(engine), notice_(notice), preferences_(preferences), undo_(undo) {
    connect(&engine_, &Engine::opened, this, &Files::noteOpened);
    // A refused or cancelled reading leaves the screen with the former options.
    connect(&engine_, &Engine::workEnded, this, [this] {
        if (!engine_.opening()) setOptions(shownOptions_);
    });
    connect(&engine_, &Engine::streamChanged, this, &Files::showWarnings);
    connect(&engine_, &Engine::refused, this, &Files::offerReading);
    written_.setSingleShot(true);
    written_.setInterval(kWrittenMs);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, &written_, qOverload<>(&QTimer::start));
    connect(&written_, &QTimer::timeout, this, &Files::lookOnDisk);
    connect(&notice_, &NoticeBar::closed, this, [this](const QString& text) {
        if (text == warned_.second) read_.insert(warned_.first);
    });
}

void Files::open(const QStringList& paths, const ReadingOptions& options) {
    if (paths.isEmpty()) return;
    series_ = paths;
    place_ = 0;
    setOptions(options);
    engine_.open(paths.front(), options);
}

void Files::openDemo(bool afterBlast) {
    series_.clear();
    setOptions({});
    wantedDemo_ = afterBlast;
    engine_.openDemo(afterBlast);
}

void Files::openAgain(const inspect::SessionScan& scan) {
    if (inspect::hasPath(scan.kind))
        open({exactText(scan.path.string())}, scan.reading);
    else
        openDemo(scan.kind == inspect::SessionScan::Kind::DemoAfterBlast);
}

// "All supported" first, then one filter per kind.
QString Files::filters() {
    QStringList all;
    QStringList filters;
    for (const files::Format& format : files::formats()) {
        for (const char* extension : format.reads) all << QString("*") + extension;
        filters << filterOf(format, format.reads);
    }
    filters.removeAll(QString());
    all << "*.gz"
        << "metadata.yaml"; // any of them packed; the bag of a folder
    return tr("All supported (%1)").arg(all.join(' ')) + ";;" + filters.join(";;") + ";;" + tr("All files (*)");
}

namespace {

QStringList askPaths(QWidget* parent, const QString& title, const Preferences& preferences, QFileDialog::FileMode mode) {
    QFileDialog dialog(parent, title, preferences.folder("scans"), Files::filters());
    dialog.setFileMode(mode);
    dialog.setProxyModel(new WithoutSidecars(&dialog));
    const QList<QUrl> usual = dialog.sidebarUrls();
    QList<QUrl> places = usual;
    const QString recordings = preferences.recordingFolder();
    const QUrl place = QUrl::fromLocalFile(recordings);
    if (QFileInfo(recordings).isDir() && !places.contains(place)) places << place;
    dialog.setSidebarUrls(places);
    const bool chosen = dialog.exec() == QDialog::Accepted;
    dialog.setSidebarUrls(usual); // Qt stores them for every program
    return chosen ? dialog.selectedFiles() : QStringList();
}

} // namespace

QStringList Files::askScans(QWidget* parent, const QString& title, const Preferences& preferences) {
    return askPaths(parent, title, preferences, QFileDialog::ExistingFiles);
}

QString Files::askScan(QWidget* parent, const QString& title, const Preferences& preferences) {
    return askPaths(parent, title, preferences, QFileDialog::ExistingFile).value(0);
}

void Files::ask() { emit chosen(askScans(notice_.window(), tr("Open scan"), preferences_)); }

void Files::reload() {
    if (!path_.isEmpty()) engine_.open(path_, options_);
}

void Files::step(int files) {
    if (series_.size() <= 1 && !path_.isEmpty()) { // one file was opened: its folder is the series
        const QStringList inFolder = scansInFolder(path_);
        const auto own = static_cast<int>(inFolder.indexOf(absolutePath(path_)));
        if (own >= 0) {
            series_ = inFolder;
            place_ = own;
        }
    }
    const int place = place_ + files;
    if (place < 0 || place >= series_.size()) {
        notice_.showNotice(NoticeBar::Kind::Warning, files > 0 ? tr("This is the last scan of the series or folder.")
                                                               : tr("This is the first scan of the series or folder."));
        return;
    }
    place_ = place;
    engine_.open(series_[place], options_);
}

void Files::setOptions(const ReadingOptions& options) {
    options_ = options;
    emit optionsChanged(options);
}

void Files::straighten(bool wanted) {
    readWith(&ReadingOptions::straighten, wanted, wanted ? stepName("Straighten Beams") : stepName("Beams as Recorded"));
}

void Files::keepRepeated(bool wanted) {
    readWith(&ReadingOptions::keepRepeated, wanted, wanted ? stepName("Keep Repeated Values") : stepName("Repeated Values as No Return"));
}

void Files::readWith(bool ReadingOptions::*option, bool wanted, const QString& what) {
    if (path_.isEmpty()) {
        emit optionsChanged(options_); // the menu shows what holds
        return notice_.showHint(QObject::tr(kNoFile));
    }
    ReadingOptions options = options_;
    options.*option = wanted;
    readAgain(options, what);
}

void Files::readAgain(const ReadingOptions& options, const QString& what) { readAgain(options, what, options_); }

void Files::readAgain(const ReadingOptions& options, const QString& what, const ReadingOptions& before) {
    auto* step = new UndoStep<ReadingOptions>(what, before, options,
                                              [this, path = path_](const ReadingOptions& value) { return readAs(path, value); });
    step->giveWayIn(undo_);
    undo_.push(step);
}

bool Files::readAs(const QString& path, const ReadingOptions& options) {
    if (path != path_) return false;
    setOptions(options);
    reload();
    return true;
}

/// What a refusal asks for can be given at once.
void Files::offerReading(const QString& path) {
    if (std::error_code none; !std::filesystem::is_regular_file(exactBytes(path), none)) return;
    refused_ = {path, options_};
    notice_.offer(tr("Read it in another way…"), [this] { askRefused(); });
}

void Files::askRefused() {
    const auto [path, options] = refused_;
    ReadingDialog dialog(options, notice_.window());
    if (dialog.exec() == QDialog::Accepted) open({path}, dialog.options());
}

void Files::askReading() {
    if (path_.isEmpty() && !refused_.first.isEmpty()) return askRefused();
    if (path_.isEmpty()) return notice_.showHint(QObject::tr(kNoFile));
    ReadingDialog dialog(options_, notice_.window());
    if (dialog.exec() == QDialog::Accepted) readAgain(dialog.options(), stepName("How the Scan Is Read"));
}

void Files::leave() {
    series_.clear();
    path_.clear();
    watch({});
    demo_.reset();
    shownOptions_ = {};
    setOptions({});
    notice_.hide();
}

void Files::noteOpened(const QString& path) {
    path_ = path;
    refused_.first.clear();
    watch(path);
    demo_ = path.isEmpty() ? std::optional(wantedDemo_) : std::nullopt;
    shownOptions_ = options_;
    notice_.hide();
    if (path.isEmpty()) return;
    preferences_.keepRecentFile(path);
    preferences_.keepFolder("scans", path);
}

void Files::watch(const QString& path) {
    if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
    written_.stop();
    stamp_ = path.isEmpty() ? std::string() : stampOf(path);
    for (const std::filesystem::path& each : filesOf(path)) watcher_.addPath(exactText(each.string()));
}

void Files::lookOnDisk() {
    const std::string now = stampOf(path_);
    if (now == stamp_) return;
    const QString name = shownName(QFileInfo(path_).fileName());
    watch(path_); // a replaced file is another one for the watcher
    if (now.empty())
        return notice_.showNotice(NoticeBar::Kind::Warning, tr("%1 was moved or removed. Its picture stays on the screen.").arg(name));
    notice_.showNotice(NoticeBar::Kind::Warning, tr("%1 was written again. The picture shows what was in it before.").arg(name));
    notice_.offer(tr("Read again"), [this] { reload(); });
}

void Files::showWarnings() {
    const Picture& picture = *engine_.picture();
    const Scan& scan = *picture.detection->scan;
    QStringList warnings = warningsOf(picture);
    const QFileInfo pose(QFileInfo(path_).path() + '/' + QFileInfo(path_).completeBaseName() + ".pose");
    if (path_.endsWith(".3d") && pose.isFile())
        warnings << tr("%1, a pose of 3DTK, is not read with the scan: type the place of the scanner at Scan > Pose and Mounting.")
                        .arg(shownName(pose.fileName()));
    // The health strip reports the warnings of a live scan.
    if (warnings.isEmpty() || picture.source.growth.growing) return;
    const QString about = path_ + '\n' + warnings.join("\n");
    if (read_.contains(about)) return; // closed before; the status bar has them
    notice_.showNotice(NoticeBar::Kind::Warning, warnings.join("\n"));
    warned_ = {about, notice_.text()};
    if (std::ranges::any_of(scan.warnings, isDisplacementWarning) && !path_.isEmpty())
        notice_.offer(tr("Straighten beams"), [this] { straighten(true); });
    else if (std::ranges::any_of(scan.warnings, files::isRepeatedWarning) && !path_.isEmpty())
        notice_.offer(tr("Keep as measured"), [this] { keepRepeated(true); });
}

void Files::fillRecent(QMenu& menu) {
    menu.clear();
    const QStringList files = preferences_.recentFiles();
    for (const QString& path : files) {
        QAction* action = menu.addAction(shownName(QFileInfo(path).fileName() + "  -  " + QFileInfo(path).path()).replace('&', "&&"), this,
                                         [this, path] { open({path}); });
        action->setEnabled(isFile(path));
    }
    if (files.isEmpty()) menu.addAction(tr("No file yet; demos are not listed"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(tr("Clear"), this, [this] { preferences_.forgetRecentFiles(); });
}

std::optional<inspect::SessionScan> Files::scanShown(const Scan& scan) const {
    if (path_.isEmpty() && !demo_) return std::nullopt;
    inspect::SessionScan of = inspect::fileScan(exactBytes(path_), options_, inspect::notebookScan(scan));
    if (demo_) of.kind = *demo_ ? inspect::SessionScan::Kind::DemoAfterBlast : inspect::SessionScan::Kind::Demo;
    return of;
}

QString Files::placeInSeries() const { return series_.size() > 1 ? tr(" (%1 of %2)").arg(place_ + 1).arg(series_.size()) : QString(); }

} // namespace edgescan::ui

#include "moc_files.cpp"
