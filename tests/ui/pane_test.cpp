// The panes of the views: titles show how much of the scan is drawn; a button or a double-click shows one view alone.
#include "tests/ui/sized_window.h"
#include "ui/base/elided_label.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/panels/confidence/confidence_legend.h"
#include "ui/window/cab_mode.h"
#include "ui/window/side_column.h"
#include "ui/window/theme.h"

#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QSplitter>
#include <QToolButton>
#include <QtTest>

#include <functional>
#include <set>

using namespace edgescan;
using namespace edgescan::ui;

class PaneTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bare_, bell_, large_;

private slots:
    void initTestCase() {
        useTheme(*qApp);
        bare_ = (folder_ / "bare.json").string();
        QVERIFY(bool(files::saveScan(boxesToShow(), bare_)));
        sim::SimulationSettings settings;
        settings.lines = 120;
        settings.beams = 160;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, bell_)));
        settings.lines = 500;
        settings.beams = 571;
        large_ = (folder_ / "large.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, large_)));
    }

    void aLineWithoutRoomEndsInDots() {
        ElidedLabel line;
        line.setText("LMS511 of the robot, SN 18110550, firmware 1.80");
        line.resize(line.fontMetrics().horizontalAdvance(line.text()) + 4, 20);
        QCOMPARE(line.shown(), line.text());
        line.resize(120, 20);
        QVERIFY2(line.shown().endsWith("…") && line.shown().startsWith("LMS511"), qPrintable(line.shown()));
        QVERIFY(line.fontMetrics().horizontalAdvance(line.shown()) <= 120);
    }

    void aMaximisedPaneIsFilled() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        resizeTo(on.window, {1280, 800});
        for (ImageView* view : {&on.viewer.views.gray(), &on.viewer.views.edges()}) {
            const double before = view->viewPort()->zoom();
            auto* pane = qobject_cast<Pane*>(view->parentWidget());
            QVERIFY(pane != nullptr);
            QTest::mouseClick(pane->aloneButton(), Qt::LeftButton);
            QTRY_VERIFY(view->width() > 700); // next to the column and the panel
            QTRY_VERIFY2(view->viewPort()->zoom() > 1.8 * before, qPrintable(QString::number(view->viewPort()->zoom() / before)));
            const double fits = std::min(view->width() / 340.0, view->height() / 300.0);
            QVERIFY(std::abs(view->viewPort()->zoom() - fits) < 0.02 * fits);
            QVERIFY(on.activate());
            on.viewer.notice.hide();
            QTest::keyClick(&on.window, Qt::Key_Escape);
            QTRY_VERIFY(std::abs(view->viewPort()->zoom() - before) < 0.02 * before);
        }
    }

    // At no size of the window do black lines run between the scan lines of a surface, not even far from the axis, where lines spread.
    void surfacesAreClosedAtEverySize() {
        sim::SimulationSettings settings; // 1000 x 1141
        const std::string full = (folder_ / "full.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, full)));
        WindowFixture on;
        QVERIFY(on.showWith(full));
        CloudView& cloud = on.viewer.views.cloud();
        cloud.setEdgesVisible(false);
        cloud.setBackground(Qt::magenta);
        for (const QSize size : {QSize(900, 620), QSize(1024, 700), QSize(1280, 800), QSize(1500, 900), QSize(1900, 1000)}) {
            resizeTo(on.window, size);
            QVERIFY(eventually([&] { return cloud.atRest(); }));
            const QImage shown = cloud.grabFrame();
            const QRgb empty = QColor(Qt::magenta).rgb();
            const auto isEmpty = [&](int x, int y) { return shown.pixel(x, y) == empty; };
            int drawn = 0, gaps = 0; // of the width of a pixel
            for (int y = 2; y + 2 < shown.height(); ++y) {
                for (int x = 2; x + 2 < shown.width(); ++x) {
                    drawn += isEmpty(x, y) ? 0 : 1;
                    const bool across = !isEmpty(x - 1, y) && !isEmpty(x + 1, y), along = !isEmpty(x, y - 1) && !isEmpty(x, y + 1);
                    gaps += isEmpty(x, y) && (across || along) ? 1 : 0;
                }
            }
            qInfo("%d x %d: point %.2f px, %d of %d", shown.width(), shown.height(), cloud.pointSize(), gaps, drawn);
            QVERIFY2(100 * gaps < drawn,
                     qPrintable(QString("%1 x %2: %3 of %4").arg(size.width()).arg(size.height()).arg(gaps).arg(drawn)));
        }
    }

    // A dock takes room of the cloud and gives it back: the points always have the size that belongs to the room that is left.
    void thePointsHaveTheSizeOfTheirPane() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(large_));
        CloudView& cloud = on.viewer.views.cloud();
        auto* dock = on.window.findChild<QDockWidget*>("dock-edges");
        QVERIFY(dock != nullptr && dock->isVisible());
        const auto atRest = [&] {
            QCoreApplication::processEvents(); // layouts that wait
            return eventually([&] { return cloud.atRest(); });
        };
        const auto fits = [&] { return spacingOnScreen(*cloud.geometryOfCloud(), cloud.camera(), cloud.height()); };
        struct Room {
            const char* name;
            std::function<void()> take, give;
        };
        const Room rooms[] = {
            {"dock", [&] { dock->hide(); }, [&] { dock->show(); }},
            {"window", [&] { on.window.resize(1280, 1040); }, [&] { on.window.resize(1280, 800); }},
        };
        QVERIFY(atRest());
        const QSize usual = cloud.size();
        const double usualSize = cloud.pointSize();
        QCOMPARE(usualSize, fits());
        const QImage before = cloud.grabFrame();
        std::set<double> sizes;
        for (const Room& room : rooms) {
            room.take();
            QTRY_VERIFY2(cloud.size() != usual, room.name);
            QVERIFY(atRest());
            QCOMPARE(cloud.pointSize(), fits());
            sizes.insert(cloud.pointSize());
            const QImage shown = cloud.grabFrame();
            QVERIFY2(shown == cloud.grabFrame(CloudView::Points::All), room.name); // no point is missing or of another size
            room.give();
            QTRY_COMPARE(cloud.size(), usual);
            QVERIFY(atRest());
            QCOMPARE(cloud.pointSize(), usualSize);
            QVERIFY2(cloud.grabFrame() == before, room.name);
        }
        QVERIFY2(sizes.size() > 1, "the test can fail: the sizes differ");
    }

    static Pane& paneOf(QWidget& view) { return *qobject_cast<Pane*>(view.parentWidget()); }
    static QString counted(std::size_t n) { return QLocale(QLocale::English, QLocale::UnitedStates).toString(qulonglong(n)); }

    void theTitlesTellHowMuchIsShown() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bell_) && on.activate());
        Pane& cloud = paneOf(on.viewer.views.cloud());
        Pane& edges = paneOf(on.viewer.views.edges());
        Pane& range = paneOf(on.viewer.views.gray());
        const Scan& scan = *on.picture().detection->scan;
        const auto valid = static_cast<std::size_t>(std::ranges::count(scan.state.cells, CellState::Valid));
        QCOMPARE(cloud.note(), counted(valid) + " points");
        QTRY_VERIFY(on.viewer.views.cloud().atRest());
        QCOMPARE(cloud.remark(), QString::fromUtf8("turntable · perspective"));
        QTest::keyClick(&on.window, Qt::Key_5);
        QCOMPARE(cloud.remark(), QString::fromUtf8("turntable · orthographic"));
        QTest::keyClick(&on.window, Qt::Key_5);
        const QString all = counted(on.picture().detection->edges->size()) + " edge cells";
        QCOMPARE(edges.note(), all);
        QTest::keyClick(&on.window, Qt::Key_C);
        QCOMPARE(edges.note(), all + QString::fromUtf8(" · by class"));
        QTest::keyClick(&on.window, Qt::Key_C);
        // The ranges of the image, also after a change of the window.
        const RangeSpan usual = on.viewer.views.rangesShown();
        QCOMPARE(range.note(), QString("gray %1 to %2 m").arg(usual.nearM, 0, 'f', 1).arg(usual.farM, 0, 'f', 1));
        on.viewer.views.setRangeWindow(RangeSpan{1.0, 2.5});
        QCOMPARE(range.note(), QString("gray 1.0 to 2.5 m"));
        // Hidden cells are not drawn: the title shows the number of remaining points.
        on.viewer.selection.hideBeyond(0.0, (usual.nearM + usual.farM) / 2);
        const std::size_t hidden = on.viewer.selection.hidden().size();
        QVERIFY(hidden > 0 && hidden < valid);
        QCOMPARE(cloud.note(), counted(valid - hidden) + " of " + counted(valid) + " points");
        QTest::keyClick(&on.window, Qt::Key_I, Qt::ControlModifier);
        QCOMPARE(cloud.note(), counted(valid) + " points");
        // The number of edges changes with the settings; uncertain edges that the confidence picture hides are counted in the title.
        QTest::keyClick(&on.window, Qt::Key_W, Qt::ShiftModifier);
        QVERIFY(eventually([&] { return on.viewer.confidence.made() != nullptr; }));
        QCOMPARE(edges.note(), all + QString::fromUtf8(" · by confidence"));
        on.viewer.confidence.setLeast(95);
        QTRY_COMPARE(on.viewer.confidence.made()->leastPercent, 95);
        QCOMPARE(edges.note(), counted(on.viewer.confidence.made()->shown()) + " of " + all + QString::fromUtf8(" · by confidence"));
        QTest::keyClick(&on.window, Qt::Key_W, Qt::ShiftModifier);
        edges::Settings fewer = on.viewer.engine.settings();
        fewer.method = edges::Method::Canny;
        QVERIFY(on.use(fewer));
        QCOMPARE(edges.note(), counted(on.picture().detection->edges->size()) + " edge cells");
    }

    void aButtonShowsAViewAlone() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(bare_));
        for (QWidget* view : {static_cast<QWidget*>(&on.viewer.views.edges()), static_cast<QWidget*>(&on.viewer.views.cloud())}) {
            Pane& pane = paneOf(*view);
            const QSize before = view->size();
            QTest::mouseClick(pane.aloneButton(), Qt::LeftButton);
            QTRY_VERIFY(view->width() > before.width() && pane.aloneButton()->isChecked());
            QVERIFY(pane.aloneButton()->toolTip().startsWith("All views"));
            QTest::mouseClick(pane.aloneButton(), Qt::LeftButton);
            QTRY_COMPARE(view->size(), before);
            QVERIFY(!pane.aloneButton()->isChecked());
        }
    }

    void theLegendsGiveTheCloudTheirRoom() {
        WindowFixture on;
        resizeTo(on.window, {1280, 800});
        QVERIFY(on.showWith(bare_));
        const QWidget& cloud = on.viewer.views.cloud();
        const int before = cloud.width(), column = on.window.side().width();
        auto* fold = paneOf(on.viewer.views.cloud()).findChild<QToolButton*>("pane-panel");
        QVERIFY(fold->geometry().right() < fold->parentWidget()->width());
        QTest::mouseClick(fold, Qt::LeftButton);
        QTRY_COMPARE(cloud.width(), before + column);
        QTest::mouseClick(fold, Qt::LeftButton);
        QTRY_COMPARE(cloud.width(), before);
    }

    // A title never widens its pane: text that does not fit ends in "…", and the remark is dropped first.
    void aLongNoteMakesNoPaneWider() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        for (const int width : {853, 1280, 1920}) {
            resizeTo(on.window, {width, 800});
            Pane& cloud = paneOf(on.viewer.views.cloud());
            const int least = cloud.minimumSizeHint().width();
            cloud.setNote(QString(400, 'x'));
            QApplication::processEvents();
            QVERIFY(cloud.minimumSizeHint().width() <= least);
            QVERIFY(cloud.aloneButton()->geometry().right() < cloud.width());
            for (const QLabel* label : cloud.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
                QVERIFY2(label->isHidden() || label->text() != cloud.remark(), "the remark stands over the note");
        }
    }
};

int pane_test(int argc, char** argv) { return runWindowTest<PaneTest>(argc, argv); }

#include "pane_test.moc"
