// The file on the screen: opening, the series, recent files, reading it again with other options.
#pragma once

#include "core/inspect/session_file/viewer_state.h"
#include "ui/engine/worker_bridge/engine.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <QTimer>

class QMenu;
class QUndoStack;

namespace edgescan::ui {

class Preferences;
class NoticeBar;

/// GUI thread only. The objects passed to it must outlive it.
class Files : public QObject {
    Q_OBJECT
public:
    Files(Engine& engine, NoticeBar& notice, Preferences& preferences, QUndoStack& undo);

    /// Opens the first file; step() opens the others.
    void open(const QStringList& paths, const ReadingOptions& options = {});
    void openDemo(bool afterBlast = false);
    /// The file or the demo that was open before.
    void openAgain(const inspect::SessionScan& scan);
    /// Asks which files to open: chosen().
    void ask();
    void reload();
    void step(int files);
    /// Opens the file on the screen again: with corrected angles of interlaced beams and slipped lines, or as recorded.
    void straighten(bool wanted);
    /// Opens it again: with values that repeat far apart from the rest as measured, or as no return.
    void keepRepeated(bool wanted);
    /// Opens it again with these options, as one undo step named `what`.
    void readAgain(const ReadingOptions& options, const QString& what);
    /// The same after a preview: undo restores `before`.
    void readAgain(const ReadingOptions& options, const QString& what, const ReadingOptions& before);
    /// Opens it again with these options as a preview, without an undo step.
    void look(const ReadingOptions& options) { readAs(path_, options); }
    /// Asks for mounting, angles, pose and other values that a file may lack or have wrong.
    void askReading();
    void fillRecent(QMenu& menu);
    /// The picture on the screen no longer comes from a file.
    void leave();

    /// On the screen; empty: the demo, a scanner, or an empty screen.
    [[nodiscard]] const QString& path() const { return path_; }
    /// The demo on the screen (true: after the blast, false: before); empty: not a demo.
    [[nodiscard]] std::optional<bool> demo() const { return demo_; }
    /// The options of the file on the screen.
    [[nodiscard]] const ReadingOptions& options() const { return options_; }
    /// `scan`, which is on the screen, as it can be opened again; empty: it comes from no file.
    [[nodiscard]] std::optional<inspect::SessionScan> scanShown(const Scan& scan) const;
    /// " (2 of 3)" in a series, else empty.
    [[nodiscard]] QString placeInSeries() const;
    /// The filters of a dialog that asks for a scan.
    [[nodiscard]] static QString filters();
    /// Asks for scans; the folder of the recordings is offered at the side. Empty: none was chosen.
    [[nodiscard]] static QStringList askScans(QWidget* parent, const QString& title, const Preferences& preferences);
    /// Asks for one.
    [[nodiscard]] static QString askScan(QWidget* parent, const QString& title, const Preferences& preferences);

signals:
    void optionsChanged(const ReadingOptions& options);
    /// In the dialog; empty: none.
    void chosen(const QStringList& paths);

private:
    /// False: another file is on the screen meanwhile.
    bool readAs(const QString& path, const ReadingOptions& options);
    void readWith(bool ReadingOptions::*option, bool wanted, const QString& what);
    void setOptions(const ReadingOptions& options);
    void noteOpened(const QString& path);
    void showWarnings();
    void watch(const QString& path);
    void offerReading(const QString& path);
    void askRefused();
    void lookOnDisk();

    Engine& engine_;
    NoticeBar& notice_;
    Preferences& preferences_;
    std::pair<QString, ReadingOptions> refused_; // the last file that could not be read so; empty after a scan was opened
    QString path_;                               // on the screen; empty: the demo or a scanner
    ReadingOptions options_;                     // of the scan on the screen, or of the one that is being opened
    ReadingOptions shownOptions_;                // of the scan on the screen
    std::optional<bool> demo_;
    bool wantedDemo_ = false;
    QUndoStack& undo_;
    QStringList series_;
    int place_ = 0;
    std::pair<QString, QString> warned_; // the file with its warnings, and the note about them
    QSet<QString> read_;                 // files with warnings whose note was closed
    QFileSystemWatcher watcher_;         // of the file on the screen
    QTimer written_;                     // a file is written in several steps
    std::string stamp_;                  // of the file as it was opened
};

} // namespace edgescan::ui
