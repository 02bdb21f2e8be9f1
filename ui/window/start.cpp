// What the start page's buttons and the steps of the tour do, and their places.
#include "ui/window/start.h"

#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/dialogs/sheets.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/start/tour.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/docks.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QBoxLayout>
#include <QDockWidget>
#include <QEvent>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>

namespace edgescan::ui {
namespace {

constexpr const char* kOffered = "tour-ended"; // of the settings

Tour* tourOf(MainWindow& window) { return window.findChild<Tour*>("tour"); }

void tryStep(MainWindow& window, int step) {
    Viewer& viewer = window.viewer();
    switch (step) {
    case 0:
        return viewer.files.openDemo();
    case 1:
        return viewer.cloud.viewFromScanner();
    case 2:
        if (auto* dock = window.findChild<QDockWidget*>("dock-edges"); dock != nullptr && dock->toggleViewAction()->isEnabled()) {
            dock->show();
            dock->raise();
        }
        return;
    case 3:
        return viewer.rocks.setShown(true);
    default:
        return showShortcuts(&window, window.actions());
    }
}

} // namespace

void addTour(MainWindow& window, QBoxLayout& column) {
    auto* tour = new Tour;
    column.addWidget(tour);
    QObject::connect(&window.cab(), &CabMode::changed, tour, [tour](bool cab) { tour->setVisible(tour->running() && !cab); });
    // Whichever way the scan was opened, the first step is done.
    QObject::connect(&window.viewer().engine, &Engine::pictureReady, tour, [tour] {
        tour->tick(0);
        if (tour->running() && tour->step() == 0) tour->showStep(1);
    });
    Works& works = window.viewer().engine.works();
    QObject::connect(&works, &Works::changed, tour, [tour, &works] { tour->setOpening(works.newest() != nullptr); });
    QObject::connect(tour, &Tour::tryRequested, &window, [&window](int step) { tryStep(window, step); });
}

void startTour(MainWindow& window) {
    if (window.cab().on()) return;
    tourOf(window)->start();
    if (window.viewer().engine.picture()) tourOf(window)->showStep(1);
}

bool endTour(MainWindow& window) {
    Tour& tour = *tourOf(window);
    if (!tour.isVisible()) return false;
    tour.end();
    return true;
}

/// Once: a window that was closed during the tour has skipped it.
void offerTour(MainWindow& window, Preferences& preferences) {
    if (preferences.dataFolder().isEmpty() || preferences.flag(kOffered, false) || window.cab().on()) return;
    preferences.keep(kOffered, true);
    startTour(window);
}

namespace {

constexpr int kAskAgainMs = 1000;
constexpr int kSettleMs = 400; // time until docks have their positions

/// Keeps the page over everything between tool bar and status bar; in a cab, over everything below the head. The notice bar stays visible,
/// and the scanner panel closes the page.
class OverViews : public QObject {
public:
    OverViews(MainWindow& window, StartPage& page) : QObject(&page), window_(window), page_(page), tour_(window.findChild<Tour*>("tour")) {
        for (QObject* watched : {static_cast<QObject*>(&page), static_cast<QObject*>(&window),
                                 static_cast<QObject*>(&window.viewer().notice), static_cast<QObject*>(window.centralWidget()),
                                 static_cast<QObject*>(&window.cab().frame().head()), static_cast<QObject*>(&window.viewer().statusLine),
                                 static_cast<QObject*>(&window.viewer().live.panel()), static_cast<QObject*>(tour_)})
            watched->installEventFilter(this);
        for (QObject* dock : window.findChildren<QDockWidget*>()) dock->installEventFilter(this);
        for (QObject* pane : window.findChildren<Pane*>()) pane->installEventFilter(this);
        settle_.setSingleShot(true);
        settle_.setInterval(kSettleMs);
        connect(&settle_, &QTimer::timeout, this, [this] {
            window_.update();
            page_.update();
        });
        place();
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto type = event->type();
        // A window is hidden before it is destroyed; from then on its functions must not be called.
        if (watched == &window_ && (type == QEvent::Hide || type == QEvent::Show)) gone_ = type == QEvent::Hide;
        // An OpenGL picture under other widgets leaves the line next to it black; docks would take room of the strips above the page.
        if (!gone_ && watched == &page_ && (type == QEvent::Hide || type == QEvent::Show)) {
            window_.viewer().views.cloud().setVisible(type == QEvent::Hide);
            window_.lockDocks(DockLock::Start, type == QEvent::Show);
        }
        if (!gone_ && watched == &window_.viewer().live.panel() && type == QEvent::Hide && isNothingShown()) page_.show(); // the way back
        if (gone_ || !page_.isVisible()) return false;
        const bool moves = type == QEvent::Resize || type == QEvent::Move || type == QEvent::Show || type == QEvent::Hide;
        if (moves && isBelow(watched))
            settle_.start();
        else if (watched == &window_.viewer().live.panel() && type == QEvent::Show)
            page_.hide();
        else if (type == QEvent::Show || ((type == QEvent::Resize || type == QEvent::Hide || type == QEvent::Move) && watched != &page_))
            place();
        return false;
    }

private:
    /// Docks and views, which the page covers; they find their places at any time after the start.
    static bool isBelow(QObject* watched) {
        return qobject_cast<QDockWidget*>(watched) != nullptr || qobject_cast<Pane*>(watched) != nullptr;
    }
    [[nodiscard]] bool isNothingShown() const {
        Viewer& viewer = window_.viewer();
        return !viewer.engine.picture() && !viewer.engine.coarse() && !viewer.live.scanner().connected();
    }
    void place() {
        const QWidget &centre = *window_.centralWidget(), &head = window_.cab().frame().head();
        int top = centre.mapTo(&window_, QPoint(0, 0)).y();
        if (head.isVisible()) top = std::max(top, head.mapTo(&window_, QPoint(0, head.height())).y());
        const QWidget& foot = window_.viewer().statusLine; // a cab has none
        const int bottom = foot.isVisible() ? foot.mapTo(&window_, QPoint(0, 0)).y() : window_.height();
        page_.setGeometry(0, top, window_.width(), std::max(0, bottom - top));
        // The strips show through a hole: what is next to them belongs to the views, and is covered.
        QRegion shown(page_.rect());
        int used = 0;
        for (const QWidget* strip : {static_cast<QWidget*>(&window_.viewer().notice), tour_}) {
            if (!strip->isVisible()) continue;
            const QRect place(strip->mapTo(&window_, QPoint(0, 0)) - page_.pos(), strip->size());
            shown -= place;
            used = std::max(used, place.bottom() + 1);
        }
        page_.setMask(shown);
        page_.setTopCovered(used);
        page_.raise();
        settle_.start();
    }

