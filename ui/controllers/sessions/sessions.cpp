// Saves and opens sessions.
#include "ui/controllers/sessions/sessions.h"

#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/base/whole_file.h"
#include "core/scan/grid/scan_time.h"
#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/save_question.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/live.h"
#include "ui/controllers/sessions/session_in_picture.h"
#include "ui/engine/worker_bridge/in_background.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/live/timeline.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QUndoStack>
#include <QWidget>

#include <system_error>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kSaveSoonMs = 400; // maximum loss when the program is killed

// The first is the usual one: scans and records of exports are JSON files too. A name that ends in .json stays as it was typed; one without
// an ending gets that of the first.
QStringList filtersOfSessions() {
    return {Sessions::tr("EdgeScan sessions (*%1)").arg(inspect::kSessionEnding), Sessions::tr("JSON files (*.json)")};
}

std::filesystem::path folderOf(const QString& path) { return exactBytes(QFileInfo(absolutePath(path)).path()); }

} // namespace

Sessions::Sessions(Engine& engine, Files& files, Live& live, NoticeBar& notice, Preferences& preferences, QUndoStack& undo,
                   std::vector<StatePart> parts)
    : engine_(engine), files_(files), live_(live), notice_(notice), preferences_(preferences), undo_(undo), parts_(std::move(parts)),
      autosaves_(preferences.dataFolder().isEmpty() ? QString() : preferences.dataFolder() + "/sessions"),
      written_(
          Urgency::Soon, [this](const Job& job) { return write(job); }, // the hash of a closed recording may take seconds
          [this](const Job&, const std::shared_ptr<const QString>& trouble) { finishSaving(*trouble); },
          [this](const QString& what) { notice_.showNotice(NoticeBar::Kind::Warning, tr("The session is not saved (%1).").arg(what)); },
          Older::Delivered) {
    soon_.setSingleShot(true);
    soon_.setInterval(kSaveSoonMs);
    connect(&soon_, &QTimer::timeout, this, &Sessions::save);
    const auto change = [this] { changed(); };
    for (const StatePart& part : parts_) {
        if (part.follow) part.follow(*this, change);
    }
    changesOf(engine_, &Engine::pictureReady, &Engine::settingsChanged)(*this, change);
    changesOf(undo_, &QUndoStack::indexChanged)(*this, change);
    changesOf(live_.scanner(), &ScannerLink::recordingChanged, &ScannerLink::written)(*this, change);
    connect(&engine_, &Engine::streamChanged, this, &Sessions::followStream);
    connect(&live_.timeline(), &Timeline::loaded, this, [this] {
        if (nextSweep_) lookInNextSweep();
    });
    connect(&live_.timeline(), &Timeline::arrived, this, &Sessions::lookAt);
    connect(&engine_, &Engine::pictureReady, this, [this] {
        if (found_ && wanted_ && engine_.picture()->detection->scan == found_) giveBack();
    });
    // What belongs to a scan ends when another one is there: the picture stays if that one is refused or cancelled.
    connect(&engine_, &Engine::opened, this, [this] {
        if (std::exchange(scanAsked_, false)) emit scanArrives();
    });
    connect(&engine_, &Engine::workEnded, this, [this] { scanAsked_ = scanAsked_ && engine_.opening(); });
    connect(&files_, &Files::chosen, this, [this](const QStringList& paths) { open(paths); });
    connect(&engine_, &Engine::failed, this, [this](const QString& sentence) {
        if (wanted_ && !engine_.opening()) askForPlace(sentence);
    });
}

Sessions::~Sessions() {
    const bool pending = soon_.isActive() || written_.behind();
    written_.end(); // an older state must not be written after the last one
    if (pending) {
        if (const auto last = job()) {
            for (const QString& path : {last->own, last->file}) {
                if (!path.isEmpty())
                    (void)writeWholeFile(exactBytes(path), inspect::sessionText(last->state, folderOf(path), utcText(utcNow())));
            }
        }
    }
    autosaves_.end();
}

void Sessions::changed() {
    if (!soon_.isActive() && !wanted_ && !reading_) soon_.start();
}

