// The window: builds views, panels and controllers, and lays them out. Their behaviour is in ui/controllers.
#pragma once

#include "ui/base/plain_window.h"
#include "ui/controllers/audit_trail.h"
#include "ui/controllers/comparing.h"
#include "ui/controllers/confidence.h"
#include "ui/controllers/explanation.h"
#include "ui/controllers/files/exports.h"
#include "ui/controllers/files/files.h"
#include "ui/controllers/files/opening.h"
#include "ui/controllers/live.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/controllers/scan_report.h"
#include "ui/controllers/targets/marked_edges.h"
#include "ui/controllers/targets/measures.h"
#include "ui/controllers/targets/selection.h"
#include "ui/controllers/targets/targets.h"
#include "ui/controllers/tuning.h"
#include "ui/engine/linked_views/linked_views.h"

#include <QMainWindow>
#include <QTimer>
#include <QUndoStack>

#include <array>
#include <map>
#include <memory>
#include <string>

class QDockWidget;
class QSplitter;

namespace edgescan::ui {

class CabMode;
class ChangeLegend;
class ConfidenceLegend;
class DockRail;
class EdgeLegend;
class EdgesPanel;
class Memory;
class NoticeBar;
class Pane;
class RocksPanel;
class RangeWindow;
class RockTable;
class Sessions;
class ScanLook;
class StateBadge;
class StatusLine;
class TargetsPanel;
class ToolBar;
class WarningButton;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `memory` must outlive the window.
    explicit MainWindow(Memory& memory, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Engine& engine() { return engine_; }
    [[nodiscard]] LinkedViews& views() { return views_; }
    [[nodiscard]] Files& files() { return files_; }
    [[nodiscard]] Opening& opening() { return opening_; }
    [[nodiscard]] Exports& exports() { return exports_; }
    [[nodiscard]] Tuning& tuning() { return tuning_; }
    [[nodiscard]] Live& live() { return live_; }
    [[nodiscard]] Explanation& explanation() { return explanation_; }
    [[nodiscard]] Rocks& rocks() { return rocks_; }
    [[nodiscard]] AuditTrail& audit() { return audit_; }
    [[nodiscard]] ScanReport& report() { return report_; }
    [[nodiscard]] RocksPanel& rocksPanel() { return *rocksPanel_; }
    [[nodiscard]] RockTable& rockTable() { return *rockTable_; }
    [[nodiscard]] Targets& targets() { return targets_; }
    [[nodiscard]] TargetsPanel& targetsPanel() { return *targetsPanel_; }
    [[nodiscard]] Measures& measures() { return measures_; }
    [[nodiscard]] Selection& selection() { return selection_; }
    [[nodiscard]] Comparing& comparing() { return comparing_; }
    [[nodiscard]] ChangeLegend& changeLegend() { return *changeLegend_; }
    [[nodiscard]] Confidence& confidence() { return confidence_; }
    [[nodiscard]] ConfidenceLegend& confidenceLegend() { return *confidenceLegend_; }
    [[nodiscard]] MarkedEdges& markedEdges() { return markedEdges_; }
    [[nodiscard]] Sessions& sessions() { return *sessions_; }
    [[nodiscard]] ToolBar& tools() { return *tools_; }
    /// The source and time of the picture: always visible.
    [[nodiscard]] const StateBadge& origin() const { return *origin_; }
    [[nodiscard]] EdgesPanel& panel() { return *panel_; }
    [[nodiscard]] StatusLine& statusLine() { return *status_; }
    [[nodiscard]] NoticeBar& notice() { return *notice_; }
    [[nodiscard]] WarningButton& warnings() { return *warnings_; }
    [[nodiscard]] EdgeLegend& legend() { return *legend_; }
    [[nodiscard]] QUndoStack& undoStack() { return undo_; }
    [[nodiscard]] CabMode& cab() { return *cab_; }
    [[nodiscard]] ScanLook& look() { return *look_; }
    [[nodiscard]] RangeWindow& rangeWindow() { return *rangeWindow_; }

    void resetLayout();
    // For cab mode: hides the parts that it replaces, all docks, and all views except one (null: shows all views).
    void useCab(bool on);
    void lockDocks(bool on);
    /// Shrinks and moves the window until its frame is inside the screen.
    void fitScreen();
    void showAlone(const QWidget* view);
    /// Docks, splitters and the maximised view, for a session.
    [[nodiscard]] std::map<std::string, std::string> layoutKept() const;
    void useLayout(const std::map<std::string, std::string>& layout);
    /// A picture of the whole window with all points of the cloud; below it the warnings of the scan, whether they are visible or not.
    [[nodiscard]] QImage screenshot();

signals:
    /// All views and panels now show engine().picture().
    void pictureShown();
    /// The source of the picture changed or became known.
    void originShown();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    static constexpr const char* kByHand = "byHand"; ///< of a dock: "open" or "folded" if the operator opened or folded it
    void layOutViews();
    QDockWidget* addDock(const QString& title, const char* name, QWidget* content);
    void layOutLegend();
    void layOutTools();
    void connectSession();
    void showOrigin();
    void escape();
    void showWarnings();
    void showTitle();
    void arrange();
    void setImagesWidth(int width);
    [[nodiscard]] bool mayClose();
    void maximise(Pane* pane);
    void showRangeWindow();
    void followFrame();
    void remember();
    void restoreLayout();

    PlainWindow plain_; // before any widget
    Memory& memory_;
    Engine engine_;
    QUndoStack undo_;

    // Children of the window after the layout.
    ImageView* gray_;
    ImageView* edges_;
    CloudView* cloud_;
    EdgesPanel* panel_;
    LivePanel* livePanel_;
    Timeline* timeline_;
    RocksPanel* rocksPanel_;
    RockTable* rockTable_;
    TargetsPanel* targetsPanel_;
    ToolBar* tools_;
    StateBadge* origin_;
    NoticeBar* notice_;
    StatusLine* status_;
    WarningButton* warnings_;
    EdgeLegend* legend_;
    ChangeLegend* changeLegend_;
    ConfidenceLegend* confidenceLegend_;
    DockRail* rail_;
    RangeWindow* rangeWindow_;

    // The views first: the others use what is shown. The order of the others does not matter to what is drawn (sceneOf).
    LinkedViews views_;
    Files files_;
    Opening opening_;
    Exports exports_;
    Tuning tuning_;
    Live live_;
    Explanation explanation_;
    Rocks rocks_;
    Targets targets_;
    Measures measures_;
    Selection selection_;
    Comparing comparing_;
    Confidence confidence_;
    MarkedEdges markedEdges_;
    ScanReport report_;
    AuditTrail audit_;

    std::array<Pane*, 3> panes_{}; // gray, edges, cloud
    Pane* maximised_ = nullptr;
    QWidget* pictures_ = nullptr; // both images and the range window
    QSplitter* images_ = nullptr;
    QSplitter* splitter_ = nullptr;
    ScanLook* look_ = nullptr;
    CabMode* cab_ = nullptr;
    QList<QDockWidget*> hiddenForCab_; // restored after cab mode
    QList<QDockWidget*> docks_;
    bool framed_ = false;                        // the desktop has reported the width of the window's frame
    int arrangedImages_ = 0, arrangedPanel_ = 0; // widths set by arrange(): a panel that still has this width follows the window
    QTimer rememberTimer_;                       // one write for a whole drag of window or splitter
    std::unique_ptr<Sessions> sessions_;         // last: destroyed before the objects that it uses
};

} // namespace edgescan::ui