    MainWindow& window_;
    StartPage& page_;
    QWidget* tour_;
    QTimer settle_; // then everything is painted again: what moved under the page is drawn over it until then
    bool gone_ = false;
};

/// A program that was killed may hold its session for some seconds more: the page asks again while it offers none.
void showSession(MainWindow& w, StartPage& page) {
    const QString path = w.sessions().toGoOn();
    page.showSession(path);
    if (path.isEmpty())
        QTimer::singleShot(kAskAgainMs, &page, [&w, &page] {
            if (page.isVisible()) showSession(w, page);
        });
}

} // namespace

StartPage* showStart(MainWindow& w, Preferences& preferences) {
    const QString cache = preferences.dataFolder().isEmpty()
                              ? QString()
                              : QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/edgescan/recent";
    auto* page = new StartPage(cache, &w);
    new OverViews(w, *page);
    QObject::connect(page, &StartPage::openRequested, &w, [&w] { w.viewer().files.ask(); });
    QObject::connect(page, &StartPage::connectRequested, &w, [&w, page] {
        page->hide();
        w.viewer().live.panel().askAddress();
    });
    QObject::connect(page, &StartPage::continueRequested, &w, [&w] { w.sessions().continueLast(); });
    QObject::connect(page, &StartPage::demoRequested, &w, [&w] { w.viewer().files.openDemo(); });
    QObject::connect(page, &StartPage::demoPairRequested, &w, [&w] { w.viewer().comparing.openDemoPair(); });
    QObject::connect(page, &StartPage::scanRequested, &w, [&w](const QString& path) { w.sessions().open({path}); });
    QObject::connect(page, &StartPage::locateRequested, &w, [&w, &preferences, page](const QString& path) {
        const QString now = Files::askScan(&w, QObject::tr("Where is the scan now?"), preferences);
        if (now.isEmpty()) return;
        preferences.forgetRecentFile(path);
        preferences.keepRecentFile(now);
        page->showRecent(preferences.recentFiles());
        w.sessions().open({now});
    });
    QObject::connect(page, &StartPage::clearRequested, &w, [&preferences, page] {
        preferences.forgetRecentFiles();
        page->showRecent({});
    });
    QObject::connect(page, &StartPage::cabRequested, &w, [&w] {
        if (auto* cab = w.findChild<QAction*>("cab-mode")) cab->trigger();
    });
    QObject::connect(page, &StartPage::keysRequested, &w, [&w] { showShortcuts(&w, w.actions()); });
    QObject::connect(&w.viewer().engine, &Engine::pictureReady, page, &QWidget::hide);
    QObject::connect(&w.viewer().engine, &Engine::coarseChanged, page, // a cancelled opening goes back to the page
                     [&w, page] { page->setVisible(!w.viewer().engine.coarse() && !w.viewer().engine.picture()); });
    // A cab has its own way out, and no keys.
    QObject::connect(&w.cab(), &CabMode::changed, page, &StartPage::setForTouch);
    page->setForTouch(w.cab().on());
    page->showRecent(preferences.recentFiles());
    showSession(w, *page);
    offerTour(w, preferences);
    page->show();
    page->setFocus();
    return page;
}

} // namespace edgescan::ui