std::optional<inspect::SessionScan> Sessions::currentScan() const {
    const Picture& picture = *engine_.picture();
    const Scan& scan = *picture.detection->scan;
    if (picture.source.growth.sweep < 0) return scan.sha256.empty() ? std::nullopt : files_.scanShown(scan);
    QString recording = live_.recordingOf(picture.source.stream);
    if (recording.isEmpty() && live_.timeline().active()) recording = files_.path(); // another sweep of it than the one it opens with
    if (recording.isEmpty() || scan.lines() == 0) return std::nullopt;
    inspect::SessionScan of = inspect::fileScan(exactBytes(recording), {}, inspect::notebookScan(scan));
    of.kind = inspect::SessionScan::Kind::Recording;
    of.identity.sha256.clear(); // of a file that grows
    of.head = inspect::scanHead(scan);
    of.startS = startOfScan(scan).value_or(0.0);
    return of;
}

std::optional<inspect::ViewerState> Sessions::currentState() const {
    auto scan = engine_.picture() ? currentScan() : std::nullopt;
    if (!scan) return std::nullopt;
    inspect::ViewerState state;
    state.scan = std::move(*scan);
    for (const StatePart& part : parts_) part.store(state);
    if (state.rocks) state.rocks->sha256 = state.scan.identity.sha256;
    return state;
}

void Sessions::give(const inspect::ViewerState& state, GivenBack when) {
    for (const StatePart& part : parts_) {
        if (part.when == when || part.when == GivenBack::Both) part.use(state);
    }
}

bool Sessions::isShown(const inspect::SessionScan& scan) const {
    const Scan& shown = *engine_.picture()->detection->scan;
    if (scan.kind == inspect::SessionScan::Kind::Recording)
        return inspect::isSweepOf(scan, shown) && (scan.identity.sha256.empty() || shown.sha256 == scan.identity.sha256);
    return shown.sha256 == scan.identity.sha256 && shown.lines() == scan.identity.lines && shown.beams() == scan.identity.beams;
}

std::optional<Sessions::Job> Sessions::job() {
    if (wanted_ || reading_) return std::nullopt; // the session's scan is not on the screen yet
    auto state = currentState();
    if (!state) return std::nullopt;
    state->keptIn = exactBytes(file_);
    if (autosaves_.own().isEmpty() && file_.isEmpty()) return std::nullopt;
    const bool closed = state->scan.kind == inspect::SessionScan::Kind::Recording && live_.scanner().recordingClosed();
    return Job{std::move(*state), autosaves_.own(), file_, closed};
}

void Sessions::save() {
    if (auto next = job()) written_.ask(std::move(*next));
}

QString Sessions::write(const Job& job) {
    QString trouble;
    std::string hash;
    if (job.closed) {
        std::string& known = hashes_[job.state.scan.path];
        if (known.empty()) {
            if (auto of = sha256OfFile(job.state.scan.path)) known = *of;
        }
        hash = known;
    }
    for (const QString& path : {job.own, job.file}) {
        if (path.isEmpty()) continue;
        inspect::ViewerState state = job.state;
        if (job.closed) state.scan.identity.sha256 = hash;
        if (path == job.file) state.keptIn.clear();
        std::string text = inspect::sessionText(state, folderOf(path), {});
        if (const auto last = lastTexts_.find(path); last != lastTexts_.end() && last->second == text) continue;
        const auto done = writeWholeFile(exactBytes(path), inspect::sessionText(state, folderOf(path), utcText(utcNow())));
        if (done)
            lastTexts_[path] = std::move(text);
        else
            trouble = exactText(done.error().sentence());
    }
    return trouble;
}

void Sessions::finishSaving(const QString& trouble) {
    if (!trouble.isEmpty() && !failing_) notice_.showNotice(NoticeBar::Kind::Warning, tr("The session is not saved: %1").arg(trouble));
    failing_ = !trouble.isEmpty();
    if (written_.behind() || !std::exchange(toTell_, false)) return;
    if (!failing_ && !file_.isEmpty()) notice_.showSaved(file_, tr("from now on saved as it changes"));
}

void Sessions::saveAs(const QString& path) {
    const auto state = currentState();
    if (!state) {
        notice_.showHint(tr("There is nothing to save yet: open a scan first. To store a live sweep, record it."));
        return;
    }
    file_ = QFileInfo(path).absoluteFilePath();
    filed_ = state->scan.identity;
    save();
    toTell_ = true;
    emit nameChanged();
}

