// Robots with ROS in the real window: a bag from the start page, a recorded bridge that is played, clouds over a bridge.
#include "app/lab/robots/bridge.h"
#include "core/exports/report.h"
#include "tests/support/point_lists.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/scans.h"
#include "tests/support/served_program.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/files/source.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/live/topic_menu.h"
#include "ui/panels/start/start_page.h"
#include "ui/window/start.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

using namespace edgescan;
using namespace edgescan::ui;

class RobotWindowTest : public QObject {
    Q_OBJECT

    static constexpr int kLines = 90, kBeams = 191;
    test::TemporaryFolder folder_;
    std::string bell_;
    Scan scan_;

    static std::string shownMask(WindowFixture& on) { return exports::maskSha256(*on.picture().detection->mask); }
    [[nodiscard]] static std::string maskOf(const std::string& file) {
        const auto run = test::runCli("detect " + file + " --json -");
        return run.code == 0 ? nlohmann::json::parse(run.out)["edge_mask_sha256"].get<std::string>() : run.err;
    }
    /// What edgescan-cli records of an emulated bridge.
    [[nodiscard]] std::string recorded(const std::string& name, const std::string& served, const std::string& record) const {
        std::string path = (folder_ / name).string();
        const test::ServedProgram bridge(bell_ + " --bridge " + served);
        const auto run = test::runCli("record ws://" + bridge.address() + " -o " + path + ' ' + record + " --seconds 120");
        return run.code == 0 ? path : run.err;
    }

private slots:
    void initTestCase() {
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        const auto bell = test::simulatedBell(kLines, kBeams);
        QVERIFY(bell);
        scan_ = *bell;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(files::saveScan(scan_, bell_));
    }

