// Files in the real window: opening, refusals, straightening, series, and exports that equal those of the command line.
#include "app/lab/sim/simulate.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/point_lists.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/tuning/count_curve.h"
#include "ui/panels/tuning/status_line.h"

#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include <fcntl.h>
#include <fstream>
#include <functional>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

using namespace edgescan;
using namespace edgescan::ui;

class FilesWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    std::string real_;

private slots:
    void initTestCase() { real_ = usualScan(folder_); }

    void badInputIsSaidAndLeavesTheScanOnTheScreen_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("missing") << "gone.pcd" << QByteArray("\x01REMOVE");
        QTest::newRow("empty") << "empty.json" << QByteArray();
        QTest::newRow("not a scan") << "picture.json" << QByteArray("\x89PNG\r\n\x1a\n 12345", 14);
        QTest::newRow("too large")
            << "huge.json"
            << QByteArray(
                   "{\"format\":\"edgescan-raw-grid/1\",\"data\":\"huge.u16\",\"lines\":1000000000,\"beams\":1000000000,\"unit_mm\":1,"
                   "\"no_return\":[0],\"status_codes\":[],\"beam_deg\":{\"start\":0,\"step\":1},\"line_deg\":{\"start\":0,\"step\":1},"
                   "\"axis\":\"spin\"}");
        QTest::newRow("promises more")
            << "short.pcd"
            << QByteArray("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 640\nHEIGHT 480\nVIEWPOINT 0 0 0 1 0 0 0\n"
                          "POINTS 307200\nDATA binary\n12345678");
        QTest::newRow("not a number") << "nan.csv" << QByteArray("nan,nan\nnan,inf\n");
        QTest::newRow("non-ASCII") << "leer-\u00e4\u5929.txt" << QByteArray("hello world\n");
    }

    void badInputIsSaidAndLeavesTheScanOnTheScreen() {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        const auto before = window.viewer().engine.picture();
        QVERIFY(eventually([&] { return window.viewer().engine.bordered() != nullptr; }));
        const auto edges = window.viewer().views.edges().image();
        const QString path = QString::fromStdString(folder_.path().string()) + "/" + name;
        if (!content.startsWith('\x01')) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        }
        QSignalSpy failures(&window.viewer().engine, &Engine::failed);
        window.viewer().files.open({path});
        QVERIFY(eventually([&] { return failures.count() == 1; }));
        QVERIFY(window.viewer().notice.isVisible());
        QCOMPARE(window.viewer().notice.kind(), NoticeBar::Kind::Error);
        QVERIFY2(window.viewer().notice.text().contains(name.section('.', 0, 0)), qPrintable(window.viewer().notice.text()));
        QVERIFY(on.settled());
        QCOMPARE(window.viewer().engine.picture(), before);
        QCOMPARE(window.viewer().views.edges().image(), edges);
        QCOMPARE(window.windowTitle(),
                 QFileInfo(QString::fromStdString(before->detection->scan->path)).fileName() + " - EdgeScan"); // with its ending
    }

    // A pose of 3DTK in the folder of its scan is named: the window does not read it.
    void aPoseOf3dtkIsNamed() {
        const auto from = test::sharedFolder() / "data/lms200_corridor";
        if (!std::filesystem::exists(from / "scan000.pose")) QSKIP("needs the corridor of 3DTK");
        for (const char* name : {"scan000.3d", "scan000.pose"}) std::filesystem::copy_file(from / name, folder_ / name);
        WindowFixture on;
        QVERIFY(on.showWith((folder_ / "scan000.3d").string()));
        QTRY_VERIFY2(on.viewer.notice.text().contains("scan000.pose, a pose of 3DTK, is not read"), qPrintable(on.viewer.notice.text()));
    }

    // Only what EdgeScan opens: records, poses and edits next to a scan are not listed, and are not the next scan of the folder.
    void theDialogOfOpenListsScans() {
        const std::filesystem::path folder = folder_ / "listed";
        std::filesystem::create_directory(folder);
        test::writeText((folder / "a.csv").string(), "1,2\n3,4\n");
        for (const char* name : {"a.csv.provenance.json", "a.csv.pose.json", "a.csv.rocks.json"})
            test::writeText((folder / name).string(), "{}");
        WindowFixture on;
        QVERIFY(on.show());
        on.preferences.keepFolder("scans", QString::fromStdString((folder / "a.csv").string()));
        QStringList names;
        const Meanwhile looked([&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            auto* list = dialog == nullptr ? nullptr : dialog->findChild<QListView*>("listView");
            if (list == nullptr || list->model()->rowCount(list->rootIndex()) == 0) return false;
            for (int n = 0; n < list->model()->rowCount(list->rootIndex()); ++n)
                names << list->model()->index(n, 0, list->rootIndex()).data().toString();
            dialog->reject();
            return true;
        });
        on.viewer.files.ask();
        QVERIFY(looked.done());
        QCOMPARE(names, QStringList("a.csv"));
    }

    void beamsThatLieElsewhereAreToldAndStraightened() {
        sim::SimulationSettings settings;
        settings.lines = 250;
        settings.beams = 286;
        settings.seed = 3;
        settings.interlaceDeg = 0.36;
        const std::string path = (folder_ / "interlaced.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, path)));
        WindowFixture on;
        MainWindow& window = on.window;
        window.resize(1300, 800);
        QVERIFY(on.showWith(path));
        QVERIFY2(window.viewer().notice.text().contains("degrees ahead of even ones"), qPrintable(window.viewer().notice.text()));
        auto* straighten = window.findChild<QAction*>("straighten");
        QVERIFY(straighten != nullptr && !straighten->isChecked());
        const auto skew = [&] { return std::get<PolarGeometry>(window.viewer().engine.picture()->detection->scan->geometry).lineSkewDeg; };
        const auto tilted = [&] { return !skew().empty() && std::abs(skew()[1] - skew()[0]) > 0.2; };
        QVERIFY(!tilted());
        // The button in the notice corrects it ...
        auto* offered = window.viewer().notice.findChild<QToolButton*>("notice-action");
        QVERIFY(offered != nullptr && offered->isVisible());
        QTest::mouseClick(offered, Qt::LeftButton);
        QVERIFY(on.settled());
        QVERIFY(eventually(tilted));
        QVERIFY(straighten->isChecked());
        QVERIFY2(window.viewer().notice.text().contains("Straightened: odd beams lie 0.3"), qPrintable(window.viewer().notice.text()));
        // ... and the menu undoes the correction.
        straighten->trigger();
        QVERIFY(eventually([&] { return !tilted(); }));
        QVERIFY(on.settled());
        QVERIFY(!straighten->isChecked());
        straighten->trigger();
        QVERIFY(eventually(tilted));
        // Another file opens as recorded.
        QVERIFY(on.open(real_));
        QVERIFY(!straighten->isChecked());
    }

    void valuesThatRepeatAreKeptWhereWanted() {
        const std::string path = (folder_ / "marked.csv").string();
        const Scan scan = test::boxesScan(40, 1141, 3, 0.1); // beams of a known scanner need no angles
        std::ofstream file(path);
        for (std::size_t k = 0; k < scan.cells(); ++k)
            file << (scan.state[k] == CellState::Valid ? static_cast<int>(scan.rangeMm[k]) : 65535) << (k % 1141 == 1140 ? '\n' : ',');
        file.close();
        WindowFixture on;
        QVERIFY(on.showWith(path));
        const auto measured = [&] {
            return static_cast<std::size_t>(std::ranges::count(on.picture().detection->scan->state.cells, CellState::Valid));
        };
        QVERIFY(measured() < scan.cells());
        QVERIFY2(on.viewer.notice.text().contains("Scan > Keep Repeated Values"), qPrintable(on.viewer.notice.text()));
        QVERIFY(eventually([&] { return on.viewer.opening.settled(); }));
        auto* offered = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QCOMPARE(offered->text(), QString("Keep as measured"));
        QTest::mouseClick(offered, Qt::LeftButton);
        QVERIFY(eventually([&] { return measured() == scan.cells(); }) && on.settled());
        auto* keep = on.window.findChild<QAction*>("keep-repeated");
        QVERIFY(keep->isChecked());
        // Reopened as a session opens it.
        const auto stored = on.viewer.files.scanShown(*on.picture().detection->scan);
        QVERIFY(stored && on.open(real_) && !keep->isChecked());
        on.viewer.files.openAgain(*stored);
        QVERIFY(eventually([&] { return keep->isChecked() && measured() == scan.cells(); }) && on.settled());
        keep->trigger();
        QVERIFY(eventually([&] { return measured() < scan.cells(); }) && on.settled());
        QVERIFY(!keep->isChecked());
    }

    void exportsEqualThoseOfTheCommandLine() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        using Export = exports::ExportContent;
        const std::vector<std::tuple<Export, const char*, const char*>> exports{
            {Export::EdgeCloud, "edges.pcd", "--edges"}, {Export::EdgeCloud, "edges.ply", "--edges"},
            {Export::EdgeCloud, "edges.csv", "--edges"}, {Export::FullCloud, "cloud.pcd", "--cloud"},
            {Export::EdgeImage, "mask.png", "--mask"},   {Export::GrayImage, "gray.png", "--gray"},
            {Export::RangeImage, "range.png", "--range"}};
        for (const auto& [what, name, flag] : exports) {
            QSignalSpy saved(&window.viewer().engine, &Engine::saved);
            const std::string path = (folder_ / name).string();
            window.viewer().engine.save(what, QString::fromStdString(path));
            QVERIFY(eventually([&] { return saved.count() == 1 && !window.viewer().engine.working(); }));
            const std::string other = (folder_ / (std::string("cli-") + name)).string();
            QCOMPARE(test::runCli("detect '" + real_ + "' " + flag + " " + other).code, 0);
            QVERIFY2(test::fileText(path) == test::fileText(other), name);
            QVERIFY(!test::fileText(path).empty());
        }
        // A failed export names the path and leaves no file.
        QSignalSpy failures(&window.viewer().engine, &Engine::failed);
        window.viewer().engine.save(Export::EdgeCloud, "/nonexistent-folder/e.pcd");
        QVERIFY(eventually([&] { return failures.count() == 1; }));
        QVERIFY(window.viewer().notice.text().contains("/nonexistent-folder/e.pcd"));
    }

    void aSmallerScanUnderTheMouseIsShown() {
        const std::string large = (folder_ / "large.json").string();
        const std::string small = (folder_ / "small.json").string();
        QVERIFY(files::saveScan(test::boxesScan(1500, 1500, 1), large));
        QVERIFY(files::saveScan(test::boxesScan(4, 4, 1), small));
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(large));
        emit window.viewer().views.gray().hovered(1499, 1499);
        emit window.viewer().views.gray().clicked(1499, 1499);
        QVERIFY(!window.viewer().statusLine.probeShown().isEmpty());
        window.viewer().files.open({QString::fromStdString(small)});
        QVERIFY(eventually([&] { return window.viewer().engine.picture()->detection->scan->lines() == 4; }));
        QVERIFY(window.viewer().statusLine.probeShown().isEmpty());
    }

    void aSeriesGoesOnBehindABadFile() {
        const std::string second = (folder_ / "series2.json").string();
        const std::string bad = (folder_ / "series-bad.json").string();
        QVERIFY(files::saveScan(test::boxesScan(30, 40, 8), second));
        std::ofstream(bad) << "no scan";
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.viewer().files.open({QString::fromStdString(real_), QString::fromStdString(bad), QString::fromStdString(second)});
        QVERIFY(on.settled());
        QVERIFY(window.windowTitle().contains("(1 of 3)"));
        QVERIFY(on.activate());
        QSignalSpy failures(&window.viewer().engine, &Engine::failed);
        QTest::keyClick(&window, Qt::Key_PageDown);
        QVERIFY(eventually([&] { return failures.count() == 1 && !window.viewer().engine.working(); }));
        QTest::keyClick(&window, Qt::Key_PageDown);
        QVERIFY(eventually([&] { return window.viewer().engine.picture()->detection->scan->lines() == 30; }));
        QVERIFY(window.windowTitle().contains("(3 of 3)"));
    }

    void everyKindOfExportIsReportedWhenItIsSaved() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        for (const exports::ExportKind& kind : exports::exportKinds()) {
            if (kind.needs > exports::ExportKind::Needs::Edges) continue; // rocks_window_test.cpp, targets_test.cpp
            QSignalSpy saved(&window.viewer().engine, &Engine::saved);
            const std::string name = std::string(kind.key) + (kind.files.empty() ? ".pcd" : kind.files.front().extension);
            window.viewer().engine.save(kind.content, QString::fromStdString((folder_ / name).string()));
            QVERIFY2(eventually([&] { return saved.count() == 1 && !window.viewer().engine.working(); }), kind.key);
            const QString counted = countText(saved.front()[2].toLongLong()) + " " + exports::countedThings(kind);
            QVERIFY2(window.viewer().notice.text().contains(counted), qPrintable(window.viewer().notice.text()));
        }
    }

    void aFailingSaveIsToldEvenWhileAScanOpens() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        QSignalSpy failures(&window.viewer().engine, &Engine::failed);
        window.viewer().engine.save(exports::ExportContent::EdgeCloud, "/nonexistent-folder/e.pcd");
        window.viewer().files.open({QString::fromStdString(real_)});
        QVERIFY(eventually([&] { return failures.count() == 1 && !window.viewer().engine.working(); }));
    }

    void aDroppedFileIsOpened() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        QMimeData mime;
        mime.setUrls({QUrl::fromLocalFile(QString::fromStdString(real_))});
        QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &drop);
        QVERIFY(on.settled());
        QCOMPARE(QString::fromStdString(window.viewer().engine.picture()->detection->scan->path), QString::fromStdString(real_));
    }

    void aNameThatIsNotUtf8IsOpenedAndRemembered() {
        const std::string place = (folder_ / "d\xfd").string();
        std::filesystem::create_directories(place);
        const std::string first = place + "/n\xfe.json", second = place + "/n\xff.json";
        QVERIFY(files::saveScan(test::boxesScan(30, 40, 8), first));
        QVERIFY(files::saveScan(test::boxesScan(31, 40, 9), second));
        const QString ini = exactText((folder_ / "names.ini").string());
        const auto shown = [](WindowFixture& on) { return on.viewer.engine.picture()->detection->scan->path; };
        {
            WindowFixture on(ini);
            QVERIFY(on.show());
            on.viewer.files.open({exactText(first)});
            QVERIFY(on.settled());
            QCOMPARE(shown(on), first);
            on.viewer.files.step(1); // the next one in its folder
            QVERIFY(eventually([&] { return shown(on) == second && !on.viewer.engine.working(); }));
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            on.viewer.engine.save(exports::ExportContent::EdgeImage, exactText(place + "/mask\xff.png"));
            QVERIFY(eventually([&] { return saved.count() == 1 && !on.viewer.engine.working(); }));
            QVERIFY(std::filesystem::exists(place + "/mask\xff.png"));
            QVERIFY2(on.viewer.notice.text().contains("mask\\xff.png"), qPrintable(on.viewer.notice.text()));
        }
        WindowFixture on(ini);
        QVERIFY(on.show());
        QCOMPARE(on.preferences.recentFiles().mid(0, 2), QStringList({exactText(second), exactText(first)}));
        QMenu menu;
        on.viewer.files.fillRecent(menu);
        QVERIFY(menu.actions()[1]->isEnabled());
        QVERIFY2(menu.actions()[1]->text().startsWith("n\\xfe.json"), qPrintable(menu.actions()[1]->text()));
        menu.actions()[1]->trigger();
        QVERIFY(on.settled());
        QCOMPARE(shown(on), first);
        QMimeData mime;
        mime.setUrls({QUrl::fromEncoded("file://" + QByteArray::fromStdString(second).toPercentEncoding("/"))});
        QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&on.window, &enter);
        QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&on.window, &drop);
        QVERIFY(eventually([&] { return shown(on) == second && !on.viewer.engine.working(); }));
        mime.setUrls({QUrl("smb://nas/scans/a.pcd")});
        QCoreApplication::sendEvent(&on.window, &enter);
        QCoreApplication::sendEvent(&on.window, &drop);
        QVERIFY(eventually([&] { return on.viewer.notice.text().contains("on another computer, nas"); }));
        // A file dialog of Qt replaces the byte.
        QSignalSpy failures(&on.viewer.engine, &Engine::failed);
        on.viewer.files.open({exactText(place + "/n\xef\xbf\xbd.json")});
        QVERIFY(eventually([&] { return failures.count() == 1; }));
        QVERIFY2(on.viewer.notice.text().contains("does not come through a file dialog"), qPrintable(on.viewer.notice.text()));
    }

    // Also after every kind of work on it: a large scan does not stay in memory while the next one is on the screen.
    void aScanIsFreedWhenAnotherOneIsOpened() {
        const std::string scans[]{(folder_ / "first.json").string(), (folder_ / "second.json").string()};
        for (const std::string& path : scans) QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3), path)));
        WindowFixture on;
        QVERIFY(on.showWith(scans[0]));
        Viewer& v = on.viewer;
        const auto edge = [&] { return on.picture().detection->edges->front(); };
        const struct {
            const char* name;
            std::function<void()> begin;
            std::function<bool()> done;
        } works[]{
            {"nothing", [] {}, [] { return true; }},
            {"colours", [&] { v.look.setColourBy(ColourBy::Range); }, [&] { return v.look.settled(); }},
            {"edge counts", [] {}, [&] { return v.panel.curve("sensitivity")->curve().has_value(); }},
            {"target", [&] { v.views.pin(edge()); }, [&] { return v.targets.settled(); }},
            {"why", [&] { v.explanation.explain(inspect::exactly(edge()), Explanation::Subject::Click); },
             [&] { return v.explanation.card() != nullptr && !v.explanation.card()->text().isEmpty(); }},
            {"lasso", [&] { emit v.views.cloudOutlined(QRectF(v.cloud.rect()), Qt::NoModifier); },
             [&] { return !v.selection.cells().empty(); }},
            {"confidence", [&] { v.confidence.setOn(true); }, [&] { return v.confidence.made() != nullptr; }},
            {"proposals",
             [&] {
                 v.markedEdges.mark(edge(), true);
                 v.markedEdges.propose();
             },
             [&] { return v.markedEdges.settled(); }},
            {"rocks", [&] { v.rocks.setShown(true); }, [&] { return !v.rocks.behind(); }},
            {"rocks that are hidden again", [&] { v.rocks.setShown(false); }, [] { return true; }},
        };
        std::size_t number = 0;
        for (const auto& work : works) {
            work.begin();
            QVERIFY2(eventually(work.done), work.name);
            const std::weak_ptr<const Scan> scan = on.picture().detection->scan;
            QVERIFY(on.open(scans[++number % 2]));
            QVERIFY2(eventually([&] { return scan.expired(); }), work.name);
        }
    }

    void thePictureBeforeIsCalledOldAndStageAndCancelAreShown() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        const QString title = window.windowTitle(), origin = on.viewer.origin.text();
        QStringList wrong;
        int replaced = 0;
        connect(&on.viewer.engine, &Engine::replacingChanged, this, [&](bool replacing) {
            if (!replacing) return;
            ++replaced;
            if (!on.viewer.origin.text().startsWith("OLD PICTURE")) wrong << on.viewer.origin.text();
            if (window.windowTitle() == title) wrong << window.windowTitle();
            const auto* stage = on.viewer.statusLine.findChild<QLabel*>("work-stage");
            const auto* cancel = on.viewer.statusLine.findChild<QPushButton*>("cancel-work");
            if (!stage->isVisible() || stage->text().isEmpty() || !cancel->isVisible()) wrong << "no stage or no Cancel";
        });
        // A pipe that gives no more.
        const std::string pipe = (folder_ / "slow.pcd").string();
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        const int writer = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
        QVERIFY(writer >= 0 && ::write(writer, "# .PCD v0.7\n", 12) == 12);
        on.viewer.files.open({QString::fromStdString(pipe)});
        QVERIFY(eventually([&] { return replaced > 0; }));
        QTest::mouseClick(on.viewer.statusLine.findChild<QPushButton*>("cancel-work"), Qt::LeftButton);
        QVERIFY(eventually([&] { return !on.viewer.engine.working(); }));
        ::close(writer);
        QCOMPARE(window.windowTitle(), title);
        QCOMPARE(on.viewer.origin.text(), origin);
        QVERIFY(!on.viewer.statusLine.findChild<QPushButton*>("cancel-work")->isVisible());
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    // Cancelled after it was read, while its first picture is made: nothing of the new scan is used.
    void aScanWithoutAPictureYetCanBeCancelled() {
        WindowFixture on;
        QVERIFY(on.showWith(real_));
        const auto before = on.viewer.engine.picture();
        QSignalSpy opened(&on.viewer.engine, &Engine::opened);
        bool cancelled = false;
        connect(&on.viewer.engine, &Engine::workProgressed, this, [&](const QString& stage, double) {
            if (stage != "finding edges" || cancelled) return;
            cancelled = true;
            on.viewer.engine.cancel();
        });
        const std::string other = (folder_ / "other-scan.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3, 0.05), other)));
        on.viewer.files.open({QString::fromStdString(other)});
        QVERIFY(eventually([&] { return cancelled; }));
        QVERIFY(!on.viewer.engine.opening() && !on.viewer.engine.behind());
        QCOMPARE(on.viewer.engine.picture(), before);
        QCOMPARE(opened.count(), 0);
        QCOMPARE(on.viewer.files.path(), QString::fromStdString(real_));
        edges::Settings settings = on.viewer.engine.settings();
        settings.lower *= 1.5;
        QVERIFY(on.use(settings));
        QVERIFY2(on.picture().detection->scan == before->detection->scan, "sliders work on the scan that stayed");
    }

    void openingCanBeCancelledAndTheNewestWins() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        const auto before = window.viewer().engine.picture();
        QSignalSpy progress(&window.viewer().engine, &Engine::workProgressed);
        window.viewer().files.openDemo();
        QTRY_VERIFY(progress.count() > 0);
        QVERIFY(window.viewer().engine.working());
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(eventually([&] { return !window.viewer().engine.working(); }));
        QCOMPARE(window.viewer().engine.picture(), before);
        // Two openings in a row: the second one is shown.
        window.viewer().files.openDemo();
        window.viewer().files.open({QString::fromStdString(real_)});
        QVERIFY(eventually([&] { return window.viewer().engine.picture() != before && !window.viewer().engine.working(); }));
        QCOMPARE(QString::fromStdString(window.viewer().engine.picture()->detection->scan->path), QString::fromStdString(real_));
    }

    // The picture shows what was read; a file that another program writes meanwhile is said, and is read again by one click.
    void aFileThatIsWrittenAgainIsSaid() {
        const std::string path = (folder_ / "watched.json").string();
        const auto write = [&](int boxes) { // as another program does: this one replaces no input
            std::filesystem::create_directories(folder_ / "other");
            if (!files::saveScan(test::boxesScan(24, 30, boxes), folder_ / "other/watched.json")) return false;
            for (const char* ending : {".u16", ".json"})
                std::filesystem::rename(folder_ / "other" / (std::string("watched") + ending), folder_ / (std::string("watched") + ending));
            return true;
        };
        QVERIFY(write(3));
        WindowFixture on;
        QVERIFY(on.showWith(path));
        const auto before = on.viewer.engine.picture();
        for (int n = 0; n < 2; ++n) { // each writing replaces the file
            QVERIFY(write(4 + n));
            QTRY_VERIFY2(on.viewer.notice.text().startsWith("watched.json was written again."), qPrintable(on.viewer.notice.text()));
            if (n == 0) {
                QCOMPARE(on.viewer.engine.picture(), before);
                on.viewer.notice.hide();
            }
        }
        QAbstractButton* again = nullptr;
        for (auto* each : on.viewer.notice.findChildren<QAbstractButton*>()) again = each->text() == "Read again" ? each : again;
        QVERIFY(again != nullptr);
        again->click();
        QVERIFY(eventually([&] { return on.viewer.engine.picture() != before; }) && on.settled());
        QVERIFY(on.picture().detection->scan->rangeMm == test::boxesScan(24, 30, 5).rangeMm);
        std::filesystem::remove(path);
        QTRY_VERIFY2(on.viewer.notice.text().startsWith("watched.json was moved or removed."), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.engine.picture() != nullptr);
    }
};

int files_window_test(int argc, char** argv) { return runWindowTest<FilesWindowTest>(argc, argv); }

#include "files_window_test.moc"
