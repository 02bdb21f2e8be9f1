// Divides the window between cloud, images and panels, and remembers the operator's layout.
#include "ui/window/main_window.h"

#include "ui/base/pane.h"
#include "ui/base/window_room.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QScreen>
#include <QSplitter>
#include <QStyle>
#include <QWindow>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace edgescan::ui {
namespace {

constexpr int kFoldedBelow = 1100;              // px of the window: in a narrower one the panels are folded unless the operator opens them
constexpr double kCloudShare = 0.55;            // of the width, minimum
constexpr double kImagesFirstShare = 2.0 / 3.0; // of the views' width, for both images side by side
constexpr int kRangeWindowFrom = 600;           // px of the window's height
constexpr int kLeastPanel = 240;                // px; narrower panels cut off text
constexpr int kOpenFrame = 2;                   // px: widths that differ by less count as equal

// Widths at which the cloud has most of the window and images and panel stay readable.
int usualImages(int window) {
    const int wanted = window < kFoldedBelow ? static_cast<int>(0.23 * window) : static_cast<int>(std::lround(48 + 0.1843 * window));
    return std::clamp(wanted, 140, 560);
}
int usualPanel(int window) { return std::clamp(static_cast<int>(std::lround(260 + 0.1656 * (window - 1280))), kLeastPanel, 400); }

// A small screen is filled; on a large one some space is left.
QSize usualWindow(const QRect& screen) {
    constexpr int kSmall = 1600;
    if (screen.width() <= kSmall) return screen.size();
    return {std::max(kSmall, static_cast<int>(0.85 * screen.width())), static_cast<int>(0.88 * screen.height())};
}

} // namespace

void MainWindow::arrange() {
    if (!isVisible() || cab_->on()) return;
    const int wide = width();
    for (QDockWidget* dock : docks_) {
        const QString byHand = dock->property(kByHand).toString();
        const bool open = byHand.isEmpty() ? wide >= kFoldedBelow : byHand == "open";
        if (dock->isHidden() != open) continue;
        dock->setVisible(open);
        // Docked with others it gets their width and may be cut off: checked when its width is known.
        if (open) QMetaObject::invokeMethod(this, &MainWindow::arrange, Qt::QueuedConnection);
    }
    const auto asArranged = [](int now, int arranged) { return arranged == 0 || std::abs(now - arranged) <= kOpenFrame; };
    int panel = 0;
    for (QDockWidget* dock : docks_) {
        if (dock->isHidden() || dock->isFloating()) continue;
        const int usual = std::max(usualPanel(wide), dock->minimumSizeHint().width());
        // no operator wants a panel that cuts off text
        const bool follows = asArranged(dock->width(), arrangedPanel_) || dock->width() < kLeastPanel;
        if (follows) resizeDocks({dock}, {arrangedPanel_ = usual}, Qt::Horizontal);
        panel = std::max(panel, follows ? usual : dock->width()); // its width changes later
    }
    if (maximised_ != nullptr) return;
    const int most = static_cast<int>(wide * (1.0 - kCloudShare)) - panel;
    if (asArranged(pictures_->width(), arrangedImages_))
        setImagesWidth(places_->imagesFirst() ? static_cast<int>(kImagesFirstShare * splitter_->width())
                                              : std::min(usualImages(wide), std::max(most, pictures_->minimumSizeHint().width())));
    showRangeWindow();
}

void MainWindow::setImagesWidth(int width) {
    arrangedImages_ = width;
    splitter_->setSizes({width, std::max(1, splitter_->width() - width - splitter_->handleWidth())});
}

void MainWindow::maximise(Pane* pane) {
    maximised_ = maximised_ == pane ? nullptr : pane;
    for (Pane* each : panes_) {
        each->setVisible(maximised_ == nullptr || maximised_ == each);
        each->showAlone(maximised_ == each);
    }
    pictures_->setVisible(maximised_ == nullptr || maximised_ != places_->inCloudsPlace());
    viewer_.views.setCaptionIn(maximised_ == nullptr ? nullptr : qobject_cast<const ImageView*>(maximised_->content()));
    showRangeWindow();
}

/// Not if the images would lose their space, and not next to the edge map alone.
void MainWindow::showRangeWindow() {
    const bool wanted = maximised_ == nullptr || maximised_->content() == &viewer_.gray;
    viewer_.rangeWindow.setVisible(wanted && height() >= kRangeWindowFrom);
}

void MainWindow::remember() {
    if (cab_->on()) return; // the layout outside cab mode is the one to store
    viewer_.preferences.keep("window/geometry", saveGeometry());
    viewer_.preferences.keep("window/state", saveState());
    viewer_.preferences.keep("window/views", splitter_->saveState());
    viewer_.preferences.keep("window/images", images_->saveState());
    viewer_.preferences.keep("window/images-width", QString::number(arrangedImages_));
    viewer_.preferences.keep("window/panel-width", QString::number(arrangedPanel_));
}

void MainWindow::restoreLayout() {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    const QSize title(0, style()->pixelMetric(QStyle::PM_TitleBarHeight));
    resize(usualWindow({screen.topLeft(), screen.size() - title}));
    restoreGeometry(viewer_.preferences.bytes("window/geometry"));
    restoreState(viewer_.preferences.bytes("window/state"));
    images_->restoreState(viewer_.preferences.bytes("window/images"));
    places_->orient();
    places_->use(viewer_.preferences.text("window/large-view"));
    splitter_->restoreState(viewer_.preferences.bytes("window/views"));
    arrangedImages_ = viewer_.preferences.text("window/images-width").toInt();
    arrangedPanel_ = viewer_.preferences.text("window/panel-width").toInt();
    // A window on a screen that no longer exists is moved back; a window of a larger screen is shrunk.
    const QScreen* at = nullptr;
    for (const QScreen* each : QGuiApplication::screens()) {
        if (each->availableGeometry().intersects(geometry())) at = each;
    }
    const QRect room = at != nullptr ? at->availableGeometry() : screen;
    if (!isMaximized() && !isFullScreen()) resize(size().boundedTo(room.size() - title));
    if (at == nullptr) move(room.topLeft());
}

void MainWindow::fitScreen() { fitIntoScreen(*this); }

/// The desktop reports the width of the frame only after it has placed the window.
void MainWindow::followFrame() {
    if (framed_ || !isVisible() || windowHandle() == nullptr || windowHandle()->frameMargins().isNull()) return;
    framed_ = true;
    QTimer::singleShot(0, this, &MainWindow::fitScreen); // not while the window is being moved
}

void MainWindow::resetLayout() {
    if (cab_->on()) return;
    if (maximised_ != nullptr) maximise(maximised_);
    for (QDockWidget* dock : docks_) {
        dock->setProperty(kByHand, QString());
        viewer_.preferences.keep("window/" + dock->objectName(), QString());
        dock->setFloating(false);
        addDockWidget(Qt::RightDockWidgetArea, dock);
    }
    places_->use(QString());
    places_->setImagesFirst(false);
    images_->setSizes({1000, 1000});
    arrangedImages_ = arrangedPanel_ = 0;
    arrange();
    rememberTimer_.start();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    arrange();
    followFrame();
    rememberTimer_.start();
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    arrange();
}

void MainWindow::moveEvent(QMoveEvent* event) {
    QMainWindow::moveEvent(event);
    followFrame();
    rememberTimer_.start();
}

} // namespace edgescan::ui
