// The window in a cab, and which of its views is large.
#include "ui/window/cab_mode.h"

#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/language/catalogue.h"
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/source.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/cab/gloves.h"
#include "ui/panels/cab/keypad.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/keys/commands.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/scale_plate.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/docks.h"
#include "ui/window/main_window.h"
#include "ui/window/side_column.h"
#include "ui/window/theme.h"
#include "ui/window/tool_bar.h"

#include <QActionGroup>
#include <QApplication>
#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTouchEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace edgescan::ui {
namespace {

constexpr int kCancelAfterMs = 300;

} // namespace

CabMode::CabMode(MainWindow& window, QWidget* middle)
    : QObject(&window), window_(window), badge_(new StateBadge), frame_(new CabFrame(middle, badge_)),
      corner_(new CornerPicture(&window.viewer().views.cloud())), back_(new CornerPicture(&window.viewer().views.gray())),
      zoom_(new QWidget), menu_(new QMenu(&window)), keypad_(new Keypad(&window)), gloveMenus_(new GloveMenus(&window)),
      swipes_(new Swipes(&window)), tune_(gloveButton("cab-tune", "tune", tr("Tune"))) {
    badge_->setTwoLines();
    badge_->setObjectName("cab-origin");
    corner_->setObjectName("cab-corner");
    back_->setObjectName("cab-back");
    corner_->hide();
    back_->hide();
    back_->setWords("⇄ " + QObject::tr("Back to the cloud"));
    addZoom();
    window.setCentralWidget(frame_);
    window.side().add(*zoom_);
    connectHead();
    connect(back_, &CornerPicture::reachChanged, this, [this](int reach) {
        if (large_ != Large::Cloud) imageView().setCovered(reach); // no prompt is below it
    });
    for (CornerPicture* each : {corner_, back_}) {
        connect(each, &QAbstractButton::clicked, this, &CabMode::swap);
        connect(each, &CornerPicture::uncovered, this, &CabMode::noteChangeUnder);
    }
    connect(keypad_, &Keypad::closedByKey, this, &CabMode::noteChangeUnder);
    follow();
    nameUndone();
}

CabMode::~CabMode() {
    useTouchWords(false);
    QCoreApplication::setAttribute(Qt::AA_DontShowShortcutsInContextMenus, false);
}

void CabMode::connectHead() {
    CabHead& head = frame_->head();
    connect(head.menu(), &QToolButton::clicked, this, [this, button = head.menu()] {
        fillMenu();
        menu_->popup(button->mapToGlobal(QPoint(0, button->height())));
    });
    connect(head.open(), &QToolButton::clicked, this, [this] { window_.viewer().files.ask(); });
    connect(head.connectScanner(), &QToolButton::clicked, this, [this] {
        LivePanel& live = window_.viewer().live.panel();
        live.setVisible(!live.isVisible() || window_.viewer().live.scanner().connected());
        if (live.isVisible()) live.askAddress();
    });
    connect(head.warnings(), &QToolButton::clicked, &window_.viewer().warnings, &QToolButton::click);
    connect(head.cancel(), &QToolButton::clicked, &window_.viewer().engine.works(), &Works::cancel);
    connect(badge_, &StateBadge::clicked, this, [this] { window_.viewer().notice.showHint(badge_->toolTip()); });
    connect(head.leave(), &HoldButton::held, this, &CabMode::leaveRequested);
    connect(head.leave(), &HoldButton::releasedEarly, this,
            [this] { window_.viewer().notice.showHint(tr("Hold it for one second to leave.")); });
    cancelSoon_.setSingleShot(true);
    cancelSoon_.setInterval(kCancelAfterMs);
    connect(&cancelSoon_, &QTimer::timeout, this, &CabMode::showWork);
    connect(&window_.viewer().engine.works(), &Works::changed, this, [this] {
        const bool none = window_.viewer().engine.works().newest() == nullptr;
        if (none) cancelSoon_.stop();
        if (none || frame_->head().working())
            showWork();
        else if (!cancelSoon_.isActive())
            cancelSoon_.start();
    });
}

/// What a small screen has no button for, then all menus.
void CabMode::fillMenu() {
    menu_->clear();
    CabHead& head = frame_->head();
    if (head.clock()->isHidden()) menu_->addAction(head.clock()->text().simplified())->setEnabled(false);
    for (QToolButton* each : {head.open(), head.connectScanner()}) {
        if (each->isHidden()) menu_->addAction(each->text(), each, &QToolButton::click);
    }
    if (!menu_->isEmpty()) menu_->addSeparator();
    menu_->addActions(window_.menuBar()->actions());
}

