// The real window with a live scanner and with recordings: the picture grows, keeps its place, is marked when stale, is recorded and played
// again.
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "app/lab/robots/bridge.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/report.h"
#include "tests/support/own_sockets.h"
#include "tests/support/served_program.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/scanner_link.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/live/topic_menu.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/window/cab_mode.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>

#include <algorithm>
#include <random>
#include <set>

using namespace edgescan;
using namespace edgescan::ui;

class LiveWindowTest : public QObject {
    Q_OBJECT

    static constexpr int kLines = 160;
    static constexpr int kBeams = 381;

    test::TemporaryFolder folder_;
    std::string bell_;
    Scan scan_;

    static scanner::SweepSettings sweep(int expected = kLines) {
        scanner::SweepSettings settings;
        settings.expectedLines = expected;
        settings.degPerLine = 180.0 / kLines;
        settings.firstLineDeg = -90;
        settings.axis = Axis::Sweep;
        return settings;
    }

    // An emulated scanner in this process, so that the test can cause faults.
    [[nodiscard]] std::unique_ptr<scanner::EmulatedScanner> scanner(const scanner::EmulatedScannerSettings& settings) const {
        auto telegrams = scanner::telegramsOf(scan_);
        if (!telegrams) return nullptr;
        auto made = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
        return made ? std::move(*made) : nullptr;
    }

