// The real window on a live scanner and on recordings: grows, keeps its place, tells what is stale, records, plays again.
#include "core/emulator/emulated_scanner.h"
#include "core/emulator/emulated_telegram.h"
#include "core/io/save_scan.h"
#include "core/method/pipeline.h"
#include "core/report/report.h"
#include "core/sim/simulate.h"
#include "tests/support/own_sockets.h"
#include "tests/support/served_program.h"
#include "ui/base/notice_bar.h"
#include "ui/cloud/cloud_view.h"
#include "ui/image/image_view.h"
#include "ui/image/viewport.h"
#include "ui/live/live_panel.h"
#include "ui/live/scanner_link.h"
#include "ui/live/state_badge.h"
#include "ui/live/timeline.h"
#include "ui/main/main_window.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/parameter_row.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QtTest>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <map>
#include <random>
#include <set>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

double threadMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Knows which single event kept the GUI thread longest.
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

} // namespace

class LiveWindowTest : public QObject {
    Q_OBJECT

    static constexpr int kLines = 160;
    static constexpr int kBeams = 381;

    test::TemporaryFolder folder_;
    std::string bell_;
    Scan scan_;

    static SweepSettings sweep(int expected = kLines) {
        SweepSettings settings;
        settings.expectedLines = expected;
        settings.degPerLine = 180.0 / kLines;
        settings.firstLineDeg = -90;
        settings.axis = Axis::Sweep;
        return settings;
    }

    // An emulated scanner in this process, so that the test can make it fail.
    [[nodiscard]] std::unique_ptr<EmulatedScanner> scanner(const EmulatedScannerSettings& settings) const {
        auto telegrams = telegramsOf(scan_);
        if (!telegrams) return nullptr;
        auto made = serveTelegrams(std::make_shared<const std::vector<ScanTelegram>>(std::move(*telegrams)), settings);
        return made ? std::move(*made) : nullptr;
    }

