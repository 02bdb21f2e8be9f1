// The parts of the image view that need no display: pyramid and view port.
#include "tests/ui/ramp_image.h"
#include "tests/ui/run_test.h"
#include "ui/base/selected_colour.h"
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
        const QImage light = halved(image, Shrink::Share);
        QCOMPARE(int(light.scanLine(0)[0]), 27); // the root of the mean square
        QCOMPARE(int(light.scanLine(1)[1]), 7);
    }

    // A picture with a table of colours gives the halves of the same picture in full colour.
    void halvingKeepsTheColoursOfATable() {
        QImage image(7, 5, QImage::Format_Indexed8);
        image.setColorTable({qRgba(0, 0, 0, 0), qRgb(0, 255, 0), qRgb(90, 170, 255), qRgb(45, 85, 127)});
        std::mt19937 random(7);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) image.setPixel(x, y, random() % 4);
        }
        for (const Shrink shrink : {Shrink::Share, Shrink::Average})
            QCOMPARE(halved(image, shrink), halved(image.convertToFormat(QImage::Format_ARGB32_Premultiplied), shrink));
    }

    void halvingColourKeepsItsLight() {
        QImage image(2, 2, QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        image.setPixelColor(1, 1, QColor(0, 255, 0));
        const QColor quarter = halved(image, Shrink::Share).pixelColor(0, 0);
        QVERIFY(quarter.green() > 250 && quarter.red() == 0 && std::abs(quarter.alpha() - 128) <= 1); // a quarter of the light
        const QColor mean = halved(image, Shrink::Average).pixelColor(0, 0);
        QVERIFY(std::abs(mean.alpha() - 64) <= 1);
        image.fill(QColor(40, 20, 60));
        QCOMPARE(halved(image, Shrink::Average).pixelColor(0, 0), QColor(40, 20, 60));
        QVERIFY(halved(QImage(), Shrink::Average).isNull());
    }

    // A pixel of a smaller image shows the share of edge cells in it: its light is that share.
    void aSmallerImageShowsTheShareOfEdgeCells() {
        std::mt19937 random(5);
        for (const unsigned among : {2U, 10U, 100U}) {
            auto image = std::make_shared<QImage>(256, 256, QImage::Format_Grayscale8);
            double edges = 0.0;
            for (int y = 0; y < 256; ++y) {
                for (int x = 0; x < 256; ++x) {
                    const bool edge = random() % among == 0;
                    image->scanLine(y)[x] = edge ? 255 : 0;
                    edges += edge ? 1.0 : 0.0;
                }
            }
            Pyramid pyramid(image, Shrink::Share);
            for (int level = 1; level <= 4; ++level) {
                const QImage& small = pyramid.level(level);
                double light = 0.0;
                for (int y = 0; y < small.height(); ++y) {
                    for (int x = 0; x < small.width(); ++x) light += std::pow(small.constScanLine(y)[x] / 255.0, 2);
                }
                const double share = light / (small.width() * small.height());
                QVERIFY2(std::abs(share - edges / (256.0 * 256.0)) < 0.002,
                         qPrintable(QString("1 of %1, level %2: %3").arg(among).arg(level).arg(share)));
            }
        }
    }

    // A line one cell wide is seen in an image of an eighth of the size; a single cell without return is not.
    void aLineStaysVisibleAndASingleCellFades() {
        auto image = std::make_shared<QImage>(64, 64, QImage::Format_Grayscale8);
        image->fill(0);
        for (int y = 0; y < 64; ++y) image->scanLine(y)[20] = 255;
        image->scanLine(40)[50] = 255;
        Pyramid pyramid(image, Shrink::Share);
        const QImage& small = pyramid.level(3);
        for (int y = 0; y < 8; ++y) QVERIFY(qGray(small.pixel(2, y)) > 80);
        QVERIFY(qGray(small.pixel(6, 5)) < 40);
        QCOMPARE(qGray(small.pixel(4, 4)), 0);
    }

    void theRimOfASelectionIsWhereItMeetsWhatIsNotSelected() {
        using Cells = std::vector<std::uint32_t>;
        // 5 beams; a block of 3 x 3 from beam 1 to 3, and the last beam of a line, which is not a neighbour of the next line's first.
        const Cells block{6, 7, 8, 11, 12, 13, 16, 17, 18};
        QCOMPARE(rimOf(block, 5), (Cells{6, 7, 8, 11, 13, 16, 17, 18}));
        QCOMPARE(rimOf({4, 5}, 5), (Cells{4, 5}));
        QCOMPARE(rimOf({}, 5), Cells{});
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
        QCOMPARE(pyramidLevel(3.0), 0);
        QCOMPARE(pyramidLevel(1.0), 0);
        QCOMPARE(pyramidLevel(0.9), 0);
        QCOMPARE(pyramidLevel(0.5), 1);
        QCOMPARE(pyramidLevel(0.3), 1);
        QCOMPARE(pyramidLevel(0.24), 2);
        QCOMPARE(pyramidLevel(0.0), 0);
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
        port.panPixels({20, 10}, QSizeF(400, 300));
        QVERIFY(QLineF(port.toPixel(cell, QSizeF(400, 300)), before + QPointF(20, 10)).length() < 1e-9);
        port.setViewSize(&view, {500, 300}); // zoomed: does not change
        QCOMPARE(port.zoom(), 1.5);
        port.fit();
        port.setViewSize(&view, {800, 600}); // fitted: follows the size
        QCOMPARE(port.zoom(), 1.0);
        port.panPixels({1e7, 1e7}, QSizeF(400, 300));
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
