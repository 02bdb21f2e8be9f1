// The cloud view from the user's side: a real widget, real frames.
#include "cloud_fixture.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QSignalSpy>

#include <functional>
#include <utility>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;

class CloudViewTest : public CloudFixture {
    Q_OBJECT
private slots:
    void emptyViewSaysSo() {
        const QImage image = view_->grabFrame();
        keep(image, "cloud_empty");
        QVERIFY(view_->context() != nullptr && view_->context()->isValid());
        QCOMPARE(image.pixelColor(5, 5), QColor(48, 48, 48));
        QVERIFY(colours(image) > 1); // the text
        hover(*view_, {100, 100});
        wheel(*view_, {100, 100}, 2);
        drag(*view_, Qt::LeftButton, Qt::NoModifier, {100, 100}, {200, 200});
        view_->viewTop();
        view_->zoomToFit();
        view_->flyTo(3);
        view_->setMarkedCell(4);
        QVERIFY(!view_->grabFrame().isNull());
    }

    void scanWithoutAnyPointSaysSo() {
        view_->setScan(demo::room(20, 30, 1));
        view_->setEdges(std::make_shared<std::vector<std::uint32_t>>(std::vector<std::uint32_t>{1, 2, 3}));
        const QImage image = view_->grabFrame();
        keep(image, "cloud_no_point");
        QCOMPARE(countPixels(image, isGreen), 0);
        QVERIFY(colours(image) > 1);
    }

    void cloudAndEdgesHaveTheirColours() {
        view_->setScan(scan_);
        const QImage plain = view_->grabFrame(CloudView::Points::All);
        keep(plain, "cloud_plain");
        QVERIFY(countPixels(plain, isGray121) > 20000);
        QCOMPARE(countPixels(plain, isGreen), 0);

        view_->setEdges(edges_);
        const QImage image = view_->grabFrame(CloudView::Points::All);
        keep(image, "cloud_edges");
        keep(image.copy(200, 150, 220, 180).scaled(880, 720), "cloud_edges_close");
        QVERIFY(countPixels(image, isGreen) > static_cast<int>(edges_->size()));
        QVERIFY(countPixels(image, isHalo) > 500);

        view_->setEdgeColours(kColourBlindColours);
        const QImage yellow = view_->grabFrame();
        QCOMPARE(countPixels(yellow, isGreen), 0);
        QVERIFY(countPixels(yellow, isYellow) > static_cast<int>(edges_->size()));

        view_->setEdgesVisible(false);
        const QImage off = view_->grabFrame();
        QCOMPARE(countPixels(off, isYellow), 0);
        QVERIFY(countPixels(off, isBright) > 20000);
        view_->setEdgesVisible(true);
        view_->setCloudDimmed(false);
        QVERIFY(countPixels(view_->grabFrame(), isBright) > 20000);
    }

    void everyVisibleEdgePointIsGreen() {
        view_->setScan(scan_);
        view_->setEdges(edges_);
        const QImage image = view_->grabFrame();
        const double dpr = view_->devicePixelRatioF();
        int green = 0;
        for (const std::uint32_t k : *edges_) {
            const auto at = view_->pixelOf(k);
            QVERIFY(at);
            const QPoint p(static_cast<int>(at->x() * dpr), static_cast<int>(at->y() * dpr));
            if (image.rect().contains(p)) green += isGreen(image.pixel(p));
        }
        QVERIFY2(green > 0.97 * static_cast<double>(edges_->size()), qPrintable(QString("%1 of %2").arg(green).arg(edges_->size())));
    }

    void edgesBehindRockStayHidden() {
        view_->setScan(scan_);
        view_->setPointSize(5); // closed surfaces
        auto one = std::make_shared<std::vector<std::uint32_t>>();
        view_->viewLeft();
        (void)view_->grabFrame();
        // The wall at x = -6 is on the right of the scanner. From the left, the other wall hides most of it.
        const auto& cloud = *view_->geometryOfCloud();
        for (std::uint32_t k = 0; k < cloud.cells(); ++k) {
            if (cloud.point(k).x() < -5.9F) one->push_back(k);
        }
        QVERIFY(!one->empty());
        view_->setEdges(one);
        const int seen = countPixels(view_->grabFrame(CloudView::Points::All), isGreen);
        view_->viewRight();
        const int open = countPixels(view_->grabFrame(CloudView::Points::All), isGreen);
        QVERIFY2(seen * 2 < open, qPrintable(QString("%1 %2").arg(seen).arg(open)));
    }