    static int linesShown(MainWindow& window) {
        const auto& picture = window.session().picture();
        return picture ? picture->detection->scan->lines() : 0;
    }
    static bool waitForLines(MainWindow& window, int lines, int ms = 20000) {
        return QTest::qWaitFor([&] { return linesShown(window) >= lines; }, ms);
    }
    static bool waitForBadge(MainWindow& window, StateBadge::Sign sign, int ms) {
        return QTest::qWaitFor([&] { return window.livePanel().strip().badge().sign() == sign; }, ms);
    }
    static std::string shownMask(MainWindow& window) { return maskSha256(*window.session().picture()->detection->mask); }
    [[nodiscard]] static std::string maskOf(const std::string& file) {
        const auto run = test::runCli("detect " + file + " --json -");
        return run.code == 0 ? nlohmann::json::parse(run.out)["edge_mask_sha256"].get<std::string>() : run.err;
    }
    static void press(MainWindow& window, const char* name) {
        QTest::mouseClick(window.livePanel().findChild<QPushButton*>(name), Qt::LeftButton);
    }
    // What an image view has on the screen, texts and stale overlay included.
    static QImage seen(QWidget& view) { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

private slots:
    void initTestCase() {
        SimulationSettings settings;
        settings.lines = kLines;
        settings.beams = kBeams;
        auto simulation = simulate(settings);
        QVERIFY(simulation);
        scan_ = simulation->scan;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(saveScan(scan_, bell_));
    }

    void theSweepGrowsWhileSlidersWorkAndEndsAsTheFile() {
        const test::ServedProgram served(bell_ + " --rate 60 --loop");
        QVERIFY(served.port() > 0);
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        // As a hand does it.
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier);
        auto* host = window.livePanel().findChild<QLineEdit*>("live-host");
        QTRY_VERIFY(host->isVisible());
        host->setText("127.0.0.1");
        window.livePanel().findChild<QSpinBox*>("live-port")->setValue(served.port());
        window.livePanel().setSweep(sweep());
        std::set<int> lines;
        std::set<std::pair<double, double>> windows;
        std::set<std::string> growingSizes;
        connect(&window, &MainWindow::pictureShown, this, [&] {
            const Picture& picture = *window.session().picture();
            lines.insert(picture.detection->scan->lines());
            if (!picture.source.growth.growing) return;
            windows.insert({picture.detection->settings.nearMm, picture.detection->settings.farMm});
            growingSizes.insert(std::to_string(picture.gray->width()) + "x" + std::to_string(picture.gray->height()));
        });
        press(window, "live-connect");
        QVERIFY(waitForLines(window, 20));
        QVERIFY(waitForBadge(window, StateBadge::Sign::Good, 2000));
        QVERIFY2(window.livePanel().scannerShown().contains("SN 18110550"), qPrintable(window.livePanel().scannerShown()));
        QVERIFY(window.livePanel().findChild<QLabel*>("live-lines")->text().startsWith("INCOMPLETE "));
        QVERIFY(window.livePanel().findChild<QLabel*>("live-lines")->text().endsWith("/160 lines"));

        // Every picture belongs together and equals the whole method with the settings that it names.
        const auto growing = window.session().picture();
        QVERIFY(growing->source.growth.growing);
        QCOMPARE(*growing->detection->mask, *detectEdges(growing->detection->scan, growing->detection->settings)->mask);
        QCOMPARE(static_cast<int>(window.cloudView().geometryOfCloud()->cells()), static_cast<int>(window.cloudView().scan()->cells()));

        // A camera that was moved stays; so does the zoom of the images.
        CameraPose pose = window.cloudView().camera();
        pose.position.x() += 0.5;
        window.cloudView().setCamera(pose);
        window.grayView().viewPort()->zoomAt({100, 5}, 3.0);
        const double zoom = window.grayView().viewPort()->zoom();
        const int before = linesShown(window);
        QSlider* slider = window.panel().row("lower")->slider();
        slider->setValue(slider->value() + 7);
        const double wanted = window.session().settings().lower;
        QVERIFY(QTest::qWaitFor([&] { return window.session().picture()->detection->settings.lower == wanted; }, 5000));
        QVERIFY2(window.session().picture()->source.growth.growing, "the slider works while the sweep grows");
        QVERIFY(waitForLines(window, before + 30));
        QVERIFY(window.cloudView().camera() == pose);
        QCOMPARE(window.grayView().viewPort()->zoom(), zoom);
        slider->setValue(slider->value() - 7);

        QVERIFY(QTest::qWaitFor([&] { return linesShown(window) == kLines && !window.session().picture()->source.growth.growing; }, 20000));
        QVERIFY(QTest::qWaitFor([&] { return !window.session().behind(); }, 5000));
        QCOMPARE(shownMask(window), maskOf(bell_));
        QVERIFY2(lines.size() > 8, "line by line, not all at once");
        QVERIFY2(windows.size() <= 6, "the range window stays while the sweep grows");
        QCOMPARE(growingSizes, std::set<std::string>{"381x160"});
        // The next sweep does not push the finished one aside.
        QTest::qWait(600);
        QCOMPARE(linesShown(window), kLines);
        QVERIFY(!window.scanner().following());
        QVERIFY(window.grayView().note().startsWith("Held: sweep 1"));
        press(window, "live-follow");
        QVERIFY(QTest::qWaitFor([&] { return window.session().picture()->source.growth.growing; }, 5000));
        QVERIFY(window.cloudView().camera() == pose);
    }

    void nothingListensAndTheScannerIsTheOnlyOtherEnd() {
        const test::ServedProgram served(bell_ + " --rate 60 --loop");
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.connectScanner("127.0.0.1", served.port(), sweep());
        QVERIFY(waitForLines(window, 5));
        const auto sockets = test::ownTcpSockets();
        QCOMPARE(static_cast<int>(sockets.size()), 1);
        QVERIFY(!sockets.front().listening);
        QCOMPARE(sockets.front().remotePort, served.port());
        QVERIFY(sockets.front().loopback);
        press(window, "live-connect"); // Stop
        QVERIFY(QTest::qWaitFor([&] { return test::ownTcpSockets().empty(); }, 5000));
        QCOMPARE(window.livePanel().strip().badge().text(), QString("STOPPED"));
    }

