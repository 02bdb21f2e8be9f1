// The window: builds its views and keeps them in step.
#include "ui/main/main_window.h"

#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/cloud/cloud_view.h"
#include "ui/cloud/gl_check.h"
#include "ui/control/settings_undo.h"
#include "ui/image/image_view.h"
#include "ui/image/viewport.h"
#include "ui/live/live_panel.h"
#include "ui/live/scanner_link.h"
#include "ui/live/timeline.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/status_line.h"
#include "ui/session/edge_counts.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QScreen>
#include <QSplitter>
#include <QUndoStack>
#include <QUrl>
#include <QVBoxLayout>

#include <cmath>

namespace edgescan::ui {
namespace {

constexpr int kWideScreen = 1920; // three views in one row from here on
constexpr int kRememberAfterMs = 300;
constexpr int kShowWorkAfterMs = 100;

} // namespace

MainWindow::MainWindow(Memory& memory, QWidget* parent)
    : QMainWindow(parent), memory_(memory), scanner_(std::make_unique<ScannerLink>(session_)), undo_(new QUndoStack(this)),
      viewPort_(std::make_shared<ViewPort>()), gray_(new ImageView(viewPort_)), edges_(new ImageView(viewPort_)), cloud_(new CloudView) {
    setObjectName("edgescan");
    setWindowTitle("EdgeScan");
    setAcceptDrops(true);
    buildViews();
    buildPanel();
    status_ = new StatusLine(this);
    setStatusBar(status_);
    buildMenus();
    connectSession();
    connectLive();
    linkViews();
    connectThresholds();
    rememberTimer_.setSingleShot(true);
    rememberTimer_.setInterval(kRememberAfterMs);
    connect(&rememberTimer_, &QTimer::timeout, this, &MainWindow::remember);
    resize(1600, 950);
    restoreLayout();
    useSettings(memory_.settings(session_.settings()));
    status_->showRenderer(checkGl().renderer);
}

MainWindow::~MainWindow() = default;

void MainWindow::buildViews() {
    gray_->setObjectName("gray");
    edges_->setObjectName("edges");
    cloud_->setObjectName("cloud");
    for (ImageView* view : {gray_, edges_}) view->setNote(tr("Open a scan: Ctrl+O, or drop a file here"));
    grayPane_ = new Pane(tr("Range image"), gray_);
    edgePane_ = new Pane(tr("Edge map"), edges_);
    cloudPane_ = new Pane(tr("Cloud"), cloud_);
    for (Pane* pane : {grayPane_, edgePane_, cloudPane_}) connect(pane, &Pane::maximiseWanted, this, [this, pane] { maximise(pane); });

    images_ = new QSplitter(Qt::Vertical);
    images_->addWidget(grayPane_);
    images_->addWidget(edgePane_);
    views_ = new QSplitter(Qt::Horizontal);
    views_->addWidget(images_);
    views_->addWidget(cloudPane_);
    for (QSplitter* splitter : {images_, views_}) {
        splitter->setChildrenCollapsible(false);
        connect(splitter, &QSplitter::splitterMoved, this, [this] { rememberTimer_.start(); });
    }
    notice_ = new NoticeBar;
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice_);
    column->addWidget(views_, 1);
    buildLive(*column);
    setCentralWidget(centre);
}

void MainWindow::buildPanel() {
    panel_ = new EdgesPanel;
    dock_ = new QDockWidget(tr("Edges"), this);
    dock_->setObjectName("dock-edges");
    dock_->setWidget(panel_);
    addDockWidget(Qt::RightDockWidgetArea, dock_);
    connect(panel_, &EdgesPanel::edited, this, &MainWindow::changeSettings);
    connect(panel_, &EdgesPanel::editEnded, this, [this] { ++drag_; });
    connect(panel_, &EdgesPanel::refused, this, [this](const QString& sentence) { notice_->showNotice(NoticeBar::Kind::Error, sentence); });
    connect(panel_, &EdgesPanel::presetChosen, this, &MainWindow::usePreset);
    connect(panel_, &EdgesPanel::openPresetWanted, this, &MainWindow::askOpenPreset);
    connect(panel_, &EdgesPanel::savePresetWanted, this, &MainWindow::askSavePreset);
    connect(panel_, &EdgesPanel::ratioLockChanged, this, [this](bool locked) { memory_.keep("edges/ratio-locked", locked); });
}

