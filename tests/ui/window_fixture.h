// A window with its own settings memory, and functions that wait for its content.
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/run_program.h"
#include "tests/support/shared_folder.h"
#include "tests/ui/patience.h"
#include "tests/ui/pictures.h"
#include "tests/ui/run_test.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/parameter_row.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/views/image/image_view.h"
#include "ui/views/image/viewport.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include <functional>
#include <string>

namespace edgescan::ui {

struct WindowFixture {
    /// Without a path no settings are stored.
    explicit WindowFixture(const QString& iniPath = {}) : preferences(iniPath), window(preferences) {}

    [[nodiscard]] bool show() {
        window.show();
        return QTest::qWaitForWindowExposed(&window, kPatienceMs);
    }
    /// Gives it the keyboard focus.
    [[nodiscard]] bool activate() {
        window.activateWindow();
        return QTest::qWaitForWindowActive(&window, kPatienceMs);
    }
    /// Waits until the shown picture belongs to the newest settings and scan.
    [[nodiscard]] bool settled() {
        return eventually([this] { return viewer.engine.picture() != nullptr && !viewer.engine.behind() && !viewer.engine.working(); });
    }
    [[nodiscard]] bool open(const std::string& path) {
        viewer.files.open({QString::fromStdString(path)});
        return settled();
    }
    /// Shows the window and opens the scan.
    [[nodiscard]] bool showWith(const std::string& path) { return show() && open(path); }
    [[nodiscard]] bool use(const edges::Settings& settings) {
        viewer.tuning.useSettings(settings);
        return settled();
    }

    [[nodiscard]] const Picture& picture() { return *viewer.engine.picture(); }
    /// The same, as it is drawn: with likely borders of rocks, as soon as they are known.
    [[nodiscard]] const Picture& drawn() { return viewer.engine.bordered() ? *viewer.engine.bordered() : picture(); }
    [[nodiscard]] QSlider* slider(const char* key) { return viewer.panel.row(key)->slider(); }

    Preferences preferences;
    MainWindow window;
    Viewer& viewer = window.viewer();
};

/// A real corridor scan, or a simulated one in `folder` where ../shared is absent.
[[nodiscard]] inline std::string usualScan(const edgescan::test::TemporaryFolder& folder) {
    const std::string real = (edgescan::test::sharedFolder() / "data/lms200_corridor/scan000.json").string();
    if (std::filesystem::exists(real)) return real;
    qWarning("../shared is absent: a simulated scan stands in for the real one");
    sim::SimulationSettings settings;
    settings.lines = 200;
    settings.beams = 300;
    const std::string simulated = (folder / "simulated.json").string();
    if (!files::saveScan(sim::simulate(settings)->scan, simulated)) qFatal("%s cannot be written", simulated.c_str());
    return simulated;
}

/// A button of the window by its object name.
[[nodiscard]] inline QToolButton* tool(MainWindow& window, const char* name) {
    auto* found = window.findChild<QToolButton*>(name);
    if (found == nullptr) qFatal("the window has no button %s", name);
    return found;
}

template <class Test, class Application = QApplication>
int runWindowTest(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat());
    return runTest<Test, Application>(argc, argv);
}

} // namespace edgescan::ui
