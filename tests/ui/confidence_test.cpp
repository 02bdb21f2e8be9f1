// Edge confidence in the real window: a key shows it, the slider hides edges, a new picture is computed again, a comparison has priority.
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/confidence/confidence_legend.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"

#include <QAction>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>

using namespace edgescan;
using namespace edgescan::ui;

class ConfidenceTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;

    static bool known(WindowFixture& on) {
        return on.settled() && eventually([&] { return on.viewer.confidence.made() != nullptr; });
    }
    static bool showByKey(WindowFixture& on) {
        QTest::keyClick(&on.window, Qt::Key_W, Qt::ShiftModifier);
        return known(on);
    }
    static std::size_t numberIn(const QString& text) { return QString(text).remove(',').toULong(); }
    static double luminance(const QColor& colour) {
        const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
    }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = 120;
        settings.beams = 160;
        scan_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, scan_)));
    }

    void aKeyShowsItInAllViewsAndTheSliderLeavesEdgesOut() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(scan_) && on.activate());
        QVERIFY(!on.viewer.confidenceLegend.isVisible());
        QVERIFY(showByKey(on));
        const ConfidencePicture& made = *on.viewer.confidence.made();
        const edges::Detection& detection = *on.picture().detection;
        const auto truth = edges::edgeConfidence(detection);
        QVERIFY(truth && truth->percent == made.confidence->percent);
        const ConfidenceLegend& legend = on.viewer.confidenceLegend;
        QVERIFY(legend.isVisible() && !on.viewer.legend.isVisible());
        QVERIFY2(legend.words().contains(QString::number(truth->settings)), qPrintable(legend.words()));
        // The counts of the legend equal those of the cells, and each edge is in one band.
        std::array<std::size_t, kBands> counts{};
        for (const std::uint32_t k : *detection.edges) ++counts[edges::confidenceBand(truth->percent[k])];
        std::size_t sum = 0;
        for (std::size_t band = 0; band < kBands; ++band) {
            QCOMPARE(numberIn(legend.counted(band)), counts[band]);
            sum += counts[band];
        }
        QCOMPARE(sum, detection.edges->size());
        QVERIFY2(counts[0] > 0 && counts[0] < sum, "all edges are alike");
        // Each edge cell has the colour of its band in the edge map, and its size in the cloud.
        const QImage& map = *on.viewer.views.edges().image();
        for (const std::uint32_t k : *detection.edges) {
            const QPoint at = on.viewer.views.placeOf(k);
            const QColor colour = bandColours(false)[edges::confidenceBand(truth->percent[k])];
            const QRgb pixel = map.pixel(at);
            QVERIFY(pixel == colour.rgba() || pixel == colour.darker(250).rgba());
        }
        QVERIFY(on.viewer.views.cloud().edgeColours() == bandColours(false));
        QVERIFY(made.cells.sizes[0] > made.cells.sizes[2] && made.cells.sizes[2] > made.cells.sizes[4]);
        // With the keyboard: edges that fewer than 70 % of the settings find are hidden.
        QSlider* slider = legend.slider();
        slider->setFocus();
        for (int n = 0; n < 7; ++n) QTest::keyClick(slider, Qt::Key_PageUp);
        QCOMPARE(slider->value(), 70);
        QVERIFY(eventually([&] { return on.viewer.confidence.made()->leastPercent == 70; }));
        std::size_t kept = 0;
        for (const std::uint32_t k : *detection.edges) kept += truth->percent[k] >= 70 ? 1 : 0;
        QCOMPARE(on.viewer.confidence.made()->shown(), kept);
        QCOMPARE(on.viewer.views.scene().instead->cells.all->size(), kept);
        // The detection, and so every export, does not change.
        QCOMPARE(on.picture().detection->edges->size(), sum);
        // Off: the normal picture.
        QTest::keyClick(&on.window, Qt::Key_W, Qt::ShiftModifier);
        QVERIFY(!on.viewer.views.scene().instead && on.viewer.legend.isVisible() && !legend.isVisible());
        QVERIFY(on.viewer.views.edges().image() == on.drawn().edges);
    }

    void anotherPictureIsWorkedOutAnewAndAbHasPrecedence() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(scan_) && on.activate());
        QVERIFY(showByKey(on));
        const auto first = on.viewer.confidence.made();
        QTest::keyClick(&on.window, Qt::Key_A, Qt::ShiftModifier);
        edges::Settings other = on.viewer.engine.settings();
        other.method = edges::Method::Canny;
        QVERIFY(on.use(other));
        QVERIFY2(on.viewer.confidence.made() != first, "what was known of the picture before is still shown");
        QVERIFY(eventually([&] { return on.viewer.comparing.settled() && on.viewer.comparing.comparison(); }));
        QVERIFY(known(on));
        QVERIFY(on.viewer.confidence.made()->of == on.viewer.engine.picture());
        QVERIFY(on.viewer.changeLegend.isVisible() && !on.viewer.confidenceLegend.isVisible());
        QCOMPARE(on.viewer.views.scene().instead->map, on.viewer.comparing.comparison()->map);
        // The difference is switched off: confidence appears again; and back.
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ShiftModifier);
        QVERIFY(on.viewer.confidenceLegend.isVisible());
        QCOMPARE(on.viewer.views.scene().instead->map, on.viewer.confidence.made()->images[0]);
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ShiftModifier);
        QCOMPARE(on.viewer.views.scene().instead->map, on.viewer.comparing.comparison()->map);
    }

    void theCardOfAnEdgeTellsItWithoutBeingAsked() {
        const QString kept = QString::fromStdString((folder_ / "own" / "edgescan.ini").string());
        std::string text;
        {
            WindowFixture on(kept);
            on.window.resize(1280, 800);
            QVERIFY(on.showWith(scan_) && on.activate());
            const edges::Detection first = *on.picture().detection;
            const auto truth = edges::edgeConfidence(first);
            // An edge that a lower threshold finds too, and that some settings miss.
            const auto doubtful = std::ranges::find_if(*first.edges, [&](std::uint32_t k) { return truth->percent[k] < 90; });
            QVERIFY(doubtful != first.edges->end());
            const std::uint32_t cell = *doubtful;
            const QPoint at = on.viewer.views.placeOf(cell);
            ImageView& edges = on.viewer.views.edges();
            edges.viewPort()->zoomAt(QPointF(at) + QPointF(0.5, 0.5), 8.0);
            QTest::mouseClick(&edges, Qt::LeftButton, Qt::ShiftModifier, // this cell, and not the near side of it
                              edges.viewPort()->toPixel(QPointF(at) + QPointF(0.5, 0.5), edges.size()).toPoint());
            QVERIFY(on.viewer.targets.active() != nullptr);
            QCOMPARE(on.viewer.targets.active()->cell, cell);
            const auto card = [&] { return on.viewer.targetsPanel.card().text(); };
            QTRY_VERIFY(card().contains("Edge: "));
            QVERIFY2(card().contains(QString::fromUtf8("Confidence: …")), qPrintable(card()));
            const auto figure = [](const edges::EdgeConfidence& of, std::uint32_t k) {
                return QString("%1 % of %2 settings").arg(of.percent[k]).arg(of.settings);
            };
            QTRY_VERIFY2(card().contains("Confidence: " + figure(*truth, cell)), qPrintable(card()));
            // The views show the plain edges: the confidence picture is off.
            QVERIFY(!on.viewer.views.scene().instead && !on.viewer.confidence.made());
            // The key shows the same value, without a second computation.
            QVERIFY(showByKey(on));
            QCOMPARE(int(*on.viewer.confidence.at(cell)), int(truth->percent[cell]));
            QTest::keyClick(&on.window, Qt::Key_W, Qt::ShiftModifier);
            // A key of the slider changes the setting: the former value stays on the card, first next to the dots, then next to the new
            // value.
            QSlider* slider = on.slider("sensitivity");
            slider->setFocus();
            QTest::keyClick(slider, Qt::Key_Left);
            QVERIFY(on.settled());
            const edges::Detection second = *on.picture().detection;
            QVERIFY(*second.mask != *first.mask && (*second.mask)[cell] != 0);
            QTRY_VERIFY(card().contains(QString::fromUtf8("Confidence: …\nwas ") + figure(*truth, cell)));
            const auto then = edges::edgeConfidence(second);
            const QString now = "Confidence: " + figure(*then, cell);
            QTRY_VERIFY2(card().contains(now), qPrintable(card()));
            QVERIFY(then->percent[cell] == truth->percent[cell] || card().contains(now + "\nwas " + figure(*truth, cell)));
            // A cell that is not an edge has no such row.
            const auto plain = std::ranges::find(second.mask->cells, 0) - second.mask->cells.begin();
            on.viewer.views.pinByClick(inspect::exactly(static_cast<std::size_t>(plain)));
            QTRY_VERIFY(on.viewer.targets.active()->cell != cell && card().contains("Edge: no edge"));
            QVERIFY2(!card().contains("Confidence"), qPrintable(card()));
            QTRY_VERIFY(on.viewer.targets.settled());
            text = figure(*truth, cell).toStdString();
        }
        // The file of the targets stores the value from the picture on which the target was set.
        const std::filesystem::path targets = folder_ / "own" / "targets";
        std::string file;
        for (const auto& entry : std::filesystem::directory_iterator(targets)) {
            std::ifstream in(entry.path());
            file.append(std::istreambuf_iterator<char>(in), {});
        }
        QVERIFY2(file.find("\"" + text + "\"") != std::string::npos, file.c_str());
    }

    void theWorkIsGivenUpWhenTheWindowGoes() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        QTest::keyClick(&on.window, Qt::Key_W, Qt::ShiftModifier);
        QVERIFY(eventually([&] { return on.viewer.confidenceLegend.words().contains('%'); }));
    }

    void bandsStandOutFromTheCloud() {
        const double cloud = luminance(QColor(121, 121, 121));
        for (const bool colourBlind : {false, true}) {
            for (const QColor& colour : bandColours(colourBlind)) {
                const double contrast = (luminance(colour) + 0.05) / (cloud + 0.05);
                QVERIFY2(contrast >= 3.0, qPrintable(colour.name() + QString(" %1").arg(contrast)));
            }
        }
    }
};

int confidence_test(int argc, char** argv) { return runWindowTest<ConfidenceTest>(argc, argv); }
#include "confidence_test.moc"