void Sessions::askSaveAs() {
    if (!currentState()) return saveAs({});
    const QString scan = QFileInfo(files_.path().isEmpty() ? "demo" : files_.path()).completeBaseName();
    SaveQuestion question{tr("Save session"), QDir(preferences_.folder("sessions")).filePath(scan + inspect::kSessionEnding),
                          filtersOfSessions()};
    question.keeps = [](const QString& there) {
        return inspect::readSession(exactBytes(there)) ? QString()
                                                       : tr("%1 is not a session and stays as it is: choose another name.").arg(there);
    };
    const QString path = askWhereToSave(notice_.window(), question);
    if (path.isEmpty()) return;
    preferences_.keepFolder("sessions", path);
    saveAs(path);
}

void Sessions::ask() {
    const QString path = QFileDialog::getOpenFileName(notice_.window(), tr("Open session"), preferences_.folder("sessions"),
                                                      (filtersOfSessions() << tr("Screenshots (*.png)")).join(";;"));
    if (path.isEmpty()) return;
    preferences_.keepFolder("sessions", path);
    openSession(path);
}

void Sessions::openSession(const QString& path) { read({path}, {}, true); }

void Sessions::open(const QStringList& paths, const ReadingOptions& options) { read(paths, options, false); }

void Sessions::read(const QStringList& paths, const ReadingOptions& options, bool onlySession) {
    if (paths.isEmpty()) return;
    const QString first = paths.front();
    if (std::error_code problem; !std::filesystem::is_regular_file(exactBytes(first), problem)) return openScan(paths, options);
    reading_ = true;
    inBackground(
        this,
        [this, paths, options, first, onlySession, number = ++readings_]() -> std::function<void()> {
            const bool isFile = isSessionFile(first);
            auto read = isFile ? inspect::readSession(exactBytes(first)) : sessionOfPicture(first);
            const QString own = isFile ? first : QString(); // a picture is not written to
            if (read && *read) {                            // those that exist
                std::error_code none;
                std::erase_if((*read)->places, [&](const std::filesystem::path& place) { return !std::filesystem::exists(place, none); });
            }
            return [this, paths, options, own, onlySession, number, read = std::move(read)] {
                if (number != readings_) return;
                reading_ = false;
                if (!read && onlySession)
                    refuse(
                        NoticeBar::Kind::Error,
                        tr("%1: this is not a session; choose a session, or a screenshot that carries one.").arg(shownName(paths.front())));
                else if (!read)
                    openScan(paths, options);
                else if (!*read)
                    refuse(NoticeBar::Kind::Error, exactText(read->error().sentence()));
                else
                    restore(**read, own);
            };
        },
        [this](const QString& what) {
            reading_ = false;
            refuse(NoticeBar::Kind::Error, what);
        });
}

void Sessions::openScan(const QStringList& paths, const ReadingOptions& options) {
    scanAsked_ = true;
    files_.open(paths, options);
}

void Sessions::restore(inspect::ReadSession read, const QString& file) {
    wanted_ = std::move(read);
    scanAsked_ = false;
    nextSweep_.reset();
    found_ = nullptr;
    // An autosaved session continues in the file that the operator had given it.
    const bool byItself = QFileInfo(file).absolutePath() == QFileInfo(autosaves_.own()).absolutePath() && !file.isEmpty();
    byItself_ = byItself;
    if (byItself) wanted_->state.view.images.reset(); // a start shows the images whole
    wantedFile_ = byItself ? exactText(wanted_->state.keptIn.string()) : file;
    autosaves_.markContinued(file);
    place_ = 0;
    file_.clear();
    undo_.clear();
    give(wanted_->state, GivenBack::BeforeScan);
    openNextPlace();
}

void Sessions::openNextPlace() {
    const inspect::SessionScan& scan = wanted_->state.scan;
    if (!inspect::hasPath(scan.kind)) return files_.openAgain(scan);
    if (place_ < wanted_->places.size()) return files_.open({exactText(wanted_->places[place_].string())}, scan.reading);
    askForPlace(tr("%1: the scan of this session was not found. It was moved, or its disk is missing. Settings and view are restored. The "
                   "rest needs the scan.")
                    .arg(shownName(exactText(scan.path.string()))));
}

void Sessions::refuse(NoticeBar::Kind kind, const QString& sentence) {
    notice_.showNotice(kind, sentence);
    emit refused(sentence);
}

