// The mouse of the cloud view: real events on a real widget; frame times at full size.
#include "cloud_fixture.h"

#include <QSignalSpy>

using namespace edgescan;
using namespace edgescan::ui;

class CloudMouseTest : public CloudFixture {
    Q_OBJECT
private slots:
    void hoverAndClickFindTheCell() {
        view_->setScan(scan_);
        (void)view_->grabFrame();
        QSignalSpy hovered(view_.get(), &CloudView::hovered), left(view_.get(), &CloudView::hoverLeft);
        QSignalSpy clicked(view_.get(), &CloudView::clicked);
        const std::uint32_t cell = 100 * 300 + 150;
        const QPoint at = view_->pixelOf(cell)->toPoint();
        hover(*view_, at);
        QCOMPARE(hovered.count(), 1);
        const auto found = static_cast<std::uint32_t>(hovered[0][0].toLongLong());
        QVERIFY(QLineF(*view_->pixelOf(found), at).length() <= QLineF(*view_->pixelOf(cell), at).length() + 1e-6);
        QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::NoModifier, at);
        QCOMPARE(clicked.count(), 1);
        QCOMPARE(clicked[0][0].toLongLong(), static_cast<qint64>(found));
        hover(*view_, {2, 2});
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(view_.get(), &leave);
        QCOMPARE(left.count(), 1);
    }

    // The read-out was of the cell that a key had moved away.
    void whatIsUnderThePointerFollowsAKey() {
        view_->setScan(scan_);
        (void)view_->grabFrame();
        QSignalSpy hovered(view_.get(), &CloudView::hovered), left(view_.get(), &CloudView::hoverLeft);
        const QPoint at = view_->pixelOf(100 * 300 + 150)->toPoint();
        hover(*view_, at);
        QCOMPARE(hovered.count(), 1);
        view_->viewRight();
        QTRY_COMPARE(hovered.count() + left.count(), 2); // at rest
        hover(*view_, at);                               // the same as without the key
        QCOMPARE(hovered.count() + left.count(), 2);
    }

    void dragsMoveTheCameraAsPromised() {
        view_->setScan(scan_);
        QSignalSpy clicked(view_.get(), &CloudView::clicked);
        const CameraPose start = view_->camera();
        const auto centre = view_->rotationCentre();
        drag(*view_, Qt::LeftButton, Qt::NoModifier, {400, 300}, {500, 330});
        const CameraPose turnedPose = view_->camera();
        QVERIFY(!turnedPose.position.isApprox(start.position));
        QVERIFY(std::abs((turnedPose.position - centre).norm() - (start.position - centre).norm()) < 1e-6);

        view_->setCamera(start);
        drag(*view_, Qt::LeftButton, Qt::ShiftModifier, {400, 300}, {460, 300});
        const CameraPose panned1 = view_->camera();
        QVERIFY(panned1.forward().isApprox(start.forward()) && !panned1.position.isApprox(start.position));
        view_->setCamera(start);
        drag(*view_, Qt::MiddleButton, Qt::NoModifier, {400, 300}, {460, 300});
        QVERIFY(view_->camera().position.isApprox(panned1.position));

        view_->setCamera(start);
        drag(*view_, Qt::RightButton, Qt::NoModifier, {400, 300}, {400, 220});
        QVERIFY(view_->camera().distance() < start.distance());

        view_->setCamera(start);
        drag(*view_, Qt::LeftButton, Qt::ControlModifier, {700, 320}, {450, 560}); // clockwise on the screen
        QVERIFY(view_->camera().forward().isApprox(start.forward()));
        QVERIFY(view_->camera().up.dot(start.up) < 0.3);
        QVERIFY(view_->camera().up.dot(start.right()) < -0.5); // the picture rotates clockwise, so the camera rotates to the left
        QCOMPARE(clicked.count(), 0);
    }

    void pannedPointStaysUnderTheHand() {
        view_->setScan(scan_);
        const std::uint32_t cell = 100 * 300 + 150;
        const QPoint from = view_->pixelOf(cell)->toPoint();
        const QPointF offset = *view_->pixelOf(cell) - from;
        drag(*view_, Qt::MiddleButton, Qt::NoModifier, from, from + QPoint(80, -40));
        QVERIFY(QLineF(*view_->pixelOf(cell), from + QPoint(80, -40) + offset).length() < 1.0);
    }

    void wheelZoomsTowardsTheCursor() {
        view_->setScan(scan_);
        const std::uint32_t cell = 60 * 300 + 90;
        const QPointF at = *view_->pixelOf(cell);
        const double before = view_->camera().distance();
        for (int i = 0; i < 5; ++i) wheel(*view_, at.toPoint(), 1);
        QVERIFY(view_->camera().distance() < 0.5 * before);
        QVERIFY(QLineF(*view_->pixelOf(cell), at).length() < 6.0);
        wheel(*view_, at.toPoint(), -5);
        QVERIFY(std::abs(view_->camera().distance() - before) < 1e-6 * before);
    }

    void wheelWithModifiers() {
        view_->setScan(scan_);
        const CameraPose start = view_->camera();
        QSignalSpy size(view_.get(), &CloudView::pointSizeChanged);
        wheel(*view_, {400, 300}, 1, Qt::AltModifier);
        QCOMPARE(view_->pointSize(), 3.0);
        QCOMPARE(size.count(), 1);
        const int whole = countPixels(view_->grabFrame(CloudView::Points::All), isGray121);
        for (int i = 0; i < 30; ++i) wheel(*view_, {400, 300}, 1, Qt::ControlModifier);
        const int nearCut = countPixels(view_->grabFrame(CloudView::Points::All), isGray121);
        QVERIFY(nearCut < whole);
        view_->resetView();
        for (int i = 0; i < 30; ++i) wheel(*view_, {400, 300}, -1, Qt::ControlModifier | Qt::ShiftModifier);
        const int farCut = countPixels(view_->grabFrame(CloudView::Points::All), isGray121);
        QVERIFY(farCut < whole);
        QVERIFY(view_->camera().position.isApprox(start.position));
    }

    void doubleClickAndMiddleClickSetTheCentre() {
        view_->setScan(scan_);
        const std::uint32_t cell = 60 * 300 + 90;
        const QPoint at = view_->pixelOf(cell)->toPoint();
        const CameraPose before = view_->camera();
        QTest::mouseDClick(view_->windowHandle(), Qt::LeftButton, Qt::NoModifier, at);
        const Eigen::Vector3d point = view_->geometryOfCloud()->point(cell).cast<double>();
        QVERIFY((view_->rotationCentre() - point).norm() < 0.2);
        QVERIFY(view_->camera().position.isApprox(before.position));
        view_->resetView();
        QTest::mouseClick(view_.get(), Qt::MiddleButton, Qt::NoModifier, at);
        QVERIFY((view_->rotationCentre() - point).norm() < 0.2);
    }

    void rightClickAsksForTheMenu() {
        view_->setScan(scan_);
        QSignalSpy menu(view_.get(), &CloudView::contextMenuRequested);
        drag(*view_, Qt::RightButton, Qt::NoModifier, {400, 300}, {400, 250});
        QCOMPARE(menu.count(), 0);
        QTest::mouseClick(view_.get(), Qt::RightButton, Qt::NoModifier, {450, 320});
        QCOMPARE(menu.count(), 1);
        QVERIFY(menu[0][1].toLongLong() >= 0);
    }

    void focalSphereWhileTurning() {
        view_->setScan(scan_);
        QTest::mousePress(view_.get(), Qt::LeftButton, Qt::NoModifier, {400, 300});
        for (int i = 1; i < 8; ++i) hoverWith({400 + 10 * i, 300}, Qt::LeftButton);
        const QImage image = view_->grabFrame(CloudView::Points::All);
        keep(image, "cloud_turning");
        const auto yellowish = [](QRgb p) { return qRed(p) > qBlue(p) + 25 && qGreen(p) > qBlue(p) + 25; };
        QVERIFY(countPixels(image, yellowish) > 100);
        QTest::mouseRelease(view_.get(), Qt::LeftButton, Qt::NoModifier, {470, 300});
        QCOMPARE(countPixels(view_->grabFrame(), yellowish), 0);
    }
};

int cloud_mouse_test(int argc, char** argv) { return runCloudTest<CloudMouseTest>(argc, argv); }
#include "cloud_mouse_test.moc"