    void retuneReplacesOnlyTheEdges() {
        view_->setScan(scan_);
        view_->setEdges(edges_);
        const int before = countPixels(view_->grabFrame(CloudView::Points::All), isGreen);
        view_->setEdges(std::make_shared<std::vector<std::uint32_t>>(edges_->begin(), edges_->begin() + 50));
        const int fewer = countPixels(view_->grabFrame(CloudView::Points::All), isGreen);
        QVERIFY(fewer > 0 && fewer < before / 4);
        view_->setEdges(std::make_shared<std::vector<std::uint32_t>>());
        QCOMPARE(countPixels(view_->grabFrame(CloudView::Points::All), isGreen), 0);
        view_->setEdges(edges_);
        QCOMPARE(countPixels(view_->grabFrame(CloudView::Points::All), isGreen), before);
        view_->setEdges(nullptr);
        QCOMPARE(countPixels(view_->grabFrame(CloudView::Points::All), isGreen), 0);
    }

    void edgeCellsWithoutAPointAreLeftOut() {
        const auto holes = demo::room(60, 80, 2);
        view_->setScan(holes);
        auto all = std::make_shared<std::vector<std::uint32_t>>();
        for (std::uint32_t k = 0; k < 6000; ++k) all->push_back(k); // invalid cells and cells beyond the end
        view_->setEdges(all);
        QVERIFY(countPixels(view_->grabFrame(), isGreen) > 1000);
    }

    void markerAndRay() {
        view_->setScan(scan_);
        view_->setEdges(edges_);
        view_->viewIsometric();
        const QImage before = view_->grabFrame(CloudView::Points::All);
        keep(before, "cloud_isometric");
        const auto cell = view_->cellAt({520, 400});
        QVERIFY(cell);
        QVERIFY(rests());
        const int settled = view_->framesDrawn();
        view_->setMarkedCell(cell);
        view_->repaint();
        QCOMPARE(view_->framesDrawn(), settled); // moving the marker does not redraw the points
        const QImage image = view_->grabFrame(CloudView::Points::All);
        keep(image, "cloud_marker");
        keep(image.copy(420, 330, 220, 180).scaled(880, 720), "cloud_marker_close");
        const auto white = [](QRgb p) { return qRed(p) > 240 && qGreen(p) > 240 && qBlue(p) > 240; };
        const QPoint at = (*view_->pixelOf(*cell) * view_->devicePixelRatioF()).toPoint();
        const int reach = static_cast<int>(12 * view_->devicePixelRatioF());
        QVERIFY(countPixels(image.copy(QRect(at - QPoint(reach, reach), at + QPoint(reach, reach))), white) > 30);
        QCOMPARE(countPixels(before, white), 0);
        // A hidden point gets a dotted ring.
        bool hidden = false;
        for (std::uint32_t k = 0; k < scan_->cells(); k += 31) {
            const auto seen = view_->pixelOf(k);
            if (!seen || !view_->rect().contains(seen->toPoint())) continue;
            const auto front = view_->cellAt(*seen);
            if (!front || (view_->geometryOfCloud()->point(*front) - view_->geometryOfCloud()->point(k)).norm() < 3.0F) continue;
            view_->setMarkedCell(k);
            const QImage dotted = view_->grabFrame(CloudView::Points::All);
            keep(dotted, "cloud_marker_hidden");
            QVERIFY(countPixels(dotted, white) > 0);
            hidden = true;
            break;
        }
        QVERIFY(hidden);
        view_->setMarkedCell(std::nullopt);
        QCOMPARE(countPixels(view_->grabFrame(), white), 0);
    }