void MainWindow::connectSession() {
    workTimer_.setSingleShot(true);
    workTimer_.setInterval(kShowWorkAfterMs);
    connect(&workTimer_, &QTimer::timeout, this, [this] { status_->showWork(workTitle_, QString(), 0.0); });
    connect(&session_, &Session::workStarted, this, [this](const QString& title) {
        workTitle_ = title;
        workTimer_.start();
    });
    connect(&session_, &Session::workProgressed, this, [this](const QString& stage, double fraction) {
        if (!workTimer_.isActive()) status_->showWork(workTitle_, stage, fraction);
    });
    connect(&session_, &Session::workEnded, this, [this] {
        workTimer_.stop();
        status_->hideWork();
    });
    connect(status_, &StatusLine::cancelWanted, &session_, &Session::cancel);
    connect(&session_, &Session::failed, this, [this](const QString& sentence) { notice_->showNotice(NoticeBar::Kind::Error, sentence); });
    connect(&session_, &Session::opened, this, [this](const QString& path) {
        openedPath_ = path;
        notice_->hide();
        if (path.isEmpty()) return;
        memory_.keepRecentFile(path);
        memory_.keepFolder("scans", path);
        memory_.write();
    });
    connect(&session_, &Session::saved, this, &MainWindow::tellSaved);
    connect(&session_, &Session::settingsChanged, this, [this] {
        sinceChange_.start();
        panel_->show(session_.settings());
        panel_->setBehind(session_.behind());
        if (!starting_) memory_.keepSettings(session_.settings());
        rememberTimer_.start();
    });
    connect(&session_, &Session::pictureReady, this, &MainWindow::showPicture);
}

void MainWindow::linkViews() {
    for (ImageView* view : {gray_, edges_}) {
        connect(view, &ImageView::hovered, this, [this, view](int line, int beam) {
            if (shown_ && line < shown_->detection->scan->lines()) showHover(shown_->detection->scan->rangeMm.index(line, beam), view);
        });
        connect(view, &ImageView::hoverLeft, this, [this, view] { showHover(std::nullopt, view); });
        connect(view, &ImageView::clicked, this, [this](int line, int beam) {
            if (shown_ && line < shown_->detection->scan->lines()) stick(shown_->detection->scan->rangeMm.index(line, beam));
        });
        connect(view, &ImageView::cleared, this, [this] { stick(std::nullopt); });
        connect(view, &ImageView::windowLevelDragged, this, &MainWindow::changeDisplayLevels);
    }
    connect(cloud_, &CloudView::hovered, this, [this](qint64 cell) { showHover(static_cast<std::size_t>(cell), cloud_); });
    connect(cloud_, &CloudView::hoverLeft, this, [this] { showHover(std::nullopt, cloud_); });
    connect(cloud_, &CloudView::clicked, this, [this](qint64 cell) { stick(static_cast<std::size_t>(cell)); });
    connect(cloud_, &CloudView::contextMenuRequested, this, [this](const QPoint& position, qint64 cell) {
        QMenu menu;
        if (cell >= 0) menu.addAction(tr("Fly to this point"), this, [this, cell] { cloud_->flyTo(cell); });
        menu.addAction(tr("View from scanner"), cloud_, &CloudView::viewFromScanner);
        menu.addAction(tr("Fit"), cloud_, &CloudView::zoomToFit);
        menu.exec(position);
    });
    connect(cloud_, &CloudView::drawnFractionChanged, this, [this](double fraction) {
        cloudPane_->setRemark(fraction >= 1.0 ? QString() : tr("%1 % of the points drawn").arg(std::lround(fraction * 100)));
    });
}

void MainWindow::changeSettings(const Settings& settings, bool dragging) {
    if (settings == session_.settings()) return;
    undo_->push(
        new SettingsChange(session_.settings(), settings, dragging ? drag_ : 0, [this](const Settings& s) { session_.setSettings(s); }));
}

void MainWindow::usePreset(const Preset& preset) {
    panel_->setPreset(preset);
    memory_.keep("edges/preset", QString::fromStdString(preset.path.empty() ? preset.name : preset.path));
    changeSettings(preset.settings, false);
    panel_->show(session_.settings());
}

void MainWindow::useSettings(const Settings& settings) {
    session_.setSettings(settings);
    panel_->show(session_.settings());
}

void MainWindow::startWith(const Preset& preset, const Settings& settings) {
    starting_ = true;
    panel_->setPreset(preset);
    useSettings(settings);
    starting_ = false;
}

void MainWindow::openFile(const QString& path, const ReadingOptions& options) { openSeries({path}, options); }

