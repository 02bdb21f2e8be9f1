// The display of the scan itself: points by range, height and line with a scale in metres, axes, scale bar, ground grid, and the window of
// the range image on its histogram.
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"
#include "ui/controllers/scan_look.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/views/cloud/scale_plate.h"

#include <QAction>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <cmath>

using namespace edgescan;
using namespace edgescan::ui;

class ScanLookTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string boxes_, other_, placed_;

    static bool shown(WindowFixture& on, const std::string& path) {
        on.window.resize(1280, 800);
        return on.showWith(path) && on.activate() && rested(on);
    }
    static bool rested(WindowFixture& on) {
        return eventually([&] { return on.viewer.look.settled() && on.viewer.views.cloud().atRest(); });
    }
    static ScalePlate& plate(WindowFixture& on) { return *on.window.findChild<ScalePlate*>("scale-plate"); }
    static QRgb colourOf(WindowFixture& on, std::size_t k) {
        const std::uint32_t bytes = (*on.viewer.views.cloud().pointColours())[k];
        return qRgb(static_cast<int>(bytes & 255U), static_cast<int>((bytes >> 8U) & 255U), static_cast<int>((bytes >> 16U) & 255U));
    }
    static int grayAt(WindowFixture& on, std::size_t k) {
        const QPoint at = on.viewer.views.placeOf(k);
        return qRed(on.viewer.views.gray().image()->pixel(at));
    }
    // Drags with one mouse button over the handles, from one range to another.
    static void drag(RangeHandles& handles, double fromM, double toM) {
        const auto at = [&](double metres) { return QPoint(static_cast<int>(std::lround(handles.toX(metres))), handles.height() / 3); };
        QTest::mousePress(&handles, Qt::LeftButton, Qt::NoModifier, at(fromM));
        for (const double share : {0.3, 0.7, 1.0}) {
            const QPoint place = at(fromM + share * (toM - fromM));
            QMouseEvent move(QEvent::MouseMove, place, handles.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&handles, &move);
        }
        QTest::mouseRelease(&handles, Qt::LeftButton, Qt::NoModifier, at(toM));
    }

