// Several scans of one place in one cloud, in the real window: placed, shown, made active, stored in the session, undone.
#include "tests/support/folders.h"
#include "tests/support/scans.h"
#include "tests/support/stations.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/panels/layers/layers_panel.h"
#include "ui/panels/rocks/rock_colours.h"

#include <QDockWidget>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;

class ScanLayersTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string first_, second_, elsewhere_;
    RigidTransform place_{rotationRpyDeg({1, -1, 2}), Eigen::Vector3d(0.10, -0.05, 0.03)};

    static bool rests(WindowFixture& on) {
        return on.settled() && eventually([&] {
                   for (int n = 0; n < list(on)->count(); ++n) {
                       if (list(on)->item(n)->text().contains("being read")) return false;
                   }
                   return on.viewer.layers.settled() && on.window.sessions().settled();
               });
    }
    static QListWidget* list(WindowFixture& on) { return on.viewer.layersPanel.list(); }
    static QString words(WindowFixture& on, int layer) { return list(on)->item(layer)->text(); }
    static void press(WindowFixture& on, const char* button) {
        QTest::mouseClick(on.window.findChild<QPushButton*>(button), Qt::LeftButton);
    }
    /// Pixels of the cloud that have the colour of this layer.
    static int drawn(WindowFixture& on, std::size_t layer) {
        on.viewer.cloud.setShaded(false);
        const QRgb colour = rockColour(layer).rgb();
        return countPixels(on.viewer.cloud.grabFrame(CloudView::Points::All), [colour](QRgb pixel) { return pixel == colour; });
    }
    [[nodiscard]] bool showBoth(WindowFixture& on) const {
        on.window.resize(1280, 1000);
        if (!on.showWith(first_) || !on.activate()) return false;
        on.viewer.layers.add({QString::fromStdString(second_)});
        return rests(on);
    }

