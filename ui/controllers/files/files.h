// Which file is on the screen: opening, the series, recent files, reading it again with straightened beams.
#pragma once

#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/engine.h"

#include <QObject>
#include <QStringList>

class QMenu;
class QUndoStack;

namespace edgescan::ui {

class Memory;
class NoticeBar;

/// GUI thread only. What it is given must outlive it.
class Files : public QObject {
    Q_OBJECT
public:
    Files(Engine& engine, NoticeBar& notice, Memory& memory, QUndoStack& undo);

    /// Opens the first; the others follow with step().
    void open(const QStringList& paths, const ReadingOptions& options = {});
    void openDemo(bool afterBlast = false);
    void ask();
    void reload();
    void step(int files);
    /// Opens the file on the screen again, with the angles of interlaced beams and slipped lines corrected, or as they were recorded.
    void straighten(bool wanted);
    /// Opens it again with these, as one step of undo named `what`.
    void readAgain(const ReadingOptions& options, const QString& what);
    /// The same, where something else was looked at before: undo brings back `before`.
    void readAgain(const ReadingOptions& options, const QString& what, const ReadingOptions& before);
    /// Opens it again with these, to be looked at: no step of undo.
    void look(const ReadingOptions& options) { readAs(path_, options); }
    /// Asks for mounting, angles, pose and all else that a file may not know of itself, or has wrong.
    void askReading();
    void fillRecent(QMenu& menu);
    /// What is on the screen comes from no file any more.
    void leave();

    /// On the screen; empty: the demo, a scanner, or nothing.
    [[nodiscard]] const QString& path() const { return path_; }
    /// Which demo is on the screen (after the blast or before), if any.
    [[nodiscard]] std::optional<bool> demo() const { return demo_; }
    /// Those of the file on the screen.
    [[nodiscard]] const ReadingOptions& options() const { return options_; }
    /// `scan`, which is on the screen, as it can be opened again; empty: it comes from no file.
    [[nodiscard]] std::optional<SessionScan> scanShown(const Scan& scan) const;
    /// " (2 of 3)" in a series, else empty.
    [[nodiscard]] QString placeInSeries() const;
    /// Of a dialog that asks for a scan.
    [[nodiscard]] static QString filters();

signals:
    void straightened(bool on);

private:
    /// False: another file is on the screen by now.
    bool readAs(const QString& path, const ReadingOptions& options);
    void setOptions(const ReadingOptions& options);
    void noteOpened(const QString& path);
    void tellWarnings();

    Engine& engine_;
    NoticeBar& notice_;
    Memory& memory_;
    QString path_;                // on the screen; empty: the demo or a scanner
    ReadingOptions options_;      // of what is on the screen, or about to be
    ReadingOptions shownOptions_; // of what is on the screen
    std::optional<bool> demo_;
    bool wantedDemo_ = false;
    QUndoStack& undo_;
    QStringList series_;
    int place_ = 0;
};

} // namespace edgescan::ui
