// The window while a scanner is connected: an outdated picture is never marked live, and a stray key loses no data.
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "core/files/recording/writer.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/elided_label.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/panels/dialogs/place_dialog.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/scanner_link.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/sweep_bar.h"
#include "ui/panels/live/timeline.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/count_curve.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/views/cloud/cloud_overlay.h"
#include "ui/views/cloud/view_cube.h"
#include "ui/window/cab_mode.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

#include <set>
#include <utility>

using namespace edgescan;
using namespace edgescan::ui;

class LiveMannersTest : public QObject {
    Q_OBJECT

    static constexpr int kLines = 120;
    test::TemporaryFolder folder_;
    std::string bell_;
    Scan scan_;

    static scanner::SweepSettings sweep(Axis axis = Axis::Sweep) {
        scanner::SweepSettings settings;
        settings.expectedLines = kLines;
        settings.degPerLine = 180.0 / kLines;
        settings.firstLineDeg = -90;
        settings.axis = axis;
        return settings;
    }
    /// `only`: it sends so many lines, for a test that needs the scanner in the middle of a sweep. 0: it does not end.
    [[nodiscard]] std::unique_ptr<scanner::EmulatedScanner> scanner(double linesPerSecond, std::uint16_t port = 0,
                                                                    std::size_t only = 0) const {
        auto telegrams = scanner::telegramsOf(scan_);
        if (!telegrams) return nullptr;
        scanner::EmulatedScannerSettings settings;
        if (only > 0) settings.atEnd = scanner::AtEnd::Stop;
        for (std::size_t next = 0; telegrams->size() < only; ++next) telegrams->push_back((*telegrams)[next]);
        settings.linesPerSecond = linesPerSecond;
        settings.port = port;
        auto made = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
        return made ? std::move(*made) : nullptr;
    }
    static void press(MainWindow& window, const char* name) {
        QTest::mouseClick(window.viewer().live.panel().findChild<QPushButton*>(name), Qt::LeftButton);
    }
    static int lines(MainWindow& window) {
        return window.viewer().engine.picture() ? window.viewer().engine.picture()->detection->scan->lines() : 0;
    }
    /// Shows the window and connects it.
    static bool showsFirstLines(WindowFixture& on, const scanner::EmulatedScanner& emulated) {
        if (!on.show()) return false;
        on.viewer.live.connectTo("127.0.0.1", emulated.port(), sweep());
        return eventually([&on] { return lines(on.window) > 5; });
    }

    /// Shows the window and connects it while the scanner is in the middle of a sweep.
    static bool connectsInTheMiddle(WindowFixture& on, const scanner::EmulatedScanner& emulated) {
        if (!on.show()) return false;
        on.viewer.live.connectTo("127.0.0.1", emulated.port(), sweep());
        if (!eventually([&on] { return lines(on.window) > 60; })) return false;
        press(on.window, "live-connect"); // Stop: the emulated scanner waits at this line
        if (!eventually([&on] { return !on.viewer.engine.behind(); })) return false;
        on.viewer.live.connectTo("127.0.0.1", emulated.port(), sweep());
        return true;
    }

    /// What the button offers after Stop, where there are several.
    static QMenu* openSweeps(MainWindow& window) {
        const auto* button = window.viewer().live.panel().findChild<QPushButton*>("live-other");
        if (!eventually([button] { return button->isVisible(); })) return nullptr;
        QApplication::processEvents(); // its place
        press(window, "live-other");
        auto* menu = window.viewer().live.panel().findChild<QMenu*>("live-others");
        return eventually([menu] { return menu->isVisible(); }) ? menu : nullptr;
    }
    static QStringList offered(MainWindow& window) {
        QStringList words;
        QMenu* menu = openSweeps(window);
        if (menu == nullptr) return words;
        for (const QAction* each : menu->actions()) {
            if (each->objectName() != "close-menu") words << each->text(); // the first entry in a cab
        }
        menu->close();
        return words;
    }
    static bool chooseSweep(MainWindow& window, const QString& words) {
        QMenu* menu = openSweeps(window);
        if (menu == nullptr) return false;
        for (QAction* each : menu->actions()) {
            if (each->text() != words) continue;
            QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(each).center());
            return true;
        }
        menu->close();
        return false;
    }

