// Builds the window and lays it out.
#include "ui/window/main_window.h"

#include "ui/base/core_words.h"
#include "ui/base/count_text.h"
#include "ui/base/dock_rail.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/base/shown_text.h"
#include "ui/base/tool_tips.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/files/source.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/engine/linked_views/cell_cursor.h"
#include "ui/engine/worker_bridge/preferences.h"
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
#include "ui/views/cloud/scale_plate.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/cab_mode.h"
#include "ui/window/docks.h"
#include "ui/window/manual.h"
#include "ui/window/menus.h"
#include "ui/window/pane_places.h"
#include "ui/window/session_menu.h"
#include "ui/window/side_column.h"
#include "ui/window/start.h"
#include "ui/window/tool_bar.h"
#include "ui/window/view_choices.h"

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QImage>
#include <QMenuBar>
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

/// Hides the legend of edges while a difference is shown.
void followChanges(MainWindow& w) {
    const auto follow = [&w] {
        w.viewer().changeLegend.showOverRocks(w.viewer().views.scene().pointsOver != nullptr);
        w.viewer().legend.setVisible(w.viewer().views.scene().picture != nullptr && w.viewer().views.scene().insteadNow() == nullptr);
    };
    QObject::connect(&w.viewer().views, &LinkedViews::picturesChanged, &w, follow);
}

/// "turned 90°, mirrored": of the images; empty as they are.
QString turnNote(const ViewPort& images) {
    const ViewPort::Turn& turn = images.turn();
    QStringList words;
    if (turn.degrees() > 0) words << Pane::tr("turned by %1°").arg(turn.degrees());
    if (turn.mirrored) words << Pane::tr("mirrored");
    return words.join(", ");
}

QString rangeNote(MainWindow& window) {
    const RangeSpan ranges = window.viewer().views.rangesShown();
    const int decimals = ranges.farM - ranges.nearM < 1.0 ? 2 : 1;
    QString note = Pane::tr("gray %1 to %2 m").arg(ranges.nearM, 0, 'f', decimals).arg(ranges.farM, 0, 'f', decimals);
    if (window.viewer().engine.picture()->source.growth.growing)
        note = Pane::tr("up to line %1").arg(window.viewer().engine.picture()->detection->scan->lines()) + " · " + note;
    return note;
}

QString edgeNote(MainWindow& window) {
    const LinkedViews& views = window.viewer().views;
    const OverlayEdges* instead = views.scene().insteadNow();
    const edges::Detection& detection = *views.shown()->detection;
    const std::size_t all = detection.edges->size();
    // In a comparison the shown edges come from two scans.
    const std::size_t shown = instead != nullptr && instead->overImageAsAsked && instead->cells.all ? instead->cells.all->size() : all;
    const QString edges = shown == all ? Pane::tr("%1 edge cells").arg(countText(all))
                                       : Pane::tr("%1 of %2 edge cells").arg(countText(shown), countText(all));
    if (instead != nullptr) return edges + " · " + instead->words;
    return views.edgesByClass() && detection.classes ? edges + " · " + Pane::tr("by class") : edges;
}

QString cloudNote(MainWindow& window) {
    const CloudView& cloud = window.viewer().views.cloud();
    if (!cloud.geometryOfCloud()) return {};
    const std::size_t all = window.viewer().views.shown()->cloud->validCount, shown = cloud.geometryOfCloud()->validCount;
    QString note =
        shown == all ? Pane::tr("%1 points").arg(countText(all)) : Pane::tr("%1 of %2 points").arg(countText(shown), countText(all));
    if (window.viewer().live.grows()) note += ", " + Pane::tr("growing");
    return note;
}

QString cloudRemark(const CloudView& cloud) {
    if (cloud.drawnFraction() < 1.0) return Pane::tr("%1 % of the points drawn").arg(std::lround(cloud.drawnFraction() * 100));
    return (cloud.isTurntable() ? Pane::tr("turntable") : Pane::tr("free rotation")) + " · " +
           (cloud.isParallel() ? Pane::tr("orthographic") : Pane::tr("perspective"));
}