    void viewsLookFromTheirSides() {
        view_->setScan(scan_);
        view_->setEdges(edges_);
        const ViewFrame axes = view_->geometryOfCloud()->axes;
        const Eigen::Vector3d fromBehind = -axes.forward, fromTheRight = -axes.right, fromTheTop = -axes.up;
        struct Case {
            const char* name;
            void (CloudView::*go)();
            Eigen::Vector3d forward;
        };
        const std::vector<Case> cases = {{"front", &CloudView::viewFront, axes.forward}, {"back", &CloudView::viewBack, fromBehind},
                                         {"left", &CloudView::viewLeft, axes.right},     {"right", &CloudView::viewRight, fromTheRight},
                                         {"top", &CloudView::viewTop, fromTheTop},       {"bottom", &CloudView::viewBottom, axes.up}};
        for (const Case& c : cases) {
            (view_.get()->*c.go)();
            QVERIFY(view_->camera().forward().isApprox(c.forward));
            const QImage image = view_->grabFrame();
            keep(image, QString("cloud_") + c.name);
            QVERIFY(countPixels(image, isGray121) > 3000);
        }
        view_->viewFront();
        view_->setParallel(true);
        QVERIFY(countPixels(view_->grabFrame(), isGray121) > 3000);
        QVERIFY(countPixels(view_->grabFrame(), isGreen) > 300);
        keep(view_->grabFrame(), "cloud_parallel");
        QVERIFY(view_->cellAt({450, 320}).has_value());
        view_->flyTo(100 * 300 + 150);
        QVERIFY(QLineF(*view_->pixelOf(100 * 300 + 150), QPointF(450, 320)).length() < 1.0);
        view_->zoomToFit();
        view_->zoomToCells({100 * 300 + 150, 110 * 300 + 160});
        const QRectF area = view_->rect();
        QVERIFY(area.contains(*view_->pixelOf(110 * 300 + 160)));
    }

    // Fit keeps the direction and does not go behind a wall, which would cover everything.
    // A wall behind an opening must not look like the rocks around it. Colours of points stay: they have a meaning.
    void fartherSurfacesFade() {
        view_->setShaded(true);
        auto deep = std::make_shared<Scan>(*scan_);
        constexpr int kFarLines = 50;
        const auto beams = static_cast<std::size_t>(deep->beams());
        for (std::size_t k = 0; k < kFarLines * beams; ++k) deep->rangeMm[k] *= 4.0F;
        view_->setScan(deep);
        const auto meanGray = [&](bool far) {
            const QImage image = view_->grabFrame(CloudView::Points::All);
            double sum = 0.0;
            int pixels = 0;
            for (int x = 10; x < view_->width(); x += 8) {
                for (int y = 10; y < view_->height(); y += 8) {
                    const auto cell = view_->cellAt(QPointF(x, y));
                    if (!cell || (*cell < kFarLines * beams) != far) continue;
                    sum += qGray(image.pixel(x, y));
                    ++pixels;
                }
            }
            return pixels < 30 ? -1.0 : sum / pixels;
        };
        const double near = meanGray(false), far = meanGray(true);
        QVERIFY2(far > 48.0 && far < 0.8 * near, qPrintable(QString("%1 %2").arg(far).arg(near))); // 48: the background
        constexpr std::uint32_t kGray = 0xff797979U;
        view_->setFaces(std::make_shared<const std::vector<std::uint32_t>>(deep->cells(), kGray));
        const double plain = meanGray(true);
        QVERIFY2(plain > far + 3.0, qPrintable(QString("%1 %2").arg(plain).arg(far)));
        view_->setFaces(nullptr);
        QVERIFY(std::abs(meanGray(true) - far) < 1.0);
    }