/// The tool bar, which has the prompts, is hidden here.
void CabMode::showAsked() { window_.viewer().views.setAsked(on_ ? window_.viewer().tools.shown() : QString()); }

/// Updates the panel and the pictures of this mode.
void CabMode::follow() {
    connect(&window_.viewer().tools, &ToolBar::wordsChanged, this, &CabMode::showAsked);
    connect(&window_, &MainWindow::pictureShown, this, [this] {
        showScan();
        showCorner();
    });
    connect(&window_, &MainWindow::originShown, this, &CabMode::showScan);
    connect(&window_.viewer().views, &LinkedViews::picturesChanged, this, &CabMode::showCorner);
    connect(&window_.viewer().targets, &Targets::cardChanged, this, [this] {
        showPanel();
        showCorner();
    });
    connect(&window_.viewer().measures, &Measures::kindChanged, this, [this] {
        if (on_ && window_.viewer().measures.kind())
            window_.viewer().explanation.closeCard(); // it would take the taps, and cover the cloud
    });
    connect(&window_.viewer().views, &LinkedViews::flippedChanged, this, [this] {
        showPanel();
        showCorner();
    });
    connect(&window_.viewer().rocks, &Rocks::rocksShown, this, &CabMode::showPanel);
    connect(&window_.viewer().rocks, &Rocks::selectionChanged, this, [this] {
        showPanel();
        showCorner();
    });
    connect(&window_.viewer().rocks, &Rocks::shownChanged, this, &CabMode::showPanel);
    connect(&window_.viewer().warnings, &WarningButton::warningsRaised, this, &CabMode::showScan);
    connect(&window_.viewer().warnings, &WarningButton::warningsAcknowledged, this, &CabMode::showScan);
    connect(&window_.viewer().live.scanner(), &ScannerLink::connectedChanged, this, [this](bool connected) {
        LivePanel& live = window_.viewer().live.panel();
        if (on_) live.setVisible(connected || live.offers());
    });
}

/// A cab has no menu in sight that names the step before: the notice does, after the step.
void CabMode::nameUndone() {
    QUndoStack& undo = window_.viewer().undo;
    connect(&undo, &QUndoStack::indexChanged, this, [this, &undo, last = undo.index(), count = undo.count()](int index) mutable {
        const bool undone = index == last - 1 && undo.count() == count; // a step of another scan leaves the stack instead
        const bool redone = index == last + 1 && undo.count() == count && undo.canRedo();
        last = index;
        count = undo.count();
        if (on_ && (undone || redone) && !undo.property(kDrops).toBool()) window_.viewer().notice.showUndone(undo, redone);
    });
}

void CabMode::set(bool on) {
    if (std::exchange(on_, on) == on) return;
    showLarge(Large::Cloud);
    on ? qApp->installEventFilter(this) : qApp->removeEventFilter(this);
    useTouchWords(on);
    QCoreApplication::setAttribute(Qt::AA_DontShowShortcutsInContextMenus, on); // a cab has no keyboard, and each menu counts as such
    window_.viewer().measures.show();                                           // the prompts of the tool in use
    window_.viewer().rocks.useTool(window_.viewer().rocks.tool());
    const QSize size = window_.size();
    auto& application = *qobject_cast<QApplication*>(QApplication::instance());
    if (!on) useTheme(application, false);
    if (!on) zoom_->hide();
    window_.viewer().notice.endPassing(); // a hint about the other mode
    window_.useCab(on);
    lockDocks(on);
    window_.viewer().legend.setBrief(on);
    window_.viewer().changeLegend.setBrief(on);
    window_.viewer().notice.setBrief(on);
    window_.viewer().live.panel().setBrief(on);
    window_.viewer().rocksPanel.setBrief(on);
    window_.viewer().targetsPanel.setCardFirst(on);
    window_.viewer().panel.setForGloves(on);
    frame_->setCab(on);
    keypad_->setOn(on);
    gloveMenus_->setOn(on);
    swipes_->setOn(on);
    window_.viewer().viewCube.setForGloves(on);
    window_.viewer().scalePlate.setBrief(on);
    for (ImageView* view : {&window_.viewer().views.gray(), &window_.viewer().views.edges()}) view->setForGloves(on);
    window_.viewer().views.cloud().setForGloves(on);
    showAsked();
    LivePanel& live = window_.viewer().live.panel();
    live.setVisible(window_.viewer().live.scanner().connected() || live.offers() || (!on && !live.strip().shown().badge.empty()));
    if (on) {
        for (QDialog* each : window_.findChildren<QDialog*>()) {
            if (!each->isModal()) each->hide(); // it would cover the cloud, and gloves cannot move it
        }
    }
    showCorner();
    if (on) {
        useTheme(application, true); // last: large widgets that are hidden must not enlarge the window
        showScan();
        showPanel();
    }
    window_.viewer().rocks.show();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // rows whose letters grew: nothing moves later
    window_.layout()->activate();
    const auto keepSize = [this, size] {
        if (!window_.isMaximized() && !window_.isFullScreen()) window_.resize(size);
        window_.fitScreen();
    };
    keepSize();
    const auto later = [this, keepSize, left = window_.size()] { // unless it was resized since
        if (window_.size() == left) keepSize();
    };
    if (!on) QTimer::singleShot(0, &window_, [this, later] { QTimer::singleShot(0, &window_, later); }); // the desk folds panels again
    left_.clear(); // all is new, and no finger is on its way to what was there
    emit changed(on);
}

