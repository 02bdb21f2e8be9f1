// What a finger does over the views in cab mode: it zooms, folds legends, scrolls, and takes steps back whose names it reads.
#include "core/edges/settings/parameters.h"
#include "tests/support/folders.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/sized_window.h"
#include "tests/ui/whole_widgets.h"
#include "ui/base/count_text.h"
#include "ui/base/elided_label.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/cab/numbers_side.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/window/cab_mode.h"
#include "ui/window/side_column.h"
#include "ui/window/theme.h"

#include <QCheckBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QScroller>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>

using namespace edgescan;
using namespace edgescan::ui;

class CabViewsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_, other_;

    static void press(MainWindow& window, const char* name) { QTest::mouseClick(window.findChild<QAbstractButton*>(name), Qt::LeftButton); }
    static QRect placeOf(const QWidget& of) { return {of.mapToGlobal(QPoint()), of.size()}; }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        scan_ = (folder_ / "boxes.json").string();
        other_ = (folder_ / "others.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(200, 240, 3, 0.02), scan_)));
        QVERIFY(bool(files::saveScan(test::boxesScan(160, 200, 5, 0.02), other_)));
    }
    void cleanup() { useTheme(*qApp, false); }

    // On every screen, over the cloud and over the image that is exchanged with it.
    void aTapZooms() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        QVERIFY(!tool(on.window, "cab-zoom-in")->isVisible());
        on.window.cab().set(true);
        CloudView& cloud = on.viewer.views.cloud();
        for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
            resizeTo(on.window, size);
            QTRY_VERIFY(tool(on.window, "cab-zoom-in")->isVisible());
            for (const char* name : {"cab-zoom-in", "cab-zoom-out"}) {
                const QToolButton& button = *tool(on.window, name);
                QVERIFY(button.width() >= 48 && button.height() >= 48);
                QVERIFY(placeOf(button).top() > placeOf(cloud).bottom());
                QVERIFY(!placeOf(on.viewer.legend).intersects(placeOf(button)));
            }
            const double before = cloud.camera().distance();
            press(on.window, "cab-zoom-in");
            QVERIFY(cloud.camera().distance() < 0.9 * before);
            press(on.window, "cab-zoom-out");
            QVERIFY(std::abs(cloud.camera().distance() - before) < 1e-6 * before);
        }
        QTest::mouseClick(&on.window.cab().corner(), Qt::LeftButton);
        QTRY_VERIFY(on.viewer.views.gray().isVisible() && tool(on.window, "cab-zoom-in")->isVisible());
        const double wide = on.viewer.views.gray().viewPort()->cellSize().width();
        press(on.window, "cab-zoom-in");
        QVERIFY(on.viewer.views.gray().viewPort()->cellSize().width() > 1.1 * wide);
        QVERIFY(tapEntry(on.window, "cab-images", CloudEntry));
        QTRY_VERIFY(cloud.isVisible() && tool(on.window, "cab-zoom-in")->isVisible());
        on.window.cab().set(false);
        QVERIFY(!tool(on.window, "cab-zoom-in")->isVisible());
    }

    // Its parts are in lines, and none is cut; the text itself is as given.
    void aLongNameOfAFileIsWhole() {
        const QString words =
            "Saved /home/op/demo-draw-bell-after-the-blast_edges_edgescan+_edge-strength1_2026-11-27_LOCAL.pcd: x -7.78 m.";
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        for (const QSize size : {QSize(853, 480), QSize(1280, 800)}) {
            resizeTo(on.window, size);
            NoticeBar& notice = on.viewer.notice;
            notice.showNotice(NoticeBar::Kind::Warning, words);
            QTest::mouseClick(notice.findChild<QToolButton*>("notice-unfold"), Qt::LeftButton);
            const auto* text = notice.findChild<QLabel*>("notice-text");
            QTRY_VERIFY(text->isVisible());
            QCOMPARE(notice.text(), words);
            QCOMPARE(QString(text->text()).remove(QChar(0x200B)), words);
            static const QRegularExpression places(QString("[ %1]").arg(QChar(0x200B)));
            for (const QString& part : text->text().split(places))
                QTRY_VERIFY2(text->fontMetrics().horizontalAdvance(part) <= text->width(), qPrintable(part));
            notice.hide();
        }
        on.window.cab().set(false);
    }

    // Next to fewer and more, with its word.
    void theUsualSettingsAreNextToFewerAndMore() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {1024, 768});
        const edges::Settings usual = on.viewer.engine.settings();
        const Stepper& stepper = *on.window.cab().frame().side().mainStepper();
        const QToolButton& button = *tool(on.window, "cab-default-near");
        QVERIFY(button.isVisible() && stepper.isAncestorOf(&button) && button.text() == "Default" && button.height() >= 48);
        QTest::mouseClick(stepper.more(), Qt::LeftButton);
        QVERIFY(!(on.viewer.engine.settings() == usual));
        press(on.window, "cab-default-near");
        QCOMPARE(on.viewer.engine.settings(), usual);
    }

    // Undo names its step, before and after it, and none is of a scan that was on the screen before.
    void undoNamesItsStep() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QToolButton* undo = tool(on.window, "cab-undo");
        on.viewer.views.pin(100 * 240 + 120);
        on.viewer.views.pin(60 * 240 + 60);
        QCOMPARE(undo->accessibleName(), QString("Undo new target 2"));
        press(on.window, "cab-undo");
        QCOMPARE(on.viewer.notice.text(), QString("Undone: new target 2."));
        QVERIFY(on.viewer.notice.isVisible());
        QTest::mouseClick(on.viewer.notice.findChild<QToolButton*>("notice-action"), Qt::LeftButton);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(2));
        on.viewer.targets.remove(1);
        press(on.window, "cab-undo");
        QCOMPARE(on.viewer.notice.text(), QString("Undone: removal of target 1. It is back."));
        QTest::mouseClick(on.window.cab().frame().side().mainStepper()->more(), Qt::LeftButton);
        QVERIFY(on.settled() && on.open(other_));
        press(on.window, "cab-undo"); // the setting, which is of no scan
        QVERIFY2(on.viewer.notice.text().startsWith("Undone: Edge strength 1.05 to 1."), qPrintable(on.viewer.notice.text()));
        QTRY_VERIFY2(!undo->isEnabled(), "only steps of the scan before are left");
        QCOMPARE(undo->accessibleName(), QString("Undo"));
    }

    // What was undone needs nothing: its notice leaves, but not from under the pointer. Others stay.
    void theNoticeOfAnUndoLeaves() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        NoticeBar& notice = on.viewer.notice;
        auto* leaves = notice.findChild<QTimer*>("notice-leaves");
        const auto undo = [&] {
            on.viewer.views.pin(100 * 240 + 120);
            press(on.window, "cab-undo");
            QVERIFY(notice.isVisible() && leaves->isActive());
            QVERIFY2(leaves->interval() >= 5000 && leaves->interval() <= 10000, qPrintable(QString::number(leaves->interval())));
            leaves->start(20); // faster, for the test
        };
        undo();
        QTRY_VERIFY(!notice.isVisible() && !leaves->isActive());
        leaves->setInterval(8000);
        undo();
        notice.findChild<QToolButton*>("notice-action")->setFocus();
        QSignalSpy passed(leaves, &QTimer::timeout);
        QTRY_VERIFY(passed.count() >= 3);
        QVERIFY(notice.isVisible());
        notice.showHint("Something to read.");
        QVERIFY(!leaves->isActive() && notice.isVisible());
    }

    // What was below the small picture a moment ago is not what the finger meant.
    void noTapThatIsMeantForTheSmallPictureReachesTheCloud() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        resizeTo(on.window, {1280, 775});
        for (int n = 0; n < 9; ++n) press(on.window, "cab-zoom-in"); // the cloud is below all of it
        const CornerPicture& small = on.window.cab().corner();
        QTRY_VERIFY(small.isVisible());
        const QPoint at = small.mapTo(&on.window, {4, small.height() - 6});
        const auto tap = [&] { QTest::mouseClick(on.window.windowHandle(), Qt::LeftButton, Qt::NoModifier, at); };
        QVERIFY(tapEntry(on.window, "cab-images", SmallEntry));
        QTRY_VERIFY(!small.isVisible());
        tap();
        QVERIFY(on.viewer.targets.notebook().empty() && !on.viewer.views.pinned());
        QTRY_VERIFY((tap(), on.viewer.views.pinned()));
        // It became lower: the part that it left is guarded, and it is a button itself.
        QVERIFY(tapEntry(on.window, "cab-images", SmallEntry));
        QTRY_VERIFY(small.isVisible());
        QSignalSpy left(&small, &CornerPicture::uncovered);
        const int before = small.height();
        resizeTo(on.window, {1280, 500});
        QVERIFY(small.height() < before && !left.isEmpty());
    }

    // While + and − change the settings, the edges are seen in the large range image, and their number between the two buttons.
    void theLargeRangeImageHasTheEdgesAndTheirNumber() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QVERIFY(!on.viewer.views.scene().overGray);
        QVERIFY(tapEntry(on.window, "cab-images", RangeEntry));
        QTRY_VERIFY(on.viewer.gray.isVisible() && on.viewer.views.scene().overGray);
        for (const QSize size : {QSize(1280, 775), QSize(853, 480)}) {
            resizeTo(on.window, size);
            auto& side = *on.window.findChild<NumbersSide*>();
            if (!side.mainStepper()->isVisible()) press(on.window, "cab-tune");
            const auto all = side.findChildren<QLabel*>("stepper-found");
            const auto found = std::ranges::find_if(all, [](const QLabel* each) { return each->isVisible(); });
            QVERIFY(found != all.end());
            const auto words = [&] { return countText(on.picture().detection->edges->size()) + "\nEdges"; };
            QCOMPARE((*found)->text(), words());
            QVERIFY((*found)->width() >= (*found)->sizeHint().width());
            QVERIFY(placeOf(on.window).contains(placeOf(**found)) && !(*found)->visibleRegion().isEmpty());
            const QString before = (*found)->text();
            for (int clicks = 0; clicks < 20 && (*found)->text() == before; ++clicks) { // few edges of boxes are near the threshold
                QTest::mouseClick(static_cast<Stepper*>((*found)->parentWidget())->more(), Qt::LeftButton);
                QVERIFY(on.settled());
                QTRY_COMPARE((*found)->text(), words());
            }
            QVERIFY((*found)->text() != before);
        }
        QVERIFY(tapEntry(on.window, "cab-images", CloudEntry));
        QTRY_VERIFY(on.viewer.cloud.isVisible() && !on.viewer.views.scene().overGray);
    }

    // While Why waits for a tap, its button is on, as those of the other tools.
    void theButtonOfWhyIsOnWhileItWaits() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        const QToolButton &why = *tool(on.window, "cab-why"), &pin = *tool(on.window, "cab-pin");
        QVERIFY(!why.isChecked() && pin.isChecked());
        press(on.window, "cab-why");
        QVERIFY(why.isChecked() && !pin.isChecked());
        press(on.window, "cab-why");
        QVERIFY(!why.isChecked() && pin.isChecked());
        press(on.window, "cab-why");
        press(on.window, "cab-pin");
        QVERIFY(!why.isChecked() && pin.isChecked());
    }

    // Where a low screen has no stepper next to the numbers, that of Tune has the words.
    void theFirstNumberOfTuneNamesMoreAndFewerEdges() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        press(on.window, "cab-tune");
        const NumbersSide& side = on.window.cab().frame().side();
        const QString first = edges::sweptParameter(on.viewer.engine.settings().method).key;
        for (const auto& [name, words] : {std::pair("meaning-of-less", "More edges"), std::pair("meaning-of-more", "Fewer edges")}) {
            const auto* label = side.stepper(first)->findChild<QLabel*>(name);
            QVERIFY(label != nullptr && label->isVisible());
            QCOMPARE(label->text(), QString(words));
            QVERIFY(side.stepper("method")->findChild<QLabel*>(name)->isHidden());
        }
        QVERIFY2(side.stepper(first)->less()->text() != side.stepper("method")->less()->text(), "minus would be read as fewer edges");
    }

    // A swipe scrolls Tune; a tap still presses, and a button that is held repeats.
    void aSwipeScrollsTune() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        press(on.window, "cab-tune");
        Stepper& method = *on.window.cab().frame().side().stepper("method");
        QWidget* up = &method;
        while (qobject_cast<QScrollArea*>(up) == nullptr) up = up->parentWidget();
        auto& area = *qobject_cast<QScrollArea*>(up);
        QTRY_VERIFY(area.verticalScrollBar()->maximum() > 0);
        const auto swipe = [&](QWidget& from) {
            const QPoint at = from.rect().center();
            QTest::mousePress(&from, Qt::LeftButton, Qt::NoModifier, at);
            for (int n = 1; n <= 12; ++n) {
                const QPoint here = at - QPoint(0, 8 * n);
                QMouseEvent move(QEvent::MouseMove, here, from.mapToGlobal(here), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
                QApplication::sendEvent(&from, &move);
                QTest::qWait(10); // the speed of a finger
            }
            QTest::mouseRelease(&from, Qt::LeftButton, Qt::NoModifier, at - QPoint(0, 96));
        };
        const edges::Settings before = on.viewer.engine.settings();
        swipe(*area.widget());
        QTRY_VERIFY(area.verticalScrollBar()->value() > 20);
        area.verticalScrollBar()->setValue(0);
        swipe(*method.more()); // it begins on a button, which is not pressed
        QTRY_VERIFY(area.verticalScrollBar()->value() > 20);
        QVERIFY(on.viewer.engine.settings() == before);
        QTRY_COMPARE(QScroller::scroller(area.viewport())->state(), QScroller::Inactive);
        area.ensureWidgetVisible(method.more());
        QTest::mouseClick(method.more(), Qt::LeftButton);
        QVERIFY(!(on.viewer.engine.settings() == before));
    }

    // The row with its button stays where it is; over rocks it does not claim that edges are seen.
    void theLegendOfEdgesFoldsInPlace() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {1280, 800});
        const EdgeLegend& legend = on.viewer.legend;
        QVERIFY(eventually([&] { return legend.unfold()->isVisible(); }));
        const QRect folded = placeOf(*legend.unfold()), all = placeOf(*legend.edges());
        QTest::mouseClick(legend.unfold(), Qt::LeftButton);
        QTRY_VERIFY(legend.classSwitch(0)->isVisible());
        QApplication::processEvents();
        QCOMPARE(placeOf(*legend.unfold()), folded);
        QCOMPARE(placeOf(*legend.edges()).center().y(), all.center().y());
        QVERIFY(placeOf(*legend.classSwitch(0)).bottom() <= all.top());
        QTest::mouseClick(legend.unfold(), Qt::LeftButton);
        QCOMPARE(legend.edges()->text(), QString("Edges"));
        on.viewer.rocks.setShown(true);
        QTRY_VERIFY(on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind());
        QTRY_COMPARE(QString(legend.edges()->text()).replace('\n', ' '), QString("Edges, under rocks"));
        QTRY_COMPARE(placeOf(*legend.unfold()), folded);
        // The tick follows what the cloud shows; a tap on it draws the edges over the rocks.
        const CloudView& cloud = on.viewer.cloud;
        const auto tap = [&] {
            QTest::mouseClick(legend.edges(), Qt::LeftButton, Qt::NoModifier, QPoint(12, legend.edges()->height() / 2));
        };
        QVERIFY(!legend.edges()->isChecked() && cloud.edgesVisible());
        tap();
        QTRY_VERIFY(legend.edges()->isChecked() && legend.edges()->text() == "Edges");
        tap();
        QTRY_VERIFY(!legend.edges()->isChecked() && !cloud.edgesVisible());
        tap();
        QTRY_VERIFY(legend.edges()->isChecked() && cloud.edgesVisible());
        on.viewer.rocks.setShown(false);
        QTRY_VERIFY(legend.edges()->isChecked());
        on.window.cab().set(false);
        QCOMPARE(legend.edges()->text(), QString("Edges"));
        QVERIFY(placeOf(*legend.classSwitch(0)).top() >= placeOf(*legend.edges()).bottom());
    }

    // One row of buttons over the low view of a small screen.
    void theComparisonBeginsFoldedOnASmallScreen() {
        WindowFixture on;
        QVERIFY(on.show());
        on.window.cab().set(true);
        resizeTo(on.window, {853, 533});
        on.viewer.comparing.openDemoPair();
        ChangeLegend& legend = on.viewer.changeLegend;
        QVERIFY(eventually([&] { return legend.isVisible() && !legend.counted(ChangeRow::Nearer).isEmpty(); }));
        auto* fold = legend.findChild<QToolButton*>("change-fold");
        const auto* summary = legend.findChild<QLabel*>("change-summary");
        QTRY_VERIFY(fold->isVisible() && legend.next()->isVisible() && summary->isVisible());
        QVERIFY2(summary->text().startsWith("Changes:"), qPrintable(summary->text()));
        for (const ChangeRow row : {ChangeRow::Nearer, ChangeRow::Farther}) // what the colours mean
            QVERIFY2(summary->text().contains(changeColour(row).name()), qPrintable(summary->text()));
        QVERIFY2(summary->text().contains("nearer") && summary->text().contains("farther"), qPrintable(summary->text()));
        QVERIFY(!legend.row(ChangeRow::Nearer)->isVisible() && !legend.previous()->isVisible());
        QVERIFY2(legend.height() <= fold->height() + 48, qPrintable(QString::number(legend.height())));
        const QRect strip = placeOf(on.window.side()), own = placeOf(legend);
        QVERIFY2(strip.left() <= own.left() && own.right() <= strip.right(),
                 qPrintable(QString("%1 to %2 of %3 to %4").arg(own.left()).arg(own.right()).arg(strip.left()).arg(strip.right())));
        // Folded too, each region has its number, and End stays under the finger.
        const auto* last = legend.findChild<QToolButton*>("change-end");
        const QRect endAt = placeOf(*last);
        QTest::mouseClick(legend.next(), Qt::LeftButton);
        QTRY_VERIFY2(summary->text().startsWith("1/15 ") && summary->text().contains("+4.62 m"), qPrintable(summary->text()));
        QTRY_VERIFY(on.viewer.views.cloud().atRest());
        QCOMPARE(placeOf(*last), endAt);
        // A, the difference and B have their buttons on each of the three.
        const auto* ofB = legend.findChild<QToolButton*>("change-shown-2");
        QTest::mouseClick(fold, Qt::LeftButton);
        for (const int shown : {2, 0, 1}) {
            auto* choice = legend.findChild<QToolButton*>(QString("change-shown-%1").arg(shown));
            QTRY_VERIFY2(choice->isVisible() && ofB->isVisible(), qPrintable(QString::number(shown)));
            QApplication::processEvents();
            // The small picture shrinks with the cloud: for a moment a tap is meant for what was there.
            QTRY_VERIFY((QTest::mouseClick(choice, Qt::LeftButton), choice->isChecked()));
        }
        legend.showRegion({});
        if (!fold->isChecked()) QTest::mouseClick(fold, Qt::LeftButton);
        QTRY_VERIFY(summary->isVisible());
        const int bottom = placeOf(*fold).bottom();
        QTest::mouseClick(fold, Qt::LeftButton);
        QTRY_VERIFY(legend.row(ChangeRow::Nearer)->isVisible() && !summary->isVisible());
        QCOMPARE(placeOf(*fold).bottom(), bottom);
        // It stays open when the comparison is made again, of the next sweep.
        const auto made = on.viewer.comparing.comparison();
        legend.showKept({"A", {}}, nullptr, true, false);
        legend.showKept({"A", {}}, &*made, false, false);
        QVERIFY(!fold->isChecked() && legend.row(ChangeRow::Nearer)->isVisible());
        for (const Language& language : kLanguages) { // in the narrowest view
            QVERIFY(useLanguage(language.code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            QWidget view;
            view.resize(416, 383);
            ChangeLegend narrow(&view);
            narrow.setBrief(true);
            narrow.showKept({"A", {}}, &*made, false, false);
            narrow.show();
            view.show();
            QVERIFY(QTest::qWaitForWindowExposed(&view));
            QApplication::processEvents();
            const auto* line = narrow.findChild<QLabel*>("change-summary");
            QVERIFY2(line->isVisible() && narrow.width() <= view.width(),
                     qPrintable(QString("%1: %2 px").arg(language.code).arg(narrow.width())));
            QVERIFY2(line->width() >= line->sizeHint().width(), language.code);
        }
        useLanguage("en");
        // End stays under the finger that goes over the regions.
        const auto* end = legend.findChild<QToolButton*>("change-end");
        for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
            resizeTo(on.window, size);
            QTRY_VERIFY(on.viewer.views.cloud().atRest());
            legend.showRegion({});
            QApplication::processEvents();
            const QRect before = placeOf(*end);
            QTest::mouseClick(legend.next(), Qt::LeftButton);
            QTRY_VERIFY(!legend.regionText().isEmpty() && on.viewer.views.cloud().atRest());
            QCOMPARE(placeOf(*end), before);
        }
    }

    // The line of a saved file has the end of its path. Close stays where it is, whether or not More is there.
    void aNoteShowsTheEndOfAPathAndKeepsItsClose() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        NoticeBar& notice = on.viewer.notice;
        const auto* line = static_cast<const ElidedLabel*>(notice.findChild<QLabel*>("notice-line"));
        const auto buttons = notice.findChildren<QToolButton*>();
        const auto* close = *std::ranges::find_if(buttons, [](const QToolButton* each) { return each->objectName() == "notice-close"; });
        for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
            resizeTo(on.window, size);
            const QString path = QString::fromStdString((folder_ / "a/folder/that/is/far/away/from/the/root/of/all/rocks.csv").string());
            notice.showSaved(path, "12 points");
            QTRY_VERIFY2(line->shown().contains("all/rocks.csv"), qPrintable(line->shown()));
            QVERIFY(notice.text().contains(path));
            // Its buttons share a line.
            QCOMPARE(placeOf(*notice.findChild<QToolButton*>("notice-action")).top(),
                     placeOf(*notice.findChild<QToolButton*>("notice-unfold")).top());
            notice.showNotice(NoticeBar::Kind::Warning, "Short.");
            QApplication::processEvents();
            const QRect before = placeOf(*close);
            notice.hide();
            notice.showNotice(NoticeBar::Kind::Warning, QString("A note of several words. ").repeated(12));
            QTRY_VERIFY(notice.findChild<QToolButton*>("notice-unfold")->isVisible());
            QCOMPARE(placeOf(*close).right(), before.right());
            notice.hide();
        }
    }

    // A tap on the badge shows the name that has no room in it.
    void theBadgeGivesTheWholeName() {
        WindowFixture on;
        const std::string path = (folder_ / "the-north-draw-bell-after-the-third-blast-of-november.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3, 0.02), path)) && on.showWith(path));
        on.window.cab().set(true);
        QTest::mouseClick(on.window.findChild<StateBadge*>("cab-origin"), Qt::LeftButton);
        QVERIFY2(on.viewer.notice.text().contains(QString::fromStdString(on.picture().detection->scan->name)),
                 qPrintable(on.viewer.notice.text()));
    }

    // A tool that is lit ends with a tap on it, or in its menu, and Undo takes back the last point of a measurement that is being made.
    void aLitToolEnds() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QVERIFY(tapEntry(on.window, "cab-measure", 1));
        const QToolButton &measure = *tool(on.window, "cab-measure"), &undo = *tool(on.window, "cab-undo");
        QTRY_VERIFY(on.viewer.measures.kind() && measure.isChecked());
        QVERIFY(!undo.isEnabled());
        QVERIFY(tapEntry(on.window, "cab-images", RangeEntry));
        ImageView& image = on.viewer.gray;
        QTRY_VERIFY(image.isVisible());
        QTest::mouseClick(&image, Qt::LeftButton, Qt::NoModifier, image.rect().center());
        QCOMPARE(on.viewer.measures.picked().size(), std::size_t(1));
        QVERIFY(undo.isEnabled());
        QCOMPARE(undo.accessibleName(), QString("Take the last point back"));
        press(on.window, "cab-undo");
        QVERIFY(on.viewer.measures.picked().empty() && on.viewer.measures.kind() && !undo.isEnabled());
        press(on.window, "cab-measure"); // its menu, as its sign says
        auto* kinds = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(kinds != nullptr && on.viewer.measures.kind());
        const auto entries = kinds->actions();
        const auto end = std::ranges::find(entries, QString("End measuring: Distance"), &QAction::text);
        QVERIFY(end != entries.end() && (*end)->isVisible());
        QCOMPARE(end - entries.begin(), 1); // at its place: the rows do not move, and a tap on one of the others means it
        QCOMPARE(entries[2]->text(), QObject::tr(inspect::measureTraits()[1].label));
        QTest::mouseClick(kinds, Qt::LeftButton, Qt::NoModifier, kinds->actionGeometry(*end).center());
        QTRY_VERIFY(!on.viewer.measures.kind() && !measure.isChecked() && QApplication::activePopupWidget() == nullptr);
        // Why, while a target is chosen.
        on.viewer.views.pin(100 * 240 + 120);
        press(on.window, "cab-why");
        QVERIFY(tool(on.window, "cab-why")->isChecked());
        press(on.window, "cab-why");
        QVERIFY(!tool(on.window, "cab-why")->isChecked());
    }

    // A tap on a label leaves the pointer over what is behind it.
    void theSmallPictureMarksTheTargetNotWhatIsUnderThePointer() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        on.viewer.views.pin(100 * 240 + 120);
        emit on.viewer.views.gray().hovered(20, 30);
        on.viewer.views.pin(100 * 240 + 120);
        emit on.viewer.targets.cardChanged();
        QCOMPARE(on.window.cab().corner().marked().cells.value(0), on.viewer.views.placeOf(100 * 240 + 120));
    }

    // On a low screen the numbers have pages of whole rows and a button for the next page, and Tune has the strength.
    void theNumbersOfALowScreenHavePages() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        on.viewer.views.pin(100 * 240 + 120);
        QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
        QToolButton& page = *tool(on.window, "cab-page");
        QTRY_VERIFY(page.isVisible() && page.height() == 48 && page.text().startsWith("▼"));
        const auto* area = qobject_cast<const QScrollArea*>(page.parentWidget());
        const auto wholeRows = [&] {
            const QRect seen(area->mapToGlobal(QPoint()), QSize(area->width(), area->findChild<QWidget*>("cab-below")->y()));
            QStringList cut;
            for (const QLabel* each : area->widget()->findChildren<QLabel*>()) {
                const QRect place = placeOf(*each);
                if (each->isVisible() && place.intersects(seen) && !seen.adjusted(0, -1, 0, 1).contains(place))
                    cut << QString("%1: %2 to %3 of %4 to %5")
                               .arg(each->text())
                               .arg(place.top())
                               .arg(place.bottom())
                               .arg(seen.top())
                               .arg(seen.bottom());
            }
            return cut.join(", ");
        };
        QTRY_VERIFY2(wholeRows().isEmpty(), qPrintable(wholeRows()));
        const auto *last = area->widget()->findChild<QLabel*>("cab-edge"), *pose = area->widget()->findChild<QLabel*>("cab-pose");
        const QWidget* below = area->findChild<QWidget*>("cab-below");
        QVERIFY(placeOf(*last).top() >= placeOf(*below).top() && pose->text().startsWith("▲"));
        QVERIFY2(placeOf(*pose).bottom() < placeOf(*below).top(), "a warning is on the first page");
        for (int n = 0; n < 4 && !page.text().startsWith("▲"); ++n) {
            QTest::mouseClick(&page, Qt::LeftButton);
            QVERIFY2(wholeRows().isEmpty(), qPrintable(wholeRows()));
            QCOMPARE(page.height(), 48);
        }
        QVERIFY(page.text().startsWith("▲"));
        QTest::mouseClick(&page, Qt::LeftButton);
        QCOMPARE(area->verticalScrollBar()->value(), 0);
        const QToolButton& tune = *tool(on.window, "cab-tune");
        QCOMPARE(tune.text(), "Tune\n" + on.window.cab().frame().side().mainStepper()->value());
        QVERIFY2(!tune.text().endsWith(QLatin1Char(10)) && tune.height() >= tune.sizeHint().height(),
                 qPrintable(QString("%1 of %2").arg(tune.height()).arg(tune.sizeHint().height())));
        // Warnings do not push the coordinates away.
        using Look = FactRow::Look;
        auto* side = on.window.findChild<NumbersSide*>();
        side->show(
            {.title = "Target 1\n1 of 3",
             .rows = {{Look::Number, {"distance", "Distance", "6.52 m", "± 0.02"}},
                      {Look::Warning, {"pose", "", "▲ no pose: no E N RL"}},
                      {Look::Short, {"x", "X [m]", "-0.512"}},
                      {Look::Short, {"y", "Y", "1.234"}},
                      {Look::Short, {"z", "Z", "6.301"}},
                      {Look::Warning,
                       {"warned", "", "▲ the click was 6 cells away, on another surface\n▲ a second warning that needs two lines"}}}});
        QApplication::processEvents();
        for (const QLabel* each : side->findChildren<QLabel*>()) {
            if (each->text() != "6.301" && each->text() != "-0.512") continue;
            QVERIFY2(each->isVisible() && (!below->isVisible() || placeOf(*each).bottom() < placeOf(*below).top()),
                     qPrintable(each->text()));
        }
        // Of many warnings the first ones are next to their number.
        SideFacts throat{.title = "W1",
                         .rows = {{Look::Number, {"distance", "Throat Width", "1.61 m"}},
                                  {Look::Warning, {"warned", "", QString("▲ a warning\n").repeated(16).trimmed()}}}};
        side->show(throat);
        const auto* warned = area->widget()->findChild<QLabel*>("cab-warned");
        QTRY_VERIFY(page.isVisible() && placeOf(*warned).top() + warned->fontMetrics().lineSpacing() <= placeOf(*below).top());
        throat.rows.pop_back();
        side->show(throat);
        resizeTo(on.window, {1280, 800});
        QTRY_VERIFY(!page.isVisible());
        QCOMPARE(tune.text(), QString("Tune"));
    }

    // The scroll bar of the settings is next to their buttons, and not over them.
    void theBarOfTheSettingsCoversNoButton() {
        for (const Language& language : kLanguages) {
            QVERIFY(useTexts(language.code));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            press(on.window, "cab-tune");
            auto& side = *on.window.findChild<NumbersSide*>();
            for (const QSize size : {QSize(853, 480), QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
                resizeTo(on.window, size);
                QTRY_VERIFY(side.stepper("sensitivity")->isVisible());
                QTRY_VERIFY2(faultsIn(side).isEmpty(), qPrintable(QString(language.code) + ' ' + faultsIn(side).join('\n')));
                for (const auto* each : side.findChildren<QToolButton*>())
                    QVERIFY2(!each->isVisible() || (each->width() >= kGlovePx && each->height() >= kGlovePx), qPrintable(each->text()));
            }
            on.window.cab().set(false);
        }
        useLanguage("en");
    }

    // Each small picture shows its name. On a low screen the name is over the picture.
    void theSmallPictureHasItsName() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        for (const QSize size : {QSize(853, 480), QSize(1280, 800)}) {
            resizeTo(on.window, size);
            CornerPicture& small = on.window.cab().corner();
            QTRY_VERIFY(small.isVisible());
            const QImage drawn = small.grab().toImage();
            const auto isLetter = [](QRgb p) { return p == qRgb(0xe8, 0xe8, 0xe8); };
            const int line = small.fontMetrics().height();
            QVERIFY2(countPixels(drawn.copy(0, drawn.height() - line, drawn.width() / 2, line), isLetter) > 20,
                     qPrintable(QString::number(size.width())));
        }
    }

    // The size of a chosen rock and its ± are on the first page, in each language, with and without a pose.
    void theSizeOfAChosenRockIsSeenAtOnce() {
        for (const Language& language : kLanguages) {
            QVERIFY(useTexts(language.code));
            WindowFixture on;
            QVERIFY(on.showWith(test::savedBell(folder_ / "bell.json")));
            on.window.cab().set(true);
            resizeTo(on.window, {853, 480});
            on.viewer.rocks.setShown(true);
            QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.picture()->study.rocks.empty(); }));
            on.viewer.rocks.select({on.viewer.rocks.picture()->study.rocks.front().cell});
            QTRY_VERIFY(on.window.findChild<QLabel*>("cab-size") != nullptr);
            const QLabel *size = on.window.findChild<QLabel*>("cab-size"), *tolerance = on.window.findChild<QLabel*>("cab-size-tolerance");
            const QToolButton& page = *tool(on.window, "cab-page");
            const QWidget* below = page.parentWidget()->findChild<QWidget*>("cab-below");
            const auto isSeen = [&](const QLabel& each) {
                const int end = below->isVisible() ? placeOf(*below).top() : placeOf(*page.parentWidget()).bottom();
                return each.isVisible() && !each.text().isEmpty() && placeOf(each).bottom() <= end;
            };
            QTRY_VERIFY2(isSeen(*size) && isSeen(*tolerance), qPrintable(QString(language.code) + size->text() + tolerance->text()));
            QVERIFY(tolerance->text().startsWith("±"));
            on.window.cab().set(false);
        }
        useLanguage("en");
    }

    // After Connect the state is in sight, before any line came; after Stop nothing of it is left.
    void aScannerWithoutALineSaysItsState() {
        WindowFixture on;
        QVERIFY(on.show());
        on.window.cab().set(true);
        on.viewer.live.connectTo("127.0.0.1", 1, {}); // nothing listens there
        QTRY_COMPARE(on.window.findChild<QLabel*>("cab-name")->toolTip(), QString("Scanner"));
        QCOMPARE(on.viewer.live.panel().isVisible(), true);
        QTRY_VERIFY(!on.window.findChild<StateBadge*>("cab-origin")->accessibleName().contains("NO PICTURE"));
        QVERIFY(!on.viewer.live.waitsFor().isEmpty());
        press(on.window, "live-connect");
        QTRY_COMPARE(on.window.findChild<QLabel*>("cab-name")->toolTip(), QString("No scan"));
        QVERIFY2(!on.viewer.notice.isVisible(), qPrintable(on.viewer.notice.text()));
    }
};

int cab_views_test(int argc, char** argv) { return runWindowTest<CabViewsTest>(argc, argv); }
#include "cab_views_test.moc"