    void fitShowsAllOfTheCloud() {
        view_->setScan(scan_);
        const auto fronts = [&] {
            const CloudGeometry& cloud = *view_->geometryOfCloud();
            int front = 0, all = 0;
            for (int x = 10; x < view_->width(); x += 30) {
                for (int y = 10; y < view_->height(); y += 30) {
                    const auto cell = view_->cellAt(QPointF(x, y));
                    if (!cell) continue;
                    const Eigen::Vector3d way = cloud.point(*cell).cast<double>() - view_->camera().position;
                    ++all;
                    front += way.dot(cloud.normal(*cell).cast<double>()) < 0.0 ? 1 : 0;
                }
            }
            return all == 0 ? 0.0 : static_cast<double>(front) / all;
        };
        // The operator asked for the walls from outside: Fit shows all of it again.
        view_->viewRight();
        QVERIFY2(fronts() < 0.5, qPrintable(QString::number(fronts())));
        const CameraPose right = view_->camera();
        view_->setCamera(zoomed(right, right.focus, 2.5));
        view_->zoomToFit();
        QVERIFY(view_->camera().forward().isApprox(right.forward()));
        QVERIFY2(view_->shareInPicture() > 0.99, qPrintable(QString::number(view_->shareInPicture()))); // the end of the drift too
        // From wherever the view was turned to, Fit keeps the direction and shows all of the cloud.
        view_->viewFromScanner();
        const CameraPose scanners = view_->camera();
        for (const double rightRad : {0.05, 0.3, 0.8, 1.6, 3.0}) {
            for (const double upRad : {-0.6, 0.0, 0.4}) {
                view_->setCamera(turned(scanners, scanners.focus, scanners.up, rightRad, upRad));
                const Eigen::Vector3d forward = view_->camera().forward();
                for (int n = 0; n < 2; ++n) { // once more changes nothing
                    view_->zoomToFit();
                    QVERIFY2(view_->shareInPicture() > 0.99 && view_->camera().forward().isApprox(forward),
                             qPrintable(QString("%1 %2 %3").arg(rightRad).arg(upRad).arg(view_->shareInPicture())));
                }
            }
        }
        // Zoomed and moved, the scanner's view is what it was.
        view_->setCamera(zoomed(scanners, scanners.focus, 2.0));
        view_->zoomToFit();
        QVERIFY(fronts() > 0.9 && view_->camera() == scanners);
        // Once more, where nothing is left to do: all of it, in this direction.
        view_->zoomToFit();
        QVERIFY2(view_->shareInPicture() > 0.99, qPrintable(QString::number(view_->shareInPicture())));
        QVERIFY(view_->camera().forward().isApprox(scanners.forward()));
    }

    void growingScanKeepsTheCamera() {
        view_->setScan(scan_);
        drag(*view_, Qt::LeftButton, Qt::NoModifier, {400, 300}, {450, 330});
        const CameraPose pose = view_->camera();
        const auto next = demo::room(200, 300, 5);
        view_->setCloud(next, makeCloudGeometry(*next), CloudView::Camera::Keep);
        QVERIFY(view_->camera().position.isApprox(pose.position));
        view_->setCloud(scan_, makeCloudGeometry(*scan_));
        QVERIFY(!view_->camera().position.isApprox(pose.position));
    }

    void oneScanAfterAnotherLeavesNothingBehind() {
        const auto other = demo::room(90, 410, 3);
        const auto otherEdges = demo::edges(*other);
        const auto show = [&](const std::shared_ptr<Scan>& scan, const std::shared_ptr<const std::vector<std::uint32_t>>& cells) {
            view_->setScan(scan);
            view_->setEdges(cells);
            return view_->grabFrame(CloudView::Points::All);
        };
        const QImage first = show(scan_, edges_);
        const QImage second = show(other, otherEdges);
        QVERIFY(first != second);
        for (int i = 0; i < 4; ++i) {
            QCOMPARE(show(scan_, edges_), first);
            QCOMPARE(show(nullptr, nullptr).pixelColor(3, 3), QColor(48, 48, 48));
            QCOMPARE(show(other, otherEdges), second);
            if (i % 2 == 1) QVERIFY(rests()); // with and without frames in between
        }
    }

    void rendersAreMerged() {
        view_->setScan(scan_);
        QVERIFY(rests());
        const int before = view_->framesDrawn();
        for (int i = 0; i < 100; ++i) view_->setPointSize(1 + i % 5);
        QVERIFY(rests());
        QVERIFY(view_->framesDrawn() - before <= 2);
        const int settled = view_->framesDrawn();
        view_->update(); // shows the old frame again
        view_->repaint();
        QCOMPARE(view_->framesDrawn(), settled);
    }
};

int cloud_view_test(int argc, char** argv) { return runCloudTest<CloudViewTest>(argc, argv); }
#include "cloud_view_test.moc"
#include "moc_cloud_fixture.cpp"
