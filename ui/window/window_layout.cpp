// Lays the window out; what Esc ends, and the question before it closes.
#include "ui/window/main_window.h"

#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/base/window_room.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/keys/commands.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/cab_mode.h"
#include "ui/window/docks.h"
#include "ui/window/pane_places.h"
#include "ui/window/side_column.h"
#include "ui/window/start.h"
#include "ui/window/tool_bar.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QCloseEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QStyle>
#include <QWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr double kImages = 0.38;                            // of the window's width: both images, one above the other
constexpr double kPanels = 0.45;                            // of the width, at most
constexpr double kLeastCloud = 0.22, kLeastOfNarrow = 0.38; // of the width; of that of a narrow window
constexpr int kNarrow = 1100;                               // px of the window: in a narrower one the images get their share of it
constexpr int kLargeImage = 600;                            // px of a square one that is large
constexpr int kRangeWindowFrom = 600;                       // px of the window's height
constexpr int kLeastImages = 140;                           // px of width
constexpr int kLeastImage = 96;                             // px of height; in a lower column the range image is alone

// Widths at which the cloud is large and the images stay readable.
int smallImages(int window) {
    const int wanted = window < kNarrow ? static_cast<int>(0.23 * window) : static_cast<int>(std::lround(48 + 0.1843 * window));
    return std::clamp(wanted, 140, 560);
}

// A small screen is filled; on a large one some space is left.
QSize usualWindow(const QRect& screen) {
    constexpr int kSmall = 1600;
    if (screen.width() <= kSmall) return screen.size();
    return {std::max(kSmall, static_cast<int>(0.85 * screen.width())), static_cast<int>(0.88 * screen.height())};
}

} // namespace

/// Panels and images get a suitable width, the cloud gets the rest. Docks that the operator folded, opened or dragged stay unchanged, as
/// far as the cloud keeps its share. Folding order: the panels, the second image, the first image, the column at the side.
void MainWindow::arrange() {
    if (cab_->on()) return docks_->cover(QRect(splitter_->mapTo(this, QPoint()), side_->mapTo(this, side_->rect().bottomRight())));
    if (!isVisible()) return;
    const int wide = width();
    const int leastCloud = std::max(viewer_.cloud.minimumWidth(), static_cast<int>(wide * (wide < kNarrow ? kLeastOfNarrow : kLeastCloud)));
    const int leastImages = std::max(kLeastImages, pictures_->minimumSizeHint().width());
    const int mostPanels = static_cast<int>(wide * kPanels);
    docks_->fit(mostPanels);
    const int panels = docks_->setWidths(mostPanels), column = side_->sizeHint().width();
    const bool large = places_->share() == Share::Images; // a large image counts more than the column
    const int needed = large ? leastImages + splitter_->handleWidth() + kLargeImage : leastCloud;
    side_->setVisible(columnWanted_ && wide - panels - column >= needed);
    const int views = wide - panels - (side_->isHidden() ? 0 : column), most = views - leastCloud - splitter_->handleWidth();
    const bool tooNarrow = most < leastImages;
    foldImages(tooNarrow, panels != 0);
    showImages();
    if (maximised_ != nullptr || !roomForImages_) return;
    int wanted = static_cast<int>(wide * kImages);
    if (places_->share() == Share::Cloud || wide < kNarrow) wanted = smallImages(wide);
    if (places_->share() == Share::Images) wanted = views - splitter_->handleWidth() - largeImage();
    if (!imagesDragged_ || pictures_->width() > most) setImagesWidth(std::clamp(wanted, leastImages, most));
}

void MainWindow::showColumn(bool on) {
    columnWanted_ = on;
    arrange();
}

/// The badge has the same place whatever it says: no tool moves. A narrow window gives it what its tools leave.
void MainWindow::fitOrigin() {
    constexpr int kLeastFrame = 8; // px, of its bar
    StateBadge& badge = viewer_.origin;
    const QMargins margins = badge.parentWidget()->layout()->contentsMargins();
    const int around = 2 * (style()->pixelMetric(QStyle::PM_ToolBarItemMargin) + style()->pixelMetric(QStyle::PM_ToolBarFrameWidth));
    const int frame = margins.left() + margins.right() + std::max(kLeastFrame, around);
    viewer_.tools.setMost(screen()->size().width() - badge.minimumSizeHint().width() - frame); // with large letters on a small screen
    const int wanted = badge.widthFor("2026-11-19 08:12:05 UTC");                              // its second line
    const int room = width() - viewer_.tools.minimumWidth() - frame;
    badge.setRoom(std::max(badge.minimumSizeHint().width(), std::min(wanted, room)));
    viewer_.tools.reserve(badge.sizeHint().width() + frame);
}

