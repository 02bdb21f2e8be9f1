// The window: builds views, panels and controllers, and lays them out. Their behaviour is in ui/controllers.
#pragma once

#include "ui/base/plain_window.h"
#include "ui/window/viewer.h"

#include <QMainWindow>
#include <QTimer>

#include <array>
#include <map>
#include <memory>
#include <string>

class QBoxLayout;
class QMenuBar;
class QSplitter;

namespace edgescan::ui {

class CabMode;
class DockRail;
class Docks;
enum class DockLock;
class Preferences;
class Pane;
class PanePlaces;
class Sessions;
class SideColumn;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `memory` must outlive the window.
    explicit MainWindow(Preferences& preferences, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Viewer& viewer() { return viewer_; }
    [[nodiscard]] Sessions& sessions() { return *sessions_; }
    [[nodiscard]] CabMode& cab() { return *cab_; }
    [[nodiscard]] PanePlaces& places() { return *places_; }
    [[nodiscard]] SideColumn& side() { return *side_; }
    [[nodiscard]] QMenuBar* menuBar() const { return menus_; } // that of Qt would replace the row

    void resetLayout();
    /// Closes the window for the operator; in cab mode it asks before.
    void quit();
    /// Ends the program as when the window is closed, but asks nothing and waits for no work, as at a log-out.
    void end();
    // For cab mode: hides the parts that it replaces, all docks, and all views except one (null: shows all views).
    void useCab(bool on);
    void lockDocks(DockLock by, bool on);
    /// Shrinks and moves the window until its frame is inside the screen.
    void fitScreen();
    void showAlone(const QWidget* view);
    /// Docks, splitters and the maximised view, for a session.
    [[nodiscard]] std::map<std::string, std::string> layoutKept() const;
    void useLayout(const std::map<std::string, std::string>& layout);
    /// A picture of the whole window with all points of the cloud; below it the warnings of the scan, whether they are visible or not.
    [[nodiscard]] QImage screenshot();

signals:
    /// All views and panels now show the engine's picture.
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
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layOutViews();
    void layOutLegends();
    void layOutTools();
    void connectEngine();
    void showOrigin();
    void fitOrigin();
    void escape();
    bool leaveTool();
    void showWarnings();
    void followPlaces();
    void showTitle();
    void showFacts();
    void showSettings();
    void arrange();
    void showColumn(bool on);
    void setImagesWidth(int width);
    [[nodiscard]] int largeImage() const;
    void foldImages(bool fold, bool byPanel);
    void showImages();
    [[nodiscard]] bool mayClose(bool byHand);
    void maximise(Pane* pane);
    void followFrame();
    void remember();
    void restoreLayout();

    PlainWindow plain_; // before any widget
    Viewer viewer_;
    DockRail* rail_;
    QMenuBar* menus_;

    std::array<Pane*, 3> panes_{}; // gray, edges, cloud
    Pane* maximised_ = nullptr;
    QWidget* pictures_ = nullptr; // both images and the range window
    QSplitter* images_ = nullptr;
    QSplitter* splitter_ = nullptr;
    QBoxLayout* viewsRow_ = nullptr; // the views, and the column at their side
    SideColumn* side_ = nullptr;
    PanePlaces* places_ = nullptr;
    CabMode* cab_ = nullptr;
    Docks* docks_ = nullptr;
    bool byHand_ = false;        // the operator closes the window
    bool framed_ = false;        // the desktop has reported the width of the window's frame
    bool imagesDragged_ = false; // by the operator: their width does not follow the window
    bool roomForImages_ = true;  // next to the cloud
    bool columnWanted_ = true;   // the one at the side
    bool saidThatImagesFold_ = false;
    std::pair<int, CameraPose> beforeText_; // undo steps and view, before letters that may be a text
    QTimer rememberTimer_;                  // one write for a whole drag of window or splitter
    std::unique_ptr<Sessions> sessions_;    // last: destroyed before the objects that it uses
};

} // namespace edgescan::ui
