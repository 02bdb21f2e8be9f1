// Scan > Calibrate in the real window: for sweeps simulated with mounting errors. The file equals that of the command line, it is applied
// only by a click, and a sweep without enough information is refused.
#include "core/scan/georef/calibration.h"
#include "core/scan/grid/placement.h"
#include "tests/support/run_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/base/two_pictures.h"
#include "ui/controllers/files/calibrating.h"
#include "ui/panels/dialogs/calibration_card.h"
#include "ui/panels/live/state_badge.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTimer>

#include <nlohmann/json.hpp>

#include <cmath>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

const AssemblyErrors kBuiltIn{{12.0, -8.0, 0.4, -0.3, 0.2}};

bool turned(const std::string& path, double turnDeg, Axis axis = Axis::Spin, std::uint64_t seed = 31) {
    sim::SimulationSettings settings;
    settings.axis = axis;
    settings.seed = seed;
    settings.turnDeg = turnDeg;
    settings.lines = static_cast<int>(turnDeg * 2);
    settings.beams = 381;
    settings.assembly = kBuiltIn;
    return bool(files::saveScan(sim::simulate(settings)->scan, path));
}

QAction* calibrateAction(MainWindow& window) {
    for (QAction* action : window.findChildren<QAction*>()) {
        if (action->text() == "&Calibrate…") return action;
    }
    return nullptr;
}

/// The window with the card open.
struct Bench : WindowFixture {
    explicit Bench(const std::string& path, const ReadingOptions& options = {}) {
        window.viewer().files.open({QString::fromStdString(path)}, options);
        calibrating = window.findChild<Calibrating*>();
        ready = show() && settled() && activate();
        if (!ready) return;
        calibrateAction(window)->trigger();
        card = calibrating->card();
        ready = card != nullptr && QTest::qWaitForWindowExposed(card, kPatienceMs);
    }
    template <class Widget>
    [[nodiscard]] Widget* part(const char* name) const {
        return card->findChild<Widget*>(name);
    }
    void click(const char* button) const { QTest::mouseClick(part<QPushButton>(button), Qt::LeftButton); }
    [[nodiscard]] bool found() const {
        return eventually([this] { return !card->working(); }) && calibrating->found() != nullptr;
    }

    Calibrating* calibrating = nullptr;
    CalibrationCard* card = nullptr;
    bool ready = false;
};

/// Types a name into the file dialog when it appears.
void typeInto(QTimer& timer, const QString& name) {
    QObject::connect(&timer, &QTimer::timeout, &timer, [&timer, name] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr || !dialog->isVisible()) return;
        timer.stop();
        dialog->findChild<QLineEdit*>("fileNameEdit")->setText(name);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
    });
    timer.start(30);
}

} // namespace

class CalibratingTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string turned_, other_, half_, sweep_, pose_, robot_;

    [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }
    void write(const std::string& file, const char* text) const { std::ofstream(file) << text; }

