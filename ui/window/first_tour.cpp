// What each step of the tour shows.
#include "ui/window/first_tour.h"

#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/dialogs/sheets.h"
#include "ui/panels/start/tour.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QBoxLayout>
#include <QDockWidget>

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

} // namespace edgescan::ui
