// Likely borders of rocks in the real window: their look arrives after the edges, a switch leaves folds out, a slider says from where on.
#include "core/edges/rock_borders/rock_borders.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/status_line.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLayout>

#include <algorithm>
#include <tuple>

using namespace edgescan;
using namespace edgescan::ui;

class BordersTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;

    static bool known(WindowFixture& on) {
        return on.settled() && eventually([&] { return on.viewer.engine.bordered() != nullptr; });
    }
    static std::size_t edgesIn(WindowFixture& on) { return on.picture().detection->edges->size(); }
    static QComboBox* shownEdges(WindowFixture& on) { return on.viewer.panel.row("rock-borders")->choice(); }
    static QString row(WindowFixture& on, const char* name) {
        const auto* place = on.viewer.legend.findChild<QWidget*>(name);
        const QString text = static_cast<QLabel*>(place->layout()->itemAt(1)->widget())->text();
        return place->isVisible() ? QString(text).replace(QChar(0x00A0), ' ') : QString();
    }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = 120;
        settings.beams = 160;
        scan_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, scan_)));
    }

    void theirLookArrivesAfterTheEdges() {
        WindowFixture on;
        on.window.resize(1280, 900);
        std::shared_ptr<const QImage> plain;
        QObject::connect(&on.viewer.engine, &Engine::pictureReady, &on.window, [&] {
            QVERIFY(!on.viewer.engine.bordered());
            plain = on.viewer.views.edges().image();
        });
        QVERIFY(on.showWith(scan_) && known(on));
        QVERIFY2(plain && plain != on.viewer.views.edges().image(), "the edges did not come first");
        const edges::Detection& detection = *on.picture().detection;
        const QImage& map = *on.viewer.views.edges().image();
        std::array<std::size_t, kEdgeStrengths> counts{};
        for (std::size_t n = 0; n < detection.edges->size(); ++n) {
            const int percent = (*detection.borders)[n];
            const std::size_t strength = percent >= 70 ? 0 : percent >= 30 ? 1 : 2;
            ++counts[strength];
            const QPoint at = on.viewer.views.placeOf((*detection.edges)[n]);
            const int level = qRed(map.pixel(at));
            if ((*detection.classes)[(*detection.edges)[n]] == edges::DepthEdge::VoidRim) continue;
            QVERIFY(strength == 0 ? level == 255 : strength == 1 ? level > 150 && level < 200 : level > 50 && level < 150);
        }
        QVERIFY2(counts[0] > 0 && counts[2] > 0, "all edges are alike");
        // In the cloud folds have smaller points, and all edges are there.
        const Scene& scene = on.viewer.views.scene();
        QVERIFY(scene.byStrength && scene.cells.all == detection.edges);
        QCOMPARE(scene.cells.byClass[kWeakEdge]->size(), counts[1]);
        QCOMPARE(scene.cells.byClass[kThinEdge]->size(), counts[2]);
        QVERIFY(scene.cells.sizes[kStrongEdge] > scene.cells.sizes[kWeakEdge] &&
                scene.cells.sizes[kWeakEdge] > scene.cells.sizes[kThinEdge]);
        // The legend says what they mean.
        const auto number = [](std::size_t count) { return QLocale(QLocale::English).toString(static_cast<qulonglong>(count)); };
        QCOMPARE(row(on, "legend-strong"), "Rock border, 70 % and more: " + number(counts[0]));
        QCOMPARE(row(on, "legend-weak"), "Perhaps, 30 to 69 %: " + number(counts[1]));
        QCOMPARE(row(on, "legend-thin"), "Fold in a rock, below 30 %: " + number(counts[2]));
        // With a limit the legend has rows only for what is shown. Where all edges look alike, it has no rows of strength.
        edges::Settings limited = on.viewer.engine.settings();
        limited.rockBorders = true;
        for (const auto& [least, weak, thin] :
             {std::tuple{50, "Perhaps, 50 to 69 %: ", ""}, {80, "", ""}, {20, "Perhaps, 30 to 69 %: ", "Fold in a rock, 20 to 29 %: "}}) {
            limited.borderPercent = least;
            QVERIFY(on.use(limited) && known(on));
            const auto says = [&](const char* name, const QString& words) {
                return words.isEmpty() ? row(on, name).isEmpty() : row(on, name).startsWith(words);
            };
            QTRY_VERIFY2(says("legend-weak", weak), qPrintable(row(on, "legend-weak")));
            QTRY_VERIFY2(says("legend-thin", thin), qPrintable(row(on, "legend-thin")));
        }
        limited.rockBorders = false;
        QVERIFY(on.use(limited) && known(on));
        // By class all are as before.
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_C);
        QVERIFY(!on.viewer.views.scene().byStrength && on.viewer.views.scene().cells == on.picture().edgeCells);
        QVERIFY(row(on, "legend-thin").isEmpty());
        QTest::keyClick(&on.window, Qt::Key_C);
        QVERIFY(on.viewer.views.scene().byStrength);
        QCOMPARE(edgesIn(on), counts[0] + counts[1] + counts[2]);
    }

    void nothingFlickersWhileASliderMoves() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && known(on));
        const EdgeCells before = on.viewer.views.scene().cells;
        int pictures = 0;
        QObject::connect(&on.viewer.engine, &Engine::pictureReady, &on.window, [&] {
            const EdgeCells& now = on.picture().borderCells;
            QVERIFY(now.all != nullptr);
            std::vector<std::uint32_t> both, thin;
            std::ranges::set_intersection(*now.all, *before.byClass[kThinEdge], std::back_inserter(both));
            std::ranges::set_intersection(*now.byClass[kThinEdge], *before.byClass[kThinEdge], std::back_inserter(thin));
            QCOMPARE(thin, both);
            ++pictures;
        });
        on.slider("sensitivity")->setFocus();
        QTest::keyClick(on.slider("sensitivity"), Qt::Key_Right);
        QVERIFY(known(on));
        QVERIFY(pictures > 0);
    }

    void theSwitchAndTheSliderLeaveFoldsOutAndUndoBringsThemBack() {
        WindowFixture on;
        on.window.resize(1280, 900);
        QVERIFY(on.showWith(scan_) && on.activate() && known(on));
        const std::size_t all = edgesIn(on);
        const auto found = edges::detectEdges(on.picture().detection->scan, {});
        const auto likely = [&](int from) {
            return static_cast<std::size_t>(std::ranges::count_if(*found->borders, [from](int percent) { return percent >= from; }));
        };
        QVERIFY(shownEdges(on)->isVisible() && !on.slider("border-from")->isVisible());
        QCOMPARE(shownEdges(on)->currentText(), QString("All edges"));
        shownEdges(on)->setFocus();
        QTest::keyClick(shownEdges(on), Qt::Key_Down);
        QCOMPARE(shownEdges(on)->currentText(), QString("Rock borders"));
        QVERIFY(on.settled());
        QCOMPARE(edgesIn(on), likely(50));
        QVERIFY(edgesIn(on) < all && on.slider("border-from")->isVisible());
        on.slider("border-from")->setFocus();
        QTest::keyClick(on.slider("border-from"), Qt::Key_Right);
        QVERIFY(on.settled());
        QCOMPARE(on.viewer.engine.settings().borderPercent, 51.0);
        QCOMPARE(edgesIn(on), likely(51));
        QDoubleSpinBox* number = on.viewer.panel.row("border-from")->number();
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, "60");
        QTest::keyClick(number, Qt::Key_Return);
        QVERIFY(on.settled());
        constexpr int from = 60;
        QCOMPARE(edgesIn(on), likely(from));
        QVERIFY(on.viewer.statusLine.countsShown().contains(QLocale(QLocale::English).toString(static_cast<qulonglong>(likely(from))) +
                                                            " edge cells"));
        while (on.viewer.undo.canUndo()) on.viewer.undo.undo();
        QVERIFY(on.settled());
        QCOMPARE(edgesIn(on), all);
        QCOMPARE(shownEdges(on)->currentText(), QString("All edges"));
        // Methods on gray levels have neither.
        edges::Settings canny;
        canny.method = edges::Method::Canny;
        QVERIFY(on.use(canny));
        QVERIFY(!shownEdges(on)->isVisible() && !on.viewer.views.scene().byStrength && row(on, "legend-strong").isEmpty());
    }
};

int borders_test(int argc, char** argv) { return runWindowTest<BordersTest>(argc, argv); }

#include "borders_test.moc"