private slots:
    void initTestCase() {
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        turned_ = path("turned.json");
        other_ = path("other.json");
        half_ = path("half.json");
        sweep_ = path("sweep.json");
        QVERIFY(turned(turned_, 200) && turned(other_, 200, Axis::Spin, 32) && turned(half_, 180) && turned(sweep_, 200, Axis::Sweep));
        pose_ = path("pose.json");
        robot_ = path("robot.json");
        write(robot_, R"({"format": "edgescan-calibration/1", "robot": "R7", "boom": {"head_in_robot_m": [4, 1, 2]}})");
        write(pose_, R"({"format": "edgescan-pose/1", "robot": "R7", "sweep": "static", "boom": {"azimuth_deg": 30},
            "inclinometer": {"tilt_x_deg": 4, "tilt_y_deg": -3},
            "talin": {"easting_m": 498765, "northing_m": 5150123, "elevation_m": 287, "heading_deg": 217, "heading_ref": "grid",
                      "pitch_deg": 5, "roll_deg": -2}})");
    }

    void whatIsFoundIsSavedAsTheCommandLineSavesItAndAppliedByAClickAlone() {
        ReadingOptions placed;
        placed.pose = pose_;
        placed.calibration = robot_;
        Bench on(turned_, placed);
        QVERIFY(on.ready);
        const auto* list = on.part<QListWidget>("calibration-scans");
        QCOMPARE(list->count(), 1);
        auto* save = on.part<QPushButton>("calibration-save");
        auto* apply = on.part<QPushButton>("calibration-apply");
        QVERIFY(!save->isEnabled() && !apply->isEnabled());
        on.click("calibration-start");
        QVERIFY(on.found());
        const inspect::SelfCalibration& found = *on.calibrating->found();
        for (std::size_t n = 0; n < AssemblyErrors::kCount; ++n)
            QVERIFY2(std::abs(found.errors.values[n] - kBuiltIn.values[n]) < std::max(4 * found.sd.values[n], 1e-3),
                     std::to_string(n).c_str());
        QVERIFY2(on.card->verdict().startsWith("✓ found from"), qPrintable(on.card->verdict()));
        const auto* table = on.part<QTableWidget>("calibration-table");
        QCOMPARE(table->rowCount(), 5);
        QCOMPARE(table->item(0, 1)->text(), QString::number(found.errors.t1Mm(), 'f', 2) + " mm");
        QCOMPARE(table->item(2, 2)->text(), QString::number(2 * found.sd.tiltDeg(), 'f', 4) + " °");

        QVERIFY(save->isEnabled() && !apply->isEnabled());
        QTimer hand;
        typeInto(hand, QString::fromStdString(path("new.json")));
        QSignalSpy saved(on.calibrating, &Calibrating::saved);
        on.click("calibration-save");
        QTRY_COMPARE(saved.count(), 1);
        const auto cli = test::runCli("calibrate " + turned_ + " --base " + robot_ + " -o " + path("cli.json"));
        QVERIFY2(cli.code == 0, cli.err.c_str());
        QCOMPARE(QString::fromStdString(test::fileText(path("new.json"))), QString::fromStdString(test::fileText(path("cli.json"))));

        // The scan has not moved yet; a click moves it, and Ctrl+Z moves it back.
        const StepperMount before = on.picture().detection->scan->placement->mount;
        QCOMPARE(before.sensorInMover.translationM.norm(), 0.0);
        QVERIFY(apply->isEnabled());
        QTest::mouseClick(apply, Qt::LeftButton);
        QVERIFY(on.settled());
        const Placement& after = *on.picture().detection->scan->placement;
        QVERIFY(std::abs(after.mount.sensorInMover.translationM.x() - 0.001 * found.errors.t1Mm()) < 1e-6);
        QVERIFY(after.source.find("new.json") != std::string::npos);
        QVERIFY(on.viewer.origin.toolTip().contains("new.json"));
        QVERIFY(on.calibrating->found() != nullptr); // the same scan: the result stays
        on.viewer.undo.undo();
        QVERIFY(on.settled());
        QCOMPARE(on.picture().detection->scan->placement->mount, before);
        QVERIFY(!on.viewer.origin.toolTip().contains("new.json"));
    }

    void theSeamIsShownBeforeAndAfterAndTheTwoMoveTogether() {
        Bench on(turned_);
        QVERIFY(on.ready);
        on.click("calibration-start");
        QVERIFY(on.found());
        const QRect room = on.card->screen()->availableGeometry();
        QTRY_VERIFY2(room.contains(on.card->geometry()), "the card has grown beyond the screen");
        const TwoPictures& pictures = on.card->pictures();
        const auto white = [](const QImage& image) {
            return countPixels(image, [](QRgb pixel) { return (pixel & 0xffffffU) == 0xffffffU; });
        };
        QVERIFY(white(pictures.picture(1)) > 3 * white(pictures.picture(0)) / 2);
        const QImage edges = pictures.picture(1);
        QCOMPARE(edges.width(), 3 * on.picture().detection->scan->beams());
        auto* which = on.part<QComboBox>("calibration-picture");
        QCOMPARE(which->count(), 2);
        QScrollBar* above = pictures.area(0)->horizontalScrollBar();
        QScrollBar* below = pictures.area(1)->horizontalScrollBar();
        QVERIFY(above->maximum() > 0);
        QTRY_VERIFY(below->maximum() == above->maximum() && below->value() == above->value());
        QTest::keyClick(pictures.area(0), Qt::Key_Right);
        QCOMPARE(below->value(), above->value());
        which->setFocus();
        QTest::keyClick(which, Qt::Key_Down);
        QVERIFY(pictures.picture(1) != edges);
        QCOMPARE(pictures.picture(1).width(), on.picture().detection->scan->beams());
    }

    void severalScansCountTogetherAndAllAreNamed() {
        Bench on(turned_);
        QVERIFY(on.ready);
        on.calibrating->add({QString::fromStdString(turned_), QString::fromStdString(other_)}); // one of them is already in the list
        QCOMPARE(on.part<QListWidget>("calibration-scans")->count(), 2);
        on.click("calibration-start");
        QVERIFY(on.found());
        QSignalSpy saved(on.calibrating, &Calibrating::saved);
        on.calibrating->saveTo(QString::fromStdString(other_)); // an input
        QTRY_VERIFY(!on.calibrating->saving());
        QCOMPARE(saved.count(), 0);
        QVERIFY(on.viewer.notice.text().contains("other.json"));
        on.calibrating->saveTo(QString::fromStdString(path("both.json")));
        QTRY_COMPARE(saved.count(), 1);
        const auto file = nlohmann::json::parse(test::fileText(path("both.json")));
        QCOMPARE(file["estimated"]["scans"].size(), std::size_t{2});
        QCOMPARE(file["estimated"]["scans"][1]["name"].get<std::string>(), std::string("other.json"));
        // Without a pose the calibration cannot be applied, and the card says so.
        QVERIFY(!on.part<QPushButton>("calibration-apply")->isEnabled());
        QVERIFY(on.part<QPushButton>("calibration-apply")->toolTip().contains("without a pose"));
        QVERIFY(on.viewer.files.options().calibration.empty());
    }

    void aTurnThatTellsNothingIsRefusedWithTheReason() {
        for (const auto& [scan, reason] : {std::pair{half_, "turn 200 degrees once"}, {sweep_, "about an axis in the fan"}}) {
            Bench on(scan);
            QVERIFY(on.ready);
            on.click("calibration-start");
            QTRY_VERIFY(!on.card->working());
            QVERIFY2(on.card->verdict().startsWith("✕ ") && on.card->verdict().contains(reason), qPrintable(on.card->verdict()));
            QVERIFY(on.calibrating->found() == nullptr);
            QVERIFY(!on.part<QPushButton>("calibration-save")->isEnabled());
            QVERIFY(!on.part<QTableWidget>("calibration-table")->isVisible());
        }
    }

    void itCanBeGivenUpAndAnotherScanForgetsIt() {
        Bench on(turned_);
        QVERIFY(on.ready);
        on.click("calibration-start");
        QVERIFY(on.card->working());
        on.click("calibration-start"); // the button is "Stop" now
        QVERIFY(!on.card->working());
        QCOMPARE(on.card->verdict(), QString("✕ stopped"));
        on.click("calibration-start");
        QVERIFY(on.found()); // the cancelled question has no effect
        QVERIFY(on.open(half_));
        QVERIFY(on.calibrating->found() == nullptr);
        QVERIFY(!on.card->isVisible());
    }

    void whatComesFromNoFileCannotBeNamed() {
        WindowFixture on;
        QVERIFY(on.show());
        calibrateAction(on.window)->trigger();
        QCOMPARE(on.viewer.notice.text(), QString("Open a scan first."));
        on.viewer.files.openDemo();
        QVERIFY(on.settled());
        calibrateAction(on.window)->trigger();
        QVERIFY(on.viewer.notice.text().contains("does not come from a file"));
    }
};

int calibrating_test(int argc, char** argv) { return runWindowTest<CalibratingTest>(argc, argv); }
#include "calibrating_test.moc"
