// Scan > Pose and Mounting in the real window: typed, pasted, shown in the cloud, stored with the scan, undone; also for the demo.
#include "core/files/open_save/pose_sidecar.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/placement.h"
#include "tests/support/run_program.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/files/placing.h"
#include "ui/panels/dialogs/place_dialog.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/window/cab_mode.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QTabWidget>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

/// The window with the form open.
struct PlaceForm : WindowFixture {
    explicit PlaceForm(const QString& ini = {}) : WindowFixture(ini), placing(*window.findChild<Placing*>("placing")) {}

    bool ready() {
        placing.show();
        return placing.dialog() != nullptr && placing.dialog()->isVisible();
    }
    QLineEdit& field(const char* name) { return *placing.dialog()->findChild<QLineEdit*>(name); }
    QLabel& fault(const char* name) { return *placing.dialog()->findChild<QLabel*>(QString("fault-") + name); }
    QPushButton& button(const char* name) { return *placing.dialog()->findChild<QPushButton*>(name); }
    bool placed() {
        return eventually([this] { return placing.settled() && button("place-keep").isEnabled(); }) && settled();
    }
    [[nodiscard]] const Placement* place() { return picture().detection->scan->placement.get(); }
    void paste(const char* line) {
        field("survey-line").setText(line);
        button("survey-take").click();
    }
    bool stored() {
        button("place-keep").click();
        return reopened();
    }
    bool reopened() {
        return eventually([this] { return placing.settled() && !viewer.engine.working(); }) && settled();
    }

    Placing& placing;
};

} // namespace

class PlacingTest : public QObject {
    Q_OBJECT