void CabMode::lockDocks(bool on) {
    window_.menuBar()->setVisible(!on);
    window_.statusBar()->setVisible(!on);
    for (QAction* each : window_.findChildren<QAction*>()) {
        if (each->property(kOfDesk).toBool()) each->setVisible(!on);
    }
    window_.lockDocks(DockLock::Cab, on);
}

/// Stage and progress instead of the facts of the scan, and Cancel.
void CabMode::showWork() {
    const Works::Running* work = window_.viewer().engine.works().newest();
    if (work == nullptr) return frame_->head().showWork(QString());
    const QString stage = work->stage.isEmpty() ? QString() : ": " + work->stage;
    // The number first: a small screen cuts the end.
    frame_->head().showWork(tr("%1 % · %2%3").arg(std::lround(100.0 * work->fraction)).arg(work->title, stage));
}

void CabMode::showScan() {
    if (!on_) return;
    const Picture* picture = window_.viewer().views.shown().get();
    const PictureOrigin origin = originOfDrawn(window_.viewer().engine, window_.viewer().live.scanner(),
                                               window_.viewer().comparing.pictureA().get(), window_.viewer().views.flipped());
    badge_->showState(origin.sign, origin.badge);
    const QString name = picture == nullptr ? QString() : scanName(picture->detection->scan->name) + ". "; // whole
    badge_->setToolTip(origin.badge + ". " + name + origin.more);
    const QStringList warnings = window_.viewer().warnings.warnings();
    QToolButton* button = frame_->head().warnings();
    button->setText((window_.viewer().warnings.acknowledged() ? QStringLiteral("✓ ") : QStringLiteral("▲ ")) +
                    QString::number(warnings.size()));
    button->setAccessibleName(window_.viewer().warnings.text());
    button->setVisible(!warnings.isEmpty());
    for (QWidget* each : ofScan_) each->setEnabled(picture != nullptr);
    zoom_->setVisible(picture != nullptr);
    Live& live = window_.viewer().live;
    if (picture == nullptr && live.scanner().connected()) return frame_->head().showScan(tr("Scanner"), live.waitsFor());
    if (picture == nullptr) return frame_->head().showScan(tr("No scan"), tr("Open one, or connect to a scanner"));
    const Scan& scan = *picture->detection->scan;
    const int expected = std::max(picture->source.growth.expectedLines, scan.lines());
    const auto missing = std::ranges::count_if(scan.state.cells, [](CellState state) { return state != CellState::Valid; });
    // Lines that arrived whole, as in the strip and in the warnings.
    int arrived = 0;
    for (int line = 0; line < scan.lines(); ++line) {
        const auto* first = scan.state.cells.data() + static_cast<std::ptrdiff_t>(line) * scan.beams();
        arrived += std::find(first, first + scan.beams(), CellState::Lost) == first + scan.beams() ? 1 : 0;
    }
    const Growth& growth = picture->source.growth;
    const bool lengthUnknown = growth.sweep >= 0 && growth.expectedLines == 0 && arrived == expected;
    QString facts =
        lengthUnknown ? tr("%1 lines").arg(countText(arrived)) : tr("%1 of %2 lines").arg(countText(arrived), countText(expected));
    const double share = static_cast<double>(missing) / std::max<double>(1.0, static_cast<double>(scan.state.cells.size()));
    // A line ends between two facts, and not within the second one.
    facts += tr(" · %1 % no return").arg(100.0 * share, 0, 'f', 1).replace(' ', QChar(0x00A0)).replace("·\u00a0", "· ");
    for (const QString& warning : warnings) {
        if (warning.startsWith("INCOMPLETE")) facts = tr("✕ INCOMPLETE") + " · " + facts;
    }
    if (scan.placement && scan.placement->outOfSpec) facts = tr("▲ OUT OF SPEC") + " · " + facts;
    frame_->head().showScan(scanName(scan.name), facts);
}