    void aStallIsGreyedWithinTwoSeconds() {
        EmulatedScannerSettings settings;
        settings.linesPerSecond = 60;
        settings.faults.stallEvery = 70;
        settings.faults.stallS = 4;
        const auto emulated = scanner(settings);
        QVERIFY(emulated);
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.connectScanner("127.0.0.1", emulated->port(), sweep());
        QVERIFY(waitForBadge(window, StateBadge::Sign::Good, 5000));
        QVERIFY(waitForLines(window, 60));
        QVERIFY(window.grayView().stale().isEmpty());
        const QImage fresh = seen(window.grayView());
        QVERIFY(QTest::qWaitFor([&] { return emulated->statistics().stalls == 1; }, 5000));
        QElapsedTimer since;
        since.start();
        QVERIFY(QTest::qWaitFor([&] { return !window.grayView().stale().isEmpty(); }, 3000));
        QVERIFY2(since.elapsed() <= 2000, qPrintable(QString("grey after %1 ms").arg(since.elapsed())));
        QVERIFY2(window.grayView().stale().startsWith("STALE") || window.grayView().stale().startsWith("LOST"),
                 qPrintable(window.grayView().stale()));
        QCOMPARE(window.edgeView().stale(), window.grayView().stale());
        QCOMPARE(window.cloudView().stale(), window.grayView().stale());
        const QImage stale = seen(window.grayView());
        int greyer = 0;
        for (int x = 0; x < stale.width(); ++x) greyer += stale.pixel(x, stale.height() / 4) != fresh.pixel(x, stale.height() / 4) ? 1 : 0;
        QVERIFY2(greyer > stale.width() / 2, "the whole picture is greyed, not a corner");
        QVERIFY(window.livePanel().strip().badge().sign() != StateBadge::Sign::Good);
        // When it goes on, so does the picture.
        QVERIFY(QTest::qWaitFor([&] { return window.grayView().stale().isEmpty(); }, 8000));
        QCOMPARE(window.livePanel().strip().badge().text(), QString("LIVE"));
    }

    void aDroppedConnectionIsLostAndComesBack() {
        EmulatedScannerSettings settings;
        settings.linesPerSecond = 60;
        settings.keepTurning = true; // lines pass meanwhile: they are lost, and said to be
        const auto emulated = scanner(settings);
        QVERIFY(emulated);
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.connectScanner("127.0.0.1", emulated->port(), sweep(0));
        QVERIFY(waitForLines(window, 20));
        emulated->dropConnections();
        QVERIFY(waitForBadge(window, StateBadge::Sign::Failed, 1500));
        QVERIFY(window.livePanel().strip().badge().text().startsWith("LOST"));
        QVERIFY(window.grayView().stale().startsWith("LOST"));
        QVERIFY(waitForBadge(window, StateBadge::Sign::Good, 6000));
        QVERIFY(QTest::qWaitFor([&] { return !window.livePanel().strip().shown().lost.empty(); }, 3000));
        QVERIFY(QTest::qWaitFor(
            [&] { return countCells(*window.session().picture()->detection->scan)[static_cast<std::size_t>(CellState::Lost)] > 0; }, 3000));
        QCOMPARE(emulated->statistics().writes, 0ULL);
    }

