// How long the GUI thread is away while a slider moves over a full sweep. Prints; asserts no time.
#include "core/io/save_scan.h"
#include "core/sim/simulate.h"
#include "tests/support/run_program.h"
#include "ui/cloud/cloud_view.h"
#include "ui/main/main_window.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/parameter_row.h"

#include <QElapsedTimer>
#include <QSlider>
#include <QtTest>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::ui;

class ResponsivenessTest : public QObject {
    Q_OBJECT

    // Gaps between the ticks of a 1 ms timer on the GUI thread, ms, longest first.
    template <class Act>
    static std::vector<qint64> gapsWhile(Act act) {
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

    static void tell(const char* what, const std::vector<qint64>& gaps) {
        if (gaps.size() < 3) return;
        qInfo("%s: GUI thread away for at most %lld, %lld, %lld ms", what, static_cast<long long>(gaps[0]), static_cast<long long>(gaps[1]),
              static_cast<long long>(gaps[2]));
    }

private slots:
    void openingAndTuningAFullSweep() {
        const test::TemporaryFolder folder;
        const std::string path = (folder / "bell.json").string();
        SimulationSettings bell;
        bell.footprint = false; // the picture does not matter here, the number of points does
        QVERIFY(saveScan(simulate(bell)->scan, path));
        Memory none{QString()};
        MainWindow window(none);
        window.usePreset(*findPreset("log"));
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        tell("opening", gapsWhile([&] {
                 window.openFile(QString::fromStdString(path));
                 QVERIFY(QTest::qWaitFor([&] { return window.session().picture() != nullptr; }, 20000));
                 QTest::qWait(1500);
             }));
        QSlider* slider = window.panel().row("lower")->slider();
        int pictures = 0;
        connect(&window, &MainWindow::pictureShown, this, [&] { ++pictures; });
        tell("200 slider moves in 2 s", gapsWhile([&] {
                 for (int move = 0; move < 200; ++move) {
                     slider->setValue(100 + move);
                     QTest::qWait(10);
                 }
             }));
        qInfo("%d pictures shown for 200 moves", pictures);
        QVERIFY(pictures > 0);
        QVERIFY(QTest::qWaitFor([&] { return !window.session().behind(); }, 20000));
        QCOMPARE(window.session().picture()->detection->settings.lower, sliderValue(window.panel().row("lower")->parameter(), 299));
        tell("at rest", gapsWhile([] { QTest::qWait(1500); }));
    }
};

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat());
    QApplication application(argc, argv);
    ResponsivenessTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "responsiveness_test.moc"
