// Builds the window and lays it out.
#include "ui/window/main_window.h"

#include "core/scan/georef/placed_points.h"
#include "ui/base/dock_rail.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/base/shown_text.h"
#include "ui/controllers/files/source.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/engine/linked_views/cell_cursor.h"
#include "ui/engine/worker_bridge/memory.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/confidence/confidence_legend.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/gl_check.h"
#include "ui/views/cloud/scale_plate.h"
#include "ui/views/image/image_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/compare_menu.h"
#include "ui/window/legend_place.h"
#include "ui/window/menus.h"
#include "ui/window/pane_notes.h"
#include "ui/window/rock_docks.h"
#include "ui/window/session_menu.h"
#include "ui/window/target_dock.h"
#include "ui/window/tool_bar.h"
#include "ui/window/tool_buttons.h"
#include "ui/window/warned_picture.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QStyle>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kRememberAfterMs = 300;

} // namespace

MainWindow::MainWindow(Memory& memory, QWidget* parent)
    : QMainWindow(parent), memory_(memory), gray_(new ImageView), edges_(new ImageView(gray_->viewPort())), cloud_(new CloudView),
      panel_(new EdgesPanel), livePanel_(new LivePanel), timeline_(new Timeline), rocksPanel_(new RocksPanel), rockTable_(new RockTable),
      targetsPanel_(new TargetsPanel), tools_(new ToolBar), origin_(new StateBadge), notice_(new NoticeBar), status_(new StatusLine),
      warnings_(new WarningButton), legend_(new EdgeLegend), changeLegend_(new ChangeLegend), confidenceLegend_(new ConfidenceLegend),
      rail_(new DockRail), rangeWindow_(new RangeWindow), views_(engine_, *gray_, *edges_, *cloud_),
      files_(engine_, *notice_, memory, undo_), opening_(engine_, files_, *notice_), exports_(engine_, files_, *notice_, memory),
      tuning_(engine_, *panel_, *notice_, memory, undo_), live_(engine_, *livePanel_, *timeline_, views_, files_, *notice_, memory),
      explanation_(engine_, views_, *notice_), rocks_(engine_, views_, *rocksPanel_, *rockTable_, *notice_, memory, undo_),
      targets_(engine_, views_, rocks_, *targetsPanel_, *notice_, memory, undo_), measures_(views_, targets_, *notice_),
      selection_(engine_, views_, rocks_, *notice_, undo_), comparing_(engine_, views_, *changeLegend_, files_, *notice_, memory, undo_),
      confidence_(engine_, views_, targets_, *confidenceLegend_, memory), markedEdges_(engine_, views_, targets_, undo_, *notice_),
      report_(engine_, files_, rocks_, targets_, comparing_, *notice_, memory), audit_(memory.place(), engine_, views_, undo_, *notice_) {
    setObjectName("edgescan");
    setWindowTitle("EdgeScan");
    setAcceptDrops(true);
    layOutViews();
    layOutLegend();
    addChangeLegend(*this);
    addConfidenceLegend(*this);
    keepLegendsOffPins(*cloud_, views_);
    look_ = new ScanLook(engine_, views_, *new ScalePlate(cloud_), *rangeWindow_, memory_);
    look_->setParent(this);
    layOutTools();
    addToolBar(Qt::RightToolBarArea, rail_);
    addDock(tr("Edges"), "dock-edges", panel_);
    connect(rail_, &DockRail::changedByOperator, this, [this](QDockWidget* dock, bool open) {
        dock->setProperty(kByHand, open ? "open" : "folded");
        memory_.keep("window/" + dock->objectName(), QString(open ? "open" : "folded"));
        arrange();
    });
    addRockDocks(*this, rocks_, *rocksPanel_, *rockTable_);
    addTargetDock(*this, targets_, *targetsPanel_);
    setStatusBar(status_);
    status_->addPinned(warnings_);
    connect(warnings_, &QToolButton::clicked, this,
            [this] { notice_->showNotice(NoticeBar::Kind::Warning, warnings_->warnings().join('\n')); });
    connect(&report_, &ScanReport::saved, &audit_, [this](const QString& path) { audit_.noteExport("report", path); });
    connect(warnings_, &WarningButton::warningsRaised, &audit_, &AuditTrail::noteWarnings);
    connect(warnings_, &WarningButton::warningsAcknowledged, &audit_, [this] {
        audit_.note("acknowledged", {{"warnings", warnings_->warnings().size()}});
    });
    for (const Command& menu : menusOf(*this, memory_))
        addCommands(*menuBar()->addMenu(menu.text), menu.submenu, *this, memory_, menu.source);
    recallKeys(keyedCommands(actions()), memory_);
    addToolButtons(*this);
    QApplication::instance()->installEventFilter(new KeysOfFocus(this));
    new CellCursor(views_, this);
    connectSession();
    sessions_ = sessionsOf(*this, memory_);
    rememberTimer_.setSingleShot(true);
    rememberTimer_.setInterval(kRememberAfterMs);
    connect(&rememberTimer_, &QTimer::timeout, this, &MainWindow::remember);
    restoreLayout();
    if (memory_.flag("view/cab", false)) cab_->set(true);
    status_->showRenderer(checkGl().renderer);
}