    static int linesShown(MainWindow& window) {
        const auto& picture = window.viewer().engine.picture();
        return picture ? picture->detection->scan->lines() : 0;
    }
    static bool waitForLines(MainWindow& window, int lines) {
        return eventually([&] { return linesShown(window) >= lines; });
    }
    static bool waitForBadge(MainWindow& window, StateBadge::Sign sign) {
        return eventually([&] { return window.viewer().live.panel().strip().badge().sign() == sign; });
    }
    static std::string shownMask(MainWindow& window) { return exports::maskSha256(*window.viewer().engine.picture()->detection->mask); }
    [[nodiscard]] static std::string maskOf(const std::string& file) {
        const auto run = test::runCli("detect " + file + " --json -");
        return run.code == 0 ? nlohmann::json::parse(run.out)["edge_mask_sha256"].get<std::string>() : run.err;
    }
    static void press(MainWindow& window, const char* name) {
        QTest::mouseClick(window.viewer().live.panel().findChild<QPushButton*>(name), Qt::LeftButton);
    }
    // The visible pixels of an image view, with texts and stale overlay.
    static QImage seen(QWidget& view) { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

private slots:
    // S2: irregularities of counters, beams and clock are on the screen while they occur.
    void whatIsWrongWithTheTelegramsIsTold() {
        struct Case {
            scanner::ScannerFaults faults;
            QString lines, lost, remark;
            std::size_t remarks = 1;
        };
        scanner::ScannerFaults counters, narrow, clock;
        counters.counterStep = 1000;
        narrow.narrowEvery = 2;
        clock.clockRate = -1;
        for (const Case& each : {Case{counters, "COUNTERS IN DOUBT", "", "COUNTERS IN DOUBT"},
                                 Case{narrow, "lines", " lost: lines ", "START ASSUMED"}, Case{clock, "lines", "", "START ASSUMED", 2}}) {
            scanner::EmulatedScannerSettings settings;
            settings.linesPerSecond = 100;
            settings.faults = each.faults;
            const auto scanner = this->scanner(settings);
            QVERIFY(scanner);
            WindowFixture on;
            QVERIFY(on.show());
            on.viewer.live.connectTo("127.0.0.1", scanner->port(), sweep());
            QVERIFY(waitForLines(on.window, 20));
            const HealthStrip& strip = on.viewer.live.panel().strip();
            const auto isShown = [&] {
                return QString::fromStdString(strip.shown().lines).contains(each.lines) &&
                       QString::fromStdString(strip.shown().lost).contains(each.lost) &&
                       QString::fromStdString(strip.shown().remark) == each.remark && strip.shown().remarks.size() >= each.remarks;
            };
            QVERIFY2(eventually(isShown), qPrintable(QString::fromStdString(strip.shown().lines + " / " + strip.shown().remark)));
            QCOMPARE(on.viewer.statusLine.recordedShown(), QString()); // the picture is live
            on.viewer.live.scanner().disconnectScanner();
        }
    }

    void initTestCase() {
        const auto bell = test::simulatedBell(kLines, kBeams);
        QVERIFY(bell);
        scan_ = *bell;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(files::saveScan(scan_, bell_));
    }

    // Next to the address the number alone was not understood. A cab has no room for the word.
    void thePortHasItsName() {
        WindowFixture on;
        QVERIFY(on.show());
        LivePanel& panel = on.viewer.live.panel();
        panel.askAddress();
        const auto* port = panel.findChild<QSpinBox*>("live-port");
        QVERIFY(port->isVisible());
        QCOMPARE(port->text(), QString("Port 2112"));
        QVERIFY(port->fontMetrics().horizontalAdvance("Port 65535") < port->width() - 16);
        on.window.cab().set(true);
        QCOMPARE(port->text(), QString("2112"));
    }

    // Also when the scan on the screen is read again, as without its pose.
    void theRowOfTheAddressStaysWhileAScanOpens() {
        WindowFixture on;
        QVERIFY(on.show());
        LivePanel& panel = on.viewer.live.panel();
        panel.askAddress();
        QVERIFY(on.open(bell_));
        QVERIFY(panel.isVisible() && panel.findChild<QLineEdit*>("live-host")->isVisible());
        panel.toggleAddress();
        QVERIFY(!panel.isVisible());
        QVERIFY(on.open(bell_));
        QVERIFY(!panel.isVisible());
    }

    // A robot's bridge: the port is that of the field or of the address, the topics are listed with what they give, and one is chosen.
    void theTopicsOfARobotAreListedAndChosen() {
        auto lines = robots::bridgeSweepOf(scan_);
        QVERIFY(lines);
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 100;
        auto bridge = robots::serveBridge(std::move(*lines), settings);
        QVERIFY(bridge);
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        QTest::keyClick(&on.window, Qt::Key_L, Qt::ControlModifier);
        LivePanel& panel = on.viewer.live.panel();
        auto* host = panel.findChild<QLineEdit*>("live-host");
        auto* port = panel.findChild<QSpinBox*>("live-port");
        QTRY_VERIFY(host->isVisible());
        QCOMPARE(port->value(), 2112);
        host->setText("ws://127.0.0.1");
        QCOMPARE(port->value(), 8765);
        host->setText("ws://127.0.0.1:1234");
        QCOMPARE(panel.port(), 1234);
        QVERIFY(!port->isEnabled());
        host->setText("wss://127.0.0.1");
        press(on.window, "live-connect");
        QVERIFY(on.viewer.notice.isVisible() && !on.viewer.live.scanner().connected());
        host->setText("ws://127.0.0.1");
        port->setValue((*bridge)->port());
        QTest::keyClick(port, Qt::Key_Return);
        QVERIFY(waitForLines(on.window, 20));
        QVERIFY(panel.topics().isVisible());
        const auto row = [&](const QString& words) -> QAction* {
            emit panel.topics().asked();
            const auto rows = panel.topics().menu()->actions();
            const auto found = std::ranges::find_if(rows, [&](const QAction* each) { return each->text().contains(words); });
            return found != rows.end() ? *found : nullptr;
        };
        QAction* scan = row("/scan: lines of 381 beams; messages: ");
        QVERIFY(scan != nullptr && scan->isChecked() && scan->isEnabled());
        QVERIFY(row("from the transforms") != nullptr && row("from the transforms")->isChecked());
        QVERIFY(row("/tf: transforms: head in mast") != nullptr);
        QVERIFY(row("Topics that are not used: 1") != nullptr);
        const std::uint64_t stream = on.viewer.live.scanner().stream();
        row("/scan: lines")->trigger();
        QVERIFY(on.viewer.live.scanner().stream() != stream);
        QVERIFY(eventually([&] {
            const auto& picture = on.viewer.engine.picture();
            return picture->source.stream == on.viewer.live.scanner().stream() && linesShown(on.window) > 10;
        }));
        on.viewer.live.scanner().disconnectScanner();
    }

    void theSweepGrowsWhileSlidersWorkAndEndsAsTheFile() {
        const test::ServedProgram served(bell_ + " --rate 60 --loop");
        QVERIFY(served.port() > 0);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        // Like an operator.
        QVERIFY(on.activate());
        QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier);
        auto* host = window.viewer().live.panel().findChild<QLineEdit*>("live-host");
        QTRY_VERIFY(host->isVisible());
        host->setText("127.0.0.1");
        window.viewer().live.panel().findChild<QSpinBox*>("live-port")->setValue(served.port());
        window.viewer().live.panel().setSweep(sweep());
        std::set<int> lines;
        std::set<std::pair<double, double>> windows;
        std::set<std::string> growingSizes;
        connect(&window, &MainWindow::pictureShown, this, [&] {
            const Picture& picture = *window.viewer().engine.picture();
            lines.insert(picture.detection->scan->lines());
            if (!picture.source.growth.growing) return;
            windows.insert({picture.detection->settings.nearMm, picture.detection->settings.farMm});
            growingSizes.insert(std::to_string(picture.gray->width()) + "x" + std::to_string(picture.gray->height()));
        });
        press(window, "live-connect");
        QVERIFY(waitForLines(window, 20));
        QVERIFY(waitForBadge(window, StateBadge::Sign::Good));
        QVERIFY2(window.viewer().live.panel().scannerShown().contains("SN 18110550"),
                 qPrintable(window.viewer().live.panel().scannerShown()));
        const QString soFar = window.viewer().live.panel().findChild<QLabel*>("live-lines")->text();
        QVERIFY2(QRegularExpression("^sweep 1: [0-9]+/160 lines$").match(soFar).hasMatch(), qPrintable(soFar));
        QVERIFY2(window.viewer().warnings.warnings().filter("INCOMPLETE").isEmpty(), "a sweep that grows is not incomplete");
        QVERIFY(!window.viewer().statusLine.findChild<QLabel*>("incomplete")->isVisible());

        // Every picture is consistent, and equals the complete method with the settings that it names.
        const auto growing = window.viewer().engine.picture();
        QVERIFY(growing->source.growth.growing);
        QCOMPARE(*growing->detection->mask, *edges::detectEdges(growing->detection->scan, growing->detection->settings)->mask);
        QCOMPARE(static_cast<int>(window.viewer().views.cloud().geometryOfCloud()->cells()),
                 static_cast<int>(window.viewer().views.cloud().scan()->cells()));

        // A camera that was moved stays; so does the zoom of the images.
        CameraPose pose = window.viewer().views.cloud().camera();
        pose.position.x() += 0.5;
        window.viewer().views.cloud().setCamera(pose);
        window.viewer().views.gray().viewPort()->zoomAt({100, 5}, 3.0);
        const double zoom = window.viewer().views.gray().viewPort()->zoom();
        const int before = linesShown(window);
        QSlider* slider = on.slider("lower");
        slider->setValue(slider->value() + 7);
        const double wanted = window.viewer().engine.settings().lower;
        QVERIFY(eventually([&] { return window.viewer().engine.picture()->detection->settings.lower == wanted; }));
        QVERIFY2(window.viewer().engine.picture()->source.growth.growing, "the slider works while the sweep grows");
        QVERIFY(waitForLines(window, before + 30));
        QVERIFY(window.viewer().views.cloud().camera() == pose);
        QCOMPARE(window.viewer().views.gray().viewPort()->zoom(), zoom);
        slider->setValue(slider->value() - 7);

        QVERIFY(eventually([&] { return linesShown(window) == kLines && !window.viewer().engine.picture()->source.growth.growing; }));
        QVERIFY(eventually([&] { return !window.viewer().engine.behind(); }));
        QCOMPARE(shownMask(window), maskOf(bell_));
        QVERIFY2(lines.size() > 8, "line by line, not all at once");
        QVERIFY2(windows.size() <= 6, "the range window stays while the sweep grows");
        QCOMPARE(growingSizes, std::set<std::string>{"381x160"});
        // The next sweep does not replace the finished one.
        QSignalSpy health(&window.viewer().live.scanner(), &ScannerLink::healthChanged);
        QTRY_VERIFY(health.count() > 5); // lines of the next sweep arrive
        QCOMPARE(linesShown(window), kLines);
        QVERIFY(!window.viewer().live.scanner().following());
        LinkedViews& views = window.viewer().views;
        QVERIFY(views.gray().pictureFrame().colour.isValid() && views.gray().pictureFrame().words.isEmpty());
        QCOMPARE(views.edges().pictureFrame(), views.gray().pictureFrame());
        QCOMPARE(views.cloud().pictureFrame(), views.gray().pictureFrame());
        QVERIFY(window.viewer().live.panel().strip().findChild<QWidget*>("live-badge")->toolTip().startsWith("Sweep 1 is held"));
        press(window, "live-follow");
        QVERIFY(eventually([&] { return window.viewer().engine.picture()->source.growth.growing; }));
        QVERIFY(!views.gray().pictureFrame().colour.isValid());
        QVERIFY(window.viewer().views.cloud().camera() == pose);
    }