/// Says once where they are.
void MainWindow::foldImages(bool fold, bool byPanel) {
    if (std::exchange(roomForImages_, !fold) == !fold || !fold || !byPanel || !viewer_.engine.picture()) return;
    if (!std::exchange(saidThatImagesFold_, true))
        viewer_.notice.showHint(tr("The window has no room for the images next to this panel: they come back when you fold it."));
}

/// Px of the width of the image that is in the place of the cloud: as high as the views, in its own aspect.
int MainWindow::largeImage() const {
    const ViewPort& port = *viewer_.gray.viewPort();
    const int high = splitter_->height() - panes_.front()->minimumSizeHint().height();
    QSizeF shape(port.imageSize().width() * port.aspect(), port.imageSize().height());
    if (port.turn().quarter) shape.transpose();
    const double aspect = shape.isEmpty() ? 1.0 : shape.width() / shape.height();
    return std::max(kLargeImage, static_cast<int>(std::ceil(aspect * high)));
}

void MainWindow::setImagesWidth(int width) {
    splitter_->setSizes({width, std::max(1, splitter_->width() - width - splitter_->handleWidth())});
    imagesDragged_ = false;
}

void MainWindow::maximise(Pane* pane) {
    maximised_ = maximised_ == pane ? nullptr : pane;
    for (Pane* each : panes_) each->showAlone(maximised_ == each);
    showImages();
}

/// What has room next to the cloud, or the maximised view. The range window not if the images would lose their space, and not next to the
/// edge map alone.
void MainWindow::showImages() {
    const bool all = maximised_ == nullptr;
    const int room = splitter_->height() - (height() >= kRangeWindowFrom ? viewer_.rangeWindow.sizeHint().height() : 0);
    const bool both = room >= 2 * (kLeastImage + panes_.front()->minimumSizeHint().height());
    const Pane* large = places_->inCloudsPlace();
    const Pane* first = large == panes_.back() ? panes_.front() : panes_.back(); // the cloud is never the one that has no room
    for (Pane* each : panes_) {
        const bool fits = each == large || (roomForImages_ && (both || each == first));
        each->setVisible(all ? fits : maximised_ == each);
    }
    pictures_->setVisible(all ? roomForImages_ : maximised_ != large);
    viewer_.rangeWindow.setVisible((all || maximised_ == panes_.front()) && height() >= kRangeWindowFrom);
}

void MainWindow::remember() {
    if (cab_->on()) return; // the layout outside cab mode is the one to store
    viewer_.preferences.keep("window/geometry", saveGeometry());
    if (docks_->locked()) return; // by the start page: all panels are hidden
    viewer_.preferences.keep("window/state", saveState());
    viewer_.preferences.keep("window/views", splitter_->saveState());
    viewer_.preferences.keep("window/images", images_->saveState());
    viewer_.preferences.keep("window/images-dragged", imagesDragged_);
    viewer_.preferences.keep("window/panel-dragged", QString::number(docks_->draggedWidth()));
    viewer_.preferences.keep("window/table-dragged", QString::number(docks_->draggedTableHeight()));
}

