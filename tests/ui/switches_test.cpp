// Switches, lists and colours of the real window: effects of the wheel, content of the legend, distinct colours.
#include "app/lab/sim/simulate.h"
#include "core/edges/settings/presets.h"
#include "core/rocks/attributes/faces.h"
#include "tests/support/scans.h"
#include "tests/ui/sized_window.h"
#include "ui/base/count_text.h"
#include "ui/base/selected_colour.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/window/theme.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSpinBox>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

// Like the window system: Qt may set the focus before the widget gets the wheel event.
void wheelOver(QWidget& widget, int notches) {
    const QPointF at(widget.width() / 2.0, widget.height() / 2.0);
    QWheelEvent event(at, widget.mapToGlobal(at.toPoint()), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&widget, &event);
}

double contrast(QColor a, QColor b) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const auto luminance = [&](const QColor& c) {
        return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    };
    const double x = luminance(a) + 0.05;
    const double y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

// Machado, Oliveira and Fernandes 2009, severity 1: remaining linear red, green and blue.
struct Sight {
    const char* name;
    std::array<double, 9> matrix;
};
constexpr std::array<Sight, 4> kSights{
    {{"usual", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
     {"without red", {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}},
     {"without green", {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}},
     {"without blue", {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}}}};
using Triple = std::array<double, 3>;

Triple times(const std::array<double, 9>& m, const Triple& v) {
    return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2], m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}

// CIE L*a*b* of the colour seen by such an eye.
Triple asSeen(const QColor& colour, const Sight& sight) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    Triple seen = times(sight.matrix, {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())});
    for (double& c : seen) c = std::clamp(c, 0.0, 1.0);
    const Triple xyz = times({0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505}, seen);
    const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = root(xyz[0] / 0.9505), y = root(xyz[1]), z = root(xyz[2] / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const Triple& a, const Triple& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

} // namespace

class SwitchesTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bare_;

