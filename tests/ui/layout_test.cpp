// Where things stand in the real window: the cloud has the room at every size, no panel is cut off, nothing covers what must be read.
#include "core/settings/method_traits.h"
#include "core/settings/presets.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/dock_rail.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/base/window_room.h"
#include "ui/language/languages.h"
#include "ui/live/live_panel.h"
#include "ui/main/theme.h"
#include "ui/main/tool_bar.h"
#include "ui/panel/edge_legend.h"
#include "ui/panel/status_line.h"
#include "ui/rocks/rocks_panel.h"
#include "ui/targets/targets_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>

#include <random>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

// As the window system sends it: Qt may give the focus before the widget gets the wheel.
void wheelOver(QWidget& widget, int notches) {
    const QPointF at(widget.width() / 2.0, widget.height() / 2.0);
    QWheelEvent event(at, widget.mapToGlobal(at.toPoint()), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&widget, &event);
}

double contrast(QColor a, QColor b) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const auto luminance = [&](const QColor& c) {
        return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    };
    const double x = luminance(a) + 0.05;
    const double y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

} // namespace

class LayoutTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bare_, placed_, tall_;

    static QDockWidget* dock(MainWindow& window) { return window.findChild<QDockWidget*>("dock-edges"); }
    static void resizeTo(MainWindow& window, QSize size) {
        window.resize(size);
        QTRY_COMPARE(window.size(), size);
        QApplication::processEvents();
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        Scan scan = test::boxesScan(300, 340, 3, 0.05);
        bare_ = (folder_ / "bare.json").string();
        QVERIFY(bool(saveScan(scan, bare_)));
        Placement placement = *test::randomPlacement(3, 1, true);
        placement.outOfSpec = true;
        scan.placement = std::make_shared<const Placement>(placement);
        placed_ = (folder_ / "placed.json").string();
        QVERIFY(bool(saveScan(scan, placed_)));
    }

    void theWindowFitsItsScreen() {
        WindowFixture on;
        QVERIFY(on.show());
        const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
        QVERIFY2(on.window.width() <= screen.width() && on.window.height() <= screen.height(),
                 qPrintable(QString("%1 x %2").arg(on.window.width()).arg(on.window.height())));
        QVERIFY(on.window.width() >= std::min(screen.width(), 1280));
        if (screen.width() > 1700) QVERIFY2(on.window.width() != 1600, "it follows the screen");
        QVERIFY2(on.window.minimumSizeHint().width() <= 853 && on.window.minimumSizeHint().height() <= 533,
                 qPrintable(QString("%1 x %2").arg(on.window.minimumSizeHint().width()).arg(on.window.minimumSizeHint().height())));
        // One that was remembered on a larger screen is made to fit.
        const QString ini = QString::fromStdString((folder_ / "large.ini").string());
        {
            WindowFixture large(ini);
            large.window.resize(5000, 4000);
            large.memory.keep("window/geometry", large.window.saveGeometry());
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
            const QRect fits = insideScreen(window, frame, room);
            QVERIFY(room.contains(fits.marginsAdded(frame)));
            if (room.contains(window.marginsAdded(frame))) QCOMPARE(fits, window); // nothing moves by itself
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
            const CloudView& cloud = window.views().cloud();
            const QByteArray at = QString("%1: cloud %2 images %3 panel %4")
                                      .arg(size.width())
                                      .arg(cloud.width())
                                      .arg(window.views().gray().width())
                                      .arg(dock(window)->isHidden() ? 0 : dock(window)->width())
                                      .toUtf8();
            QVERIFY2(cloud.width() >= 0.54 * size.width(), at.constData());
            // The images stand above one another, never three panes in a row.
            QCOMPARE(window.views().gray().mapTo(&window, QPoint()).x(), window.views().edges().mapTo(&window, QPoint()).x());
            QVERIFY2(window.views().gray().width() >= 140, at.constData());
            QCOMPARE(dock(window)->isHidden(), size.width() < 1100);
            if (!dock(window)->isHidden()) QVERIFY2(dock(window)->width() <= 0.225 * size.width(), at.constData());
            QCOMPARE(window.findChild<DockRail*>()->isVisible(), size.width() < 1100);
        }
    }

    void noMethodMakesThePanelWiderThanItsDock() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1280, 800});
        auto* scroll = on.window.panel().findChild<QScrollArea*>();
        const int width = dock(on.window)->width();
        for (const MethodTraits& method : methodTraits()) {
            Settings settings = cannySettings();
            settings.method = method.method;
            settings.ratio = 2.5; // unlocked: its row is there as well
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
            const int before = on.window.views().cloud().width();
            QTest::mouseClick(dock(on.window)->findChild<QToolButton*>("fold"), Qt::LeftButton);
            QTRY_VERIFY(dock(on.window)->isHidden());
            QTRY_VERIFY(on.window.views().cloud().width() > before + 150);
            resizeTo(on.window, {1500, 800});
            QVERIFY(dock(on.window)->isHidden());
            auto* rail = on.window.findChild<QToolButton*>("rail-dock-edges");
            QVERIFY(rail->isVisible());
            QTest::mouseClick(rail, Qt::LeftButton);
            QTRY_VERIFY(dock(on.window)->isVisible());
            resizeTo(on.window, {900, 700}); // opened by hand: it stays also where it is narrow
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

    void aPanelIsFoldedAlsoWhereNothingIsRemembered() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1280, 800});
        QTest::mouseClick(dock(on.window)->findChild<QToolButton*>("fold"), Qt::LeftButton);
        QTRY_VERIFY(dock(on.window)->isHidden());
        resizeTo(on.window, {1300, 800});
        QVERIFY(dock(on.window)->isHidden());
    }

    void aMaximisedPaneIsFilled() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1280, 800});
        for (ImageView* view : {&on.window.views().gray(), &on.window.views().edges()}) {
            const double before = view->viewPort()->zoom();
            auto* pane = qobject_cast<Pane*>(view->parentWidget());
            QVERIFY(pane != nullptr);
            QTest::mouseDClick(pane->findChild<QLabel*>()->parentWidget(), Qt::LeftButton);
            QTRY_VERIFY(view->width() > 900);
            QTRY_VERIFY2(view->viewPort()->zoom() > 1.8 * before, qPrintable(QString::number(view->viewPort()->zoom() / before)));
            const double fits = std::min(view->width() / 340.0, view->height() / 300.0);
            QVERIFY(std::abs(view->viewPort()->zoom() - fits) < 0.02 * fits);
            QVERIFY(on.activate());
            on.window.notice().hide();
            QTest::keyClick(&on.window, Qt::Key_Escape);
            QTRY_VERIFY(std::abs(view->viewPort()->zoom() - before) < 0.02 * before);
        }
    }

    void theStatusLineCoversNothingThatMustBeRead() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        auto* probe = on.window.findChild<QLabel*>("probe");
        const Scan& scan = *on.picture().detection->scan;
        const auto valid = std::ranges::find(scan.state.cells, CellState::Valid) - scan.state.cells.begin();
        const QPoint cell = on.window.views().placeOf(static_cast<std::size_t>(valid));
        for (const int width : {853, 1280, 1366, 1600, 1920}) {
            resizeTo(on.window, {width, 800});
            on.window.views().letGo();
            emit on.window.views().gray().clicked(cell.y(), cell.x());
            QApplication::processEvents();
            const QString text = probe->text();
            QVERIFY2(
                QRegularExpression("N [0-9.]+  E [0-9.]+  El -?[0-9.]+  x -?[0-9.]+  y -?[0-9.]+  z -?[0-9.]+ m").match(text).hasMatch(),
                qPrintable(QString::number(width) + ": " + text));
            QVERIFY2(text.contains("EDGE") || text.contains("not an edge"), qPrintable(text));
            QVERIFY2(probe->width() >= QFontMetrics(probe->font()).horizontalAdvance(text), qPrintable(text));
            // Whole, and beside it: nothing lies over anything else.
            QList<QRect> places{QRect(probe->mapTo(&on.window, QPoint()), probe->size())};
            bool spec = false;
            for (const QLabel* label : on.window.statusLine().findChildren<QLabel*>()) {
                if (label == probe || !label->isVisible()) continue;
                spec = spec || label->text().contains("OUT OF SPEC");
                const QRect place(label->mapTo(&on.window, QPoint()), label->size());
                QVERIFY2(on.window.rect().contains(place), qPrintable(label->text()));
                QVERIFY2(label->width() >= QFontMetrics(label->font()).horizontalAdvance(label->text()), qPrintable(label->text()));
                for (const QRect& before : places) QVERIFY2(!place.intersects(before), qPrintable(label->text()));
                places << place;
            }
            QVERIFY2(spec, "OUT OF SPEC never goes");
        }
        resizeTo(on.window, {1900, 800});
        QVERIFY(on.window.findChild<QLabel*>("counts")->isVisible());
    }

    // Without a pose the cell, its line and beam too, is told whole at 1280, in every language: what tells least gives way.
    void theCellIsToldWholeOnASmallScreenInEveryLanguage() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString(EDGESCAN_SOURCE_DIR) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(bare_));
            const Scan& scan = *on.picture().detection->scan;
            const auto valid = std::ranges::find(scan.state.cells, CellState::Valid) - scan.state.cells.begin();
            const QPoint cell = on.window.views().placeOf(static_cast<std::size_t>(valid));
            auto* probe = on.window.findChild<QLabel*>("probe");
            for (const int width : {1280, 1366, 1920}) {
                resizeTo(on.window, {width, 800});
                on.window.views().letGo();
                emit on.window.views().gray().clicked(cell.y(), cell.x());
                QApplication::processEvents();
                QVERIFY2(!probe->text().contains("…"), qPrintable(QString("%1 %2: %3").arg(code).arg(width).arg(probe->text())));
                QCOMPARE(probe->toolTip(), on.window.statusLine().probeShown());
                QVERIFY(probe->width() >= QFontMetrics(probe->font()).horizontalAdvance(probe->text()));
                QVERIFY2(on.window.findChild<QLabel*>("counts")->isVisible(), code);
            }
        }
        useLanguage("en");
    }

    void everyToolHasItsButtonInEveryLanguage() {
        for (const char* code : {"fr", "es", "pt", "en"}) {
            QVERIFY(useLanguage(code, QString(EDGESCAN_SOURCE_DIR) + "/resources/languages"));
            WindowFixture on;
            QVERIFY(on.showWith(bare_));
            int withWords = 0;
            for (const int width : {853, 1280, 1920, 2560}) {
                resizeTo(on.window, {width, 800});
                withWords = 0;
                for (const auto* button : on.window.tools().findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
                    if (button->objectName() == "qt_toolbar_ext_button") {
                        QVERIFY2(!button->isVisible(), qPrintable(QString("%1: there is no room at %2").arg(code).arg(width)));
                        continue;
                    }
                    QVERIFY2(button->isVisible() && button->width() >= button->sizeHint().width(), qPrintable(button->text()));
                    QVERIFY2(!button->icon().isNull() && !button->toolTip().isEmpty(), qPrintable(button->text()));
                    withWords += button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon ? 1 : 0;
                }
                QVERIFY2(withWords >= 2, "Open and Connect are read at every width");
            }
            QVERIFY2(withWords > 10, "where there is room all are read");
        }
        useLanguage("en");
        WindowFixture on;
        QVERIFY(on.showWith(bare_) && on.activate());
        const auto pressed = [&](const char* text) {
            for (auto* button : on.window.tools().findChildren<QToolButton*>()) {
                if (button->text() == text) QTest::mouseClick(button, Qt::LeftButton);
            }
        };
        pressed("Rocks");
        QVERIFY(on.window.rocks().shown());
        auto* measure = on.window.findChild<QToolButton*>("tool-measure");
        QVERIFY(!measure->isChecked());
        on.window.measures().start(MeasureKind::Distance);
        QVERIFY(measure->isChecked());
        pressed("Pin");
        QVERIFY(!measure->isChecked() && on.window.views().tool() == Tool::Pin);
    }

    // Three panels above each other, a rock and a target with their cards: what does not fit scrolls, nothing is squeezed or cut off.
    void cardsAreWholeWhateverRoomTheyHave() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(QTest::qWaitFor([&] { return on.window.rocks().picture() && !on.window.rocks().behind(); }, 60000));
        on.window.views().pin(on.window.views().cellAt(60, 80));
        QVERIFY(QTest::qWaitFor([&] { return on.window.targets().settled(); }, 20000));
        for (const QSize size : {QSize(1280, 800), QSize(1366, 768), QSize(1920, 1080)}) {
            resizeTo(on.window, size);
            for (const QWidget* panel :
                 {static_cast<QWidget*>(&on.window.rocksPanel()), static_cast<QWidget*>(&on.window.targetsPanel())}) {
                if (!panel->isVisible()) continue;
                int labels = 0;
                for (const QLabel* label : panel->findChildren<QLabel*>()) {
                    if (!label->isVisible() || label->text().isEmpty() || !label->pixmap(Qt::ReturnByValue).isNull()) continue;
                    ++labels;
                    QVERIFY2(label->height() >= label->fontMetrics().height(), qPrintable(label->text()));
                }
                QVERIFY(labels > 2);
                QVERIFY2(panel->width() <= panel->parentWidget()->width(), "cut off at the right");
            }
        }
    }

    void theWheelTurnsNothingThatHasNoFocus() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        QVERIFY(on.use(cannySettings()));
        QVERIFY(on.activate());
        MainWindow& window = on.window;
        window.live().panel().show();
        window.views().cloud().setFocus();
        int tried = 0;
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            if (!widget->isVisible() || !widget->isEnabled()) continue;
            QVariant before;
            if (auto* list = qobject_cast<QComboBox*>(widget)) before = list->currentIndex();
            if (auto* box = qobject_cast<QAbstractSpinBox*>(widget)) before = box->text();
            if (auto* slider = qobject_cast<QSlider*>(widget)) before = slider->value();
            if (!before.isValid()) continue;
            ++tried;
            wheelOver(*widget, 1);
            wheelOver(*widget, -2);
            QVariant after;
            if (auto* list = qobject_cast<QComboBox*>(widget)) after = list->currentIndex();
            if (auto* box = qobject_cast<QAbstractSpinBox*>(widget)) after = box->text();
            if (auto* slider = qobject_cast<QSlider*>(widget)) after = slider->value();
            QVERIFY2(before == after, qPrintable(widget->objectName()));
            QVERIFY2(!widget->hasFocus(), qPrintable(widget->objectName()));
        }
        QVERIFY2(tried > 8, qPrintable(QString::number(tried)));
        QVERIFY(window.session().settings() == cannySettings());
        // With the focus it does.
        QDoubleSpinBox* number = window.panel().row("lower")->number();
        number->setFocus();
        QTRY_VERIFY(number->hasFocus());
        wheelOver(*number, 1);
        QVERIFY(window.session().settings().lower > cannySettings().lower);
    }

    void theLegendTellsAndSwitches() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        EdgeLegend& legend = on.window.legend();
        QVERIFY(legend.isVisible());
        const auto press = [&](QCheckBox* box) { QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {8, box->height() / 2}); };
        press(legend.classSwitch(1));
        QVERIFY(on.settled());
        QCOMPARE(on.window.session().settings().classes, static_cast<int>(kClassJump | kClassConcave | kClassSilhouette));
        QVERIFY(!legend.classSwitch(1)->isChecked());
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(on.settled());
        QVERIFY(legend.classSwitch(1)->isChecked());
        press(legend.byClass());
        QVERIFY(on.window.views().cloud().edgesByClass());
        QTest::keyClick(&on.window, Qt::Key_C);
        QVERIFY(!legend.byClass()->isChecked() && !on.window.views().cloud().edgesByClass());
        press(legend.edges());
        QVERIFY(!on.window.views().cloud().edgesVisible());
        QTest::keyClick(&on.window, Qt::Key_E);
        QVERIFY(legend.edges()->isChecked() && on.window.views().cloud().edgesVisible());
        QVERIFY(on.use(cannySettings())); // tells no classes apart
        QVERIFY(legend.edges()->isVisible() && !legend.classSwitch(0)->isVisible());
    }

    void everyEdgeColourIsSeenOnTheCloud() {
        for (const EdgeColours& colours : {kUsualColours, kColourBlindColours}) {
            for (const QColor& colour : colours) QVERIFY2(contrast(colour, QColor(121, 121, 121)) >= 3.0, qPrintable(colour.name()));
        }
    }

    // Greyed words are thinner than usable ones, not bolder: no shadow is drawn beside them.
    void whatCannotBeUsedLooksLess() {
        QMenu menu;
        menu.addAction("Reload the file")->setEnabled(true);
        menu.addAction("Reload the file")->setEnabled(false);
        menu.popup({50, 50});
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        const auto ink = [&](int n) {
            const QImage seen = menu.grab(menu.actionGeometry(menu.actions().at(n))).toImage();
            const QRgb ground = seen.pixel(2, seen.height() / 2);
            qint64 sum = 0;
            int pixels = 0;
            for (int y = 2; y < seen.height() - 2; ++y) {
                for (int x = 2; x < seen.width() - 2; ++x) {
                    const int off = std::abs(qGray(seen.pixel(x, y)) - qGray(ground));
                    sum += off;
                    pixels += off > 12 ? 1 : 0;
                }
            }
            return std::pair{sum, pixels};
        };
        menu.setActiveAction(nullptr);
        const auto usable = ink(0), greyed = ink(1);
        menu.close();
        QVERIFY2(4 * greyed.first < 3 * usable.first && 20 * greyed.second <= 21 * usable.second,
                 qPrintable(QString("%1 %2 against %3 %4").arg(greyed.first).arg(greyed.second).arg(usable.first).arg(usable.second)));
    }
};

int main(int argc, char** argv) { return runWindowTest<LayoutTest>(argc, argv); }

#include "layout_test.moc"
