// The real window, driven by real events: what it shows belongs together and equals what the command line computes.
#include "core/io/save_scan.h"
#include "core/report/report.h"
#include "core/settings/parameters.h"
#include "core/settings/presets.h"
#include "core/sim/simulate.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "ui/base/notice_bar.h"
#include "ui/cloud/cloud_view.h"
#include "ui/image/image_view.h"
#include "ui/image/viewport.h"
#include "ui/main/main_window.h"
#include "ui/panel/edges_panel.h"
#include "ui/panel/parameter_row.h"
#include "ui/panel/status_line.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QMimeData>
#include <QProcess>
#include <QSignalSpy>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <QUndoStack>
#include <QtTest>

#include <nlohmann/json.hpp>

#include <fstream>
#include <random>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

// Pure green as drawn for edge points.
int greenPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += c.green() > 200 && c.red() < 60 && c.blue() < 60 ? 1 : 0;
        }
    }
    return count;
}

int whitePixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == qRgb(255, 255, 255) ? 1 : 0;
    }
    return count;
}

QPoint sliderHandle(QSlider* slider) {
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = slider->sliderPosition();
    option.sliderValue = slider->value();
    option.orientation = slider->orientation();
    option.subControls = QStyle::SC_All;
    return slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider).center();
}

} // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    std::string real_; // a real corridor scan, or a simulated one where ../shared is absent

    static bool waitForPicture(MainWindow& window) {
        return QTest::qWaitFor(
            [&] { return window.session().picture() != nullptr && !window.session().behind() && !window.session().working(); }, 20000);
    }

    // Everything on the screen tells of the same frame, and that frame is what edgescan-cli computes.
    void compareWithCommandLine(MainWindow& window) {
        const Detection& detection = *window.session().picture()->detection;
        QCOMPARE(window.edgeView().image(), window.session().picture()->edges);
        QCOMPARE(whitePixels(*window.edgeView().image()), static_cast<int>(detection.edges->size()));
        QVERIFY(window.statusLine().countsShown().contains(
            QLocale(QLocale::English).toString(static_cast<qulonglong>(detection.edges->size())) + " edges"));
        std::string flags;
        const nlohmann::json settings = settingsToJson(detection.settings);
        for (const auto& [key, value] : settings.items())
            flags += " --" + key + " " + (value.is_string() ? value.get<std::string>() : value.dump());
        const auto run = test::runCli("detect '" + detection.scan->path + "' --json -" + flags);
        QCOMPARE(run.code, 0);
        const auto report = nlohmann::json::parse(run.out);
        QCOMPARE(report["edges"].get<std::size_t>(), detection.edges->size());
        QCOMPARE(report["edge_mask_sha256"].get<std::string>(), maskSha256(*detection.mask));
    }