namespace {

constexpr qint64 kSecondTapMs = 700;
constexpr int kZoomSide = 52, kBetweenZooms = 4; // px
constexpr double kZoomStep = 1.25;

} // namespace

/// Where the image has what is chosen: the ends of a measurement, a rock or a target.
PictureMark CabMode::chosenPlace() const {
    const LinkedViews& views = window_.viewer().views;
    if (!window_.viewer().engine.picture()) return {};
    PictureMark mark;
    const auto& measures = views.marks().measures;
    if (const auto chosen = std::ranges::find_if(measures, &MeasureMark::active); chosen != measures.end()) {
        for (const std::size_t cell : chosen->cells) mark.cells << views.placeOf(cell);
        mark.links = chosen->links;
        return mark;
    }
    const rocks::Rock* const rock = chosenRock();
    // A tap on the label of a target leaves the pointer over the cell behind it.
    const auto pinned = views.pinned() ? views.pinned() : views.marked();
    if (const auto cell = rock != nullptr ? std::optional<std::size_t>(rock->cell) : pinned) mark.cells << views.placeOf(*cell);
    return mark;
}

void CabMode::showCorner() {
    const bool some = on_ && window_.viewer().engine.picture() != nullptr && small_;
    corner_->setVisible(some);
    if (!some) return;
    corner_->setWords("⇄ " + (image_ == Large::Range ? QObject::tr("Range image") : QObject::tr("Edge map")));
    corner_->show(imageView().image(), chosenPlace(), imageView().viewPort()->toScreen());
}

ImageView& CabMode::imageView() const {
    LinkedViews& views = window_.viewer().views;
    return image_ == Large::Edges ? views.edges() : views.gray();
}

/// A tap at this place is meant for what was there, for a moment after the change is painted: a large cloud takes its time.
void CabMode::noteChangeUnder(const QRegion& place) {
    if (!on_ || place.isEmpty()) return;
    std::erase_if(left_, [](const LeftPlace& each) { return each.isOver(); });
    left_.push_back({place});
    QTimer::singleShot(0, this, [this] {
        for (LeftPlace& each : left_) {
            if (!each.since.isValid()) each.since.start();
        }
    });
}

/// Exchanges the large view and the corner: image and cloud.
void CabMode::swap() {
    const CornerPicture& used = large_ == Large::Cloud ? *corner_ : *back_;
    const QRect place = used.isVisible() ? QRect(used.mapToGlobal(QPoint()), used.size()) : QRect();
    showLarge(large_ == Large::Cloud ? image_ : Large::Cloud);
    noteChangeUnder(place); // also of the other one, which is there now
}

void CabMode::showLarge(Large which) {
    if (std::exchange(large_, which) == which) return;
    if (which != Large::Cloud) image_ = which;
    const bool isImage = which != Large::Cloud;
    ImageView& image = imageView();
    for (ImageView* each : {&window_.viewer().views.gray(), &window_.viewer().views.edges()}) {
        each->removeEventFilter(back_);
        each->setCovered(0);
    }
    back_->setParent(&image);
    image.installEventFilter(back_);
    window_.viewer().views.setOnlyImage(which == Large::Range);
    window_.showAlone(isImage ? static_cast<QWidget*>(&image) : &window_.viewer().views.cloud());
    back_->setVisible(isImage);
    back_->endAt(corner_->isHidden() ? 0 : corner_->geometry().bottom()); // a second tap at the same place swaps them back
    if (isImage) image.setCovered(back_->reach());
    showCorner();
    emit viewsChanged();
}

