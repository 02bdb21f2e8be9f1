// The real window with real events: the shown data is consistent and equals the result of the command line.
#include "core/edges/settings/command_text.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/edges/settings/slider_scale.h"
#include "core/exports/report.h"
#include "core/files/open_save/save_scan.h"
#include "core/inspect/measure/near_side.h"
#include "tests/support/folders.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/tuning/status_line.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QProcess>
#include <QSignalSpy>
#include <QStyle>
#include <QStyleOptionSlider>

#include <nlohmann/json.hpp>

#include <random>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

// Pure green, the colour of edge points.
int greenPixels(const QImage& image) {
    return countPixels(image, [](QRgb p) { return qGreen(p) > 200 && qRed(p) < 60 && qBlue(p) < 60; });
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

// All widgets show the same frame, and this frame equals the result of edgescan-cli.
void compareWithCommandLine(WindowFixture& on) {
    MainWindow& window = on.window;
    const edges::Detection& detection = *on.picture().detection;
    QCOMPARE(window.viewer().views.edges().image(), on.drawn().edges);
    const std::size_t rims = edges::countClasses(detection)[static_cast<std::size_t>(edges::DepthEdge::VoidRim)]; // not white
    QCOMPARE(countPixels(*window.viewer().views.edges().image(),
                         [](QRgb p) { return p >= qRgb(60, 60, 60) && qRed(p) == qGreen(p) && qGreen(p) == qBlue(p); }),
             static_cast<int>(detection.edges->size() - rims));
    QVERIFY(window.viewer().statusLine.countsShown().contains(
        QLocale(QLocale::English).toString(static_cast<qulonglong>(detection.edges->size())) + " edge cells"));
    const auto run = test::runCli("detect '" + detection.scan->path + "' --json - " + edges::settingsFlags(detection.settings));
    QCOMPARE(run.code, 0);
    const auto report = nlohmann::json::parse(run.out);
    QCOMPARE(report["edges"].get<std::size_t>(), detection.edges->size());
    QCOMPARE(report["edge_mask_sha256"].get<std::string>(), exports::maskSha256(*detection.mask));
}

} // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    std::string real_;