private slots:
    void initTestCase() {
        const auto save = [&](const Scan& scan, const char* name) {
            const std::string path = (folder_ / name).string();
            if (!files::saveScan(scan, path)) qFatal("%s cannot be written", path.c_str());
            return path;
        };
        Scan scan = test::boxesScan(120, 160, 3, 0.02);
        boxes_ = save(scan, "boxes.json");
        other_ = save(test::boxesScan(120, 160, 9, 0.02), "other.json");
        scan.placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
        placed_ = save(scan, "placed.json");
    }

    void pointsHaveTheColourOfTheirRange() {
        WindowFixture on;
        QVERIFY(shown(on, boxes_));
        CloudView& cloud = on.viewer.views.cloud();
        QVERIFY(!cloud.pointColours() && plate(on).scaleTitle().isEmpty());
        QTest::keyClick(&on.window, Qt::Key_J, Qt::ShiftModifier);
        QVERIFY(rested(on));
        QVERIFY(cloud.pointColours());
        QVERIFY2(plate(on).scaleTitle().contains("[m]"), qPrintable(plate(on).scaleTitle()));
        const Scan& scan = *on.picture().detection->scan;
        // The ends of the scale are the 1st and 99th percentile of the ranges, and every cell has the colour of its range.
        std::vector<double> ranges;
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] == CellState::Valid) ranges.push_back(static_cast<double>(scan.rangeMm[k]) / 1000.0);
        }
        std::ranges::sort(ranges);
        const double low = ranges[ranges.size() / 100], high = ranges[ranges.size() - 1 - ranges.size() / 100];
        for (std::size_t k = 0; k < scan.cells(); k += 37) {
            if (scan.state[k] != CellState::Valid) continue;
            const QRgb expected = colourAt((static_cast<double>(scan.rangeMm[k]) / 1000.0 - low) / (high - low)), now = colourOf(on, k);
            QVERIFY(std::abs(qRed(now) - qRed(expected)) < 4 && std::abs(qGreen(now) - qGreen(expected)) < 4 &&
                    std::abs(qBlue(now) - qBlue(expected)) < 4);
        }
        const auto ticks = plate(on).scaleTicks();
        QVERIFY(ticks.size() >= 2);
        for (const auto& [share, text] : ticks)
            QVERIFY(std::abs(low + share * (high - low) - text.toDouble()) < 0.02 * (high - low) + 0.01);
        // Edges are drawn over them; the frame contains the colours of the scale.
        const QImage frame = cloud.grabFrame(CloudView::Points::All);
        QVERIFY(countPixels(frame, [](QRgb p) { return qGreen(p) > 200 && qRed(p) < 60; }) > 50);
        QVERIFY(countPixels(frame, [](QRgb p) { return qBlue(p) > qRed(p) + 30 && qBlue(p) > qGreen(p) + 20; }) > 200);
        QVERIFY(countPixels(frame, [](QRgb p) { return qRed(p) > qBlue(p) + 30; }) > 200);
        // Rocks have their own colours; without rocks the range colours return.
        const auto coloured = cloud.pointColours();
        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }));
        QVERIFY(cloud.pointColours() != coloured && rested(on));
        QVERIFY(plate(on).scaleTitle().isEmpty());
        QTest::keyClick(&on.window, Qt::Key_K);
        QTRY_VERIFY(cloud.pointColours() == coloured && !plate(on).scaleTitle().isEmpty());
        // Another scan has its own colours.
        QVERIFY(on.open(other_) && rested(on));
        QVERIFY(cloud.pointColours() && cloud.pointColours() != coloured);
        on.window.findChild<QAction*>("colour-gray")->trigger();
        QVERIFY(rested(on));
        QVERIFY(!cloud.pointColours() && plate(on).scaleTitle().isEmpty());
    }

    void intensityIsOfferedWhereTheFileHasIt() {
        Scan scan = test::boxesScan(120, 160, 3, 0.02);
        scan.intensity = Grid<float>(scan.lines(), scan.beams(), std::numeric_limits<float>::quiet_NaN());
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] == CellState::Valid && k % 160 >= 10) scan.intensity[k] = static_cast<float>(k % 160);
        }
        for (const char* name : {"strong.pcd", "strong.ply", "strong.las"}) {
            const std::string path = (folder_ / name).string();
            const auto saved = files::saveScan(scan, path);
            QVERIFY2(saved, saved ? "" : saved.error().sentence().c_str());
            WindowFixture on;
            QVERIFY(shown(on, boxes_));
            auto* action = on.window.findChild<QAction*>("colour-intensity");
            QVERIFY(!action->isEnabled());
            QVERIFY2(action->text().contains("this scan has none"), qPrintable(action->text()));
            QVERIFY2(on.open(path) && rested(on), name);
            QVERIFY2(action->isEnabled(), name);
            action->trigger();
            QVERIFY(rested(on));
            QCOMPARE(plate(on).scaleTitle(), QString("Intensity"));
            // Weak returns are blue, strong ones are not.
            const Grid<float>& intensity = on.picture().detection->scan->intensity;
            std::vector<std::pair<float, int>> blues;
            for (std::size_t k = 0; k < intensity.size(); ++k) {
                if (std::isfinite(intensity[k])) blues.emplace_back(intensity[k], qBlue(colourOf(on, k)));
            }
            QVERIFY(blues.size() > 1000);
            std::ranges::sort(blues);
            QVERIFY2(blues[blues.size() / 20].second > blues[blues.size() * 19 / 20].second + 30, name);
        }
    }

    void heightIsThatOfTheMineWhereThereIsAPose() {
        for (const bool placed : {false, true}) {
            WindowFixture on;
            QVERIFY(shown(on, placed ? placed_ : boxes_));
            QTest::keyClick(&on.window, Qt::Key_H, Qt::ShiftModifier);
            QVERIFY(rested(on));
            QCOMPARE(plate(on).scaleTitle().contains("RL"), placed);
            QCOMPARE(plate(on).axisNames()[2] == "RL", placed);
            // Of two cells the higher one is further along the scale.
            const edges::Detection& detection = *on.picture().detection;
            const auto heightOf = [&](std::size_t k) {
                const edges::Probe probe = edges::probeCell(detection, k);
                return placed ? probe.mineM->z() : on.picture().cloud->axes.up.dot(probe.pointM);
            };
            std::vector<std::pair<double, std::size_t>> heights;
            for (std::size_t k = 0; k < detection.scan->cells(); k += 101) {
                if (detection.scan->state[k] == CellState::Valid) heights.emplace_back(heightOf(k), k);
            }
            std::ranges::sort(heights);
            const auto blue = [&](double share) {
                return qBlue(colourOf(on, heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))].second));
            };
            // blue decreases along the scale
            for (double share = 0.05; share < 0.9; share += 0.1) QVERIFY(blue(share) >= blue(share + 0.05));
            QVERIFY(blue(0.02) > blue(0.98) + 100);
        }
    }

    void aMetreOnTheScaleIsAMetreInTheCloud() {
        WindowFixture on;
        QVERIFY(shown(on, boxes_));
        CloudView& cloud = on.viewer.views.cloud();
        enum class View { FromScanner, Isometric, Parallel };
        for (const View view : {View::FromScanner, View::Isometric, View::Parallel}) {
            const bool parallel = view == View::Parallel;
            cloud.setParallel(parallel);
            view == View::FromScanner ? cloud.viewFromScanner() : cloud.viewIsometric();
            QVERIFY(rested(on));
            const QString text = plate(on).barText();
            QCOMPARE(text.contains(" at "), view == View::FromScanner); // there, the distance counts from the scanner
            QCOMPARE(text.startsWith("≈ "), view == View::Isometric);
            const QString length = QString(text).remove("≈ ");
            const double metres = length.section(' ', 0, 0).toDouble() * (length.section(' ', 1, 1) == "mm" ? 0.001 : 1.0);
            const CameraPose pose = cloud.camera();
            const auto pixel = [&](const Eigen::Vector3d& at) {
                const ScreenPoint p = toScreen(cloud.screenView(), at.cast<float>());
                return QPointF(p.x, p.y) / cloud.devicePixelRatioF();
            };
            // The median depth of the points in view.
            std::vector<double> depths;
            for (std::uint32_t k = 0; k < cloud.geometryOfCloud()->cells(); ++k) {
                const auto place = cloud.pixelOf(k);
                if (place && QRectF(cloud.rect()).contains(*place))
                    depths.push_back(pose.forward().dot(cloud.geometryOfCloud()->point(k).cast<double>() - pose.position));
            }
            QVERIFY(depths.size() > 100);
            std::ranges::nth_element(depths, depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2));
            const double median = depths[depths.size() / 2];
            double depth = parallel ? pose.distance() : median;
            if (view == View::FromScanner) {
                depth = length.section(' ', 3, 3).toDouble() +
                        pose.forward().dot(cloud.geometryOfCloud()->sensor.cast<double>() - pose.position);
                QVERIFY2(std::abs(depth - median) < 0.05 + 0.02 * median, qPrintable(text + QString(" %1").arg(median)));
            }
            const Eigen::Vector3d middle = pose.position + depth * pose.forward();
            const QPointF way = pixel(middle + metres * pose.right()) - pixel(middle);
            QVERIFY2(std::abs(std::hypot(way.x(), way.y()) - plate(on).barPixels()) < 0.5 + 0.02 * plate(on).barPixels(), qPrintable(text));
            for (int n = 0; n < 3; ++n) { // an axis points along its projected direction
                const QPointF along = pixel(pose.focus + 0.01 * Eigen::Vector3d::Unit(n)) - pixel(pose.focus);
                const Eigen::Vector2d axis = plate(on).axesOnScreen()[static_cast<std::size_t>(n)];
                QVERIFY(axis.norm() < 0.05 || std::abs(along.x() * axis.y() + along.y() * axis.x()) <
                                                  0.1 * axis.norm() * std::hypot(along.x(), along.y()) + 1e-6);
            }
        }
        QVERIFY(plate(on).isVisible());
    }

    // The middle of the view looks through a gap at a far wall.
    void theScaleIsForWhatIsMostlySeen() {
        WindowFixture on;
        const std::string path = (folder_ / "gap.json").string();
        const auto range = [](int line, int beam) { return std::abs(line - 60) < 12 && std::abs(beam - 80) < 12 ? 19000.0F : 5000.0F; };
        QVERIFY(bool(files::saveScan(test::makeScan(120, 160, range), path)));
        QVERIFY(shown(on, path));
        on.viewer.views.cloud().viewFromScanner();
        QVERIFY(rested(on));
        const double at = plate(on).barText().section(' ', 3, 3).toDouble();
        QVERIFY2(at > 0.0 && at < 6.0, qPrintable(plate(on).barText()));
        QVERIFY(!plate(on).toolTip().isEmpty());
    }

    void theGroundGridIsDrawnBelow() {
        WindowFixture on;
        QVERIFY(shown(on, boxes_));
        CloudView& cloud = on.viewer.views.cloud();
        cloud.viewIsometric();
        QVERIFY(rested(on));
        const auto lines = [](QRgb p) { return p == qRgb(0x85, 0x8b, 0x92); };
        QCOMPARE(countPixels(cloud.grabFrame(CloudView::Points::All), lines), 0);
        QTest::keyClick(&on.window, Qt::Key_K, Qt::ShiftModifier);
        QVERIFY(rested(on));
        QVERIFY(cloud.groundStepM() > 0.0);
        QVERIFY(countPixels(cloud.grabFrame(CloudView::Points::All), lines) > 200);
        const GroundGrid grid = groundOf(*on.picture().cloud);
        std::size_t below = 0;
        const CloudGeometry& points = *on.picture().cloud;
        const double level = points.axes.up.dot(grid.lines.front()[0].cast<double>());
        for (std::size_t k = 0; k < points.cells(); ++k) {
            if (points.drawable(k) && points.axes.up.dot(points.point(k).cast<double>()) < level - 1e-4) ++below;
        }
        QVERIFY2(below <= points.validCount / 50, qPrintable(QString::number(below)));
        QVERIFY(grid.lines.size() >= 8 && grid.lines.size() < 60);
    }

    void noNumberOfTheRangeWindowIsCut() {
        for (const char* code : {"en", "fr", "es", "pt"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            for (int wide = 480; wide >= 260; wide -= 20) {
                RangeWindow window;
                window.resize(wide, window.sizeHint().height());
                window.showWindow({2.1, 16.3}, true);
                window.show();
                QVERIFY(QTest::qWaitForWindowExposed(&window));
                const auto* words = window.findChild<QLabel*>("range-window-words");
                QVERIFY2(words->fontMetrics().horizontalAdvance(words->text()) <= words->width(),
                         qPrintable(QString("%1 %2: %3 in %4 px").arg(code).arg(wide).arg(words->text()).arg(words->width())));
            }
        }
        useLanguage("en");
    }

    void theRangeWindowIsDraggedLockedAndAutomaticAgain() {
        const QString ini = QString::fromStdString((folder_ / "viewer.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(shown(on, boxes_));
            RangeWindow& window = on.viewer.rangeWindow;
            RangeHandles& handles = window.handles();
            QVERIFY(window.isVisible());
            const std::shared_ptr<const QImage> automatic = on.viewer.views.gray().image();
            QVERIFY(automatic == on.picture().gray);
            const auto before = handles.window();
            const double nearM = before.first, wanted = before.first + 0.4 * (before.second - before.first);
            drag(handles, before.second, wanted);
            QVERIFY(std::abs(handles.window().second - wanted) < 0.05);
            QCOMPARE(handles.window().first, nearM);
            // The range image shows these ranges from black to white; the edges do not change.
            const Scan& scan = *on.picture().detection->scan;
            const auto [low, high] = handles.window();
            for (std::size_t k = 0; k < scan.cells(); k += 53) {
                if (scan.state[k] != CellState::Valid) continue;
                const double level = std::clamp((static_cast<double>(scan.rangeMm[k]) / 1000.0 - low) / (high - low) * 255.0, 0.0, 255.0);
                QVERIFY(std::abs(grayAt(on, k) - level) <= 1.0);
            }
            QVERIFY(!on.viewer.undo.canUndo() && on.viewer.engine.settings() == edges::Settings{});
            // Keys move the ends too.
            handles.setFocus();
            QTest::keyClick(&handles, Qt::Key_Right);
            QVERIFY(handles.window().second > high);
            QTest::keyClick(&handles, Qt::Key_Right, Qt::ShiftModifier);
            QVERIFY(handles.window().first > low);
            // A new scan starts with its own ranges ...
            QVERIFY(on.open(other_) && rested(on));
            QVERIFY(!on.viewer.views.rangeWindow());
            QVERIFY(on.viewer.views.gray().image() == on.picture().gray);
            // ... unless the window is locked.
            drag(handles, handles.window().second, handles.window().second - 0.5);
            const auto locked = handles.window();
            QTest::mouseClick(window.findChild<QToolButton*>("range-lock"), Qt::LeftButton);
            QVERIFY(on.open(boxes_) && rested(on));
            QVERIFY(handles.window() == locked);
            QVERIFY(on.viewer.views.gray().image() != on.picture().gray);
            // A drag with the right button over the image changes the same window.
            ImageView& gray = on.viewer.views.gray();
            QTest::mousePress(&gray, Qt::RightButton, Qt::NoModifier, gray.rect().center());
            for (const int dx : {10, 30, 60}) {
                const QPoint at = gray.rect().center() + QPoint(dx, 0);
                QMouseEvent move(QEvent::MouseMove, at, gray.mapToGlobal(at), Qt::NoButton, Qt::RightButton, Qt::NoModifier);
                QApplication::sendEvent(&gray, &move);
            }
            QTest::mouseRelease(&gray, Qt::RightButton, Qt::NoModifier, gray.rect().center() + QPoint(60, 0));
            QVERIFY(handles.window().second - handles.window().first > locked.second - locked.first);
        }
        // It is restored at the next start.
        WindowFixture on(ini);
        QVERIFY(shown(on, other_));
        QVERIFY(on.viewer.rangeWindow.locked() && on.viewer.views.rangeWindow());
        QTest::mouseClick(on.viewer.rangeWindow.findChild<QToolButton*>("range-automatic"), Qt::LeftButton);
        QVERIFY(!on.viewer.views.rangeWindow() && on.viewer.views.gray().image() == on.picture().gray);
    }

    void noEndMovesBeforeTheRangesAreCounted() {
        RangeHandles handles;
        handles.resize(240, handles.height());
        handles.setWindow({2.0, 10.0});
        QTest::mouseClick(&handles, Qt::LeftButton, Qt::NoModifier, QPoint(60, 10));
        QTest::keyClick(&handles, Qt::Key_Left);
        QVERIFY(handles.window() == RangeHandles::Window(2.0, 10.0));
        handles.showHistogram(rangeHistogram(test::boxesScan(120, 160, 3)));
        QTest::keyClick(&handles, Qt::Key_Left);
        QVERIFY(handles.window().second < 10.0);
    }

    void theHistogramCountsEveryRange() {
        const Scan scan = test::boxesScan(120, 160, 3, 0.02);
        const RangeHistogram histogram = rangeHistogram(scan);
        std::vector<std::uint32_t> counts(histogram.counts.size(), 0);
        std::size_t beyond = 0;
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] != CellState::Valid) continue;
            const auto at = static_cast<std::size_t>(static_cast<double>(scan.rangeMm[k]) / 1000.0 / histogram.mostM *
                                                     static_cast<double>(counts.size()));
            beyond += at >= counts.size() ? 1 : 0;
            ++counts[std::min(at, counts.size() - 1)];
        }
        QVERIFY(counts == histogram.counts);
        QVERIFY(beyond <= scan.cells() / 1000);
    }
};

int scan_look_test(int argc, char** argv) { return runWindowTest<ScanLookTest>(argc, argv); }
#include "scan_look_test.moc"
