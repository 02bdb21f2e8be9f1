// Saving and opening sessions.
#include "ui/controllers/sessions/sessions.h"

#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "ui/base/notice_bar.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/confidence.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/live.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/sessions/session_store.h"
#include "ui/controllers/targets/marked_edges.h"
#include "ui/controllers/targets/selection.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/in_background.h"
#include "ui/engine/worker_bridge/memory.h"
#include "ui/panels/keys/commands.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QUndoStack>
#include <QWidget>

#include <system_error>

namespace edgescan::ui {
namespace {

constexpr int kSaveSoonMs = 400; // that much is lost at most when the program is killed

QString filterOfSittings() { return Sittings::tr("EdgeScan sessions (*%1)").arg(kSittingEnding); }

std::filesystem::path folderOf(const QString& path) { return QFileInfo(path).absolutePath().toStdString(); }

bool isSame(const NotebookScan& a, const NotebookScan& b) {
    return a.sha256 == b.sha256 && a.name == b.name && a.lines == b.lines && a.beams == b.beams;
}

} // namespace

Sittings::Sittings(const Desk& desk)
    : desk_(desk), autosaves_(desk.memory.ownFolder().isEmpty() ? QString() : desk.memory.ownFolder() + "/sessions"),
      worker_(
          this, [this](const Job& job) { return write(job); }, [this](const Written& written) { take(written); },
          [this](const QString& what) {
              answered_ = posted_;
              desk_.notice.showNotice(NoticeBar::Kind::Warning, tr("The session is not saved (%1).").arg(what));
          }) {
    soon_.setSingleShot(true);
    soon_.setInterval(kSaveSoonMs);
    connect(&soon_, &QTimer::timeout, this, &Sittings::save);
    connectDesk();
}

Sittings::~Sittings() {
    if (soon_.isActive() || posted_ != answered_) {
        if (const auto last = job()) {
            for (const QString& path : {last->own, last->file}) {
                if (!path.isEmpty())
                    (void)writeWholeFile(path.toStdString(), sittingText(last->sitting, folderOf(path), utcText(utcNow())));
            }
        }
    }
    autosaves_.end();
}

void Sittings::connectDesk() {
    const auto follow = [this](auto* sender, auto signal) { connect(sender, signal, this, &Sittings::changed); };
    follow(&desk_.session, &Session::pictureReady);
    follow(&desk_.session, &Session::settingsChanged);
    follow(&desk_.undo, &QUndoStack::indexChanged);
    follow(&desk_.views, &LinkedViews::pinChanged);
    follow(&desk_.selection, &Selection::changed);
    follow(&desk_.rocks, &Rocks::changed);
    follow(&desk_.rocks, &Rocks::shownChanged);
    follow(&desk_.rocks, &Rocks::rocksShown);
    follow(&desk_.marked, &MarkedEdges::changed);
    follow(&desk_.comparing, &Comparing::keptChanged);
    follow(&desk_.comparing, &Comparing::rowsChanged);
    follow(&desk_.confidence, &Confidence::changed);
    follow(&desk_.look, &ScanLook::changed);
    follow(&desk_.views, &LinkedViews::rangeWindowChanged);
    follow(&desk_.live.scanner(), &ScannerLink::recordingChanged);
    follow(&desk_.live.scanner(), &ScannerLink::written);
    follow(&desk_.views.cloud(), &CloudView::frameDrawn);
    follow(desk_.views.gray().viewPort().get(), &ViewPort::changed);
    for (QAction* action : desk_.window.actions()) {
        if (action->property(kInSessions).isValid()) follow(action, &QAction::toggled);
    }
    connect(&desk_.session, &Session::streamChanged, this, &Sittings::followStream);
    connect(&desk_.session, &Session::failed, this, [this](const QString& sentence) {
        if (wanted_ && !desk_.session.opening()) askForPlace(sentence);
    });
}

void Sittings::changed() {
    if (!soon_.isActive() && !wanted_ && !reading_) soon_.start();
}

std::optional<Sittings::Job> Sittings::job() {
    if (wanted_ || reading_) return std::nullopt; // what is on the screen is not it yet
    auto sitting = taken(desk_);
    if (!sitting) return std::nullopt;
    sitting->keptIn = file_.toStdString();
    if (autosaves_.own().isEmpty() && file_.isEmpty()) return std::nullopt;
    const bool closed = sitting->scan.kind == SittingScan::Kind::Recording && desk_.live.scanner().recordingClosed();
    return Job{std::move(*sitting), autosaves_.own(), file_, closed, ++posted_};
}

void Sittings::save() {
    if (auto next = job()) worker_.post(std::move(*next));
}

Sittings::Written Sittings::write(const Job& job) {
    Written written{job.number, {}};
    std::string hash;
    if (job.closed) {
        std::string& known = hashes_[job.sitting.scan.path];
        if (known.empty()) {
            if (auto of = sha256OfFile(job.sitting.scan.path)) known = *of;
        }
        hash = known;
    }
    for (const QString& path : {job.own, job.file}) {
        if (path.isEmpty()) continue;
        Sitting sitting = job.sitting;
        if (job.closed) sitting.scan.identity.sha256 = hash;
        if (path == job.file) sitting.keptIn.clear();
        std::string text = sittingText(sitting, folderOf(path), {});
        if (const auto last = lastTexts_.find(path); last != lastTexts_.end() && last->second == text) continue;
        const auto done = writeWholeFile(path.toStdString(), sittingText(sitting, folderOf(path), utcText(utcNow())));
        if (done)
            lastTexts_[path] = std::move(text);
        else
            written.trouble = exactText(done.error().sentence());
    }
    return written;
}

void Sittings::take(const Written& written) {
    answered_ = written.number;
    if (!written.trouble.isEmpty() && !failing_)
        desk_.notice.showNotice(NoticeBar::Kind::Warning, tr("▲ The session is not saved: %1").arg(written.trouble));
    failing_ = !written.trouble.isEmpty();
    if (!toTell_ || answered_ < *toTell_) return;
    toTell_.reset();
    if (!failing_ && !file_.isEmpty()) desk_.notice.tellSaved(file_, tr("from now on saved as it changes"));
}

void Sittings::saveAs(const QString& path) {
    const auto sitting = taken(desk_);
    if (!sitting) {
        desk_.notice.showNotice(NoticeBar::Kind::Warning,
                                tr("There is nothing to save yet: open a scan first. A live sweep is kept by recording it."));
        return;
    }
    file_ = QFileInfo(path).absoluteFilePath();
    filed_ = sitting->scan.identity;
    save();
    toTell_ = posted_;
    emit nameChanged();
}

void Sittings::askSaveAs() {
    if (!taken(desk_)) return saveAs({});
    const QString scan = QFileInfo(desk_.files.path().isEmpty() ? "demo" : desk_.files.path()).completeBaseName();
    SaveQuestion question{tr("Save session"), QDir(desk_.memory.folder("sessions")).filePath(scan + kSittingEnding), {filterOfSittings()}};
    question.keeps = [](const QString& there) {
        return readSitting(there.toStdString()) ? QString() : tr("%1 is no session and stays as it is: choose another name.").arg(there);
    };
    const QString path = askWhereToSave(desk_.notice.window(), question);
    if (path.isEmpty()) return;
    desk_.memory.keepFolder("sessions", path);
    saveAs(path);
}

void Sittings::ask() {
    const QString path = QFileDialog::getOpenFileName(desk_.notice.window(), tr("Open session"), desk_.memory.folder("sessions"),
                                                      filterOfSittings() + ";;" + tr("Screenshots (*.png)"));
    if (path.isEmpty()) return;
    desk_.memory.keepFolder("sessions", path);
    openSession(path);
}

void Sittings::openSession(const QString& path) { open({path}); }

void Sittings::open(const QStringList& paths, const ReadingOptions& options) {
    if (paths.isEmpty()) return;
    const QString first = paths.front();
    if (!isSittingName(first) && !first.endsWith(".png", Qt::CaseInsensitive)) return desk_.files.open(paths, options);
    reading_ = true;
    inBackground(
        this,
        [this, paths, options, first, number = ++readings_]() -> std::function<void()> {
            auto read = sittingOf(first);
            if (read && *read) { // those that are there
                std::error_code none;
                std::erase_if((*read)->places, [&](const std::filesystem::path& place) { return !std::filesystem::exists(place, none); });
            }
            return [this, paths, options, first, number, read = std::move(read)] {
                if (number != readings_) return;
                reading_ = false;
                if (!read)
                    desk_.files.open(paths, options);
                else if (!*read)
                    desk_.notice.tell(read->error());
                else
                    restore(**read, isSittingName(first) ? first : QString());
            };
        },
        [this](const QString& what) {
            reading_ = false;
            desk_.notice.showNotice(NoticeBar::Kind::Error, what);
        });
}

void Sittings::restore(ReadSitting read, const QString& file) {
    wanted_ = std::move(read);
    // One that was saved by itself goes on in the file that the person gave it.
    const bool byItself = QFileInfo(file).absolutePath() == QFileInfo(autosaves_.own()).absolutePath() && !file.isEmpty();
    wantedFile_ = byItself ? exactText(wanted_->sitting.keptIn.string()) : file;
    autosaves_.takenUp(file);
    place_ = 0;
    file_.clear();
    desk_.undo.clear();
    layOut(desk_, wanted_->sitting);
    openNextPlace();
}

void Sittings::openNextPlace() {
    const SittingScan& scan = wanted_->sitting.scan;
    if (!hasPath(scan.kind)) return desk_.files.openDemo(scan.kind == SittingScan::Kind::DemoAfterBlast);
    if (place_ < wanted_->places.size()) return desk_.files.open({exactText(wanted_->places[place_].string())}, scan.reading);
    askForPlace(tr("%1: the scan of this session is not there: it was moved, or its disk is not here. Settings and view are back; the rest "
                   "comes with the scan.")
                    .arg(shownName(exactText(scan.path.string()))));
}

void Sittings::askForPlace(const QString& sentence) {
    desk_.notice.showNotice(NoticeBar::Kind::Warning, sentence);
    desk_.notice.offer(tr("Locate…"), [this] {
        const QString path = QFileDialog::getOpenFileName(desk_.notice.window(), tr("Where is the scan now?"), desk_.memory.folder("scans"),
                                                          Files::filters());
        if (!path.isEmpty()) locate(path);
    });
}

void Sittings::locate(const QString& path) {
    if (!wanted_) return;
    wanted_->places = {path.toStdString()};
    place_ = 0;
    openNextPlace();
}

/// Another scan is on the screen: the one that a session waits for, or one that has nothing to do with it.
void Sittings::followStream() {
    if (!wanted_) {
        if (!file_.isEmpty() && !isSame(filed_, notebookScan(*desk_.session.picture()->detection->scan))) {
            if (desk_.notice.isHidden())
                desk_.notice.showNotice(
                    NoticeBar::Kind::Done,
                    tr("The session %1 stays as it was: this is another scan.").arg(shownName(QFileInfo(file_).fileName())));
            file_.clear();
            emit nameChanged();
        }
        return;
    }
    const bool isFile = hasPath(wanted_->sitting.scan.kind);
    if (isFile && (place_ >= wanted_->places.size() || desk_.files.path().toStdString() != wanted_->places[place_].string())) {
        wanted_.reset(); // somebody opened another scan meanwhile
        return;
    }
    if (!isShown(desk_, wanted_->sitting.scan)) {
        if (isFile && ++place_ < wanted_->places.size()) return openNextPlace();
        askForPlace(tr("%1 is not the scan of this session: its content is another one. Settings and view are back; targets, selection, "
                       "marks, rocks, A and the camera are not.")
                        .arg(shownName(exactText(desk_.session.picture()->detection->scan->name))));
        return;
    }
    const ReadSitting read = std::move(*std::exchange(wanted_, std::nullopt));
    layOutOnScan(desk_, read.sitting);
    file_ = wantedFile_;
    filed_ = notebookScan(*desk_.session.picture()->detection->scan);
    emit nameChanged();
    changed();
}

QString Sittings::toGoOn() const {
    const QStringList left = autosaves_.leftBehind();
    return left.isEmpty() ? autosaves_.last() : left.front();
}

void Sittings::goOn() {
    const QString path = toGoOn();
    if (!path.isEmpty()) return openSession(path);
    desk_.notice.showNotice(NoticeBar::Kind::Warning, tr("There is no session to go on with yet: open a scan first."));
}

void Sittings::offerToGoOn() {
    const QStringList left = autosaves_.leftBehind();
    if (left.isEmpty()) return;
    desk_.notice.showNotice(NoticeBar::Kind::Warning, tr("EdgeScan ended without being closed. What was on the screen is kept."));
    desk_.notice.offer(tr("Go on where I was"), [this, path = left.front()] { openSession(path); });
}

std::string Sittings::textFor(const QString& folder) const {
    const auto sitting = taken(desk_);
    return sitting ? sittingText(*sitting, QDir(folder).absolutePath().toStdString(), utcText(utcNow())) : std::string();
}

} // namespace edgescan::ui
