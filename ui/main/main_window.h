// The window: builds views, panels and controllers, and lays them out. What they do is in ui/control.
#pragma once

#include "ui/control/explanation.h"
#include "ui/control/exports.h"
#include "ui/control/files.h"
#include "ui/control/linked_views.h"
#include "ui/control/live.h"
#include "ui/control/tuning.h"

#include <QMainWindow>
#include <QTimer>

#include <array>

class QSplitter;

namespace edgescan::ui {

class EdgesPanel;
class Memory;
class NoticeBar;
class Pane;
class StatusLine;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `memory` must outlive the window.
    explicit MainWindow(Memory& memory, QWidget* parent = nullptr);

    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] LinkedViews& views() { return views_; }
    [[nodiscard]] Files& files() { return files_; }
    [[nodiscard]] Exports& exports() { return exports_; }
    [[nodiscard]] Tuning& tuning() { return tuning_; }
    [[nodiscard]] Live& live() { return live_; }
    [[nodiscard]] Explanation& explanation() { return explanation_; }
    [[nodiscard]] EdgesPanel& panel() { return *panel_; }
    [[nodiscard]] StatusLine& statusLine() { return *status_; }
    [[nodiscard]] NoticeBar& notice() { return *notice_; }

    void resetLayout();
    /// The whole window as it is, with all points of the cloud drawn.
    [[nodiscard]] QImage screenshot();

signals:
    /// All views and panels show session().picture() now.
    void pictureShown();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layOutViews();
    void addDock(const QString& title, const char* name, QWidget* content);
    void connectSession();
    void arrangePanes();
    [[nodiscard]] QList<int> usualSizes() const;
    void maximise(Pane* pane);
    void remember();
    void restoreLayout();

    Memory& memory_;
    Session session_;

    // Children of the window once they are laid out.
    ImageView* gray_;
    ImageView* edges_;
    CloudView* cloud_;
    EdgesPanel* panel_;
    LivePanel* livePanel_;
    Timeline* timeline_;
    NoticeBar* notice_;
    StatusLine* status_;

    // In the order in which they are told of a new picture.
    LinkedViews views_;
    Files files_;
    Exports exports_;
    Tuning tuning_;
    Live live_;
    Explanation explanation_;

    std::array<Pane*, 3> panes_{}; // gray, edges, cloud
    Pane* maximised_ = nullptr;
    QSplitter* images_ = nullptr;
    QSplitter* splitter_ = nullptr;
    QTimer rememberTimer_; // one writing for a whole drag of window or splitter
};

} // namespace edgescan::ui