void MainWindow::restoreLayout() {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    const QSize title(0, style()->pixelMetric(QStyle::PM_TitleBarHeight));
    const QSize usual = usualWindow({screen.topLeft(), screen.size() - title});
    const bool fills = usual == screen.size() - title;
    resize(fills ? screen.size() : usual);
    if (fills) setWindowState(windowState() | Qt::WindowMaximized);
    restoreGeometry(viewer_.preferences.bytes("window/geometry"));
    restoreState(viewer_.preferences.bytes("window/state"));
    images_->restoreState(viewer_.preferences.bytes("window/images"));
    images_->setOrientation(Qt::Vertical); // a state of an earlier version may have another one
    places_->use(viewer_.preferences.text("window/large-view"));
    splitter_->restoreState(viewer_.preferences.bytes("window/views"));
    imagesDragged_ = viewer_.preferences.flag("window/images-dragged", false);
    docks_->setDraggedWidth(viewer_.preferences.text("window/panel-dragged").toInt());
    docks_->setDraggedTableHeight(viewer_.preferences.text("window/table-dragged").toInt());
    // A window on a screen that no longer exists is moved back; a window of a larger screen is shrunk.
    const QScreen* at = nullptr;
    for (const QScreen* each : QGuiApplication::screens()) {
        if (each->availableGeometry().intersects(geometry())) at = each;
    }
    const QRect room = at != nullptr ? at->availableGeometry() : screen;
    if (!isMaximized() && !isFullScreen()) resize(size().boundedTo(room.size() - title));
    // Qt leaves 20 px above a restored window for a title; where no window manager makes the window as large as the screen, its foot is off
    // it.
    const bool isTooLow = isMaximized() && !room.contains(geometry());
    if (at == nullptr || isTooLow) move(room.topLeft());
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
    places_->use(QString());
    imagesDragged_ = false;
    images_->setSizes({1000, 1000});
    for (QAction* action : actions()) {
        const QString key = action->property(kInSessions).toString();
        if (key == "view/true-angles" || key.startsWith("view/images-")) action->setChecked(false);
    }
    docks_->reset();
    rememberTimer_.start();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    fitOrigin();
    arrange();
    followFrame();
    rememberTimer_.start();
}

/// A dock, a notice or the strip takes room of the views, or gives it back; images that are shown again come back at their old width.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if ((watched == splitter_ || watched == pictures_) && event->type() == QEvent::Resize)
        QMetaObject::invokeMethod(this, &MainWindow::arrange, Qt::QueuedConnection);
    return QMainWindow::eventFilter(watched, event);
}

/// The window itself gets the mouse only at the edges of its docks.
bool MainWindow::event(QEvent* event) {
    // The size from before it was maximised may be that of another screen, or of another scale. It may arrive before or after this event.
    if (event->type() == QEvent::WindowStateChange && !isMaximized() && !isFullScreen()) {
        framed_ = false;
        QTimer::singleShot(0, this, &MainWindow::fitScreen);
    }
    // Qt would give the focus to the first button of a legend: the next Space would switch it.
    if (event->type() == QEvent::WindowActivate && focusWidget() == nullptr && viewer_.cloud.isVisible()) viewer_.cloud.setFocus();
    const bool done = QMainWindow::event(event);
    if (event->type() == QEvent::MouseButtonPress && event->isAccepted()) docks_->setHeld(true);
    if (event->type() == QEvent::MouseButtonRelease) {
        docks_->setHeld(false);
        arrange(); // at once: nothing moves later under the pointer
    }
    return done;
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    fitOrigin();
    arrange();
}

void MainWindow::moveEvent(QMoveEvent* event) {
    QMainWindow::moveEvent(event);
    followFrame();
    rememberTimer_.start();
}

