// Sessions: saved as they change, opened, and gone on with after a crash.
#pragma once

#include "ui/controllers/sessions/autosaves.h"
#include "ui/controllers/sessions/desk.h"
#include "ui/engine/worker_bridge/derived.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <optional>
#include <string>

namespace edgescan::ui {

/// GUI thread only; files are read and written off it.
class Sessions : public QObject {
    Q_OBJECT
public:
    explicit Sessions(const Desk& desk);
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
    [[nodiscard]] bool settled() const { return !reading_ && !wanted_ && !soon_.isActive() && !written_.behind(); }

signals:
    void nameChanged();

private:
    struct Job {
        ViewerState state;
        QString own, file;   ///< where to; either may be empty
        bool closed = false; ///< the recording of the sweep: it has its hash by now
    };
    void connectDesk();
    void changed();
    [[nodiscard]] std::optional<Job> job();
    [[nodiscard]] QString write(const Job& job); // pool's thread; empty, or why not
    void take(const QString& trouble);
    void save();
    void restore(ReadSession read, const QString& file);
    void openNextPlace();
    void followStream();
    void askForPlace(const QString& sentence);

    Desk desk_;
    Autosaves autosaves_;
    QString file_; // the person's; of the scan below
    NotebookScan filed_;
    std::optional<ReadSession> wanted_; // waits for its scan
    QString wantedFile_;
    std::size_t place_ = 0;
    bool reading_ = false;
    std::uint64_t readings_ = 0; // number of the newest
    QTimer soon_;
    bool toTell_ = false; // a file that the operator named is being written: a notice follows
    bool failing_ = false;
    std::map<QString, std::string> lastTexts_;            // of write() alone: by path
    std::map<std::filesystem::path, std::string> hashes_; // the same: of recordings
    Derived<Job, QString> written_;                       // last
};

} // namespace edgescan::ui
