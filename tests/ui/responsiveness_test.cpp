// How long the GUI thread is blocked while a slider moves over a full sweep, from a file and from a scanner. Prints times; asserts none.
#include "app/lab/sim/simulate.h"
#include "core/edges/settings/presets.h"
#include "core/edges/settings/slider_scale.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/served_program.h"
#include "tests/ui/window_fixture.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTimer>

#include <algorithm>
#include <ctime>
#include <map>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

double threadMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Records the event that blocked the GUI thread longest.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override {
        if (depth_ > 0 || !watching) return QApplication::notify(receiver, event);
        ++depth_;
        const QString name = QString("%1 of %2 %3").arg(event->type()).arg(receiver->metaObject()->className(), receiver->objectName());
        QElapsedTimer clock;
        clock.start();
        const double cpu = threadMs();
        const bool result = QApplication::notify(receiver, event);
        const auto ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        if (ms > 60) events[name] = std::max(events[name], std::pair(ms, threadMs() - cpu));
        --depth_;
        return result;
    }
    bool watching = false;
    std::map<QString, std::pair<double, double>> events; ///< longer than 60 ms: wall time and CPU time of the longest of its kind

private:
    int depth_ = 0;
};

// Gaps between the ticks of a 1 ms timer on the GUI thread, ms, longest first.
template <class Act>
std::vector<qint64> gapsWhile(Act act) {
    std::vector<qint64> gaps;
    QElapsedTimer clock;
    clock.start();
    qint64 last = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        gaps.push_back(clock.elapsed() - last);
        last = clock.elapsed();
    });
    timer.start(1);
    act();
    std::sort(gaps.rbegin(), gaps.rend());
    return gaps;
}

void tell(const char* what, const std::vector<qint64>& gaps) {
    if (gaps.size() < 3) return;
    qInfo("%s: GUI thread away for at most %lld, %lld, %lld ms", what, static_cast<long long>(gaps[0]), static_cast<long long>(gaps[1]),
          static_cast<long long>(gaps[2]));
}

// `move` is called with 0, 1, 2 ... every `ms`, until `done`. False if it never is.
template <class Move, class Done>
bool movesUntil(int ms, Move move, Done done) {
    int count = 0;
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, [&] { move(count++); });
    hand.start(ms);
    return eventually([&] { return done(count); });
}

} // namespace

class ResponsivenessTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;

private slots:
    void openingAndTuningAFullSweep() {
        const std::string path = (folder_ / "bell.json").string();
        sim::SimulationSettings bell;
        bell.footprint = false; // only the number of points matters here, not the picture
        QVERIFY(files::saveScan(sim::simulate(bell)->scan, path));
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().tuning.usePreset(*edges::findPreset("log"));
        QVERIFY(on.show());
        tell("opening", gapsWhile([&] {
                 QVERIFY(on.open(path));
                 QVERIFY(eventually([&] { return window.viewer().views.cloud().drawnFraction() >= 1.0; }));
             }));
        QSlider* slider = on.slider("lower");
        int pictures = 0;
        connect(&window, &MainWindow::pictureShown, this, [&] { ++pictures; });
        tell("200 slider moves in 2 s", gapsWhile([&] {
                 const auto move = [&](int n) { slider->setValue(100 + std::min(n, 199)); };
                 QVERIFY(movesUntil(10, move, [](int count) { return count >= 200; }));
             }));
        qInfo("%d pictures shown for 200 moves", pictures);
        QVERIFY(pictures > 0);
        QVERIFY(on.settled());
        QCOMPARE(on.picture().detection->settings.lower, edges::sliderValue(window.viewer().panel.row("lower")->parameter(), 299));
        const auto nothing = [](int) {};
        tell("at rest", gapsWhile([&] { QVERIFY(movesUntil(100, nothing, [](int count) { return count >= 15; })); }));
    }

    void aFullSweepFromAScanner() {
        const std::string full = (folder_ / "full.json").string();
        QCOMPARE(test::runLab("simulate -o " + full + " --scene staircase --lines 1000").code, 0);
        const test::ServedProgram served(full + " --rate 200 --loop");
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        scanner::SweepSettings settings;
        settings.expectedLines = 1000;
        settings.degPerLine = 0.18;
        settings.firstLineDeg = -90;
        settings.axis = Axis::Sweep;
        const auto lines = [&] { return window.viewer().engine.picture() ? on.picture().detection->scan->lines() : 0; };
        window.viewer().live.connectTo("127.0.0.1", served.port(), settings);
        QVERIFY(eventually([&] { return lines() >= 10; }));
        auto& application = *static_cast<TimedApplication*>(QCoreApplication::instance());
        application.watching = true;
        QSignalSpy pictures(&window, &MainWindow::pictureShown);
        QElapsedTimer clock;
        clock.start();
        const auto gaps = gapsWhile([&] {
            int moves = 0;
            QTimer hand;
            connect(&hand, &QTimer::timeout, this, [&] { on.slider("lower")->setValue(100 + 20 * moves++ % 100); });
            hand.start(200);
            while (lines() < 1000) QVERIFY(eventually([&, before = lines()] { return lines() > before; })); // however slowly it grows
        });
        application.watching = false;
        tell("a growing sweep", gaps);
        qInfo("a sweep of 1000 x 1141 grew to %d lines in %lld ms, %d pictures", lines(), clock.elapsed(),
              static_cast<int>(pictures.count()));
        for (const auto& [name, times] : application.events)
            qInfo("event %s: %.0f ms, of these %.0f ms at work", qPrintable(name), times.first, times.second);
        QVERIFY(pictures.count() > 5);
    }
};

int responsiveness_test(int argc, char** argv) { return runWindowTest<ResponsivenessTest, TimedApplication>(argc, argv); }

#include "responsiveness_test.moc"
