// Filled gaps in the real window: counted, striped, named in the status line, and removed again.
#include "core/exports/provenance.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/dialogs/export_dialog.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/panels/tuning/status_line.h"

#include <QCheckBox>
#include <QLabel>

using namespace edgescan;
using namespace edgescan::ui;

class GapsWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;

private slots:
    void theSliderFillsGapsThatSayTheyAreNotMeasured() {
        const std::string path = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(120, 160, 3, 0.02), path)));
        WindowFixture on;
        MainWindow& window = on.window;
        window.resize(1500, 950);
        QVERIFY(on.showWith(path));
        const Grid<std::uint8_t> before = *on.picture().detection->mask;
        QVERIFY(window.viewer().legend.filled()->isHidden());
        QVERIFY(!window.viewer().statusLine.countsShown().contains("filled"));

        QTest::keyClick(on.slider("fill"), Qt::Key_End);
        QVERIFY(on.settled());
        QTRY_VERIFY(on.picture().detection->filled != nullptr);
        const GapFilling& filling = *on.picture().detection->filled;
        QVERIFY(filling.cells.size() > 50);
        QCOMPARE(*on.picture().detection->mask, before);
        QVERIFY(!window.viewer().legend.filled()->isHidden());
        QVERIFY(window.viewer().legend.filled()->text().contains(QString::number(filling.cells.size())));
        QVERIFY(window.viewer().statusLine.countsShown().contains(QString(" %1 filled").arg(filling.cells.size())));
        for (const auto& image : {on.picture().gray, on.picture().edges}) {
            const FilledCell& cell = filling.cells.front();
            const QRgb seen = image->pixel(static_cast<int>(cell.cell % 160), static_cast<int>(cell.cell / 160));
            QVERIFY(qGreen(seen) > qRed(seen) && qGreen(seen) > qBlue(seen));
        }
        const edges::Probe probe = edges::probeCell(*on.picture().detection, filling.cells.front().cell);
        QVERIFY(probeWords(probe).verdict.startsWith("filled, not measured: "));
        // The dialog before an export shows the number of points that the export writes.
        for (const exports::ExportContent content : {exports::ExportContent::FullCloud, exports::ExportContent::EdgeCloud}) {
            ExportDialog dialog(on.picture().detection, content);
            const std::size_t measured = dialog.count();
            dialog.findChild<QCheckBox*>("with-filled")->setChecked(true);
            const auto written =
                exports::exportWithProvenance(content, *on.picture().detection, (folder_ / "filled.ply").string(), dialog.options());
            QVERIFY2(bool(written), written ? "" : written.error().sentence().c_str());
            QCOMPARE(dialog.count(), written->count);
            if (content == exports::ExportContent::FullCloud) QCOMPARE(dialog.count(), measured + filling.cells.size());
            QVERIFY(dialog.findChild<QLabel*>("count")->text().remove(',').startsWith(QString::number(written->count) + " "));
        }

        QTest::keyClick(on.slider("fill"), Qt::Key_Home);
        QVERIFY(on.settled());
        QTRY_VERIFY(on.picture().detection->filled == nullptr);
        QVERIFY(window.viewer().legend.filled()->isHidden());
    }
};

int gaps_window_test(int argc, char** argv) { return runWindowTest<GapsWindowTest>(argc, argv); }
#include "gaps_window_test.moc"