private slots:
    void initTestCase() {
        const auto bell = test::simulatedBell(kLines, 381);
        QVERIFY(bell);
        scan_ = *bell;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(scan_, bell_)));
    }

    // The mean direction of the lines turns by 90 degrees while this sweep grows: a view has one name all the time.
    void aViewOfAGrowingSweepHasOneName() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        QVERIFY(on.show());
        const auto* cube = on.window.findChild<ViewCube*>("view-cube");
        std::set<std::string> names;
        CameraPose pose;
        connect(&on.viewer.cloud, &CloudView::frameDrawn, this, [&] {
            if (!cube->isVisible() || lines(on.window) < 10 || (!names.empty() && !(on.viewer.cloud.camera() == pose))) return;
            pose = on.viewer.cloud.camera();
            std::string now;
            for (const auto face : {ViewCube::Face::Front, ViewCube::Face::Back, ViewCube::Face::Left, ViewCube::Face::Right,
                                    ViewCube::Face::Top, ViewCube::Face::Bottom}) {
                const auto place = cube->middleOf(face);
                now += place ? std::to_string(qRound(place->x())) + "," + std::to_string(qRound(place->y())) + " " : std::string("- ");
            }
            names.insert(now);
        });
        on.viewer.live.connectTo("127.0.0.1", emulated->port(), sweep());
        QTRY_VERIFY(lines(on.window) == kLines && on.viewer.cloud.atRest());
        QCOMPARE(names.size(), std::size_t{1});
    }

    void onlyAPictureThatGrowsIsCalledLive() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        const StateBadge& badge = window.viewer().live.panel().strip().badge();
        QTRY_VERIFY(lines(window) > 5 && badge.text() == "LIVE");
        press(window, "live-hold");
        QTRY_COMPARE(badge.text(), QString("HELD"));
        QVERIFY(badge.sign() != StateBadge::Sign::Good);
        // The badge of the picture agrees, with the time of its newest line and the lines that came since.
        QTRY_VERIFY(QRegularExpression("^HELD, ([2-9]|[1-9][0-9]) lines behind · ").match(window.viewer().origin.text()).hasMatch());
        const QRegularExpression time("^HELD, [0-9]+ lines behind · [0-9]{4}-[0-9]{2}-[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2} UTC$");
        QVERIFY2(time.match(window.viewer().origin.text()).hasMatch(), qPrintable(window.viewer().origin.text()));
        QVERIFY(window.viewer().origin.sign() == StateBadge::Sign::Waiting);
        press(window, "live-follow");
        QTRY_COMPARE(badge.text(), QString("LIVE"));
        QVERIFY2(window.viewer().origin.text().startsWith("LIVE · "), qPrintable(window.viewer().origin.text()));
        QVERIFY(window.viewer().origin.sign() == StateBadge::Sign::Good);
        window.viewer().files.open({QString::fromStdString(bell_)});
        QTRY_VERIFY(on.picture().detection->scan->path == bell_);
        QTRY_VERIFY2(badge.text().contains("ANOTHER PICTURE") && badge.sign() != StateBadge::Sign::Good, qPrintable(badge.text()));
        QVERIFY2(window.viewer().origin.text().startsWith("FILE bell"), qPrintable(window.viewer().origin.text()));
        press(window, "live-follow");
        QTRY_COMPARE(badge.text(), QString("LIVE"));
        QVERIFY(on.picture().detection->scan->path != bell_);
    }

    void holdAndFollowHaveTheirOwnButtons() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        const LivePanel& panel = window.viewer().live.panel();
        const auto& hold = *panel.findChild<QPushButton*>("live-hold");
        const auto& follow = *panel.findChild<QPushButton*>("live-follow");
        QVERIFY(hold.isEnabled() && !follow.isEnabled());
        const QColor ground = follow.palette().color(QPalette::Button);
        QTRY_VERIFY(!window.viewer().live.scanner().following()); // held at the end of a sweep
        QVERIFY(!hold.isEnabled() && follow.isEnabled() && follow.palette().color(QPalette::Button) != ground);
        QTRY_VERIFY(window.viewer().views.gray().pictureFrame().colour.isValid());
        const auto& badge = *window.viewer().live.panel().findChild<QWidget*>("live-badge");
        QTRY_COMPARE(badge.toolTip(), QString("Sweep 1 is held on the screen. Follow shows sweep 2, which grows now."));
        QVERIFY(badge.isVisible());
        press(window, "live-follow");
        QVERIFY(hold.isEnabled() && !follow.isEnabled() && follow.palette().color(QPalette::Button) == ground);
        // A second tap does not do the opposite.
        press(window, "live-hold");
        press(window, "live-hold");
        QVERIFY(!window.viewer().live.scanner().following());
        press(window, "live-follow");
        press(window, "live-follow");
        QVERIFY(window.viewer().live.scanner().following());
    }

    // The first lines of the next sweep are at its side, outside of the view of the whole sweep that was held.
    void theFirstLinesAfterFollowAreInTheView() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        WindowFixture on;
        QVERIFY(showsFirstLines(on, *emulated));
        const ScannerLink& scanner = on.viewer.live.scanner();
        QTRY_VERIFY_WITH_TIMEOUT(!scanner.following() && lines(on.window) == kLines, 30000);
        press(on.window, "live-follow");
        QTRY_VERIFY(scanner.following() && lines(on.window) < kLines);
        int looks = 0;
        while (lines(on.window) < kLines && looks < 10000) {
            if (!eventually([&] { return on.viewer.engine.picture()->detection->scan == on.viewer.views.cloud().scan(); })) break;
            const double seen = on.viewer.views.cloud().shareInPicture();
            QVERIFY2(seen >= 0.1, qPrintable(QString("%1 lines: %2").arg(lines(on.window)).arg(seen)));
            ++looks;
            QTest::qWait(20);
        }
        QVERIFY(looks > 3);
    }

    // A double tap on Stop does not connect again, which would drop the sweep on the screen.
    void aDoubleTapOnStopIsOneTap() {
        const auto emulated = scanner(100);
        QVERIFY(emulated);
        WindowFixture on;
        QVERIFY(showsFirstLines(on, *emulated));
        auto* stop = on.viewer.live.panel().findChild<QPushButton*>("live-connect");
        QCOMPARE(stop->text(), QString("Stop"));
        QSignalSpy again(&on.viewer.live.panel(), &LivePanel::connectRequested);
        QTest::mouseClick(stop, Qt::LeftButton);
        QTest::mouseDClick(stop, Qt::LeftButton);
        QCOMPARE(stop->text(), QString("Connect"));
        QVERIFY(again.isEmpty());
        QTest::mouseClick(stop, Qt::LeftButton);
        QCOMPARE(again.size(), 1);
    }

    // In a cab the second tap may come a moment later.
    void withGlovesTheNextTapAfterStopConnectsToNothing() {
        const auto emulated = scanner(100);
        QVERIFY(emulated);
        WindowFixture on;
        QVERIFY(showsFirstLines(on, *emulated));
        on.window.cab().set(true);
        QTRY_VERIFY(on.window.cab().on());
        auto* stop = on.viewer.live.panel().findChild<QPushButton*>("live-connect");
        QSignalSpy again(&on.viewer.live.panel(), &LivePanel::connectRequested);
        stop->click();
        stop->click();
        QTRY_VERIFY(!on.viewer.live.scanner().connected());
        QVERIFY(again.isEmpty());
        QTRY_VERIFY((stop->click(), again.size() == 1)); // a tap that comes later is meant
        on.window.cab().set(false);
    }

    void theNoticeOfASweepGoesWithIt() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        QVERIFY(on.show());
        on.viewer.live.connectTo("127.0.0.1", emulated->port(), sweep());
        const NoticeBar& notice = on.viewer.notice;
        QTRY_VERIFY2(notice.isVisible() && notice.text().contains("Held. "), qPrintable(notice.text()));
        press(on.window, "live-follow");
        QVERIFY2(!notice.isVisible() || !notice.text().contains("Held. "), qPrintable(notice.text()));
    }

    // The scanner is in the middle of a sweep when the connection is made: that part is named, is not held, and the next sweep, which is
    // complete, replaces it without a click.
    void aPartOfASweepIsNamedAndReplaced() {
        const auto emulated = scanner(100);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(connectsInTheMiddle(on, *emulated));
        const ScannerLink& scanner = window.viewer().live.scanner();
        QTRY_VERIFY(scanner.part());
        const int part = scanner.part()->lines;
        QVERIFY2(part > 0 && part < 60, qPrintable(QString::number(part)));
        QVERIFY(scanner.following());
        const QString words = QString("is a part: %1 of 120 lines.").arg(part);
        QTRY_VERIFY2(window.viewer().notice.text().contains(words), qPrintable(window.viewer().notice.text()));
        const auto& sentence = *window.viewer().live.panel().findChild<QLabel*>("live-sentence");
        QTRY_VERIFY2(sentence.isVisible() && sentence.toolTip() == "Sweep 1 " + words, qPrintable(sentence.toolTip()));
        QTRY_VERIFY(!scanner.following()); // held at the end of the next sweep
        QTRY_COMPARE(lines(window), kLines);
        QTRY_COMPARE(window.viewer().engine.picture()->source.growth.sweep, 1);
        QVERIFY(!scanner.part());
        // The view of the cloud was fitted to the part: it is fitted to the sweep now.
        CloudView& cloud = window.viewer().views.cloud();
        const double seen = cloud.shareInPicture();
        QVERIFY2(seen > 0.1, qPrintable(QString::number(seen)));
        cloud.viewFromScanner();
        QVERIFY2(1.2 * seen >= cloud.shareInPicture(), qPrintable(QString("%1 of %2").arg(seen).arg(cloud.shareInPicture())));
        const auto& badge = *window.viewer().live.panel().findChild<QWidget*>("live-badge");
        QTRY_VERIFY2(badge.toolTip().startsWith("Sweep 2 is held on the screen."), qPrintable(badge.toolTip()));
        QVERIFY2(!sentence.isVisible(), "a row that comes with Hold would move the pictures");
    }

    // After Stop a next sweep does not come, which would replace the part.
    void theNoteOfAPartEndsWithStop() {
        const auto emulated = scanner(100);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(connectsInTheMiddle(on, *emulated));
        const NoticeBar& notice = window.viewer().notice;
        QTRY_VERIFY2(notice.isVisible() && notice.text().contains("The next sweep replaces it."), qPrintable(notice.text()));
        press(window, "live-connect");
        QTRY_VERIFY2(!notice.isVisible() || !notice.text().contains("replaces"), qPrintable(notice.text()));
        QVERIFY2(notice.earlier() == 0 || !notice.isVisible(), "nor is it an earlier note");
    }

    // Stop in the middle of a sweep, while the one before it is held: strip, badge and count name the sweep on the screen, and the button
    // shows the other.
    void afterStopOneSweepIsNamedAndTheOtherIsOffered() {
        const auto emulated = scanner(100, 0, kLines + 30);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        const ScannerLink& scanner = window.viewer().live.scanner();
        QTRY_VERIFY_WITH_TIMEOUT(!scanner.following() && scanner.health().sweep == 2 && scanner.health().row > 10, 30000);
        press(window, "live-connect"); // Stop
        const auto& button = *window.viewer().live.panel().findChild<QPushButton*>("live-other");
        const auto& count = *window.viewer().live.panel().findChild<QLabel*>("live-lines");
        QTRY_VERIFY2(button.text().startsWith("Show sweep 2: "), qPrintable(button.text()));
        const QString second = button.text();
        QVERIFY2(second.endsWith("/120 lines, partial"), qPrintable(second));
        QVERIFY(button.isVisible() && button.isEnabled());
        QCOMPARE(count.text(), QString("sweep 1: 120/120 lines"));
        QCOMPARE(scanner.health().sweep, 1);
        QCOMPARE(button.toolTip(), QString("On the screen: sweep 1: 120/120 lines, complete"));
        press(window, "live-other");
        QTRY_COMPARE(button.text(), QString("Show sweep 1: 120/120 lines, complete"));
        QCOMPARE(second, QString("Show sweep 2: %1/120 lines, partial").arg(lines(window)));
        QCOMPARE(window.viewer().engine.picture()->source.growth.sweep, 1);
        QVERIFY(lines(window) < kLines);
        QCOMPARE(scanner.health().sweep, 2);
        QCOMPARE(count.text(), QString("sweep 2: INCOMPLETE %1/120 lines").arg(lines(window)));
        QVERIFY(button.toolTip().startsWith("On the screen: sweep 2: "));
        press(window, "live-other");
        QTRY_COMPARE(button.text(), second);
        QTRY_COMPARE(lines(window), kLines);
        // With gloves on, the fields of the address leave their room to the picture until Connect asks for them.
        const auto& host = *window.viewer().live.panel().findChild<QLineEdit*>("live-host");
        window.viewer().live.panel().setBrief(true);
        QVERIFY(button.isVisible() && !host.isVisible());
        window.viewer().live.panel().askAddress();
        QVERIFY(button.isVisible() && host.isVisible());
        window.viewer().live.panel().setBrief(false);
        // Another picture has nothing to do with them.
        QVERIFY(on.open(bell_));
        QTRY_VERIFY(!button.isVisible());
    }

    // The rest of a sweep that was held in its middle: the scanner measured it, so Stop does not lose it for the first lines of the next.
    void aSweepHeldInTheMiddleIsOfferedWholeAfterStop() {
        const auto emulated = scanner(60, 0, kLines + 30);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(showsFirstLines(on, *emulated));
        press(window, "live-hold");
        const ScannerLink& scanner = window.viewer().live.scanner();
        QTRY_VERIFY_WITH_TIMEOUT(scanner.health().sweep == 2 && scanner.health().row > 3, 30000);
        const int held = lines(window);
        QVERIFY(held < kLines);
        press(window, "live-connect"); // Stop
        const auto& button = *window.viewer().live.panel().findChild<QPushButton*>("live-other");
        QTRY_COMPARE(button.text(), QString("Show another sweep…"));
        QTRY_COMPARE(window.viewer().notice.text(), QString("Sweep 1 was held with %1 lines when the connection ended.").arg(held));
        QVERIFY2(chooseSweep(window, "Show sweep 1: 120/120 lines, complete"), qPrintable(offered(window).join(", ")));
        QTRY_COMPARE(lines(window), kLines);
    }

    // Of a scanner that was restarted in the middle of a sweep: the picture has room for all lines, and not all came.
    void aHeldSweepThatIsNotWholeIsNotCalledWhole() {
        auto emulated = scanner(60);
        QVERIFY(emulated);
        const std::uint16_t port = emulated->port();
        WindowFixture on;
        QVERIFY(showsFirstLines(on, *emulated));
        emulated.reset();
        const ScannerLink& link = on.viewer.live.scanner();
        QTRY_COMPARE(link.health().liveness, files::Liveness::Lost);
        emulated = scanner(60, port);
        QVERIFY(emulated);
        QTRY_VERIFY_WITH_TIMEOUT(link.health().sweep >= 2 || !link.following(), 30000);
        if (link.following()) press(on.window, "live-hold");
        QTRY_VERIFY(on.viewer.origin.text().contains("HELD"));
        QVERIFY2(!on.viewer.origin.text().contains("whole sweep"), qPrintable(on.viewer.origin.text()));
    }

    // A picture is held for more than a sweep, and Stop comes in the middle of the third: each sweep that is held is offered by its name,
    // and strip, count and picture are of the one that was chosen.
    void afterStopEverySweepThatIsHeldIsOffered() {
        const auto emulated = scanner(200, 0, 2 * kLines + 30);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        const ScannerLink& scanner = window.viewer().live.scanner();
        QTRY_VERIFY_WITH_TIMEOUT(!scanner.following() && scanner.health().sweep == 3 && scanner.health().row > 10, 30000);
        press(window, "live-connect"); // Stop
        const auto& button = *window.viewer().live.panel().findChild<QPushButton*>("live-other");
        const auto& count = *window.viewer().live.panel().findChild<QLabel*>("live-lines");
        QTRY_COMPARE(button.text(), QString("Show another sweep…"));
        QStringList sweeps = offered(window);
        QCOMPARE(sweeps.size(), 2);
        const QString whole = "Show sweep 2: 120/120 lines, complete", part = sweeps[1];
        QCOMPARE(sweeps[0], whole);
        QVERIFY2(part.startsWith("Show sweep 3: ") && part.endsWith("/120 lines, partial"), qPrintable(part));
        for (const bool cab : {false, true}) {
            window.cab().set(cab);
            QTRY_VERIFY(window.cab().on() == cab && button.isVisible());
            QVERIFY(chooseSweep(window, whole));
            QTRY_COMPARE(count.text(), QString("sweep 2: 120/120 lines"));
            QCOMPARE(window.viewer().engine.picture()->source.growth.sweep, 1);
            QCOMPARE(lines(window), kLines);
            QCOMPARE(offered(window), QStringList({"Show sweep 1: 120/120 lines, complete", part}));
            QVERIFY(chooseSweep(window, part));
            QTRY_COMPARE(window.viewer().engine.picture()->source.growth.sweep, 2);
            QTRY_COMPARE(count.text(), QString("sweep 3: INCOMPLETE %1/120 lines").arg(lines(window)));
            QCOMPARE(offered(window), QStringList({"Show sweep 1: 120/120 lines, complete", whole}));
        }
        window.cab().set(false);
    }

    // The finished sweep that a growing one replaced is offered too.
    void afterStopOfAGrowingSweepTheOneBeforeItIsOffered() {
        const auto emulated = scanner(40);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        const ScannerLink& scanner = window.viewer().live.scanner();
        QTRY_VERIFY(!scanner.following());
        press(window, "live-follow");
        QTRY_VERIFY(window.viewer().engine.picture()->source.growth.sweep > 0 && lines(window) < kLines / 2);
        press(window, "live-connect"); // Stop
        const int growing = window.viewer().engine.picture()->source.growth.sweep + 1;
        const auto& button = *window.viewer().live.panel().findChild<QPushButton*>("live-other");
        const auto& count = *window.viewer().live.panel().findChild<QLabel*>("live-lines");
        QTRY_COMPARE(button.text(), QString("Show sweep %1: 120/120 lines, complete").arg(growing - 1));
        QTRY_COMPARE(count.text(), QString("sweep %1: INCOMPLETE %2/120 lines").arg(growing).arg(lines(window)));
        const Picture& part = *window.viewer().engine.picture(); // it does not look whole: its images have room for all lines, hatched
        QCOMPARE(part.gray->height(), kLines);
        QCOMPARE(linesToCome(part).height(), kLines - lines(window));
        press(window, "live-other");
        QTRY_COMPARE(count.text(), QString("sweep %1: 120/120 lines").arg(growing - 1));
        QCOMPARE(lines(window), kLines);
        QTRY_VERIFY2(button.text().startsWith(QString("Show sweep %1: ").arg(growing)), qPrintable(button.text()));
    }

    // A sweep ends and holds itself in the moment in which the operator presses Hold: the press must not follow the next sweep.
    void aPressOfHoldThatComesTooLateDoesNotFollow() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        auto& button = *window.viewer().live.panel().findChild<QPushButton*>("live-hold");
        const ScannerLink& scanner = window.viewer().live.scanner();
        bool late = false;
        connect(&scanner, &ScannerLink::followingChanged, &window, [&](bool follows) {
            if (follows || std::exchange(late, true)) return;
            QTest::mouseClick(&button, Qt::LeftButton);
        });
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        QTRY_VERIFY_WITH_TIMEOUT(late, 30000);
        QVERIFY(!scanner.following());
        press(window, "live-follow");
        QVERIFY(scanner.following());
    }

    // No line is added to a picture that is held in the middle of its sweep, so its edges are counted, and again after Follow.
    void theEdgesOfAHeldPictureAreCounted() {
        const auto emulated = scanner(20);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(showsFirstLines(on, *emulated));
        const auto counted = [&window] {
            for (const CountCurve* each : window.findChildren<CountCurve*>()) {
                if (each->isVisible() && each->curve()) return true;
            }
            return false;
        };
        for (int n = 0; n < 2; ++n) {
            QVERIFY(window.viewer().live.scanner().following() && !counted());
            press(window, "live-hold");
            QVERIFY(lines(window) < kLines);
            QTRY_VERIFY2(counted(), qPrintable(QString::number(n)));
            QVERIFY(on.picture().source.growth.growing);
            press(window, "live-follow");
        }
    }

    // A finger that taps again where a button was must not press its neighbour.
    void noButtonOfTheScannerMovesWhenAnotherChangesItsWords() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().live.setRecordingFolder(QString::fromStdString((folder_ / "still").string()));
        window.resize(1280, 800);
        QVERIFY(showsFirstLines(on, *emulated));
        QVERIFY(on.activate());
        const auto places = [&window] {
            QString all;
            for (const char* name : {"live-connect", "live-record", "live-hold", "live-follow"}) {
                const QPoint at = window.viewer().live.panel().findChild<QPushButton*>(name)->mapTo(&window, QPoint(0, 0));
                all += QString("%1 at %2, %3; ").arg(name).arg(at.x()).arg(at.y());
            }
            return all;
        };
        const auto* record = window.viewer().live.panel().findChild<QPushButton*>("live-record");
        for (const bool cab : {false, true}) {
            window.cab().set(cab);
            QTRY_COMPARE(window.cab().on(), cab);
            QTest::qWait(0);
            const auto before = places();
            const int high = window.viewer().live.panel().height();
            press(window, "live-record");
            QTRY_COMPARE(record->text(), QString("Stop recording"));
            QTest::qWait(0);
            QCOMPARE(places(), before);
            QTRY_VERIFY(window.viewer().live.panel().strip().shown().recording.size() > 0);
            QTest::qWait(0);
            QCOMPARE(window.viewer().live.panel().height(), high); // the views below it do not move either
            if (cab) {                                             // besides the word of the button
                const auto* badge = window.viewer().live.panel().findChild<StateBadge*>("live-recording");
                QTRY_VERIFY2(badge->isVisible() && badge->text().startsWith("recording "), qPrintable(badge->text()));
            }
            press(window, "live-hold");
            QTest::qWait(0);
            QCOMPARE(places(), before);
            press(window, "live-follow");
            press(window, "live-record");
            QTRY_COMPARE(record->text(), QString("Record"));
            QTest::qWait(0);
            QCOMPARE(places(), before);
        }
        window.cab().set(false);
    }

    // The first whole sweep is held; after Follow, sweep after sweep is shown until Hold. A note is about one sweep.
    void followGoesOnThroughTheEndsOfSweeps() {
        const auto emulated = scanner(300);
        QVERIFY(emulated);
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.show());
        ScannerLink& link = on.viewer.live.scanner();
        on.viewer.live.connectTo("127.0.0.1", emulated->port(), sweep());
        QTRY_VERIFY(link.connected() && !link.following() && on.viewer.notice.isVisible());
        const auto* line = static_cast<const ElidedLabel*>(on.viewer.notice.findChild<QLabel*>("notice-line"));
        QTRY_VERIFY2(line->shown().startsWith("Held. Follow shows the next ones, until Hold."), qPrintable(line->shown()));
        const std::size_t earlier = on.viewer.notice.earlier();
        press(on.window, "live-follow");
        std::set<int> sweeps;
        QVERIFY(eventually([&] {
            sweeps.insert(on.picture().source.growth.sweep);
            return sweeps.size() >= 4;
        }));
        QVERIFY(link.following() && on.viewer.notice.earlier() <= earlier + 1);
        press(on.window, "live-hold");
        QTRY_VERIFY(!on.viewer.engine.behind()); // a picture was under way
        const auto held = on.picture().source.growth.sweep;
        QTest::qWait(1000); // more than two sweeps
        QCOMPARE(on.picture().source.growth.sweep, held);
        link.disconnectScanner();
    }

    void aPinOnAHeldPictureComesBackByUndo() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        Viewer& v = window.viewer();
        QVERIFY(on.show());
        v.rocks.setShown(true);
        v.live.connectTo("127.0.0.1", emulated->port(), sweep());
        QTRY_VERIFY(!v.live.scanner().following() && !v.engine.behind() && !v.rocks.behind()); // held at the end of a sweep
        const auto held = on.picture().detection->scan;
        ImageView& view = v.views.gray();
        QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, view.viewPort()->toPixel(QPointF(190.5, 60.5), view.size()).toPoint());
        QCOMPARE(v.targets.notebook().targets.size(), std::size_t(1));
        const auto pinned = v.targets.notebook();
        press(window, "live-follow");
        QTRY_VERIFY(on.picture().detection->scan->name != held->name);
        QVERIFY(v.targets.notebook().targets.empty() && !v.views.pinned());
        QVERIFY2(!v.views.cloud().outline(), "no outline of the sweep before");
        QVERIFY2(v.notice.text().contains("Undo"), qPrintable(v.notice.text()));
        QVERIFY(on.activate());
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(on.picture().detection->scan == held);
        QVERIFY(!v.live.scanner().following());
        QCOMPARE(v.targets.notebook().targets.size(), std::size_t(1));
        QCOMPARE(v.targets.notebook().targets.front().cell, pinned.targets.front().cell);
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier); // the pin itself
        QVERIFY(v.targets.notebook().targets.empty());
    }

    void aScannerIsNotComparedUnaskedWithAnotherPlace() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        Viewer& v = on.viewer;
        QVERIFY(on.showWith(bell_) && on.activate());
        QTest::keyClick(&on.window, Qt::Key_A, Qt::ShiftModifier);
        const auto a = v.comparing.pictureA();
        QVERIFY(a);
        v.live.connectTo("127.0.0.1", emulated->port(), sweep());
        QVERIFY(!v.comparing.pictureA());
        QVERIFY2(v.notice.text().contains("no longer compared"), qPrintable(v.notice.text()));
        QTRY_VERIFY(!v.live.scanner().following() && !v.engine.behind());
        QVERIFY(!v.comparing.comparison());
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(v.comparing.pictureA() == a);
        // A sweep of this scanner is compared after connecting again, too.
        QTest::keyClick(&on.window, Qt::Key_A, Qt::ShiftModifier);
        const auto own = v.comparing.pictureA();
        QVERIFY(own && own != a);
        press(on.window, "live-connect"); // Stop
        v.live.connectTo("127.0.0.1", emulated->port(), sweep());
        QVERIFY(v.comparing.pictureA() == own);
    }

    void anUnknownMountingIsAskedForAndMarked() {
        const auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        Viewer& v = on.viewer;
        QVERIFY(on.show());
        scanner::SweepSettings assumed = scanner::assumedSweep();
        assumed.expectedLines = kLines;
        v.live.connectTo("127.0.0.1", emulated->port(), assumed);
        QVERIFY2(v.notice.text().startsWith("How the stepper turns"), qPrintable(v.notice.text()));
        // The cloud says it as long as it is so; images have no shape.
        QTRY_VERIFY(lines(on.window) > 2);
        const auto* overlay = v.cloud.findChild<CloudOverlay*>();
        QTRY_VERIFY2(overlay->marks().note.contains("Scan > Sweep…"), qPrintable(overlay->marks().note));
        QVERIFY(!v.gray.note().contains("Sweep…"));
        // As soon as the ranges show the axis, the cloud has its shape and a view that shows it.
        const auto axis = [&] { return std::get<PolarGeometry>(on.picture().detection->scan->geometry).axis; };
        QVERIFY(axis() == Axis::Spin);
        QTRY_VERIFY(axis() == Axis::Sweep);
        QVERIFY2(v.cloud.shareInPicture() > 0.2, qPrintable(QString::number(v.cloud.shareInPicture())));
        // A double click, and a click while the fields are open, leave them open.
        auto* fields = v.live.panel().findChild<QDialog*>("sweep-dialog");
        auto* give = v.notice.findChild<QToolButton*>("notice-action");
        QVERIFY(fields != nullptr && give != nullptr);
        QTest::mouseClick(give, Qt::LeftButton);
        QTRY_VERIFY(fields->isVisible());
        QTest::mouseDClick(on.window.windowHandle(), Qt::LeftButton, Qt::NoModifier, give->mapTo(&on.window, give->rect().center()));
        QTRY_VERIFY(fields->isVisible());
        fields->close();
        QTRY_VERIFY(!v.live.scanner().following() && !v.engine.behind());
        v.targets.keepMeasure({inspect::MeasureKind::Distance, {60 * 381 + 150, 60 * 381 + 230}, {}});
        auto* list = v.targetsPanel.findChild<QListWidget*>("measure-list");
        QVERIFY(list != nullptr);
        QTRY_VERIFY(list->count() == 1 && list->item(0)->toolTip().contains("step assumed")); // the ranges showed the axis
        v.live.panel().setSweep(sweep());
        v.live.panel().askSweep(); // typed values are taken when it closes
        fields->close();
        QVERIFY2(!v.notice.isVisible() || !v.notice.text().startsWith("How the stepper turns"), qPrintable(v.notice.text()));
        QTRY_VERIFY2(!overlay->marks().note.contains("Sweep…"), qPrintable(overlay->marks().note));
        // With the mounting, only the step is asked for.
        scanner::SweepSettings half = sweep();
        half.stepAssumed = true;
        v.live.connectTo("127.0.0.1", emulated->port(), half);
        QVERIFY2(v.notice.text().startsWith("How the stepper turns"), qPrintable(v.notice.text()));
    }

    void nothingOfALostScannerIsGreen() {
        auto emulated = scanner(200);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().live.setRecordingFolder(QString::fromStdString((folder_ / "green").string()));
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        press(window, "live-record");
        HealthStrip& strip = window.viewer().live.panel().strip();
        const auto green = [&] {
            int count = 0;
            for (const QWidget* each : window.viewer().live.panel().findChildren<QWidget*>()) {
                const auto* badge = dynamic_cast<const StateBadge*>(each);
                count += badge != nullptr && badge->isVisible() && badge->sign() == StateBadge::Sign::Good ? 1 : 0;
            }
            return count;
        };
        QTRY_VERIFY(green() >= 2);
        const auto* stop = window.viewer().live.panel().findChild<QPushButton*>("live-connect");
        const QPoint place = stop->mapToGlobal(QPoint(0, 0));
        emulated.reset();
        QTRY_VERIFY(strip.shown().liveness == files::Liveness::Lost);
        QTest::qWait(0); // the strip gets its rows
        QCOMPARE(stop->mapToGlobal(QPoint(0, 0)), place);
        QCOMPARE(green(), 0);
        QVERIFY2(strip.shown().contamination.ends_with(" ago"), strip.shown().contamination.c_str());
        press(window, "live-connect"); // Stop
        QCOMPARE(green(), 0);
    }

    void theTitleIsThatOfTheSweepOnTheScreen() {
        const auto emulated = scanner(300);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        for (int n = 0; n < 3; ++n) {
            QTRY_VERIFY(!window.viewer().live.scanner().following()); // held at the end of a sweep
            QTRY_VERIFY(!window.viewer().engine.behind());
            const QString name = QString::fromStdString(on.picture().detection->scan->name);
            QVERIFY2(window.windowTitle().startsWith(name + " "), qPrintable(window.windowTitle() + " for " + name));
            press(window, "live-follow");
            window.viewer().live.scanner().setHoldAtEnd(true); // also the next one
        }
        QVERIFY(!window.windowTitle().startsWith("sweep 1 "));
    }

    void spaceAfterStopConnectsToNothing() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(showsFirstLines(on, *emulated));
        QVERIFY(on.activate());
        press(window, "live-connect"); // Stop
        QVERIFY(!window.viewer().live.scanner().connected());
        QTRY_VERIFY(!window.viewer().engine.behind());
        for (const bool byKey : {false, true}) {
            QWidget* at = window.focusWidget() != nullptr ? window.focusWidget() : &window;
            QTest::keyClick(at, Qt::Key_Space);
            QTest::keyClick(at, Qt::Key_Return);
            QVERIFY2(!window.viewer().live.scanner().connected(), byKey ? "after a key" : "after a click");
            if (byKey) break;
            // With the keyboard: the pressed button has another meaning by now.
            auto* button = window.viewer().live.panel().findChild<QPushButton*>("live-connect");
            button->setFocus(Qt::TabFocusReason);
            QTest::keyClick(button, Qt::Key_Space); // Connect
            QVERIFY(window.viewer().live.scanner().connected());
            QVERIFY(!button->hasFocus());
            button->setFocus(Qt::TabFocusReason);
            QTest::keyClick(button, Qt::Key_Space); // Stop
            QVERIFY(!window.viewer().live.scanner().connected());
        }
    }

    // The view is that of the whole sweep, of which half a turn does not fit, as soon as a tenth of what came is in it. From then on it
    // moves when the operator asks, and for the next sweep.
    void theViewStaysWhileASweepGrows() {
        const auto emulated = scanner(100);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(showsFirstLines(on, *emulated));
        const CloudView& cloud = on.viewer.views.cloud();
        std::vector<CameraPose> poses;
        connect(&cloud, &CloudView::frameDrawn, &cloud, [&] {
            if (poses.empty() || !(poses.back() == cloud.camera())) poses.push_back(cloud.camera());
        });
        QTRY_VERIFY_WITH_TIMEOUT(!on.viewer.live.scanner().following() && !on.viewer.engine.behind(), 30000);
        QVERIFY2(poses.size() <= 10, qPrintable(QString::number(poses.size())));
        const CameraPose pose = cloud.camera();
        std::size_t drawn = 0, seen = 0;
        for (std::uint32_t k = 0; k < cloud.scan()->cells(); ++k) {
            drawn += cloud.geometryOfCloud()->drawable(k) ? 1 : 0;
            const auto at = cloud.pixelOf(k);
            seen += at && QRectF(cloud.rect()).contains(*at) ? 1 : 0;
        }
        QVERIFY2(10 * seen > drawn, qPrintable(QString("%1 of %2 points are in view").arg(seen).arg(drawn)));
        // The first lines of the next sweep are at its side: the view goes there, for the operator asked to follow, and comes back.
        press(window, "live-follow");
        window.viewer().live.scanner().setHoldAtEnd(true); // also this one
        QTRY_VERIFY(lines(window) > 20 && on.picture().source.growth.growing);
        QVERIFY2(cloud.shareInPicture() >= 0.1, qPrintable(QString::number(cloud.shareInPicture())));
        QTRY_VERIFY_WITH_TIMEOUT(!on.viewer.live.scanner().following() && !on.viewer.engine.behind(), 30000);
        QVERIFY((cloud.camera().forward() - pose.forward()).norm() < 0.05);
    }

    // As --live on the command line.
    void aPortInTheAddressIsThePort() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        LivePanel& panel = on.viewer.live.panel();
        panel.askAddress();
        auto* host = panel.findChild<QLineEdit*>("live-host");
        auto* port = panel.findChild<QSpinBox*>("live-port");
        host->setText("[::1]:2113");
        port->setFocus();
        QCOMPARE(host->text(), QString("::1"));
        QCOMPARE(port->value(), 2113);
        for (const char* wrong : {"127.0.0.1:", "127.0.0.1:99999", ":2112", "http://127.0.0.1"}) {
            host->setText(wrong);
            press(on.window, "live-connect");
            QVERIFY2(!on.viewer.live.scanner().connected(), wrong);
            QVERIFY2(on.viewer.notice.text().contains("cannot be connected to"), qPrintable(on.viewer.notice.text()));
        }
        host->setText(QString("127.0.0.1:%1").arg(emulated->port()));
        press(on.window, "live-connect");
        QCOMPARE(panel.host(), QString("127.0.0.1"));
        QCOMPARE(panel.port(), static_cast<int>(emulated->port()));
        QVERIFY(eventually([&on] { return lines(on.window) > 5; }));
    }

    void closingWhileRecordingAsks() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        const QString folder = QString::fromStdString((folder_ / "recordings").string());
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().live.setRecordingFolder(folder);
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        press(window, "live-record");
        QTRY_VERIFY(lines(window) > 10);
        int asked = 0;
        const auto close = [&](const QString& button) {
            const Meanwhile hand([&asked, button] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                if (box == nullptr || box->objectName() != "close-question" || !box->isVisible()) return false;
                ++asked;
                for (QAbstractButton* each : box->buttons()) {
                    if (each->objectName() == button) return QTest::mouseClick(each, Qt::LeftButton), true;
                }
                return QTest::keyClick(box, Qt::Key_Escape), true;
            });
            return window.close();
        };
        QVERIFY(!close("no"));
        QCOMPARE(asked, 1);
        QVERIFY(window.isVisible() && window.viewer().live.scanner().recording());
        QVERIFY(close("end-and-close"));
        QCOMPARE(asked, 2);
        QVERIFY(!window.viewer().live.scanner().recording());
        const QStringList files = QDir(folder).entryList({"sweep_*.mcap"});
        QCOMPARE(files.size(), 1);
        QTRY_VERIFY(bool(files::openScan(QDir(folder).filePath(files.front()).toStdString())));
    }

    void afterStopNothingGrowsAndTheSweepIsIncomplete() {
        for (const bool held : {false, true}) {
            const auto emulated = scanner(60);
            QVERIFY(emulated);
            WindowFixture on;
            MainWindow& window = on.window;
            QVERIFY(on.show());
            window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
            QTRY_VERIFY(lines(window) > 10);
            Pane& cloud = *qobject_cast<Pane*>(window.viewer().views.cloud().parentWidget());
            QTRY_VERIFY2(cloud.note().contains("growing"), qPrintable(cloud.note()));
            if (held) {
                press(window, "live-hold");
                QTRY_VERIFY2(!cloud.note().contains("growing"), "a held picture does not grow");
            }
            press(window, "live-connect"); // Stop
            QTRY_VERIFY(!on.picture().source.growth.growing && !window.viewer().engine.behind());
            QVERIFY(!cloud.note().contains("growing"));
            QVERIFY(!window.viewer().warnings.warnings().filter("INCOMPLETE").isEmpty());
            const std::string shown = window.viewer().live.panel().strip().shown().lines;
            QVERIFY2(shown.starts_with("INCOMPLETE"), shown.c_str());
        }
    }

    // Stop while the first sweep is held and the second grows: the strip counts the sweep on the screen, by its number. Nothing "is
    // sending".
    void afterStopTheStripNamesTheSweepThatItCounts() {
        const auto emulated = scanner(400);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        LivePanel& panel = window.viewer().live.panel();
        QTRY_VERIFY(!window.viewer().live.scanner().following() && panel.strip().shown().sweep > 1);
        press(window, "live-connect"); // Stop
        const files::LiveHealth& last = panel.strip().shown();
        QVERIFY(last.liveness == files::Liveness::Stopped);
        QTRY_COMPARE(panel.findChild<QLabel*>("live-lines")->text(), QString("sweep 1: 120/120 lines"));
        QCOMPARE(last.sentence, std::string());
    }

    void tabAndReturnWorkInTheFieldsOfTheSweep() {
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        LivePanel& panel = on.viewer.live.panel();
        panel.askAddress();
        panel.askSweep();
        auto* menu = panel.findChild<QDialog*>("sweep-dialog");
        QTRY_VERIFY(menu->isVisible() && QApplication::focusWidget() != nullptr && menu->isAncestorOf(QApplication::focusWidget()));
        const auto fields = menu->findChildren<QAbstractSpinBox*>();
        QVERIFY(fields.size() == 5 && fields[0]->hasFocus());
        const auto type = [&](QAbstractSpinBox& field, const QString& text) {
            field.setFocus();
            field.selectAll();
            QTest::keyClicks(&field, text);
            fields[0]->setFocus();
            fields[0]->selectAll();
        };
        // A click into "not known" selects the words; one into a number does not.
        for (const auto& [n, number] : {std::pair{0, "600"}, {2, "0.25"}, {3, "-90"}, {4, "100"}}) {
            auto* line = fields[n]->findChild<QLineEdit*>();
            QVERIFY2(line->text().startsWith("not known"), qPrintable(line->text()));
            QTest::mouseClick(line, Qt::LeftButton);
            QTRY_VERIFY(line->selectedText() == line->text());
            QTest::keyClicks(line, number);
            QVERIFY2(line->text().startsWith(number), qPrintable(line->text()));
            QTest::mouseClick(line, Qt::LeftButton);
            QCoreApplication::processEvents();
            QVERIFY(!line->hasSelectedText());
            panel.setSweep(scanner::assumedSweep());
        }
        panel.setSweep(scanner::assumedSweep());
        fields[0]->setFocus();
        // The turn of all lines and the step are one value.
        QVERIFY(!fields[1]->isEnabled());
        type(*fields[0], "600");
        QVERIFY(fields[1]->isEnabled() && panel.sweep().stepAssumed);
        QCOMPARE(panel.sweep().degPerLine.value_or(0.0), 0.3); // half a turn
        type(*fields[1], "120");
        QVERIFY(!panel.sweep().stepAssumed);
        QCOMPARE(panel.sweep().degPerLine.value_or(0.0), 0.2);
        type(*fields[2], "0.25");
        QCOMPARE(static_cast<QDoubleSpinBox*>(fields[1])->value(), 150.0);
        QCOMPARE(fields[4]->text(), QString("not known")); // counts of an encoder
        type(*fields[4], "12.5");
        QCOMPARE(panel.sweep().ticksPerDeg.value_or(0.0), 12.5);
        type(*fields[4], "0");
        QVERIFY(fields[4]->text() == "not known" && !panel.sweep().ticksPerDeg);
        QTest::keyClicks(fields[0], "240");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY2(fields[1]->hasFocus() && menu->isVisible(), "Tab goes to the next field");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
        QVERIFY(fields[0]->hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY2(!menu->isVisible(), "Return accepts");
        QCOMPARE(panel.sweep().expectedLines, 240);
    }

    // The dialog is about the whole recording, so the whole recording is shown first.
    void thePoseOfAPlayingRecordingIsAsked() {
        const std::string path = (folder_ / "played.mcap").string();
        {
            const auto emulated = scanner(400);
            QVERIFY(emulated);
            const auto run = test::runCli("record 127.0.0.1:" + std::to_string(emulated->port()) + " -o " + path +
                                          " --lines 120 --expected-lines 120 --axis sweep --line-start -90 --line-step 1.5 --seconds 120");
            QCOMPARE(run.code, 0);
        }
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        on.viewer.files.open({QString::fromStdString(path)});
        Timeline& timeline = on.viewer.live.timeline();
        QTRY_VERIFY(timeline.active() && !on.viewer.engine.behind());
        timeline.goTo(40);
        QTRY_VERIFY(lines(on.window) == 40);
        timeline.play(true);
        on.viewer.notice.hide();
        QTest::keyClick(&on.window, Qt::Key_P, Qt::ControlModifier);
        const auto dialog = [&]() -> QDialog* { return on.window.findChild<PlaceDialog*>(); };
        QTRY_VERIFY2(dialog() != nullptr && dialog()->isVisible(), qPrintable(on.viewer.notice.text()));
        QVERIFY(!timeline.playing());
        QCOMPARE(lines(on.window), kLines);
        dialog()->reject();
    }

    void theStripOfAStoppedScannerGoesWithItsPicture() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(showsFirstLines(on, *emulated));
        LivePanel& panel = window.viewer().live.panel();
        press(window, "live-connect"); // Stop
        QTRY_VERIFY(!window.viewer().engine.behind());
        QVERIFY2(panel.isVisible() && panel.strip().isVisible(), "its last picture is on the screen");
        QCOMPARE(panel.strip().badge().text(), QString("STOPPED")); // one word in both places
        QVERIFY2(window.viewer().origin.text().startsWith("STOPPED · "), qPrintable(window.viewer().origin.text()));
        QVERIFY(window.viewer().origin.sign() == panel.strip().badge().sign());
        QVERIFY(on.open(bell_));
        QVERIFY(!panel.isVisible());
        panel.askAddress();
        QVERIFY2(panel.isVisible() && !panel.strip().isVisible(), "nothing is said about the scanner before");
        // Stopped while a file is on the screen.
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        QTRY_VERIFY(on.picture().source.stream == window.viewer().live.scanner().stream());
        QVERIFY(on.open(bell_));
        QVERIFY(panel.isVisible());
        press(window, "live-connect");
        QVERIFY(!panel.isVisible());
    }

    // A recording holds the sweep under way from its begin: the notice counts the lines from before Record. The dialog of Open offers the
    // folder of the recordings.
    void aRecordingCountsTheLinesFromBeforeRecord() {
        const auto emulated = scanner(60);
        QVERIFY(emulated);
        const QString folder = QString::fromStdString((folder_ / "recorded").string());
        WindowFixture on(QString::fromStdString((folder_ / "recorded.ini").string()));
        on.viewer.live.setRecordingFolder(folder);
        QVERIFY(showsFirstLines(on, *emulated));
        const int before = lines(on.window);
        press(on.window, "live-record");
        QTRY_VERIFY(lines(on.window) > before + 10);
        press(on.window, "live-record");
        const QRegularExpression counted("It begins with the sweep under way: ([0-9]+) lines of it came before Record\\.$");
        QTRY_VERIFY2(counted.match(on.viewer.notice.text()).hasMatch(), qPrintable(on.viewer.notice.text()));
        on.viewer.notice.unfold(true);
        QTRY_VERIFY(on.viewer.notice.findChild<QToolButton*>("notice-folder")->isVisible());
        const int said = counted.match(on.viewer.notice.text()).captured(1).toInt();
        QVERIFY2(said >= before && said <= lines(on.window), qPrintable(QString("%1 from %2").arg(said).arg(before)));
        QList<QUrl> places;
        QString first;
        const Meanwhile looked([&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return false;
            places = dialog->sidebarUrls();
            first = dialog->directory().absolutePath();
            dialog->reject();
            return true;
        });
        on.viewer.files.ask();
        QVERIFY(looked.done() && places.contains(QUrl::fromLocalFile(folder)));
        QCOMPARE(first, QDir(folder).absolutePath()); // no scan was opened yet
        on.viewer.live.scanner().disconnectScanner();
        // The notice opens it.
        auto* open = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QTRY_VERIFY(open->isVisible() && open->text() == "Open");
        QTest::mouseClick(open, Qt::LeftButton);
        QTRY_VERIFY2(on.viewer.files.path().startsWith(folder) && on.viewer.files.path().endsWith(".mcap"),
                     qPrintable(on.viewer.files.path()));
    }

    void thePictureBeforeAScannersFirstOneIsCalledOld() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(bell_));
        window.viewer().live.connectTo("127.0.0.1", 9, sweep()); // nothing answers
        QVERIFY2(window.viewer().origin.text().startsWith("OLD PICTURE · FILE bell"), qPrintable(window.viewer().origin.text()));
        QVERIFY(window.viewer().origin.sign() == StateBadge::Sign::Waiting);
        press(window, "live-connect"); // Stop
        QVERIFY2(window.viewer().origin.text().startsWith("FILE bell"), qPrintable(window.viewer().origin.text()));
    }

    void aLostScannerPromisesNoEnd() {
        auto emulated = scanner(40);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep());
        const HealthStrip& strip = window.viewer().live.panel().strip();
        QTRY_COMPARE(strip.shown().remark, std::string("START ASSUMED"));
        QCOMPARE(strip.shown().end, std::string()); // the connection may be in the middle of a sweep
        QTRY_VERIFY_WITH_TIMEOUT(strip.shown().end.ends_with(" left"), 20000);
        QTRY_VERIFY2(strip.shown().remark.empty(), strip.shown().remark.c_str()); // the encoder leapt back, also in the picture
        QVERIFY(strip.bar().share() > 0.0 && strip.bar().share() < 1.0);
        emulated.reset();
        QTRY_VERIFY(strip.shown().liveness == files::Liveness::Lost);
        QCOMPARE(strip.shown().end, std::string());
    }

    void theMountingIsPutRightWhileItScans() {
        const auto emulated = scanner(40);
        QVERIFY(emulated);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().live.connectTo("127.0.0.1", emulated->port(), sweep(Axis::Spin));
        QTRY_VERIFY(lines(window) > 10);
        const auto axis = [&] { return std::get<PolarGeometry>(on.picture().detection->scan->geometry).axis; };
        QVERIFY(axis() == Axis::Spin);
        const int before = lines(window);
        auto* button = window.viewer().live.panel().findChild<QToolButton*>("live-sweep");
        QVERIFY(button->isEnabled());
        const Meanwhile hand([&] {
            auto* menu = window.findChild<QDialog*>("sweep-dialog");
            if (!menu->isVisible()) return false;
            for (auto* list : menu->findChildren<QComboBox*>()) list->setCurrentIndex(list->findData(static_cast<int>(Axis::Sweep)));
            return menu->close();
        });
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(axis() == Axis::Sweep);
        QVERIFY2(lines(window) >= before, "the lines that are there go to their new places");
        QVERIFY(window.viewer().live.scanner().connected());
    }

    // A recording with wrong mounting values: corrected on opening, and during scrubbing too.
    void aRecordingsMountingIsPutRight() {
        const std::string path = (folder_ / "wrong.mcap").string();
        {
            const auto emulated = scanner(400);
            QVERIFY(emulated);
            const auto run = test::runCli("record 127.0.0.1:" + std::to_string(emulated->port()) + " -o " + path +
                                          " --lines 120 --expected-lines 120 --axis spin --line-start -90 --line-step 1.5 --seconds 120");
            QCOMPARE(run.code, 0);
        }
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().files.open({QString::fromStdString(path)});
        const auto geometry = [&] { return std::get<PolarGeometry>(on.picture().detection->scan->geometry); };
        Timeline& timeline = window.viewer().live.timeline();
        QTRY_VERIFY(timeline.active() && !window.viewer().engine.behind());
        QVERIFY(geometry().axis == Axis::Spin);
        ReadingOptions options = window.viewer().files.options();
        options.axis = Axis::Sweep;
        options.lineStartDeg = -80.0;
        options.lineStepDeg = 1.25;
        window.viewer().files.readAgain(options, "mounting");
        QTRY_VERIFY(!window.viewer().engine.opening() && timeline.active() && geometry().axis == Axis::Sweep);
        QCOMPARE(geometry().lineDeg.at(1), -78.75);
        timeline.goTo(40);
        QTRY_VERIFY(lines(window) == 40);
        QVERIFY(geometry().axis == Axis::Sweep);
        QCOMPARE(geometry().lineDeg.at(1), -78.75);
        window.viewer().undo.undo();
        QTRY_VERIFY(!window.viewer().engine.opening() && geometry().axis == Axis::Spin);
    }
};

int live_manners_test(int argc, char** argv) { return runWindowTest<LiveMannersTest>(argc, argv); }

#include "live_manners_test.moc"