private slots:
    void initTestCase() {
        const auto save = [&](const Scan& scan, const char* name) {
            const std::string path = (folder_ / name).string();
            if (!files::saveScan(scan, path)) qFatal("%s cannot be written", path.c_str());
            return path;
        };
        first_ = save(*test::scanFrom({}, 4, 0, 160, 200), "first.json");
        second_ = save(*test::scanFrom(place_, 4, 1, 160, 200), "second.json");
        elsewhere_ = save(test::boxesScan(60, 80, 3, 0.02), "elsewhere.json");
    }

    void aSecondScanIsRegisteredDrawnHiddenAndUndone() {
        WindowFixture on;
        QVERIFY(showBoth(on));
        QCOMPARE(list(on)->count(), 2);
        QVERIFY2(words(on, 0).endsWith("active"), qPrintable(words(on, 0)));
        QVERIFY2(words(on, 1).contains("registered, residual"), qPrintable(words(on, 1)));
        QVERIFY(on.window.findChild<QDockWidget*>("dock-layers")->isVisible());
        QCOMPARE(on.viewer.cloud.layers().size(), 1U);
        const RigidTransform& found = on.viewer.cloud.layers().front().toShown;
        QVERIFY2((found.translationM - place_.translationM).norm() < 0.03, "its place");
        QVERIFY2((found.rotation - place_.rotation).norm() < 0.01, "its turn");
        QVERIFY(drawn(on, 1) > 1000);
        // The box of its row hides it; undo shows it again, and once more takes it out of the list.
        const QRect row = list(on)->visualItemRect(list(on)->item(1));
        QTest::mouseClick(list(on)->viewport(), Qt::LeftButton, Qt::NoModifier, QPoint(row.left() + 10, row.center().y()));
        QVERIFY(on.viewer.cloud.layers().empty());
        QCOMPARE(drawn(on, 1), 0);
        on.viewer.undo.undo();
        QCOMPARE(on.viewer.cloud.layers().size(), 1U);
        on.viewer.undo.undo();
        QCOMPARE(list(on)->count(), 0);
        QVERIFY(on.viewer.cloud.layers().empty());
        QVERIFY(!on.window.findChild<QDockWidget*>("dock-layers")->isVisible());
        on.viewer.undo.redo();
        QVERIFY(rests(on));
        QCOMPARE(on.viewer.cloud.layers().size(), 1U);
        list(on)->setCurrentRow(1);
        press(on, "layer-remove");
        QCOMPARE(list(on)->count(), 0);
    }

    void aLayerThatIsMadeActiveHasItsOwnImageAndEdges() {
        WindowFixture on;
        QVERIFY(showBoth(on));
        const std::string sha256 = on.picture().detection->scan->sha256;
        const RigidTransform there = on.viewer.cloud.layers().front().toShown;
        list(on)->setCurrentRow(1);
        press(on, "layer-activate");
        QVERIFY(eventually([&] { return on.picture().detection->scan->sha256 != sha256; }));
        QVERIFY(rests(on));
        QVERIFY(on.viewer.views.edges().image() == on.drawn().edges);
        QVERIFY2(words(on, 1).endsWith("active"), qPrintable(words(on, 1)));
        QCOMPARE(on.viewer.cloud.layers().size(), 1U);
        const RigidTransform both = there * on.viewer.cloud.layers().front().toShown;
        QVERIFY((both.rotation - Eigen::Matrix3d::Identity()).norm() < 1e-9 && both.translationM.norm() < 1e-9);
        QVERIFY(drawn(on, 0) > 1000);
        // Another place has its own layers.
        QVERIFY(on.open(elsewhere_));
        QCOMPARE(list(on)->count(), 0);
        QVERIFY(on.viewer.cloud.layers().empty());
    }

    void aScanOfAnotherPlaceIsNotPlacedAndTheReasonIsShown() {
        WindowFixture on;
        QVERIFY(showBoth(on));
        on.viewer.layers.add({QString::fromStdString(elsewhere_), QString::fromStdString(second_)});
        QVERIFY(rests(on));
        QVERIFY2(words(on, 2).contains("not placed"), qPrintable(words(on, 2)));
        QVERIFY(list(on)->item(2)->toolTip().contains("elsewhere"));
        QVERIFY2(words(on, 3).contains("not read"), qPrintable(words(on, 3)));
        QVERIFY2(list(on)->item(3)->toolTip().contains("a layer already"), qPrintable(list(on)->item(3)->toolTip()));
        QCOMPARE(on.viewer.cloud.layers().size(), 1U);
        list(on)->setCurrentRow(2);
        press(on, "layer-targets");
        QVERIFY2(on.viewer.notice.text().contains("targets 1, 2 and 3"), qPrintable(on.viewer.notice.text()));
    }

    void theSessionHasItsLayersAndReportsMissingFiles() {
        const std::string copy = (folder_ / "copy.json").string();
        std::filesystem::copy_file(second_, copy, std::filesystem::copy_options::overwrite_existing);
        const QString session = QString::fromStdString((folder_ / "both.edgescan-session.json").string());
        RigidTransform there;
        {
            WindowFixture on;
            on.window.resize(1280, 1000);
            QVERIFY(on.showWith(first_));
            on.viewer.layers.add({QString::fromStdString(copy)});
            QVERIFY(rests(on));
            there = on.viewer.cloud.layers().front().toShown;
            on.window.sessions().saveAs(session);
            QVERIFY(rests(on));
        }
        {
            WindowFixture on;
            QVERIFY(on.show());
            on.window.sessions().openSession(session);
            QVERIFY(eventually([&] { return on.viewer.cloud.layers().size() == 1; }));
            const RigidTransform& now = on.viewer.cloud.layers().front().toShown;
            QVERIFY((now.rotation - there.rotation).norm() < 1e-12 && (now.translationM - there.translationM).norm() < 1e-12);
            QVERIFY(words(on, 1).contains("registered, residual"));
        }
        std::filesystem::rename(copy, copy + ".moved.json");
        WindowFixture on;
        QVERIFY(on.show());
        on.window.sessions().openSession(session);
        QVERIFY(eventually([&] { return list(on)->count() == 2 && words(on, 1).contains("not read"); }));
        QVERIFY2(list(on)->item(1)->toolTip().contains("copy.json"), qPrintable(list(on)->item(1)->toolTip()));
        on.viewer.layers.locate(1, QString::fromStdString(copy + ".moved.json"));
        QVERIFY(eventually([&] { return on.viewer.cloud.layers().size() == 1; }));
    }

    void whatALayerCoversIsNotMeasured() {
        WindowFixture on;
        QVERIFY(showBoth(on));
        CloudView& cloud = on.viewer.cloud;
        std::vector<QPoint> places;
        for (int y = 40; y < cloud.height() - 40; y += 20) {
            for (int x = 40; x < cloud.width() - 40; x += 20) {
                if (cloud.cellAt(QPointF(x, y)) && cloud.childAt(x, y) == nullptr) places.emplace_back(x, y);
            }
        }
        CloudLayer layer = cloud.layers().front();
        layer.toShown.translationM -= cloud.camera().forward(); // 1 m nearer to the eye
        QSignalSpy clicked(&cloud, &CloudView::clicked), covered(&cloud, &CloudView::layerClicked);
        cloud.setLayers({layer});
        const auto place = std::ranges::find_if(places, [&](const QPoint& at) { return !cloud.cellAt(at); });
        QVERIFY(place != places.end());
        QTest::mouseClick(&cloud, Qt::LeftButton, Qt::NoModifier, *place);
        QCOMPARE(clicked.count(), 0);
        QCOMPARE(covered.count(), 1);
        QVERIFY2(on.viewer.notice.text().contains("make it active"), qPrintable(on.viewer.notice.text()));
    }

    void largeCoordinatesStayExact() {
        auto cloud = std::make_shared<CloudGeometry>();
        cloud->originM = {620000, 6200000, 250};
        CloudLayer layer{cloud, {rotationRpyDeg({0, 0, 30}), Eigen::Vector3d::Zero()}, Qt::red};
        const Eigen::Vector3d shown(621000, 6200000, 250);
        layer.toShown.translationM = shown - layer.toShown.rotation * cloud->originM + Eigen::Vector3d(0.0123, 0, 0);
        QVERIFY((layer.local(shown).translationM - Eigen::Vector3d(0.0123, 0, 0)).norm() < 1e-8);
    }
};

int scan_layers_test(int argc, char** argv) { return runWindowTest<ScanLayersTest>(argc, argv); }
#include "scan_layers_test.moc"