private slots:
    void initTestCase() {
        real_ = std::string(EDGESCAN_SHARED_DIR) + "/data/lms200_corridor/scan000.json";
        if (std::filesystem::exists(real_)) return;
        qWarning("../shared is absent: a simulated scan stands in for the real one");
        SimulationSettings settings;
        settings.lines = 200;
        settings.beams = 300;
        real_ = (folder_ / "simulated.json").string();
        QVERIFY(saveScan(simulate(settings)->scan, real_));
    }

    void aDraggedSliderChangesImageCloudAndNumbersTogether() {
        Memory none{QString()};
        MainWindow window(none);
        window.usePreset(*findPreset("log"));
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        QTest::qWait(300);
        compareWithCommandLine(window);
        const QImage edgesBefore = *window.edgeView().image();
        const int greenBefore = greenPixels(window.cloudView().grabFrame(CloudView::Points::All));
        const QString countsBefore = window.statusLine().countsShown();
        QVERIFY(greenBefore > 100);

        QSlider* slider = window.panel().row("lower")->slider();
        const QPoint handle = sliderHandle(slider);
        QSignalSpy pictures(&window, &MainWindow::pictureShown);
        QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, handle);
        for (int x = 2; x <= 60; x += 2) {
            // QTest::mouseMove() moves the cursor without the button held down.
            const QPoint at = handle + QPoint(x, 0);
            QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(slider, &move);
            QTest::qWait(10);
        }
        QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, handle + QPoint(60, 0));
        QVERIFY(waitForPicture(window));
        QVERIFY2(pictures.count() > 5, "the views follow while the slider moves, not only at the end");
        QVERIFY(window.session().settings().lower > 20.0);
        QCOMPARE(window.session().picture()->detection->settings.lower, window.panel().row("lower")->number()->value());
        QVERIFY(*window.edgeView().image() != edgesBefore);
        QVERIFY(greenPixels(window.cloudView().grabFrame(CloudView::Points::All)) < greenBefore);
        QVERIFY(window.statusLine().countsShown() != countsBefore);
        compareWithCommandLine(window);

        // One drag is one step of undo.
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(waitForPicture(window));
        QCOMPARE(*window.edgeView().image(), edgesBefore);
        QCOMPARE(window.statusLine().countsShown(), countsBefore);
        QCOMPARE(greenPixels(window.cloudView().grabFrame(CloudView::Points::All)), greenBefore);
    }

    void twoHundredRandomMovesEndOnTheLastValue() {
        Memory none{QString()};
        MainWindow window(none);
        window.usePreset(*findPreset("log"));
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        std::mt19937 random(5);
        QSlider* slider = window.panel().row("lower")->slider();
        QElapsedTimer clock;
        clock.start();
        for (int move = 0; move < 200; ++move) {
            slider->setValue(static_cast<int>(random() % 1001));
            while (clock.elapsed() < move * 10) QTest::qWait(1);
        }
        const double last = sliderValue(window.panel().row("lower")->parameter(), slider->value());
        QVERIFY(waitForPicture(window));
        QCOMPARE(window.session().settings().lower, last);
        QCOMPARE(window.session().picture()->detection->settings.lower, last);
        QCOMPARE(window.panel().row("lower")->number()->value(), last);
        compareWithCommandLine(window);
    }

    void hoverInOneImageShowsTheSameCellEverywhere() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        QTest::qWait(200);
        const Detection& detection = *window.session().picture()->detection;
        const std::uint32_t k = (*detection.edges)[detection.edges->size() / 2];
        const QPoint cell(static_cast<int>(k) % detection.scan->beams(), static_cast<int>(k) / detection.scan->beams());
        ImageView& gray = window.grayView();
        const QPoint pixel = gray.viewPort()->toPixel(QPointF(cell) + QPointF(0.5, 0.5), gray.size()).toPoint();
        QTest::mouseMove(&gray, pixel - QPoint(20, 0));
        QTest::mouseMove(&gray, pixel);
        // A view pixel may cover more than one cell; the move to the place before may still be on its way.
        const auto marks = [&] {
            return window.edgeView().markedCell() && (*window.edgeView().markedCell() - cell).manhattanLength() <= 2;
        };
        QTRY_VERIFY(marks());
        const QPoint marked = *window.edgeView().markedCell();
        QTRY_VERIFY(window.cloudView().markedCell().has_value());
        QCOMPARE(static_cast<int>(*window.cloudView().markedCell()), marked.y() * detection.scan->beams() + marked.x());
        const QString probe = window.statusLine().probeShown();
        QVERIFY2(probe.startsWith(QString("line %1  beam %2").arg(marked.y()).arg(marked.x())), qPrintable(probe));
        QVERIFY(probe.contains("gray"));

        // A click sticks, Esc takes it away.
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::NoModifier, pixel);
        QCOMPARE(*window.edgeView().crosshair(), marked);
        window.notice().hide(); // Esc would close it first: the beams of the real scan are interlaced, and it says so
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!window.edgeView().crosshair().has_value());
    }

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
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        const auto before = window.session().picture();
        const QString path = QString::fromStdString(folder_.path().string()) + "/" + name;
        if (!content.startsWith('\x01')) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        }
        QSignalSpy failures(&window.session(), &Session::failed);
        window.openFile(path);
        QVERIFY(QTest::qWaitFor([&] { return failures.count() == 1; }, 10000));
        QVERIFY(window.notice().isVisible());
        QCOMPARE(window.notice().kind(), NoticeBar::Kind::Error);
        QVERIFY2(window.notice().text().contains(name.section('.', 0, 0)), qPrintable(window.notice().text()));
        QTest::qWait(50);
        QCOMPARE(window.session().picture(), before);
        QCOMPARE(window.edgeView().image(), before->edges);
        QCOMPARE(window.windowTitle(), QString::fromStdString(before->detection->scan->name) + " - EdgeScan");
    }

    void settingsAndLayoutSurviveAKill() {
        const QString ini = QString::fromStdString((folder_ / "viewer.ini").string());
        // Left on the heap and never closed: what a kill leaves behind is what was on the disk by then.
        auto* memory = new Memory(ini);
        auto* window = new MainWindow(*memory);
        window->show();
        window->resize(1234, 777);
        window->openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(*window));
        window->panel().row("lower")->number()->setValue(42.0);
        window->panel().row("kernel")->slider()->setValue(2); // 5 cells
        window->panel().setRatioLocked(false);
        window->panel().row("ratio")->number()->setValue(2.5);
        QTest::qWait(800);
        QVERIFY(QFile::copy(ini, ini + ".killed"));

        Memory after(ini + ".killed");
        MainWindow again(after);
        again.show();
        QCOMPARE(again.session().settings().lower, 42.0);
        QCOMPARE(again.session().settings().kernel, 5);
        QCOMPARE(again.session().settings().ratio, 2.5);
        QVERIFY(!again.panel().ratioLocked());
        QCOMPARE(again.size(), QSize(1234, 777));
        QCOMPARE(after.recentFiles(), QStringList(QFileInfo(QString::fromStdString(real_)).absoluteFilePath()));
        delete window;
        delete memory;
    }

    void whatTheCommandLineAskedForIsNotRemembered() {
        const QString ini = QString::fromStdString((folder_ / "asked.ini").string());
        Settings own;
        own.creaseDeg = 50;
        {
            Memory memory(ini);
            MainWindow window(memory);
            window.useSettings(own);
            memory.write();
        }
        const Preset thesis = *findPreset("thesis");
        {
            Memory memory(ini);
            MainWindow window(memory);
            QVERIFY(window.session().settings() == own);
            Settings asked = thesis.settings;
            asked.lower = 33;
            window.startWith(thesis, asked);
            QVERIFY(window.session().settings() == asked);
            QCOMPARE(QString::fromStdString(window.panel().preset().name), QString("thesis"));
            window.close();
        }
        {
            Memory memory(ini);
            MainWindow window(memory);
            QVERIFY(window.session().settings() == own);
            QVERIFY(window.panel().preset().name != "thesis");
        }
        // From the program itself, too.
        const QString config = QString::fromStdString((folder_ / "config").string());
        QProcess viewer;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_CONFIG_HOME", config);
        viewer.setProcessEnvironment(environment);
        viewer.start(QString::fromUtf8(EDGESCAN_BIN_DIR) + "/edgescan",
                     {"--preset", "thesis", "--quit-after", "1", QString::fromStdString(real_)});
        QVERIFY(viewer.waitForFinished(30000));
        QCOMPARE(viewer.exitCode(), 0);
        QVERIFY(Memory(config + "/edgescan/viewer.ini").settings(own) == own);
    }

    void beamsThatLieElsewhereAreToldAndStraightened() {
        SimulationSettings settings;
        settings.lines = 250;
        settings.beams = 286;
        settings.seed = 3;
        settings.interlaceDeg = 0.36;
        const std::string path = (folder_ / "interlaced.json").string();
        QVERIFY(bool(saveScan(simulate(settings)->scan, path)));
        Memory memory{QString()};
        MainWindow window(memory);
        window.resize(1300, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.openFile(QString::fromStdString(path));
        QVERIFY(waitForPicture(window));
        QVERIFY2(window.notice().text().contains("degrees ahead of even ones"), qPrintable(window.notice().text()));
        auto* straighten = window.findChild<QAction*>("straighten-beams");
        QVERIFY(straighten != nullptr && !straighten->isChecked());
        const auto skew = [&] { return std::get<PolarGeometry>(window.session().picture()->detection->scan->geometry).lineSkewDeg; };
        const auto tilted = [&] { return !skew().empty() && std::abs(skew()[1] - skew()[0]) > 0.2; };
        QVERIFY(!tilted());
        // The button in the note does it ...
        auto* offered = window.notice().findChild<QToolButton*>("notice-action");
        QVERIFY(offered != nullptr && offered->isVisible());
        QTest::mouseClick(offered, Qt::LeftButton);
        QVERIFY(waitForPicture(window));
        QVERIFY(QTest::qWaitFor(tilted, 20000));
        QVERIFY(straighten->isChecked());
        QVERIFY2(window.notice().text().contains("Straightened: odd beams lie 0.3"), qPrintable(window.notice().text()));
        // ... and the menu takes it back.
        straighten->trigger();
        QVERIFY(QTest::qWaitFor([&] { return !tilted(); }, 20000));
        QVERIFY(waitForPicture(window));
        QVERIFY(!straighten->isChecked());
        straighten->trigger();
        QVERIFY(QTest::qWaitFor(tilted, 20000));
        // Another file starts as it was recorded.
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        QVERIFY(!straighten->isChecked());
    }

    void exportsEqualThoseOfTheCommandLine() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        using Export = Session::Export;
        const std::vector<std::tuple<Export, const char*, const char*>> exports{
            {Export::EdgeCloud, "edges.pcd", "--edges"}, {Export::EdgeCloud, "edges.ply", "--edges"},
            {Export::EdgeCloud, "edges.csv", "--edges"}, {Export::FullCloud, "cloud.pcd", "--cloud"},
            {Export::EdgeImage, "mask.png", "--mask"},   {Export::GrayImage, "gray.png", "--gray"},
            {Export::RangeImage, "range.png", "--range"}};
        for (const auto& [what, name, flag] : exports) {
            QSignalSpy saved(&window.session(), &Session::saved);
            const std::string path = (folder_ / name).string();
            window.session().save(what, QString::fromStdString(path));
            QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1 && !window.session().working(); }, 10000));
            const std::string other = (folder_ / (std::string("cli-") + name)).string();
            QCOMPARE(test::runCli("detect '" + real_ + "' " + flag + " " + other).code, 0);
            QVERIFY2(test::fileText(path) == test::fileText(other), name);
            QVERIFY(!test::fileText(path).empty());
        }
        // A failed export names the path and leaves nothing behind.
        QSignalSpy failures(&window.session(), &Session::failed);
        window.session().save(Export::EdgeCloud, "/nonexistent-folder/e.pcd");
        QVERIFY(QTest::qWaitFor([&] { return failures.count() == 1; }, 10000));
        QVERIFY(window.notice().text().contains("/nonexistent-folder/e.pcd"));
    }

    void aSmallerScanUnderTheMouseIsShown() {
        const std::string large = (folder_ / "large.json").string();
        const std::string small = (folder_ / "small.json").string();
        QVERIFY(saveScan(test::boxesScan(1500, 1500, 1), large));
        QVERIFY(saveScan(test::boxesScan(4, 4, 1), small));
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(large));
        QVERIFY(waitForPicture(window));
        emit window.grayView().hovered(1499, 1499);
        emit window.grayView().clicked(1499, 1499);
        QVERIFY(!window.statusLine().probeShown().isEmpty());
        window.openFile(QString::fromStdString(small));
        QVERIFY(QTest::qWaitFor([&] { return window.session().picture()->detection->scan->lines() == 4; }, 20000));
        QVERIFY(window.statusLine().probeShown().isEmpty());
    }

    void aSingleEditIsAStepOfItsOwn() {
        Memory none{QString()};
        MainWindow window(none);
        window.usePreset(*findPreset("log"));
        window.show();
        window.panel().row("kernel")->choice()->setCurrentIndex(3); // 7 cells
        QSlider* slider = window.panel().row("lower")->slider();
        slider->setSliderDown(true);
        slider->setValue(300);
        slider->setValue(400);
        slider->setSliderDown(false);
        QVERIFY(window.session().settings().lower > 20);
        QCOMPARE(window.session().settings().kernel, 7);
        auto* undo = window.findChild<QUndoStack*>();
        undo->undo();
        QCOMPARE(window.session().settings().lower, Settings{}.lower);
        QCOMPARE(window.session().settings().kernel, 7);
        undo->undo();
        QCOMPARE(window.session().settings().kernel, Settings{}.kernel);
    }

    void aSeriesGoesOnBehindABadFile() {
        const std::string second = (folder_ / "series2.json").string();
        const std::string bad = (folder_ / "series-bad.json").string();
        QVERIFY(saveScan(test::boxesScan(30, 40, 8), second));
        std::ofstream(bad) << "no scan";
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openSeries({QString::fromStdString(real_), QString::fromStdString(bad), QString::fromStdString(second)});
        QVERIFY(waitForPicture(window));
        QVERIFY(window.windowTitle().contains("(1 of 3)"));
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QSignalSpy failures(&window.session(), &Session::failed);
        QTest::keyClick(&window, Qt::Key_PageDown);
        QVERIFY(QTest::qWaitFor([&] { return failures.count() == 1 && !window.session().working(); }, 10000));
        QTest::keyClick(&window, Qt::Key_PageDown);
        QVERIFY(QTest::qWaitFor([&] { return window.session().picture()->detection->scan->lines() == 30; }, 10000));
        QVERIFY(window.windowTitle().contains("(3 of 3)"));
    }

    void aFailingSaveIsToldEvenWhileAScanOpens() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        QSignalSpy failures(&window.session(), &Session::failed);
        window.session().save(Session::Export::EdgeCloud, "/nonexistent-folder/e.pcd");
        window.openFile(QString::fromStdString(real_));
        QVERIFY(QTest::qWaitFor([&] { return failures.count() == 1 && !window.session().working(); }, 10000));
    }

    void theCloudIsCompleteOnceItRests() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        const std::string large = (folder_ / "complete.json").string();
        QVERIFY(saveScan(test::boxesScan(800, 900, 1), large));
        window.openFile(QString::fromStdString(large));
        QVERIFY(waitForPicture(window));
        QVERIFY(QTest::qWaitFor([&] { return window.cloudView().drawnFraction() < 1.0; }, 15000)); // coarse first
        QVERIFY(QTest::qWaitFor([&] { return window.cloudView().drawnFraction() >= 1.0; }, 15000));
        // Part after part on top of each other gives the picture that one single frame gives.
        const QImage grown = window.cloudView().grabFrame();
        const QImage whole = window.cloudView().grabFrame(CloudView::Points::All);
        if (const QByteArray pictures = qgetenv("EDGESCAN_PICTURES"); !pictures.isEmpty()) {
            grown.save(pictures + "/cloud_grown.png");
            whole.save(pictures + "/cloud_whole.png");
        }
        int different = 0;
        for (int y = 0; y < whole.height(); ++y) {
            for (int x = 0; x < whole.width(); ++x) different += whole.pixel(x, y) != grown.pixel(x, y) ? 1 : 0;
        }
        QVERIFY2(different < whole.width() * whole.height() / 200, qPrintable(QString::number(different)));
    }

    void aDroppedFileIsOpened() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        QMimeData mime;
        mime.setUrls({QUrl::fromLocalFile(QString::fromStdString(real_))});
        QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &drop);
        QVERIFY(waitForPicture(window));
        QCOMPARE(QString::fromStdString(window.session().picture()->detection->scan->path), QString::fromStdString(real_));
    }

    void openingCanBeCancelledAndTheNewestWins() {
        Memory none{QString()};
        MainWindow window(none);
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        const auto before = window.session().picture();
        qputenv("XDG_CACHE_HOME", QByteArray::fromStdString((folder_ / "cache").string())); // no demo in the cache: it must be made
        window.openDemo();
        QTest::qWait(150);
        QVERIFY(window.session().working());
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(QTest::qWaitFor([&] { return !window.session().working(); }, 10000));
        QCOMPARE(window.session().picture(), before);
        // Two in a row: the second one is shown.
        window.openDemo();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(QTest::qWaitFor([&] { return window.session().picture() != before && !window.session().working(); }, 20000));
        QCOMPARE(QString::fromStdString(window.session().picture()->detection->scan->path), QString::fromStdString(real_));
    }

    void aPresetIsOneClickAndItsChangesAreMarked() {
        Memory none{QString()};
        MainWindow window(none);
        window.usePreset(*findPreset("log"));
        window.show();
        window.openFile(QString::fromStdString(real_));
        QVERIFY(waitForPicture(window));
        auto* presets = window.panel().findChild<QComboBox*>("presets");
        QVERIFY(presets != nullptr);
        presets->setCurrentText("thesis");
        emit presets->activated(presets->currentIndex());
        QVERIFY(waitForPicture(window));
        QVERIFY(window.session().picture()->detection->settings == findPreset("thesis")->settings);
        QVERIFY(!window.panel().modified());
        compareWithCommandLine(window);
        window.panel().row("lower")->number()->setValue(33);
        QVERIFY(window.panel().modified());
        // A double-click on the slider goes back to the preset's value.
        QTest::mouseDClick(window.panel().row("lower")->slider(), Qt::LeftButton);
        QCOMPARE(window.session().settings().lower, 10.0);
        QVERIFY(!window.panel().modified());
    }
};

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat());
    QApplication application(argc, argv);
    MainWindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "main_window_test.moc"