void MainWindow::openSeries(const QStringList& paths, const ReadingOptions& options) {
    if (paths.isEmpty()) return;
    series_ = paths;
    seriesPlace_ = 0;
    openOptions_ = options;
    straighten_->setChecked(options.straighten);
    session_.open(paths.front(), options);
}

void MainWindow::straightenBeams(bool wanted) {
    if (openedPath_.isEmpty()) {
        straighten_->setChecked(false);
        notice_->showNotice(NoticeBar::Kind::Warning,
                            tr("There is no file on the screen whose beams could be straightened: open one first."));
        return;
    }
    openOptions_.straighten = wanted;
    straighten_->setChecked(wanted);
    session_.open(openedPath_, openOptions_);
}

void MainWindow::openDemo() {
    series_.clear();
    openOptions_ = {};
    straighten_->setChecked(false);
    session_.openDemo();
}

void MainWindow::arrangePanes() {
    const Qt::Orientation wanted = width() >= kWideScreen ? Qt::Horizontal : Qt::Vertical;
    if (images_->orientation() == wanted) return;
    images_->setOrientation(wanted);
    views_->setSizes(wanted == Qt::Horizontal ? QList<int>{2000, 1000} : QList<int>{1000, 1400});
}

void MainWindow::maximise(Pane* pane) {
    maximised_ = maximised_ == pane ? nullptr : pane;
    for (Pane* each : {grayPane_, edgePane_, cloudPane_}) each->setVisible(maximised_ == nullptr || maximised_ == each);
    images_->setVisible(maximised_ != cloudPane_);
}

void MainWindow::remember() {
    memory_.keep("window/geometry", saveGeometry());
    memory_.keep("window/state", saveState());
    memory_.keep("window/views", views_->saveState());
    memory_.keep("window/images", images_->saveState());
    memory_.write();
}

void MainWindow::restoreLayout() {
    restoreGeometry(memory_.bytes("window/geometry"));
    restoreState(memory_.bytes("window/state"));
    images_->restoreState(memory_.bytes("window/images"));
    if (!views_->restoreState(memory_.bytes("window/views"))) views_->setSizes({1000, 1400});
    arrangePanes();
    // A window on a screen that is gone is pulled back.
    bool onScreen = false;
    for (const QScreen* screen : QGuiApplication::screens()) onScreen = onScreen || screen->availableGeometry().intersects(geometry());
    if (!onScreen) move(QGuiApplication::primaryScreen()->availableGeometry().topLeft());
    const QString preset = memory_.text("edges/preset");
    if (const auto found = findPreset(preset.toStdString()); !preset.isEmpty() && found) panel_->setPreset(*found);
    if (!memory_.flag("edges/ratio-locked", true)) panel_->setRatioLocked(false);
}

void MainWindow::resetLayout() {
    if (maximised_ != nullptr) maximise(maximised_);
    dock_->show();
    dock_->setFloating(false);
    addDockWidget(Qt::RightDockWidgetArea, dock_);
    images_->setSizes({1000, 1000});
    views_->setSizes(images_->orientation() == Qt::Horizontal ? QList<int>{2000, 1000} : QList<int>{1000, 1400});
    rememberTimer_.start();
}

QImage MainWindow::screenshot() {
    const QImage cloud = cloud_->grabFrame(CloudView::Points::All);
    cloudPane_->setRemark(QString()); // true of this picture; the next frame says again what it draws
    QImage image = grab().toImage();
    // What grab() makes of an OpenGL child depends on the platform: the view's own picture goes there.
    QPainter painter(&image);
    painter.drawImage(QRect(cloud_->mapTo(this, QPoint(0, 0)), cloud_->size()), cloud);
    return image;
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    arrangePanes();
    rememberTimer_.start();
}

void MainWindow::moveEvent(QMoveEvent* event) {
    QMainWindow::moveEvent(event);
    rememberTimer_.start();
}

void MainWindow::closeEvent(QCloseEvent* event) {
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
    openSeries(paths);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    // Esc: the job first, then the crosshair.
    if (event->key() != Qt::Key_Escape) {
        QMainWindow::keyPressEvent(event);
        return;
    }
    if (session_.opening()) {
        session_.cancel();
        notice_->showNotice(NoticeBar::Kind::Warning, tr("Cancelled; what was on the screen stays."));
    } else if (notice_->isVisible())
        notice_->hide();
    else if (maximised_ != nullptr)
        maximise(maximised_);
    else {
        stick(std::nullopt);
        forgetTrail();
    }
}

} // namespace edgescan::ui