    // The bag of a tilting laser, by someone who sees the program for the first time: each action is a click or a text that is typed.
    void aNewUserReachesTheEdgesOfABagInFiveActions() {
        const std::string path = (folder_ / "tilting.bag").string();
        const Bytes bytes = test::bag1Of(test::rosMessagesOf(scan_, {.from = test::AngleFrom::Joint}));
        test::writeText(path, std::string(bytes.begin(), bytes.end()));
        WindowFixture on;
        on.window.resize(1280, 800);
        StartPage* page = showStart(on.window, on.preferences);
        QVERIFY(on.show() && on.activate());
        int actions = 0;
        const auto click = [&](QWidget* button) {
            ++actions;
            QTest::mouseClick(button, Qt::LeftButton);
        };
        QTimer hand;
        connect(&hand, &QTimer::timeout, this, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr || !dialog->isVisible()) return;
            hand.stop();
            ++actions;
            dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(path));
            click(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open));
        });
        hand.start(30);
        click(page->findChild<QAbstractButton*>("start-open"));
        QVERIFY(on.settled());
        QCOMPARE(on.picture().detection->scan->lines(), kLines);
        QVERIFY(!on.picture().detection->edges->empty());
        QVERIFY2(actions <= 5, qPrintable(QString::number(actions)));
        // What was a guess is said, and one more click lists the topics.
        QVERIFY2(on.viewer.notice.text().contains("GUESS"), qPrintable(on.viewer.notice.text()));
        const auto source = std::make_shared<Scan>(*on.picture().detection->scan); // what is wrong comes before what was guessed
        source->warnings = {"GUESS: the topic.", "No cell has a range."};
        Picture warned = on.picture();
        auto detection = std::make_shared<edges::Detection>(*warned.detection);
        detection->scan = source;
        warned.detection = detection;
        QCOMPARE(warningsOf(warned).front(), QString("No cell has a range."));
        QVERIFY(eventually([&] { return on.viewer.notice.findChild<QAbstractButton*>("notice-action")->isVisible(); }));
    }

    void aRecordedBridgeIsPlayedToTheEdgesOfItsFile() {
        const std::string path = recorded("robot.mcap", "--rate 300", "--lines " + std::to_string(kLines));
        WindowFixture on;
        QVERIFY2(on.showWith(path), path.c_str());
        Timeline& timeline = on.viewer.live.timeline();
        QVERIFY(eventually([&] { return timeline.active() && !on.viewer.engine.behind(); }));
        const std::string whole = shownMask(on);
        QCOMPARE(whole, maskOf(path));
        QCOMPARE(whole, maskOf(bell_));
        QCOMPARE(timeline.lines(), kLines);
        const auto linesShown = [&] { return on.picture().detection->scan->lines(); };
        QVERIFY(on.activate());
        timeline.goTo(40);
        QVERIFY(eventually([&] { return linesShown() == 40 && timeline.position() == 40; }));
        QCOMPARE(on.picture().detection->scan->format, std::string("ROS 2 bag (MCAP)"));
        timeline.setSpeed(5.0);
        QTest::keyClick(&on.window, Qt::Key_Space);
        QVERIFY(timeline.playing());
        QVERIFY(eventually([&] { return !timeline.playing() && !on.viewer.engine.behind() && linesShown() == kLines; }));
        QCOMPARE(shownMask(on), whole);
        QVERIFY(on.viewer.notice.kind() != NoticeBar::Kind::Error);
    }

    // The switch is behind the address of a bridge, and nowhere else: 1,000 m is range_max of the emulated laser.
    void repeatedRangesOfARobotAreKeptOnRequest() {
        auto lines = robots::bridgeSweepOf(scan_);
        QVERIFY(lines);
        for (robots::BridgeLine& line : lines->lines) std::fill_n(line.rangesM.begin() + 20, 12, 1000.0F);
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 300;
        const auto bridge = robots::serveBridge(std::move(*lines), settings);
        QVERIFY(bridge);
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        LivePanel& panel = on.viewer.live.panel();
        auto* keep = panel.findChild<QCheckBox*>("live-keep-repeated");
        panel.askAddress();
        QVERIFY(!keep->isVisible());
        panel.setAddress("ws://127.0.0.1", (*bridge)->port());
        QVERIFY(keep->isVisible() && !keep->isChecked());
        for (const bool wanted : {false, true}) {
            if (wanted) QTest::mouseClick(keep, Qt::LeftButton, {}, {8, keep->height() / 2});
            QCOMPARE(keep->isChecked(), wanted);
            QTest::mouseClick(panel.findChild<QPushButton*>("live-connect"), Qt::LeftButton);
            QVERIFY(!keep->isVisible());
            const auto stream = [&] { return on.viewer.live.scanner().stream(); };
            const auto repeated = [&] { return std::ranges::count(on.picture().detection->scan->rangeMm.cells, 1e6F) > 0; };
            // The second connection begins in the middle of a sweep, which may end, and be held, after a few lines.
            QVERIFY(eventually([&] {
                const auto& shown = on.viewer.engine.picture();
                return shown != nullptr && shown->source.stream == stream() && (wanted ? repeated() : shown->detection->scan->lines() > 20);
            }));
            QCOMPARE(repeated(), wanted);
            QTest::mouseClick(panel.findChild<QPushButton*>("live-connect"), Qt::LeftButton);
            QVERIFY(eventually([&] { return keep->isVisible(); }));
        }
    }

    // A scanner that sends whole clouds: the picture is the newest one, and what was recorded opens with the same edges.
    void theCloudsOfARobotAreShownAndRecorded() {
        const test::ServedProgram served(bell_ + " --bridge --cloud --loop --rate 5");
        WindowFixture on;
        on.viewer.live.setRecordingFolder(QString::fromStdString((folder_ / "recordings").string()));
        QVERIFY(on.show());
        on.viewer.live.connectTo("ws://127.0.0.1", served.port(), scanner::assumedSweep());
        LivePanel& panel = on.viewer.live.panel();
        QVERIFY(eventually(
            [&] { return on.viewer.engine.picture() != nullptr && on.viewer.live.scanner().health().liveness == files::Liveness::Live; }));
        QCOMPARE(on.picture().detection->scan->cells(), scan_.cells());
        emit panel.topics().asked();
        const auto rows = panel.topics().menu()->actions();
        const auto points = std::ranges::find_if(rows, [](const QAction* row) { return row->text().startsWith("/points: clouds of "); });
        QVERIFY(points != rows.end() && (*points)->isChecked());
        QTest::mouseClick(panel.findChild<QPushButton*>("live-record"), Qt::LeftButton);
        QVERIFY(eventually([&] { return on.viewer.live.scanner().recording(); }));
        const std::string live = shownMask(on);
        QVERIFY(eventually([&] { return QString::fromStdString(on.viewer.live.scanner().health().recording).contains("MB"); }));
        QTest::mouseClick(panel.findChild<QPushButton*>("live-record"), Qt::LeftButton);
        QVERIFY(eventually([&] { return on.viewer.live.scanner().recordingClosed(); }));
        const std::string path = on.viewer.live.scanner().recordingPath().toStdString();
        on.viewer.live.scanner().disconnectScanner();
        QVERIFY(eventually([&] { return !on.viewer.live.grows() && on.settled(); }));
        QCOMPARE(maskOf(path), live);
    }
};

int robot_window_test(int argc, char** argv) { return runWindowTest<RobotWindowTest>(argc, argv); }

#include "robot_window_test.moc"