MainWindow::~MainWindow() = default;

void MainWindow::layOutViews() {
    gray_->setObjectName("gray");
    edges_->setObjectName("edges");
    cloud_->setObjectName("cloud");
    auto* grayPane = new Pane(tr("Range image"), gray_);
    auto* edgePane = new Pane(tr("Edge map"), edges_);
    auto* cloudPane = new Pane(tr("Cloud"), cloud_);
    panes_ = {grayPane, edgePane, cloudPane};
    keepPaneNotes(*this, *grayPane, *edgePane, *cloudPane);
    for (Pane* pane : panes_)
        connect(pane, &Pane::maximiseRequested, this, [this, pane] {
            if (!cab_->on()) maximise(pane);
        });

    images_ = new QSplitter(Qt::Vertical);
    images_->addWidget(grayPane);
    images_->addWidget(edgePane);
    pictures_ = new QWidget;
    auto* under = new QVBoxLayout(pictures_);
    under->setContentsMargins(0, 0, 0, 0);
    under->setSpacing(0);
    under->addWidget(images_, 1);
    under->addWidget(rangeWindow_);
    splitter_ = new QSplitter(Qt::Horizontal);
    splitter_->addWidget(pictures_);
    splitter_->addWidget(cloudPane);
    for (QSplitter* splitter : {images_, splitter_}) {
        splitter->setChildrenCollapsible(false);
        splitter->setHandleWidth(5);
        connect(splitter, &QSplitter::splitterMoved, this, [this] { rememberTimer_.start(); });
    }
    splitter_->setStretchFactor(0, 0); // additional width goes to the cloud
    splitter_->setStretchFactor(1, 1);
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice_);
    column->addWidget(splitter_, 1);
    column->addWidget(timeline_);
    column->addWidget(livePanel_);
    cab_ = new CabMode(*this, centre);
}

QDockWidget* MainWindow::addDock(const QString& title, const char* name, QWidget* content) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setProperty(kByHand, memory_.text("window/" + dock->objectName()));
    dock->setWidget(content);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    rail_->add(dock);
    docks_ << dock;
    return dock;
}

// Over a free part of the cloud; more legends go above it.
void MainWindow::layOutLegend() {
    auto* over = new QVBoxLayout(cloud_);
    over->setContentsMargins(8, 8, 8, 8);
    over->addStretch(1);
    over->addWidget(legend_, 0, Qt::AlignLeft | Qt::AlignBottom);
    connect(cloud_, &CloudView::edgesCovered, legend_, &EdgeLegend::showCovered);
    connect(legend_, &EdgeLegend::classesRequested, this, [this](int classes) { tuning_.setParameter("classes", classes); });
}

// The badge is in the corner of the menu bar, where it is visible at every width.
void MainWindow::layOutTools() {
    addToolBar(Qt::TopToolBarArea, tools_);
    tools_->toggleViewAction()->setVisible(false);
    origin_->setObjectName("origin");
    menuBar()->setCornerWidget(origin_, Qt::TopRightCorner);
    connect(&measures_, &Measures::asked, tools_, &ToolBar::showAsked);
    connect(&selection_, &Selection::changed, this, [this] { tools_->showSelected(selection_.words()); });
    connect(&selection_, &Selection::exportRequested, this, [this] { exports_.askSelected(); });
    connect(&selection_, &Selection::changed, this, [this] { exports_.setSelection(selection_.cells()); });
    connect(&targets_, &Targets::explanationRequested, &explanation_, &Explanation::explain);
    connect(&targets_, &Targets::measureRequested, &measures_, &Measures::startAt);
    const ScannerLink& scanner = live_.scanner();
    for (const auto told : {&ScannerLink::connectedChanged, &ScannerLink::followingChanged})
        connect(&scanner, told, this, &MainWindow::showOrigin);
    connect(&scanner, &ScannerLink::healthChanged, this, &MainWindow::showOrigin);
    showOrigin();
}

void MainWindow::showOrigin() {
    const PictureOrigin origin = originOf(engine_.picture().get(), live_.scanner());
    const QSize before = origin_->sizeHint();
    origin_->showState(origin.sign, origin.badge);
    origin_->setToolTip(origin.more);
    // the menu bar reads the size only in this call
    if (origin_->sizeHint() != before) menuBar()->setCornerWidget(origin_, Qt::TopRightCorner);
    targets_.setSource(origin.badge);
    emit originShown();
}