void Sessions::askForPlace(const QString& sentence) {
    refuse(NoticeBar::Kind::Warning, sentence);
    notice_.offer(tr("Locate…"), [this] {
        const QString path = Files::askScan(notice_.window(), tr("Where is the scan now?"), preferences_);
        if (!path.isEmpty()) locate(path);
    });
}

void Sessions::locate(const QString& path) {
    if (!wanted_) return;
    wanted_->places = {exactBytes(path)};
    place_ = 0;
    openNextPlace();
}

/// Another scan is on the screen: the one that the session waits for, or an unrelated one.
void Sessions::followStream() {
    if (!wanted_) {
        if (!file_.isEmpty() && !inspect::isSame(filed_, inspect::notebookScan(*engine_.picture()->detection->scan))) {
            if (notice_.isHidden())
                notice_.showNotice(NoticeBar::Kind::Done,
                                   tr("The session %1 is not changed: this is another scan.").arg(shownName(QFileInfo(file_).fileName())));
            file_.clear();
            emit nameChanged();
        }
        return;
    }
    const bool isFile = inspect::hasPath(wanted_->state.scan.kind);
    if (isFile && (place_ >= wanted_->places.size() || exactBytes(files_.path()) != wanted_->places[place_].string())) {
        wanted_.reset(); // the operator opened another scan meanwhile
        nextSweep_.reset();
        return;
    }
    if (isShown(wanted_->state.scan)) return giveBack();
    if (!lookInSweeps()) refuseScan();
}

void Sessions::refuseScan() {
    if (inspect::hasPath(wanted_->state.scan.kind) && ++place_ < wanted_->places.size()) return openNextPlace();
    askForPlace(tr("%1 is not the scan of this session: its content differs. Settings and view are restored; targets, selection, marks, "
                   "rocks, A and the camera are not.")
                    .arg(scanName(engine_.picture()->detection->scan->name)));
}

void Sessions::giveBack() {
    nextSweep_.reset();
    found_ = nullptr;
    const inspect::ReadSession read = std::move(*std::exchange(wanted_, std::nullopt));
    give(inspect::cutTo(read.state, engine_.picture()->detection->scan->cells()), GivenBack::OnScan);
    file_ = wantedFile_;
    filed_ = inspect::notebookScan(*engine_.picture()->detection->scan);
    if (byItself_) sayWhatCameBack(read.state);
    emit nameChanged();
    changed();
}

/// After a crash nothing looks as if it could be undone that cannot be.
void Sessions::sayWhatCameBack(const inspect::ViewerState& state) {
    undo_.clear();
    const inspect::Notebook& notebook = state.targets.notebook;
    QStringList back{targetCount(notebook.targets.size())};
    if (!notebook.measures.empty()) back << tr("measurements: %1").arg(notebook.measures.size());
    if (state.rocks && !state.rocks->edits.empty()) back << tr("edits of rocks: %1").arg(rocks::changesByHand(state.rocks->edits));
    back << tr("settings, view");
    notice_.showNotice(NoticeBar::Kind::Done, tr("Restored: %1. Undo begins here.").arg(back.join(", ")));
}

QString Sessions::toGoOn() const {
    const QStringList left = autosaves_.afterCrash();
    const QString last = autosaves_.last();
    if (left.isEmpty()) return last;
    // What was closed after a crash is the last session; the notice at the start offers what the crash left.
    const bool closedLater = !last.isEmpty() && QFileInfo(last).lastModified() > QFileInfo(left.front()).lastModified();
    return closedLater ? last : left.front();
}

void Sessions::continueLast() {
    const QString path = toGoOn();
    if (!path.isEmpty()) return openSession(path);
    refuse(NoticeBar::Kind::Warning, tr("There is no session to go on with yet: open a scan first."));
}

void Sessions::offerToContinue() {
    const QString left = autosaves_.toOffer();
    if (left.isEmpty()) return;
    notice_.showNotice(NoticeBar::Kind::Warning, tr("EdgeScan ended without being closed. What was on the screen at %1 is stored.")
                                                     .arg(QFileInfo(left).lastModified().toString("yyyy-MM-dd HH:mm")));
    notice_.offer(tr("Go on where I was"), [this, path = left] { openSession(path); });
}

std::string Sessions::textFor(const QString& folder) const {
    const auto state = currentState();
    return state ? inspect::sessionText(*state, exactBytes(absolutePath(folder)), utcText(utcNow())) : std::string();
}

} // namespace edgescan::ui

#include "moc_sessions.cpp"