/// Numbers and edges come with the picture of the whole.
void showCoarse(MainWindow& window, Pane& range, Pane& edges, Pane& cloud) {
    const bool coarse = window.viewer().engine.coarse() != nullptr;
    for (Pane* pane : {&range, &cloud}) pane->setNote(coarse ? Pane::tr("coarse picture") : QString());
    edges.setNote(coarse ? Pane::tr("edges pending") : QString());
    cloud.setRemark(coarse ? cloudRemark(window.viewer().views.cloud()) : QString());
}

/// Keeps the notes up to date.
void keepPaneNotes(MainWindow& window, Pane& range, Pane& edges, Pane& cloud) {
    const auto update = [&] {
        if (!window.viewer().engine.picture()) return showCoarse(window, range, edges, cloud);
        if (!window.viewer().views.shown()) return;
        range.setNote(rangeNote(window));
        edges.setNote(edgeNote(window));
        for (Pane* pane : {&range, &edges}) pane->setRemark(turnNote(*window.viewer().gray.viewPort()));
        cloud.setNote(cloudNote(window));
        cloud.setRemark(cloudRemark(window.viewer().views.cloud()));
    };
    QObject::connect(&window.viewer().views, &LinkedViews::picturesChanged, &window, update);
    QObject::connect(&window, &MainWindow::pictureShown, &window, update);
    QObject::connect(&window.viewer().engine, &Engine::coarseChanged, &window, update);
    QObject::connect(&window.viewer().live, &Live::growthChanged, &window, update);
    QObject::connect(window.viewer().gray.viewPort().get(), &ViewPort::turned, &window, update);
    CloudView& view = window.viewer().views.cloud();
    for (const auto changed : {&CloudView::parallelChanged, &CloudView::turntableChanged})
        QObject::connect(&view, changed, &window, update);
    QObject::connect(&view, &CloudView::pointsChanged, &window, update);
    QObject::connect(&view, &CloudView::drawnFractionChanged, &window, update);
}

/// The picture is used without the window; therefore the warnings are drawn below it. Unchanged without warnings.
QImage withWarnings(const QImage& window, const QStringList& warnings, const QFont& font) {
    if (warnings.isEmpty()) return window;
    constexpr int kMargin = 8;
    const qreal scale = window.devicePixelRatio();
    const int width = static_cast<int>(window.width() / scale);
    const QString text = shownText(QObject::tr("Warnings of this scan:\n") + warnings.join('\n'));
    const QRect room(kMargin, kMargin, width - 2 * kMargin, 100000);
    const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWrapAnywhere;
    const QRect needed = QFontMetrics(font).boundingRect(room, flags, text);
    const int height = static_cast<int>(window.height() / scale);
    QImage image(static_cast<int>(width * scale), static_cast<int>((height + needed.height() + 2 * kMargin) * scale), window.format());
    image.setDevicePixelRatio(scale);
    image.fill(QColor(107, 78, 0));
    QPainter painter(&image);
    painter.drawImage(0, 0, window);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(QRect(kMargin, height + kMargin, width - 2 * kMargin, needed.height()), flags, text);
    return image;
}

constexpr int kRememberAfterMs = 300;
constexpr int kAgeMs = 15000;
constexpr QSize kLeastCloud(240, 120);

