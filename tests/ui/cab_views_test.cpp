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
#include "ui/panels/change/change_legend.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/edges_panel.h"
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
        press(on.window, "cab-tune");
        press(on.window, "more-sensitivity");
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

    // While + and − change the settings, the edges are seen in the large range image.
    void theLargeRangeImageHasTheEdges() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QVERIFY(!on.viewer.views.scene().overGray);
        QVERIFY(tapEntry(on.window, "cab-images", RangeEntry));
        QTRY_VERIFY(on.viewer.gray.isVisible() && on.viewer.views.scene().overGray);
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

    // At the ends of the slider of a threshold are arrows, and words say which one gives fewer edges: a plus would lower its number.
    void wordsSayWhatGivesFewerEdges() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        press(on.window, "cab-tune");
        const QString key = edges::sweptParameter(on.viewer.engine.settings().method).key;
        for (const auto& [name, sign, words, fewer] :
             {std::tuple("more-", "▶", "Fewer edges", true), std::tuple("less-", "◀", "More edges", false)}) {
            auto* button = on.viewer.panel.findChild<QToolButton*>(name + key);
            const auto* label = on.viewer.panel.findChild<QLabel*>("meaning-of-" + (name + key));
            QTRY_VERIFY(button->visibleRegion().boundingRect() == button->rect() && label->isVisible());
            QCOMPARE(button->text(), QString(sign));
            QCOMPARE(label->text(), QString(words));
            const auto edges = [&] { return on.picture().detection->edges->size(); };
            const auto before = edges();
            for (int clicks = 0; clicks < 80 && edges() == before; ++clicks) { // few edges of boxes are near the threshold
                QTest::mouseClick(button, Qt::LeftButton);
                QVERIFY(on.settled());
            }
            QVERIFY2(
                fewer ? edges() < before : edges() > before,
                qPrintable(QString("%1: %2 to %3, %4").arg(sign).arg(before).arg(edges()).arg(on.viewer.engine.settings().sensitivity)));
        }
        QCOMPARE(on.viewer.panel.findChild<QToolButton*>("more-crease")->text(), QString("+"));
    }

    // A swipe scrolls Tune; a tap still presses, and a button that is held repeats.
    void aSwipeScrollsTune() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        press(on.window, "cab-tune");
        auto& button = *on.viewer.panel.findChild<QToolButton*>("more-sensitivity");
        auto& area = *on.viewer.panel.findChild<QScrollArea*>();
        QTRY_VERIFY(button.visibleRegion().boundingRect() == button.rect());
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
        const int from = area.verticalScrollBar()->value();
        swipe(button); // it begins on a button, which is not pressed
        QTRY_VERIFY(area.verticalScrollBar()->value() > from + 20);
        QVERIFY(on.viewer.engine.settings() == before);
        QTRY_COMPARE(QScroller::scroller(area.viewport())->state(), QScroller::Inactive);
        area.ensureWidgetVisible(&button);
        QTest::mouseClick(&button, Qt::LeftButton);
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
        QVERIFY2(legend.edges()->text().startsWith("Edges\n"), qPrintable(legend.edges()->text())); // and their number
        on.viewer.rocks.setShown(true);
        QTRY_VERIFY(on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind());
        QTRY_VERIFY(QString(legend.edges()->text()).replace(QChar(10), QChar(32)).startsWith("Edges, under rocks "));
        QTRY_COMPARE(placeOf(*legend.unfold()), folded);
        // The tick follows what the cloud shows; a tap on it draws the edges over the rocks.
        const CloudView& cloud = on.viewer.cloud;
        const auto tap = [&] {
            QTest::mouseClick(legend.edges(), Qt::LeftButton, Qt::NoModifier, QPoint(12, legend.edges()->height() / 2));
        };
        QVERIFY(!legend.edges()->isChecked() && cloud.edgesVisible());
        tap();
        QTRY_VERIFY(legend.edges()->isChecked() && legend.edges()->text().startsWith("Edges\n"));
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
            QTRY_VERIFY2(line->shown().contains(size.width() < 1024 ? "…/rocks.csv" : "all/rocks.csv"), qPrintable(line->shown()));
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
        const auto lit = std::ranges::find_if(entries, &QAction::isChecked);
        QVERIFY(lit != entries.end() && (*lit)->isVisible());
        QTest::mouseClick(kinds, Qt::LeftButton, Qt::NoModifier, kinds->actionGeometry(*lit).center());
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

    // The size of a chosen rock is in sight, in each language.
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
            const auto* size = on.viewer.rocksPanel.card().findChild<QLabel*>("rock-spans");
            QTRY_VERIFY2(!size->text().isEmpty() && size->visibleRegion().boundingRect() == size->rect(), language.code);
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
