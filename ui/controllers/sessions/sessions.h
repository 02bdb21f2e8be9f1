// Sessions: saved as they change, opened, and gone on with after a crash.
#pragma once

#include "core/inspect/session_file/session_file.h"
#include "ui/controllers/sessions/autosaves.h"
#include "ui/controllers/sessions/parts.h"
#include "ui/engine/worker_bridge/newest.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <optional>
#include <string>

class QUndoStack;

namespace edgescan::ui {

class Engine;
class Files;
class Live;
class Memory;
class NoticeBar;

/// GUI thread only. What it is given must outlive it; files are read and written on threads of their own.
class Sessions : public QObject {
    Q_OBJECT
public:
    Sessions(Engine& engine, Files& files, Live& live, NoticeBar& notice, Memory& memory, QUndoStack& undo, std::vector<StatePart> parts);
    /// What was not written yet is written now.
    ~Sessions() override;

    /// Files that were dropped or named: a session or a picture that carries one is gone on with, anything else is opened as scans.
    void open(const QStringList& paths, const ReadingOptions& options = {});
    void openSession(const QString& path);
    void ask();
    void askSaveAs();
    void saveAs(const QString& path);
    /// The session that a crash left behind, else the one that was closed last.
    void goOn();
    [[nodiscard]] QString toGoOn() const;
    /// In the bar above the views, where a crash left one behind.
    void offerToGoOn();
    /// Another place of the scan that the session waits for.
    void locate(const QString& path);

    /// What is on the screen as text of a session, for a picture in `folder`; empty: there is nothing to come back to.
    [[nodiscard]] std::string textFor(const QString& folder) const;
    /// The file that it was saved as; empty: none.
    [[nodiscard]] const QString& path() const { return file_; }
    [[nodiscard]] const Autosaves& autosaves() const { return autosaves_; }
    /// Nothing is being read, waited for or still to be written.
    [[nodiscard]] bool settled() const { return !reading_ && !wanted_ && !soon_.isActive() && posted_ == answered_; }

signals:
    void nameChanged();

private:
    struct Job {
        ViewerState state;
        QString own, file;   ///< where to; either may be empty
        bool closed = false; ///< the recording of the sweep: it has its hash by now
        std::uint64_t number = 0;
    };
    struct Written {
        std::uint64_t number = 0;
        QString trouble;
    };
    void changed();
    /// The state now. Empty while there is nothing to come back to: no picture, or one of no file; of a sweep from a scanner, what is not
    /// being recorded.
    [[nodiscard]] std::optional<ViewerState> taken() const;
    [[nodiscard]] std::optional<SessionScan> scanTaken() const;
    /// That the scan on the screen is that one.
    [[nodiscard]] bool isShown(const SessionScan& scan) const;
    void give(const ViewerState& state, GivenBack when);
    [[nodiscard]] std::optional<Job> job();
    [[nodiscard]] Written write(const Job& job); // worker's thread
    void take(const Written& written);
    void save();
    void restore(ReadSession read, const QString& file);
    void openNextPlace();
    void followStream();
    void askForPlace(const QString& sentence);

    Engine& engine_;
    Files& files_;
    Live& live_;
    NoticeBar& notice_;
    Memory& memory_;
    QUndoStack& undo_;
    std::vector<StatePart> parts_; // in the order in which they are given back
    Autosaves autosaves_;
    QString file_; // the person's; of the scan below
    NotebookScan filed_;
    std::optional<ReadSession> wanted_; // waits for its scan
    QString wantedFile_;
    std::size_t place_ = 0;
    bool reading_ = false;
    std::uint64_t readings_ = 0; // number of the newest
    QTimer soon_;
    std::uint64_t posted_ = 0, answered_ = 0;
    std::optional<std::uint64_t> toTell_; // the job that writes a file somebody named: that it is saved is told then
    bool failing_ = false;
    std::map<QString, std::string> lastTexts_;            // worker's thread: by path
    std::map<std::filesystem::path, std::string> hashes_; // the same: of recordings
    Newest<Job, Written> worker_;                         // last
};

} // namespace edgescan::ui