    edgescan::test::TemporaryFolder folder_;
    std::string scan_ = (folder_ / "wall.json").string();

private slots:
    void init() {
        qputenv("XDG_CACHE_HOME", QByteArray::fromStdString((folder_ / "cache").string()));
        sim::SimulationSettings settings;
        settings.lines = 120;
        settings.beams = 160;
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, scan_)));
        QVERIFY(bool(files::writePoseSidecar(scan_, std::nullopt)));
    }

    void aSurveyLineFillsTheFormAndTheCloudShowsThePlace() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        QVERIFY(!on.button("place-keep").isEnabled());
        QVERIFY(!on.button("place-remove").isEnabled());
        on.paste("P7; 498765.432; 5150123.456; 287.654; 217.4; 14.25; -3.4");
        QCOMPARE(on.field("talin-northing_m").text(), QString("5150123.456"));
        QVERIFY(on.placed());
        QVERIFY(on.place() != nullptr);
        QCOMPARE(on.place()->originEnhM.x(), 498700.0);
        QVERIFY2(on.placing.dialog()->stateText().contains("E 498765.432, N 5150123.456, RL 287.654"),
                 qPrintable(on.placing.dialog()->stateText()));
        // What the next line does not give is not taken from the line before.
        on.field("talin-pitch_deg").setText("3");
        QVERIFY2(on.placing.dialog()->stateText().startsWith("… Scanner"), qPrintable(on.placing.dialog()->stateText())); // as before
        QVERIFY(on.placed());
        QVERIFY2(on.placing.dialog()->stateText().startsWith("Scanner"), qPrintable(on.placing.dialog()->stateText()));
        on.paste("P8; 498765.432; 5150123.456; 287.654; 217.4");
        for (const char* each : {"inclinometer-tilt_x_deg", "inclinometer-tilt_y_deg", "talin-pitch_deg"})
            QCOMPARE(on.field(each).text(), QString());
        QVERIFY(on.placed());
        // Closed without storing, the scan has no place again.
        on.placing.dialog()->reject();
        QVERIFY(on.settled());
        QVERIFY(on.place() == nullptr);
        QVERIFY(!std::filesystem::exists(files::poseSidecar(scan_)));
    }

    // Who types without a click types the first field, and Tab goes to the next.
    void whatIsTypedBeforeAFieldIsChosenIsTheEasting() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_) && on.ready() && QTest::qWaitForWindowActive(on.placing.dialog()));
        QWidget* dialog = on.placing.dialog();
        const auto typed = [dialog](const QString& text) {
            for (const QChar each : text)
                QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : dialog, each.toLatin1());
        };
        typed("1000");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        typed("2000");
        QCOMPARE(on.field("talin-easting_m").text(), QString("1000"));
        QCOMPARE(on.field("talin-northing_m").text(), QString("2000"));
        on.placing.dialog()->reject();
    }

    // Neither card, list nor cab show coordinates of values that were replaced in the form, also while what is typed is unsound.
    void coordinatesAreThoseOfTheFormOrNone() {
        for (const bool cab : {false, true}) {
            PlaceForm on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(cab);
            on.viewer.views.pin(on.picture().detection->edges->front());
            QVERIFY(on.ready());
            const QRegularExpression east("4987[1-9]"); // near the scanner, not the origin of the frame
            const auto shown = [&] {
                QString all = on.viewer.targets.inWords(*on.viewer.targets.active());
                for (const QLabel* each : on.window.findChildren<QLabel*>()) {
                    if (each->isVisible() && each->window() == &on.window) all += "\n" + each->text(); // not those of the form
                }
                return all;
            };
            on.paste("P7; 498765.432; 5150123.456; 287.654; 217.4; 14.25; -3.4");
            QVERIFY(on.placed());
            QVERIFY(eventually([&] { return shown().contains(east) && !on.viewer.engine.placePending(); }));
            for (const QString& heading : {QString("31"), QString("-"), QString("310")}) {
                on.field("talin-heading_deg").setText(heading);
                QVERIFY2(!shown().contains(east), qPrintable(shown())); // at once
            }
            QVERIFY(on.placed());
            QVERIFY(eventually([&] { return shown().contains(east); }));
            on.field("talin-heading_deg").setText("-");
            QVERIFY(!shown().contains(east));
            on.placing.dialog()->reject();
            QVERIFY(on.settled());
            QVERIFY(on.place() == nullptr && !on.viewer.engine.placePending());
            QVERIFY(eventually([&] { return shown().contains("no pose"); }));
        }
    }

    // The cells are the same: with a stored and with a removed pose, what is chosen stays so, and the views stay where they are.
    void theChosenTargetAndTheViewsStay() {
        for (const bool cab : {false, true}) {
            QVERIFY(bool(files::writePoseSidecar(scan_, std::nullopt)));
            PlaceForm on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(cab);
            const std::size_t cell = on.picture().detection->edges->front();
            on.viewer.views.pin(cell);
            CloudView& cloud = on.viewer.views.cloud();
            cloud.setCamera(turned(cloud.camera(), cloud.camera().focus, cloud.axes().up, 0.4, 0.3));
            ViewPort& port = *on.viewer.views.gray().viewPort();
            port.zoomAt({40, 30}, 3.0);
            const auto camera = cloud.camera();
            const auto centre = port.centre();
            const auto zoom = port.zoom();
            on.viewer.savedViews.store(1);
            const auto stay = [&] {
                return cloud.camera() == camera && port.centre() == centre && port.zoom() == zoom && on.viewer.savedViews.view(1);
            };
            QVERIFY(on.ready());
            on.paste("P7; 498765.432; 5150123.456; 287.654; 217.4; 14.25; -3.4");
            QVERIFY(on.placed());
            QVERIFY(on.stored());
            QVERIFY(on.place() != nullptr);
            QVERIFY(on.viewer.views.pinned() == cell && on.viewer.targets.active() != nullptr);
            QVERIFY(stay());
            if (cab) {
                const auto* mine = on.viewer.targetsPanel.card().findChild<QLabel*>("mine");
                const auto east = [mine] { return mine->isVisible() && mine->text().contains("498"); };
                QVERIFY(eventually(east));
            }
            QVERIFY(on.ready());
            on.button("place-remove").click();
            QVERIFY(on.reopened());
            QVERIFY(on.place() == nullptr);
            QVERIFY(on.viewer.views.pinned() == cell && on.viewer.targets.active() != nullptr);
            QVERIFY(stay());
            on.window.cab().set(false);
        }
    }

    // The scan without a pose is shown with the scanner's z axis up. The form does not turn it over, and says so where a choice does.
    void aTypedPoseLeavesTheCloudUprightOrSaysOtherwise() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        auto& viewing = *on.placing.dialog()->findChild<QComboBox*>("inclinometer-viewing");
        QCOMPARE(viewing.currentText(), QString("up"));
        on.paste("498765.432 5150123.456 287.654 217.4");
        QVERIFY(on.placed());
        const Scan& scan = *on.picture().detection->scan;
        QVERIFY((localMinePoint(scan, 0, 0, {0, 0, 5.4}) + scan.placement->originEnhM).z() > 293.0);
        const QString upright = on.placing.dialog()->stateText();
        QVERIFY2(upright.contains("It looks 90° above the horizon.") && !upright.contains("▲"), qPrintable(upright));
        viewing.setCurrentText("forward");
        QVERIFY(on.placed());
        QVERIFY2(on.placing.dialog()->stateText().contains("▲ The scanner looks forward"), qPrintable(on.placing.dialog()->stateText()));
        viewing.setCurrentText("up");
        on.field("inclinometer-tilt_x_deg").setText("90");
        QVERIFY(on.placed());
        QVERIFY2(on.placing.dialog()->stateText().contains("▲ The mounting looks up, but"), qPrintable(on.placing.dialog()->stateText()));
    }

    void eachWrongFieldHasItsSentence() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        // Nothing was typed: nothing is wrong.
        for (const auto* each : on.placing.dialog()->findChildren<QLabel*>(QRegularExpression("^fault-")))
            QVERIFY2(!each->isVisible(), qPrintable(each->text()));
        for (const auto* tabs : on.placing.dialog()->findChildren<QTabWidget*>()) QVERIFY(!tabs->tabText(0).contains("✕"));
        QVERIFY(!on.button("place-keep").isEnabled());
        // An empty field says itself that it is missing: a line below it would push the others down.
        const int place = on.field("talin-roll_deg").mapTo(on.placing.dialog(), QPoint(0, 0)).y();
        QTest::keyClicks(&on.field("talin-northing_m"), "5");
        QVERIFY(on.field("talin-easting_m").placeholderText().startsWith(QString::fromUtf8("✕ ")) &&
                !on.fault("talin-easting_m").isVisible());
        on.paste("498765.432, 5150123.456, 287.654");
        QVERIFY(!on.fault("talin-heading_deg").isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(on.field("talin-roll_deg").mapTo(on.placing.dialog(), QPoint(0, 0)).y(), place);
        QCOMPARE(on.field("talin-heading_deg").placeholderText(), QString::fromUtf8("✕ missing"));
        QCOMPARE(on.fault("talin-heading_deg").text(), QString("Heading, clockwise from north is missing."));
        QVERIFY(!on.fault("talin-easting_m").isVisible());
        on.field("talin-elevation_m").setText("-"); // the beginning of a number
        QVERIFY(on.fault("talin-elevation_m").isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(on.field("talin-roll_deg").mapTo(on.placing.dialog(), QPoint(0, 0)).y(), place);
        on.field("talin-elevation_m").setText("287.654");
        on.field("talin-heading_deg").setText("400");
        QVERIFY(on.fault("talin-heading_deg").text().contains("must be from -360 to 360"));
        on.field("talin-heading_deg").setText("40");
        QVERIFY(!on.fault("talin-heading_deg").isVisible());
        on.paste("one two");
        QVERIFY(on.placing.dialog()->stateText().startsWith("✕ "));
    }

    // The form says what RL is and which way it counts. What the note names has the words of the form, not the keys of the file.
    void theFormAndTheNoteHaveTheSameWords() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        QStringList words;
        for (const auto* each : on.placing.dialog()->findChildren<QLabel*>()) words << each->text();
        QVERIFY2(words.contains("RL, positive up [m]"), qPrintable(words.join('\n')));
        QVERIFY2(words.join('\n').contains("a higher place has a larger RL"), qPrintable(words.join('\n')));
        on.paste("498765.432 5150123.456 287.654 217.4");
        QVERIFY(on.placed());
        QVERIFY(on.stored());
        on.viewer.warnings.click();
        const QString note = on.viewer.notice.text();
        QVERIFY2(note.contains(
                     QString::fromUtf8("The calibration does not give “Lever arm of the head in the robot”, “Lever arm of TALIN in the "
                                       "robot”, “Boresight”")) &&
                     note.contains("so 0 is used: add what is missing (Scan > Pose and Mounting, page Mounting)."),
                 qPrintable(note));
        QVERIFY2(!note.contains("talin.") && !note.contains("_deg"), qPrintable(note));
    }

    void itIsStoredBesideTheScanAndUndone() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        on.paste("498765.432 5150123.456 287.654 217.4");
        QVERIFY(on.placed());
        QVERIFY(on.stored());
        QVERIFY(!on.placing.dialog()->isVisible());
        QVERIFY(on.place() != nullptr);
        // What was just done is read first; the warnings of the scan are the other note.
        NoticeBar& notice = on.viewer.notice;
        QVERIFY2(notice.text().startsWith("The pose is stored with the scan, in wall.json.pose.json"), qPrintable(notice.text()));
        QVERIFY(notice.kind() == NoticeBar::Kind::Done);
        QCOMPARE(notice.findChild<QToolButton*>("notice-earlier")->text(), QString("1 of 2"));
        for (int n = 0; n < 2; ++n) notice.findChild<QToolButton*>("notice-close")->click();
        QVERIFY(!notice.isVisible());
        QVERIFY(bool(files::openScan(scan_)->placement));
        on.viewer.undo.undo();
        QVERIFY(on.reopened());
        QVERIFY(on.place() == nullptr);
        QVERIFY(!std::filesystem::exists(files::poseSidecar(scan_)));
        on.viewer.undo.redo();
        QVERIFY(on.reopened());
        QVERIFY(on.place() != nullptr);
        QVERIFY2(notice.text().startsWith("The pose is stored") && notice.earlier() == 0, "warnings that were closed do not come back");
        QVERIFY(on.viewer.warnings.isVisible());
        // Another pose replaces it, with a message; it can be removed.
        QVERIFY(on.ready());
        QCOMPARE(on.field("talin-easting_m").text(), QString("498765.432"));
        on.field("talin-easting_m").setText("498965.432");
        QVERIFY(on.placed());
        QVERIFY(on.stored());
        QVERIFY(on.viewer.notice.text().contains("it replaced the one that was there"));
        QCOMPARE(on.place()->originEnhM.x(), 498900.0);
        QVERIFY(on.ready());
        on.button("place-remove").click();
        QVERIFY(on.reopened());
        QVERIFY(on.place() == nullptr);
        auto* undo = notice.findChild<QAbstractButton*>("notice-action");
        QVERIFY2(undo->isVisible() && undo->text() == "Undo", qPrintable(notice.text()));
        undo->click();
        QVERIFY(on.reopened());
        QCOMPARE(on.place()->originEnhM.x(), 498900.0);
    }

    void theDemoHasAPoseToo() {
        PlaceForm on;
        QVERIFY(on.show());
        on.viewer.files.openDemo();
        QVERIFY(on.settled());
        QVERIFY(on.ready());
        on.paste("498765.432 5150123.456 287.654 217.4");
        QVERIFY(on.placed());
        QVERIFY(on.stored());
        QVERIFY(on.place() != nullptr);
        QVERIFY(on.viewer.files.demo().has_value());
        on.viewer.undo.undo();
        QVERIFY(on.reopened());
        QVERIFY(on.place() == nullptr);
    }

    void aMountingHasANameForTheNextScan() {
        const QString ini = QString::fromStdString((folder_ / "viewer.ini").string());
        {
            PlaceForm on(ini);
            QVERIFY(on.showWith(scan_));
            QVERIFY(on.ready());
            on.field("talin-in_robot_m").setText("-0.85, 0.1, 1.15");
            on.field("grid-scale").setText("1.0004");
            on.placing.keepScanner("Robot 3");
            on.placing.dialog()->reject();
        }
        PlaceForm on(ini);
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        auto& names = *on.placing.dialog()->findChild<QComboBox*>("scanner-names");
        QCOMPARE(names.currentText(), QString("Robot 3"));
        QCOMPARE(on.field("grid-scale").text(), QString("1.0004"));
        QCOMPARE(on.field("talin-in_robot_m").text(), QString("-0.85, 0.1, 1.15"));
        on.button("scanner-forget").click();
        QCOMPARE(names.count(), 1);
    }

    void itFitsASmallScreenAndAnotherScanClosesIt() {
        PlaceForm on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(on.ready());
        QVERIFY(on.placing.dialog()->minimumSizeHint().height() <= 600);
        QVERIFY(on.placing.dialog()->minimumSizeHint().width() <= 640);
        const std::string other = (folder_ / "other.json").string();
        QVERIFY(bool(files::saveScan(*test::simulatedBell(60, 80), other)));
        QVERIFY(on.open(other));
        QVERIFY(!on.placing.dialog()->isVisible());
        QVERIFY(on.place() == nullptr);
    }
};

int placing_test(int argc, char** argv) { return runWindowTest<PlacingTest>(argc, argv); }

#include "placing_test.moc"
