// The tour: on the first start only, ended at any time, opened again from the menu, and covering nothing; the demo before and after a blast
// by one click.
#include "tests/support/folders.h"
#include "tests/support/run_program.h"
#include "tests/ui/whole_widgets.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/start/tour.h"
#include "ui/window/cab_mode.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::ui;

struct FirstStart : WindowFixture {
    explicit FirstStart(const QString& ini = {}) : WindowFixture(ini), tour(*window.findChild<Tour*>("tour")) {}

    bool begin() {
        if (!show()) return false;
        page = showStart(window, preferences);
        return page->isVisible() && activate();
    }
    void click(const char* name) { QTest::mouseClick(window.findChild<QAbstractButton*>(name), Qt::LeftButton); }

    Tour& tour;
    StartPage* page = nullptr;
};

class TourTest : public QObject {
    Q_OBJECT
    edgescan::test::TemporaryFolder folder_;
    QString ini_ = QString::fromStdString((folder_ / "viewer.ini").string());

private slots:
    void initTestCase() { useTheme(*qApp); }
    void init() { QFile::remove(ini_); }
    void cleanup() { useLanguage("en"); }

    void itIsOfferedOnceOnTheFirstStart_data() {
        QTest::addColumn<QString>("way");
        for (const char* way : {"Esc", "button", "last step", "the window is closed"}) QTest::newRow(way) << QString(way);
    }
    void itIsOfferedOnceOnTheFirstStart() {
        QFETCH(QString, way);
        {
            FirstStart on(ini_);
            QVERIFY(on.begin());
            QVERIFY(on.tour.isVisible());
            QCOMPARE(on.tour.step(), 0);
            on.click("tour-next");
            QCOMPARE(on.tour.step(), 1);
            on.click("tour-back");
            QCOMPARE(on.tour.step(), 0);
            if (way == "Esc") QTest::keyClick(&on.window, Qt::Key_Escape);
            if (way == "button") on.click("tour-end");
            for (int n = 0; way == "last step" && n < Tour::kSteps; ++n) on.click("tour-next");
            QCOMPARE(on.tour.isVisible(), way == "the window is closed");
        }
        FirstStart again(ini_);
        QVERIFY(again.begin());
        QVERIFY(!again.tour.isVisible());
        for (QAction* action : again.window.findChildren<QAction*>()) {
            if (action->text() == "&Tour") action->trigger();
        }
        QVERIFY(again.tour.isVisible());
        QCOMPARE(again.tour.step(), 0);
    }

    void withoutSettingsItIsNotShownBecauseItsEndCouldNotBeStored() {
        FirstStart on;
        QVERIFY(on.begin());
        QVERIFY(!on.tour.isVisible());
    }

    void aCabHidesIt() {
        FirstStart on(ini_);
        QVERIFY(on.begin());
        on.window.cab().set(true);
        QVERIFY(!on.tour.isVisible());
        on.window.cab().set(false);
        QVERIFY(on.tour.isVisible());
    }

    void theFirstStepIsDoneWhenAScanIsOpenWhicheverWay() {
        FirstStart on(ini_);
        QVERIFY(on.begin());
        QCOMPARE(on.tour.step(), 0);
        on.click("start-demo"); // of the start page, not of the tour
        auto* button = on.window.findChild<QAbstractButton*>("tour-try");
        QTRY_VERIFY2(!button->isEnabled() || on.tour.step() == 1, "the demo is being opened");
        QVERIFY(eventually([&] { return on.tour.step() == 1; }));
        QVERIFY(button->isEnabled());
        // What was done has a tick.
        const auto isTicked = [&](int step) {
            on.tour.showStep(step);
            const auto labels = on.tour.findChildren<QLabel*>();
            return std::ranges::any_of(labels, [](const QLabel* each) { return each->text().startsWith("✓"); });
        };
        QVERIFY(isTicked(0) && !isTicked(1));
        on.click("tour-try");
        QVERIFY(isTicked(1) && !isTicked(2));
        on.tour.showStep(3);
        QVERIFY(on.open(edgescan::test::sourceFolder() + "/tests/data/thesis/steps.json"));
        QCOMPARE(on.tour.step(), 3);
        on.tour.end();
        for (QAction* action : on.window.findChildren<QAction*>()) {
            if (action->text() == "&Tour") action->trigger();
        }
        QCOMPARE(on.tour.step(), 1);
    }

    // The second step is about turning the cloud: no comparison opens over it.
    void theFirstStepOpensOneScan() {
        FirstStart on(ini_);
        QVERIFY(on.begin());
        on.click("tour-try");
        QVERIFY(eventually([&] { return on.tour.step() == 1 && on.viewer.engine.picture() != nullptr; }));
        QVERIFY(on.settled());
        QVERIFY(eventually([&] { return on.viewer.comparing.settled(); }));
        QVERIFY(on.viewer.comparing.pictureA() == nullptr);
    }

