// Sessions: saved as they change, opened, and continued after a crash.
#pragma once

#include "core/inspect/session_file/session_file.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/sessions/autosaves.h"
#include "ui/controllers/sessions/parts.h"
#include "ui/engine/worker_bridge/derived.h"
#include "ui/panels/live/replay_player.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>

class QUndoStack;

namespace edgescan::ui {

class Engine;
class Files;
class Live;
class Preferences;

/// GUI thread only. What it is given must outlive it; files are read and written by the pool.
class Sessions : public QObject {
    Q_OBJECT
public:
    Sessions(Engine& engine, Files& files, Live& live, NoticeBar& notice, Preferences& preferences, QUndoStack& undo,
             std::vector<StatePart> parts);
    /// Writes pending changes.
    ~Sessions() override;

    /// Opens dropped or named files: a session or a picture with a session is continued, other files are opened as scans.
    void open(const QStringList& paths, const ReadingOptions& options = {});
    /// Refuses other files.
    void openSession(const QString& path);
    void ask();
    void askSaveAs();
    void saveAs(const QString& path);
    /// Continues the session that a crash left, else the last closed one.
    void continueLast();
    [[nodiscard]] QString toGoOn() const;
    /// Offers this in the bar above the views if a crash left a session.
    void offerToContinue();
    /// Another path of the scan that the session waits for.
    void locate(const QString& path);

    /// The current state as session text, for a picture in `folder`; empty: no state to restore.
    [[nodiscard]] std::string textFor(const QString& folder) const;
    /// The operator's session file; empty: none.
    [[nodiscard]] const QString& path() const { return file_; }
    [[nodiscard]] const Autosaves& autosaves() const { return autosaves_; }
    /// No reading, waiting or writing is pending.
    [[nodiscard]] bool settled() const { return !restoring() && !soon_.isActive() && !written_.behind(); }

    /// A session is being read, or waits for its scan.
    [[nodiscard]] bool restoring() const { return reading_ || wanted_; }

signals:
    void nameChanged();
    /// A scan that was asked for by itself, without a session, is about to be shown.
    void scanArrives();
    /// The wanted session cannot be restored, or not with its scan.
    void refused(const QString& sentence);

private:
    struct Job {
        inspect::ViewerState state;
        QString own, file;   ///< target paths; either may be empty
        bool closed = false; ///< the recording of the sweep is closed: its hash is known
    };
    void changed();
    /// The state now. Empty while there is nothing to come back to: no picture, or one of no file; of a sweep from a scanner, what is not
    /// being recorded.
    [[nodiscard]] std::optional<inspect::ViewerState> currentState() const;
    [[nodiscard]] std::optional<inspect::SessionScan> currentScan() const;
    /// That the scan on the screen is that one.
    [[nodiscard]] bool isShown(const inspect::SessionScan& scan) const;
    /// The wanted sweep is another one of the recording on the screen: looks at them one after the other.
    [[nodiscard]] bool lookInSweeps();
    void lookInNextSweep();
    void lookAt(const ReplayedSweep& at);
    void giveBack();
    void sayWhatCameBack(const inspect::ViewerState& state);
    void refuseScan();
    void give(const inspect::ViewerState& state, GivenBack when);
    [[nodiscard]] std::optional<Job> job();
    [[nodiscard]] QString write(const Job& job); // pool's thread; empty, or why not
    void finishSaving(const QString& trouble);
    void save();
    void read(const QStringList& paths, const ReadingOptions& options, bool onlySession);
    void openScan(const QStringList& paths, const ReadingOptions& options);
    void restore(inspect::ReadSession read, const QString& file);
    void openNextPlace();
    void followStream();
    void refuse(NoticeBar::Kind kind, const QString& sentence);
    void askForPlace(const QString& sentence);

    Engine& engine_;
    Files& files_;
    Live& live_;
    NoticeBar& notice_;
    Preferences& preferences_;
    QUndoStack& undo_;
    std::vector<StatePart> parts_; // in the order in which they are given back
    Autosaves autosaves_;
    QString file_; // chosen by the operator; of the scan below
    inspect::NotebookScan filed_;
    std::optional<inspect::ReadSession> wanted_; // waits for its scan
    QString wantedFile_;
    bool byItself_ = false; // the wanted session was saved by the viewer itself
    std::size_t place_ = 0;
    std::optional<std::size_t> nextSweep_; // to look at; empty: the sweeps are not looked through
    std::shared_ptr<const Scan> found_;    // the wanted sweep, on its way to the screen
    bool scanAsked_ = false;               // by itself
    bool reading_ = false;
    std::uint64_t readings_ = 0; // number of the newest reading
    QTimer soon_;
    bool toTell_ = false; // a file that the operator named is being written: a notice follows
    bool failing_ = false;
    std::map<QString, std::string> lastTexts_;            // used only by write(): by path
    std::map<std::filesystem::path, std::string> hashes_; // the same: hashes of recordings
    Derived<Job, QString> written_;                       // last
};

} // namespace edgescan::ui