/// A direction is one of the cloud.
void CabMode::showCloud() {
    if (on_) showLarge(Large::Cloud);
}

/// Each does what it says, whatever is large.
void CabMode::fillViews(QMenu& menu) {
    menu.clear();
    auto* views = menu.findChild<QActionGroup*>();
    if (views == nullptr) views = new QActionGroup(&menu); // one of them is on
    for (const auto& [which, words] : {std::pair(Large::Cloud, QObject::tr("Cloud")), std::pair(Large::Range, QObject::tr("Range image")),
                                       std::pair(Large::Edges, QObject::tr("Edge map"))}) {
        QAction* action = menu.addAction(words, this, [this, which = which] { showLarge(which); });
        action->setCheckable(true);
        action->setChecked(large_ == which);
        views->addAction(action);
    }
    menu.addSeparator();
    QAction* small = menu.addAction(tr("Small picture"), this, [this](bool on) {
        small_ = on;
        showCorner();
        emit viewsChanged();
    });
    small->setCheckable(true);
    small->setChecked(small_);
    small->setEnabled(large_ == Large::Cloud); // an image has no picture in its corner
    menu.addSeparator();
    menu.addMenu(&menuWith(kDirection));
}

std::string CabMode::viewsKept() const {
    const char* names[]{"cloud", "range", "edges"};
    return std::string(names[static_cast<int>(large_)]) + (image_ == Large::Edges ? " edges" : " range") + (small_ ? " small" : "");
}

void CabMode::useViews(const QString& kept) {
    const QStringList words = kept.split(' ');
    const QStringList names{"cloud", "range", "edges"};
    const auto large = names.indexOf(words.value(0));
    if (large < 0) return;
    showLarge(Large::Cloud);
    image_ = words.value(1) == "edges" ? Large::Edges : Large::Range;
    small_ = words.contains("small");
    showLarge(static_cast<Large>(large));
    showCorner();
}

/// Zooms the large view about its middle.
void CabMode::zoom(double factor) {
    CloudView& cloud = window_.viewer().views.cloud();
    if (large_ == Large::Cloud) return cloud.setCamera(zoomed(cloud.camera(), cloud.camera().focus, factor));
    ViewPort& images = *window_.viewer().views.gray().viewPort();
    images.zoomAt(images.centre(), factor);
}

void CabMode::addZoom() {
    zoom_->setObjectName("cab-zoom");
    auto* row = new QHBoxLayout(zoom_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBetweenZooms);
    for (const bool in : {true, false}) {
        auto* button = new QToolButton;
        button->setObjectName(in ? "cab-zoom-in" : "cab-zoom-out");
        button->setText(in ? "+" : "−");
        button->setAccessibleName(in ? tr("Zoom in") : tr("Zoom out"));
        button->setFixedSize(kZoomSide, kZoomSide);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRepeat(true);
        QFont letters = button->font();
        letters.setPixelSize(kZoomSide / 2);
        letters.setBold(true);
        button->setFont(letters);
        connect(button, &QToolButton::clicked, this, [this, in] { zoom(in ? kZoomStep : 1.0 / kZoomStep); });
        row->addWidget(button);
    }
    zoom_->hide();
}

bool CabMode::LeftPlace::isOver() const { return since.isValid() && since.elapsed() >= kSecondTapMs; }

bool CabMode::isOnLeftPlace(const QPoint& onScreen) const {
    return std::ranges::any_of(left_, [&onScreen](const LeftPlace& each) { return !each.isOver() && each.onScreen.contains(onScreen); });
}

bool CabMode::eventFilter(QObject* watched, QEvent* event) {
    const bool press = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    const bool follows = event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseMove;
    if (press) {
        const QPoint at = static_cast<QMouseEvent*>(event)->globalPos();
        secondTap_ = !keypad_->place().contains(at) && isOnLeftPlace(at);
    }
    if (event->type() == QEvent::TouchBegin) {
        const auto points = static_cast<QTouchEvent*>(event)->touchPoints();
        if (std::ranges::any_of(points, [this](const auto& each) { return isOnLeftPlace(each.screenPos().toPoint()); })) {
            event->ignore(); // Qt sends the mouse event instead
            return true;
        }
    }
    return ((press || follows) && secondTap_) || QObject::eventFilter(watched, event);
}

} // namespace edgescan::ui

#include "moc_cab_mode.cpp"