private slots:
    // Undo shows the step that it takes back, in the words of the window. Steps of a scan that was closed are gone.
    void undoNamesWhatItCanUndo() {
        WindowFixture on;
        QVERIFY(on.showWith(usualScan(folder_)));
        const auto undo = [&] { return on.viewer.undo.undoText(); };
        const double before = on.viewer.engine.settings().classes;
        on.viewer.tuning.setParameter("classes", edges::kClassJump | edges::kClassVoidRim);
        QVERIFY2(undo().contains("class convex fold off") && !undo().contains("rim"), qPrintable(undo()));
        on.viewer.tuning.setParameter("classes", edges::kClassJump);
        QCOMPARE(undo(), QString("class void rim off"));
        on.viewer.undo.undo();
        on.viewer.undo.undo();
        QCOMPARE(static_cast<double>(on.viewer.engine.settings().classes), before);
        QVERIFY(on.settled());
        on.viewer.tuning.setParameter("sensitivity", 1.5);
        QVERIFY(on.settled());
        on.viewer.views.pin(on.picture().detection->edges->front());
        on.viewer.selection.select({on.picture().detection->edges->front()});
        QVERIFY(undo().contains("Select"));
        const std::string other = (folder_ / "other.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(40, 60, 3, 0.05), other)));
        QVERIFY(on.open(other));
        QTRY_VERIFY2(undo().contains("Edge strength"), qPrintable(undo()));
        on.viewer.undo.undo();
        QCOMPARE(on.viewer.engine.settings().sensitivity, 1.0);
        QVERIFY(!on.viewer.undo.canUndo());
    }

    void initTestCase() { real_ = usualScan(folder_); }

    void aDraggedSliderChangesImageCloudAndNumbersTogether() {
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().tuning.usePreset(*edges::findPreset("log"));
        QVERIFY(on.showWith(real_));
        compareWithCommandLine(on);
        QTRY_VERIFY(window.viewer().views.cloud().atRest()); // the plates over the cloud have found their places
        const QImage edgesBefore = *window.viewer().views.edges().image();
        const int greenBefore = greenPixels(window.viewer().views.cloud().grabFrame(CloudView::Points::All));
        const QString countsBefore = window.viewer().statusLine.countsShown();
        QVERIFY(greenBefore > 100);

        QSlider* slider = on.slider("lower");
        const QPoint handle = sliderHandle(slider);
        QSignalSpy pictures(&window, &MainWindow::pictureShown);
        QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, handle);
        for (int x = 2; x <= 60; x += 2) {
            // QTest::mouseMove() would move the cursor without the pressed button.
            const QPoint at = handle + QPoint(x, 0);
            QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(slider, &move);
            QVERIFY(on.settled());
        }
        QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, handle + QPoint(60, 0));
        QVERIFY(on.settled());
        QVERIFY2(pictures.count() > 5, "the views follow while the slider moves, not only at the end");
        QVERIFY(window.viewer().engine.settings().lower > 20.0);
        QCOMPARE(window.viewer().engine.picture()->detection->settings.lower, window.viewer().panel.row("lower")->number()->value());
        QVERIFY(*window.viewer().views.edges().image() != edgesBefore);
        QVERIFY(greenPixels(window.viewer().views.cloud().grabFrame(CloudView::Points::All)) < greenBefore);
        QVERIFY(window.viewer().statusLine.countsShown() != countsBefore);
        compareWithCommandLine(on);

        // One drag is one undo step.
        QVERIFY(on.activate());
        QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(on.settled());
        QCOMPARE(*window.viewer().views.edges().image(), edgesBefore);
        QCOMPARE(window.viewer().statusLine.countsShown(), countsBefore);
        QTRY_VERIFY(window.viewer().views.cloud().atRest());
        QCOMPARE(greenPixels(window.viewer().views.cloud().grabFrame(CloudView::Points::All)), greenBefore);
    }

    void twoHundredRandomMovesEndOnTheLastValue() {
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().tuning.usePreset(*edges::findPreset("log"));
        QVERIFY(on.showWith(real_));
        std::mt19937 random(5);
        QSlider* slider = on.slider("lower");
        for (int move = 0; move < 200; ++move) {
            slider->setValue(static_cast<int>(random() % 1001));
            QCoreApplication::processEvents();
        }
        const double last = edges::sliderValue(window.viewer().panel.row("lower")->parameter(), slider->value());
        QVERIFY(on.settled());
        QCOMPARE(window.viewer().engine.settings().lower, last);
        QCOMPARE(window.viewer().engine.picture()->detection->settings.lower, last);
        QCOMPARE(window.viewer().panel.row("lower")->number()->value(), last);
        compareWithCommandLine(on);
    }

    void hoverInOneImageShowsTheSameCellEverywhere() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.showWith(real_));
        const edges::Detection& detection = *on.picture().detection;
        const std::uint32_t k = (*detection.edges)[detection.edges->size() / 2];
        const QPoint cell(static_cast<int>(k) % detection.scan->beams(), static_cast<int>(k) / detection.scan->beams());
        ImageView& gray = window.viewer().views.gray();
        const QPoint pixel = gray.viewPort()->toPixel(QPointF(cell) + QPointF(0.5, 0.5), gray.size()).toPoint();
        QTest::mouseMove(&gray, pixel - QPoint(20, 0));
        QTest::mouseMove(&gray, pixel);
        // A view pixel may cover more than one cell; the event of the previous move may still be pending.
        const auto marks = [&] {
            return window.viewer().views.edges().markedCell() &&
                   (*window.viewer().views.edges().markedCell() - cell).manhattanLength() <= 2;
        };
        QTRY_VERIFY(marks());
        const QPoint marked = *window.viewer().views.edges().markedCell();
        QTRY_VERIFY(window.viewer().views.cloud().markedCell().has_value());
        QCOMPARE(static_cast<int>(*window.viewer().views.cloud().markedCell()), marked.y() * detection.scan->beams() + marked.x());
        const QString probe = window.viewer().statusLine.probeShown();
        QVERIFY2(probe.contains(QString("  line %1  beam %2  ").arg(marked.y()).arg(marked.x())), qPrintable(probe));
        QVERIFY(probe.contains("gray"));

        // A click fixes the crosshair, at an edge near the pointer or its near side, and Esc removes it.
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::NoModifier, pixel);
        const QPoint fixed = *window.viewer().views.edges().crosshair();
        const int beams = detection.scan->beams();
        const auto clicked = static_cast<std::uint32_t>(marked.y() * beams + marked.x());
        const auto means = static_cast<int>(inspect::nearSideEdge(*detection.scan, *detection.mask, clicked).cell);
        QCOMPARE(fixed, QPoint(means % beams, means / beams));
        QVERIFY((fixed - marked).manhattanLength() <= 6);
        window.viewer().notice.hide(); // Esc would first close the notice about the interlaced beams of the real scan
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!window.viewer().views.edges().crosshair().has_value());
    }

    void settingsAndLayoutSurviveAKill() {
        const QString ini = QString::fromStdString((folder_ / "viewer.ini").string());
        // Not closed before the copy is made: after a kill only the data on the disk exists.
        WindowFixture on(ini);
        MainWindow& window = on.window;
        QVERIFY(on.show());
        window.resize(1234, 777);
        QVERIFY(on.open(real_));
        window.viewer().panel.row("lower")->number()->setValue(42.0);
        on.slider("kernel")->setValue(2); // 5 cells
        window.viewer().panel.setRatioLocked(false);
        window.viewer().panel.row("ratio")->number()->setValue(2.5);
        QString killed;
        int copies = 0;
        const auto copied = [&] { // a new name each time: Qt caches files that it read
            killed = QString("%1.%2").arg(ini).arg(++copies);
            QFile::copy(ini, killed);
            const Preferences there(killed);
            return there.bytes("window/geometry") == window.saveGeometry() && there.settings(edges::Settings{}).ratio == 2.5;
        };
        QTRY_VERIFY(copied());

        WindowFixture again(killed);
        QVERIFY(again.show());
        const edges::Settings& settings = again.window.viewer().engine.settings();
        QCOMPARE(settings.lower, 42.0);
        QCOMPARE(settings.kernel, 5);
        QCOMPARE(settings.ratio, 2.5);
        QVERIFY(!again.window.viewer().panel.ratioLocked());
        QCOMPARE(again.window.size(), QSize(1234, 777));
        QCOMPARE(again.preferences.recentFiles(), QStringList(QFileInfo(QString::fromStdString(real_)).absoluteFilePath()));
    }

    void whatTheCommandLineAskedForIsNotRemembered() {
        const QString ini = QString::fromStdString((folder_ / "asked.ini").string());
        edges::Settings own;
        own.creaseDeg = 50;
        {
            WindowFixture on(ini);
            MainWindow& window = on.window;
            window.viewer().tuning.useSettings(own);
        }
        const edges::Preset thesis = *edges::findPreset("thesis");
        {
            WindowFixture on(ini);
            MainWindow& window = on.window;
            QVERIFY(window.viewer().engine.settings() == own);
            edges::Settings asked = thesis.settings;
            asked.lower = 33;
            window.viewer().tuning.startWith(thesis, asked);
            QVERIFY(window.viewer().engine.settings() == asked);
            QCOMPARE(QString::fromStdString(window.viewer().panel.preset().name), QString("thesis"));
            window.close();
        }
        {
            WindowFixture on(ini);
            MainWindow& window = on.window;
            QVERIFY(window.viewer().engine.settings() == own);
            QVERIFY(window.viewer().panel.preset().name != "thesis");
        }
        // The same from the program itself.
        const QString config = QString::fromStdString((folder_ / "config").string());
        QProcess viewer;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_CONFIG_HOME", config);
        viewer.setProcessEnvironment(environment);
        viewer.start(QString::fromStdString(test::programFolder()) + "/edgescan",
                     {"--preset", "thesis", "--screenshot", config + ".png", QString::fromStdString(real_)});
        QVERIFY(viewer.waitForFinished(kPatienceMs));
        QCOMPARE(viewer.exitCode(), 0);
        QVERIFY(Preferences(config + "/edgescan/viewer.ini").settings(own) == own);
    }

    void aSingleEditIsAStepOfItsOwn() {
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().tuning.usePreset(*edges::findPreset("log"));
        QVERIFY(on.show());
        window.viewer().panel.row("kernel")->choice()->setCurrentIndex(3); // 7 cells
        QSlider* slider = on.slider("lower");
        slider->setSliderDown(true);
        slider->setValue(300);
        slider->setValue(400);
        slider->setSliderDown(false);
        QVERIFY(window.viewer().engine.settings().lower > 20);
        QCOMPARE(window.viewer().engine.settings().kernel, 7);
        QUndoStack& undo = window.viewer().undo;
        undo.undo();
        QCOMPARE(window.viewer().engine.settings().lower, edges::Settings{}.lower);
        QCOMPARE(window.viewer().engine.settings().kernel, 7);
        undo.undo();
        QCOMPARE(window.viewer().engine.settings().kernel, edges::Settings{}.kernel);
    }

    void theCloudIsCompleteOnceItRests() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        const std::string large = (folder_ / "complete.json").string();
        QVERIFY(files::saveScan(test::boxesScan(800, 900, 1), large));
        QVERIFY(on.open(large));
        QVERIFY(eventually([&] { return window.viewer().views.cloud().drawnFraction() < 1.0; })); // coarse first
        QVERIFY(eventually([&] { return window.viewer().views.cloud().drawnFraction() >= 1.0; }));
        // The parts drawn one after the other give the same picture as one frame.
        const QImage grown = window.viewer().views.cloud().grabFrame();
        const QImage whole = window.viewer().views.cloud().grabFrame(CloudView::Points::All);
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

    void aPresetIsOneClickAndItsChangesAreMarked() {
        WindowFixture on;
        MainWindow& window = on.window;
        window.viewer().tuning.usePreset(*edges::findPreset("log"));
        QVERIFY(on.showWith(real_));
        auto* presets = window.viewer().panel.findChild<QComboBox*>("presets");
        QVERIFY(presets != nullptr);
        presets->setCurrentText("Thesis");
        emit presets->activated(presets->currentIndex());
        QVERIFY(on.settled());
        QVERIFY(window.viewer().engine.picture()->detection->settings == edges::findPreset("thesis")->settings);
        QVERIFY(!window.viewer().panel.modified());
        compareWithCommandLine(on);
        window.viewer().panel.row("lower")->number()->setValue(33);
        QVERIFY(window.viewer().panel.modified());
        // A double-click on the slider restores the preset's value.
        QTest::mouseDClick(on.slider("lower"), Qt::LeftButton);
        QCOMPARE(window.viewer().engine.settings().lower, 10.0);
        QVERIFY(!window.viewer().panel.modified());
    }
};

int main_window_test(int argc, char** argv) { return runWindowTest<MainWindowTest>(argc, argv); }

#include "main_window_test.moc"