/// Changes of the layout in cab mode.
void MainWindow::useCab(bool on) {
    viewsRow_->setDirection(on ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    auto& strips = static_cast<QBoxLayout&>(*viewer_.livePanel.parentWidget()->layout());
    QWidget* menuRow = viewer_.notice.parentWidget();
    on ? strips.insertWidget(strips.indexOf(&viewer_.livePanel) + 1, menuRow) : setMenuWidget(menuRow);
    menuRow->show();
    docks_->lend(cab_->frame().panels(), on);
    side_->setStrip(on);
    side_->setVisible(on); // on the desk where it has room: arrange()
    viewer_.tools.setVisible(!on);
    findChild<QToolBar*>("badge-bar")->setVisible(!on); // the head of the cab has its own badge
    showAlone(on ? &viewer_.cloud : nullptr);
    for (Pane* pane : panes_) pane->setTitled(!on); // the corner picture has its own text
}

void MainWindow::lockDocks(DockLock by, bool on) { docks_->setLocked(by, on); }

void MainWindow::showAlone(const QWidget* view) {
    Pane* wanted = nullptr;
    for (Pane* pane : panes_) wanted = pane->content() == view ? pane : wanted;
    if (maximised_ != nullptr) maximise(maximised_);
    if (wanted != nullptr) maximise(wanted);
}

void MainWindow::quit() {
    byHand_ = true;
    close();
    byHand_ = false;
}

void MainWindow::end() {
    viewer_.engine.works().cancelAll();
    viewer_.live.scanner().disconnectScanner();
    remember();
    QApplication::exit(0); // of all event loops: open questions end as if they were cancelled
}

bool MainWindow::mayClose(bool byHand) {
    const bool records = viewer_.live.scanner().recording();
    const bool byGlove = byHand && cab_->on(); // it may have meant the button that leaves cab mode
    const bool targets = viewer_.targets.unsaved(), edits = viewer_.rocks.unsaved();
    const bool lost = targets || edits;
    if (!records && !viewer_.engine.saving() && !lost && !byGlove) return true;
    const bool writes = records || viewer_.engine.saving();
    QMessageBox box(QMessageBox::Warning, tr("Close EdgeScan?"),
                    records            ? tr("A recording is being written.")
                    : writes           ? tr("A file is still being written.")
                    : targets && edits ? tr("Your targets and your edits of rocks are not stored.")
                    : targets          ? tr("Your targets are not stored.")
                    : edits            ? tr("Your edits of rocks are not stored.")
                                       : tr("This ends the program."),
                    QMessageBox::Cancel, this);
    box.setObjectName("close-question");
    box.setInformativeText(records  ? tr("Closing ends the recording. What was recorded so far remains in its file.")
                           : writes ? tr("Closing waits until it is complete.")
                           : lost   ? tr("The disk refused them. EdgeScan tries again as it closes; what it cannot write then is lost.")
                                    : tr("To leave cab mode only, cancel, then hold the button “Hold to leave” for one second."));
    QPushButton* end = box.addButton(records ? tr("End the Recording and Close") : tr("Close EdgeScan"), QMessageBox::DestructiveRole);
    end->setObjectName("end-and-close");
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == end;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose(byHand_ || event->spontaneous())) return event->ignore();
    viewer_.live.scanner().disconnectScanner();
    remember();
    QMainWindow::closeEvent(event);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    auto* number = qobject_cast<QAbstractSpinBox*>(focusWidget());
    if (number != nullptr && (isEnter || event->key() == Qt::Key_Escape))
        number->clearFocus(); // the next key is a command
    else if (event->key() == Qt::Key_Escape)
        escape();
    else if (event->key() != Qt::Key_Backspace || !viewer_.measures.removeLastPick())
        QMainWindow::keyPressEvent(event);
}

// One press ends one thing, whichever view has the keyboard focus; docs/guide/keys.md has this order.
void MainWindow::escape() {
    if (viewer_.engine.opening()) { // a save or a comparison has its button
        viewer_.engine.cancel();
        viewer_.notice.showHint(tr("Cancelled; what was on the screen stays."));
        return;
    }
    if (leaveTool() || viewer_.explanation.closeCard() || viewer_.notice.fold()) return;
    if (viewer_.notice.isVisible())
        viewer_.notice.closeShown();
    else if (viewer_.livePanel.closeAddress())
        return;
    else if (maximised_ != nullptr && !cab_->on())
        maximise(maximised_);
    else if (endTour(*this))
        viewer_.notice.showHint(tr("The tour has ended; Help > Tour begins it again."));
    else if (!viewer_.selection.cells().empty())
        viewer_.selection.select({});
    else if (viewer_.sections.close())
        return;
    else {
        viewer_.views.clearPin();
        viewer_.targets.chooseMeasure(std::nullopt);
        viewer_.rocks.select({});
    }
}

/// With its unfinished clicks, and the hint about them. False: no tool is in use.
bool MainWindow::leaveTool() {
    const bool isRocks = viewer_.rocks.tool() != RockTool::None;
    const Tool tool = viewer_.views.tool();
    const bool pinsOnRocks = tool == Tool::Pin && viewer_.rocks.shown() && !viewer_.views.choosesOnly();
    if (!isRocks && !pinsOnRocks && (tool == Tool::Pin || tool == Tool::Why)) return false; // Why ends with its card
    isRocks ? viewer_.rocks.useTool(RockTool::None) : viewer_.views.setTool(Tool::Pin);
    if (pinsOnRocks) viewer_.views.setChoosesOnly(true);
    viewer_.notice.endPassing();
    return true;
}

} // namespace edgescan::ui
