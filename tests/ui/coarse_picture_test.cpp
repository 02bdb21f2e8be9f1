// The coarse picture that a large scan has until its edges are found.
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/window/start.h"

#include <QToolTip>

using namespace edgescan;
using namespace edgescan::ui;

class CoarsePictureTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;
    static constexpr int kLines = 301, kBeams = 400;

    /// Looks at the window at the moment when the coarse picture has come: what follows waits in the event loop.
    static bool openUntilCoarse(WindowFixture& on, const std::string& path, const std::function<void()>& look) {
        on.viewer.engine.setCoarseAbove(1000);
        bool seen = false;
        QObject lifetime;
        QObject::connect(&on.viewer.engine, &Engine::coarseChanged, &lifetime, [&] {
            if (!on.viewer.engine.coarse() || std::exchange(seen, true)) return;
            look();
        });
        on.viewer.files.open({QString::fromStdString(path)});
        return eventually([&] { return seen; });
    }
    static void click(QWidget& view) {
        QToolTip::hideText();
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.rect().center());
    }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = kLines;
        settings.beams = kBeams;
        scan_ = (folder_ / "large.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, scan_)));
    }

    void itIsShownFirstWithoutEdgesOrNumbers() {
        WindowFixture on;
        QVERIFY(on.show());
        StartPage* page = showStart(on.window, on.preferences);
        QVERIFY(page->isVisible());
        QVERIFY(openUntilCoarse(on, scan_, [&] {
            const QString note = "Coarse picture of 0.1 million cells, the rest is coming";
            QVERIFY(!page->isVisible());
            QVERIFY(!on.viewer.engine.picture() && on.viewer.engine.opening());
            QCOMPARE(on.viewer.gray.note(), note);
            QCOMPARE(on.viewer.gray.image()->size(), QSize((kBeams + 2) / 3, (kLines + 2) / 3));
            QCOMPARE(on.viewer.cloud.geometryOfCloud(), on.viewer.engine.coarse()->cloud);
            QVERIFY(!on.viewer.edges.image());
            QCOMPARE(on.viewer.statusLine.countsShown(), QString("120,400 cells · edges pending"));
            QCOMPARE(on.viewer.origin.text().contains("COARSE PICTURE"), true);
            // The click says that it waits, and pins nothing.
            click(on.viewer.gray);
            QVERIFY2(QToolTip::text().startsWith("Cells can be clicked when"), qPrintable(QToolTip::text()));
            click(on.viewer.cloud);
            QVERIFY2(QToolTip::text().startsWith("Cells can be clicked when"), qPrintable(QToolTip::text()));
            QVERIFY(!on.viewer.views.pinned());
        }));
        QVERIFY(on.settled());
        QVERIFY(!on.viewer.engine.coarse());
        QVERIFY(on.viewer.gray.note().isEmpty());
        QCOMPARE(on.viewer.gray.image()->size(), QSize(kBeams, kLines));
        QCOMPARE(on.viewer.cloud.geometryOfCloud(), on.picture().cloud);
        QVERIFY(on.viewer.statusLine.countsShown().contains("edge cells"));
        click(on.viewer.gray);
        QVERIFY(on.viewer.views.pinned().has_value());
    }

    // The whole picture is the same as without a coarse one before it.
    void theWholeIsTheSame() {
        WindowFixture with, without;
        QVERIFY(with.show() && without.show());
        QVERIFY(openUntilCoarse(with, scan_, [] {}) && with.settled());
        QVERIFY(without.open(scan_));
        QCOMPARE(*with.picture().detection->mask == *without.picture().detection->mask, true);
        QCOMPARE(*with.viewer.gray.image(), *without.viewer.gray.image());
        QVERIFY(with.viewer.cloud.camera() == without.viewer.cloud.camera());
        QVERIFY(with.viewer.gray.viewPort()->fitted());
    }

    void whatWasTurnedAndZoomedStays() {
        WindowFixture on;
        QVERIFY(on.show());
        CameraPose turned;
        QPointF seen;
        double shown = 0.0;
        QVERIFY(openUntilCoarse(on, scan_, [&] {
            on.viewer.cloud.viewTop();
            turned = on.viewer.cloud.camera();
            ViewPort& port = *on.viewer.gray.viewPort();
            port.zoomAt(QPointF(40, 30), 4.0);
            seen = {port.centre().x() / port.imageSize().width(), port.centre().y() / port.imageSize().height()};
            shown = port.zoom() * port.imageSize().height();
        }));
        QVERIFY(on.settled());
        const CameraPose now = on.viewer.cloud.camera();
        QVERIFY((now.position - turned.position).norm() < 1e-9 && (now.focus - turned.focus).norm() < 1e-9);
        const ViewPort& port = *on.viewer.gray.viewPort();
        QCOMPARE(port.imageSize(), QSize(kBeams, kLines));
        QVERIFY(std::abs(port.centre().x() / kBeams - seen.x()) < 1e-9 && std::abs(port.centre().y() / kLines - seen.y()) < 1e-9);
        QVERIFY(std::abs(port.zoom() * kLines - shown) < 1e-9 * shown);
    }

    void cancelEmptiesTheViews() {
        WindowFixture on;
        QVERIFY(on.show());
        StartPage* page = showStart(on.window, on.preferences);
        QVERIFY(openUntilCoarse(on, scan_, [&] { on.viewer.engine.cancel(); }));
        QVERIFY(eventually([&] { return !on.viewer.engine.working(); }));
        QVERIFY(!on.viewer.engine.picture() && !on.viewer.engine.coarse());
        QVERIFY(!on.viewer.gray.image() && !on.viewer.cloud.geometryOfCloud());
        QVERIFY(on.viewer.gray.note().startsWith("Open a scan"));
        QVERIFY(on.viewer.statusLine.countsShown().isEmpty());
        QVERIFY(page->isVisible());
        // The next scan has its own.
        QVERIFY(openUntilCoarse(on, scan_, [] {}) && on.settled());
    }

    // The picture on the screen stays in use until the next one is whole, and a cancelled opening goes back to it.
    void anotherScanOnTheScreenStays() {
        WindowFixture on;
        on.viewer.engine.setCoarseAbove(1000);
        QVERIFY(on.show() && on.open(scan_));
        bool coarse = false;
        connect(&on.viewer.engine, &Engine::coarseChanged, this, [&] { coarse = true; });
        const auto before = on.viewer.engine.picture();
        on.viewer.files.open({QString::fromStdString(scan_)});
        QVERIFY(eventually([&] { return on.viewer.engine.picture() != before && !on.viewer.engine.working(); }));
        QVERIFY(!coarse);
    }

    void aSmallScanHasNone() {
        WindowFixture on;
        bool coarse = false;
        connect(&on.viewer.engine, &Engine::coarseChanged, this, [&] { coarse = true; });
        QVERIFY(on.show() && on.open(scan_));
        QVERIFY(!coarse);
    }
};

int coarse_picture_test(int argc, char** argv) { return runWindowTest<CoarsePictureTest>(argc, argv); }
#include "coarse_picture_test.moc"
