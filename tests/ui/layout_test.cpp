// The layout of the real window: the cloud has enough space at every size, no panel is cut off, and important texts are not covered.
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/presets.h"
#include "tests/support/placements.h"
#include "tests/ui/sized_window.h"
#include "ui/base/dock_rail.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/base/window_room.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/window/cab_mode.h"
#include "ui/window/docks.h"
#include "ui/window/pane_places.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"
#include "ui/window/tool_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include <random>

using namespace edgescan;
using namespace edgescan::ui;

class LayoutTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bare_;

    static QDockWidget* dock(MainWindow& window) { return window.findChild<QDockWidget*>("dock-edges"); }

    /// Of the left button; QTest::mouseMove() sends none while it is down.
    static void sendMouse(QWidget& to, QEvent::Type type, const QPoint& at, Qt::MouseButtons buttons) {
        QMouseEvent event(type, at, to.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, {});
        QApplication::sendEvent(&to, &event);
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        bare_ = (folder_ / "bare.json").string();
        QVERIFY(bool(files::saveScan(boxesToShow(), bare_)));
    }

    // Its size from before may be that of a larger screen, or of another scale.
    void aWindowThatIsNoLongerMaximisedFitsItsScreen() {
        WindowFixture on;
        QVERIFY(on.show());
        const QRect room = on.window.screen()->availableGeometry();
        on.window.resize(room.size() + QSize(0, 200));
        QTRY_VERIFY(on.window.height() > room.height());
        QWindowStateChangeEvent restored(Qt::WindowMaximized);
        QApplication::sendEvent(&on.window, &restored);
        QTRY_VERIFY2(on.window.frameGeometry().height() <= room.height(), qPrintable(QString::number(on.window.height())));
    }

    void theWindowFitsItsScreen() {
        WindowFixture on;
        QVERIFY(on.show());
        const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
        QVERIFY2(on.window.width() <= screen.width() && on.window.height() <= screen.height(),
                 qPrintable(QString("%1 x %2").arg(on.window.width()).arg(on.window.height())));
        QVERIFY(on.window.width() >= std::min(screen.width(), 1280));
        if (screen.width() > 1700) QVERIFY2(on.window.width() != 1600, "it follows the screen");
        if (screen.width() <= 1600) QCOMPARE(on.window.frameGeometry().size(), screen.size()); // xvfb-run -s "-screen 0 1280x800x24"
        QVERIFY2(on.window.minimumSizeHint().width() <= 853 && on.window.minimumSizeHint().height() <= 533,
                 qPrintable(QString("%1 x %2").arg(on.window.minimumSizeHint().width()).arg(on.window.minimumSizeHint().height())));
        // A window size stored on a larger screen is reduced.
        const QString ini = QString::fromStdString((folder_ / "large.ini").string());
        {
            WindowFixture large(ini);
            large.window.resize(5000, 4000);
            large.preferences.keep("window/geometry", large.window.saveGeometry());
        }
        WindowFixture again(ini);
        QVERIFY(again.show());
        QVERIFY(again.window.width() <= screen.width() && again.window.height() <= screen.height());
    }

    void aWindowAndItsFrameStandOnTheScreen() {
        std::mt19937 random(5);
        const auto number = [&random](int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); };
        for (int n = 0; n < 2000; ++n) {
            const QRect room(number(-2000, 2000), number(0, 60), number(900, 3000), number(600, 2000));
            const QMargins frame(number(0, 8), number(0, 40), number(0, 8), number(0, 8));
            const QRect window(number(-3000, 3000), number(-500, 2500), number(300, 3500), number(300, 2500));
            const QRect fits = fittedInScreen(window, frame, room);
            QVERIFY(room.contains(fits.marginsAdded(frame)));
            if (room.contains(window.marginsAdded(frame))) QCOMPARE(fits, window); // a window that fits does not move
            const QRect most = room.marginsRemoved(frame);
            QCOMPARE(fits.size(), window.size().boundedTo(most.size()));
        }
    }

    void theCloudHasTheRoomAtEverySize() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        MainWindow& window = on.window;
        for (const QSize size :
             {QSize(853, 533), QSize(1024, 700), QSize(1280, 800), QSize(1366, 768), QSize(1600, 900), QSize(1920, 1040)}) {
            resizeTo(window, size);
            const CloudView& cloud = window.viewer().views.cloud();
            const QByteArray at = QString("%1: cloud %2 images %3 panel %4")
                                      .arg(size.width())
                                      .arg(cloud.width())
                                      .arg(window.viewer().views.gray().width())
                                      .arg(dock(window)->isHidden() ? 0 : dock(window)->width())
                                      .toUtf8();
            QVERIFY2(cloud.width() >= (size.width() < 1100 ? 0.38 : 0.22) * size.width() - 2, at.constData());
            // The images are one above the other; three panes in a row never occur.
            QCOMPARE(window.viewer().views.gray().mapTo(&window, QPoint()).x(), window.viewer().views.edges().mapTo(&window, QPoint()).x());
            QVERIFY2(window.viewer().views.gray().width() >= 140, at.constData());
            QCOMPARE(dock(window)->isHidden(), size.width() < 1100);
            if (!dock(window)->isHidden()) QVERIFY2(dock(window)->width() <= 0.225 * size.width(), at.constData());
            QCOMPARE(window.findChild<DockRail*>()->isVisible(), size.width() < 1100);
        }
    }

    // Rocks, a target, panels and the table that the operator opened: the cloud keeps its share, and nothing is left blank.
    void theCloudKeepsItsShareInEveryState() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bare_) && on.activate());
        MainWindow& window = on.window;
        const auto open = [&](const char* name) { window.findChild<QDockWidget*>(name)->toggleViewAction()->trigger(); };
        const std::vector<std::pair<const char*, std::function<void()>>> states{
            {"plain", [] {}},
            {"rocks", [&] { on.viewer.rocks.setShown(true); }},
            {"target", [&] { on.viewer.views.pin(on.picture().detection->edges->front()); }},
            {"table", [&] { open("dock-rock-table"); }},
            {"edges", [&] { open("dock-edges"); }}, // by hand: folded
            {"edges again", [&] { open("dock-edges"); }},
        };
        QStringList faults;
        for (const auto& [name, enter] : states) {
            enter();
            for (const QSize size : {QSize(640, 480), QSize(853, 480), QSize(900, 600), QSize(1024, 700), QSize(1280, 800),
                                     QSize(1366, 768), QSize(1920, 1040), QSize(1280, 800)}) {
                QVERIFY(eventually([&] { // what folds on the way makes room for a smaller window
                    window.resize(size);
                    QApplication::processEvents();
                    return window.size() == size.expandedTo(window.minimumSizeHint());
                }));
                for (int n = 0; n < 5; ++n) QApplication::processEvents(); // layouts that still wait
                const CloudView& cloud = on.viewer.views.cloud();
                const QString where = QString("%1 at %2 x %3: ").arg(name).arg(window.width()).arg(window.height());
                if (cloud.width() < (window.width() < 1100 ? 0.38 : 0.22) * window.width() - 2) {
                    QString docks;
                    for (const auto* each : window.findChildren<QDockWidget*>())
                        if (each->isVisible())
                            docks += QString(", %1 %2 (at least %3)")
                                         .arg(each->objectName())
                                         .arg(each->width())
                                         .arg(each->minimumSizeHint().width());
                    faults << where +
                                  QString("cloud %1, images %2")
                                      .arg(cloud.width())
                                      .arg(on.viewer.views.gray().isVisible() ? on.viewer.views.gray().width() : 0) +
                                  docks;
                }
                for (const auto* each : window.findChildren<QDockWidget*>()) {
                    if (!each->isVisible() || each->visibleRegion().isEmpty()) continue; // behind another tab
                    if (!each->widget()->isVisible() || each->widget()->height() < 40 || each->widget()->width() < 100)
                        faults << where + each->objectName() + " is blank";
                    if (!window.rect().contains(QRect(each->mapTo(&window, QPoint()), each->size())))
                        faults << where + each->objectName() + " is off the window";
                }
                if (size == QSize(1280, 800) && !on.viewer.views.gray().isVisible()) faults << where + "the images are folded";
                if (size == QSize(1280, 800) && window.findChild<QDockWidget*>("dock-edges")->isHidden() != (name == std::string("edges")))
                    faults << where + "edges";
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

    void resetLayoutRestoresTheOrder() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1920, 1040});
        on.viewer.rocks.setShown(true);
        on.viewer.views.pin(on.picture().detection->edges->front());
        const auto top = [&](const char* name) {
            const auto* each = on.window.findChild<QDockWidget*>(name);
            return each->isVisible() ? each->mapTo(&on.window, QPoint()).y() : -1;
        };
        const auto inOrder = [&] {
            return top("dock-edges") >= 0 && top("dock-edges") < top("dock-rocks") && top("dock-rocks") < top("dock-targets");
        };
        QTRY_VERIFY(inOrder());
        on.window.addDockWidget(Qt::RightDockWidgetArea, on.window.findChild<QDockWidget*>("dock-edges")); // dragged below the others
        QTRY_VERIFY(!inOrder());
        on.window.resetLayout();
        QTRY_VERIFY2(inOrder(), qPrintable(QString("%1 %2 %3").arg(top("dock-edges")).arg(top("dock-rocks")).arg(top("dock-targets"))));
    }

    void noMethodMakesThePanelWiderThanItsDock() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1280, 800});
        auto* scroll = on.viewer.panel.findChild<QScrollArea*>();
        const int width = dock(on.window)->width();
        for (const edges::MethodTraits& method : edges::methodTraits()) {
            edges::Settings settings = edges::cannySettings();
            settings.method = method.method;
            settings.ratio = 2.5; // unlocked: its row is visible too
            QVERIFY(on.use(settings));
            QApplication::processEvents();
            QString wide = QString("%1: %2 of %3").arg(method.key).arg(scroll->widget()->width()).arg(scroll->viewport()->width());
            for (const QWidget* each : scroll->widget()->findChildren<QWidget*>()) {
                if (each->isVisible() && each->mapTo(scroll->widget(), QPoint(each->width(), 0)).x() > scroll->viewport()->width())
                    wide += QString("; %1 %2 least %3")
                                .arg(each->metaObject()->className(), each->objectName())
                                .arg(each->minimumSizeHint().width());
            }
            QVERIFY2(scroll->widget()->width() <= scroll->viewport()->width(), qPrintable(wide));
            QCOMPARE(dock(on.window)->width(), width);
        }
    }

    void aPanelIsFoldedAndStaysAsItWasLeft() {
        const QString ini = QString::fromStdString((folder_ / "fold.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(on.showWith(bare_));
            resizeTo(on.window, {1280, 800});
            const int before = on.viewer.views.cloud().width();
            QTest::mouseClick(dock(on.window)->findChild<QToolButton*>("fold"), Qt::LeftButton);
            QTRY_VERIFY(dock(on.window)->isHidden());
            QTRY_VERIFY(on.viewer.views.cloud().width() > before + 150);
            resizeTo(on.window, {1500, 800});
            QVERIFY(dock(on.window)->isHidden());
            auto* rail = on.window.findChild<QToolButton*>("rail-dock-edges");
            QVERIFY(rail->isVisible());
            QTest::mouseClick(rail, Qt::LeftButton);
            QTRY_VERIFY(dock(on.window)->isVisible());
            resizeTo(on.window, {900, 700}); // opened by the operator: it stays open in a narrow window too
            QVERIFY(dock(on.window)->isVisible());
            QTest::mouseClick(dock(on.window)->findChild<QToolButton*>("fold"), Qt::LeftButton);
            QTRY_VERIFY(dock(on.window)->isHidden());
            on.window.close();
        }
        WindowFixture again(ini);
        QVERIFY(again.show());
        resizeTo(again.window, {1400, 800});
        QVERIFY(dock(again.window)->isHidden());
        again.window.resetLayout();
        QVERIFY(!dock(again.window)->isHidden());
    }

    // The start page covers the places of the docks: they take no room until the first scan, and the strips above it are as wide as it.
    void theStartPageHasTheWholeWidth() {
        WindowFixture on;
        QVERIFY(on.show());
        StartPage* page = showStart(on.window, on.preferences);
        for (const QSize size : {QSize(853, 533), QSize(1280, 800), QSize(1920, 1040)}) {
            resizeTo(on.window, size);
            on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "EdgeScan ended without being closed.");
            QTRY_COMPARE(on.window.centralWidget()->width(), size.width());
            QTRY_COMPARE(page->width(), size.width());
            QVERIFY(dock(on.window)->isHidden() && on.window.findChild<DockRail*>()->isHidden());
        }
        QVERIFY(on.open(bare_));
        QTRY_VERIFY(!page->isVisible() && dock(on.window)->isVisible());
    }

    // After a crash a note comes above the buttons: where the page has room for it, no button moves.
    void aNoteMovesNoButtonOfTheStartPage() {
        WindowFixture on;
        QVERIFY(on.show());
        StartPage* page = showStart(on.window, on.preferences);
        for (const auto& [cab, size] : {std::pair(false, QSize(1280, 800)), {true, QSize(1280, 800)}, {true, QSize(853, 480)}}) {
            on.window.cab().set(cab);
            resizeTo(on.window, size);
            on.viewer.notice.hide();
            const auto* open = page->findChild<QWidget*>("start-open");
            const auto top = [&] { return open->mapTo(&on.window, QPoint()).y(); };
            QTRY_VERIFY(page->isVisible() && page->width() == size.width() && top() >= page->y() + (size.height() < 600 ? 50 : 61));
            for (int n = 0; n < 5; ++n) QApplication::processEvents();
            const int before = top();
            on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "EdgeScan ended without being closed.");
            if (size.width() > 853) on.viewer.notice.offer("Go on where I was", [] {});
            QTRY_VERIFY(on.viewer.notice.isVisible() && on.viewer.notice.height() >= 20);
            for (int n = 0; n < 5; ++n) QApplication::processEvents();
            QCOMPARE(top(), before);
        }
        on.window.cab().set(false);
    }

    // The usual share gives the images 38 % of the window; large, a square image has 600 px, and a wide one its own aspect.
    void imagesHaveTheirShare() {
        const std::string wide = (folder_ / "wide.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(100, 400, 3, 0.05), wide)));
        for (const bool isWide : {false, true}) {
            WindowFixture on;
            QVERIFY(on.showWith(isWide ? wide : bare_));
            const ImageView &gray = on.viewer.gray, &edges = on.viewer.edges;
            for (const QSize size : {QSize(1280, 800), QSize(1366, 768), QSize(1920, 1040), QSize(2560, 1400)}) {
                on.window.places().setShare(Share::Balanced);
                resizeTo(on.window, size);
                const QString at = QString("%1 wide, %2").arg(size.width()).arg(isWide);
                QTRY_VERIFY2(gray.width() >= 0.38 * size.width() - 4 && edges.width() == gray.width(), qPrintable(at));
                QVERIFY2(on.viewer.cloud.width() >= 0.22 * size.width() - 2, qPrintable(at));
                on.window.places().setShare(Share::Images);
                QTRY_VERIFY2(edges.width() >= 600 && edges.height() >= (size.height() >= 800 ? 600 : 560), qPrintable(at));
                const ViewPort& port = *edges.viewPort();
                const double high = port.cellSize(edges.size()).height() * port.imageSize().height();
                const double across = port.cellSize(edges.size()).width() * port.imageSize().width();
                QTRY_VERIFY2(high > 0.95 * edges.height() || across > 0.95 * edges.width(), qPrintable(at));
            }
        }
    }

    // A panel that takes the place of the images says so once; Reset Layout gives the panels their heights and the pixels their shape.
    // The images hid or shrank at the next picture, under the pointer: a click met another rock.
    void whatTheDragOfAPanelMovesItMovesAtOnce() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        MainWindow& window = on.window;
        resizeTo(window, {1280, 800});
        QDockWidget& panel = *dock(window);
        QTRY_VERIFY(panel.isVisible() && on.viewer.gray.isVisible());
        const int usual = panel.width(), images = on.viewer.gray.width();
        const QPoint edge = panel.geometry().topLeft() + QPoint(-2, 300);
        const auto mouse = [&](QEvent::Type type, int moved, Qt::MouseButtons buttons) {
            sendMouse(window, type, edge - QPoint(moved, 0), buttons);
        };
        const auto places = [&] {
            QList<QRect> all{panel.geometry()};
            for (const QWidget* view : {static_cast<QWidget*>(&on.viewer.gray), static_cast<QWidget*>(&on.viewer.cloud)})
                all << QRect(view->mapTo(&window, QPoint()), view->isVisible() ? view->size() : QSize());
            return all;
        };
        for (const int moved : {60, 220}) {
            mouse(QEvent::MouseButtonPress, 0, Qt::LeftButton);
            mouse(QEvent::MouseMove, moved, Qt::LeftButton);
            QTRY_COMPARE(panel.width(), usual + moved); // the panel is under the pointer
            QTRY_VERIFY(on.viewer.gray.isVisible() && (moved < 100 || on.viewer.gray.width() < images));
            for (int n = 0; n < 5; ++n) QApplication::processEvents();
            mouse(QEvent::MouseButtonRelease, moved, Qt::NoButton);
            const QList<QRect> before = places();
            edges::Settings other;
            other.classes = moved < 100 ? edges::kClassConvex : edges::kClassJump;
            QVERIFY(on.use(other)); // a new picture
            QTest::qWait(300);
            QCOMPARE(places(), before);
            mouse(QEvent::MouseButtonPress, moved, Qt::LeftButton);
            mouse(QEvent::MouseMove, 0, Qt::LeftButton);
            QTRY_VERIFY(panel.width() == usual && on.viewer.gray.isVisible());
            QTRY_COMPARE(on.viewer.gray.width(), images);
            mouse(QEvent::MouseButtonRelease, 0, Qt::NoButton);
        }
    }

    void imagesThatWereDraggedKeepTheirWidth() {
        const QString ini = QString::fromStdString((folder_ / "dragged.ini").string());
        int dragged = 0;
        for (const bool again : {false, true}) {
            WindowFixture on(ini);
            QVERIFY(on.showWith(bare_));
            resizeTo(on.window, {1280, 800});
            QTRY_VERIFY(on.viewer.gray.isVisible());
            const QWidget& gray = on.viewer.gray;
            if (again) {
                QTRY_COMPARE(gray.width(), dragged);
                continue;
            }
            QSplitterHandle* handle = nullptr;
            for (auto* each : on.window.findChildren<QSplitterHandle*>())
                if (each->orientation() == Qt::Horizontal && each->isVisible()) handle = each;
            QVERIFY(handle != nullptr);
            const int before = gray.width();
            const QPoint from = handle->mapToGlobal(handle->rect().center()), to = from - QPoint(50, 0);
            const auto mouse = [&](QEvent::Type type, const QPoint& global, Qt::MouseButtons buttons) {
                sendMouse(*handle, type, handle->mapFromGlobal(global), buttons);
            };
            mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
            mouse(QEvent::MouseMove, to, Qt::LeftButton);
            mouse(QEvent::MouseButtonRelease, to, Qt::NoButton);
            QTRY_COMPARE(gray.width(), before - 50);
            dragged = gray.width();
            QVERIFY(on.use(edges::Settings{}));
            QTest::qWait(500); // the layout is stored
            QCOMPARE(gray.width(), dragged);
        }
    }

    void aPanelThatFoldsTheImagesSaysSo() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {853, 600});
        QTRY_VERIFY(on.viewer.gray.isVisible());
        QVERIFY(!on.viewer.notice.isVisible());
        dock(on.window)->toggleViewAction()->trigger();
        QTRY_VERIFY(!on.viewer.gray.isVisible());
        QTRY_VERIFY2(on.viewer.notice.isVisible() && on.viewer.notice.text().contains("images"), qPrintable(on.viewer.notice.text()));
        on.viewer.notice.hide();
        dock(on.window)->toggleViewAction()->trigger();
        QTRY_VERIFY(on.viewer.gray.isVisible());
        dock(on.window)->toggleViewAction()->trigger();
        QTRY_VERIFY(!on.viewer.gray.isVisible());
        QVERIFY2(!on.viewer.notice.isVisible(), "once is enough");

        resizeTo(on.window, {1280, 800});
        on.viewer.views.pin(on.picture().detection->edges->front());
        auto* targets = on.window.findChild<QDockWidget*>("dock-targets");
        QTRY_VERIFY(targets->isVisible());
        on.window.resizeDocks({dock(on.window), targets}, {600, 110}, Qt::Vertical);
        QTRY_VERIFY(targets->height() < 300);
        for (QAction* action : on.window.actions()) {
            if (action->text().remove('&') == "True Angle Aspect") action->setChecked(true);
        }
        on.window.resetLayout();
        QTRY_VERIFY2(targets->height() > 0.4 * on.window.height(), qPrintable(QString::number(targets->height())));
        for (QAction* action : on.window.actions()) {
            if (action->text().remove('&') == "True Angle Aspect") QVERIFY(!action->isChecked());
        }
        resizeTo(on.window, {1920, 1040}); // now rocks and targets have a place each
        on.viewer.rocks.setShown(true);
        const auto* rocks = on.window.findChild<QDockWidget*>("dock-rocks");
        QTRY_VERIFY(rocks->isVisible() && targets->isVisible());
        QTRY_VERIFY2(targets->height() > 0.2 * on.window.height() && rocks->height() > 0.2 * on.window.height(),
                     qPrintable(QString("%1 %2").arg(targets->height()).arg(rocks->height())));
    }

    // The menus name docks that another tab hides: such a dock comes to the front, and only the one in front is folded.
    void aDockBehindATabComesToTheFront() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        const auto dockOf = [&](const char* name) { return on.window.findChild<QDockWidget*>(name); };
        const auto inFront = [](const QDockWidget* dock) { return dock->isVisible() && !dock->visibleRegion().isEmpty(); };
        for (const QSize size : {QSize(1024, 768), QSize(1366, 768)}) {
            resizeTo(on.window, size);
            on.viewer.rocks.setShown(true);
            for (const char* name : {"dock-rocks", "dock-rock-table", "dock-targets", "dock-layers", "dock-rock-table", "dock-rocks"}) {
                QDockWidget* dock = dockOf(name);
                if (!inFront(dock)) dock->toggleViewAction()->trigger();
                QTRY_VERIFY2(inFront(dock), name);
                QVERIFY2(dock->toggleViewAction()->isChecked(), name);
            }
            dockOf("dock-rocks")->toggleViewAction()->trigger();
            QTRY_VERIFY(dockOf("dock-rocks")->isHidden());
            QVERIFY(!dockOf("dock-rock-table")->isHidden());
            on.window.resetLayout();
            on.viewer.rocks.setShown(false);
        }
    }

    // The settings of edges do not scroll while the panel of rocks has an empty part.
    void noPanelScrollsNextToAnEmptyOne() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1900, 1040});
        const auto* edges = on.viewer.panel.findChild<QScrollArea*>();
        QTRY_COMPARE(edges->verticalScrollBar()->maximum(), 0);
        on.viewer.rocks.setShown(true);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() != nullptr; }));
        const auto* rocks = on.window.findChild<QDockWidget*>("dock-rocks");
        QTRY_VERIFY(rocks->isVisible());
        const auto* ofRocks = qobject_cast<const QScrollArea*>(rocks->widget());
        const auto scroll = [&] { return edges->verticalScrollBar()->maximum() + ofRocks->verticalScrollBar()->maximum(); };
        QTRY_VERIFY2_WITH_TIMEOUT(scroll() == 0,
                                  qPrintable(QString("%1 %2: %3 %4")
                                                 .arg(edges->verticalScrollBar()->maximum())
                                                 .arg(ofRocks->verticalScrollBar()->maximum())
                                                 .arg(edges->height())
                                                 .arg(ofRocks->height())),
                                  8000);
    }

    // The part of the targets came back to its usual height when the mouse was released.
    void theHeightOfThePanelsFollowsTheOperator() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_) && on.activate());
        auto* edges = on.window.findChild<QDockWidget*>("dock-edges");
        auto* targets = on.window.findChild<QDockWidget*>("dock-targets");
        for (const QSize size : {QSize(1280, 800), QSize(1900, 1040)}) {
            resizeTo(on.window, size);
            on.viewer.views.pin(std::nullopt);
            on.viewer.views.pin(on.picture().detection->edges->front());
            QTRY_VERIFY(targets->isVisible() && targets->height() > 0.4 * size.height()); // it has its usual part
            for (const int by : {-100, 60}) {
                const QPoint edge((edges->geometry().left() + edges->geometry().right()) / 2,
                                  (edges->geometry().bottom() + targets->geometry().top()) / 2);
                const int before = targets->geometry().top();
                const auto mouse = [&](QEvent::Type type, int moved, Qt::MouseButtons buttons) {
                    sendMouse(on.window, type, edge + QPoint(0, moved), buttons);
                };
                mouse(QEvent::MouseButtonPress, 0, Qt::LeftButton);
                mouse(QEvent::MouseMove, by, Qt::LeftButton);
                QTRY_VERIFY(std::abs(targets->geometry().top() - before - by) <= 3);
                mouse(QEvent::MouseButtonRelease, by, Qt::NoButton);
                for (int n = 0; n < 5; ++n) QApplication::processEvents();
                QVERIFY2(std::abs(targets->geometry().top() - before - by) <= 3, qPrintable(QString::number(targets->geometry().top())));
            }
        }
    }

    // Below the views it shows rows in a window of any height, and a height that the operator dragged stays.
    void theRockTableShowsRowsAtEverySize() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_) && on.activate());
        auto* table = on.window.findChild<QDockWidget*>("dock-rock-table");
        on.viewer.rocks.setShown(true);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() != nullptr; }));
        for (const QSize size : {QSize(1600, 900), QSize(1900, 1000), QSize(1280, 800), QSize(1700, 1000)}) {
            resizeTo(on.window, size);
            if (size.width() < 1600) continue; // a tab at the right
            QTRY_VERIFY2(table->isVisible() && std::abs(table->height() - std::max(234, size.height() * 26 / 100)) <= 3,
                         qPrintable(QString("%1 px of %2").arg(table->height()).arg(size.height())));
            QVERIFY(on.viewer.rockTable.table()->viewport()->height() >= 3 * 24);
        }
        const QPoint edge = table->geometry().topLeft() + QPoint(300, -2);
        const auto mouse = [&](QEvent::Type type, int moved, Qt::MouseButtons buttons) {
            sendMouse(on.window, type, edge - QPoint(0, moved), buttons);
        };
        mouse(QEvent::MouseButtonPress, 0, Qt::LeftButton);
        mouse(QEvent::MouseMove, 80, Qt::LeftButton);
        QVERIFY(eventually([&] { return table->height() > 300; }));
        mouse(QEvent::MouseButtonRelease, 80, Qt::NoButton);
        const int dragged = table->height();
        resizeTo(on.window, {1900, 1000});
        for (int n = 0; n < 5; ++n) QApplication::processEvents();
        QVERIFY(std::abs(table->height() - dragged) <= 2);
        on.window.resetLayout();
        QTRY_VERIFY(std::abs(table->height() - 260) <= 3);
    }

    void aPanelIsFoldedAlsoWhereNothingIsRemembered() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1280, 800});
        QTest::mouseClick(dock(on.window)->findChild<QToolButton*>("fold"), Qt::LeftButton);
        QTRY_VERIFY(dock(on.window)->isHidden());
        resizeTo(on.window, {1300, 800});
        QVERIFY(dock(on.window)->isHidden());
    }
};

int layout_test(int argc, char** argv) { return runWindowTest<LayoutTest>(argc, argv); }

#include "layout_test.moc"