    void nothingListensAndTheScannerIsTheOnlyOtherEnd() {
        const test::ServedProgram served(bell_ + " --rate 60 --loop");
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", served.port(), sweep());
        QVERIFY(waitForLines(window, 5));
        const auto sockets = test::ownTcpSockets();
        QCOMPARE(static_cast<int>(sockets.size()), 1);
        QVERIFY(!sockets.front().listening);
        QCOMPARE(sockets.front().remotePort, served.port());
        QVERIFY(sockets.front().loopback);
        press(window, "live-connect"); // Stop
        QVERIFY(eventually([&] { return test::ownTcpSockets().empty(); }));
        QCOMPARE(window.viewer().live.panel().strip().badge().text(), QString("STOPPED"));
    }

    // That a picture is called outdated after two seconds is tested with the status itself (LiveHealth).
    void anOutdatedPictureIsMarkedAtOnce() {
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 60;
        settings.faults.stallEvery = 70;
        settings.faults.stallS = 4;
        const auto emulated = scanner(settings);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        QVERIFY(waitForBadge(window, StateBadge::Sign::Good));
        QVERIFY(waitForLines(window, 60));
        QVERIFY(window.viewer().views.gray().pictureFrame().words.isEmpty());
        const QImage fresh = seen(window.viewer().views.gray());
        int outdated = 0, notMarked = 0;
        connect(&window.viewer().live.scanner(), &ScannerLink::healthChanged, this, [&] {
            if (!window.viewer().live.scanner().showsStale()) return;
            ++outdated;
            notMarked += window.viewer().views.gray().pictureFrame().words.isEmpty() ? 1 : 0;
        });
        QVERIFY(eventually([&] { return outdated > 0; }));
        QCOMPARE(notMarked, 0);
        QVERIFY2(window.viewer().views.gray().pictureFrame().words.startsWith("STALE") ||
                     window.viewer().views.gray().pictureFrame().words.startsWith("LOST"),
                 qPrintable(window.viewer().views.gray().pictureFrame().words));
        QCOMPARE(window.viewer().views.edges().pictureFrame().words, window.viewer().views.gray().pictureFrame().words);
        const QString last = window.viewer().views.gray().pictureFrame().more;
        QVERIFY2(QRegularExpression("^last line [1-9][0-9]* at [0-2][0-9]:[0-5][0-9]:[0-5][0-9] UTC( · trying to connect again)?$")
                     .match(last)
                     .hasMatch(),
                 qPrintable(last));
        QCOMPARE(window.viewer().views.cloud().pictureFrame().words, window.viewer().views.gray().pictureFrame().words);
        const QImage stale = seen(window.viewer().views.gray());
        for (int eighth = 0; eighth < 8; ++eighth) { // the whole picture, not a corner
            int others = 0;
            for (int x = eighth * stale.width() / 8; x < (eighth + 1) * stale.width() / 8; ++x)
                others += stale.pixel(x, stale.height() / 4) != fresh.pixel(x, stale.height() / 4) ? 1 : 0;
            QVERIFY(others > 0);
        }
        QVERIFY(window.viewer().live.panel().strip().badge().sign() != StateBadge::Sign::Good);
        // When data arrives again, the picture continues.
        QVERIFY(eventually([&] { return window.viewer().views.gray().pictureFrame().words.isEmpty(); }));
        QCOMPARE(window.viewer().live.panel().strip().badge().text(), QString("LIVE"));
    }

