// The audit log contains the actions in the real window; a full disk is reported.
#include "core/base/audit_log/audit_check.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"

#include <QDir>
#include <QElapsedTimer>
#include <QMessageBox>
#include <QProcess>
#include <QSignalSpy>
#include <QTimer>

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>

using namespace edgescan;
using namespace edgescan::ui;

constexpr qint64 kAtOnceMs = 5000; // a second, on a machine that has other work

class AuditWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    std::string scan_;

    static std::vector<AuditLine> linesOf(const std::filesystem::path& path) {
        std::vector<AuditLine> lines;
        std::ifstream file(path);
        for (std::string text; std::getline(file, text);) {
            const auto line = auditLine(text, "");
            if (line) lines.push_back(*line);
        }
        return lines;
    }
    static bool written(WindowFixture& on) {
        return eventually([&] { return on.viewer.audit.written(); });
    }

private slots:
    void initTestCase() {
        qRegisterMetaType<exports::ExportContent>("edgescan::ExportContent");
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(files::saveScan(test::boxesScan(60, 90, 4, 0.02), scan_));
    }

    void whatIsDoneIsNotedAndTheChainHolds() {
        const std::filesystem::path place = folder_ / "a";
        std::filesystem::create_directories(place);
        {
            WindowFixture on(QString::fromStdString((place / "viewer.ini").string()));
            QVERIFY(on.showWith(scan_));
            on.viewer.views.pin(45U * 90U + 20U);
            edges::Settings settings;
            settings.sensitivity = 1.5;
            QVERIFY(on.use(settings));
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            on.viewer.engine.save(exports::ExportContent::EdgeImage, QString::fromStdString((place / "edges.png").string()));
            QVERIFY(saved.wait(kPatienceMs));
            QSignalSpy reported(&on.viewer.report, &ScanReport::ended);
            on.viewer.report.writeTo(QString::fromStdString((place / "report.html").string()));
            QVERIFY(reported.wait(kPatienceMs));
            QVERIFY(written(on));
        }
        const auto check = checkAudit(place / "audit.jsonl");
        QVERIFY(check);
        QVERIFY2(check->faults.empty(), check->faults.empty() ? "" : check->faults[0].sentence.c_str());
        std::map<std::string, AuditLine> last;
        for (const AuditLine& line : linesOf(place / "audit.jsonl")) last[line.event] = line;
        for (const char* event : {"started", "opened", "pinned", "changed", "exported", "ended"}) QVERIFY2(last.contains(event), event);
        QCOMPARE(last["opened"].details["scan"].get<std::string>(), scan_);
        QCOMPARE(last["pinned"].details["line"].get<int>(), 45);
        QCOMPARE(last["exported"].details["content"].get<std::string>(), std::string("report")); // after the picture
        QCOMPARE(linesOf(place / "audit.jsonl").size(), std::size_t{7});                         // setting a target is also an undo step
        QCOMPARE(last["exported"].details["settings"]["sensitivity"].get<double>(), 1.5);
        QCOMPARE(test::runCli("audit '" + (place / "audit.jsonl").string() + "'").code, 0);
    }

    // A log-out or Ctrl+C is not a crash: also while a scan is read or a question is open.
    void aSignalEndsTheProgramAsAClose_data() {
        QTest::addColumn<int>("signal");
        QTest::addColumn<bool>("reads");
        QTest::newRow("log-out") << SIGTERM << false;
        QTest::newRow("end of the terminal") << SIGHUP << false;
        QTest::newRow("Ctrl+C while it reads") << SIGINT << true;
    }

    void aSignalEndsTheProgramAsAClose() {
        QFETCH(int, signal);
        QFETCH(bool, reads);
        const std::filesystem::path home = folder_ / QTest::currentDataTag(), folder = home / "edgescan", pipe = home / "never.json";
        std::filesystem::create_directories(home);
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_CONFIG_HOME", QString::fromStdString(home.string()));
        QProcess viewer;
        viewer.setProcessEnvironment(environment);
        viewer.start(QString::fromStdString(test::programFolder()) + "/edgescan", {QString::fromStdString(reads ? pipe.string() : scan_)});
        const auto isNoted = [&](const char* event) {
            const auto lines = linesOf(folder / "audit.jsonl");
            return std::ranges::any_of(lines, [&](const AuditLine& line) { return line.event == event; });
        };
        const auto sessions = [&](const char* pattern) {
            return QDir(QString::fromStdString((folder / "sessions").string())).entryList({pattern}).size();
        };
        QVERIFY(eventually([&] { return reads ? isNoted("started") : isNoted("opened") && sessions("running-*.json") == 1; }));
        const int reader = reads ? ::open(pipe.c_str(), O_WRONLY) : -1; // waits until the pipe is read
        QElapsedTimer since;
        since.start();
        QCOMPARE(::kill(static_cast<pid_t>(viewer.processId()), signal), 0);
        QVERIFY(viewer.waitForFinished(kPatienceMs));
        QVERIFY2(since.elapsed() < kAtOnceMs, qPrintable(QString::number(since.elapsed())));
        ::close(reader);
        QCOMPARE(viewer.exitStatus(), QProcess::NormalExit);
        QCOMPARE(viewer.exitCode(), 0);
        QVERIFY(isNoted("ended"));
        QCOMPARE(sessions("running-*"), 0);
        QCOMPARE(sessions("last*"), reads ? 0 : 1);
    }

    void anOpenQuestionDoesNotKeepTheWindow() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QMessageBox question(QMessageBox::Question, "", "?", QMessageBox::Yes | QMessageBox::Cancel, &on.window);
        QTimer::singleShot(0, &question, [&] { QTimer::singleShot(0, &on.window, &MainWindow::end); });
        question.exec();
        QVERIFY(question.clickedButton() != question.button(QMessageBox::Yes));
    }

    void aFullDiskIsSeenAndNothingElseFails() {
        const std::filesystem::path place = folder_ / "b";
        std::filesystem::create_directories(place);
        std::filesystem::create_symlink("/dev/full", place / "audit.jsonl");
        WindowFixture on(QString::fromStdString((place / "viewer.ini").string()));
        QVERIFY(on.showWith(scan_));
        QVERIFY(eventually([&] { return on.viewer.notice.isVisible() && on.viewer.notice.text().contains("AUDIT LOG"); }));
        QVERIFY(!on.viewer.audit.written());
        // Space is free again: the lines of the meantime are written too.
        std::filesystem::remove(place / "audit.jsonl");
        on.viewer.views.pin(5);
        QVERIFY(written(on));
        const std::vector<AuditLine> lines = linesOf(place / "audit.jsonl");
        QVERIFY(lines.size() >= 3);
        QCOMPARE(lines[0].event, std::string("started"));
        QVERIFY(std::ranges::any_of(lines, [](const AuditLine& line) { return line.event == "pinned"; }));
    }

    void withoutMemoryThereIsNone() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.viewer.audit.written());
    }
};

int audit_window_test(int argc, char** argv) { return runWindowTest<AuditWindowTest>(argc, argv); }
#include "audit_window_test.moc"
