// The panel shows the noise with which the edges were found, as in the record, and offers others.
#include "core/edges/settings/settings.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"

#include <QComboBox>
#include <QLabel>

using namespace edgescan;
using namespace edgescan::ui;

class NoisePanelTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;

private slots:
    void theNoiseInUseIsToldAndAnotherKindCanBeChosen() {
        sim::SimulationSettings simulated;
        simulated.lines = 200;
        simulated.beams = 220;
        const std::string path = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(simulated)->scan, path)));
        WindowFixture on;
        on.window.resize(1500, 950);
        QVERIFY(on.showWith(path));
        const auto* label = on.viewer.panel.findChild<QLabel*>("noise-found");
        QVERIFY(label != nullptr && !label->isHidden());
        const auto mm = [](const RangeNoise& noise, double at) {
            return QString("%1 mm at %2 m").arg(noise.at(at), 0, 'f', 1).arg(at, 0, 'f', 1);
        };
        const auto laser = on.picture().detection->responses;
        QVERIFY(!laser->neighboursAlike);
        const double usual = laser->scales.rangeM;
        QVERIFY2(label->text().startsWith("Noise in use: each cell errs for itself"), qPrintable(label->text()));
        for (const double at : {0.5 * usual, usual, 2 * usual})
            QVERIFY2(label->text().contains(mm(laser->noise, at)), qPrintable(label->text()));
        QVERIFY(!label->text().contains("Folds"));

        edges::Settings camera = on.viewer.engine.settings();
        camera.noiseKind = edges::NoiseKind::Camera;
        QVERIFY(on.use(camera));
        QTRY_VERIFY(label->text().contains("neighbours err alike"));
        QVERIFY2(label->text().contains("Folds have to exceed " + mm(on.picture().detection->responses->foldNoise, usual)),
                 qPrintable(label->text()));

        edges::Settings gray = camera;
        gray.method = edges::Method::Canny;
        QVERIFY(on.use(gray));
        QTRY_VERIFY(label->isHidden());
    }
};

int noise_panel_test(int argc, char** argv) { return runWindowTest<NoisePanelTest>(argc, argv); }
#include "noise_panel_test.moc"
