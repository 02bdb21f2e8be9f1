// The A/B comparison in the real window, with real events: keep, change a setting, open the scan after the blast, flip all views with a
// key, gained and lost edges in colours and numbers.
#include "core/edges/pipeline/pipeline.h"
#include "core/inspect/change_detection/change_report.h"
#include "core/inspect/change_detection/scene_change.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/whole_widgets.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/start/tour.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/window/cab_mode.h"
#include "ui/window/side_column.h"
#include "ui/window/tool_bar.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::ui;

class ComparingTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string before_, after_, placed_, other_;

    static bool known(WindowFixture& on) {
        return on.settled() && eventually([&] {
                   const Comparing& comparing = on.viewer.comparing;
                   return comparing.settled() && (!comparing.pictureA() || comparing.comparison() != nullptr);
               });
    }
    static bool showWith(WindowFixture& on, const std::string& path) {
        on.window.resize(1280, 800);
        return on.showWith(path) && on.activate();
    }
    static QAction* action(WindowFixture& on, const QString& text) {
        for (QAction* each : on.window.findChildren<QAction*>()) {
            if (each->text().remove('&') == text) return each;
        }
        return nullptr;
    }
    static bool keepByKey(WindowFixture& on) {
        QTest::keyClick(&on.window, Qt::Key_A, Qt::ShiftModifier);
        return on.viewer.comparing.pictureA() == on.viewer.engine.picture();
    }
    // Pixels of the edge map by colour.
    static std::size_t painted(const ImageView& view, const QColor& colour) {
        return static_cast<std::size_t>(countPixels(*view.image(), [&](QRgb pixel) { return pixel == colour.rgba(); }));
    }
    static std::size_t numberIn(const QString& text) { return QString(text).remove(',').toULong(); }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = 200;
        settings.beams = 260;
        const auto save = [&](const Scan& scan, const char* name) {
            const std::string path = (folder_ / name).string();
            if (!files::saveScan(scan, path)) qFatal("%s cannot be written", path.c_str());
            return path;
        };
        Scan before = sim::simulate(settings)->scan;
        before_ = save(before, "before.json");
        before.placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
        placed_ = save(before, "placed.json");
        settings.afterBlast = true;
        after_ = save(sim::simulate(settings)->scan, "after.json");
        other_ = save(test::boxesScan(60, 80, 3, 0.02), "boxes.json");
    }

    // Rows count edges of both scans; one sentence counts all edges of A.
    void theEdgesOfAAddUp() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        const std::size_t all = on.picture().detection->edges->size();
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_) && known(on));
        const ChangeLegend& legend = on.viewer.changeLegend;
        const auto* label = legend.findChild<QLabel*>("change-sum");
        QCOMPARE(legend.row(ChangeRow::Lost)->toolTip(), legend.sumText());
        QTRY_VERIFY(label->isVisible());
        std::vector<std::size_t> numbers;
        static const QRegularExpression digits("[0-9][0-9,]*");
        for (auto each = digits.globalMatch(legend.sumText()); each.hasNext();) numbers.push_back(numberIn(each.next().captured()));
        QCOMPARE(numbers.size(), std::size_t(8));
        QCOMPARE(numbers[0], all);
        QCOMPARE(numbers[1] + numbers[2] + numbers[3], all);
        QCOMPARE(numbers[4], on.picture().detection->edges->size());
        QCOMPARE(numberIn(legend.counted(ChangeRow::Gained)) + numberIn(legend.counted(ChangeRow::Unchanged)) + numbers[7], numbers[4]);
        QCOMPARE(numbers[1], numberIn(legend.counted(ChangeRow::Lost)));
        on.window.cab().set(true);
        on.window.resize(1280, 800);
        QTest::mouseClick(legend.findChild<QToolButton*>("change-fold"), Qt::LeftButton); // it begins folded
        QTRY_VERIFY(label->isVisible());
        on.window.cab().set(false);
        on.window.resize(1600, 1000);
        QTRY_VERIFY(label->isVisible());
    }

    void twoSettingsOfOneScanAreGainedLostAndKept() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        const edges::Detection& a = *on.picture().detection;
        const Grid<std::uint8_t> maskA = *a.mask;
        on.viewer.rocks.setShown(true);
        QVERIFY(keepByKey(on));
        QVERIFY2(!on.viewer.rocks.shown(), "faces would cover what changed");
        QVERIFY(on.viewer.changeLegend.isVisible());
        QVERIFY(!on.viewer.views.scene().instead);
        edges::Settings other = on.viewer.engine.settings();
        other.method = edges::Method::Canny;
        QVERIFY(on.use(other));
        QVERIFY(known(on));
        const Grid<std::uint8_t>& maskB = *on.picture().detection->mask;
        std::size_t kept = 0, gained = 0, lost = 0;
        const auto& state = on.picture().detection->scan->state;
        for (std::size_t k = 0; k < maskA.size(); ++k) {
            kept += maskA[k] != 0 && maskB[k] != 0 ? 1 : 0;
            gained += maskA[k] == 0 && maskB[k] != 0 && state[k] == CellState::Valid ? 1 : 0;
            lost += maskA[k] != 0 && maskB[k] == 0 && state[k] == CellState::Valid ? 1 : 0;
        }
        QVERIFY(kept > 0 && gained > 0 && lost > 0);
        const ChangeLegend& legend = on.viewer.changeLegend;
        QCOMPARE(numberIn(legend.counted(ChangeRow::Unchanged)), kept);
        QVERIFY(numberIn(legend.counted(ChangeRow::Gained)) >= gained);
        QVERIFY(numberIn(legend.counted(ChangeRow::Lost)) >= lost);
        QVERIFY(legend.row(ChangeRow::Gained)->text().startsWith("+"));
        QVERIFY2(legend.howText().contains("one scan"), qPrintable(legend.howText()));
        // A comparison within one scan has no changed surfaces.
        QVERIFY(!legend.row(ChangeRow::Nearer)->isVisible());
        // The colours of the legend appear in the edge map, over the range image and in the cloud.
        QCOMPARE(painted(on.viewer.views.edges(), changeColour(ChangeRow::Gained)), numberIn(legend.counted(ChangeRow::Gained)));
        QCOMPARE(painted(on.viewer.views.edges(), changeColour(ChangeRow::Unchanged)), kept);
        QVERIFY(on.viewer.views.gray().overlay() == on.viewer.views.scene().instead->overImage);
        QVERIFY(on.viewer.views.cloud().edgeColours() == changeColours());
        QVERIFY(on.viewer.views.cloud().edgesByClass());
        QVERIFY2(!on.viewer.legend.isVisible(), "the legend of the edges tells of other colours");
        // A row of the legend is a switch.
        QTest::mouseClick(legend.row(ChangeRow::Unchanged), Qt::LeftButton, Qt::NoModifier,
                          QPoint(8, legend.row(ChangeRow::Unchanged)->height() / 2));
        QVERIFY(eventually([&] { return painted(on.viewer.views.edges(), changeColour(ChangeRow::Unchanged)) == 0; }));
        QCOMPARE(painted(on.viewer.views.edges(), changeColour(ChangeRow::Gained)), numberIn(legend.counted(ChangeRow::Gained)));
        // With the settings of A the difference is empty; without A the picture is normal.
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(!on.viewer.views.scene().instead);
        QVERIFY(on.viewer.legend.isVisible());
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(on.viewer.views.scene().instead != nullptr);
        // Their names say which is which; over B alone the name is that of B.
        QCOMPARE(legend.titleText(), QString("A, before: Default\nB, after: Percent of range"));
        // A, difference or B by buttons that stay where they are.
        const auto choose = [&](int n) {
            auto* button = legend.findChild<QToolButton*>(QString("change-shown-%1").arg(n));
            const QPoint at = button->mapTo(&on.window, button->rect().center());
            QTest::mouseClick(button, Qt::LeftButton);
            return button->isChecked() && eventually([&] { return button->mapTo(&on.window, button->rect().center()) == at; });
        };
        QVERIFY(choose(0) && on.viewer.views.flipped());
        on.viewer.notice.showHint(LinkedViews::onlyOfB());
        QVERIFY(choose(2) && !on.viewer.views.flipped() && !on.viewer.views.scene().instead);
        QVERIFY2(!on.viewer.notice.isVisible(), "it is possible again");
        QVERIFY2(legend.titleText().startsWith("On the screen: B, after: "), qPrintable(legend.titleText()));
        QVERIFY(!action(on, "Show What Changed")->isChecked());
        QVERIFY(choose(1) && !on.viewer.views.flipped() && on.viewer.views.scene().instead);
        QVERIFY(action(on, "Show What Changed")->isChecked());
        action(on, "Forget A")->trigger();
        QVERIFY(!on.viewer.views.scene().instead && !on.viewer.changeLegend.isVisible() && on.viewer.legend.isVisible());
        QVERIFY(on.viewer.views.edges().image() == on.drawn().edges);
        QCOMPARE(on.viewer.views.cloud().edgesByClass(), on.viewer.views.scene().byStrength);
    }

    void aKeyFlipsImagesAndCloudTogetherWhileItIsHeld() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        const std::shared_ptr<const Picture> a = on.viewer.engine.picture();
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        const std::shared_ptr<const Picture> b = on.viewer.engine.picture();
        // Both scans have a name in the legend, each after its letter.
        const QStringList heads = on.viewer.changeLegend.titleText().split('\n');
        QVERIFY2(heads.size() == 2 && heads[0].startsWith("A, before: before") && heads[1].startsWith("B, after: after"),
                 qPrintable(heads.join('|')));
        LinkedViews& views = on.viewer.views;
        CloudView& cloud = views.cloud();
        // A view with some cells hidden and some selected.
        cloud.zoomToCells({20000, 20001, 20200});
        on.viewer.selection.select({20000, 20001});
        const CameraPose camera = cloud.camera();
        const QPointF port = views.gray().viewPort()->toPixel(QPointF(3, 5), views.gray().size());
        QTest::keyPress(&views.gray(), Qt::Key_Backslash);
        QVERIFY(views.flipped());
        QVERIFY(views.gray().image() == a->gray);
        QVERIFY2(views.edges().image() == on.viewer.comparing.comparison()->before->edges,
                 "its edges as likely borders of rocks, as B has them");
        QVERIFY(cloud.scan() == a->detection->scan);
        QVERIFY2(on.viewer.changeLegend.titleText().contains("On the screen: A"), qPrintable(on.viewer.changeLegend.titleText()));
        QVERIFY((cloud.camera().position + cloud.geometryOfCloud()->originM - camera.position - b->cloud->originM).norm() < 1e-9);
        QCOMPARE(views.gray().viewPort()->toPixel(QPointF(3, 5), views.gray().size()), port);
        QVERIFY(cloud.selection() != nullptr && cloud.selection()->size() == 2);
        QTest::keyRelease(&views.gray(), Qt::Key_Backslash);
        QVERIFY(!views.flipped());
        QVERIFY(views.gray().image() == b->gray);
        QVERIFY(cloud.scan() == b->detection->scan);
        QVERIFY(views.edges().image() == views.scene().instead->map);
        QVERIFY(cloud.faces() == on.viewer.comparing.comparison()->points);
        QVERIFY(cloud.selection() != nullptr && cloud.selection()->size() == 2);
        QVERIFY((cloud.camera().position - camera.position).norm() < 1e-9);
        // In a text field the key types a character.
        auto* box = on.window.findChild<QDoubleSpinBox*>("number-sensitivity");
        box->setFocus();
        QTest::keyPress(box, Qt::Key_Backslash);
        QVERIFY(!views.flipped());
        QTest::keyRelease(box, Qt::Key_Backslash);
        views.gray().setFocus();
        QVERIFY2(on.viewer.engine.picture() == b, "flipping opens nothing");
        // A new picture ends a flip even while the key is pressed.
        QTest::keyPress(&views.gray(), Qt::Key_Backslash);
        QVERIFY(views.flipped());
        edges::Settings other = on.viewer.engine.settings();
        other.method = edges::Method::Canny;
        QVERIFY(on.use(other));
        QVERIFY(!views.flipped() && known(on));
        QVERIFY(cloud.scan() == b->detection->scan);
        QTest::keyRelease(&views.gray(), Qt::Key_Backslash);
        // Another scan resets the comparison.
        QVERIFY(on.open(before_));
        QVERIFY(cloud.scan() == on.picture().detection->scan && !views.flipped());
    }

    void afterABlastWhatChangedIsToldInNumbersAndColour() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        const Comparison& comparison = *on.viewer.comparing.comparison();
        const ChangeLegend& legend = on.viewer.changeLegend;
        QVERIFY(comparison.change.ranges.nearer > 100 && comparison.change.ranges.farther > 100);
        QCOMPARE(numberIn(legend.counted(ChangeRow::Nearer)), comparison.change.ranges.nearer);
        QCOMPARE(numberIn(legend.counted(ChangeRow::Farther)), comparison.change.ranges.farther);
        // While another comparison is made, the counts of this one are gray.
        const auto* count = legend.findChild<QLabel*>("change-count-0");
        QVERIFY(count != nullptr && count->isEnabled());
        on.viewer.changeLegend.showKept({"A", "B"}, &comparison, true, false);
        QVERIFY(!count->isEnabled() && legend.howText().contains("Gray counts are older"));
        on.viewer.changeLegend.showKept({"A", "B"}, &comparison, false, false);
        QVERIFY(count->isEnabled());
        // Neither scan has a pose: reported here and above the views.
        QVERIFY2(legend.howText().contains("OUT OF SPEC"), qPrintable(legend.howText()));
        QVERIFY2(on.viewer.notice.text().contains("without a pose"), qPrintable(on.viewer.notice.text()));
        // Changed points have their own colour, others are dimmed; edges are drawn over them.
        const auto& points = *on.viewer.views.cloud().faces();
        const auto dimmed = static_cast<std::size_t>(std::ranges::count(points, 0xff545454U));
        QCOMPARE(points.size() - dimmed, comparison.change.ranges.nearer + comparison.change.ranges.farther);
        // The regions one after the other, the largest first.
        const CameraPose camera = on.viewer.views.cloud().camera();
        const std::size_t nearer = comparison.change.ranges.nearer;
        QTest::mouseClick(legend.next(), Qt::LeftButton);
        QVERIFY2(legend.regionText().startsWith("region 1 of "), qPrintable(legend.regionText()));
        QVERIFY(legend.regionText().contains("±"));
        QVERIFY((on.viewer.views.cloud().camera().position - camera.position).norm() > 0.01);
        QTest::keyClick(&on.window, Qt::Key_N, Qt::ShiftModifier);
        QVERIFY2(legend.regionText().startsWith("region 2 of "), qPrintable(legend.regionText()));
        // The outline is around the region in all views, and stays over B alone.
        const ImageView& image = on.viewer.views.gray();
        const auto outline = on.viewer.views.cloud().outline();
        QVERIFY(outline && !image.outline().empty());
        for (const std::uint32_t k : *outline)
            QCOMPARE(comparison.change.ranges.cells[k], comparison.change.ranges.cells[outline->front()]);
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(on.viewer.views.cloud().outline() && !image.outline().empty());
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ShiftModifier);
        // At this size both legends fit. A picture with another setting keeps the known surfaces.
        QTRY_VERIFY(on.viewer.views.cloud().rect().contains(on.viewer.changeLegend.geometry()));
        edges::Settings other = on.viewer.engine.settings();
        other.method = edges::Method::Canny;
        QVERIFY(on.use(other));
        QVERIFY(known(on));
        QCOMPARE(on.viewer.comparing.comparison()->change.ranges.nearer, nearer);
        // A changed slider is not a blast: A is computed with the current settings.
        const auto earlier = edges::detectEdges(on.viewer.comparing.pictureA()->detection->scan, other);
        const auto expected =
            inspect::sceneChange({on.picture().detection->scan, on.picture().detection->mask}, {earlier->scan, earlier->mask});
        QVERIFY(expected);
        QCOMPARE(on.viewer.comparing.comparison()->change.edges.lost, expected->edges.lost);
        QCOMPARE(numberIn(legend.counted(ChangeRow::Lost)), expected->edges.lost);
        QVERIFY(on.viewer.comparing.pictureA()->asked != other);
        // Rocks colour what did not change; changed points and edges stay in sight, and the legend says so.
        const auto* overRocks = legend.findChild<QLabel*>("change-over-rocks");
        const CloudView& cloud = on.viewer.views.cloud();
        QVERIFY(overRocks->isHidden());
        QTest::keyClick(&on.window, Qt::Key_K);
        QTRY_VERIFY(overRocks->isVisible());
        const auto& changes = on.viewer.comparing.comparison()->change.ranges;
        std::size_t changed = 0, ofRocks = 0;
        for (std::size_t k = 0; k < changes.cells.size(); ++k) {
            const bool stays = changes.cells[k] == inspect::RangeChange::Nearer || changes.cells[k] == inspect::RangeChange::Farther;
            const bool same = (*cloud.faces())[k] == (*on.viewer.comparing.comparison()->points)[k];
            changed += stays && same ? 1 : 0;
            ofRocks += !stays && !same ? 1 : 0;
        }
        QCOMPARE(changed, changes.nearer + changes.farther);
        QVERIFY(ofRocks > 1000);
        QVERIFY(on.viewer.views.scene().edgesOverPoints);
        QTest::keyClick(&on.window, Qt::Key_K);
        QTRY_VERIFY(overRocks->isHidden());
        QVERIFY(cloud.faces() == on.viewer.comparing.comparison()->points);
    }

    void anEarlierFileIsReadBesideAndWhatDoesNotFitIsRefused() {
        WindowFixture on;
        QVERIFY(showWith(on, after_));
        on.viewer.comparing.compareWith(QString::fromStdString(before_));
        QVERIFY(known(on));
        QVERIFY(on.viewer.comparing.comparison() != nullptr);
        QVERIFY(QString::fromStdString(on.picture().detection->scan->path).endsWith("after.json"));
        // Only one scan has a pose: refused, no comparison.
        on.viewer.comparing.compareWith(QString::fromStdString(placed_));
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && !on.viewer.comparing.comparison(); }));
        QVERIFY2(on.viewer.notice.text().contains("has none"), qPrintable(on.viewer.notice.text()));
        QVERIFY(!on.viewer.views.scene().instead);
        // The notice has the button that lets the surfaces decide; A with another scan is refused again.
        auto* lineUp = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QTRY_VERIFY(lineUp->isVisible());
        QTest::mouseClick(lineUp, Qt::LeftButton);
        QVERIFY(known(on));
        QCOMPARE(on.viewer.comparing.comparison()->change.earlier.how.by, inspect::RegistrationBasis::Surfaces);
        QVERIFY2(on.viewer.notice.text().contains("OUT OF SPEC"), qPrintable(on.viewer.notice.text()));
        on.viewer.comparing.compareWith(QString::fromStdString(placed_));
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && !on.viewer.comparing.comparison(); }));
        // A scan of another place, and a missing file.
        on.viewer.comparing.compareWith(QString::fromStdString(other_));
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && !on.viewer.comparing.comparison(); }));
        QCOMPARE(on.viewer.notice.kind(), NoticeBar::Kind::Error);
        on.viewer.comparing.compareWith("/nowhere/at/all.json");
        QVERIFY(eventually([&] { return on.viewer.comparing.settled(); }));
        QVERIFY2(on.viewer.notice.text().contains("nowhere"), qPrintable(on.viewer.notice.text()));
    }

    // The demo was compared with whatever scan was opened next: OUT OF SPEC, and a picture full of colours.
    void theDemoAsAEndsWithAnotherScan() {
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        on.viewer.comparing.openDemoPair();
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && on.viewer.comparing.comparison() != nullptr; }));
        QVERIFY(on.open(after_));
        QTRY_VERIFY(!on.viewer.comparing.pictureA());
        QVERIFY(!on.viewer.changeLegend.isVisible() && !on.viewer.views.scene().instead);
        QVERIFY2(on.viewer.notice.text().contains("A was forgotten"), qPrintable(on.viewer.notice.text()));
        // It comes back by Undo.
        auto* undo = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QVERIFY(undo->isVisible());
        QTest::mouseClick(undo, Qt::LeftButton);
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && on.viewer.comparing.pictureA() != nullptr; }));
    }

    // The operator's own A stays; its notices have a button that ends it, and go with it.
    void theNoticesOfAComparisonGoWithA() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(other_));
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && on.viewer.notice.kind() == NoticeBar::Kind::Error; }));
        QVERIFY(on.viewer.comparing.pictureA() != nullptr && !on.viewer.comparing.comparison());
        // The legend and the notice do not contradict each other.
        const QString how = on.viewer.changeLegend.howText();
        QVERIFY2(!how.contains("nothing to compare"), qPrintable(how));
        const QString refusal = on.viewer.notice.text();
        auto* forget = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QVERIFY(forget->isVisible());
        QCOMPARE(forget->text(), QString("Forget A"));
        QTest::mouseClick(forget, Qt::LeftButton);
        QVERIFY(!on.viewer.comparing.pictureA());
        QVERIFY(on.viewer.notice.isHidden() || on.viewer.notice.text() != refusal);
    }

    // What the operator ended on one scan does not begin again by an undo on a later one, where only the steps of that scan are undone.
    void anEndedComparisonDoesNotComeBackOnAnotherScan() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        on.viewer.comparing.end();
        on.viewer.undo.undo(); // on the same scan it does
        QVERIFY(known(on) && on.viewer.comparing.pictureA());
        on.viewer.comparing.end();
        QVERIFY(on.open(other_));
        QTRY_VERIFY2(!on.viewer.undo.canUndo(), qPrintable(on.viewer.undo.undoText()));
        QVERIFY(!on.viewer.comparing.pictureA());
    }

    // Two scans of one scanner that did not move, as the demo before and after the blast: nothing is out of spec.
    void twoScansFromOnePlaceAreInSpec() {
        const auto before = earlierPicture(QString::fromStdString(before_), {}, {}),
                   after = earlierPicture(QString::fromStdString(after_), {}, {});
        QVERIFY(before && after);
        for (const bool byDistance : {false, true}) {
            ComparisonAsked asked{*before, *after};
            asked.byDistance = byDistance;
            const auto bySurfaces = compared(asked, nullptr);
            QVERIFY(bySurfaces && (*bySurfaces)->change.earlier.how.outOfSpec);
            asked.onePlace = true;
            const auto known = compared(asked, nullptr);
            QVERIFY(known);
            QVERIFY(!(*known)->change.earlier.how.outOfSpec && (*known)->change.earlier.how.sameCells);
            QCOMPARE((*known)->distances != nullptr, byDistance);
        }
    }

    void theChangedRegionsComeIntoThePicture() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        // The numbers of the legend have a unit.
        const auto* unit = on.viewer.changeLegend.findChild<QLabel*>("change-unit");
        QVERIFY(unit->isVisible());
        QCOMPARE(unit->text(), QString("cells"));
        // The camera looks at each region along the scanner's line of sight and never from behind the scanner, where walls are in the way:
        // most of the region is in the picture, and most of that is in sight.
        CloudView& cloud = on.viewer.views.cloud();
        const Comparison& made = *on.viewer.comparing.comparison();
        const auto& regions = made.change.regions;
        QVERIFY(!regions.empty());
        for (std::size_t n = 0; n < std::min<std::size_t>(regions.size(), 8); ++n) {
            on.viewer.comparing.nextRegion();
            QVERIFY(eventually([&] { return cloud.atRest(); }));
            if (qEnvironmentVariableIsSet("EDGESCAN_KEEP_PICTURES")) on.window.screenshot().save(QString("region_%1.png").arg(n));
            const CameraPose pose = cloud.camera();
            const Eigen::Vector3d sensor = cloud.geometryOfCloud()->sensor.cast<double>();
            QVERIFY2((pose.focus - pose.position).norm() <= (pose.focus - sensor).norm() + 1e-6, qPrintable(QString::number(n)));
            int all = 0, inView = 0, inSight = 0;
            const inspect::ChangedRegion& region = regions[n];
            const auto& kinds = made.change.ranges.cells;
            for (int line = region.firstLine; line <= region.lastLine; line += 3) {
                for (int beam = region.firstBeam; beam <= region.lastBeam; beam += 3) {
                    const auto k = static_cast<std::uint32_t>(kinds.index(line, beam));
                    if (kinds[k] != kinds[region.cell] || !cloud.geometryOfCloud()->drawable(k)) continue;
                    const auto at = cloud.pixelOf(k);
                    ++all;
                    inView += at ? 1 : 0;
                    const auto seen = at ? cloud.cellAt(*at) : std::nullopt;
                    const auto rangeOf = [&](std::uint32_t cell) { return on.picture().detection->scan->rangeMm[cell]; };
                    inSight += seen && rangeOf(*seen) > 0.9F * rangeOf(k) ? 1 : 0;
                }
            }
            const QString counts = QString("region %1: %2 of %3 in view, %4 in sight").arg(n + 1).arg(inView).arg(all).arg(inSight);
            QVERIFY2(4 * inView >= 3 * all && 4 * inSight >= 3 * inView, qPrintable(counts));
        }
        // The outline of a region ends with its scan.
        QVERIFY(!on.viewer.views.gray().outline().empty());
        QVERIFY(on.open(before_));
        QVERIFY(on.viewer.views.gray().outline().empty() && !cloud.outline());
    }

    // The buttons stay under the pointer while the legend gets the text of a region, and the way goes back as well.
    void theButtonsOfTheRegionsStayUnderThePointer() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        const ChangeLegend& legend = on.viewer.changeLegend;
        const std::size_t count = on.viewer.comparing.comparison()->change.regions.size();
        QVERIFY(count > 2);
        const auto place = [&](const QToolButton* button) { return button->mapTo(&on.window, QPoint(0, 0)); };
        const QPoint next = place(legend.next()), previous = place(legend.previous());
        const auto isRegion = [&](std::size_t n) { return legend.regionText().startsWith(QString("region %1 of %2").arg(n).arg(count)); };
        const auto press = [&](QToolButton* button, const QPoint& at) {
            QCOMPARE(on.window.childAt(at + QPoint(4, 4)), button);
            QTest::mouseClick(button, Qt::LeftButton, Qt::NoModifier, QPoint(4, 4));
            QVERIFY(eventually([&] { return on.viewer.views.cloud().atRest(); }));
            QCOMPARE(place(button), at);
            static const QRegularExpression unit("\\n(mm?|cm|m²)(\\W|$)|±\\n"), breakable("[ \\n](mm?|cm|m²)(\\W|$)|±[ \\n]");
            for (const auto* label : legend.findChildren<QLabel*>()) QVERIFY2(!label->text().contains(unit), qPrintable(label->text()));
            for (const auto* label : legend.findChildren<QLabel*>())
                QVERIFY2(!label->wordWrap() || !label->text().contains(breakable), qPrintable(label->text()));
        };
        press(legend.next(), next);
        QVERIFY2(isRegion(1), qPrintable(legend.regionText()));
        press(legend.next(), next);
        QVERIFY2(isRegion(2), qPrintable(legend.regionText()));
        press(legend.previous(), previous);
        QVERIFY2(isRegion(1), qPrintable(legend.regionText()));
        QTest::keyClick(&on.window, Qt::Key_B, Qt::ShiftModifier);
        QVERIFY2(isRegion(count), qPrintable(legend.regionText()));
        // By key and with a target, too, the legend stays at its side and open.
        on.viewer.views.pin(on.picture().detection->edges->front());
        QTRY_VERIFY(on.viewer.views.cloud().atRest());
        QTest::qWait(100);
        const int left = legend.x();
        for (std::size_t n = 1; n <= count && n < 9; ++n) {
            QTest::keyClick(&on.window, Qt::Key_N, Qt::ShiftModifier);
            QVERIFY2(isRegion(n), qPrintable(legend.regionText()));
            QTRY_VERIFY(on.viewer.views.cloud().atRest());
            QTest::qWait(100);
            QVERIFY2(legend.x() == left && legend.row(ChangeRow::Nearer)->isVisible(), qPrintable(legend.regionText()));
        }
    }

    // The outline of the region, its text and its buttons stay while A, B and the difference are looked at in turn.
    void theRegionStaysOverAAndB() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        ChangeLegend& legend = on.viewer.changeLegend;
        QTest::mouseClick(legend.next(), Qt::LeftButton);
        const QString words = legend.regionText();
        const auto outline = on.viewer.views.gray().outline();
        QVERIFY(!words.isEmpty() && !outline.empty());
        const auto* ofA = legend.findChild<QToolButton*>("change-shown-0");
        const QPoint choice = ofA->mapTo(&on.window, QPoint());
        for (const int shown : {0, 2, 0, 1, 2, 1}) { // A, B, the difference
            QTest::mouseClick(legend.findChild<QToolButton*>(QString("change-shown-%1").arg(shown)), Qt::LeftButton);
            const QByteArray which = QByteArray::number(shown);
            QVERIFY2(legend.regionText() == words, which.constData());
            QVERIFY2(on.viewer.views.gray().outline() == outline && on.viewer.views.cloud().outline(), which.constData());
            QVERIFY2(legend.next()->isVisible(), which.constData());
            QTRY_COMPARE(ofA->mapTo(&on.window, QPoint()), choice);
            // A is shown in the frame of B.
            QCOMPARE(on.viewer.cloud.frameOf(), on.picture().detection->scan);
        }
        on.viewer.comparing.end();
        QTRY_VERIFY(on.viewer.legend.isVisible());
    }

    // While A is drawn, badge and title name A.
    void badgeAndTitleNameWhatIsDrawn() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        const QString badge = on.viewer.origin.text(), title = on.window.windowTitle();
        QVERIFY2(badge.contains("after") && title.startsWith("after.json"), qPrintable(badge + title));
        const auto& counts = *on.window.findChild<QLabel*>("range-window-words");
        const QString facts = on.viewer.statusLine.countsShown(), ranges = counts.text();
        const int frames = on.viewer.cloud.framesDrawn();
        on.viewer.comparing.flip(true);
        QVERIFY2(on.viewer.origin.text().startsWith(QString::fromUtf8("A · FILE before")), qPrintable(on.viewer.origin.text()));
        QVERIFY2(on.viewer.cloud.framesDrawn() > frames || on.window.windowTitle() == title, "the title is before its picture");
        QTRY_VERIFY2(on.window.windowTitle().startsWith("A: before.json"), qPrintable(on.window.windowTitle()));
        // The rows of the legend are not of what is drawn now.
        QVERIFY(!on.viewer.changeLegend.row(ChangeRow::Gained)->isVisible());
        // Status line, ranges, panel and cab are of A too, or say that they are of B.
        const edges::Detection& a = *on.viewer.views.shown()->detection;
        QVERIFY(a.scan == on.viewer.comparing.pictureA()->detection->scan && on.viewer.statusLine.countsShown() != facts);
        QVERIFY2(on.viewer.statusLine.countsShown().contains(QLocale(QLocale::English).toString(qulonglong(a.edges->size()))),
                 qPrintable(on.viewer.statusLine.countsShown()));
        QTRY_VERIFY(counts.text() != ranges);
        const auto* panel = on.window.findChild<QDockWidget*>("dock-edges")->titleBarWidget()->findChild<QLabel*>();
        QCOMPARE(panel->text(), QString::fromUtf8("Edges · B"));
        on.viewer.views.pointAt(100);
        QVERIFY2(on.viewer.statusLine.probeShown().startsWith("A: "), qPrintable(on.viewer.statusLine.probeShown()));
        on.viewer.comparing.flip(false);
        QCOMPARE(on.viewer.origin.text(), badge);
        QTRY_COMPARE(on.window.windowTitle(), title);
        QCOMPARE(on.viewer.statusLine.countsShown(), facts);
        QCOMPARE(counts.text(), ranges);
        QVERIFY2(!on.viewer.legend.isVisible(), "the legend of A's edges stays below that of the comparison");
        QCOMPARE(panel->text(), QString("Edges"));
        QVERIFY(!on.viewer.statusLine.probeShown().startsWith("A: "));
    }

    // What is clicked is measured on B: no click counts while A is drawn, and no length of B is over A.
    void nothingIsMeasuredWhileAIsShown() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        LinkedViews& views = on.viewer.views;
        const auto clickAt = [&](int line, int beam) {
            const QPointF at = views.gray().viewPort()->toPixel(QPointF(beam + 0.5, line + 0.5), views.gray().size());
            QTest::mouseClick(&views.gray(), Qt::LeftButton, {}, at.toPoint());
        };
        const auto targets = [&] { return on.viewer.targets.notebook().targets.size(); };
        clickAt(100, 60);
        QCOMPARE(targets(), std::size_t(1));
        QVERIFY(!views.gray().marks().targets.empty());
        on.viewer.comparing.flip(true);
        QVERIFY(views.gray().marks() == CellMarks{} && on.viewer.cloud.marks() == CellMarks{});
        clickAt(60, 100);
        QCOMPARE(targets(), std::size_t(1));
        QVERIFY2(QToolTip::text().startsWith("A is shown"), qPrintable(QToolTip::text()));
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        clickAt(100, 60);
        QTest::keyClick(&views.gray(), Qt::Key_Return);
        QVERIFY(on.viewer.measures.picked().empty());
        QVERIFY2(on.viewer.tools.shown().contains("A is shown"), qPrintable(on.viewer.tools.shown()));
        on.viewer.comparing.flip(false);
        QVERIFY(views.gray().marks().targets.size() == 1);
        QVERIFY2(!on.viewer.tools.shown().contains("A is shown"), qPrintable(on.viewer.tools.shown()));
        clickAt(100, 60);
        QCOMPARE(on.viewer.measures.picked().size(), std::size_t(1));
    }

    // A file and a report are of B: while they are asked for, B is on the screen.
    void whatIsWrittenIsOnTheScreen() {
        WindowFixture on;
        QVERIFY(showWith(on, before_));
        QVERIFY(keepByKey(on));
        QVERIFY(on.open(after_));
        QVERIFY(known(on));
        const QString ofB = on.viewer.origin.text();
        for (const char* name : {"Edge Drawing (DXF)…", "Report…"}) {
            QAction* ask = action(on, name);
            QVERIFY2(ask != nullptr && ask->isEnabled(), name);
            on.viewer.comparing.flip(true);
            QTRY_VERIFY2(on.viewer.origin.text() != ofB, qPrintable(ofB));
            bool asked = false;
            QTimer::singleShot(0, &on.window, [&] {
                auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
                asked = dialog != nullptr && on.viewer.origin.text() == ofB;
                if (dialog != nullptr) dialog->reject();
            });
            ask->trigger();
            QVERIFY2(asked, name);
        }
    }

    // The pair of the tour ends with the next scan, also with the plain demo; the legend has its own end, and folds.
    void theLegendEndsAndFoldsAndTheDemoPairDoesNotStay() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.show() && on.activate());
        on.viewer.comparing.openDemoPair();
        QVERIFY(eventually([&] { return on.viewer.comparing.pictureA() != nullptr; }) && known(on));
        auto& legend = on.viewer.changeLegend;
        auto* fold = legend.findChild<QToolButton*>("change-fold");
        QTRY_VERIFY(fold->isVisible());
        const int high = legend.height();
        const QPoint at = fold->mapTo(&on.window, QPoint());
        QTest::mouseClick(fold, Qt::LeftButton);
        QTRY_VERIFY2(legend.height() < high / 2, qPrintable(QString("%1 of %2").arg(legend.height()).arg(high)));
        QCOMPARE(fold->mapTo(&on.window, QPoint()), at);
        QVERIFY(!legend.row(ChangeRow::Gained)->isVisible() && legend.next()->isVisible());
        QTest::mouseClick(fold, Qt::LeftButton);
        QTRY_COMPARE(legend.height(), high);
        // A zoom to a region ends with the comparison, and is not that of the next scan, whose size is the same. The images have a button
        // that shows them whole.
        auto* fit = on.viewer.gray.findChild<QToolButton*>("fit-images");
        QVERIFY(!fit->isVisible());
        on.viewer.comparing.nextRegion();
        QVERIFY(!on.viewer.gray.viewPort()->fitted());
        QVERIFY2(fit->isVisible() && fit->text().endsWith("Fit"), qPrintable(fit->text()));
        QTest::mouseClick(legend.findChild<QToolButton*>("change-end"), Qt::LeftButton);
        QVERIFY(on.viewer.gray.viewPort()->fitted() && !fit->isVisible());
        // B is on the screen now; A is one press away.
        auto* offered = on.viewer.notice.findChild<QAbstractButton*>("notice-action");
        QVERIFY(on.viewer.files.demo() == true && offered->isVisible() && offered->text() == "Open A");
        QTest::mouseClick(offered, Qt::LeftButton);
        QVERIFY(on.settled() && eventually([&] { return on.viewer.files.demo() == false; }));
        on.viewer.comparing.openDemoPair();
        QVERIFY(eventually([&] { return on.viewer.comparing.pictureA() != nullptr; }) && known(on));
        QTest::mouseClick(legend.findChild<QToolButton*>("change-end"), Qt::LeftButton);
        on.viewer.undo.undo();
        QTRY_VERIFY(legend.isVisible() && on.viewer.comparing.comparison());
        QTRY_VERIFY2(!on.viewer.notice.isVisible() || !on.viewer.notice.text().contains("comparison ended"),
                     qPrintable(on.viewer.notice.text()));
        on.viewer.comparing.nextRegion();
        QVERIFY(fit->isVisible());
        QTest::mouseClick(fit, Qt::LeftButton);
        QVERIFY(on.viewer.gray.viewPort()->fitted() && !fit->isVisible());
        on.viewer.comparing.nextRegion();
        on.viewer.files.openDemo();
        QVERIFY(on.settled());
        QTRY_VERIFY(on.viewer.comparing.pictureA() == nullptr);
        QVERIFY2(on.viewer.notice.text().contains("comparison ended"), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.gray.viewPort()->fitted());
        QVERIFY(keepByKey(on));
        QVERIFY(legend.isVisible());
        QTest::mouseClick(legend.findChild<QToolButton*>("change-end"), Qt::LeftButton);
        QVERIFY(on.viewer.comparing.pictureA() == nullptr && !legend.isVisible());
        QVERIFY(on.viewer.notice.isVisible() && on.viewer.notice.text().startsWith("The comparison ended"));
        QTest::mouseClick(on.viewer.notice.findChild<QAbstractButton*>("notice-action"), Qt::LeftButton); // Undo
        QVERIFY(on.viewer.comparing.pictureA() != nullptr && legend.isVisible());
        on.viewer.undo.redo();
        // The next comparison shows what changed, whatever the one before showed at its end.
        QVERIFY(keepByKey(on));
        on.viewer.comparing.setDifferenceShown(false);
        QTest::mouseClick(legend.findChild<QToolButton*>("change-end"), Qt::LeftButton);
        QSignalSpy difference(&on.viewer.comparing, &Comparing::differenceShownChanged);
        QVERIFY(keepByKey(on));
        QCOMPARE(difference.count(), 1);
        QVERIFY(difference.front().front().toBool());
        // The button of the menu has no frame as under the pointer after its menu.
        auto* button = tool(on.window, "tool-compare");
        QCursor::setPos(on.window.mapToGlobal(QPoint(5, 5)));
        button->setAttribute(Qt::WA_UnderMouse);
        button->menu()->popup(on.window.mapToGlobal(QPoint(300, 300)));
        button->menu()->hide();
        QVERIFY(!button->underMouse());
    }

    void withoutAnythingKeptTheKeysSaySo() {
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        QTest::keyClick(&on.window, Qt::Key_A, Qt::ShiftModifier);
        QVERIFY2(on.viewer.notice.text().contains("open a scan first"), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.open(before_));
        QTest::keyPress(&on.viewer.views.gray(), Qt::Key_Backslash);
        QVERIFY2(on.viewer.notice.text().contains("Nothing is kept as A"), qPrintable(on.viewer.notice.text()));
        QTest::keyRelease(&on.viewer.views.gray(), Qt::Key_Backslash);
        QVERIFY(!on.viewer.views.flipped());
    }

    // A screen of 1280 x 800 at a scale of 1.5, with a panel open by hand and the tour on: the buttons of a comparison are
    // always in reach, and the tour takes a few lines.
    void onASmallScreenCardsLeaveThePicture() {
        WindowFixture on;
        on.window.resize(853, 500);
        QVERIFY(on.showWith(before_) && on.activate());
        QVERIFY(keepByKey(on) && on.open(after_) && known(on));
        QVERIFY(!on.viewer.comparing.comparison()->change.regions.empty());
        auto& tour = *on.window.findChild<Tour*>("tour");
        tour.start();
        tour.showStep(2); // the longest text
        on.viewer.views.pin(on.viewer.views.cellAt(60, 80));
        on.window.findChild<QDockWidget*>("dock-targets")->toggleViewAction()->trigger();
        const ChangeLegend& legend = on.viewer.changeLegend;
        const int line = tour.fontMetrics().lineSpacing();
        const auto isInReach = [&] { return !legend.next()->visibleRegion().isEmpty(); };
        QVERIFY(eventually(isInReach));
        QVERIFY2(tour.height() < 6 * line, qPrintable(QString::number(tour.height())));
        const QStringList faults = faultsIn(tour) + faultsIn(on.window.side());
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
        // Where there is room, all of it is seen.
        tour.end();
        on.window.resize(1600, 1000);
        const auto* bar = on.window.side().verticalScrollBar();
        QTRY_VERIFY(bar->maximum() == 0 && !bar->isVisible() && isInReach());
    }
};

int comparing_test(int argc, char** argv) { return runWindowTest<ComparingTest>(argc, argv); }
#include "comparing_test.moc"
