// The parts of the image view that need no display: pyramid and view port.
#include "tests/ui/ramp_image.h"
#include "tests/ui/run_test.h"
#include "ui/views/image/pyramid.h"
#include "ui/views/image/viewport.h"

#include <QLineF>

#include <random>

using namespace edgescan::ui;

class ImageRoomsTest : public QObject {
    Q_OBJECT
private slots:
    void halvingAverages() {
        QImage image(3, 3, QImage::Format_Grayscale8);
        const uchar values[3][3] = {{10, 20, 5}, {30, 40, 15}, {100, 50, 7}};
        for (int y = 0; y < 3; ++y) std::copy_n(values[y], 3, image.scanLine(y));
        const QImage half = halved(image, Shrink::Average);
        QCOMPARE(half.size(), QSize(2, 2));
        QCOMPARE(half.format(), QImage::Format_Grayscale8);
        QCOMPARE(int(half.scanLine(0)[0]), 25);
        QCOMPARE(int(half.scanLine(0)[1]), 10); // the odd column is copied
        QCOMPARE(int(half.scanLine(1)[0]), 75);
        QCOMPARE(int(half.scanLine(1)[1]), 7);
        const QImage brightest = halved(image, Shrink::KeepBrightest);
        QCOMPARE(int(brightest.scanLine(0)[0]), 40);
        QCOMPARE(int(brightest.scanLine(1)[0]), 100);
    }

    void halvingColourKeepsTheOpaquePixel() {
        QImage image(2, 2, QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        image.setPixelColor(1, 1, QColor(0, 255, 0));
        QCOMPARE(halved(image, Shrink::KeepBrightest).pixelColor(0, 0), QColor(0, 255, 0));
        const QColor mean = halved(image, Shrink::Average).pixelColor(0, 0);
        QVERIFY(std::abs(mean.alpha() - 64) <= 1);
        image.fill(QColor(40, 20, 60));
        QCOMPARE(halved(image, Shrink::Average).pixelColor(0, 0), QColor(40, 20, 60));
        QVERIFY(halved(QImage(), Shrink::Average).isNull());
    }

    void everyEdgePixelSurvivesEveryLevel() {
        std::mt19937 random(5);
        for (int round = 0; round < 30; ++round) {
            const int width = 1 + static_cast<int>(random() % 90), height = 1 + static_cast<int>(random() % 70);
            auto image = std::make_shared<QImage>(width, height, QImage::Format_Grayscale8);
            image->fill(0);
            const int x = static_cast<int>(random() % static_cast<unsigned>(width)),
                      y = static_cast<int>(random() % static_cast<unsigned>(height));
            image->scanLine(y)[x] = 255;
            Pyramid pyramid(image, Shrink::KeepBrightest);
            for (int level = 1; level < 9; ++level) {
                const QImage& small = pyramid.level(level);
                if (small.width() == 1 && small.height() == 1) break;
                QCOMPARE(qGray(small.pixel(x >> level, y >> level)), 255);
            }
        }
    }

    void levelsAreMadeOnceAndOnlyWhenAsked() {
        Pyramid pyramid(ramp(100, 60), Shrink::Average);
        QCOMPARE(pyramid.levelsMade(), 0);
        QCOMPARE(pyramid.level(0).constBits(), pyramid.image()->constBits());
        QCOMPARE(pyramid.level(2).size(), QSize(25, 15));
        QCOMPARE(pyramid.levelsMade(), 2);
        const uchar* bits = pyramid.level(2).constBits();
        QCOMPARE(pyramid.level(2).constBits(), bits);
        QCOMPARE(pyramid.level(30).size(), QSize(1, 1));
    }

    void levelSuitsTheScale() {
        QCOMPARE(pyramidLevel(3.0, Shrink::KeepBrightest), 0);
        QCOMPARE(pyramidLevel(1.0, Shrink::KeepBrightest), 0);
        QCOMPARE(pyramidLevel(0.9, Shrink::KeepBrightest), 1);
        QCOMPARE(pyramidLevel(0.5, Shrink::KeepBrightest), 1);
        QCOMPARE(pyramidLevel(0.49, Shrink::KeepBrightest), 2);
        QCOMPARE(pyramidLevel(0.9, Shrink::Average), 0);
        QCOMPARE(pyramidLevel(0.5, Shrink::Average), 1);
        QCOMPARE(pyramidLevel(0.3, Shrink::Average), 1);
        QCOMPARE(pyramidLevel(0.0, Shrink::Average), 0);
    }

    void viewPortFitsZoomsAndPans() {
        ViewPort port;
        QObject view;
        port.setViewSize(&view, {400, 300});
        port.setImageSize({800, 300});
        QCOMPARE(port.zoom(), 0.5);
        QCOMPARE(port.centre(), QPointF(400, 150));
        QCOMPARE(port.toPixel({0, 0}, QSizeF(400, 300)), QPointF(0, 75));
        const QPointF cell(100.5, 200.25);
        const QPointF before = port.toPixel(cell, QSizeF(400, 300));
        port.zoomAt(cell, 3.0);
        QVERIFY(QLineF(port.toPixel(cell, QSizeF(400, 300)), before).length() < 1e-9);
        QVERIFY(!port.fitted());
        QCOMPARE(port.toCell(port.toPixel(cell, QSizeF(400, 300)), QSizeF(400, 300)), cell);
        port.panPixels({20, 10});
        QVERIFY(QLineF(port.toPixel(cell, QSizeF(400, 300)), before + QPointF(20, 10)).length() < 1e-9);
        port.setViewSize(&view, {500, 300}); // zoomed: does not change
        QCOMPARE(port.zoom(), 1.5);
        port.fit();
        port.setViewSize(&view, {800, 600}); // fitted: follows the size
        QCOMPARE(port.zoom(), 1.0);
        port.panPixels({1e7, 1e7});
        QCOMPARE(port.centre(), QPointF(0, 0)); // cannot be lost
    }

    void trueAngleAspect() {
        ViewPort port;
        QObject view;
        port.setViewSize(&view, {400, 400});
        port.setImageSize({100, 100});
        QCOMPARE(port.cellSize(), QSizeF(4, 4));
        port.setTrueAngle(0.1667, 0.3334);
        QVERIFY(std::abs(port.aspect() - 0.5) < 1e-12);
        QCOMPARE(port.cellSize().height(), 4.0);
        port.setTrueAngle(0.5, 0.25);
        QCOMPARE(port.cellSize(), QSizeF(4, 2)); // still fits
        port.setAspect(0.0);                     // invalid values are ignored
        QCOMPARE(port.aspect(), 2.0);
        port.setSquarePixels();
        QCOMPARE(port.cellSize(), QSizeF(4, 4));
    }
};

int image_rooms_test(int argc, char** argv) { return runTest<ImageRoomsTest, QCoreApplication>(argc, argv); }
#include "image_rooms_test.moc"
