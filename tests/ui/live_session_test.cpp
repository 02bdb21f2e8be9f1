// A session of a sweep during recording: its targets are restored after the program was killed in the middle of the sweep.
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "core/base/whole_file.h"
#include "core/inspect/session_file/session_file.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/live/timeline.h"

#include <QPushButton>
#include <QTimer>
#include <QToolButton>

using namespace edgescan;
using namespace edgescan::ui;

class LiveSessionTest : public QObject {
    Q_OBJECT
    static constexpr int kLines = 120;
    static constexpr int kBeams = 381;

    test::TemporaryFolder folder_;
    Scan scan_;

    [[nodiscard]] std::unique_ptr<scanner::EmulatedScanner> scanner() const {
        auto telegrams = scanner::telegramsOf(scan_);
        if (!telegrams) return nullptr;
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 40;
        auto made = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
        return made ? std::move(*made) : nullptr;
    }
    static int lines(WindowFixture& on) {
        const auto& picture = on.viewer.engine.picture();
        return picture ? picture->detection->scan->lines() : 0;
    }
    static void clickCell(WindowFixture& on, int line, int beam) {
        ImageView& view = on.viewer.views.gray();
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier,
                          view.viewPort()->toPixel(QPointF(beam + 0.5, line + 0.5), view.size()).toPoint());
    }
    static void press(WindowFixture& on, const char* name) {
        QTest::mouseClick(on.viewer.live.panel().findChild<QPushButton*>(name), Qt::LeftButton);
    }
    [[nodiscard]] static std::optional<std::filesystem::path> savedIn(const std::filesystem::path& sessions) {
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(sessions, none)) {
            const std::string name = entry.path().filename().string();
            if (name.starts_with("running-") && name.ends_with(inspect::kSessionEnding)) return entry.path();
        }
        return std::nullopt;
    }
    [[nodiscard]] static std::optional<inspect::ViewerState> saved(const std::filesystem::path& sessions) {
        const auto path = savedIn(sessions);
        auto read = path ? inspect::readSession(*path) : Result<inspect::ReadSession>(Error{});
        return read ? std::optional(read->state) : std::nullopt;
    }
    bool connectAndRecord(WindowFixture& on, const scanner::EmulatedScanner& scanner, const std::filesystem::path& home) {
        on.viewer.live.setRecordingFolder(QString::fromStdString((home / "recordings").string()));
        if (!on.show() || !on.activate()) return false;
        scanner::SweepSettings sweep;
        sweep.expectedLines = kLines;
        sweep.degPerLine = 180.0 / kLines;
        sweep.firstLineDeg = -90;
        sweep.axis = Axis::Sweep;
        on.viewer.live.connectTo("127.0.0.1", scanner.port(), sweep);
        press(on, "live-record"); // before the first line arrives
        return on.viewer.live.scanner().recording() && eventually([&] { return lines(on) >= 50; });
    }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = kLines;
        settings.beams = kBeams;
        scan_ = sim::simulate(settings)->scan;
    }

    void afterAKillInTheMiddleOfASweepItsRecordingOpensWithItsPins() {
        namespace fs = std::filesystem;
        const fs::path home = folder_ / "home", left = folder_ / "left";
        fs::create_directories(home);
        std::vector<std::size_t> clicked(2); // cells that the clicks meant
        const auto scanner = this->scanner();
        QVERIFY(scanner);
        {
            WindowFixture on(QString::fromStdString((home / "viewer.ini").string()));
            QVERIFY(connectAndRecord(on, *scanner, home));
            clickCell(on, 20, 150);
            clickCell(on, 40, 200);
            // The session names the recording of the sweep; a growing file has no hash.
            QVERIFY(eventually([&] {
                const auto now = saved(home / "sessions");
                return now && now->targets.notebook.targets.size() == 2 && now->scan.kind == inspect::SessionScan::Kind::Recording;
            }));
            for (std::size_t n = 0; n < 2; ++n) clicked[n] = on.viewer.targets.notebook().targets[n].cell;
            QVERIFY(lines(on) < kLines);
            QVERIFY(saved(home / "sessions")->scan.identity.sha256.empty());
            // The state after a kill: the files at this moment.
            fs::copy(home, left, fs::copy_options::recursive);
            // A closed recording has a hash.
            press(on, "live-record");
            QVERIFY(eventually([&] {
                const auto now = saved(home / "sessions");
                return now && now->scan.identity.sha256.size() == 64;
            }));
            on.viewer.live.scanner().disconnectScanner();
        }
        WindowFixture on(QString::fromStdString((folder_ / "later.ini").string()));
        QVERIFY(on.show());
        const auto session = savedIn(left / "sessions");
        QVERIFY(session);
        on.window.sessions().openSession(QString::fromStdString(session->string()));
        QVERIFY(on.settled());
        QVERIFY2(eventually([&] { return on.viewer.targets.notebook().targets.size() == 2; }), qPrintable(on.viewer.notice.text()));
        // The recording next to the copied session, not the one that continued; line and beam are those of the click.
        QVERIFY2(on.viewer.files.path().startsWith(QString::fromStdString(left.string())), qPrintable(on.viewer.files.path()));
        QVERIFY(lines(on) >= 41 && lines(on) < kLines);
        const auto& targets = on.viewer.targets.notebook().targets;
        for (std::size_t n = 0; n < 2; ++n) QCOMPARE(std::size_t(targets[n].cell), clicked[n]);
        QTRY_VERIFY(on.viewer.live.timeline().labelShown().startsWith("RECORDED")); // the timeline reads the file itself
        const Scan& scan = *on.picture().detection->scan;
        QVERIFY(std::ranges::any_of(scan.warnings, [](const std::string& warning) { return warning.starts_with("INCOMPLETE"); }));
        for (int n = 0; n < 41 * kBeams; ++n)
            QCOMPARE(scan.rangeMm[static_cast<std::size_t>(n)], scan_.rangeMm[static_cast<std::size_t>(n)]);
    }

    // The session of the second sweep of a recording, which opens at its first one.
    void theSecondSweepOfARecordingComesBackWithItsPins() {
        const std::filesystem::path home = folder_ / "second";
        std::filesystem::create_directories(home);
        Scan other = scan_;
        for (std::size_t k = 0; k < other.cells(); ++k) other.rangeMm[k] *= 0.875F;
        auto both = scanner::telegramsOf(scan_);
        auto later = scanner::telegramsOf(other);
        QVERIFY(both && later);
        both->insert(both->end(), later->begin(), later->end());
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 100;
        settings.atEnd = scanner::AtEnd::Stop;
        const auto scanner =
            scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*both)), settings);
        QVERIFY(scanner);
        std::size_t clicked = 0;
        {
            WindowFixture on(QString::fromStdString((home / "viewer.ini").string()));
            QVERIFY(connectAndRecord(on, **scanner, home));
            QTRY_VERIFY(!on.viewer.live.scanner().following()); // held at the end of the first sweep
            press(on, "live-follow");
            QTRY_VERIFY(on.viewer.engine.picture()->source.growth.sweep == 1 && lines(on) == kLines && on.settled());
            clickCell(on, 40, 200);
            QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
            clicked = on.viewer.targets.notebook().targets[0].cell;
            press(on, "live-record");
            QVERIFY(eventually([&] {
                const auto now = saved(home / "sessions");
                return now && now->targets.notebook.targets.size() == 1 && now->scan.identity.sha256.size() == 64;
            }));
            std::filesystem::copy(home / "sessions", home / "left", std::filesystem::copy_options::recursive);
            on.viewer.live.scanner().disconnectScanner();
        }
        WindowFixture on(QString::fromStdString((home / "later.ini").string()));
        QVERIFY(on.show());
        const auto session = savedIn(home / "left");
        QVERIFY(session);
        on.window.sessions().openSession(QString::fromStdString(session->string()));
        QVERIFY2(eventually([&] { return on.viewer.targets.notebook().targets.size() == 1; }), qPrintable(on.viewer.notice.text()));
        QCOMPARE(std::size_t(on.viewer.targets.notebook().targets[0].cell), clicked);
        const Scan& scan = *on.picture().detection->scan;
        for (std::size_t n = 0; n < static_cast<std::size_t>(scan.beams()); ++n)
            QVERIFY(std::abs(scan.rangeMm[n] - other.rangeMm[n]) <= 1.0F);
    }

    // What was pinned on a live sweep is there when its recording is opened from the note, at that sweep only.
    void theRecordingHasThePinsOfItsLiveSweeps() {
        const std::filesystem::path home = folder_ / "pinned";
        std::filesystem::create_directories(home);
        auto telegrams = scanner::telegramsOf(scan_); // the same surfaces twice, without noise: only the time is another
        QVERIFY(telegrams);
        scanner::EmulatedScannerSettings settings;
        settings.linesPerSecond = 100;
        settings.atEnd = scanner::AtEnd::Again;
        const auto scanner =
            scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
        QVERIFY(scanner);
        WindowFixture on(QString::fromStdString((home / "viewer.ini").string()));
        QVERIFY(connectAndRecord(on, **scanner, home));
        QTRY_VERIFY(!on.viewer.live.scanner().following());
        press(on, "live-follow");
        on.viewer.live.scanner().setHoldAtEnd(true);
        QTRY_VERIFY(on.viewer.engine.picture()->source.growth.sweep == 1 && !on.viewer.live.scanner().following() && on.settled());
        QCOMPARE(lines(on), kLines);
        clickCell(on, 40, 200);
        const auto& targets = on.viewer.targets.notebook().targets;
        QCOMPARE(targets.size(), std::size_t(1));
        const std::uint32_t clicked = targets[0].cell;
        press(on, "live-record");
        auto* open = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QTRY_VERIFY2(open->isVisible() && open->text() == "Open", qPrintable(on.viewer.notice.text()));
        on.viewer.live.scanner().disconnectScanner();
        on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "another note");
        on.viewer.notice.findChild<QTimer*>("notice-leaves")->setInterval(1);
        QTRY_VERIFY2(open->isVisible() && open->isEnabled() && open->text() == "Open", qPrintable(on.viewer.notice.text()));
        QTest::mouseClick(open, Qt::LeftButton);
        QTRY_VERIFY(on.viewer.live.timeline().active());
        QVERIFY(on.settled());
        Timeline& timeline = on.viewer.live.timeline();
        for (const std::size_t sweep : {std::size_t{0}, std::size_t{1}}) {
            timeline.goTo(timeline.endOf(sweep));
            const auto shown = [&] {
                const auto& growth = on.picture().source.growth;
                return on.settled() && lines(on) == kLines &&
                       (growth.sweep == static_cast<int>(sweep) || timeline.endOf(sweep) == timeline.home());
            };
            QTRY_VERIFY(shown());
            QTRY_COMPARE(targets.size(), sweep);
        }
        QCOMPARE(targets[0].cell, clicked);
    }

    // Another sweep at the path of the file: targets are not placed on rocks of this other sweep.
    void anotherSweepInItsPlaceIsToldApart() {
        namespace fs = std::filesystem;
        const fs::path home = folder_ / "mixed";
        fs::create_directories(home);
        std::vector<std::size_t> clicked(2); // cells that the clicks meant
        const auto scanner = this->scanner();
        QVERIFY(scanner);
        fs::path session;
        {
            WindowFixture on(QString::fromStdString((home / "viewer.ini").string()));
            QVERIFY(connectAndRecord(on, *scanner, home));
            clickCell(on, 20, 150);
            QVERIFY(eventually([&] {
                const auto now = saved(home / "sessions");
                return now && now->targets.notebook.targets.size() == 1;
            }));
            inspect::ViewerState other = *saved(home / "sessions");
            other.scan.head.sha256 = std::string(64, '0');
            session = home / "sessions" / (std::string("other") + inspect::kSessionEnding);
            QVERIFY(bool(writeWholeFile(session, inspect::sessionText(other, session.parent_path(), ""))));
            press(on, "live-record");
            QVERIFY(eventually([&] { return on.viewer.live.scanner().recordingClosed(); }));
            on.viewer.live.scanner().disconnectScanner();
        }
        WindowFixture on;
        QVERIFY(on.show());
        on.window.sessions().openSession(QString::fromStdString(session.string()));
        QVERIFY(on.settled());
        QVERIFY2(eventually([&] { return on.viewer.notice.text().contains("is not the scan of this session"); }),
                 qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.targets.notebook().targets.empty());
    }
};

int live_session_test(int argc, char** argv) { return runWindowTest<LiveSessionTest>(argc, argv); }
#include "live_session_test.moc"