void MainWindow::connectSession() {
    connect(&engine_, &Engine::workStarted, status_, &StatusLine::startWork);
    connect(&engine_, &Engine::workProgressed, status_, &StatusLine::showProgress);
    connect(&engine_, &Engine::workEnded, status_, &StatusLine::endWork);
    connect(status_, &StatusLine::cancelRequested, &engine_, &Engine::cancel);
    connect(&engine_, &Engine::settingsChanged, this, [this] { status_->showSettings(engine_.settings()); });
    status_->showSettings(engine_.settings());
    connect(&engine_, &Engine::failed, this, [this](const QString& sentence) { notice_->showNotice(NoticeBar::Kind::Error, sentence); });
    connect(&views_, &LinkedViews::probed, status_, &StatusLine::showProbe);
    connect(&views_, &LinkedViews::boxed, status_, &StatusLine::showBox);
    connect(&engine_, &Engine::pictureReady, this, [this] {
        const edges::Detection& detection = *engine_.picture()->detection;
        status_->showCounts(detection);
        status_->showPlace(*detection.scan);
        const ScannerLink& scanner = live_.scanner();
        status_->showTimeOf(*detection.scan, scanner.connected() && engine_.picture()->source.stream == scanner.stream());
        status_->showTime(tuning_.updateMs());
        legend_->showResult(detection);
        showWarnings();
        showTitle();
        showOrigin();
        emit pictureShown(); // the controllers received it before
    });
}

// The title of the picture on the screen: sweeps of a scanner and of a recording have their own names.
void MainWindow::showTitle() {
    setWindowTitle(shownName(exactText(engine_.picture()->detection->scan->name)) + files_.placeInSeries() + " - EdgeScan");
}

void MainWindow::showWarnings() {
    const Scan& scan = *engine_.picture()->detection->scan;
    QStringList warnings;
    for (const std::vector<std::string>& some : {scan.warnings, placeWarnings(scan)}) {
        for (const std::string& warning : some) warnings << shownText(warning);
    }
    warnings_->showWarnings(warnings);
}

/// Panels and images get a suitable width, the cloud gets the rest. Docks that the operator folded, opened or dragged stay unchanged.
QImage MainWindow::screenshot() {
    const QImage cloud = cloud_->grabFrame(CloudView::Points::All);
    panes_.back()->setRemark(QString()); // its text describes a frame and is wrong for this picture
    QImage image = grab().toImage();
    // The result of grab() for an OpenGL child depends on the platform: the view's own picture replaces it.
    QPainter painter(&image);
    painter.drawImage(QRect(cloud_->mapTo(this, QPoint(0, 0)), cloud_->size()), cloud);
    painter.end();
    return withWarnings(image, warnings_->warnings(), font());
}

bool MainWindow::mayClose() {
    const bool records = live_.scanner().recording();
    if (!records && !engine_.saving()) return true;
    QMessageBox box(QMessageBox::Warning, tr("Close EdgeScan?"),
                    records ? tr("A recording is being written.") : tr("A file is still being written."), QMessageBox::Cancel, this);
    box.setObjectName("close-question");
    box.setInformativeText(records ? tr("Closing ends it here; what was recorded so far stays in its file.")
                                   : tr("Closing waits until it is whole."));
    QPushButton* end = box.addButton(records ? tr("End the Recording and Close") : tr("Close"), QMessageBox::DestructiveRole);
    end->setObjectName("end-and-close");
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == end;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose()) return event->ignore();
    live_.scanner().disconnectScanner();
    remember();
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) paths << url.toLocalFile();
    }
    if (!paths.isEmpty()) event->acceptProposedAction();
    sessions_->open(paths);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    // Esc: first cancels the job, then closes the notice, the maximised view, the crosshair.
    if (event->key() != Qt::Key_Escape) {
        QMainWindow::keyPressEvent(event);
        return;
    }
    if (engine_.opening()) {
        engine_.cancel();
        notice_->showNotice(NoticeBar::Kind::Warning, tr("Cancelled; what was on the screen stays."));
    } else if (notice_->isVisible())
        notice_->hide();
    else if (maximised_ != nullptr && !cab_->on())
        maximise(maximised_);
    else
        escape();
}

// Undoes the last click of a tool, then leaves the tool, then clears the pinned cell.
void MainWindow::escape() {
    if (explanation_.closeCard()) return;
    if (measures_.kind()) {
        if (!measures_.removeLastPick()) measures_.stop();
    } else if (views_.tool() != Tool::Pin) {
        selection_.cells().empty() ? views_.setTool(Tool::Pin) : selection_.select({});
    } else {
        views_.clearPin();
        explanation_.forgetTrail();
    }
}

} // namespace edgescan::ui
