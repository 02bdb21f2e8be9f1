// What the window writes by itself, written by twenty processes at the same time: its settings, the last session, the edits of rocks.
// EDGESCAN_WRITER_ROUNDS=1000 is the long form.
#include "core/base/whole_file.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/inspect/measure/notebook.h"
#include "core/inspect/session_file/session_file.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/ui/patience.h"
#include "ui/controllers/rocks/rock_sidecar.h"
#include "ui/controllers/sessions/autosaves.h"
#include "ui/controllers/targets/target_store.h"
#include "ui/engine/worker_bridge/preferences.h"
#include "ui/panels/change/comparison.h"

#include <QCoreApplication>
#include <QDir>
#include <QProcess>
#include <QSettings>
#include <QtTest>

#include <iostream>
#include <memory>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

constexpr int kWriters = 20;
constexpr int kSettings = 30; // written by each

QString sessionOf(int writer) { return QString("session of writer %1 ").arg(writer) + QString(1000 * writer, 'x'); }

/// The work of one process.
int writeAs(int writer, const QString& folder) {
    {
        Preferences preferences(folder + "/viewer.ini");
        for (int n = 0; n < kSettings; ++n) preferences.keep(QString("writer%1/%2").arg(writer).arg(n), QString::number(writer * n));
    }
    Autosaves autosaves(folder + "/sessions");
    if (!writeWholeFile(autosaves.own().toStdString(), sessionOf(writer).toStdString())) return 1;
    autosaves.end();
    return 0;
}

} // namespace

class WindowWritersTest : public QObject {
    Q_OBJECT
private slots:
    void ofTwentyProcessesNothingIsMissing() {
        const int rounds = std::max(1, qEnvironmentVariableIntValue("EDGESCAN_WRITER_ROUNDS"));
        int missing = 0;
        for (int round = 0; round < rounds; ++round) {
            const test::TemporaryFolder folder;
            const QString place = QString::fromStdString(folder.path().string());
            std::vector<std::unique_ptr<QProcess>> writers;
            for (int writer = 0; writer < kWriters; ++writer) {
                writers.push_back(std::make_unique<QProcess>());
                writers.back()->start(QCoreApplication::applicationFilePath(),
                                      {"window_writers_test", "--write-as", QString::number(writer), place});
            }
            for (const auto& writer : writers) {
                QVERIFY(writer->waitForFinished(kPatienceMs));
                QCOMPARE(writer->exitCode(), 0);
            }
            const QSettings settings(place + "/viewer.ini", QSettings::IniFormat);
            for (int writer = 0; writer < kWriters; ++writer) {
                for (int n = 0; n < kSettings; ++n)
                    missing += settings.value(QString("writer%1/%2").arg(writer).arg(n)).toString() == QString::number(writer * n) ? 0 : 1;
            }
            const std::string last = test::fileText(folder / ("sessions/last" + std::string(inspect::kSessionEnding)));
            bool whole = false;
            for (int writer = 0; writer < kWriters; ++writer) whole = whole || last == sessionOf(writer).toStdString();
            QVERIFY2(whole, last.substr(0, 40).c_str());
            QVERIFY(Autosaves(place + "/sessions").afterCrash().isEmpty());
            QCOMPARE(missing, 0);
        }
        std::cout << "[ measured ] " << kWriters << " processes change the window's settings and end at the same time, " << rounds
                  << " rounds: " << missing << " settings missing\n";
    }

    void noExportReplacesTheScanThatIsComparedWith() {
        const test::TemporaryFolder folder;
        const std::string path = (folder / "before.json").string();
        QVERIFY(files::saveScan(test::boxesScan(24, 30, 3), path));
        auto picture = earlierPicture(QString::fromStdString(path), {}, edges::Settings{});
        QVERIFY2(picture, picture ? "" : picture.error().sentence().c_str());
        QVERIFY(!writeWholeFile(path, std::string("an export")));
        QVERIFY(!writeWholeFile(folder / "before.u16", std::string("an export")));
        picture = std::shared_ptr<const Picture>();
        QVERIFY(files::saveScan(test::boxesScan(24, 30, 3), path));
    }

    // A look at stored targets, as the list of layers has it, begins no work on them: what another window added stays.
    void aLookAtStoredTargetsLeavesThoseOfAnotherWindow() {
        const test::TemporaryFolder folder;
        const std::string path = (folder / "a.json").string();
        QVERIFY(files::saveScan(test::boxesScan(24, 30, 3), path));
        const inspect::NotebookScan scan = inspect::notebookScan(*files::openScan(path));
        const auto notebookOf = [](const std::vector<int>& numbers) {
            inspect::Notebook notebook;
            for (const int number : numbers) notebook.targets.push_back({number, "", static_cast<std::uint32_t>(10 * number)});
            return notebook;
        };
        TargetStore store(QString::fromStdString((folder / "targets").string()));
        const std::string file = store.pathOf(scan).toStdString();
        const auto stored = [&] { return inspect::notebookFromText(test::fileText(file), scan, file); };
        QVERIFY(bool(store.load(scan)));
        store.save(notebookOf({1}), scan);
        QVERIFY(eventually([&] { return std::filesystem::exists(file) && stored() && *stored() == notebookOf({1}); }));
        QVERIFY(writeWholeFile(file, inspect::notebookText(notebookOf({1, 2}), scan))); // another window
        QVERIFY(eventually([&] {                                                        // the own ones are delivered by then
            const auto read = store.peek(scan);
            return read && read->targets.size() == 2;
        }));
        store.save(notebookOf({1, 3}), scan);
        QVERIFY(eventually([&] { return stored() && stored()->targets.size() == 3; }));
    }

    void editsOfAnotherWindowAreNotRemoved() {
        const test::TemporaryFolder folder;
        const std::string path = (folder / "a.json").string();
        QVERIFY(files::saveScan(test::boxesScan(24, 30, 3), path));
        const auto scan = std::make_shared<const Scan>(*files::openScan(path));
        const std::filesystem::path file = rocks::rockPresetPath(path);
        RockSidecar sidecar;
        std::vector<rocks::Edit> merged;
        QObject::connect(&sidecar, &RockSidecar::merged, [&](const rocks::Preset&, const rocks::Preset& now) { merged = now.edits; });
        const auto follow = [&](std::shared_ptr<const Scan> of) {
            sidecar.follow(std::move(of));
            return eventually([&] { return !sidecar.reading(); });
        };
        const std::vector<rocks::Edit> edits{{rocks::EditKind::NotRock, {7}}};
        QVERIFY(follow(scan));
        sidecar.keep({}, edits);
        QVERIFY(eventually([&] { return std::filesystem::exists(file); }));
        const std::vector<rocks::Edit> theirs{{rocks::EditKind::Rock, {3}}};
        const std::string others = rocks::rockPresetText({std::nullopt, theirs, scan->sha256}, 24, 30);
        QVERIFY(writeWholeFile(file, others)); // another window
        sidecar.keep({}, {});
        QVERIFY(eventually([&] { return !merged.empty(); }));
        QVERIFY(merged == theirs);
        const auto stored = rocks::readRockPreset(file, *scan);
        QVERIFY(stored && stored->edits == theirs);
        // Those that this window has read may be removed.
        QVERIFY(follow(nullptr));
        QVERIFY(follow(scan));
        sidecar.keep({}, {});
        QVERIFY(eventually([&] { return !std::filesystem::exists(file); }));
    }
};

int window_writers_test(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const QStringList words = application.arguments();
    if (words.size() == 4 && words[1] == "--write-as") return writeAs(words[2].toInt(), words[3]);
    WindowWritersTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_writers_test.moc"