    void nobodyThereIsSaidAndTriedAgain() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.connectScanner("127.0.0.1", 9, sweep());
        QVERIFY(waitForBadge(window, StateBadge::Sign::Failed, 5000));
        QVERIFY(QString::fromStdString(window.scanner().health().sentence).contains("127.0.0.1:9"));
        QVERIFY(!window.session().picture());
        QElapsedTimer clock;
        clock.start();
        press(window, "live-connect");
        QVERIFY(clock.elapsed() < 100);
        QVERIFY(!window.scanner().connected());
    }

    void aRecordingOpensAgainWithTheSameMaskAndIsPlayed() {
        const QString folder = QString::fromStdString((folder_ / "recordings").string());
        const test::ServedProgram served(bell_ + " --rate 100");
        Memory none{QString()};
        MainWindow window(none);
        window.setRecordingFolder(folder);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.connectScanner("127.0.0.1", served.port(), sweep());
        press(window, "live-record"); // before the first line comes
        QVERIFY(window.scanner().recording());
        QVERIFY(QTest::qWaitFor([&] { return linesShown(window) == kLines && !window.session().picture()->source.growth.growing; }, 20000));
        QVERIFY(QTest::qWaitFor([&] { return !window.session().behind(); }, 5000));
        const std::string live = shownMask(window);
        press(window, "live-keep");
        QVERIFY(QTest::qWaitFor([&] { return QDir(folder).entryList({"last-minute_*.mcap"}).size() == 1; }, 5000));
        press(window, "live-record");
        QVERIFY(QTest::qWaitFor([&] { return window.notice().isVisible() && window.notice().text().contains("sweep_"); }, 5000));
        press(window, "live-connect");
        const QStringList recordings = QDir(folder).entryList({"sweep_*.mcap"});
        QCOMPARE(recordings.size(), 1);
        const QString path = QDir(folder).filePath(recordings.front());
        QCOMPARE(live, maskOf(bell_));
        QCOMPARE(maskOf(path.toStdString()), live);
        QCOMPARE(maskOf(QDir(folder).filePath(QDir(folder).entryList({"last-minute_*.mcap"}).front()).toStdString()), live);

        window.openFile(path);
        Timeline& timeline = window.timeline();
        QVERIFY(QTest::qWaitFor([&] { return timeline.active() && !window.session().behind(); }, 10000));
        QCOMPARE(shownMask(window), live);
        QCOMPARE(timeline.lines(), kLines);
        QCOMPARE(timeline.position(), kLines);
        QVERIFY(timeline.labelShown().startsWith("RECORDED 20"));
        const auto at = [&](int line) {
            return QTest::qWaitFor([&] { return linesShown(window) == line && timeline.position() == line; }, 5000);
        };
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(at(kLines - 10));
        QTest::keyClick(&window, Qt::Key_Left);
        QVERIFY(at(kLines - 11));
        const Picture& part = *window.session().picture();
        QCOMPARE(*part.detection->mask, *detectEdges(part.detection->scan, part.detection->settings)->mask);
        QTest::keyClick(&window, Qt::Key_Right);
        QVERIFY(at(kLines - 10));
        window.findChild<QSlider*>("timeline-slider")->setValue(40);
        QVERIFY(at(40));
        window.findChild<QSlider*>("timeline-slider")->setFocus();
        QTest::keyClick(window.findChild<QSlider*>("timeline-slider"), Qt::Key_End);
        QVERIFY(at(kLines));
        QTest::keyClick(window.findChild<QSlider*>("timeline-slider"), Qt::Key_Home);
        QVERIFY(at(1));
        timeline.goTo(40);
        QVERIFY(at(40));
        timeline.setSpeed(0.25);
        QTest::keyClick(&window, Qt::Key_Space);
        QVERIFY(timeline.playing());
        QVERIFY(QTest::qWaitFor([&] { return linesShown(window) > 60; }, 5000));
        QTest::keyClick(&window, Qt::Key_Space);
        QVERIFY(!timeline.playing());
        timeline.setSpeed(10.0);
        QTest::keyClick(&window, Qt::Key_Space);
        QVERIFY(QTest::qWaitFor([&] { return !timeline.playing() && !window.session().behind() && linesShown(window) == kLines; }, 20000));
        QCOMPARE(shownMask(window), live);
        QCOMPARE(window.session().picture()->detection->scan->path, path.toStdString());
        window.openFile(QString::fromStdString(bell_));
        QVERIFY(QTest::qWaitFor([&] { return !timeline.active() && !timeline.isVisible(); }, 5000));
    }

    // Three sweeps in one recording: each is found, and going back shows the right one.
    void aRecordingOfSeveralSweepsIsScrubbed() {
        const std::string path = (folder_ / "three.mcap").string();
        {
            const test::ServedProgram served(bell_ + " --rate 600 --loop --lose-every 33");
            const auto run = test::runCli("record " + served.address() + " -o " + path + " --lines 390 --expected-lines 160 --axis sweep" +
                                          " --first-line -90 --line-step 1.125 --seconds 30");
            QCOMPARE(run.code, 0);
        }
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(path));
        Timeline& timeline = window.timeline();
        QVERIFY(QTest::qWaitFor([&] { return timeline.active() && !window.session().behind(); }, 10000));
        QCOMPARE(static_cast<int>(timeline.contents().sweeps.size()), 3);
        QVERIFY2(timeline.labelShown().contains(" of 3"), qPrintable(timeline.labelShown()));
        const std::string opened = shownMask(window);
        const auto recording = Recording::open(path);
        QVERIFY(recording);
        std::mt19937 random(4);
        for (int i = 0; i < 12; ++i) {
            const int line = 1 + static_cast<int>(random() % static_cast<unsigned>(timeline.lines()));
            timeline.goTo(line);
            Replay fresh(*recording);
            fresh.seek(line);
            const auto expected = fresh.snapshot();
            QVERIFY(QTest::qWaitFor([&] { return linesShown(window) == expected->lines() && !window.session().behind(); }, 5000));
            QVERIFY(window.session().picture()->detection->scan->rangeMm == expected->rangeMm);
            QVERIFY(window.session().picture()->detection->scan->state == expected->state);
        }
        timeline.goTo(timeline.home());
        QVERIFY(
            QTest::qWaitFor([&] { return window.session().picture()->detection->scan->path == path && !window.session().behind(); }, 5000));
        QCOMPARE(shownMask(window), opened);
    }

    // Prints how long the GUI thread is away while a full-size sweep grows; asserts no time.
    void responsiveness() {
        const std::string full = (folder_ / "full.json").string();
        QCOMPARE(test::runCli("simulate -o " + full + " --scene staircase --lines 1000").code, 0);
        const test::ServedProgram served(full + " --rate 200 --loop");
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        SweepSettings settings = sweep(1000);
        settings.degPerLine = 0.18;
        window.connectScanner("127.0.0.1", served.port(), settings);
        QVERIFY(waitForLines(window, 10));
        std::vector<qint64> gaps;
        QElapsedTimer clock;
        clock.start();
        qint64 last = 0;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&] {
            gaps.push_back(clock.elapsed() - last);
            last = clock.elapsed();
        });
        timer.start(1);
        auto& application = *static_cast<TimedApplication*>(QCoreApplication::instance());
        application.watching = true;
        int pictures = 0;
        const auto counting = connect(&window, &MainWindow::pictureShown, this, [&] { ++pictures; });
        QSlider* slider = window.panel().row("lower")->slider();
        for (int move = 0; linesShown(window) < 1000 && clock.elapsed() < 20000; ++move) {
            if (move % 20 == 0) slider->setValue(100 + move % 100);
            QTest::qWait(10);
        }
        disconnect(counting);
        std::sort(gaps.rbegin(), gaps.rend());
        const auto of = [&](double share) { return gaps[static_cast<std::size_t>(share * static_cast<double>(gaps.size() - 1))]; };
        qInfo("a sweep of 1000 x 1141 grew in %lld ms, %d pictures; the GUI thread was away for at most %lld ms (99 %%: %lld ms)",
              clock.elapsed(), pictures, of(0), of(0.01));
        for (const auto& [name, times] : application.events)
            qInfo("event %s: %.0f ms, of these %.0f ms at work", qPrintable(name), times.first, times.second);
        QVERIFY(pictures > 5);
    }
};

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat());
    TimedApplication application(argc, argv);
    LiveWindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "live_window_test.moc"
