// The pose of a scan in the window, and the dialog before an export.
#include "core/edges/pipeline/pipeline.h"
#include "core/scan/georef/placed_points.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/export_dialog.h"
#include "ui/panels/dialogs/place_dialog.h"
#include "ui/panels/tuning/status_line.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

QRadioButton& choice(ExportDialog& dialog, const char* name) { return *dialog.findChild<QRadioButton*>(name); }

std::shared_ptr<const edges::Detection> detectionOf(const Scan& scan) {
    return edges::detectEdges(std::make_shared<const Scan>(scan), edges::Settings{});
}

} // namespace

class PlaceExportTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string placed_, bare_;

private slots:
    void initTestCase() {
        Scan scan = test::boxesScan(60, 80, 3, 0.05);
        bare_ = (folder_ / "bare.json").string();
        QVERIFY(files::saveScan(scan, bare_));
        scan.placement = test::randomPlacement(3, 1, true);
        placed_ = (folder_ / "placed.json").string();
        QVERIFY(files::saveScan(scan, placed_));
    }

    void statusAndProbeTellTheMineGrid() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        QVERIFY(on.open(placed_));
        QCOMPARE(window.viewer().statusLine.placeShown(), QString("mine grid UTM 17N · origin E 620000 N 6200000 RL 250"));
        QVERIFY(window.viewer().notice.text().contains("The pose carries no time"));
        emit window.viewer().views.gray().clicked(30, 40);
        const Scan& scan = *on.picture().detection->scan;
        const std::size_t k = window.viewer().views.nearSideCell(scan.rangeMm.index(30, 40)).cell;
        QCOMPARE(scan.state[k], CellState::Valid);
        const Eigen::Vector3d mine = minePoint(scan, k).enhM;
        const QString expected = QString("E %1  N %2  RL %3").arg(mine.x(), 0, 'f', 3).arg(mine.y(), 0, 'f', 3).arg(mine.z(), 0, 'f', 3);
        QVERIFY2(window.viewer().statusLine.probeShown().contains(expected), qPrintable(window.viewer().statusLine.probeShown()));
        QVERIFY(on.open(bare_));
        QCOMPARE(window.viewer().statusLine.placeShown(), QString::fromUtf8("▲ no pose"));
        QCOMPARE(window.viewer().statusLine.recordedShown(), QString());
        emit window.viewer().views.gray().clicked(30, 40);
        QVERIFY2(window.viewer().statusLine.probeShown().startsWith("Pinned nearby: x "),
                 qPrintable(window.viewer().statusLine.probeShown()));
        QTest::mouseClick(tool(window, "no-pose"), Qt::LeftButton);
        auto* form = window.findChild<PlaceDialog*>();
        QVERIFY(form != nullptr && form->isVisible());
        form->reject();
        // The place of a scan that has a pose opens it, too.
        QVERIFY(on.open(placed_));
        auto* place = window.viewer().statusLine.findChild<QLabel*>("place");
        QTRY_VERIFY(place->isVisible());
        QTest::mouseClick(place, Qt::LeftButton);
        QVERIFY(form->isVisible());
    }

    // A drawing has its own command, and the tool bar has all exports; without a scan they are off.
    void everyExportIsInTheMenuOfTheToolBar() {
        WindowFixture on;
        QVERIFY(on.show());
        QVERIFY(!tool(on.window, "tool-export")->isEnabled());
        QVERIFY(on.open(bare_));
        QToolButton* exports = tool(on.window, "tool-export");
        QVERIFY(exports->isEnabled());
        QAction* drawing = nullptr;
        for (QAction* each : exports->menu()->actions()) drawing = each->text().contains("DXF") ? each : drawing;
        QVERIFY(drawing != nullptr && drawing->isEnabled());
        QString format;
        QTimer::singleShot(0, [&format] {
            auto* dialog = qobject_cast<ExportDialog*>(QApplication::activeModalWidget());
            format = dialog->extension();
            dialog->reject();
        });
        drawing->trigger();
        QCOMPARE(format, QString(".dxf"));
    }

    void withoutAPoseTheMineGridCannotBeChosen() {
        const auto detection = detectionOf(*files::openScan(bare_));
        ExportDialog dialog(detection, exports::ExportContent::EdgeCloud);
        QVERIFY(!choice(dialog, "mine").isEnabled());
        QVERIFY(!choice(dialog, "local").isEnabled());
        QVERIFY(choice(dialog, "scanner").isChecked());
        QVERIFY(dialog.findChild<QLabel*>("reason")->text().contains("the scan has no pose"));
        QCOMPARE(dialog.options().frame, CoordinateFrame::Scanner);
        QVERIFY(dialog.findChild<QCheckBox*>("attached")->isHidden());
    }

    void everyQuestionIsInSight() {
        for (const auto& file : {bare_, placed_}) { // with and without the text about the mine grid
            ExportDialog dialog(detectionOf(*files::openScan(file)), exports::ExportContent::EdgeCloud);
            dialog.offerFormats({{"Point Cloud Library (*.pcd)", ".pcd"}, {"Polygon (*.ply)", ".ply"}}, ".pcd");
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog, kPatienceMs));
            const auto* area = dialog.findChild<QScrollArea*>();
            QTRY_COMPARE(area->verticalScrollBar()->maximum(), 0);
            QVERIFY2(dialog.height() <= 700, qPrintable(QString::number(dialog.height())));
            QTest::mouseClick(dialog.findChild<QAbstractButton*>("for-program"), Qt::LeftButton);
            const int room = QGuiApplication::primaryScreen()->availableSize().height() - 100;
            if (dialog.height() < room) QTRY_COMPARE(area->verticalScrollBar()->maximum(), 0);
        }
    }

    void theCountIsThatOfTheFile() {
        const auto detection = detectionOf(*files::openScan(placed_));
        ExportDialog dialog(detection, exports::ExportContent::EdgeCloud);
        QVERIFY(choice(dialog, "mine").isChecked());
        QVERIFY(dialog.findChild<QLabel*>("reason") == nullptr);
        auto* count = dialog.findChild<QLabel*>("count");
        const std::vector<std::pair<const char*, const char*>> contents{{"edges", "e.csv"}, {"cloud", "a.csv"}, {"mask", "i.png"}};
        for (const auto& [name, file] : contents) {
            choice(dialog, name).click();
            const auto written = exports::exportWithProvenance(dialog.content(), *detection, folder_ / file, dialog.options());
            QVERIFY2(bool(written), name);
            QCOMPARE(dialog.count(), written->count);
            QVERIFY2(count->text().remove(',').contains(QString::number(written->count)), qPrintable(count->text()));
        }
        choice(dialog, "cloud").click();
        choice(dialog, "local").click();
        QCOMPARE(dialog.options().frame, CoordinateFrame::MineLocal);
    }

    // The dialog says what the numbers in the file count from: those of the file itself.
    void theNumbersOfTheFileAreNamed() {
        const auto detection = detectionOf(*files::openScan(placed_));
        const std::vector<ExportDialog::Format> formats{{"PCD (*.pcd)", ".pcd"}, {"CSV (*.csv)", ".csv"}, {"PLY (*.ply)", ".ply"}};
        const auto asked = [&](const char* format, const char* frame) {
            ExportDialog dialog(detection, exports::ExportContent::EdgeCloud);
            dialog.offerFormats(formats, format);
            choice(dialog, frame).click();
            return dialog.findChild<QLabel*>("numbers")->text();
        };
        const QString fromOrigin = "The file holds metres from E 620000, N 6200000, RL 250: ";
        QVERIFY2(asked(".pcd", "mine").startsWith(fromOrigin), qPrintable(asked(".pcd", "mine")));
        QVERIFY2(asked(".csv", "local").startsWith(fromOrigin), qPrintable(asked(".csv", "local")));
        QCOMPARE(asked(".csv", "mine"), QString("The file holds Easting, Northing and RL in metres."));
        QVERIFY2(asked(".ply", "mine").contains("Choose local metres for MeshLab"), qPrintable(asked(".ply", "mine")));
        QCOMPARE(asked(".ply", "scanner"), QString("The file holds x, y and z in metres from the scanner."));
        exports::ExportOptions options;
        options.frame = CoordinateFrame::Mine;
        options.ascii = true;
        const auto file = folder_ / "mine.pcd";
        QVERIFY(bool(exports::exportWithProvenance(exports::ExportContent::EdgeCloud, *detection, file, options)));
        const QString first = QString::fromStdString(test::fileText(file)).section("DATA ascii\n", 1).section(' ', 0, 0);
        QVERIFY2(std::abs(first.toDouble()) < 1000, qPrintable(first));
        ExportDialog dialog(detection, exports::ExportContent::EdgeCloud);
        dialog.offerFormats(formats, ".pcd");
        dialog.findChild<QCheckBox*>("doubles")->setChecked(true);
        QCOMPARE(dialog.numbersText(), QString("The file holds Easting, Northing and RL in metres."));
        // The chosen one says what its numbers are and where the origin is: a PCD file of the mine grid has an origin, too.
        const auto hint = [&] { return dialog.findChild<QLabel*>("frame-hint")->text(); };
        const QString whole = "Each point has its whole Easting, Northing and RL, as on the plans of the mine.";
        QCOMPARE(hint(), whole);
        dialog.findChild<QCheckBox*>("doubles")->setChecked(false);
        QVERIFY2(hint().contains("metres from an origin near the scan") && hint().contains("EdgeScan adds the origin"), qPrintable(hint()));
        choice(dialog, "local").click();
        QVERIFY2(hint().contains("header"), qPrintable(hint()));
        choice(dialog, "scanner").click();
        QVERIFY2(hint().contains("from the scanner"), qPrintable(hint()));
        choice(dialog, "mine").click();
        auto* format = dialog.findChild<QComboBox*>("format");
        format->setCurrentIndex(format->findData(".csv"));
        emit format->activated(format->currentIndex());
        QCOMPARE(hint(), whole + " The column elevation_m is the RL.");
        choice(dialog, "gray").click();
        QCOMPARE(dialog.numbersText(), QString());
    }

    void whatMeansNothingTogetherCannotBeChosenTogether() {
        const auto detection = detectionOf(*files::openScan(placed_));
        ExportDialog dialog(detection, exports::ExportContent::EdgeCloud);
        dialog.offerFormats({{"PCD (*.pcd)", ".pcd"}, {"Drawing (*.dxf)", ".dxf", true}}, ".dxf");
        QCOMPARE(dialog.extension(), QString(".dxf"));
        auto* doubles = dialog.findChild<QCheckBox*>("doubles");
        auto* release = dialog.findChild<QCheckBox*>("dxf-2000");
        QVERIFY(!doubles->isEnabled() && release->isEnabled());
        release->setChecked(true);
        QVERIFY(dialog.options().choices.dxf2000);
        choice(dialog, "cloud").click();
        QCOMPARE(dialog.extension(), QString(".pcd"));
        const auto* list = dialog.findChild<QComboBox*>("format");
        QVERIFY(!(list->model()->flags(list->model()->index(1, 0)) & Qt::ItemIsEnabled));
        QCOMPARE(dialog.filters(), QStringList{"PCD (*.pcd)"});
        QVERIFY(doubles->isEnabled() && !release->isEnabled());
        QVERIFY(!dialog.options().choices.dxf2000);
        choice(dialog, "edges").click();
        QCOMPARE(dialog.extension(), QString(".dxf"));
    }

    void attachedPointsAreCountedWhenTheyAreWanted() {
        Scan scan = *files::openScan(bare_);
        PointGeometry points{Grid<Eigen::Vector3d>(scan.lines(), scan.beams(), Eigen::Vector3d(1, 2, 3)), Eigen::Vector3d::Zero()};
        scan.geometry = points;
        const auto first = static_cast<std::uint32_t>(std::find(scan.state.cells.begin(), scan.state.cells.end(), CellState::Valid) -
                                                      scan.state.cells.begin());
        scan.attached = {{first, {1, 2, 4}}, {first, {1, 2, 5}}};
        ExportDialog dialog(detectionOf(scan), exports::ExportContent::FullCloud);
        const std::size_t alone = dialog.count();
        auto* attached = dialog.findChild<QCheckBox*>("attached");
        QVERIFY(!attached->isHidden());
        attached->setChecked(true);
        QCOMPARE(dialog.count(), alone + 2);
        QVERIFY(dialog.options().includeAttached);
        choice(dialog, "gray").click();
        QVERIFY(!dialog.options().includeAttached);
    }

    void theNumbersOfAllContentsAreOfWhatIsSelected() {
        const auto detection = detectionOf(*files::openScan(placed_));
        auto cells = std::make_shared<std::vector<std::uint32_t>>();
        for (std::uint32_t k = 0; k < detection->scan->cells(); k += 7) cells->push_back(k);
        for (const bool only : {false, true}) {
            ExportDialog dialog(detection, exports::ExportContent::EdgeCloud, {cells, only});
            auto* box = dialog.findChild<QCheckBox*>("onlySelected");
            for (const bool checked : {only, !only}) {
                box->setChecked(checked);
                int counted = 0;
                for (const exports::ExportKind& kind : exports::exportKinds()) {
                    auto* button = dialog.findChild<QRadioButton*>(kind.key);
                    if (button == nullptr || !exports::isCloud(kind.content)) continue;
                    button->setChecked(true);
                    ++counted;
                    QVERIFY2(button->text().remove(',').contains(QString::number(dialog.count())), qPrintable(button->text()));
                    QCOMPARE(dialog.options().selection != nullptr, checked);
                }
                QVERIFY(counted >= 2);
            }
        }
    }

    void theCommandAsksAndNothingIsSavedWhenItIsDismissed() {
        WindowFixture on;
        MainWindow& window = on.window;
        QVERIFY(on.show());
        QVERIFY(on.open(placed_));
        bool asked = false;
        const Meanwhile hand([&] {
            auto* dialog = window.findChild<ExportDialog*>();
            if (dialog == nullptr || !dialog->isVisible()) return false;
            asked = dialog->content() == exports::ExportContent::EdgeCloud;
            dialog->reject();
            return true;
        });
        QSignalSpy saved(&window.viewer().engine, &Engine::saved);
        const auto actions = window.actions();
        const auto command =
            std::find_if(actions.begin(), actions.end(), [](QAction* a) { return a->shortcut() == QKeySequence("Ctrl+E"); });
        QVERIFY(command != actions.end());
        (*command)->trigger();
        QTRY_VERIFY(asked);
        QCOMPARE(saved.count(), 0);
        QVERIFY(!window.viewer().engine.working());
        const QString path = QString::fromStdString((folder_ / "mine.csv").string());
        exports::ExportOptions options;
        options.frame = CoordinateFrame::Mine;
        window.viewer().engine.save(exports::ExportContent::EdgeCloud, path, options);
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(test::fileText(path.toStdString()).starts_with("easting_m,northing_m,elevation_m,"));
        QTRY_VERIFY2(window.viewer().notice.text().contains("Mine grid: E 6200"), qPrintable(window.viewer().notice.text()));
    }
};

int place_export_test(int argc, char** argv) { return runWindowTest<PlaceExportTest>(argc, argv); }

#include "place_export_test.moc"
