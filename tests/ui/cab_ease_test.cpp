// Cab mode says what it does and what is on the screen: Redo, Why, rocks and targets, what runs, what is shortened.
#include "core/edges/explain/cell_values.h"
#include "tests/support/folders.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/sized_window.h"
#include "ui/base/elided_label.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/cab/keypad.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/dialogs/report_form.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/views/cloud/scale_plate.h"
#include "ui/window/cab_mode.h"
#include "ui/window/side_column.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"

#include <QComboBox>
#include <QCommandLinkButton>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::ui;

class CabEaseTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;

    static void press(MainWindow& window, const char* name) { QTest::mouseClick(tool(window, name), Qt::LeftButton); }
    static QRect placeOf(const QWidget& of) { return {of.mapToGlobal(QPoint()), of.size()}; }
    static bool showsRocks(WindowFixture& on) {
        on.viewer.rocks.setShown(true);
        return eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); });
    }
    /// A finger on this cell of the range image.
    static void tapCell(ImageView& image, const QPoint& cell) {
        const QPointF at = image.viewPort()->toPixel(QPointF(cell) + QPointF(0.5, 0.5), image.size());
        QTest::mouseClick(&image, Qt::LeftButton, Qt::NoModifier, at.toPoint());
    }

    /// The demo before and after a blast, with its counts.
    static bool comparesInCab(WindowFixture& on, const QSize& size) {
        if (!on.show()) return false;
        on.window.cab().set(true);
        resizeTo(on.window, size);
        on.viewer.comparing.openDemoPair();
        const ChangeLegend& legend = on.viewer.changeLegend;
        return eventually([&] { return legend.isVisible() && !legend.counted(ChangeRow::Nearer).isEmpty(); });
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(200, 240, 3, 0.02), scan_)));
    }
    void cleanup() {
        useLanguage("en");
        useTheme(*qApp, false);
    }

    // A comparison opens another scan: the side says what became of the targets, and that its numbers are of B while A is shown.
    void aComparisonSaysWhatBelongsToWhichScan() {
        QDir().mkpath(QString::fromStdString((folder_ / "kept").string()));
        WindowFixture on(QString::fromStdString((folder_ / "kept" / "viewer.ini").string())); // targets are stored with settings only
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, QSize(1280, 800));
        on.viewer.views.pin(100 * 240 + 120);
        on.viewer.comparing.openDemoPair();
        const ChangeLegend& legend = on.viewer.changeLegend;
        QVERIFY(eventually([&] { return legend.isVisible() && !legend.counted(ChangeRow::Nearer).isEmpty(); }));
        const auto labels = on.window.cab().frame().panels().findChildren<QLabel*>();
        QVERIFY(eventually([&] {
            return std::ranges::any_of(labels, [](const QLabel* each) {
                return each->isVisible() && each->text().startsWith("Targets and measurements of the previous scan: 1.");
            });
        }));
        const auto* ofB = on.window.findChild<QLabel*>("cab-of-b");
        QVERIFY(!ofB->isVisible());
        on.viewer.comparing.flip(true);
        QTRY_VERIFY2(ofB->isVisible() && ofB->text() == "Targets · B", qPrintable(ofB->text()));
        on.viewer.comparing.flip(false);
        QTRY_VERIFY(!ofB->isVisible());
        on.window.cab().set(false);
    }

    // Redo is next to Undo on every screen, and both are whole.
    void whatWasUndoneIsDoneAgain() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QToolButton *undo = tool(on.window, "cab-undo"), *redo = tool(on.window, "cab-redo");
        QVERIFY(!redo->isEnabled());
        on.viewer.views.pin(100 * 240 + 120);
        press(on.window, "cab-undo");
        QVERIFY(on.viewer.targets.notebook().targets.empty() && redo->isEnabled());
        QVERIFY2(redo->toolTip().startsWith("Redo new target 1"), qPrintable(redo->toolTip()));
        press(on.window, "cab-redo");
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        QVERIFY(!redo->isEnabled());
        for (const QSize size : {QSize(853, 480), QSize(1024, 743), QSize(1280, 700), QSize(1280, 800), QSize(1920, 1040)}) {
            resizeTo(on.window, size);
            const QRect column = placeOf(on.window.cab().frame().tools()), a = placeOf(*undo), b = placeOf(*redo);
            QVERIFY(column.contains(a) && column.contains(b) && !a.intersects(b) && redo->height() >= kGlovePx);
            const bool sideBySide = a.top() == b.top() && b.left() - a.right() < 12,
                       above = a.left() == b.left() && a.top() - b.bottom() < 48;
            QVERIFY2(sideBySide || above, qPrintable(QString::number(size.height())));
            for (const auto* each : on.window.cab().frame().tools().findChildren<QToolButton*>())
                QVERIFY2(placeOf(*each).bottom() <= a.bottom(), "Undo is the lowest");
        }
        // What was undone in another scan cannot be done again: the buttons say so.
        press(on.window, "cab-undo");
        QVERIFY(redo->isEnabled());
        on.viewer.files.openDemo();
        QVERIFY(on.settled() && eventually([&] { return on.viewer.files.demo().has_value(); }));
        QTRY_VERIFY(!redo->isEnabled() && !undo->isEnabled());
        QVERIFY2(!redo->toolTip().contains("target"), qPrintable(redo->toolTip()));
    }

    // The table of rocks covers the views, with rows for gloves, and widens nothing. At the desk it is a dock again.
    void theRockTableCoversTheViews() {
        WindowFixture on;
        QVERIFY(on.showWith(test::savedBell(folder_ / "bell.json")));
        auto* dock = on.window.findChild<QDockWidget*>("dock-rock-table");
        QTableView* table = on.viewer.rockTable.table();
        for (const QSize size : {QSize(853, 480), QSize(1280, 800)}) {
            on.window.cab().set(true);
            resizeTo(on.window, size);
            QVERIFY(showsRocks(on));
            QVERIFY(dock->isHidden() && dock->toggleViewAction()->isEnabled());
            dock->toggleViewAction()->trigger();
            QTRY_VERIFY(dock->isVisible() && placeOf(*dock).contains(placeOf(on.viewer.cloud)));
            QCOMPARE(on.window.size(), size);
            QVERIFY(!placeOf(*dock).intersects(placeOf(on.window.cab().frame().panels())));
            QVERIFY(!placeOf(*dock).intersects(placeOf(on.window.cab().frame().tools())));
            QTRY_VERIFY(table->rowHeight(0) >= kGlovePx && table->horizontalHeader()->height() >= kGlovePx);
            QVERIFY2(table->viewport()->height() >= (size.height() < 500 ? 2 : 3) * kGlovePx,
                     qPrintable(QString::number(table->viewport()->height())));
            QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(table->model()->index(0, 1)).center());
            QTRY_VERIFY(on.viewer.rocksPanel.card().isVisible());
            auto* close = dock->titleBarWidget()->findChild<QToolButton*>("fold");
            QVERIFY(close->text().contains("Close") && close->height() >= kGlovePx);
            QTest::mouseClick(close, Qt::LeftButton);
            QVERIFY(dock->isHidden());
            QCOMPARE(on.window.size(), size);
            dock->toggleViewAction()->trigger();
            on.window.cab().set(false);
            resizeTo(on.window, {1366, 768});
            QTRY_VERIFY(!dock->isHidden() && on.window.tabifiedDockWidgets(dock).contains(on.window.findChild<QDockWidget*>("dock-rocks")));
            QVERIFY(table->rowHeight(0) < kGlovePx);
            on.viewer.rocks.setShown(false);
        }
    }

    // No entry is for a keyboard, a mouse or the docks. A long menu ends with a row that does nothing, where its lower arrow was.
    void menusOfACabAreForTaps() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        const auto shown = [&](const char* text) {
            for (const QAction* each : on.window.findChildren<QAction*>()) {
                if (each->text().remove('&') == text) return each->isVisible();
            }
            return false;
        };
        const char* const ofDesk[] = {"Fly to Point under Cursor", "Panels",        "Mouse", "Sizes of Views", "Reset Layout",
                                      "Find a Command…",           "Keys and Mouse"};
        for (const bool cab : {true, false}) {
            on.window.cab().set(cab);
            for (const char* text : ofDesk) QVERIFY2(shown(text) != cab, text);
            QVERIFY(shown("Split a Rock"));
        }
        on.window.cab().set(true);
        const int high = on.window.screen()->availableGeometry().height();
        for (const int rows : {3, high / kGlovePx + 2}) {
            QMenu menu(&on.window);
            for (int n = 0; n < rows; ++n) menu.addAction(QString::number(n));
            menu.popup(QPoint());
            QAction* last = menu.actions().back();
            QCOMPARE(last->isEnabled(), rows == 3);
            QCOMPARE(last->objectName() == "end-of-menu", rows != 3);
            menu.close();
            QCOMPARE(menu.actions().size(), rows);
        }
    }

    // While rocks are shown a tap chooses a rock. Only Pin sets a target.
    void aTapOnARockPinsNothing() {
        WindowFixture on;
        QVERIFY(on.showWith(test::savedBell(folder_ / "bell.json")));
        on.window.cab().set(true);
        resizeTo(on.window, {1280, 800});
        press(on.window, "cab-rocks");
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }));
        QToolButton* pin = tool(on.window, "cab-pin");
        QVERIFY(!pin->isChecked());
        QVERIFY(tapEntry(on.window, "cab-images", RangeEntry));
        ImageView& image = on.viewer.gray;
        QTRY_VERIFY(image.isVisible());
        const rocks::Rock& rock = on.viewer.rocks.picture()->study.rocks.front();
        const QPoint at = on.viewer.views.placeOf(rock.cell);
        tapCell(image, at);
        const RockCard& card = on.viewer.rocksPanel.card();
        QTRY_VERIFY2(card.isVisible() && card.text().startsWith(QString("Rock %1").arg(rock.label)), qPrintable(card.text()));
        QVERIFY(on.viewer.targets.notebook().targets.empty());
        on.viewer.rocks.select({});
        press(on.window, "cab-pin");
        QVERIFY(pin->isChecked());
        tapCell(image, at);
        QTRY_COMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        // Its mark is chosen again by a tap, also while a tap pins nothing.
        press(on.window, "cab-pin");
        QVERIFY(!pin->isChecked());
        on.viewer.views.pin(std::nullopt);
        QTRY_VERIFY(!image.tags().empty()); // drawn
        tapCell(image, on.viewer.views.placeOf(on.viewer.targets.notebook().targets.front().cell));
        QTRY_VERIFY(on.viewer.targetsPanel.card().isVisible());
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        // Without rocks a tap pins; with them a click chooses a rock on the desk, too.
        press(on.window, "cab-rocks");
        QVERIFY(pin->isChecked());
        press(on.window, "cab-rocks");
        on.window.cab().set(false);
        QVERIFY(on.viewer.views.choosesOnly());
    }

    // The card has a title and leaves the tools free; the cell that it explains is marked in image and cloud.
    void whyMarksItsCellAndLeavesTheToolsFree() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        const std::size_t edge = on.picture().detection->edges->at(on.picture().detection->edges->size() / 2);
        for (const QSize size : {QSize(853, 480), QSize(1024, 768), QSize(1280, 800)}) {
            resizeTo(on.window, size);
            for (const std::size_t cell : {edge, edge + 3}) {
                on.viewer.explanation.explain(inspect::exactly(cell), Explanation::Subject::Click);
                const WhyCard& card = *on.viewer.explanation.card();
                QTRY_VERIFY(card.isVisible() && !card.findChild<QLabel*>("why-plain")->text().isEmpty());
                const auto* question = card.findChild<QLabel*>("why-question");
                QVERIFY(question->isVisible() && question->text().endsWith('?'));
                QVERIFY(placeOf(*question).bottom() < placeOf(*card.findChild<QLabel*>("why-plain")).top());
                QVERIFY2(!placeOf(on.window.cab().frame().tools()).intersects(card.frameGeometry()),
                         qPrintable(QString::number(size.width())));
                const auto marks = on.viewer.views.cloud().marks().targets;
                QVERIFY(on.viewer.views.gray().marks().targets == marks);
                QVERIFY2(std::ranges::any_of(marks, [&](const TargetMark& mark) { return mark.tag == "Why" && !mark.isTarget; }),
                         qPrintable(QString::number(marks.size())));
            }
            on.viewer.explanation.closeCard();
            QVERIFY(on.viewer.views.cloud().marks().targets.empty());
        }
        // Another tool ends it.
        const auto explain = [&] {
            on.viewer.explanation.explain(inspect::exactly(edge), Explanation::Subject::Click);
            return on.viewer.explanation.card()->isVisible();
        };
        QVERIFY(explain());
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        QVERIFY(!on.viewer.explanation.card()->isVisible() && on.viewer.views.tool() == Tool::Measure);
        QVERIFY(explain());
        QTest::mouseClick(tool(on.window, "cab-pin"), Qt::LeftButton);
        QVERIFY(!on.viewer.explanation.card()->isVisible() && on.viewer.views.tool() == Tool::Pin);
    }

    // The rows of a menu stay where they are, and one of several views is not a box to tick. No letter is underlined.
    void theMenuOfImagesIsTheSameOverEachView() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        const auto rows = [&] {
            press(on.window, "cab-images");
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            const auto count = menu->actions().size();
            for (const QAction* each : menu->actions().mid(1, 3)) {
                if (!each->isCheckable() || each->actionGroup() == nullptr || !each->actionGroup()->isExclusive()) return -1;
            }
            menu->close();
            return static_cast<int>(count);
        };
        const int overCloud = rows();
        QVERIFY(overCloud > 4);
        QVERIFY(tapEntry(on.window, "cab-images", EdgesEntry));
        QCOMPARE(rows(), overCloud);
        // Its last row has the directions of the cloud, which becomes large.
        press(on.window, "cab-images");
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QMenu* directions = menu->actions().back()->menu();
        QVERIFY(directions != nullptr);
        menu->close();
        const auto entries = directions->actions();
        const auto top = std::ranges::find_if(entries, [](const QAction* each) { return each->text().remove('&').startsWith("Top"); });
        QVERIFY(top != entries.end() && !on.viewer.cloud.isVisible());
        (*top)->trigger();
        QTRY_VERIFY(on.viewer.cloud.isVisible());
        QVERIFY(on.viewer.cloud.camera().forward().isApprox(-on.viewer.cloud.axes().up));
        QVERIFY(qApp->style()->styleHint(QStyle::SH_UnderlineShortcut) == 0);
        on.window.cab().set(false);
        QVERIFY(qApp->style()->styleHint(QStyle::SH_UnderlineShortcut) != 0);
    }

    // What is shortened has its number first, or its end.
    void whatIsShortenedKeepsItsNumberAndItsName() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {853, 480});
        const auto work = on.viewer.engine.works().start("Simulating a demo draw-bell that has a long name", [] {});
        work->progress("tracing the beams of all lines", 0.34);
        const auto* facts = static_cast<const ElidedLabel*>(on.window.findChild<QLabel*>("cab-facts"));
        QTRY_VERIFY2(facts->shown().startsWith("34 %"), qPrintable(facts->shown()));
        const auto* line = static_cast<const ElidedLabel*>(on.viewer.notice.findChild<QLabel*>("notice-line"));
        const QString name = "the-north-draw-bell-after-the-third-blast-of-november-seen-from-the-west-drift-with-the-new-mast.json";
        on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "The file " + QString(4, 'x') + name + " has 12,345 points beyond 80 m.");
        QVERIFY2(eventually([&] { return line->shown().contains("…-mast.json"); }), qPrintable(line->shown()));
        for (const QString& each : line->shown().split("…")) QVERIFY(line->text().contains(each.left(10)));
        // A sentence ends after a whole word.
        const QString sentences = QString("Numbers follow each other in the wrong order in a telegram. ").repeated(6).trimmed();
        on.viewer.notice.showNotice(NoticeBar::Kind::Warning, sentences);
        QTRY_VERIFY2(line->shown().endsWith("…") && sentences.startsWith(line->shown().chopped(1)), qPrintable(line->shown()));
        QCOMPARE(sentences[line->shown().size() - 1], QChar(' '));
    }

    // The scale is in the smallest view too: the bar alone.
    void theScaleIsOnEveryScreen() {
        for (const Language& language : kLanguages) {
            QVERIFY(useTexts(language.code));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            for (const QSize size : {QSize(853, 480), QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
                resizeTo(on.window, size);
                const ScalePlate& scale = on.viewer.scalePlate;
                const QByteArray where = QString("%1 at %2 x %3").arg(language.code).arg(size.width()).arg(size.height()).toUtf8();
                QTRY_VERIFY2(scale.isVisible() && !scale.barText().isEmpty(), where);
                QTRY_VERIFY2(placeOf(on.window.side()).contains(placeOf(scale)), where);
            }
        }
    }

    // Above the keys each field of the form can be reached, and the buttons are in sight.
    void theKeysLeaveEveryFieldOfTheReport() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        ReportForm form({}, &on.window);
        form.show();
        form.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&form));
        for (QWidget* each : form.findChildren<QWidget*>()) {
            const bool isField = qobject_cast<QLineEdit*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr ||
                                 qobject_cast<QAbstractButton*>(each) != nullptr;
            if (isField && each->isVisible()) QVERIFY2(each->height() >= kGlovePx, qPrintable(each->objectName()));
        }
        auto* site = form.findChild<QLineEdit*>("report-site");
        auto* format = form.findChild<QComboBox*>("report-format");
        form.setGeometry(100, 0, form.width(), 400); // a low screen
        QTest::mouseClick(site, Qt::LeftButton);
        site->setFocus();
        const Keypad& pad = on.window.cab().keypad();
        QTRY_VERIFY(pad.isVisible());
        form.resize(form.width(), 260); // as on a screen of 480
        QApplication::processEvents();
        auto* area = form.findChild<QScrollArea*>();
        QVERIFY(area != nullptr);
        area->ensureWidgetVisible(format);
        QVERIFY(placeOf(*area->viewport()).intersects(placeOf(*format)));
        QVERIFY(!pad.place().intersects(placeOf(*form.findChild<QDialogButtonBox*>())));
        QCOMPARE(form.height(), 260);
    }

    // The plate of a comparison is not over the change that it names first, and its buttons are for gloves.
    void theComparisonLeavesItsChangeFree() {
        for (const QSize size : {QSize(853, 533), QSize(1280, 800)}) {
            WindowFixture on;
            QVERIFY(comparesInCab(on, size));
            ChangeLegend& legend = on.viewer.changeLegend;
            const CloudView& cloud = on.viewer.cloud;
            QTRY_VERIFY(cloud.atRest() && on.viewer.comparing.settled());
            for (int n = 0; n < 2; ++n) { // before and after the first tap on Next
                const auto isFree = [&] {
                    const auto at = cloud.pixelOf(on.viewer.comparing.someOfRegion().front());
                    return at && cloud.rect().contains(at->toPoint());
                };
                QTRY_VERIFY2(isFree(), qPrintable(QString("%1, %2").arg(size.width()).arg(n)));
                for (const auto* each : legend.findChildren<QToolButton*>())
                    QVERIFY2(!each->isVisible() || (each->width() >= kGlovePx && each->height() >= kGlovePx),
                             qPrintable(each->objectName()));
                QVERIFY2(legend.height() < cloud.height() / 3, qPrintable(QString::number(legend.height())));
                QTest::mouseClick(legend.next(), Qt::LeftButton);
                QTRY_VERIFY(cloud.atRest());
            }
        }
    }

    // A note of two rows comes above the buttons of the start page: no button moves under a finger.
    void aNoteMovesNoButtonOfTheStartPage() {
        for (const QSize size : {QSize(853, 480), QSize(853, 533), QSize(1280, 800)}) {
            WindowFixture on;
            QVERIFY(on.show());
            StartPage* page = showStart(on.window, on.preferences);
            on.window.cab().set(true);
            resizeTo(on.window, size);
            const auto* first = page->findChild<QCommandLinkButton*>("start-open");
            QTRY_VERIFY(first->isVisible());
            const QRect before = placeOf(*first);
            NoticeBar& notice = on.viewer.notice;
            for (int n = 0; n < 3; ++n)
                notice.showNotice(NoticeBar::Kind::Warning,
                                  QString::number(n) + QString(" numbers follow each other in the wrong order").repeated(5));
            notice.offer("Does this look right?", [] {});
            QTRY_VERIFY(notice.isVisible());
            for (int n = 0; n < 5; ++n) QApplication::processEvents();
            const QByteArray where = QString("%1: %2 px, %3 to %4")
                                         .arg(size.height())
                                         .arg(notice.height())
                                         .arg(before.top())
                                         .arg(placeOf(*first).top())
                                         .toUtf8();
            QVERIFY2(placeOf(*first) == before, where);
            QVERIFY2(!placeOf(notice).intersects(before), where);
        }
    }

    // The buttons of the start page are whole, and the fields of a scanner lead back to it.
    void theStartPageIsWholeAndComesBack() {
        for (const Language& language : kLanguages) {
            QVERIFY(useTexts(language.code));
            WindowFixture on;
            QVERIFY(on.show());
            StartPage* page = showStart(on.window, on.preferences);
            on.window.cab().set(true);
            for (const QSize size : {QSize(853, 480), QSize(853, 533), QSize(1024, 768), QSize(1280, 800)}) {
                resizeTo(on.window, size);
                for (int n = 0; n < 5; ++n) QApplication::processEvents();
                for (const auto* each : page->findChildren<QCommandLinkButton*>()) {
                    const QString where = QString("%1: %2 at %3").arg(language.code, each->objectName()).arg(size.height());
                    QTRY_VERIFY2(placeOf(*page).contains(placeOf(*each)), qPrintable(where));
                }
            }
            QVERIFY(on.activate()); // the field of the address gets the focus, and with it the keys
            press(on.window, "cab-connect");
            QTRY_VERIFY(!page->isVisible() && on.viewer.livePanel.isVisible());
            auto* close = on.viewer.livePanel.findChild<QToolButton*>("live-close");
            QVERIFY(close->isVisible() && close->height() >= kGlovePx);
            const Keypad& pad = on.window.cab().keypad(); // for the field of the address
            for (const QSize size : {QSize(1024, 600), QSize(853, 480)}) {
                resizeTo(on.window, size);
                QTRY_VERIFY2(pad.isVisible() && !pad.place().intersects(placeOf(*close)), language.code);
            }
            QTest::mouseClick(close, Qt::LeftButton);
            QTRY_VERIFY(page->isVisible() && !on.viewer.livePanel.isVisible());
        }
    }
};

int cab_ease_test(int argc, char** argv) { return runWindowTest<CabEaseTest>(argc, argv); }
#include "cab_ease_test.moc"
