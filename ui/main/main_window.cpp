// Builds the window and lays it out.
#include "ui/main/main_window.h"

#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/cloud/cloud_view.h"
#include "ui/cloud/gl_check.h"
#include "ui/image/image_view.h"
#include "ui/live/live_panel.h"
#include "ui/live/timeline.h"
#include "ui/main/menus.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/status_line.h"
#include "ui/session/memory.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QPainter>
#include <QScreen>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>

namespace edgescan::ui {
namespace {

constexpr int kWideScreen = 1920; // from here on the three views stand in one row
constexpr int kRememberAfterMs = 300;

} // namespace

MainWindow::MainWindow(Memory& memory, QWidget* parent)
    : QMainWindow(parent), memory_(memory), gray_(new ImageView), edges_(new ImageView(gray_->viewPort())), cloud_(new CloudView),
      panel_(new EdgesPanel), livePanel_(new LivePanel), timeline_(new Timeline), notice_(new NoticeBar), status_(new StatusLine),
      views_(session_, *gray_, *edges_, *cloud_), files_(session_, *notice_, memory), exports_(session_, files_, *notice_, memory),
      tuning_(session_, *panel_, *notice_, memory), live_(session_, *livePanel_, *timeline_, views_, files_, *notice_, memory),
      explanation_(session_, views_, *notice_) {
    setObjectName("edgescan");
    setWindowTitle("EdgeScan");
    setAcceptDrops(true);
    layOutViews();
    addDock(tr("Edges"), "dock-edges", panel_);
    setStatusBar(status_);
    for (const Command& menu : menusOf(*this, memory_)) addCommands(*menuBar()->addMenu(menu.text), menu.submenu, *this, memory_);
    QApplication::instance()->installEventFilter(new KeysOfFocus(this));
    connectSession();
    rememberTimer_.setSingleShot(true);
    rememberTimer_.setInterval(kRememberAfterMs);
    connect(&rememberTimer_, &QTimer::timeout, this, &MainWindow::remember);
    resize(1600, 950);
    restoreLayout();
    status_->showRenderer(checkGl().renderer);
}

void MainWindow::layOutViews() {
    gray_->setObjectName("gray");
    edges_->setObjectName("edges");
    cloud_->setObjectName("cloud");
    auto* grayPane = new Pane(tr("Range image"), gray_);
    auto* edgePane = new Pane(tr("Edge map"), edges_);
    auto* cloudPane = new Pane(tr("Cloud"), cloud_);
    panes_ = {grayPane, edgePane, cloudPane};
    for (Pane* pane : panes_) connect(pane, &Pane::maximiseWanted, this, [this, pane] { maximise(pane); });
    connect(&views_, &LinkedViews::grayRemark, grayPane, &Pane::setRemark);
    connect(&views_, &LinkedViews::cloudRemark, cloudPane, &Pane::setRemark);

    images_ = new QSplitter(Qt::Vertical);
    images_->addWidget(grayPane);
    images_->addWidget(edgePane);
    splitter_ = new QSplitter(Qt::Horizontal);
    splitter_->addWidget(images_);
    splitter_->addWidget(cloudPane);
    for (QSplitter* splitter : {images_, splitter_}) {
        splitter->setChildrenCollapsible(false);
        connect(splitter, &QSplitter::splitterMoved, this, [this] { rememberTimer_.start(); });
    }
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice_);
    column->addWidget(splitter_, 1);
    column->addWidget(timeline_);
    column->addWidget(livePanel_);
    setCentralWidget(centre);
}

void MainWindow::addDock(const QString& title, const char* name, QWidget* content) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(Qt::RightDockWidgetArea, dock);
}

void MainWindow::connectSession() {
    connect(&session_, &Session::workStarted, status_, &StatusLine::startWork);
    connect(&session_, &Session::workProgressed, status_, &StatusLine::showProgress);
    connect(&session_, &Session::workEnded, status_, &StatusLine::endWork);
    connect(status_, &StatusLine::cancelWanted, &session_, &Session::cancel);
    connect(&session_, &Session::failed, this, [this](const QString& sentence) { notice_->showNotice(NoticeBar::Kind::Error, sentence); });
    connect(&views_, &LinkedViews::probed, status_, &StatusLine::showProbe);
    connect(&session_, &Session::pictureReady, this, [this] {
        const Detection& detection = *session_.picture()->detection;
        status_->showCounts(detection);
        status_->showPlace(*detection.scan);
        status_->showTime(tuning_.updateMs());
        emit pictureShown(); // the controllers were told before
    });
    connect(&session_, &Session::streamChanged, this, [this] {
        setWindowTitle(QString::fromStdString(session_.picture()->detection->scan->name) + files_.placeInSeries() + " - EdgeScan");
    });
}

void MainWindow::arrangePanes() {
    const Qt::Orientation wanted = width() >= kWideScreen ? Qt::Horizontal : Qt::Vertical;
    if (images_->orientation() == wanted) return;
    images_->setOrientation(wanted);
    splitter_->setSizes(usualSizes());
}

QList<int> MainWindow::usualSizes() const {
    return images_->orientation() == Qt::Horizontal ? QList<int>{2000, 1000} : QList<int>{1000, 1400};
}

void MainWindow::maximise(Pane* pane) {
    maximised_ = maximised_ == pane ? nullptr : pane;
    for (Pane* each : panes_) each->setVisible(maximised_ == nullptr || maximised_ == each);
    images_->setVisible(maximised_ == nullptr || maximised_->content() != cloud_);
}

void MainWindow::remember() {
    memory_.keep("window/geometry", saveGeometry());
    memory_.keep("window/state", saveState());
    memory_.keep("window/views", splitter_->saveState());
    memory_.keep("window/images", images_->saveState());
}

void MainWindow::restoreLayout() {
    restoreGeometry(memory_.bytes("window/geometry"));
    restoreState(memory_.bytes("window/state"));
    images_->restoreState(memory_.bytes("window/images"));
    if (!splitter_->restoreState(memory_.bytes("window/views"))) splitter_->setSizes({1000, 1400});
    arrangePanes();
    // A window on a screen that is gone is pulled back.
    bool onScreen = false;
    for (const QScreen* screen : QGuiApplication::screens()) onScreen = onScreen || screen->availableGeometry().intersects(geometry());
    if (!onScreen) move(QGuiApplication::primaryScreen()->availableGeometry().topLeft());
}

void MainWindow::resetLayout() {
    if (maximised_ != nullptr) maximise(maximised_);
    for (QDockWidget* dock : findChildren<QDockWidget*>()) {
        dock->show();
        dock->setFloating(false);
        addDockWidget(Qt::RightDockWidgetArea, dock);
    }
    images_->setSizes({1000, 1000});
    splitter_->setSizes(usualSizes());
    rememberTimer_.start();
}

QImage MainWindow::screenshot() {
    const QImage cloud = cloud_->grabFrame(CloudView::Points::All);
    panes_.back()->setRemark(QString()); // true of this picture; the next frame says again what it draws
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
    files_.open(paths);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    // Esc: the job first, then the notice, the view that is alone, the crosshair.
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
        views_.pin(std::nullopt);
        explanation_.forgetTrail();
    }
}

} // namespace edgescan::ui
