// For the tests of the cloud view: a visible view with the demo scan, real mouse events, counting of colours.
#pragma once

#include "cloud_demo_scan.h"
#include "tests/ui/mouse_wheel.h"
#include "tests/ui/patience.h"
#include "tests/ui/pictures.h"
#include "tests/ui/run_test.h"

#include "ui/views/cloud/cloud_view.h"
#include "ui/views/cloud/gl_check.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>
#include <functional>
#include <set>

namespace edgescan::ui {

inline bool isGreen(QRgb p) { return qGreen(p) > 200 && qRed(p) < 60 && qBlue(p) < 60; }
inline bool isGray121(QRgb p) { return qRed(p) == 121 && qGreen(p) == 121 && qBlue(p) == 121; }
inline bool isBright(QRgb p) { return qRed(p) == 230 && qGreen(p) == 230 && qBlue(p) == 230; }
inline bool isHalo(QRgb p) { return qRed(p) < 20 && qGreen(p) < 20 && qBlue(p) < 20; }
inline bool isYellow(QRgb p) { return qRed(p) > 235 && qGreen(p) > 220 && std::abs(qBlue(p) - 66) < 10; }

inline int colours(const QImage& image) {
    std::set<QRgb> seen;
    for (int y = 0; y < image.height(); y += 3) {
        for (int x = 0; x < image.width(); x += 3) seen.insert(image.pixel(x, y));
    }
    return static_cast<int>(seen.size());
}

inline void drag(QWidget& view, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint from, QPoint to) {
    QTest::mousePress(&view, button, modifiers, from);
    for (int i = 1; i <= 8; ++i) {
        const QPoint at = from + (to - from) * i / 8;
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, button, modifiers, to);
}

inline void hover(QWidget& view, QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
}

/// A visible view before each test; asserts that there is an OpenGL context.
class CloudFixture : public QObject {
    Q_OBJECT
protected:
    void hoverWith(QPoint at, Qt::MouseButtons buttons) {
        QMouseEvent move(QEvent::MouseMove, at, view_->mapToGlobal(at), Qt::NoButton, buttons, Qt::NoModifier);
        QApplication::sendEvent(view_.get(), &move);
    }

    [[nodiscard]] bool rests() const {
        return eventually([this] { return view_->atRest(); });
    }
    [[nodiscard]] bool nextFrame() const {
        QSignalSpy drawn(view_.get(), &CloudView::frameDrawn);
        return drawn.wait(kPatienceMs);
    }

    std::unique_ptr<CloudView> view_;
    std::shared_ptr<Scan> scan_;
    std::shared_ptr<const std::vector<std::uint32_t>> edges_;

private slots:
    void initTestCase() {
        const GlCheck gl = checkGl();
        QVERIFY2(gl.available, qPrintable(gl.reason));
        qInfo("OpenGL: %s", qPrintable(gl.renderer));
    }
    void init() {
        view_ = std::make_unique<CloudView>();
        view_->setShaded(false); // the tests count pixels of exact colours
        view_->resize(900, 640);
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_.get(), kPatienceMs));
        scan_ = demo::room(200, 300);
        edges_ = demo::edges(*scan_);
    }
    void cleanup() { view_.reset(); }
};

template <class Test>
int runCloudTest(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(CloudView::surfaceFormat());
    return runTest<Test, QApplication>(argc, argv);
}

} // namespace edgescan::ui
