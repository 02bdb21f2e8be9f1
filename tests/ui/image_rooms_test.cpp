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
        const QImage light = halved(image, Shrink::Lines);
        QCOMPARE(int(light.scanLine(0)[0]), 39); // the root of twice the mean square
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
        for (const Shrink shrink : {Shrink::Lines, Shrink::Average})
            QCOMPARE(halved(image, shrink), halved(image.convertToFormat(QImage::Format_ARGB32_Premultiplied), shrink));
    }

    void halvingColourKeepsItsLight() {
        QImage image(2, 2, QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        image.setPixelColor(1, 1, QColor(0, 255, 0));
        const QColor quarter = halved(image, Shrink::Lines).pixelColor(0, 0);
        QVERIFY(quarter.green() > 250 && quarter.red() == 0 && std::abs(quarter.alpha() - 180) <= 1); // half of the light
        const QColor mean = halved(image, Shrink::Average).pixelColor(0, 0);
        QVERIFY(std::abs(mean.alpha() - 64) <= 1);
        image.fill(QColor(40, 20, 60));
        QCOMPARE(halved(image, Shrink::Average).pixelColor(0, 0), QColor(40, 20, 60));
        QVERIFY(halved(QImage(), Shrink::Average).isNull());
    }

    // A line one cell wide is as bright in an image of a sixteenth of the size, in every direction; a single cell fades.
    void aLineKeepsItsLightAndASingleCellFades() {
        for (const QPoint& way : {QPoint(1, 0), QPoint(0, 1), QPoint(1, 1), QPoint(2, 1), QPoint(1, 3)}) {
            auto image = std::make_shared<QImage>(128, 128, QImage::Format_Grayscale8);
            image->fill(0);
            const double length = std::max(way.x(), way.y());
            const auto at = [&](int n) { return QPoint(5 + qRound(n * way.x() / length), 5 + qRound(n * way.y() / length)); };
            for (int n = 0; n < 90; ++n) image->scanLine(at(n).y())[at(n).x()] = 255;
            image->scanLine(121)[121] = 255;
            Pyramid pyramid(image, Shrink::Lines);
            for (int level = 1; level <= 4; ++level) {
                const QImage& small = pyramid.level(level);
                double light = 0.0;
                for (int n = 10; n < 80; ++n) light += qGray(small.pixel(at(n).x() >> level, at(n).y() >> level)) / 255.0 / 70.0;
                const QByteArray where = QString("%1, %2, level %3: %4").arg(way.x()).arg(way.y()).arg(level).arg(light).toUtf8();
                QVERIFY2(light > 0.8, where);
                QVERIFY2(qGray(small.pixel(121 >> level, 121 >> level)) <= 256.0 * std::pow(0.5, level / 2.0), where);
                QCOMPARE(qGray(small.pixel(100 >> level, 127 >> level)), 0);
            }
        }
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