private slots:
    void initTestCase() {
        useTheme(*qApp);
        bare_ = (folder_ / "bare.json").string();
        QVERIFY(bool(files::saveScan(boxesToShow(), bare_)));
    }

    void theWheelTurnsNothingThatHasNoFocus() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        QVERIFY(on.use(edges::cannySettings()));
        QVERIFY(on.activate());
        MainWindow& window = on.window;
        window.viewer().live.panel().show();
        window.viewer().views.cloud().setFocus();
        int tried = 0;
        for (QWidget* widget : window.findChildren<QWidget*>()) {
            if (!widget->isVisible() || !widget->isEnabled()) continue;
            QVariant before;
            if (auto* list = qobject_cast<QComboBox*>(widget)) before = list->currentIndex();
            if (auto* box = qobject_cast<QAbstractSpinBox*>(widget)) before = box->text();
            if (auto* slider = qobject_cast<QSlider*>(widget)) before = slider->value();
            if (!before.isValid()) continue;
            ++tried;
            wheelOver(*widget, 1);
            wheelOver(*widget, -2);
            QVariant after;
            if (auto* list = qobject_cast<QComboBox*>(widget)) after = list->currentIndex();
            if (auto* box = qobject_cast<QAbstractSpinBox*>(widget)) after = box->text();
            if (auto* slider = qobject_cast<QSlider*>(widget)) after = slider->value();
            QVERIFY2(before == after, qPrintable(widget->objectName()));
            QVERIFY2(!widget->hasFocus(), qPrintable(widget->objectName()));
        }
        QVERIFY2(tried > 8, qPrintable(QString::number(tried)));
        QVERIFY(window.viewer().engine.settings() == edges::cannySettings());
        // With the focus it does.
        QDoubleSpinBox* number = window.viewer().panel.row("lower")->number();
        number->setFocus();
        QTRY_VERIFY(number->hasFocus());
        wheelOver(*number, 1);
        QVERIFY(window.viewer().engine.settings().lower > edges::cannySettings().lower);
    }

    void theLegendTellsAndSwitches() {
        WindowFixture on;
        QVERIFY(on.showWith(bare_));
        EdgeLegend& legend = on.viewer.legend;
        QVERIFY(legend.isVisible());
        const auto press = [&](QCheckBox* box) { QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {8, box->height() / 2}); };
        press(legend.classSwitch(1));
        QVERIFY(on.settled());
        QCOMPARE(on.viewer.engine.settings().classes, edges::Settings{}.classes & ~edges::kClassConvex);
        QVERIFY(!legend.classSwitch(1)->isChecked());
        const auto& taken = *legend.findChild<QLabel*>("legend-taken");
        // What is violet in the images, and the red line in the cloud.
        const auto none = countCells(*on.picture().detection->scan)[static_cast<std::size_t>(CellState::NoReturn)];
        QVERIFY(none > 0);
        const auto shows = [&](const char* name, const QString& words) {
            const auto* row = legend.findChild<QWidget*>(name);
            const auto labels = row->findChildren<QLabel*>();
            return row->isVisible() && std::ranges::any_of(labels, [&](QLabel* each) { return each->text() == words; });
        };
        QTRY_VERIFY(shows("legend-missing", "No return: " + countText(none)) && shows("legend-ray", "Laser ray to the marked cell"));
        QVERIFY(!legend.findChild<QWidget*>("legend-status")->isVisible());
        QVERIFY2(taken.isVisible() && taken.text().contains("other classes take some of its cells"), qPrintable(taken.text()));
        QVERIFY2(legend.classSwitch(1)->toolTip().contains("the other numbers change too"), "a cell has one class");
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(on.settled());
        QVERIFY(legend.classSwitch(1)->isChecked() && taken.isHidden());
        press(legend.classSwitch(static_cast<int>(kRimClass))); // its cells are free: the data border, which may have them, is off
        QVERIFY(on.settled());
        QVERIFY(!legend.classSwitch(static_cast<int>(kRimClass))->isChecked() && taken.isHidden());
        press(legend.classSwitch(static_cast<int>(kRimClass)));
        QVERIFY(on.settled());
        press(legend.byClass());
        QVERIFY(on.viewer.views.cloud().edgesByClass());
        QTest::keyClick(&on.window, Qt::Key_C);
        QVERIFY(!legend.byClass()->isChecked() && !on.viewer.views.cloud().edgesByClass());
        press(legend.edges());
        QVERIFY(!on.viewer.views.cloud().edgesVisible());
        QTest::keyClick(&on.window, Qt::Key_E);
        QVERIFY(legend.edges()->isChecked() && on.viewer.views.cloud().edgesVisible());
        QVERIFY(on.use(edges::cannySettings())); // has no edge classes
        QVERIFY(legend.edges()->isVisible() && !legend.classSwitch(0)->isVisible());
    }

    void theLegendNamesCellsWithAStatusCode() {
        sim::SimulationSettings settings;
        settings.lines = 60;
        settings.beams = 90;
        settings.statusCodes = 0.02;
        const Scan scan = sim::simulate(settings)->scan;
        const std::size_t codes = countCells(scan)[static_cast<std::size_t>(CellState::DeviceStatus)];
        QVERIFY(codes > 0);
        const std::string path = (folder_ / "status.json").string();
        QVERIFY(bool(files::saveScan(scan, path)));
        WindowFixture on;
        QVERIFY(on.showWith(path));
        const auto* row = on.viewer.legend.findChild<QWidget*>("legend-status");
        QTRY_VERIFY(row->isVisible());
        QCOMPARE(row->findChildren<QLabel*>().last()->text(), "Status code: " + countText(codes));
    }

    void everyEdgeColourIsSeenOnTheCloud() {
        for (const EdgeColours& colours : {kUsualColours, kColourBlindColours}) {
            for (const QColor& colour : colours) QVERIFY2(contrast(colour, QColor(121, 121, 121)) >= 3.0, qPrintable(colour.name()));
        }
    }

    // The colour of the selection differs from every rock colour for every kind of colour vision, and edges are visible on it as on the
    // cloud.
    void whatIsSelectedIsNoRockAndHidesNoEdge() {
        const QColor selected(kSelectedColour);
        for (const EdgeColours& colours : {kUsualColours, kColourBlindColours}) {
            for (const QColor& colour : colours) QVERIFY2(contrast(colour, selected) >= 3.0, qPrintable(colour.name()));
        }
        QVERIFY(contrast(selected, QColor(48, 48, 48)) >= 3.0); // the background of the views
        for (const Sight& sight : kSights) {
            for (const Rgb& rock : rocks::kRockFaceColours) {
                const double apart = distance(asSeen(selected, sight), asSeen(QColor(rock.red, rock.green, rock.blue), sight));
                QVERIFY2(apart >= 20.0, qPrintable(QString("%1: %2").arg(sight.name).arg(apart)));
            }
        }
    }

    // Disabled text is thinner than enabled text, not bolder: it has no shadow.
    void whatCannotBeUsedLooksLess() {
        QMenu menu;
        menu.addAction("Reload the file")->setEnabled(true);
        menu.addAction("Reload the file")->setEnabled(false);
        menu.popup({50, 50});
        QVERIFY(QTest::qWaitForWindowExposed(&menu, kPatienceMs));
        const auto ink = [&](int n) {
            const QImage seen = menu.grab(menu.actionGeometry(menu.actions().at(n))).toImage();
            const QRgb ground = seen.pixel(2, seen.height() / 2);
            qint64 sum = 0;
            int pixels = 0;
            for (int y = 2; y < seen.height() - 2; ++y) {
                for (int x = 2; x < seen.width() - 2; ++x) {
                    const int off = std::abs(qGray(seen.pixel(x, y)) - qGray(ground));
                    sum += off;
                    pixels += off > 12 ? 1 : 0;
                }
            }
            return std::pair{sum, pixels};
        };
        menu.setActiveAction(nullptr);
        const auto usable = ink(0), greyed = ink(1);
        menu.close();
        QVERIFY2(4 * greyed.first < 3 * usable.first && 20 * greyed.second <= 21 * usable.second,
                 qPrintable(QString("%1 %2 against %3 %4").arg(greyed.first).arg(greyed.second).arg(usable.first).arg(usable.second)));
    }
};

int switches_test(int argc, char** argv) { return runWindowTest<SwitchesTest>(argc, argv); }

#include "switches_test.moc"
