// The window: gray image, edge map and cloud side by side, the panel, and what links them.
#pragma once

#include "core/sweep/sweep_settings.h"
#include "ui/cloud/camera_motion.h"
#include "ui/session/memory.h"
#include "ui/session/session.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>

#include <optional>

class QAction;
class QMenu;
class QSplitter;
class QUndoStack;

namespace edgescan {
struct Why;
}

namespace edgescan::ui {

class CloudView;
class EdgeCounts;
class EdgesPanel;
class ImageView;
class LivePanel;
class NoticeBar;
class Pane;
class ScannerLink;
class StatusLine;
class Timeline;
class ViewPort;
class WhyCard;
struct ReplayedSweep;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `memory` must outlive the window.
    explicit MainWindow(Memory& memory, QWidget* parent = nullptr);
    ~MainWindow() override;

    void openFile(const QString& path, const ReadingOptions& options = {});
    /// Opens the first; the others follow with Page Down.
    void openSeries(const QStringList& paths, const ReadingOptions& options = {});
    void openDemo();
    /// Connects to a live scanner; reads and a subscription are all that is sent to it.
    void connectScanner(const QString& host, int port, const SweepSettings& sweep);
    /// Where Record and Keep Last Minute write to; from then on.
    void setRecordingFolder(const QString& folder);
    void usePreset(const Preset& preset);
    void useSettings(const Settings& settings);
    /// As the command line wants it: this start only, nothing of it is remembered until somebody changes a setting.
    void startWith(const Preset& preset, const Settings& settings);
    /// Opens the file on the screen again, with the angles of interlaced beams and slipped lines corrected, or as they were recorded.
    void straightenBeams(bool wanted);

    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] ImageView& grayView() { return *gray_; }
    [[nodiscard]] ImageView& edgeView() { return *edges_; }
    [[nodiscard]] CloudView& cloudView() { return *cloud_; }
    [[nodiscard]] EdgesPanel& panel() { return *panel_; }
    [[nodiscard]] StatusLine& statusLine() { return *status_; }
    [[nodiscard]] NoticeBar& notice() { return *notice_; }
    [[nodiscard]] LivePanel& livePanel() { return *live_; }
    [[nodiscard]] ScannerLink& scanner() { return *scanner_; }
    /// What was last asked about a cell; null before the first question.
    [[nodiscard]] const WhyCard* whyCard() const { return why_; }
    [[nodiscard]] Timeline& timeline() { return *timeline_; }

    /// The whole window as it is, with all points of the cloud drawn.
    [[nodiscard]] QImage screenshot();
    /// As a PNG, whole or not at all.
    Result<Done> saveScreenshotTo(const QString& path);

signals:
    /// All views show session().picture() now.
    void pictureShown();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    // main_window.cpp
    void buildViews();
    void buildPanel();
    void connectSession();
    void linkViews();
    void arrangePanes();
    void maximise(Pane* pane);
    void changeSettings(const Settings& settings, bool dragging);
    void remember();
    void restoreLayout();
    void resetLayout();

    // main_window_picture.cpp
    void showPicture();
    void showEdgeMap();
    void showNewScan();
    void showMoreLines(const Picture& last);
    void fitCloud();
    void showHover(std::optional<std::size_t> cell, const QObject* from);
    void stick(std::optional<std::size_t> cell);
    void changeDisplayLevels(int window, int level);
    void resetDisplayLevels();
    void applyAspect();
    [[nodiscard]] std::optional<QPoint> asPoint(std::optional<std::size_t> cell) const;

    // main_window_menus.cpp
    void buildMenus();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildScanMenu();
    void buildEdgesMenu();
    void buildHelpMenu();
    QAction* addCommand(QMenu& menu, const QString& text, const QList<QKeySequence>& keys, const std::function<void()>& run);
    QAction* addSwitch(QMenu& menu, const QString& text, const QList<QKeySequence>& keys, bool on, const QString& memoryKey,
                       const std::function<void(bool)>& run);
    void fillRecentMenu(QMenu& menu);
    void showShortcuts();
    void showAbout();
    void showScanProperties();

    // main_window_why.cpp
    void connectThresholds();
    void explain(std::size_t cell);
    void explainMarked();
    void showTrail(const Picture& picture, const Why& why);
    void forgetTrail();

    // main_window_live.cpp
    void buildLive(QLayout& column);
    void connectLive();
    void addLiveCommands(QMenu& file);
    void addTimelineCommands(QMenu& scan);
    void showLiveHealth();
    void showReplayed(const ReplayedSweep& at);
    void tellSweepEnded();
    void chooseRecordingFolder();
    [[nodiscard]] QString newRecordingPath(const char* kind);

    // main_window_files.cpp
    void askOpen();
    void stepInSeries(int step);
    void askExport(Session::Export what);
    void tellSaved(Session::Export what, const QString& path, qint64 count);
    void askOpenPreset();
    void askSavePreset();
    void saveScreenshot();
    void copyProbe();
    void copyCommand();

    Memory& memory_;
    Session session_;
    std::unique_ptr<ScannerLink> scanner_; // after the session that it feeds
    QUndoStack* undo_;
    std::shared_ptr<ViewPort> viewPort_;
    ImageView* gray_;
    ImageView* edges_;
    CloudView* cloud_;
    Pane* grayPane_ = nullptr;
    Pane* edgePane_ = nullptr;
    Pane* cloudPane_ = nullptr;
    Pane* maximised_ = nullptr;
    QSplitter* images_ = nullptr;
    QSplitter* views_ = nullptr;
    QDockWidget* dock_ = nullptr;
    EdgesPanel* panel_ = nullptr;
    NoticeBar* notice_ = nullptr;
    StatusLine* status_ = nullptr;
    LivePanel* live_ = nullptr;
    Timeline* timeline_ = nullptr;
    EdgeCounts* counts_ = nullptr;
    WhyCard* why_ = nullptr;
    BackgroundJob* explaining_ = nullptr; // child
    QAction* straighten_ = nullptr;
    bool starting_ = false;

    std::shared_ptr<const Picture> shown_;
    std::optional<std::size_t> hovered_;
    std::optional<std::size_t> sticky_;
    CameraPose fittedCamera_; // as long as the camera is there nobody moved it, and a growing cloud may be fitted again
    double fittedPointSize_ = 0.0;
    int fittedLines_ = 0;
    std::shared_ptr<const Scan> fileScan_; // of the recording on the timeline, as the file gives it
    QString recordingFolder_;
    QString heldNote_;
    DisplayLevels levels_;
    bool overlay_ = false;
    bool trueAngles_ = false;
    int drag_ = 1; // number of the drag, for undo
    QElapsedTimer sinceChange_;
    QTimer rememberTimer_;
    QTimer workTimer_; // work that ends sooner is not shown
    QString workTitle_;
    QString openedPath_;
    ReadingOptions openOptions_; // those of the file on the screen, for Reload and the series
    QStringList series_;
    int seriesPlace_ = 0;
};

} // namespace edgescan::ui