/// The bar of the badge, right of the tools, which give way: it is visible at every width.
QToolBar* badgeBar(QWidget& badge) {
    auto* bar = new QToolBar;
    bar->setObjectName("badge-bar");
    bar->setWindowTitle(MainWindow::tr("Source"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setVisible(false);
    auto* place = new QWidget;
    auto* row = new QHBoxLayout(place);
    row->setContentsMargins(8, 0, 6, 0);
    row->addStretch(1);
    row->addWidget(&badge, 0, Qt::AlignVCenter);
    bar->addWidget(place);
    return bar;
}

/// "mine.csv": two files of one name differ by their endings.
QString titleOf(const Scan& scan) {
    const std::string file = std::filesystem::path(scan.path).filename().string();
    return file.starts_with(scan.name + '.') ? shownName(exactText(file)) : scanName(scan.name);
}

/// Visible widgets that cover a part of `below`, the lowest first: stacked above it or above one of its parents up to `window`.
std::vector<QWidget*> shownOver(QWidget& below, const QWidget& window) {
    std::vector<QWidget*> over;
    const QRect place(below.mapTo(&window, QPoint(0, 0)), below.size());
    for (QWidget* part = &below; part != &window; part = part->parentWidget()) {
        const QObjectList& stack = part->parentWidget()->children(); // the highest at the end
        for (auto n = stack.indexOf(part) + 1; n < stack.size(); ++n) {
            auto* widget = qobject_cast<QWidget*>(stack[n]);
            if (widget != nullptr && widget->isVisible() && !widget->isWindow() &&
                place.intersects(QRect(widget->mapTo(&window, QPoint(0, 0)), widget->size())))
                over.push_back(widget);
        }
    }
    return over;
}

/// Qt passes the keyboard focus of a widget that is switched off or hidden to the next one: what is typed next would press another button
/// or change a number, "Smallest rock" after "Not a Rock". In the same window only a view may take it over.
void dropPassedFocus(QWidget* before, QWidget* now) {
    if (before == nullptr || now == nullptr || before->window() != now->window()) return;
    if (before->isEnabled() && before->isVisible()) return;
    if (qobject_cast<ImageView*>(now) == nullptr && qobject_cast<CloudView*>(now) == nullptr) now->clearFocus();
}

} // namespace

MainWindow::MainWindow(Preferences& preferences, QWidget* parent)
    : QMainWindow(parent), viewer_(preferences), rail_(new DockRail), menus_(new QMenuBar) {
    setObjectName("edgescan");
    setWindowTitle("EdgeScan");
    setAcceptDrops(true);
    breakToolTips(*qApp);
    connect(qApp, &QApplication::focusChanged, this, &dropPassedFocus);
    layOutViews();
    layOutLegends();
    followChanges(*this);
    layOutTools();
    addToolBar(Qt::RightToolBarArea, rail_);
    docks_ = new Docks(*this, *rail_, viewer_);
    connect(docks_, &Docks::changed, this, &MainWindow::arrange);
    setStatusBar(&viewer_.statusLine);
    viewer_.statusLine.addPinned(&viewer_.warnings);
    connect(&viewer_.warnings, &QToolButton::clicked, this, [this] {
        viewer_.notice.showNotice(NoticeBar::Kind::Warning, viewer_.warnings.warnings().join('\n'));
        viewer_.notice.unfold(true); // the operator asked for all of them
    });
    connect(&viewer_.report, &ScanReport::saved, &viewer_.audit, [this](const QString& path) { viewer_.audit.noteExport("report", path); });
    connect(&viewer_.warnings, &WarningButton::warningsRaised, &viewer_.audit, &AuditTrail::noteWarnings);
    connect(&viewer_.warnings, &WarningButton::warningsAcknowledged, &viewer_.audit, [this] {
        viewer_.audit.note("acknowledged", {{"warnings", viewer_.warnings.warnings().size()}});
    });
    Command shares = shareMenu(*this, *places_);
    shares.submenu.insert(shares.submenu.end(),
                          {kLine, toggle("&Legends at the Side", "", "view/side-column", true, [this](bool on) { showColumn(on); })});
    const WindowCommands commands{[this] { return screenshot(); },        [this] { resetLayout(); }, [this] { startTour(*this); },
                                  [this] { openManual(*this); },          sessionCommands(*this),    shares,
                                  cabCommand(*cab_, viewer_.preferences), [this] { quit(); }};
    for (const Command& menu : menusOf(viewer_, *this, commands))
        addCommands(*menuBar()->addMenu(menu.text), menu.submenu, *this, viewer_.preferences, menu.source);
    addToolButtons(*this);
    cab_->addTools();
    panes_.back()->add(actionOf(keyedCommands(actions()), "View/Sizes of Views/Legends at the Side"), "panel");
    connect(&viewer_.statusLine, &StatusLine::poseRequested, &actionOf(keyedCommands(actions()), "Scan/Pose and Mounting"),
            &QAction::trigger);
    auto* keys = new KeysOfFocus(this);
    QApplication::instance()->installEventFilter(keys);
    connect(keys, &KeysOfFocus::textBegins, this, [this] { beforeText_ = {viewer_.undo.index(), viewer_.cloud.camera()}; });
    connect(keys, &KeysOfFocus::lettersChanged, this, [this, keys](QStringList names) {
        if (!(viewer_.cloud.camera() == beforeText_.second)) names << tr("view of the cloud");
        viewer_.notice.showHint(tr("Letters outside a field are keys; these changed: %1.").arg(names.join(", ")));
        viewer_.notice.offer(tr("Undo"), [this, keys, before = beforeText_] {
            viewer_.undo.setIndex(before.first);
            keys->putBack();
            viewer_.cloud.setCamera(before.second);
            viewer_.notice.endPassing();
        });
    });
    new CellCursor(viewer_.views, this);
    connectEngine();
    sessions_ = sessionsOf(*this, viewer_.preferences);
    rememberTimer_.setSingleShot(true);
    rememberTimer_.setInterval(kRememberAfterMs);
    connect(&rememberTimer_, &QTimer::timeout, this, &MainWindow::remember);
    restoreLayout();
    if (viewer_.preferences.flag("view/cab", false)) cab_->set(true);
}

MainWindow::~MainWindow() = default;

void MainWindow::layOutViews() {
    viewer_.gray.setObjectName("gray");
    viewer_.edges.setObjectName("edges");
    viewer_.cloud.setObjectName("cloud");
    auto* grayPane = new Pane(tr("Range image"), &viewer_.gray);
    auto* edgePane = new Pane(tr("Edge map"), &viewer_.edges);
    auto* cloudPane = new Pane(tr("Cloud"), &viewer_.cloud);
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
    under->addWidget(&viewer_.rangeWindow);
    splitter_ = new QSplitter(Qt::Horizontal);
    splitter_->addWidget(pictures_);
    splitter_->addWidget(cloudPane);
    for (QSplitter* splitter : {images_, splitter_}) {
        splitter->setChildrenCollapsible(false);
        splitter->setHandleWidth(5);
        connect(splitter, &QSplitter::splitterMoved, this, [this] { rememberTimer_.start(); });
    }
    connect(splitter_, &QSplitter::splitterMoved, this, [this] { imagesDragged_ = true; });
    for (QWidget* widget : {static_cast<QWidget*>(splitter_), pictures_}) widget->installEventFilter(this);
    splitter_->setStretchFactor(0, 0); // additional width goes to the cloud
    splitter_->setStretchFactor(1, 1);
    places_ = new PanePlaces(*splitter_, *images_, panes_, this);
    followPlaces();
    auto* centre = new QWidget;
    centre->setObjectName("centre");
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* top = new QVBoxLayout;
    column->addLayout(top);
    column->addWidget(&viewer_.livePanel);
    auto* menuRow = new QWidget;
    auto* first = new QHBoxLayout(menuRow);
    first->setContentsMargins(0, 0, 0, 0);
    first->addWidget(menus_);
    first->addWidget(&viewer_.notice, 1);
    setMenuWidget(menuRow);
    viewsRow_ = new QBoxLayout(QBoxLayout::LeftToRight);
    viewsRow_->setSpacing(0);
    viewsRow_->addWidget(splitter_, 1);
    viewsRow_->addWidget(side_ = new SideColumn);
    column->addLayout(viewsRow_, 1);
    column->addWidget(&viewer_.timeline);
    connect(&viewer_.undo, &QUndoStack::indexChanged, this, [this] {
        if (!viewer_.undo.property(kDrops).toBool()) viewer_.notice.endPassing();
    });
    cab_ = new CabMode(*this, centre);
    addTour(*this, *top);
    addManualKey(*this);
}

/// A double-click on the title of an image exchanges it with the cloud; on the title of the cloud it shows the cloud alone.
void MainWindow::followPlaces() {
    for (Pane* pane : panes_)
        connect(pane, &Pane::swapRequested, this, [this, pane] {
            if (cab_->on()) return;
            if (maximised_ != nullptr) return maximise(maximised_);
            if (pane == places_->inCloudsPlace() && pane == panes_.back()) return maximise(pane);
            places_->swap(pane);
        });
    connect(places_, &PanePlaces::shareChanged, this, [this] {
        if (maximised_ != nullptr && !cab_->on()) showAlone(nullptr); // else the choice would show nothing
    });
    connect(places_, &PanePlaces::changed, this, [this] {
        viewer_.preferences.keep("window/large-view", places_->text());
        imagesDragged_ = false; // the width of the new places
        arrange();
        rememberTimer_.start();
    });
}

void MainWindow::layOutLegends() {
    viewer_.cloud.setMinimumSize(kLeastCloud);
    for (QWidget* part : std::initializer_list<QWidget*>{&viewer_.changeLegend, &viewer_.confidenceLegend, &viewer_.legend,
                                                         &viewer_.scalePlate, &viewer_.viewCube})
        side_->add(*part);
    viewer_.legend.unfold()->setChecked(viewer_.preferences.flag("view/legend-open", true));
    connect(&viewer_.legend, &EdgeLegend::unfolded, this, [this](bool open) { viewer_.preferences.keep("view/legend-open", open); });
    connect(&viewer_.cloud, &CloudView::edgesCovered, &viewer_.legend, &EdgeLegend::showCovered);
    connect(&viewer_.legend, &EdgeLegend::classesRequested, this, [this](int classes) { viewer_.tuning.setParameter("classes", classes); });
}

void MainWindow::layOutTools() {
    addToolBar(Qt::TopToolBarArea, &viewer_.tools);
    viewer_.tools.toggleViewAction()->setVisible(false);
    viewer_.origin.setObjectName("origin");
    viewer_.origin.setTwoLines();
    viewer_.origin.setRoom(viewer_.origin.widthFor("2026-11-19 08:12:05 UTC")); // its least width does not depend on what it says
    addToolBar(Qt::TopToolBarArea, badgeBar(viewer_.origin));
    connect(&viewer_.measures, &Measures::asked, &viewer_.tools, &ToolBar::showAsked);
    connect(viewer_.targetsPanel.section(), &QPushButton::clicked, &viewer_.sections, &Sections::throughMeasurement);
    connect(&viewer_.sections, &Sections::opening, &viewer_.explanation, &Explanation::closeCard); // no room for both
    connect(&viewer_.measures, &Measures::asked, &viewer_.targetsPanel, &TargetsPanel::showAsked);
    connect(&viewer_.explanation, &Explanation::asked, &viewer_.tools, &ToolBar::showAsked);
    connect(&viewer_.rocks, &Rocks::toolChanged, &viewer_.tools, [this](RockTool tool) { viewer_.tools.showRockTool(promptOf(tool)); });
    connect(&viewer_.selection, &Selection::changed, this, [this] { viewer_.tools.showSelected(viewer_.selection.words()); });
    connect(&viewer_.selection, &Selection::exportRequested, this, [this] { viewer_.exports.askSelected(); });
    connect(&viewer_.selection, &Selection::changed, this, [this] { viewer_.exports.setSelection(viewer_.selection.cells()); });
    viewer_.exports.setTargets([this] { return viewer_.targets.withRocks(); });
    connect(&viewer_.targets, &Targets::explanationRequested, &viewer_.explanation,
            [this](std::size_t cell) { viewer_.explanation.explain(inspect::exactly(cell), Explanation::Subject::Pin); });
    connect(&viewer_.targets, &Targets::measureRequested, &viewer_.measures, &Measures::startAt);
    const ScannerLink& scanner = viewer_.live.scanner();
    for (const auto changed : {&ScannerLink::connectedChanged, &ScannerLink::followingChanged})
        connect(&scanner, changed, this, &MainWindow::showOrigin);
    connect(&scanner, &ScannerLink::healthChanged, this, &MainWindow::showOrigin);
    // The letters of the views are not for the fields of the address.
    const auto focusView = [this] {
        if (focusWidget() == nullptr && viewer_.cloud.isVisible()) viewer_.cloud.setFocus();
    };
    connect(&scanner, &ScannerLink::connectedChanged, this, focusView);
    connect(&viewer_.livePanel, &LivePanel::closed, this, focusView);
    auto* age = new QTimer(this); // "8 min ago" grows
    connect(age, &QTimer::timeout, this, &MainWindow::showOrigin);
    age->start(kAgeMs);
    showOrigin();
}

void MainWindow::showOrigin() {
    const PictureOrigin origin =
        originOfDrawn(viewer_.engine, viewer_.live.scanner(), viewer_.comparing.pictureA().get(), viewer_.views.flipped());
    viewer_.origin.showState(origin.sign, origin.badge);
    viewer_.origin.setToolTip(viewer_.origin.text() + "\n" + origin.more);
    viewer_.targets.setSource(originOf(viewer_.engine, viewer_.live.scanner()).badge); // also while A is drawn
    emit originShown();
}

void MainWindow::connectEngine() {
    Works& works = viewer_.engine.works();
    connect(&works, &Works::changed, this, [this, &works] {
        const Works::Running* work = works.newest();
        work == nullptr ? viewer_.statusLine.endWork() : viewer_.statusLine.showWork(work->title, work->stage, work->fraction);
    });
    connect(&viewer_.statusLine, &StatusLine::cancelRequested, &works, &Works::cancel);
    connect(&viewer_.engine, &Engine::replacingChanged, this, [this] {
        showOrigin();
        showTitle();
    });
    connect(&viewer_.views, &LinkedViews::flippedChanged, this, [this](bool on) {
        docks_->showOfB(on);
        viewer_.warnings.showInstead(on ? std::optional(warningsOf(*viewer_.views.shown())) : std::nullopt);
        showFacts();
        showOrigin();
        if (viewer_.cloud.atRest() || !viewer_.cloud.isVisible()) showTitle(); // else with the frame: the title is not before its picture
    });
    connect(&viewer_.cloud, &CloudView::frameDrawn, this, &MainWindow::showTitle);
    connect(&viewer_.engine, &Engine::coarseChanged, this, [this] {
        const auto& coarse = viewer_.engine.coarse();
        viewer_.statusLine.showCountsToCome(coarse ? std::optional(coarse->cells) : std::nullopt);
        showOrigin();
    });
    connect(&viewer_.engine, &Engine::settingsChanged, this, &MainWindow::showSettings);
    connect(&viewer_.rocks, &Rocks::changed, this, &MainWindow::showSettings);
    connect(&viewer_.rocks, &Rocks::shownChanged, this, &MainWindow::showSettings);
    showSettings();
    connect(&viewer_.statusLine, &StatusLine::resetRequested, &viewer_.tuning, &Tuning::reset);
    connect(&viewer_.statusLine, &StatusLine::resetRequested, &viewer_.rocks, &Rocks::reset);
    connect(&viewer_.engine, &Engine::failed, this,
            [this](const QString& sentence) { viewer_.notice.showNotice(NoticeBar::Kind::Error, sentence); });
    connect(&viewer_.views, &LinkedViews::probed, &viewer_.statusLine, [this](std::optional<edges::Probe> probe) {
        using Cell = StatusLine::Cell;
        if (probe && viewer_.engine.placePending()) probe->mineM.reset();
        viewer_.statusLine.showProbe(probe, viewer_.views.flipped()     ? Cell::OfA
                                            : viewer_.views.hovered()   ? Cell::Pointer
                                            : viewer_.targets.isMoved() ? Cell::MovedPin
                                                                        : Cell::Pin);
    });
    connect(&viewer_.engine, &Engine::placePendingChanged, this, [this] { viewer_.views.probeAgain(); });
    connect(&viewer_.views, &LinkedViews::picturesChanged, this, [this] {
        const Scene& scene = viewer_.views.scene();
        if (!scene.byStrength) return viewer_.legend.showStrengths({});
        const std::size_t weak = scene.cells.byClass[kWeakEdge]->size(), thin = scene.cells.byClass[kThinEdge]->size();
        const edges::Settings& settings = viewer_.engine.picture()->detection->settings;
        viewer_.legend.showStrengths({{scene.cells.all->size() - weak - thin, weak, thin}},
                                     settings.rockBorders ? static_cast<int>(std::ceil(settings.borderPercent)) : 0);
    });
    connect(&viewer_.views, &LinkedViews::boxed, &viewer_.statusLine, &StatusLine::showBox);
    connect(&viewer_.engine, &Engine::pictureReady, this, [this] {
        showFacts();
        showWarnings();
        showTitle();
        showOrigin();
        arrange();           // images first: they may have another aspect
        emit pictureShown(); // the controllers received it before
    });
}

/// Of the picture in the views, which may be A.
void MainWindow::showFacts() {
    const Picture& picture = *viewer_.views.shown();
    const edges::Detection& detection = *picture.detection;
    viewer_.statusLine.showCounts(detection);
    viewer_.statusLine.showPlace(*detection.scan, picture.source.growth.growing);
    const ScannerLink& scanner = viewer_.live.scanner();
    viewer_.statusLine.showTimeOf(*detection.scan, scanner.connected() && picture.source.stream == scanner.stream());
    showSettings();
    viewer_.legend.showResult(detection);
    viewer_.legend.setVisible(viewer_.views.scene().insteadNow() == nullptr); // a comparison has a legend of its own
}

/// Of the picture in the views: A has no rocks.
void MainWindow::showSettings() {
    const bool own = !viewer_.views.flipped();
    const rocks::RockSettings ofRocks = own && viewer_.rocks.shown() ? viewer_.rocks.settings() : rocks::RockSettings{};
    viewer_.statusLine.showSettings(own ? viewer_.engine.settings() : viewer_.views.shown()->detection->settings, ofRocks, own);
}

// The title of the picture on the screen: sweeps of a scanner and of a recording have their own names.
void MainWindow::showTitle() {
    if (!viewer_.engine.picture()) return;
    const QString arriving = viewer_.engine.replacing() ? tr("Opening another scan · still shown: ") : QString();
    const Picture* a = viewer_.comparing.drawnA();
    const QString drawn = a != nullptr ? "A: " + titleOf(*a->detection->scan)
                                       : titleOf(*viewer_.engine.picture()->detection->scan) + viewer_.files.placeInSeries();
    setWindowTitle(arriving + drawn + " - EdgeScan");
}

void MainWindow::showWarnings() {
    const Picture& picture = *viewer_.engine.picture();
    const Scan& scan = *picture.detection->scan;
    // The sweeps of one connection have one scanner, whose warnings were read once.
    const QString of = scan.path.empty() ? QString::number(picture.source.stream) : exactText(scan.path + '\n' + scan.sha256);
    viewer_.warnings.showWarnings(warningsOf(picture), of);
}

QImage MainWindow::screenshot() {
    const QImage cloud = viewer_.cloud.grabFrame(CloudView::Points::All);
    panes_.back()->setRemark(QString()); // its text describes a frame and is wrong for this picture
    QImage image = grab().toImage();
    // The result of grab() for an OpenGL child depends on the platform: the view's own picture replaces it.
    QPainter painter(&image);
    painter.drawImage(QRect(viewer_.cloud.mapTo(this, QPoint(0, 0)), viewer_.cloud.size()), cloud);
    for (QWidget* widget : shownOver(viewer_.cloud, *this)) widget->render(&painter, widget->mapTo(this, QPoint(0, 0)));
    painter.end();
    return withWarnings(image, coreSentence(viewer_.warnings.warnings().join('\n')).split('\n', Qt::SkipEmptyParts), font());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) {
        // url.toLocalFile() loses bytes that are not UTF-8
        paths << (url.isLocalFile() ? exactText(QByteArray::fromPercentEncoding(url.path(QUrl::FullyEncoded).toLatin1()).toStdString())
                                    : url.toString());
    }
    if (!paths.isEmpty()) event->acceptProposedAction();
    sessions_->open(paths);
}

} // namespace edgescan::ui

#include "moc_main_window.cpp"