    void aDroppedConnectionIsLostAndComesBack() {
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 60;
        settings.keepTurning = true; // lines pass meanwhile: they are lost, and reported as lost
        const auto emulated = scanner(settings);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep(0));
        QVERIFY(waitForLines(window, 20));
        emulated->dropConnections();
        QVERIFY(waitForBadge(window, StateBadge::Sign::Failed));
        QVERIFY(window.viewer().live.panel().strip().badge().text().startsWith("LOST"));
        QVERIFY(window.viewer().views.gray().pictureFrame().words.startsWith("LOST"));
        QVERIFY2(window.viewer().views.gray().pictureFrame().more.endsWith("trying to connect again"),
                 qPrintable(window.viewer().views.gray().pictureFrame().more));
        QVERIFY(waitForBadge(window, StateBadge::Sign::Good));
        QVERIFY(eventually([&] { return !window.viewer().live.panel().strip().shown().lost.empty(); }));
        QVERIFY(eventually([&] { return countCells(*on.picture().detection->scan)[static_cast<std::size_t>(CellState::Lost)] > 0; }));
        QCOMPARE(emulated->statistics().writes, 0ULL);
    }

    // The scanner restarts in the middle of a sweep. The picture of that sweep is held while the strip counts the lines of the next one:
    // each count says of which sweep it is.
    void theStripSaysWhichSweepItCounts() {
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 100;
        settings.keepTurning = true;
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        const auto emulated = scanner(settings); // after the window: it turns at once, and the connection is made near the first line
        QVERIFY(emulated);
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        QVERIFY(waitForLines(window, 60));
        emulated->dropConnections();
        const ScannerLink& scanner = window.viewer().live.scanner();
        QVERIFY(eventually([&] { return scanner.connected() && !scanner.following(); })); // the sweep ended: held
        QVERIFY(eventually([&] { return scanner.health().sweep == 2 && scanner.health().row > 0; }));
        HealthStrip& strip = window.viewer().live.panel().strip();
        QCOMPARE(strip.badge().text(), QString("HELD"));
        QStringList texts;
        for (const auto* label : strip.findChildren<QLabel*>()) texts << label->text();
        QVERIFY2(!texts.filter(QRegularExpression("^now sweep 2: .*/160$")).isEmpty(), qPrintable(texts.join('\n')));
        QVERIFY2(!texts.filter("Sweep 1 is held").isEmpty(), qPrintable(texts.join('\n')));
        QVERIFY(window.viewer().views.gray().pictureFrame().colour.isValid());
        QVERIFY(on.settled());
        // Cab mode counts the lines that arrived, as the warning of the picture does.
        window.cab().set(true);
        const QString facts = window.findChild<QLabel*>("cab-facts")->toolTip();
        const QRegularExpressionMatch arrived = QRegularExpression("INCOMPLETE · (\\d+) of 160 lines").match(facts);
        QVERIFY2(arrived.hasMatch(), qPrintable(facts));
        const QString warnings = window.viewer().warnings.warnings().join('\n');
        QVERIFY2(warnings.contains(QString("INCOMPLETE %1/160 lines").arg(arrived.captured(1))), qPrintable(warnings + facts));
        window.cab().set(false);
    }

    void nobodyThereIsSaidAndTriedAgain() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", 9, sweep());
        QVERIFY(waitForBadge(window, StateBadge::Sign::Failed));
        QVERIFY(QString::fromStdString(window.viewer().live.scanner().health().sentence).contains("127.0.0.1:9"));
        QVERIFY(!window.viewer().engine.picture());
        press(window, "live-connect");
        QVERIFY(!window.viewer().live.scanner().connected());
    }

    void aRecordingOpensAgainWithTheSameMaskAndIsPlayed() {
        const QString folder = QString::fromStdString((folder_ / "recordings").string());
        const test::ServedProgram served(bell_ + " --rate 100");
        WindowFixture on(QString::fromStdString((folder_ / "recordings.ini").string()));
        MainWindow& window = on.window;
        window.viewer().live.setRecordingFolder(folder);
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", served.port(), sweep());
        press(window, "live-record"); // before the first line arrives
        QVERIFY(window.viewer().live.scanner().recording());
        QVERIFY(eventually([&] { return linesShown(window) == kLines && !window.viewer().engine.picture()->source.growth.growing; }));
        QVERIFY(eventually([&] { return !window.viewer().engine.behind(); }));
        const std::string live = shownMask(window);
        press(window, "live-keep");
        QVERIFY(eventually([&] { return QDir(folder).entryList({"last-minute_*.mcap"}).size() == 1; }));
        press(window, "live-record");
        QVERIFY(eventually([&] { return window.viewer().notice.isVisible() && window.viewer().notice.text().contains("sweep_"); }));
        press(window, "live-connect");
        const QStringList recordings = QDir(folder).entryList({"sweep_*.mcap"});
        QCOMPARE(recordings.size(), 1);
        const QString path = QDir(folder).filePath(recordings.front());
        QVERIFY2(on.preferences.recentFiles().contains(path), "a new recording is a recent scan");
        QCOMPARE(live, maskOf(bell_));
        QCOMPARE(maskOf(path.toStdString()), live);
        QCOMPARE(maskOf(QDir(folder).filePath(QDir(folder).entryList({"last-minute_*.mcap"}).front()).toStdString()), live);

        window.viewer().files.open({path});
        Timeline& timeline = window.viewer().live.timeline();
        QVERIFY(eventually([&] { return timeline.active() && !window.viewer().engine.behind(); }));
        QCOMPARE(shownMask(window), live);
        QCOMPARE(timeline.lines(), kLines);
        QCOMPARE(timeline.position(), kLines);
        QVERIFY2(timeline.labelShown().startsWith("RECORDED · line ") && timeline.labelShown().contains(" at 20"),
                 qPrintable(timeline.labelShown()));
        QVERIFY2(window.viewer().statusLine.recordedShown().startsWith("first line 20"),
                 qPrintable(window.viewer().statusLine.recordedShown()));
        const auto at = [&](int line) { return eventually([&] { return linesShown(window) == line && timeline.position() == line; }); };
        QVERIFY(on.activate());
        QTest::keyClick(&window, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(at(kLines - 10));
        QTest::keyClick(&window, Qt::Key_Left);
        QVERIFY(at(kLines - 11));
        const Picture& part = *window.viewer().engine.picture();
        QCOMPARE(*part.detection->mask, *edges::detectEdges(part.detection->scan, part.detection->settings)->mask);
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
        QVERIFY(eventually([&] { return linesShown(window) > 60; }));
        QTest::keyClick(&window, Qt::Key_Space);
        QVERIFY(!timeline.playing());
        timeline.setSpeed(10.0);
        QTest::keyClick(&window, Qt::Key_Space);
        QVERIFY(eventually([&] { return !timeline.playing() && !window.viewer().engine.behind() && linesShown(window) == kLines; }));
        QCOMPARE(shownMask(window), live);
        QCOMPARE(window.viewer().engine.picture()->detection->scan->path, path.toStdString());
        window.viewer().files.open({QString::fromStdString(bell_)});
        QVERIFY(eventually([&] { return !timeline.active() && !timeline.isVisible(); }));
    }

    // Three sweeps in one recording: each is found, and going back shows the right one.
    void aRecordingOfSeveralSweepsIsScrubbed() {
        const std::string path = (folder_ / "three.mcap").string();
        {
            const test::ServedProgram served(bell_ + " --rate 600 --loop --lose-every 33");
            const auto run = test::runCli("record " + served.address() + " -o " + path + " --lines 390 --expected-lines 160 --axis sweep" +
                                          " --line-start -90 --line-step 1.125 --seconds 120");
            QCOMPARE(run.code, 0);
        }
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().files.open({QString::fromStdString(path)});
        Timeline& timeline = window.viewer().live.timeline();
        QVERIFY(eventually([&] { return timeline.active() && !window.viewer().engine.behind(); }));
        QCOMPARE(static_cast<int>(timeline.contents().sweeps.size()), 3);
        QVERIFY2(timeline.labelShown().contains(" of 3"), qPrintable(timeline.labelShown()));
        const QRegularExpressionMatch place = QRegularExpression("line (\\d+)/(\\d+) at").match(timeline.labelShown());
        QVERIFY2(place.captured(1).toInt() > 0 && place.captured(1).toInt() <= place.captured(2).toInt() &&
                     place.captured(2).toInt() <= 160,
                 qPrintable(timeline.labelShown())); // of the sweep, not of the recording
        const std::string opened = shownMask(window);
        const auto recording = files::Recording::open(path);
        QVERIFY(recording);
        std::mt19937 random(4);
        for (int i = 0; i < 12; ++i) {
            const int line = 1 + static_cast<int>(random() % static_cast<unsigned>(timeline.lines()));
            timeline.goTo(line);
            files::Replay fresh(*recording);
            fresh.seek(line);
            const auto expected = fresh.snapshot();
            QVERIFY(eventually([&] { return linesShown(window) == expected->lines() && !window.viewer().engine.behind(); }));
            QVERIFY(window.viewer().engine.picture()->detection->scan->rangeMm == expected->rangeMm);
            QVERIFY(window.viewer().engine.picture()->detection->scan->state == expected->state);
        }
        // A click near the mark of a sweep means the mark: the sweep before it is whole there.
        auto* slider = window.findChild<QSlider*>("timeline-slider");
        for (const int sweep : {1, 2}) {
            const int mark = timeline.contents().sweeps[static_cast<std::size_t>(sweep)].firstLine;
            timeline.goTo(5);
            const int handle = slider->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, slider);
            const int x =
                handle / 2 + QStyle::sliderPositionFromValue(slider->minimum(), slider->maximum(), mark, slider->width() - handle);
            QTest::mouseClick(slider, Qt::LeftButton, Qt::NoModifier, QPoint(sweep == 1 ? x - 4 : x + 4, slider->height() / 2));
            QCOMPARE(timeline.position(), mark);
        }
        // The keys of the next and the previous scan go from sweep to sweep, before they leave the recording.
        QVERIFY(on.activate());
        timeline.goTo(5);
        const auto& sweeps = timeline.contents().sweeps;
        for (const int end : {sweeps[1].firstLine, sweeps[2].firstLine, timeline.lines()}) {
            QTest::keyClick(&window, Qt::Key_PageDown);
            QCOMPARE(timeline.position(), end);
        }
        QVERIFY(window.viewer().notice.isHidden() || !window.viewer().notice.text().contains("last scan"));
        QTest::keyClick(&window, Qt::Key_PageDown);
        QVERIFY(eventually([&] { return window.viewer().notice.text().contains("last scan"); }));
        QTest::keyClick(&window, Qt::Key_PageUp);
        QCOMPARE(timeline.position(), sweeps[2].firstLine);
        timeline.goTo(timeline.home());
        QVERIFY(eventually(
            [&] { return window.viewer().engine.picture()->detection->scan->path == path && !window.viewer().engine.behind(); }));
        QCOMPARE(shownMask(window), opened);
    }
};

int live_window_test(int argc, char** argv) { return runWindowTest<LiveWindowTest>(argc, argv); }

#include "live_window_test.moc"