    // The strip is as wide as the views: next to it the head of a dock, whose content the page covers, would be left.
    void nothingOfADockIsLeftBesideIt() {
        FirstStart on(ini_);
        on.window.resize(1280, 800);
        QVERIFY(on.begin());
        QVERIFY(on.tour.isVisible());
        for (int n = 0; n < 5; ++n) QApplication::processEvents();
        for (const auto* dock : on.window.findChildren<QDockWidget*>()) {
            if (!dock->isVisible()) continue;
            const QPoint head = dock->mapTo(&on.window, QPoint(dock->width() / 2, 8));
            const QWidget* there = on.window.childAt(head);
            QVERIFY2(there != nullptr && there != dock && !dock->isAncestorOf(there), qPrintable(dock->objectName()));
        }
    }

    void itCoversNothing_data() {
        QTest::addColumn<QString>("language");
        for (const Language& language : kLanguages) QTest::newRow(language.code) << QString(language.code);
    }
    void itCoversNothing() {
        QFETCH(QString, language);
        QVERIFY(useLanguage(language, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
        FirstStart on(ini_);
        QVERIFY(on.begin());
        // The first is a screen of 1280 x 800 at a scale of 1.5.
        for (const QSize size : {QSize(853, 500), QSize(1024, 768), QSize(1280, 800)}) {
            on.window.resize(size);
            QVERIFY2(eventually([&] { return on.window.size() == size; }), qPrintable(QString::number(on.window.width())));
            for (int step = 0; step < Tour::kSteps; ++step) {
                on.tour.showStep(step);
                for (int n = 0; n < 5; ++n) QApplication::processEvents(); // layouts that still wait
                const QStringList faults = faultsIn(*on.page) + faultsIn(on.window).filter("tour");
                QVERIFY2(faults.isEmpty(), qPrintable(QString("step %1: ").arg(step) + faults.join('\n')));
                const int strip = on.tour.mapTo(&on.window, QPoint(0, on.tour.height())).y();
                // The page is below the strip too, with a hole for it, so that nothing is left next to it.
                const int first = on.page->mapTo(&on.window, on.page->contentsRect().topLeft()).y();
                QVERIFY2(first >= strip, qPrintable(QString("the page begins at %1, the strip ends at %2").arg(first).arg(strip)));
                const QWidget* there = on.window.childAt(on.tour.mapTo(&on.window, on.tour.rect().center()));
                QVERIFY2(there == &on.tour || on.tour.isAncestorOf(there), there ? qPrintable(there->objectName()) : "");
            }
        }
    }

    // A page that does not fit scrolls: the last button can be brought into view, and nothing is squeezed (see itCoversNothing()).
    void aLowPageScrolls() {
        FirstStart on;
        on.window.resize(853, 500);
        QVERIFY(on.begin());
        on.page->showSession(QString::fromStdString((folder_ / "none.json").string())); // with a description that may need two lines
        auto* area = on.page->findChild<QScrollArea*>();
        auto* last = on.page->findChild<QAbstractButton*>("start-keys");
        QVERIFY(area != nullptr && last != nullptr);
        QTRY_VERIFY(area->verticalScrollBar()->maximum() > 0);
        area->ensureWidgetVisible(last);
        const QRect place(last->mapTo(area->viewport(), QPoint()), last->size());
        QVERIFY(area->viewport()->rect().contains(place));
        for (const auto* sign : on.page->findChildren<QLabel*>()) {
            const QPixmap picture = sign->pixmap(Qt::ReturnByValue);
            if (!picture.isNull()) QVERIFY(sign->height() >= picture.height() / picture.devicePixelRatio());
        }
    }

    void theDemoBeforeAndAfterTakesOneClick() {
        qputenv("XDG_CACHE_HOME", QByteArray::fromStdString((folder_ / "cache").string()));
        FirstStart on;
        QVERIFY(on.begin());
        on.click("start-demo-pair");
        QVERIFY(eventually([&] { return on.viewer.comparing.comparison() != nullptr && on.viewer.comparing.settled(); }));
        QCOMPARE(on.viewer.files.demo(), std::optional<bool>(true));
        QCOMPARE(on.viewer.comparing.pictureA()->detection->scan->name, std::string("demo draw-bell"));
        QVERIFY(on.viewer.comparing.comparison()->isOfTwoScans());
        QVERIFY(!on.page->isVisible());
        on.viewer.undo.undo();
        QVERIFY(on.viewer.comparing.pictureA() == nullptr);
    }
};

int tour_test(int argc, char** argv) { return runWindowTest<TourTest>(argc, argv); }

#include "tour_test.moc"
