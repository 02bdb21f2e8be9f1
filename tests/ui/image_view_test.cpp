// The image view as a real widget with real mouse events.
#include "tests/ui/mouse_wheel.h"
#include "tests/ui/patience.h"
#include "tests/ui/pictures.h"
#include "tests/ui/ramp_image.h"
#include "tests/ui/run_test.h"
#include "ui/views/image/image_view.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include <functional>

using namespace edgescan::ui;

namespace {

/// Sparse white pixels and one thin line on black.
std::shared_ptr<const QImage> edgeMap(int beams, int lines) {
    auto image = std::make_shared<QImage>(beams, lines, QImage::Format_Grayscale8);
    image->fill(0);
    for (int x = 0; x < beams; ++x) image->scanLine((x * lines / beams) % lines)[x] = 255;
    image->scanLine(lines - 1)[beams - 1] = 255;
    return image;
}

void move(QWidget& view, QPoint at, Qt::MouseButtons buttons = Qt::NoButton, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, modifiers);
    QApplication::sendEvent(&view, &event);
}

void drag(QWidget& view, Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mousePress(&view, button, modifiers, from);
    for (int i = 1; i <= 5; ++i) move(view, from + (to - from) * i / 5, button, modifiers);
    QTest::mouseRelease(&view, button, modifiers, to);
}

// In device pixels: run the tests with QT_SCALE_FACTOR=2 too.
QImage grab(QWidget& view) {
    QImage image = view.grab().toImage();
    image.setDevicePixelRatio(1.0);
    return image;
}

} // namespace

class ImageViewTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        port_ = std::make_shared<ViewPort>();
        view_ = std::make_unique<ImageView>(port_);
        view_->resize(400, 300);
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_.get(), kPatienceMs));
    }
    void cleanup() { view_.reset(); }

    void emptyViewShowsItsNote() {
        view_->setNote("no scan open");
        const QImage image = grab(*view_);
        QCOMPARE(image.pixelColor(3, 3), QColor(48, 48, 48));
        QVERIFY(countPixels(image, [](QRgb p) { return qGray(p) > 150; }) > 10);
        move(*view_, {100, 100});
        QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::NoModifier, {100, 100});
        drag(*view_, Qt::LeftButton, {100, 100}, {150, 150}, Qt::ShiftModifier);
        wheel(*view_, {10, 10}, 3);
    }

    void rowZeroIsOnTopAndColumnZeroAtTheLeft() {
        auto image = std::make_shared<QImage>(4, 3, QImage::Format_RGB32);
        image->fill(Qt::black);
        image->setPixelColor(0, 0, Qt::red);
        image->setPixelColor(3, 2, Qt::blue);
        view_->setImage(image);
        const QImage shown = grab(*view_); // 100 x 100 pixels per cell, limited to 64
        QCOMPARE(port_->zoom(), 64.0);
        const auto at = [&](int line, int beam) {
            const QPointF p = port_->toPixel({beam + 0.5, line + 0.5}, view_->size()) * view_->devicePixelRatioF();
            return shown.pixelColor(p.toPoint());
        };
        QCOMPARE(at(0, 0), QColor(Qt::red));
        QCOMPARE(at(2, 3), QColor(Qt::blue));
        QCOMPARE(at(1, 1), QColor(Qt::black));
    }

    void pixelsAreSquaresWithoutSmoothing() {
        auto image = std::make_shared<QImage>(64, 48, QImage::Format_Grayscale8);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) image->scanLine(y)[x] = (x + y) % 2 != 0 ? 255 : 0;
        }
        view_->setImage(image);
        const auto isMixed = [](QRgb p) { return qGray(p) != 0 && qGray(p) != 255; };
        QVERIFY(view_->viewPort()->fitted());
        for (int i = 0; i < 6; ++i) wheel(*view_, {133, 71}, 1);
        const QImage whole = grab(*view_);
        const QImage shown = whole.copy(0, 0, whole.width(), whole.height() * 3 / 4);
        QCOMPARE(countPixels(shown, isMixed), 0);
        // A zoomed image says so, below.
        QVERIFY(countPixels(whole, isMixed) > 100);
        QVERIFY(view_->viewPort()->magnification() > 2.0);
        // Every screen pixel shows the cell that cellAt() returns for it.
        const double dpr = view_->devicePixelRatioF();
        int wrong = 0, looked = 0;
        for (int y = 0; y < shown.height(); y += 3) {
            for (int x = 0; x < shown.width(); x += 3) {
                const auto cell = view_->cellAt(QPointF(x + 0.5, y + 0.5) / dpr);
                looked += cell.has_value();
                if (cell) wrong += qGray(shown.pixel(x, y)) != qGray(image->pixel(*cell));
            }
        }
        QVERIFY2(wrong * 50 < looked, qPrintable(QString::number(wrong))); // rounding at the borders of cells
        keep(shown, "image_squares");
    }

    /// All eight ways to lie: where a corner is, that a pixel shows the cell that the mouse gets, and that a drag moves the picture with
    /// it.
    void turnedImages() {
        const auto image = ramp(32, 20);
        for (int n = 0; n < 8; ++n) {
            const ViewPort::Turn turn{(n & 1) != 0, (n & 2) != 0, (n & 4) != 0};
            port_->setTurn(turn);
            view_->setImage(image);
            port_->fit();
            const auto pixel = [&](double beam, double line) { return port_->toPixel({beam, line}, view_->size()); };
            const QPointF first = pixel(0, 0), alongLine = pixel(32, 0) - first;
            QCOMPARE(std::abs(alongLine.y()) > std::abs(alongLine.x()), turn.quarter);
            QCOMPARE((turn.quarter ? alongLine.y() : alongLine.x()) < 0, turn.quarter ? turn.half : turn.mirrored != turn.half);
            const QRectF place = QRectF(first, pixel(32, 20)).normalized();
            QVERIFY(QRectF(view_->rect()).contains(place));
            QVERIFY2(std::abs(place.width() - 400) < 0.1 || std::abs(place.height() - 300) < 0.1, "as large as the view");
            for (int i = 0; i < 3; ++i) wheel(*view_, {133, 71}, 1);
            const QPointF before = port_->toCell({200, 150}, view_->size());
            drag(*view_, Qt::LeftButton, {200, 150}, {230, 110});
            const QPointF moved = port_->toCell({230, 110}, view_->size());
            QVERIFY(std::hypot(moved.x() - before.x(), moved.y() - before.y()) < 0.05);
            const QImage shown = grab(*view_);
            const double dpr = view_->devicePixelRatioF();
            int wrong = 0, looked = 0;
            for (int y = 0; y < shown.height() * 3 / 4; y += 3) {
                for (int x = 0; x < shown.width(); x += 3) {
                    const auto cell = view_->cellAt(QPointF(x + 0.5, y + 0.5) / dpr);
                    looked += cell.has_value();
                    if (cell) wrong += qGray(shown.pixel(x, y)) != qGray(image->pixel(*cell));
                }
            }
            QVERIFY2(looked > 1000 && wrong * 50 < looked, qPrintable(QString("%1: %2 of %3").arg(n).arg(wrong).arg(looked)));
        }
    }

    void edgesKeepTheirLightWhenZoomedOut() {
        const auto edges = edgeMap(1141, 1000);
        view_->setImage(edges, Shrink::Lines);
        for (const double out : {1.0, 0.83, 0.6, 0.51}) {
            port_->fit();
            port_->zoomAt(port_->centre(), out);
            const QImage shown = grab(*view_);
            const double dpr = view_->devicePixelRatioF();
            // Each screen column inside the image contains a part of the line.
            const QPointF a = port_->toPixel({0, 0}, view_->size()), b = port_->toPixel({1141, 1000}, view_->size());
            int sum = 0, columns = 0;
            for (int x = static_cast<int>(std::ceil(a.x() * dpr)); x < static_cast<int>(b.x() * dpr) - 1; ++x) {
                int bright = 0;
                for (int y = 0; y < shown.height(); ++y) bright = std::max(bright, qGray(shown.pixel(x, y)));
                QVERIFY2(bright > 90, qPrintable(QString("column %1 at %2: %3").arg(x).arg(out).arg(bright)));
                sum += bright;
                ++columns;
            }
            QVERIFY2(sum / columns > 0.75 * 255, qPrintable(QString("mean level %1 at %2").arg(sum / columns).arg(out)));
        }
        keep(grab(*view_), "image_edges_small");
    }

    // Many lost lines in a picture that shows several lines per pixel: dashes, no even colour.
    void lostLinesAreDashesAtEveryZoom() {
        for (const int lines : {40, 300, 3000}) {
            auto image = std::make_shared<QImage>(400, lines, QImage::Format_RGB32);
            image->fill(qRgb(24, 26, 30));
            view_->setImage(image);
            view_->setLost({QRect(0, 0, 400, lines)});
            const QImage shown = grab(*view_);
            const double dpr = view_->devicePixelRatioF();
            const QRect middle(QPoint(int(190 * dpr), int(140 * dpr)), QSize(int(20 * dpr), int(20 * dpr)));
            int amber = 0, ground = 0;
            for (int y = middle.top(); y <= middle.bottom(); ++y) {
                for (int x = middle.left(); x <= middle.right(); ++x) {
                    const QRgb pixel = shown.pixel(x, y);
                    amber += qRed(pixel) > 150 && qBlue(pixel) < 120 ? 1 : 0;
                    ground += qRed(pixel) < 60 ? 1 : 0;
                }
            }
            const int all = middle.width() * middle.height();
            QVERIFY2(amber > all / 40 && ground > all / 2, qPrintable(QString("%1 lines: %2, %3").arg(lines).arg(amber).arg(ground)));
        }
    }

    void linesToComeAreHatchedAtEveryZoom() {
        for (const int lines : {40, 300, 3000}) {
            auto image = std::make_shared<QImage>(400, lines, QImage::Format_RGB32);
            image->fill(qRgb(30, 30, 30));
            view_->setImage(image);
            view_->setToCome(QRect(0, lines / 2, 400, lines - lines / 2));
            const QImage shown = grab(*view_);
            const QRectF measured(port_->toPixel({100, 0}, view_->size()), port_->toPixel({300, lines / 2.0}, view_->size()));
            const QRectF toCome(port_->toPixel({100, lines / 2.0}, view_->size()), port_->toPixel({300, 1.0 * lines}, view_->size()));
            const auto bright = [&](const QRectF& area) {
                const QRect pixels = QRectF(area.topLeft() * view_->devicePixelRatioF(), area.size() * view_->devicePixelRatioF())
                                         .toRect()
                                         .adjusted(2, 2, -2, -2);
                int count = 0;
                for (int y = pixels.top(); y <= pixels.bottom(); ++y) {
                    for (int x = pixels.left(); x <= pixels.right(); ++x) count += qGray(shown.pixel(x, y)) > 45 ? 1 : 0;
                }
                return 1.0 * count / (pixels.width() * pixels.height());
            };
            QCOMPARE(bright(measured), 0.0);
            const double share = bright(toCome);
            QVERIFY2(share > 0.05 && share < 0.5, qPrintable(QString("%1 lines: %2").arg(lines).arg(share)));
        }
        view_->setToCome(QRect());
    }

    void theSameImageAgainCostsNothing() {
        const auto image = ramp(200, 100);
        view_->setImage(image);
        wheel(*view_, {200, 150}, 4);
        const double zoom = port_->zoom();
        view_->setImage(image);
        view_->setImage(ramp(200, 100)); // a re-tune: same size, other picture
        QCOMPARE(port_->zoom(), zoom);
        view_->setImage(ramp(300, 100)); // another scan
        QVERIFY(port_->fitted());
    }

    void viewsShareZoomAndPan() {
        ImageView other(port_);
        other.resize(400, 300);
        other.show();
        QVERIFY(QTest::qWaitForWindowExposed(&other, kPatienceMs));
        const auto image = ramp(200, 100);
        view_->setImage(image);
        other.setImage(image);
        wheel(*view_, {50, 120}, 5);
        drag(*view_, Qt::LeftButton, {200, 150}, {230, 140});
        QCOMPARE(grab(other), grab(*view_));
        QCOMPARE(other.cellAt({77, 99}), view_->cellAt({77, 99}));
    }

    void wheelZoomsAtTheCursor() {
        view_->setImage(ramp(200, 100));
        const QPointF at(311, 97);
        const QPointF before = port_->toCell(at, view_->size());
        wheel(*view_, at.toPoint(), 5);
        QVERIFY(QLineF(port_->toCell(at, view_->size()), before).length() < 1e-9);
        QTest::mouseDClick(view_->windowHandle(), Qt::LeftButton, Qt::NoModifier, {10, 10});
        QVERIFY(port_->fitted());
    }

    void dragsPan() {
        view_->setImage(ramp(200, 100));
        wheel(*view_, {200, 150}, 6);
        QSignalSpy clicked(view_.get(), &ImageView::clicked);
        for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton}) {
            const QPointF before = port_->toCell(QPointF(100, 100), view_->size());
            drag(*view_, button, {100, 100}, {140, 90});
            QVERIFY(QLineF(port_->toCell(QPointF(140, 90), view_->size()), before).length() < 1e-9);
        }
        QCOMPARE(clicked.count(), 0);
    }

    void hoverAndClickTellTheCell() {
        view_->setImage(ramp(200, 100));
        QSignalSpy hovered(view_.get(), &ImageView::hovered), left(view_.get(), &ImageView::hoverLeft);
        QSignalSpy clicked(view_.get(), &ImageView::clicked);
        const QPoint at = port_->toPixel({120.5, 30.5}, view_->size()).toPoint();
        move(*view_, at);
        move(*view_, at); // the same cell: no second signal
        QCOMPARE(hovered.count(), 1);
        QCOMPARE(hovered[0], (QVariantList{30, 120}));
        move(*view_, {5, 5}); // outside the image
        QCOMPARE(left.count(), 1);
        QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::NoModifier, at);
        QCOMPARE(clicked.count(), 1);
        QCOMPARE(clicked[0], (QVariantList{30, 120}));
        QCOMPARE(view_->crosshair(), std::optional(QPoint(120, 30)));
    }

    void rightDragIsWindowAndLevel() {
        view_->setImage(ramp(200, 100));
        QSignalSpy dragged(view_.get(), &ImageView::windowLevelDragged), finished(view_.get(), &ImageView::windowLevelFinished);
        const QPointF centre = port_->centre();
        drag(*view_, Qt::RightButton, {100, 100}, {150, 75});
        QPoint sum;
        for (const QVariantList& one : dragged) sum += QPoint(one[0].toInt(), one[1].toInt());
        QCOMPARE(sum, QPoint(50, -25));
        QCOMPARE(finished.count(), 1);
        QCOMPARE(port_->centre(), centre);
    }

    void shiftDragSelectsABox() {
        view_->setImage(ramp(200, 100));
        QSignalSpy box(view_.get(), &ImageView::boxSelected);
        const auto pixel = [&](double beam, double line) { return port_->toPixel({beam, line}, view_->size()).toPoint(); };
        QTest::mousePress(view_.get(), Qt::LeftButton, Qt::ShiftModifier, pixel(150.5, 80.5));
        move(*view_, pixel(20.5, 10.5), Qt::LeftButton, Qt::ShiftModifier);
        const QImage rubber = grab(*view_);
        QTest::mouseRelease(view_.get(), Qt::LeftButton, Qt::ShiftModifier, pixel(20.5, 10.5));
        QCOMPARE(box.count(), 1);
        QCOMPARE(box[0][0].toRect(), QRect(QPoint(20, 10), QPoint(150, 80)));
        QVERIFY(rubber != grab(*view_));
        drag(*view_, Qt::LeftButton, pixel(190.5, 90.5), {2000, 2000}, Qt::ShiftModifier); // beyond the image
        QCOMPARE(box[1][0].toRect(), QRect(QPoint(190, 90), QPoint(199, 99)));
    }

    void marksAreSeenOnBlackAndOnWhite() {
        for (const QColor& ground : {QColor(Qt::black), QColor(Qt::white)}) {
            auto image = std::make_shared<QImage>(200, 150, QImage::Format_RGB32);
            image->fill(ground);
            view_->setImage(image);
            view_->setCrosshair(std::nullopt);
            view_->setMarkedCell(std::nullopt);
            const QImage before = grab(*view_);
            view_->setMarkedCell(QPoint(60, 70));
            const QImage ring = grab(*view_);
            QVERIFY(ring != before);
            const double dpr = view_->devicePixelRatioF();
            const QPoint at = (port_->toPixel({60.5, 70.5}, view_->size()) * dpr).toPoint();
            const int reach = static_cast<int>(10 * dpr);
            const QImage patch = ring.copy(QRect(at - QPoint(reach, reach), at + QPoint(reach, reach)));
            QVERIFY(countPixels(patch, [](QRgb p) { return qGray(p) > 220; }) > 15);
            QVERIFY(countPixels(patch, [](QRgb p) { return qGray(p) < 60; }) > 15);
            view_->setCrosshair(QPoint(150, 30));
            QVERIFY(grab(*view_) != ring);
        }
        view_->setNote("gray levels of a scan");
        const auto under = view_->cellAt({view_->width() - 50.0, 16}); // the note
        QVERIFY(under);
        view_->setMarkedCell(under);
        const QPointF middle = port_->toPixel(QPointF(*under) + QPointF(0.5, 0.5), view_->size());
        const QImage titled = grab(*view_);
        for (const QPointF& at : {middle, middle + QPointF(7.0, 0.0), middle - QPointF(7.0, 0.0)})
            QVERIFY2(qGray(titled.pixel((at * view_->devicePixelRatioF()).toPoint())) > 200, "the ring is under the note");
        view_->setNote("preview");
        view_->setBox(QRect(20, 100, 60, 30));
        keep(grab(*view_), "image_marks");
    }

    void overlayLiesOverTheImage() {
        auto gray = std::make_shared<QImage>(200, 150, QImage::Format_Grayscale8);
        gray->fill(100);
        auto edges = std::make_shared<QImage>(200, 150, QImage::Format_ARGB32_Premultiplied);
        edges->fill(Qt::transparent);
        for (int x = 20; x < 180; ++x) edges->setPixelColor(x, 75, QColor(0, 255, 0));
        view_->setImage(gray);
        view_->setOverlay(edges, 1.0);
        const auto green = [](QRgb p) { return qGreen(p) > 240 && qRed(p) < 20; };
        QVERIFY(countPixels(grab(*view_), green) > 300);
        view_->setOverlay(edges, 0.5);
        const QPoint at = (port_->toPixel({100.5, 75.5}, view_->size()) * view_->devicePixelRatioF()).toPoint();
        const QColor mixed = grab(*view_).pixelColor(at);
        QVERIFY(std::abs(mixed.red() - 50) < 4 && std::abs(mixed.green() - 178) < 4);
        view_->setOverlay(nullptr, 1.0);
        QCOMPARE(countPixels(grab(*view_), green), 0);
    }

private:
    std::shared_ptr<ViewPort> port_;
    std::unique_ptr<ImageView> view_;
};

int image_view_test(int argc, char** argv) { return runTest<ImageViewTest, QApplication>(argc, argv); }
#include "image_view_test.moc"
