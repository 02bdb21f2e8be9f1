// Rocks in the real window with real events: faces in all views, slider, pointing, table, the operator's edits, undo, a growing sweep.
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "tests/support/simulated_bell.h"
#include "tests/ui/sized_window.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/count_text.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/panels/rocks/rock_card.h"
#include "ui/panels/rocks/rock_colours.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rock_table_model.h"
#include "ui/panels/rocks/rocks_panel.h"
#include "ui/panels/rocks/size_curve_view.h"
#include "ui/panels/section/section_card.h"
#include "ui/panels/section/section_plot.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/edge_legend.h"
#include "ui/window/cab_mode.h"
#include "ui/window/tool_bar.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <tuple>

using namespace edgescan;
using namespace edgescan::ui;

class RocksWindowTest : public QObject {
    Q_OBJECT

    test::TemporaryFolder folder_;
    Scan scan_;
    std::string bell_;

    static bool settled(WindowFixture& on) {
        return on.settled() && eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); });
    }
    // Opens the scan and shows rocks by their key.
    bool showRocks(WindowFixture& on, const QSize& size = {1600, 950}) {
        on.window.resize(size);
        if (!on.showWith(bell_) || !on.activate()) return false;
        QTest::keyClick(&on.window, Qt::Key_K);
        return settled(on);
    }
    static const RockPicture& picture(WindowFixture& on) { return *on.viewer.rocks.picture(); }
    static QPoint pixelOf(const ImageView& view, QPoint cell) {
        return view.viewPort()->toPixel(QPointF(cell) + QPointF(0.5, 0.5), view.size()).toPoint();
    }
    // A pixel of the view whose cell belongs to the rock.
    static QPoint pixelOn(WindowFixture& on, ImageView& view, std::uint32_t label) {
        const Grid<std::uint32_t>& labels = picture(on).labels;
        const QPoint first = pixelOf(view, on.viewer.views.placeOf(picture(on).rock(label)->cell));
        for (int reach = 0; reach < 12; ++reach) {
            for (int dy = -reach; dy <= reach; ++dy) {
                for (int dx = -reach; dx <= reach; ++dx) {
                    const auto cell = view.cellAt(first + QPoint(dx, dy));
                    if (cell && labels.at(cell->y(), cell->x()) == label) return first + QPoint(dx, dy);
                }
            }
        }
        return {-1, -1};
    }
    static void click(WindowFixture& on, std::uint32_t label, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        ImageView& view = on.viewer.views.gray();
        QTest::mouseClick(&view, Qt::LeftButton, modifiers, pixelOn(on, view, label));
    }
    // Ctrl chooses, and pins nothing.
    static void choose(WindowFixture& on, std::uint32_t label) {
        on.viewer.rocks.select({});
        click(on, label, Qt::ControlModifier);
    }
    // Two rocks with a common border, the larger one first.
    static std::pair<std::uint32_t, std::uint32_t> neighbours(WindowFixture& on) {
        for (const rocks::RegionBorder& border : picture(on).study.map.borders) {
            if (border.a != 0 && border.b <= picture(on).study.map.rocks) return {border.a, border.b};
        }
        return {0, 0};
    }

    // A left drag over an image, cell by cell.
    static void draw(ImageView& view, const std::vector<QPoint>& pixels) {
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, pixels.front());
        for (std::size_t n = 1; n < pixels.size(); ++n) {
            for (int step = 1; step <= 20; ++step) QTest::mouseMove(&view, pixels[n - 1] + (pixels[n] - pixels[n - 1]) * step / 20);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, pixels.back());
    }

private slots:
    void initTestCase() {
        qRegisterMetaType<exports::ExportContent>("edgescan::ExportContent");
        const auto bell = test::simulatedBell(400, 457, 4711);
        QVERIFY(bell);
        scan_ = *bell;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(files::saveScan(scan_, bell_));
    }

    void init() { // edits of the previous test are in the sidecar of the scan
        std::error_code none;
        std::filesystem::remove(rocks::rockPresetPath(bell_), none);
    }

    void aRowBringsItsRockIntoSightAndIsolatingTakesIt() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        CloudView& cloud = on.viewer.views.cloud();
        cloud.flyTo(static_cast<qint64>(picture(on).rock(3)->cell));
        cloud.setCamera(zoomed(cloud.camera(), cloud.camera().focus, 4.0));
        QTableView* table = on.viewer.rockTable.table();
        const auto inSight = [&](std::uint32_t cell) {
            const auto at = cloud.pixelOf(cell);
            return at && QRectF(cloud.rect()).contains(*at);
        };
        int moved = 0;
        for (int row = 0; row < 12; ++row) {
            const CameraPose before = cloud.camera();
            QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(table->model()->index(row, 0)).center());
            QVERIFY(cloud.outline() != nullptr);
            moved += cloud.camera() == before ? 0 : 1;
            std::size_t outside = 0;
            for (const std::uint32_t k : *cloud.outline()) outside += cloud.geometryOfCloud()->drawable(k) && !inSight(k) ? 1 : 0;
            QVERIFY(outside * 8 <= cloud.outline()->size());
            if (cloud.camera() == before) continue;
            // From the scanner's side, where the rock has the face that was measured.
            const CloudGeometry& all = *cloud.geometryOfCloud();
            const Eigen::Vector3f way = all.point(picture(on).rockAt(*on.viewer.rocks.selected().begin())->cell) - all.sensor;
            QVERIFY(cloud.camera().forward().dot(way.cast<double>().normalized()) > 0.9);
        }
        QVERIFY(moved > 0);
        // A small rock is seen with what is around it.
        const auto small = std::ranges::min_element(picture(on).study.rocks, {}, &rocks::Rock::cells);
        on.viewer.rocks.lookAt(small->label);
        const double acrossM = static_cast<double>(cloud.geometryOfCloud()->mainBounds.diagonal().norm());
        QVERIFY2(2.0 * cloud.camera().halfHeight() > 0.06 * acrossM,
                 qPrintable(QString::number(2.0 * cloud.camera().halfHeight() / acrossM)));
        on.viewer.rocks.lookAt(picture(on).study.rocks.front().label);
        // The rock of the row is what Isolate takes: nothing else was selected.
        const std::uint32_t label = on.viewer.rockTable.selected().front();
        QVERIFY(on.viewer.selection.cells().empty());
        on.viewer.selection.isolateSelected();
        QVERIFY(!on.viewer.selection.cells().empty() && !on.viewer.selection.hidden().empty());
        for (const std::uint32_t k : on.viewer.selection.cells()) QCOMPARE(picture(on).labels.cells[k], label);
    }

    void aKeyShowsThemInAllViewsAndTakesThemAway() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        LinkedViews& views = on.viewer.views;
        const std::size_t count = picture(on).study.rocks.size();
        QVERIFY(count > 40);
        for (ImageView* view : {&views.gray(), &views.edges()}) QCOMPARE(view->faces(), picture(on).faces);
        QVERIFY(on.viewer.rocksPanel.text().contains(rockCaveat()) && on.viewer.rockTable.remark().contains(rockCaveat()));
        QCOMPARE(on.viewer.rockTable.table()->model()->rowCount(), static_cast<int>(count));
        // In the cloud each point has the shaded colour of its rock; gray points have equal red and green.
        const auto coloured = [](QRgb p) { return std::abs(qRed(p) - qGreen(p)) + std::abs(qGreen(p) - qBlue(p)) > 40; };
        QVERIFY(countPixels(views.cloud().grabFrame(CloudView::Points::All), coloured) > 5000);

        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(!on.viewer.rocks.picture());
        QVERIFY(!views.gray().faces());
        QVERIFY(!views.cloud().faces());
        QCOMPARE(on.viewer.rockTable.table()->model()->rowCount(), 0);
        QVERIFY(on.window.findChild<QDockWidget*>("dock-rocks")->isHidden());
    }

    void neighboursDifferInColourAndDoubtfulOnesAreHatched() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const RockPicture& shown = picture(on);
        int alike = 0, all = 0;
        for (const rocks::RegionBorder& border : shown.study.map.borders) {
            if (border.a == 0 || border.b > shown.study.map.rocks) continue;
            ++all;
            alike += shown.colours[border.a] == shown.colours[border.b] ? 1 : 0;
        }
        QVERIFY(all > 50);
        QVERIFY2(alike * 50 <= all, qPrintable(QString("%1 of %2").arg(alike).arg(all)));
        on.viewer.rocksPanel.slider()->setFocus();
        QTest::keyClick(on.viewer.rocksPanel.slider(), Qt::Key_Home); // the finest pieces have the most doubtful outlines
        QVERIFY(settled(on));
        const RockPicture& fine = picture(on);
        int doubtful = 0;
        for (const rocks::Rock& rock : fine.study.rocks) {
            std::set<QRgb> inks; // of the face, borders included
            for (std::size_t k = 0; k < fine.labels.size(); ++k) {
                if (fine.labels[k] == rock.label) inks.insert(fine.faces->pixel(on.viewer.views.placeOf(k)));
            }
            QCOMPARE(static_cast<int>(inks.size()), isDoubtful(rock) ? 3 : 2);
            doubtful += isDoubtful(rock) ? 1 : 0;
        }
        QVERIFY2(doubtful > 0, "the scene has rocks with doubtful outlines");
    }

    void theSliderGoesFromFineToCoarseAndEqualsTheCore() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QSlider* slider = on.viewer.rocksPanel.slider();
        std::vector<std::size_t> regions;
        for (const Qt::Key key : {Qt::Key_Home, Qt::Key_End}) {
            slider->setFocus();
            QTest::keyClick(slider, key);
            QVERIFY(settled(on));
            const RockPicture& shown = picture(on);
            QCOMPARE(shown.study.settings.level, key == Qt::Key_Home ? -4.0 : 4.0);
            regions.push_back(shown.study.map.regions.size());
            const rocks::Study again = rocks::studyRocks(rocks::rockInputs(*on.picture().detection), shown.study.settings);
            QVERIFY(shown.labels == rocks::rockLabels(*again.segmentation, again.map));
        }
        QVERIFY2(regions[0] > regions[1], "fine has more pieces than coarse");
        QTest::keyClick(&on.window, Qt::Key_Comma); // finer by half a step
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocksPanel.number("level")->value(), 3.5);
    }

    void pointingTellsAndAClickSelectsEverywhere() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        LinkedViews& views = on.viewer.views;
        const rocks::Rock rock = *picture(on).rock(3);
        const QPoint at = pixelOn(on, views.gray(), 3);
        QTest::mouseMove(&views.gray(), at);
        QVERIFY(eventually([&] { return !views.gray().tip().isEmpty(); }));
        QCOMPARE(views.gray().tip(), rockTip(rock));
        QVERIFY(views.gray().tip().contains(QString::number(rock.longestCaliperM, 'f', 2)));
        QVERIFY(views.edges().tip().isEmpty());
        QCOMPARE(views.cloud().tip(), rockTip(rock));

        // A key, a click, another mode and a pointer that leaves: nothing of it remains.
        const auto pointed = [&] {
            QTest::mouseMove(&views.edges(), QPoint(1, 1));
            QTest::mouseMove(&views.gray(), at);
            return eventually([&] { return views.gray().tip() == rockTip(rock) && !views.cloud().tip().isEmpty(); });
        };
        const auto gone = [&] { return views.gray().tip().isEmpty() && views.cloud().tip().isEmpty(); };
        QTest::keyClick(&on.window, Qt::Key_P);
        QVERIFY(gone());
        QVERIFY(pointed());
        QTest::mousePress(on.window.findChild<QToolButton*>("tool-select"), Qt::RightButton);
        QVERIFY(gone());
        QVERIFY(pointed());
        QEvent leaves(QEvent::Leave);
        QApplication::sendEvent(&views.gray(), &leaves);
        QVERIFY(gone());
        QVERIFY(pointed());
        views.setTool(Tool::Box);
        QVERIFY(gone());
        views.setTool(Tool::Pin);

        choose(on, 3);
        QVERIFY(gone());
        QVERIFY(on.viewer.rocksPanel.card().isVisible());
        QVERIFY(on.viewer.rocksPanel.card().text().startsWith("Rock 3\n"));
        QVERIFY(on.viewer.rocksPanel.card().text().contains(rockCaveat()));
        QCOMPARE(on.viewer.rockTable.selected(), std::vector<std::uint32_t>{3});
        QVERIFY(!views.gray().outline().empty());
        QCOMPARE(views.gray().outline(), views.edges().outline());
        QVERIFY(views.cloud().outline());

        // The row of another rock: its outline appears in the views. Sorted by size b, the first row is the widest rock.
        QTableView* table = on.viewer.rockTable.table();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, table->visualRect(table->model()->index(0, 0)).center());
        const std::vector<std::uint32_t> chosen = on.viewer.rockTable.selected();
        QCOMPARE(chosen.size(), std::size_t{1});
        for (const rocks::Rock& each : picture(on).study.rocks)
            QVERIFY(each.shortestCaliperM <= picture(on).rock(chosen[0])->shortestCaliperM);
        QVERIFY(on.viewer.rocksPanel.card().text().startsWith(QString("Rock %1\n").arg(chosen[0])));
        QVERIFY(views.cloud().outline() && picture(on).labelAt(views.cloud().outline()->front()) == chosen[0]);

        // In the cloud: a visible point of a rock.
        bool clicked = false;
        for (const rocks::Rock& each : picture(on).study.rocks) {
            const auto pixel = views.cloud().pixelOf(each.cell);
            if (!pixel || views.cloud().cellAt(*pixel) != std::optional(each.cell)) continue;
            on.viewer.rocks.select({});
            QTest::mouseClick(&views.cloud(), Qt::LeftButton, Qt::ControlModifier, pixel->toPoint());
            QCOMPARE(on.viewer.rockTable.selected(), std::vector<std::uint32_t>{each.label});
            clicked = true;
            break;
        }
        QVERIFY(clicked);
        QTest::mouseClick(on.viewer.rocksPanel.card().close(), Qt::LeftButton);
        QVERIFY(on.viewer.rocksPanel.card().isHidden());
        QVERIFY(on.viewer.rockTable.selected().empty());
        QVERIFY(views.gray().outline().empty());
        QVERIFY(!views.cloud().outline());
    }

    // The table begins with its first row; a row that is chosen in a view comes with its neighbours, and one in sight moves nothing.
    void theTableBeginsAtItsTop() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTableView* table = on.viewer.rockTable.table();
        QVERIFY(eventually([&] { return table->isVisible() && table->viewport()->height() > 60; }));
        QVERIFY(table->model()->rowCount() > 30);
        const auto select = [&](int row) {
            on.viewer.rocks.select({picture(on).rock(table->model()->index(row, 0).data().toString().section(' ', 0, 0).toUInt())->cell});
        };
        const auto isInSight = [&](int row) {
            return table->viewport()->rect().contains(table->visualRect(table->model()->index(row, 0)).center());
        };
        select(0);
        QCOMPARE(table->verticalScrollBar()->value(), 0);
        select(25);
        QVERIFY(isInSight(24) && isInSight(25) && isInSight(26));
        const int now = table->verticalScrollBar()->value();
        select(24);
        QCOMPARE(table->verticalScrollBar()->value(), now);
        QAction* shows = on.window.findChild<QDockWidget*>("dock-rock-table")->toggleViewAction();
        shows->trigger();
        QVERIFY(eventually([&] { return !table->isVisible(); }));
        select(0);
        shows->trigger();
        QVERIFY(eventually([&] { return table->isVisible() && table->verticalScrollBar()->value() == 0; }));
    }

    // Pinning is its own act: by Shift, or by Pin until Esc or its key ends it.
    void aClickSelectsARockAndMovesNoPin() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto& targets = on.viewer.targets;
        const auto isOnly = [&](std::uint32_t label) { return on.viewer.rockTable.selected() == std::vector<std::uint32_t>{label}; };
        click(on, 3);
        QVERIFY(isOnly(3) && targets.notebook().empty() && !on.viewer.views.pinned());
        QVERIFY(on.viewer.rocksPanel.card().text().startsWith("Rock 3\n"));
        click(on, 3, Qt::ShiftModifier);
        QCOMPARE(targets.notebook().targets.size(), std::size_t(1));
        QVERIFY(isOnly(3) && targets.active() != nullptr);
        const std::uint32_t pinned = targets.notebook().targets.front().cell;
        click(on, 2);
        QVERIFY(isOnly(2) && targets.active() == nullptr && targets.notebook().targets.size() == 1);
        QCOMPARE(targets.notebook().targets.front().cell, pinned);
        const auto& labels = picture(on).labels.cells;
        const auto none = std::ranges::find(labels, 0U) - labels.begin();
        on.viewer.views.click(inspect::exactly(static_cast<std::size_t>(none)));
        QVERIFY2(on.viewer.notice.text().startsWith("No rock was found here"), qPrintable(on.viewer.notice.text()));
        QVERIFY(isOnly(2));
        for (const auto end : {Qt::Key_Escape, Qt::Key_P}) {
            const std::size_t before = targets.notebook().targets.size();
            QTest::keyClick(&on.window, Qt::Key_P);
            click(on, end == Qt::Key_P ? 5 : 4);
            QCOMPARE(targets.notebook().targets.size(), before + 1);
            QTest::keyClick(&on.window, end);
            click(on, 2);
            QVERIFY(isOnly(2));
            QCOMPARE(targets.notebook().targets.size(), before + 1);
        }
        QVERIFY2(on.viewer.notice.text().contains("a click selects a rock"), qPrintable(on.viewer.notice.text()));
        on.viewer.rocks.setShown(false);
        on.viewer.views.click(inspect::exactly(static_cast<std::size_t>(none)));
        QCOMPARE(targets.notebook().targets.size(), std::size_t(4)); // without rocks each click pins
    }

    // A click of Pin pins, and chooses the rock that is there; it stays the one of the chosen target.
    void aClickOfPinChoosesItsRockToo() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTest::keyClick(&on.window, Qt::Key_P);
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.size() == QSize(1280, 800))); // panels behind each other
        const std::vector<std::size_t> none;
        click(on, 2);
        on.window.findChild<QDockWidget*>("dock-rocks")->raise();
        const auto* targets = on.window.findChild<QDockWidget*>("dock-targets");
        QTRY_VERIFY(targets->visibleRegion().isEmpty());
        on.viewer.undo.undo();
        click(on, 3);
        QApplication::processEvents();
        QVERIFY2(targets->visibleRegion().isEmpty(), "the panel of the rocks stays in front: Merge and Split are there");
        on.window.findChild<QDockWidget*>("dock-targets")->raise();
        QTRY_VERIFY(!targets->visibleRegion().isEmpty());
        QVERIFY(on.viewer.views.pinned() && picture(on).labelAt(*on.viewer.views.pinned()) == 3);
        const auto isChosen = [&](std::uint32_t label) {
            const auto& outline = on.viewer.views.cloud().outline();
            return on.viewer.rockTable.selected() == std::vector<std::uint32_t>{label} && outline &&
                   picture(on).labelAt(outline->front()) == label &&
                   on.viewer.rocksPanel.card().text().startsWith(QString("Rock %1\n").arg(label));
        };
        QVERIFY(isChosen(3) && on.viewer.rocks.chosen() == on.viewer.views.pinned());
        const auto* list = on.viewer.targetsPanel.findChild<QListWidget*>("target-list");
        QTRY_VERIFY2(list->item(0)->text().contains("rock 3"), qPrintable(list->item(0)->text()));
        QVERIFY(on.viewer.cloud.marks().targets.front().tag.endsWith(" · rock 3")); // in a small window there is no list
        QVERIFY2(on.viewer.rocksPanel.card().text().contains("\npinned target: 1\n"), qPrintable(on.viewer.rocksPanel.card().text()));
        // Rocks that are switched on later, and the row of a target, choose in the same way; a row of another rock ends the choice.
        on.viewer.rocks.setShown(false);
        on.viewer.rocks.setShown(true);
        QVERIFY(settled(on) && isChosen(3));
        QTest::keyClick(&on.window, Qt::Key_P);
        click(on, 4);
        QVERIFY(isChosen(4));
        on.window.findChild<QDockWidget*>("dock-targets")->raise();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(0)).center());
        QVERIFY(isChosen(3) && on.viewer.views.pinned());
        QTRY_VERIFY(on.viewer.rocksPanel.card().visibleRegion().isEmpty());
        emit on.viewer.rockTable.chosen({5});
        QTRY_VERIFY2(!on.viewer.rocksPanel.card().visibleRegion().isEmpty(), "the card of the chosen rock is in front");
        QVERIFY(isChosen(5) && !on.viewer.views.pinned());
        on.window.findChild<QDockWidget*>("dock-targets")->raise();
        QTRY_VERIFY(!targets->visibleRegion().isEmpty());
        emit on.viewer.rocks.selectionChanged(); // the same rock in a new picture
        QApplication::processEvents();
        QVERIFY2(!targets->visibleRegion().isEmpty(), "the panel that the operator opened stays in front");
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(2));
        on.viewer.undo.undo();
        click(on, 3); // the target that is there already
        // With Ctrl a rock is added, and taken away; nothing is pinned.
        click(on, 4, Qt::ControlModifier);
        QCOMPARE(on.viewer.rocks.selected().size(), std::size_t(2));
        QVERIFY(picture(on).labelAt(*on.viewer.rocks.chosen()) == 4);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(0)).center());
        QVERIFY2(isChosen(3), "the row of the target, which was chosen all the time");
        on.viewer.rocks.select({picture(on).rock(5)->cell}); // by a command of another rock's menu
        QVERIFY(isChosen(5) && !on.viewer.views.pinned());
        click(on, 3);
        click(on, 4, Qt::ControlModifier);
        QCOMPARE(on.viewer.rocks.selected().size(), std::size_t(2));
        on.viewer.views.clearPin();
        QCOMPARE(on.viewer.rocks.selected().size(), std::size_t(2));
        click(on, 2);
        QVERIFY(isChosen(2)); // alone
        on.viewer.undo.undo();
        QVERIFY(!on.viewer.views.pinned() && on.viewer.rocks.selected() == none && !on.viewer.views.cloud().outline());
        on.viewer.rocks.select({picture(on).rock(2)->cell});
        QVERIFY2(!on.viewer.rocksPanel.card().text().contains("pinned target"), "one step took both back");
        on.viewer.rocks.select({});
        on.viewer.views.clearPin();
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_N);
        QVERIFY2(on.viewer.notice.text().startsWith("Select a rock first"), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.rocks.edits().empty());
    }

    // What the table shows as 1.00 is at least 1.00, and what it shows as 0.85 is not below 0.85.
    void limitsAreThoseOfTheNumbersThatAreShown() {
        rocks::Rock rock;
        rock.shortestCaliperM = 0.9953;
        QVERIFY((RockFilter{1.0, false}.shows(rock)));
        rock.shortestCaliperM = 0.9949;
        QVERIFY(!(RockFilter{1.0, false}.shows(rock)));
        for (const auto& [p, text, doubtful] :
             {std::tuple{0.8497, "0.85", false}, {0.8493, "0.84", true}, {1.0, "1.00", false}, {0.9, "0.90", false}}) {
            rock.confidence = p;
            QCOMPARE(rocks::confidenceText(rock), std::string(text));
            QCOMPARE(rocks::isDoubtful(rock), doubtful);
        }
    }

    void theTableSortsFiltersAndJumps() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        RockTable& rocks = on.viewer.rockTable;
        QTableView* table = rocks.table();
        const auto column = [&](int n) {
            std::vector<double> values;
            for (int row = 0; row < table->model()->rowCount(); ++row)
                values.push_back(table->model()->index(row, n).data(RockTableModel::kNumberRole).toDouble());
            return values;
        };
        QVERIFY2(table->model()->headerData(2, Qt::Horizontal).toString().startsWith("size"), "the order at first");
        QCOMPARE(table->horizontalHeader()->sortIndicatorSection(), 2);
        const std::vector<double> largestFirst = column(2);
        QVERIFY(std::is_sorted(largestFirst.rbegin(), largestFirst.rend()));
        for (int n = 0; n < table->model()->columnCount(); ++n) {
            table->scrollToBottom();
            QVERIFY(table->verticalScrollBar()->value() > 0);
            QTest::mouseClick(table->horizontalHeader()->viewport(), Qt::LeftButton, Qt::NoModifier,
                              QPoint(table->horizontalHeader()->sectionViewportPosition(n) + 5, 5));
            QTRY_COMPARE(table->verticalScrollBar()->value(), 0); // the first row of the new order
            const bool up = table->horizontalHeader()->sortIndicatorOrder() == Qt::AscendingOrder;
            const QString head = table->model()->headerData(n, Qt::Horizontal).toString();
            if (n != 2) QCOMPARE(up, head.startsWith("Rock") || head.startsWith("distance")); // of sizes the largest first
            const std::vector<double> values = column(n);
            QCOMPARE(table->horizontalHeader()->sortIndicatorSection(), n);
            QVERIFY(up ? std::is_sorted(values.begin(), values.end()) : std::is_sorted(values.rbegin(), values.rend()));
        }
        const int all = table->model()->rowCount();
        rocks.smallest()->setValue(0.5);
        const std::vector<double> wide = column(2);
        QVERIFY(!wide.empty() && static_cast<int>(wide.size()) < all);
        QVERIFY(*std::min_element(wide.begin(), wide.end()) >= 0.495); // the table has 0.50
        QVERIFY2(rocks.remark().contains(QString("%1 of %2 rocks").arg(wide.size()).arg(all)), qPrintable(rocks.remark()));
        QTRY_COMPARE(picture(on).filter.smallestM, 0.5); // the views colour what the table lists
        for (const rocks::Rock& rock : picture(on).study.rocks) {
            const auto place = on.viewer.views.placeOf(rock.cell);
            if (rocks::isRockBorder(picture(on).labels, place.y(), place.x())) continue;
            QCOMPARE(qAlpha(picture(on).faces->pixel(place)) > 0, rounded(rock.shortestCaliperM, 100) >= 0.5);
        }
        QTest::mouseClick(rocks.sureOnly(), Qt::LeftButton, Qt::NoModifier, QPoint(8, rocks.sureOnly()->height() / 2));
        for (const double p : column(10)) QVERIFY(p >= rocks::kSureConfidence);
        QVERIFY2(table->model()->rowCount() > 0, "no rock is sure");

        // The smallest rock is too small to be recognised from where the camera is.
        QTest::mouseClick(rocks.sureOnly(), Qt::LeftButton, Qt::NoModifier, QPoint(8, rocks.sureOnly()->height() / 2));
        rocks.smallest()->setValue(0);
        table->sortByColumn(2, Qt::AscendingOrder);
        const CameraPose before = on.viewer.views.cloud().camera();
        const QPoint row = table->visualRect(table->model()->index(0, 1)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, row);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, row);
        QVERIFY(!(on.viewer.views.cloud().camera() == before));
        QVERIFY(on.viewer.rocks.selected().size() == 1 && !on.viewer.views.pinned() && on.viewer.targets.notebook().targets.empty());
    }

    // At every width: a head, with its arrow where the table is sorted, and each number have their whole width; else the table scrolls.
    void theTableCutsNoHeadAndNoNumber() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTableView* table = on.viewer.rockTable.table();
        const QAbstractItemView& content = *table;
        for (const QSize size : {QSize(1280, 800), QSize(1700, 1000), QSize(1920, 1040)}) {
            QTRY_VERIFY((on.window.resize(size), on.window.width() == size.width()));
            for (int n = 0; n < 5; ++n) QApplication::processEvents();
            const QHeaderView* heads = table->horizontalHeader();
            int whole = 0;
            for (int n = 0; n < heads->count(); ++n) {
                whole += heads->sectionSize(n);
                QVERIFY2(heads->sectionSize(n) >= std::max(heads->sectionSizeHint(n), content.sizeHintForColumn(n)),
                         qPrintable(table->model()->headerData(n, Qt::Horizontal).toString()));
                const QString help = table->model()->headerData(n, Qt::Horizontal, Qt::ToolTipRole).toString();
                QVERIFY2(help.contains('\n'), qPrintable(help)); // its name and what it is
            }
            QVERIFY(whole <= table->viewport()->width() || table->horizontalScrollBar()->maximum() > 0);
            if (size.width() != 1280) continue;
            int inSight = 0; // only two of the columns were
            for (int n = 0; n < heads->count(); ++n) {
                const int left = heads->sectionViewportPosition(n), right = left + heads->sectionSize(n);
                inSight += right <= table->viewport()->width() ? 1 : 0;
                QVERIFY2(right <= table->viewport()->width() || left >= table->viewport()->width(), "a head is cut at the border");
            }
            QVERIFY2(inSight >= 4, qPrintable(QString("%1 of %2 px").arg(inSight).arg(table->viewport()->width())));
        }
    }

    // The numbers stay in sight while the other columns scroll, and their column does all that it does in the table.
    void theNumbersOfTheTableStayInSight() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.width() == 1280));
        on.window.findChild<QDockWidget*>("dock-rock-table")->raise();
        QTableView& table = *on.viewer.rockTable.table();
        QTableView& numbers = *on.viewer.rockTable.numbers();
        QTRY_VERIFY(numbers.isVisible() && table.horizontalScrollBar()->maximum() > 0);
        table.horizontalScrollBar()->setValue(table.horizontalScrollBar()->maximum());
        const int scrolled = table.horizontalScrollBar()->value();
        QTRY_COMPARE(numbers.viewport()->visibleRegion().boundingRect().width(), table.columnWidth(0));
        const auto place = [&on](const QTableView& view, int row) {
            const QRect rect = view.visualRect(view.model()->index(row, &view == on.viewer.rockTable.numbers() ? 0 : 10));
            return QRect(view.viewport()->mapToGlobal(rect.topLeft()), rect.size());
        };
        QCOMPARE(place(numbers, 2).top(), place(table, 2).top());
        QCOMPARE(place(numbers, 2).height(), place(table, 2).height());
        QTest::mouseClick(numbers.viewport(), Qt::LeftButton, Qt::NoModifier, numbers.visualRect(numbers.model()->index(2, 0)).center());
        QApplication::processEvents();
        QCOMPARE(on.viewer.rocks.selected().size(), std::size_t{1});
        QCOMPARE(QString::number(picture(on).labelAt(on.viewer.rocks.selected().front())), table.model()->index(2, 0).data().toString());
        QCOMPARE(table.horizontalScrollBar()->value(), scrolled);
        table.verticalScrollBar()->setValue(table.verticalScrollBar()->maximum());
        const int last = table.model()->rowCount() - 1;
        QCOMPARE(place(numbers, last).top(), place(table, last).top());
        table.verticalScrollBar()->setValue(0);
        QTest::mouseClick(numbers.horizontalHeader()->viewport(), Qt::LeftButton, Qt::NoModifier, QPoint(5, 5));
        QCOMPARE(table.horizontalHeader()->sortIndicatorSection(), 0);
        QCOMPARE(table.model()->index(0, 0).data(RockTableModel::kNumberRole).toInt(), 1);
        table.sortByColumn(2, Qt::DescendingOrder);
        QCOMPARE(numbers.horizontalHeader()->sortIndicatorSection(), 2);
    }

    // The menu of a rock is the same in the table; in a narrow window the table is a tab at the panel of rocks.
    void theTableHasTheMenuOfARockAndIsATabInANarrowWindow() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTableView* table = on.viewer.rockTable.table();
        const auto menuAt = [&](const QModelIndex& row, const QString& chosen) {
            QStringList words;
            Meanwhile look([&] {
                auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
                if (menu == nullptr) return false;
                auto* rock = menu->findChild<QMenu*>("rock-menu");
                QAction* wanted = nullptr;
                for (QAction* each : rock == nullptr ? QList<QAction*>() : rock->actions()) {
                    words << each->text().remove('&');
                    if (words.back() == chosen) wanted = each;
                }
                menu->close();
                if (wanted != nullptr) wanted->trigger();
                return true;
            });
            const QPoint at = table->visualRect(row).center();
            QContextMenuEvent event(QContextMenuEvent::Mouse, at, table->viewport()->mapToGlobal(at));
            QApplication::sendEvent(table->viewport(), &event);
            return words;
        };
        const std::size_t count = picture(on).study.rocks.size();
        const QStringList words = menuAt(table->model()->index(1, 0), "Wall, Not a Rock");
        for (const char* each : {"Merge with Selected Rocks", "Split Here", "Cut along a Line", "Wall, Not a Rock", "Isolate",
                                 "Measure from Here", "Export Rocks…", "Name…"})
            QVERIFY2(words.contains(QString::fromUtf8(each)), qPrintable(words.join(", ")));
        QVERIFY(settled(on));
        QCOMPARE(picture(on).study.rocks.size(), count - 1);
        // The numbers have a gap now: a row means the rock whose number it shows.
        const int last = table->model()->rowCount() - 1;
        table->selectRow(last);
        QVERIFY(eventually([&] { return on.viewer.rocks.selected().size() == 1; }));
        QCOMPARE(QString::number(picture(on).labelAt(on.viewer.rocks.selected().front())),
                 table->model()->index(last, 0).data().toString().section(' ', 0, 0));
        Meanwhile name([&] {
            auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return false;
            QTest::keyClicks(dialog->findChild<QLineEdit*>(), "Big Bertha");
            QTest::keyClick(dialog, Qt::Key_Return);
            return true;
        });
        menuAt(table->model()->index(1, 0), "Name…");
        QCOMPARE(on.viewer.targets.notebook().targets.back().name, std::string("Big Bertha"));
        // The table has the name, in the row of the rock.
        const std::uint32_t label = picture(on).labelAt(on.viewer.targets.notebook().targets.back().cell);
        QStringList rows;
        for (int row = 0; row < table->model()->rowCount(); ++row) rows << table->model()->index(row, 0).data().toString();
        QVERIFY2(rows.contains(QString("%1 Big Bertha").arg(label)), qPrintable(rows.join(", ")));
        QCOMPARE(rows.filter("Bertha").size(), 1);
        auto* dock = on.window.findChild<QDockWidget*>("dock-rock-table");
        auto* rocks = on.window.findChild<QDockWidget*>("dock-rocks");
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.width() == 1280));
        QTRY_VERIFY(!dock->isHidden() && on.window.tabifiedDockWidgets(rocks).contains(dock));
        QVERIFY(dock->width() < 450);
        QTRY_VERIFY((on.window.resize(1700, 1000), on.window.width() == 1700));
        QTRY_VERIFY(!dock->isHidden() && !on.window.tabifiedDockWidgets(rocks).contains(dock));
    }

    void theSizeCurveLeavesOutWhatHasNoRoom() {
        SizeCurveView view;
        for (const double top : {0.31, 0.5, 0.72, 1.0, 1.22, 2.4}) {
            rocks::SizeCurve curve;
            curve.widthsM = {0.2 * top, 0.5 * top, top};
            curve.topM = top;
            view.show(curve);
            for (const QSize size : {QSize(180, 110), QSize(230, 160), QSize(300, 200), QSize(500, 170), QSize(1900, 180)}) {
                view.resize(size);
                const auto labels = view.axisLabels();
                QVERIFY(labels.size() >= 2 && labels.front().text.endsWith(" m"));
                for (std::size_t n = 0; n < labels.size(); ++n) {
                    QVERIFY(QRectF(view.rect()).contains(labels[n].place));
                    QVERIFY2(n == 0 || labels[n].place.right() + 4 < labels[n - 1].place.left(), qPrintable(labels[n].text));
                }
                QVERIFY2(view.placeOf(0, 1).y() < 0.65 * size.height(), "the curve has its share");
                QVERIFY(size.height() < 150 || view.caption().contains("40 %"));
            }
        }
    }

    // The number of the largest rock is above the curve, where nothing else is drawn.
    void theLargestRockIsNotOverTheCurve() {
        SizeCurveView view;
        rocks::SizeCurve curve;
        curve.widthsM = {0.2, 0.5, 0.9, 1.0};
        curve.topM = 1.0;
        view.show(curve);
        view.resize(300, 54);
        QVERIFY(view.caption().isEmpty());
        const QImage seen = view.grab(QRect(150, 0, 150, static_cast<int>(view.placeOf(0, 1).y()) - 4)).toImage();
        int ink = 0;
        for (int y = 0; y < seen.height(); ++y) {
            for (int x = 0; x < seen.width(); ++x) ink += std::abs(qGray(seen.pixel(x, y)) - qGray(seen.pixel(0, 0))) > 60 ? 1 : 0;
        }
        QVERIFY2(ink > 60, qPrintable(QString::number(ink)));
    }

    void theSizeCurveIsDrawnWithItsMarksAndTheOversize() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        SizeCurveView* view = on.viewer.rockTable.sizeCurve();
        const std::vector<rocks::Rock> rocks = picture(on).study.rocks; // a copy: the picture is freed when another one is shown
        QCOMPARE(view->curve().rocks(), rocks.size());
        const auto over = [&](double wideM) {
            return static_cast<double>(
                       std::count_if(rocks.begin(), rocks.end(), [&](const rocks::Rock& r) { return r.shortestCaliperM > wideM; })) /
                   static_cast<double>(rocks.size());
        };
        QVERIFY(std::abs(over(view->curve().p80M) - 0.2) < 0.03);
        // Half of the rocks, up to rounding and the one rock at the pointer's position.
        const QString text = view->textAt(view->placeOf(view->curve().p50M, 0.3));
        QVERIFY2(text.contains(" % of the rocks"), qPrintable(text));
        QVERIFY2(std::abs(text.section(' ', 0, 0).toDouble() - 50) <= 0.5 + 100.0 / static_cast<double>(rocks.size()), qPrintable(text));
        QVERIFY(view->accessibleDescription().contains("40 % and more"));
        on.viewer.rocksPanel.number("oversize")->setValue(0.5);
        QVERIFY(settled(on));
        QCOMPARE(view->curve().oversizeM, 0.5);
        QVERIFY(std::abs(view->curve().oversizeShare - over(0.5)) < 1e-9);
        const QString share = QString("%1 % over 0.50 m").arg(100 * over(0.5), 0, 'f', 0);
        QVERIFY2(view->accessibleDescription().contains(share), qPrintable(view->accessibleDescription()));
        QVERIFY(on.viewer.rocksPanel.text().contains(share));
        // The dot of the selected rock has a colour of its own.
        const QImage before = view->grab().toImage();
        choose(on, 2);
        QCOMPARE(view->marked(), std::vector<double>{picture(on).rock(2)->shortestCaliperM});
        const QPoint dot = view->placeOf(view->marked()[0], view->curve().shareUpTo(view->marked()[0])).toPoint();
        QVERIFY(view->grab().toImage().pixel(dot) != before.pixel(dot));
        QTest::keyClick(&on.window, Qt::Key_K);
        QCOMPARE(view->curve().rocks(), std::size_t{0});
    }

    // On a small screen its contacts need no scrolling, and the classes of edges that rocks cover use no rows unless they are asked for.
    void theCardComesFirstAndTheLegendIsShort() {
        WindowFixture on;
        QVERIFY(showRocks(on, {1280, 800}));
        QVERIFY(on.window.findChild<QDockWidget*>("dock-rocks")->height() > 0.4 * on.window.height()); // before there is a card, too
        choose(on, 3);
        QTRY_VERIFY(on.viewer.rocksPanel.card().visibleRegion().boundingRect().height() > 0.8 * on.viewer.rocksPanel.card().height());
        QCheckBox* jumps = on.viewer.legend.classSwitch(0);
        QTRY_VERIFY(!jumps->isVisible());
        QTest::mouseClick(on.viewer.legend.unfold(), Qt::LeftButton);
        QTRY_VERIFY(jumps->isVisible());
        on.viewer.rocks.setShown(false);
        on.viewer.rocks.setShown(true);
        QTRY_VERIFY(!jumps->isVisible());
        on.viewer.rocks.setShown(false);
        QTRY_VERIFY2(jumps->isVisible(), "as the operator left it without rocks");
    }

    void theCardSaysThatUpIsAssumedAndNamesTheRocksOfTheArch() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto& all = picture(on).study.rocks;
        const auto rock = std::ranges::find_if(all, [](const rocks::Rock& each) { return each.archDeg.has_value(); });
        QVERIFY(rock != all.end());
        for (const rocks::Rock& each : all) {
            for (const std::uint32_t other : each.archBetween)
                QCOMPARE(std::ranges::find(each.contacts, other) != each.contacts.end(), each.archDeg.has_value());
        }
        choose(on, rock->label);
        const QString text = on.viewer.rocksPanel.card().text();
        QVERIFY2(text.contains("\nup: the scanner's z axis, assumed\n"), qPrintable(text));
        QVERIFY2(text.contains(QString("between rocks %1 and %2").arg(rock->archBetween[0]).arg(rock->archBetween[1])), qPrintable(text));
    }

    void oneClickMergesWhatMayBeOneRock() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto offered = [&] {
            return std::ranges::find_if(picture(on).study.rocks, [](const rocks::Rock& rock) { return !rock.maybeOneWith.empty(); });
        };
        for (int level = 0; level <= 16 && offered() == picture(on).study.rocks.end(); ++level) {
            rocks::RockSettings settings = picture(on).study.settings;
            settings.level = 0.5 * level - 4;
            settings.minimumCells = 20;
            on.viewer.rocks.useSettings(settings);
            QVERIFY(settled(on));
        }
        const auto rock = offered();
        QVERIFY(rock != picture(on).study.rocks.end());
        std::vector<std::size_t> cells{rock->cell};
        QStringList labels;
        for (const std::uint32_t other : rock->maybeOneWith) {
            cells.push_back(picture(on).rock(other)->cell);
            labels << QString::number(other);
        }
        choose(on, rock->label);
        const QString text = on.viewer.rocksPanel.card().text();
        QVERIFY2(text.contains("may be one with"), qPrintable(text));
        for (const QString& label : labels) QVERIFY2(text.section("may be one with", 1).contains(label), qPrintable(text));
        const auto* model = on.window.findChild<RockTableModel*>();
        for (int row = 0; row < model->rowCount(); ++row) {
            const rocks::Rock& of = picture(on).study.rocks[static_cast<std::size_t>(row)];
            const QModelIndex first = model->index(row, 0);
            QCOMPARE(first.data().toString().contains(QString::fromUtf8("≈")), !of.maybeOneWith.empty());
            QCOMPARE(first.data(Qt::ToolTipRole).toString().contains("may be one with"), !of.maybeOneWith.empty());
        }
        const std::uint32_t shown = rock->label;
        auto& card = on.viewer.rocksPanel.card();
        emit card.findChild<QLabel*>("rock-state")->linkActivated(labels.front());
        QTRY_VERIFY2(card.text().startsWith("Rock " + labels.front() + "\n"), qPrintable(card.text()));
        QVERIFY(!card.text().contains('<'));
        choose(on, shown);
        QTest::mouseClick(on.viewer.rocksPanel.card().merge(), Qt::LeftButton);
        QVERIFY(settled(on));
        for (const std::size_t cell : cells) QVERIFY(picture(on).regionAt(cell) == picture(on).regionAt(cells.front()));
    }

    void mergeSplitAndUndoStayWhateverIsTurned() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto [a, b] = neighbours(on);
        QVERIFY(a != 0);
        const std::size_t cellA = picture(on).rock(a)->cell, cellB = picture(on).rock(b)->cell;
        const Grid<std::uint32_t> before = picture(on).labels;
        const auto one = [&, cellA = cellA, cellB = cellB] { return picture(on).regionAt(cellA) == picture(on).regionAt(cellB); };
        choose(on, a);
        click(on, b, Qt::ControlModifier);
        QCOMPARE(on.viewer.rocks.selected().size(), std::size_t{2});
        QTest::mouseClick(on.viewer.rocksPanel.card().merge(), Qt::LeftButton);
        QVERIFY(settled(on));
        QVERIFY(one());
        // An edit is a constraint: it also holds at the fine end of the slider.
        on.viewer.rocksPanel.slider()->setFocus();
        QTest::keyClick(on.viewer.rocksPanel.slider(), Qt::Key_Home);
        QVERIFY(settled(on));
        QVERIFY(one());
        // A change of the slider is an undo step too.
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(settled(on));
        QVERIFY(on.viewer.rocks.settings() == rocks::RockSettings{});
        QVERIFY(one());
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(settled(on));
        QVERIFY(picture(on).labels == before);
        QTest::keyClick(&on.window, Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(settled(on));
        QVERIFY(one());

        // A click on a rock with several segments splits it.
        for (const rocks::Rock& rock : picture(on).study.rocks) {
            const QPoint pixel = pixelOn(on, on.viewer.views.gray(), rock.label);
            const auto cell = on.viewer.views.gray().cellAt(pixel);
            const rocks::Study& study = picture(on).study;
            const auto k = static_cast<std::uint32_t>(picture(on).labels.index(cell->y(), cell->x()));
            const auto wheel = rocks::wheelPiecesAt(*study.segmentation, *study.tree, study.settings.level, k, study.edits);
            if (wheel.split == wheel.nested.region || wheel.unjoined) continue; // the merged rock is split into what was merged
            const std::size_t regions = study.map.regions.size();
            QTest::keyClick(&on.window, Qt::Key_S);
            QTest::keyClick(&on.window, Qt::Key_S); // ends it, and says so
            QVERIFY(on.viewer.rocks.tool() == RockTool::None);
            QVERIFY2(on.viewer.notice.text().contains("Split a Rock” has ended"), qPrintable(on.viewer.notice.text()));
            QTest::keyClick(&on.window, Qt::Key_S);
            QVERIFY(on.viewer.rocks.tool() == RockTool::Split);
            QVERIFY(on.viewer.tools.shown().contains("click the part"));
            QTest::mouseMove(&on.viewer.views.gray(), pixel);
            QVERIFY(eventually([&] { return !on.viewer.views.gray().tip().isEmpty(); }));
            QTest::mouseClick(&on.viewer.views.gray(), Qt::LeftButton, Qt::NoModifier, pixel);
            QVERIFY(on.viewer.rocks.tool() == RockTool::None);
            QVERIFY(!on.viewer.tools.shown().contains("click the part"));
            QVERIFY(settled(on));
            QVERIFY2(on.viewer.views.gray().tip().isEmpty() && on.viewer.views.cloud().tip().isEmpty(), "the split is done");
            QCOMPARE(on.viewer.rocks.edits().front().kind, rocks::EditKind::Join); // the merge of before
            QVERIFY(on.viewer.rocks.edits().size() > 1);
            QVERIFY(picture(on).study.map.regions.size() > regions);
            QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(settled(on));
            QCOMPARE(picture(on).study.map.regions.size(), regions);
            return;
        }
        QFAIL("no rock of the scene can be split");
    }

    // Two rocks of several pieces: after M there is one rock with all cells of both, and one outline, table row and number less.
    void aMergeLeavesNoPartOutside() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto before = on.viewer.rocks.picture();
        const rocks::Study& study = before->study;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (const rocks::RegionBorder& border : study.map.borders) {
            if (border.a == 0 || border.b > study.map.rocks) continue;
            // With one cell of each alone, pieces of them would remain.
            const rocks::Edit cells{rocks::EditKind::Join, {before->rock(border.a)->cell, before->rock(border.b)->cell}};
            const rocks::MergeTree tree =
                rocks::withPairs(*study.tree, *study.segmentation, rocks::pairsOf(*study.segmentation, std::span(&cells, 1)));
            if (rocks::rocksAt(*study.segmentation, tree, study.settings).rocks + 1 != study.map.rocks)
                pairs.emplace_back(border.a, border.b);
        }
        QVERIFY(!pairs.empty());
        pairs.resize(std::min(pairs.size(), std::size_t{3}));
        for (const auto& [a, b] : pairs) {
            const rocks::Rock one = *before->rock(a), other = *before->rock(b);
            on.viewer.rocks.select({one.cell, other.cell});
            QVERIFY(on.activate());
            QTest::keyClick(&on.window, Qt::Key_M);
            QVERIFY(settled(on));
            QCOMPARE(picture(on).study.rocks.size() + 1, study.rocks.size());
            QCOMPARE(on.viewer.rockTable.table()->model()->rowCount() + 1, static_cast<int>(study.rocks.size()));
            const rocks::Rock* merged = picture(on).rockAt(one.cell);
            QVERIFY(merged != nullptr && merged == picture(on).rockAt(other.cell));
            QCOMPARE(merged->cells, one.cells + other.cells);
            QCOMPARE(on.viewer.views.gray().outline().size(), outlineOf(picture(on).labels, merged->label).sides.size());
            for (std::size_t k = 0; k < before->labels.size(); ++k) {
                if (before->labels[k] == a || before->labels[k] == b) QCOMPARE(picture(on).labels[k], merged->label);
            }
            on.viewer.undo.undo();
            QVERIFY(settled(on));
            QVERIFY(picture(on).labels == before->labels);
        }
    }

    // A click of a tool is a step of undo only where a rock changed, and it sets no target. The numbers of other rocks that changed are
    // said.
    void aToolLeavesAStepOnlyWhereSomethingChanged() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto count = static_cast<std::uint32_t>(picture(on).study.rocks.size());
        const std::size_t first = picture(on).rock(1)->cell, last = picture(on).rock(count)->cell;
        const std::uint32_t cells = picture(on).rock(1)->cells;
        const Grid<std::uint32_t> before = picture(on).labels;
        const std::size_t second = picture(on).rock(count - 1)->cell;
        const std::vector<std::size_t> two{second, last}, one{last};
        on.viewer.rocks.select(two);
        on.viewer.rocks.mergeSelected();
        QVERIFY(settled(on) && on.viewer.rocks.selected() == one);
        const std::uint32_t moved = picture(on).labelAt(first);
        QCOMPARE(moved, std::uint32_t{1});
        on.viewer.undo.undo();
        QVERIFY(settled(on) && on.viewer.rocks.selected() == two); // both again
        on.viewer.undo.redo();
        QVERIFY(settled(on) && on.viewer.rocks.selected() == one);
        on.viewer.undo.undo();
        QVERIFY(settled(on));
        on.viewer.rocks.select({first, last});
        on.viewer.rocks.mergeSelected();
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.undo.index(), 1);
        // The same again is refused: it is one rock.
        on.viewer.rocks.select({first, last});
        on.viewer.rocks.mergeSelected();
        QVERIFY2(on.viewer.notice.text().startsWith("Nothing was merged: this is one rock"), qPrintable(on.viewer.notice.text()));
        QCOMPARE(on.viewer.undo.count(), 1);
        // A rock marked as one again has not changed: there is not another step.
        on.viewer.rocks.select({second});
        on.viewer.rocks.callChosen(true);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.undo.count(), 2);
        on.viewer.rocks.callChosen(true);
        QVERIFY(settled(on));
        QTRY_COMPARE(on.viewer.undo.count(), 2);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{2});
        QVERIFY2(on.viewer.notice.text().startsWith("No rock changed"), qPrintable(on.viewer.notice.text()));
        on.viewer.undo.undo();
        QVERIFY(settled(on));
        // Split takes them apart again, and no target is set.
        QTest::keyClick(&on.window, Qt::Key_S);
        QTest::mouseClick(&on.viewer.views.gray(), Qt::LeftButton, Qt::NoModifier, pixelOn(on, on.viewer.views.gray(), 1));
        QVERIFY(settled(on));
        QVERIFY2(on.viewer.notice.text().startsWith("Split: rock "), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.targets.notebook().empty());
        QCOMPARE(on.viewer.undo.count(), 2);
        QVERIFY(picture(on).labels == before);
        QCOMPARE(picture(on).rockAt(first)->cells, cells);
        QVERIFY(on.viewer.rocks.edits().empty());
        // Without the largest rock each other one keeps its number.
        on.viewer.rocks.select({first});
        on.viewer.rocks.callChosen(false);
        QVERIFY(settled(on));
        for (std::size_t k = 0; k < before.size(); ++k)
            if (before[k] != picture(on).labels[k]) QCOMPARE(before[k], 1U);
    }

    // Both parts of a split are rocks, also below “Smallest rock”. What was a wall before a merge is one again after a split, which is
    // said.
    void thePartsOfASplitAreRocks() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const rocks::Study study = picture(on).study;
        bool any = false;
        std::set<std::uint32_t> tried;
        for (std::uint32_t cell = 0; cell < picture(on).labels.size(); ++cell) {
            const rocks::Rock* rock = picture(on).rockAt(cell);
            if (rock == nullptr || !tried.insert(study.segmentation->segment[cell]).second) continue;
            const auto family = rocks::wheelPiecesAt(*study.segmentation, *study.tree, study.settings.level, cell, {});
            if (family.split == family.nested.region) continue;
            const std::uint32_t part = family.nested.pieces[family.split].cells;
            if (part * 2 > rock->cells) continue;
            any = true;
            rocks::RockSettings settings = study.settings;
            settings.minimumCells = static_cast<int>(part) + 1;
            on.viewer.rocks.useSettings(settings);
            QVERIFY(settled(on));
            const std::uint32_t label = picture(on).labelAt(cell);
            QVERIFY(label != 0);
            QTest::keyClick(&on.window, Qt::Key_S);
            on.viewer.views.click(inspect::exactly(cell));
            QVERIFY(settled(on));
            QVERIFY2(on.viewer.notice.text().startsWith(QString("Split: rock %1 is now rocks ").arg(label)),
                     qPrintable(on.viewer.notice.text()));
            QCOMPARE(picture(on).rockAt(cell)->cells, part);
            on.viewer.undo.undo();
            QVERIFY2(on.viewer.notice.isHidden(), "it is about parts that are whole again");
            on.viewer.rocks.useSettings(study.settings);
            QVERIFY(settled(on));
            break;
        }
        QVERIFY2(any, "no rock of the scene has a small part");
        for (std::size_t n = study.map.rocks + 1; n < study.map.regions.size(); ++n) {
            if (study.map.regions[n].kind != rocks::RegionKind::NotRock) continue;
            const auto* const segments = study.segmentation->segment.cells.data();
            std::size_t wall = 0;
            while (study.map.regionOfSegment[segments[wall]] != n) ++wall;
            on.viewer.rocks.select({study.rocks[1].cell, wall});
            on.viewer.rocks.mergeSelected();
            QVERIFY(settled(on));
            QTest::keyClick(&on.window, Qt::Key_S);
            on.viewer.views.click(inspect::exactly(wall));
            QVERIFY(settled(on));
            const QString text = on.viewer.notice.text();
            QVERIFY2(text.contains("is not shown as a rock: ") &&
                         text.contains("Click it and choose “Not a Rock, or a Rock Again” to show it."),
                     qPrintable(text));
            return;
        }
    }

    // The name of a rock goes to the target on it; without one, a target comes with the name and not with the question.
    // It is done with a notice that names both, the row and the card mark it, and it is split again like any other.
    void rocksThatDoNotTouchAreMergedWithANotice() {
        for (const bool cab : {false, true}) {
            WindowFixture on;
            QVERIFY(showRocks(on));
            const std::uint32_t a = 1;
            std::uint32_t b = 0;
            for (const rocks::Rock& rock : picture(on).study.rocks) {
                const rocks::Rock& first = *picture(on).rock(a);
                const double apart = (rock.centreM - first.centreM).norm();
                if (b == 0 && apart > rock.longestCaliperM + first.longestCaliperM + 0.5) b = rock.label;
            }
            QVERIFY(b != 0);
            const std::size_t cellA = picture(on).rock(a)->cell, cellB = picture(on).rock(b)->cell;
            const Grid<std::uint32_t> before = picture(on).labels;
            const auto one = [&] { return picture(on).regionAt(cellA) == picture(on).regionAt(cellB); };
            const auto merge = [&] {
                on.window.cab().set(cab);
                on.viewer.rocks.select({cellA, cellB});
                on.viewer.rocks.mergeSelected();
                return settled(on) && one();
            };
            QVERIFY(merge());
            const QString text = on.viewer.notice.text();
            QVERIFY2(text.contains(QString("Rocks %1 and %2 do not touch: their nearest cells are ").arg(a).arg(b)), qPrintable(text));
            QVERIFY(on.viewer.notice.isVisible() && on.viewer.notice.kind() == NoticeBar::Kind::Warning);
            const rocks::Rock& merged = *picture(on).rockAt(cellA);
            QCOMPARE(merged.apart.size(), std::size_t{1});
            QVERIFY(picture(on).labelAt(cellA) != 0 && merged.apart.front().distanceM > merged.toleranceM);
            const QString parts = QString("▲ 2 parts that do not touch, %1 m apart").arg(merged.apart.front().distanceM, 0, 'f', 2);
            QVERIFY2(on.viewer.rocksPanel.card().text().contains(parts), qPrintable(on.viewer.rocksPanel.card().text()));
            const auto row = on.viewer.rockTable.findChild<QTableView*>()->model()->index(0, 0);
            QStringList marked;
            for (int n = 0; n < row.model()->rowCount(); ++n) {
                const QModelIndex index = row.sibling(n, 0);
                if (index.data().toString().contains("▲")) marked << index.data().toString() << index.data(Qt::ToolTipRole).toString();
            }
            QCOMPARE(marked, QStringList({QString("%1 ▲").arg(merged.label), parts}));
            // The button of the notice takes it back.
            auto& undo = *on.viewer.notice.findChild<QToolButton*>("notice-action");
            QVERIFY(undo.isVisible());
            QTest::mouseClick(&undo, Qt::LeftButton);
            QVERIFY(settled(on));
            QVERIFY(picture(on).labels == before);
            if (on.window.cab().on()) // which names the step
                QVERIFY2(on.viewer.notice.text().startsWith("Undone: "), qPrintable(on.viewer.notice.text()));
            else
                QVERIFY(on.viewer.notice.isHidden());
            QVERIFY(merge());
            on.window.cab().set(false);
            QVERIFY(settled(on));
            on.viewer.rocks.useTool(RockTool::Split);
            const QPoint pixel = pixelOf(on.viewer.views.gray(), on.viewer.views.placeOf(cellB));
            QTest::mouseClick(&on.viewer.views.gray(), Qt::LeftButton, Qt::NoModifier, pixel);
            QVERIFY(settled(on));
            QVERIFY2(!one(), qPrintable(on.viewer.notice.text()));
            QVERIFY(picture(on).labels == before);
        }
    }

    void rocksThatTouchAreMergedWithoutANotice() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        std::uint32_t a = 0, b = 0;
        for (const rocks::RegionBorder& border : picture(on).study.map.borders) {
            if (a == 0 && border.a != 0 && border.b <= picture(on).study.map.rocks && rocks::touch(border)) a = border.a, b = border.b;
        }
        QVERIFY(a != 0);
        on.viewer.rocks.select({picture(on).rock(a)->cell, picture(on).rock(b)->cell});
        on.viewer.rocks.mergeSelected();
        QVERIFY(settled(on));
        QVERIFY2(!on.viewer.notice.text().contains("touch"), qPrintable(on.viewer.notice.text()));
        QVERIFY(std::ranges::all_of(picture(on).study.rocks, [](const rocks::Rock& rock) { return rock.apart.empty(); }));
    }

    void aRockIsNamedByTheTargetOnIt() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto named = [&](std::uint32_t label, const QString& name) {
            QString question;
            Meanwhile answer([&] {
                auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
                if (dialog == nullptr) return false;
                question = dialog->labelText();
                dialog->setTextValue(name);
                name.isEmpty() ? dialog->reject() : dialog->accept();
                return true;
            });
            // By the menu of the cell, the button of the card, and F2.
            const std::size_t cell = picture(on).rock(label)->cell;
            if (label == 1) {
                on.viewer.targets.askName(inspect::exactly(cell));
            } else {
                on.viewer.views.pin(std::nullopt);
                on.viewer.rocks.select({cell});
                label == 4 ? on.window.findChild<QPushButton*>("rock-name")->click() : on.viewer.targets.editName();
            }
            return question;
        };
        QVERIFY(named(1, "").contains("A new target on it, number 1,"));
        QVERIFY(on.viewer.targets.notebook().empty());
        // The target of the last click stays on its rock.
        click(on, 3, Qt::ShiftModifier);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{1});
        click(on, 2, Qt::ShiftModifier); // another one
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{2});
        QVERIFY(named(4, "Cora").contains("A new target on it, number 3,"));
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{3});
        while (on.viewer.undo.canUndo()) on.viewer.undo.undo();
        QVERIFY(on.viewer.targets.notebook().empty());
        named(1, "Bertha");
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{1});
        named(2, "Anna");
        QVERIFY(named(1, "Berta").startsWith("Name of target 1"));
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{2});
        QCOMPARE(on.viewer.targets.notebook().targets.front().name, std::string("Berta"));
        on.viewer.rocks.select({picture(on).rock(1)->cell});
        const QString card = on.viewer.rocksPanel.card().text();
        QVERIFY2(card.startsWith("Rock 1 Berta\n"), qPrintable(card));
        // A second target on it has a name too: both are the rock's, as in the files.
        const std::uint32_t first = on.viewer.targets.notebook().targets.front().cell;
        std::uint32_t other = first + 1;
        while (picture(on).labelAt(other) != 1) ++other;
        on.viewer.views.pinByClick(inspect::exactly(other));
        on.viewer.targets.rename(on.viewer.targets.active()->number, "hole 7");
        QCOMPARE(on.viewer.rocksPanel.card().text().section('\n', 0, 0), QString("Rock 1 Berta; hole 7"));
    }

    // Of a target that is on the edge next to the click, the card was silent.
    void theCardOfATargetSaysThatItWasMoved() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        const edges::Detection& detection = *on.picture().detection;
        int tried = 0;
        for (const std::uint32_t k : *detection.edges) {
            const inspect::ClickedCell meant = inspect::nearSideEdge(*detection.scan, *detection.mask, k);
            if (!meant.moved() || meant.cell == inspect::nearSideCell(*detection.scan, k).cell || ++tried > 5) continue;
            QCOMPARE(on.viewer.views.nearSideCell(k).cell, meant.cell);
            on.viewer.views.pinByClick(meant);
            QTRY_VERIFY2(on.viewer.targetsPanel.card().text().contains("\nClicked: "), qPrintable(on.viewer.targetsPanel.card().text()));
            on.viewer.targets.removeAll();
        }
        QVERIFY(tried > 0);
    }

    // In a low window the card of a target is longer than its panel: the list is in sight without scrolling.
    void theListOfTargetsIsInSightWithACard() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.size() == QSize(1280, 800)));
        QVERIFY(settled(on));
        for (const std::uint32_t label : {1U, 2U, 3U}) click(on, label, Qt::ShiftModifier);
        QVERIFY(eventually([&] { return on.viewer.targets.settled() && on.viewer.targets.notebook().targets.size() == 3; }));
        const auto* list = on.viewer.targetsPanel.findChild<QListWidget*>("target-list");
        const QWidget& card = on.viewer.targetsPanel.card();
        QVERIFY(eventually([&] { return card.height() >= card.layout()->totalHeightForWidth(card.width()); })); // laid out
        QVERIFY(eventually([&] { return list->isVisible() && list->visibleRegion().boundingRect() == list->rect(); }));
        QVERIFY(list->visualItemRect(list->item(2)).bottom() <= list->viewport()->height());
    }

    void selectingSeveralRocksDoesNotMoveTheCloud() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.width() == 1280));
        QVERIFY(settled(on));
        const auto place = [&] { return QRect(on.viewer.cloud.mapTo(&on.window, QPoint(0, 0)), on.viewer.cloud.size()); };
        on.viewer.rocks.select({picture(on).rock(1)->cell});
        QCoreApplication::processEvents();
        const QRect one = place();
        const QWidget& merge = *on.viewer.rocksPanel.card().merge();
        const int high = merge.y(); // the button does not move under the pointer
        on.viewer.rocks.select({picture(on).rock(1)->cell, picture(on).rock(2)->cell, picture(on).rock(3)->cell});
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        QCOMPARE(place(), one);
        QCOMPARE(merge.y(), high);
        const RockCard& card = on.viewer.rocksPanel.card();
        QVERIFY2(card.minimumSizeHint().width() <= 240, qPrintable(QString::number(card.minimumSizeHint().width())));
    }

    /// The cells of a rock in the cloud, on the screen.
    static std::vector<QPoint> placesOf(WindowFixture& on, std::uint32_t label) {
        std::vector<QPoint> places;
        for (std::uint32_t k = 0; k < picture(on).labels.size(); ++k) {
            const auto at = picture(on).labelAt(k) == label ? on.viewer.cloud.pixelOf(k) : std::nullopt;
            if (at && on.viewer.cloud.rect().contains(at->toPoint())) places.push_back(on.viewer.cloud.mapToGlobal(at->toPoint()));
        }
        return places;
    }

    // The window of a section opens where it covers the least of its rock.
    void aSectionLeavesItsRockInSight() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(showRocks(on));
        for (const rocks::Rock& rock : picture(on).study.rocks) {
            on.viewer.rocks.select({rock.cell});
            const std::vector<QPoint> places = placesOf(on, rock.label);
            if (places.empty()) continue;
            on.viewer.sections.close();
            on.viewer.sections.throughRock();
            QTRY_VERIFY(on.viewer.sections.card() != nullptr && on.viewer.sections.card()->isVisible());
            const QRect card = on.viewer.sections.card()->frameGeometry();
            const int left = on.window.mapToGlobal(QPoint()).x();
            const auto covered = [&](int x) {
                const QRect there(QPoint(x, card.y()), card.size());
                return static_cast<double>(std::ranges::count_if(places, [&](const QPoint& place) { return there.contains(place); }));
            };
            const double slack = 0.05 * static_cast<double>(places.size()); // it looks at some of the cells
            for (const int x : {left, left + on.window.width() - card.width()})
                QVERIFY2(covered(card.x()) <= covered(x) + slack, qPrintable(QString("rock %1 at %2").arg(rock.label).arg(card.x())));
        }
    }

    // What a section asks for is not asked once it is done.
    void aSectionsQuestionGoesWithTheRockThatIsSelected() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        on.viewer.sections.throughRock();
        QVERIFY2(on.viewer.notice.text().contains("Select a rock first"), qPrintable(on.viewer.notice.text()));
        on.viewer.rocks.select({picture(on).study.rocks.front().cell});
        QVERIFY2(!on.viewer.notice.text().contains("Select a rock first"), qPrintable(on.viewer.notice.text()));
        on.window.findChild<QPushButton*>("rock-section")->click(); // where the other commands for a rock are
        QTRY_VERIFY(on.viewer.sections.card() != nullptr && on.viewer.sections.card()->isVisible());
    }

    // A section through a rock opens on the rock; its axes are named, and the message of an export counts what is in it.
    void aSectionThroughARockIsAboutThatRock() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const std::size_t cell = picture(on).rock(3)->cell;
        on.viewer.rocks.select({cell});
        on.viewer.sections.throughRock();
        QTRY_VERIFY(on.viewer.sections.card() != nullptr && on.viewer.sections.card()->isVisible());
        const SectionPlot& plot = on.viewer.sections.card()->plot();
        Eigen::AlignedBox2d rock;
        for (const inspect::SectionLine& line : plot.section()->lines) {
            for (const inspect::SectionVertex& vertex : line) {
                if (vertex.rock == 3) rock.extend(vertex.atM);
            }
        }
        const QRectF shown(plot.placeOf({rock.min().x(), rock.max().y()}), plot.placeOf({rock.max().x(), rock.min().y()}));
        QVERIFY(QRectF(plot.rect()).contains(shown));
        QVERIFY2(shown.width() > 0.35 * plot.width() || shown.height() > 0.35 * plot.height(),
                 qPrintable(QString("%1 x %2 px").arg(shown.width()).arg(shown.height())));
        QVERIFY2(shown.bottom() <= plot.height() - 2 * plot.fontMetrics().height() - 10, "the name of the axis covers the end of the line");
        QCOMPARE(plot.heights().name, QString("above the scanner [m]"));
        const Rgb& face = rocks::kRockFaceColours[picture(on).colours[3]]; // as in the images and the cloud
        const QRgb ink = QColor(face.red, face.green, face.blue).lighter(130).rgb();
        const QImage drawn = on.viewer.sections.card()->plot().grab().toImage().convertToFormat(QImage::Format_RGB32);
        const auto pixelsOf = [](const QImage& image, QRgb colour) {
            return countPixels(image, [colour](QRgb pixel) { return pixel == colour; });
        };
        QVERIFY2(pixelsOf(drawn, ink) > 50, qPrintable(QString::number(pixelsOf(drawn, ink))));
        // The white outline marks this rock alone.
        SectionPlot unmarked;
        unmarked.resize(plot.size());
        unmarked.show(plot.section(), {}, plot.heights(), {picture(on).colours, 0});
        const int white = pixelsOf(unmarked.grab().toImage().convertToFormat(QImage::Format_RGB32), QColor(Qt::white).rgb());
        QVERIFY2(pixelsOf(drawn, QColor(Qt::white).rgb()) > white + 100, qPrintable(QString::number(white)));
        std::set<std::uint32_t> cut;
        for (const inspect::SectionLine& line : plot.section()->lines) {
            for (const inspect::SectionVertex& vertex : line) {
                if (vertex.rock != 0) cut.insert(vertex.rock);
            }
        }
        const inspect::SectionVertex& vertex = plot.section()->lines.front().front();
        QVERIFY(std::abs(plot.heights().ofOriginM + vertex.atM.y() - vertex.pointM.z()) < 1e-9);
        QVERIFY(cut.size() < picture(on).study.rocks.size());
        on.viewer.sections.exportTo(QString::fromStdString((folder_ / "section.dxf").string()));
        QTRY_VERIFY2(on.viewer.notice.text().contains(": a section of " + rockCount(cut.size()) + ","),
                     qPrintable(on.viewer.notice.text()));
    }

    void theLargestRockIsOneCommandAwayAndSoAreTheNext() {
        WindowFixture on;
        QVERIFY(on.showWith(bell_));
        QAction* largest = on.window.findChild<QAction*>("rocks-largest");
        largest->trigger(); // rocks are off: they are computed first
        QVERIFY(settled(on));
        QTRY_VERIFY(!on.viewer.rocks.selected().empty());
        std::vector<double> widths;
        for (const rocks::Rock& rock : picture(on).study.rocks) widths.push_back(rock.shortestCaliperM);
        std::ranges::sort(widths, std::greater());
        const auto selectedWidth = [&] { return picture(on).rockAt(on.viewer.rocks.selected().back())->shortestCaliperM; };
        for (std::size_t n = 0; n < 5; ++n) {
            QCOMPARE(selectedWidth(), widths[n]);
            on.viewer.rocks.lookAtNextSmaller();
        }
        largest->trigger();
        QCOMPARE(selectedWidth(), widths.front());
        // Numbers follow the area: where another rock is rock 1, that is said.
        const std::uint32_t label = picture(on).labelAt(on.viewer.rocks.selected().back());
        QCOMPARE(on.viewer.notice.text().contains(QString("Rock %1 has the largest visible width b").arg(label)), label != 1);
        QVERIFY(on.viewer.targets.notebook().empty());
        // From behind the pile its back would be seen.
        CloudView& behind = on.viewer.views.cloud();
        for (const bool back : {true, false}) {
            back ? behind.viewBack() : behind.viewTop();
            largest->trigger();
            const CloudGeometry& geometry = *behind.geometryOfCloud();
            const Eigen::Vector3d at = geometry.point(on.viewer.rocks.selected().back()).cast<double>();
            QVERIFY((at - behind.camera().position).dot(at - geometry.sensor.cast<double>()) > 0.0);
        }
        // Nothing covers it: with the table, the least room for the cloud.
        for (const QSize size : {QSize(1280, 800), QSize(1600, 900)}) {
            resizeTo(on.window, size);
            CloudView& cloud = on.viewer.views.cloud();
            QTRY_VERIFY(cloud.atRest());
            largest->trigger();
            int asked = 0, under = 0;
            for (const std::uint32_t k : *cloud.outline()) {
                const auto pixel = cloud.geometryOfCloud()->drawable(k) ? cloud.pixelOf(k) : std::nullopt;
                under += pixel && cloud.freePixels()(*pixel) ? 0 : 1;
                ++asked;
            }
            QVERIFY2(10 * under <= asked, qPrintable(QString("%1 of %2").arg(under).arg(asked)));
        }
    }

    void withOneRockSelectedMergeWaitsForAClickOnTheOther() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto [a, b] = neighbours(on);
        const std::size_t cellA = picture(on).rock(a)->cell, cellB = picture(on).rock(b)->cell;
        on.viewer.rocks.select({cellA});
        on.viewer.rocks.mergeSelected();
        QVERIFY(on.viewer.rocks.tool() == RockTool::Join);
        const auto prompts = on.window.findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(prompts, [](const QLabel* each) { return each->isVisible() && each->text().startsWith("Merge: "); }));
        const QList<QAction*> actions = on.window.actions();
        const auto pin = std::ranges::find(actions, QString("&Pin"), &QAction::text);
        QVERIFY(pin != actions.end() && !(*pin)->isChecked()); // a click does not pin now
        (*pin)->trigger();
        QVERIFY(on.viewer.rocks.tool() == RockTool::None && (*pin)->isChecked());
        on.viewer.rocks.mergeSelected();
        click(on, b);
        QVERIFY(on.viewer.rocks.tool() == RockTool::None);
        QVERIFY(settled(on));
        QVERIFY(picture(on).regionAt(cellA) == picture(on).regionAt(cellB));
        QVERIFY(on.viewer.targets.notebook().empty());
        // A click on the selected rock itself joins nothing, and says so until the next step.
        on.viewer.rocks.mergeSelected();
        QVERIFY(on.viewer.rocks.tool() == RockTool::Join);
        click(on, picture(on).labelAt(cellA));
        QVERIFY(on.viewer.notice.text().startsWith("Nothing was merged: draw"));
        on.viewer.undo.undo();
        QVERIFY(on.viewer.notice.isHidden());
        QVERIFY(settled(on));
        QVERIFY(picture(on).regionAt(cellA) != picture(on).regionAt(cellB));
    }

    void aToolOfRocksAndAMeasurementExcludeEachOther() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        on.viewer.rocks.useTool(RockTool::Join);
        QVERIFY(on.viewer.rocks.tool() == RockTool::Join && !on.viewer.measures.kind());
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        QVERIFY(on.viewer.rocks.tool() == RockTool::None && on.viewer.measures.kind());
        on.viewer.rocks.useTool(RockTool::Cut);
        on.viewer.views.setTool(Tool::Lasso);
        QVERIFY(on.viewer.rocks.tool() == RockTool::None);
    }

    void aLineJoinsWhatItCrossesAndAnotherCuts() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        ImageView& view = on.viewer.views.gray();
        const auto [a, b] = neighbours(on);
        const QPoint from = pixelOn(on, view, a), to = pixelOn(on, view, b);
        const auto cellAt = [&](QPoint pixel) {
            const auto cell = view.cellAt(pixel);
            return picture(on).labels.index(cell->y(), cell->x());
        };
        const std::size_t cellA = cellAt(from), cellB = cellAt(to);
        const Grid<std::uint32_t> before = picture(on).labels;
        const QPointF centre = view.viewPort()->toCell(QPointF(0, 0), view.size());
        QTest::keyClick(&on.window, Qt::Key_J);
        QVERIFY(on.viewer.rocks.tool() == RockTool::Join);
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(&view, (from + to) / 2);
        QVERIFY2(!view.trail().cells.empty(), "the line is seen while it is drawn");
        QTest::mouseMove(&view, to);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
        QVERIFY(view.trail().cells.empty());
        QCOMPARE(view.viewPort()->toCell(QPointF(0, 0), view.size()), centre); // the view did not pan
        QVERIFY(on.viewer.rocks.tool() == RockTool::None);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
        QVERIFY(picture(on).regionAt(cellA) == picture(on).regionAt(cellB));
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(settled(on));
        QVERIFY(picture(on).labels == before);

        // The same in the cloud, which does not turn.
        CloudView& cloud = on.viewer.views.cloud();
        const auto first = cloud.pixelOf(static_cast<std::uint32_t>(cellA)), last = cloud.pixelOf(static_cast<std::uint32_t>(cellB));
        QVERIFY(first && last);
        const CameraPose camera = cloud.camera();
        QTest::keyClick(&on.window, Qt::Key_J);
        QTest::mousePress(&cloud, Qt::LeftButton, Qt::NoModifier, first->toPoint());
        for (int n = 1; n <= 10; ++n) QTest::mouseMove(&cloud, (*first + (*last - *first) * n / 10).toPoint());
        QVERIFY(!view.trail().cells.empty());
        QTest::mouseRelease(&cloud, Qt::LeftButton, Qt::NoModifier, last->toPoint());
        QVERIFY(on.viewer.rocks.tool() == RockTool::None && cloud.camera() == camera);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
        QVERIFY(picture(on).regionAt(cellA) == picture(on).regionAt(cellB));
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(settled(on));

        // A line through the largest rock, from side to side.
        const rocks::Rock rock = *picture(on).rock(1);
        const QPoint middle = on.viewer.views.placeOf(rock.cell);
        int left = middle.x(), right = middle.x();
        while (before.contains(middle.y(), left - 1) && before.at(middle.y(), left - 1) == 1) --left;
        while (before.contains(middle.y(), right + 1) && before.at(middle.y(), right + 1) == 1) ++right;
        on.viewer.rocks.select({rock.cell});
        QTest::mouseClick(on.viewer.rocksPanel.card().cut(), Qt::LeftButton);
        QVERIFY(on.viewer.rocks.tool() == RockTool::Cut && on.viewer.rocksPanel.card().cut()->isChecked());
        draw(view,
             {pixelOf(view, {std::max(0, left - 3), middle.y()}), pixelOf(view, {std::min(before.beams - 1, right + 3), middle.y()})});
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.undo.index(), 1);
        QVERIFY(on.viewer.rocks.edits()[0].kind == rocks::EditKind::Cut);
        QVERIFY(!on.viewer.rocksPanel.card().cut()->isChecked());
        const auto over = static_cast<std::size_t>(before.index(middle.y() - 4, middle.x()));
        const auto under = static_cast<std::size_t>(before.index(middle.y() + 4, middle.x()));
        QVERIFY(before[over] == 1 && before[under] == 1);
        QVERIFY(picture(on).regionAt(over) != picture(on).regionAt(under));
        // All of it is two rocks, and the note names both with their sizes.
        std::set<std::uint32_t> parts;
        for (std::size_t k = 0; k < before.size(); ++k) {
            if (before[k] == 1) parts.insert(picture(on).labels[k]);
        }
        QVERIFY(parts.size() > 1 && !parts.contains(0));
        const QString said = on.viewer.notice.text();
        QVERIFY2(said.startsWith("Cut: rock 1 is now rocks "), qPrintable(said));
        for (const std::uint32_t part : parts) {
            const rocks::Rock& one = *picture(on).rock(part);
            const QString named =
                QStringLiteral("%1 (%2 × %3 m)").arg(part).arg(one.longestCaliperM, 0, 'f', 2).arg(one.shortestCaliperM, 0, 'f', 2);
            QVERIFY2(said.contains(named), qPrintable(said + " | " + named));
        }
        on.viewer.undo.undo();
        QVERIFY(settled(on));
        QVERIFY(picture(on).labels == before);

        // Two clicks are the ends of the same line; the first one makes no step, and no click pins. Of several selected rocks a part of the
        // one that is cut is selected.
        on.viewer.rocks.select({rock.cell, picture(on).rock(2)->cell});
        QTest::keyClick(&on.window, Qt::Key_X);
        const QPoint oneEnd = pixelOf(view, {std::max(0, left - 3), middle.y()}),
                     otherEnd = pixelOf(view, {std::min(before.beams - 1, right + 3), middle.y()});
        const int steps = on.viewer.undo.index();
        const std::size_t targets = on.viewer.targets.notebook().targets.size();
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, oneEnd);
        QVERIFY(on.viewer.rocks.tool() == RockTool::Cut && on.viewer.undo.index() == steps);
        QVERIFY2(on.viewer.notice.text().startsWith("Click the other end"), qPrintable(on.viewer.notice.text()));
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, otherEnd);
        QVERIFY(settled(on));
        QVERIFY(on.viewer.rocks.tool() == RockTool::None && on.viewer.undo.index() == steps + 1);
        QVERIFY(on.viewer.rocks.selected().size() == 1 && before[on.viewer.rocks.selected().front()] == 1);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), targets);
        QVERIFY(picture(on).regionAt(over) != picture(on).regionAt(under) && picture(on).labels[over] != 0 &&
                picture(on).labels[under] != 0);
        on.viewer.undo.undo();
        QVERIFY(settled(on));

        // Esc leaves the tool, and a drag pans again.
        QTest::keyClick(&on.window, Qt::Key_X);
        QVERIFY(on.viewer.rocks.tool() == RockTool::Cut);
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(on.viewer.rocks.tool() == RockTool::None);
    }

    void theWheelTakesALargerOrSmallerPiece() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        ImageView& view = on.viewer.views.gray();
        const QPoint at = pixelOn(on, view, 2);
        const auto place = view.cellAt(at);
        const std::size_t cell = picture(on).labels.index(place->y(), place->x());
        const std::uint32_t cells = picture(on).rockAt(cell)->cells;
        QTest::keyClick(&on.window, Qt::Key_S);
        QTest::mouseMove(&view, at);
        QVERIFY(eventually([&] { return view.tip().contains("wheel"); }));
        const double scale = view.viewPort()->cellSize().width();
        QString tip = view.tip();
        for (int n = 0; n < 20 && !tip.contains("larger than the rock"); ++n) {
            QWheelEvent turn(at, view.mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&view, &turn);
            tip = view.tip();
        }
        QVERIFY2(tip.contains("larger than the rock"), qPrintable(tip));
        QCOMPARE(view.viewPort()->cellSize().width(), scale); // the view did not zoom
        QVERIFY(!view.outline().empty());
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, at);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
        QVERIFY(on.viewer.rocks.edits()[0].kind == rocks::EditKind::Join);
        QVERIFY(picture(on).regionAt(cell)->sums.cells > cells);
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(settled(on));
        QCOMPARE(picture(on).regionAt(cell)->sums.cells, cells);
    }

    void twoWindowsOnOneScanLoseNoEdit() {
        const std::string file = (folder_ / "two.json").string();
        QVERIFY(files::saveScan(scan_, file));
        const auto show = [&](WindowFixture& on) {
            on.window.resize(1600, 950);
            if (!on.showWith(file) || !on.activate()) return false;
            QTest::keyClick(&on.window, Qt::Key_K);
            return settled(on);
        };
        const auto makeNoRock = [&](WindowFixture& on, int rock) {
            click(on, rock);
            QTest::keyClick(&on.window, Qt::Key_N);
            return settled(on);
        };
        WindowFixture one;
        QVERIFY(show(one));
        {
            WindowFixture two;
            QVERIFY(show(two));
            QVERIFY(makeNoRock(two, 1));
        }
        QVERIFY(one.activate());
        QVERIFY(makeNoRock(one, 2));
        QTRY_COMPARE(one.viewer.rocks.edits().size(), std::size_t{2});
        QTest::keyClick(&one.window, Qt::Key_Z, Qt::ControlModifier); // takes back its own edit only
        QTRY_COMPARE(one.viewer.rocks.edits().size(), std::size_t{1});
        QVERIFY(settled(one));
    }

    void theExportHasTheRowsOfTheTableInItsOrder() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const auto rows = [&](const char* name, bool all) {
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            const std::string path = (folder_ / name).string();
            on.viewer.rocks.exportTo(QString::fromStdString(path), all);
            if (!saved.wait(kPatienceMs)) return QStringList{on.viewer.notice.text()};
            if (test::runCli("verify '" + path + "'").code != 0) return QStringList{"not verified"};
            QStringList numbers;
            for (const QString& line : QString::fromStdString(test::fileText(path)).split('\n', Qt::SkipEmptyParts).mid(1))
                numbers << line.section(',', 0, 0);
            return numbers;
        };
        RockTable& table = on.viewer.rockTable;
        const std::size_t all = picture(on).study.rocks.size();
        std::vector<double> wide;
        for (const rocks::Rock& rock : picture(on).study.rocks) wide.push_back(rock.shortestCaliperM);
        std::ranges::nth_element(wide, wide.begin() + static_cast<std::ptrdiff_t>(wide.size() / 2));
        table.smallest()->setValue(wide[wide.size() / 2]);
        table.table()->sortByColumn(0, Qt::DescendingOrder);
        QStringList shown;
        for (int row = 0; row < table.table()->model()->rowCount(); ++row) shown << table.table()->model()->index(row, 0).data().toString();
        QVERIFY(shown.size() > 1 && static_cast<std::size_t>(shown.size()) < all);
        QCOMPARE(rows("listed.csv", false), shown);
        QCOMPARE(static_cast<std::size_t>(rows("every.csv", true).size()), all);
        for (const char* name : {"listed.dxf", "listed.ply"}) {
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            const std::string path = (folder_ / name).string();
            on.viewer.rocks.exportTo(QString::fromStdString(path));
            QVERIFY2(saved.wait(kPatienceMs), qPrintable(on.viewer.notice.text()));
            QVERIFY2(on.viewer.notice.text().contains(QString::number(shown.size()) + " rocks"), qPrintable(on.viewer.notice.text()));
            QCOMPARE(test::runCli("verify '" + path + "'").code, 0);
        }
    }

    void regionAndEditsAreThereAgainWhenTheScanIsOpenedAgain() {
        const std::string file = (folder_ / "kept.json").string();
        QVERIFY(files::saveScan(scan_, file));
        const std::filesystem::path sidecar = rocks::rockPresetPath(file);
        Grid<std::uint32_t> labels;
        const auto showKept = [&](WindowFixture& on) {
            on.window.resize(1600, 950);
            if (!on.showWith(file) || !on.activate()) return false;
            QTest::keyClick(&on.window, Qt::Key_K);
            return settled(on);
        };
        {
            WindowFixture on;
            QVERIFY(showKept(on));
            QVERIFY(!std::filesystem::exists(sidecar));
            const std::size_t all = picture(on).study.rocks.size();
            ImageView& view = on.viewer.views.gray();
            QTest::keyClick(&on.window, Qt::Key_G);
            draw(view, {pixelOf(view, {80, 60}), pixelOf(view, {380, 60}), pixelOf(view, {380, 340}), pixelOf(view, {80, 340}),
                        pixelOf(view, {80, 62})});
            QVERIFY(settled(on));
            const rocks::RockSettings& settings = on.viewer.rocks.settings();
            QVERIFY2(settings.region.size() >= 4 && settings.region.size() < 12, qPrintable(QString::number(settings.region.size())));
            QVERIFY(picture(on).study.rocks.size() < all);
            QVERIFY2(on.viewer.rocksPanel.text().contains("outside the region of interest"), qPrintable(on.viewer.rocksPanel.text()));
            click(on, 1);
            QTest::keyClick(&on.window, Qt::Key_N);
            QVERIFY(settled(on));
            on.viewer.rocksPanel.slider()->setFocus();
            QTest::keyClick(on.viewer.rocksPanel.slider(), Qt::Key_PageUp);
            QVERIFY(settled(on));
            labels = picture(on).labels;
        }
        QVERIFY2(std::filesystem::exists(sidecar), "the window is closed, and nothing is lost");
        {
            WindowFixture on;
            QVERIFY(showKept(on));
            QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
            QVERIFY(picture(on).labels == labels);
            // The command line reads the same file.
            const auto run = test::runCli("rocks '" + file + "' --edits '" + sidecar.string() + "' --json -");
            QVERIFY2(run.code == 0, run.err.c_str());
            QCOMPARE(nlohmann::json::parse(run.out)["rock_count"].get<std::size_t>(), picture(on).study.rocks.size());
            // Another scan has no such edits.
            QVERIFY(on.open(bell_));
            QVERIFY(settled(on));
            QVERIFY(on.viewer.rocks.edits().empty());
            QVERIFY(on.viewer.rocks.settings().region.empty());
            // After the operator's undo no sidecar is needed.
            QVERIFY(on.open(file));
            QVERIFY(settled(on));
            QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
            on.viewer.rocks.setOperatorEdits({});
            QVERIFY(settled(on));
        }
        QVERIFY(!std::filesystem::exists(sidecar));
        // The sidecar of another scan is reported, not changed and not overwritten.
        const std::string other =
            rocks::rockPresetText({std::nullopt, {{rocks::EditKind::Rock, {3}}}, "0123"}, scan_.lines(), scan_.beams());
        QVERIFY(writeWholeFile(sidecar, other));
        {
            WindowFixture on;
            QVERIFY(showKept(on));
            QVERIFY(on.viewer.rocks.edits().empty());
            QVERIFY2(on.window.findChild<NoticeBar*>()->text().contains("other content"),
                     qPrintable(on.window.findChild<NoticeBar*>()->text()));
            click(on, 1);
            QTest::keyClick(&on.window, Qt::Key_N);
            QVERIFY(settled(on));
        }
        QCOMPARE(test::fileText(sidecar), other);
    }

    // Edits are read and written again after another scan was on the screen, of which no rocks were shown. A scan that cannot be opened
    // changes nothing of the picture that stays.
    void editsAreThereAgainAfterAScanWithoutRocks() {
        const std::string file = (folder_ / "first.json").string(), broken = (folder_ / "broken.pcd").string();
        QVERIFY(files::saveScan(scan_, file));
        QVERIFY(writeWholeFile(broken, "# .PCD v0.7\nVERSION 0.7\nFIELDS x\n"));
        const auto ask = [](WindowFixture& on, const std::string& path) { // as Open… does
            on.window.sessions().open({QString::fromStdString(path)});
            return eventually([&] { return on.viewer.files.path() == QString::fromStdString(path); }) && on.settled();
        };
        const auto notARock = [](WindowFixture& on) {
            click(on, picture(on).study.rocks.front().label);
            QTest::keyClick(&on.window, Qt::Key_N);
            return settled(on);
        };
        WindowFixture on;
        on.window.resize(1600, 950);
        QVERIFY(on.showWith(file) && on.activate());
        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(settled(on) && notARock(on));
        const auto stored = [&] {
            const auto preset = rocks::readRockPreset(rocks::rockPresetPath(file), scan_);
            return preset ? preset->edits.size() : std::size_t{0};
        };
        QTRY_COMPARE(stored(), std::size_t{1});
        on.window.sessions().open({QString::fromStdString(broken)});
        QTRY_COMPARE(on.viewer.notice.kind(), NoticeBar::Kind::Error);
        QVERIFY(!on.viewer.engine.opening());
        QVERIFY2(on.viewer.rocks.shown() && on.viewer.rocks.picture(), "a refused scan takes nothing from the picture");
        QVERIFY(ask(on, bell_));
        QVERIFY(!on.viewer.rocks.shown());
        QVERIFY(ask(on, file));
        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
        QVERIFY(notARock(on));
        QTRY_COMPARE(stored(), std::size_t{2});
    }

    void aRockIsCalledNoneAndOneAgain() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        const std::size_t cell = picture(on).rock(2)->cell;
        choose(on, 2);
        QTest::mouseClick(on.viewer.rocksPanel.card().rockOrNot(), Qt::LeftButton);
        QVERIFY(settled(on));
        QCOMPARE(picture(on).labelAt(cell), 0U);
        QVERIFY2(on.viewer.rocksPanel.card().text().contains("marked by hand as not a rock"),
                 qPrintable(on.viewer.rocksPanel.card().text()));
        QTest::mouseClick(on.viewer.rocksPanel.card().rockOrNot(), Qt::LeftButton);
        QVERIFY(settled(on));
        QVERIFY(picture(on).labelAt(cell) != 0);
        QVERIFY(picture(on).rockAt(cell)->byHand);
    }

    void exportsEqualThoseOfTheCommandLine() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        click(on, 2);
        QTest::keyClick(&on.window, Qt::Key_N);
        rocks::RockSettings settings;
        settings.level = 1.5;
        settings.minimumCells = 150;
        on.viewer.rocks.useSettings(settings);
        QVERIFY(settled(on));
        const RockPicture& shown = picture(on);
        const auto place = [&](const char* name) { return (folder_ / name).string(); };
        const std::string edits = place("edits.json");
        QVERIFY(writeWholeFile(edits, rocks::rockEditsToJson(shown.study.edits, shown.labels.lines, shown.labels.beams).dump()));
        const auto run = test::runCli("rocks '" + bell_ + "' --level 1.5 --min-cells 150 --edits '" + edits + "' --labels '" +
                                      place("cli.png") + "' --csv '" + place("cli.csv") + "'");
        QVERIFY2(run.code == 0, run.err.c_str());
        for (const char* ending : {"csv", "json", "png", "dxf", "ply", "obj"}) {
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            const std::string path = place("window.") + ending;
            on.viewer.rocks.exportTo(QString::fromStdString(path), true); // the order of the table is not that of the command line
            QVERIFY2(saved.wait(kPatienceMs), qPrintable(on.viewer.notice.text()));
            QVERIFY2(on.viewer.notice.text().contains(QString::fromStdString(path)), qPrintable(on.viewer.notice.text()));
            QCOMPARE(test::runCli("verify '" + path + "'").code, 0);
        }
        QCOMPARE(test::fileText(place("window.csv")), test::fileText(place("cli.csv")));
        const QImage byWindow(QString::fromStdString(place("window.png"))), byCli(QString::fromStdString(place("cli.png")));
        QCOMPARE(byWindow.format(), QImage::Format_Grayscale16);
        QCOMPARE(byWindow, byCli);
        for (int line = 0; line < byWindow.height(); ++line) {
            const auto* row = reinterpret_cast<const quint16*>(byWindow.constScanLine(line));
            for (int beam = 0; beam < byWindow.width(); ++beam) QCOMPARE(std::uint32_t{row[beam]}, shown.labels.at(line, beam));
        }
        // The table has the names of the targets, and is verified with them.
        on.viewer.views.pinByClick(inspect::exactly(picture(on).study.rocks.front().cell));
        QVERIFY(on.viewer.targets.active() != nullptr);
        on.viewer.targets.rename(on.viewer.targets.active()->number, "keystone, left");
        QSignalSpy saved(&on.viewer.engine, &Engine::saved);
        on.viewer.rocks.exportTo(QString::fromStdString(place("named.csv")));
        QVERIFY2(saved.wait(kPatienceMs), qPrintable(on.viewer.notice.text()));
        const std::string named = test::fileText(place("named.csv"));
        QVERIFY(named.find(",names,up_assumed\n") != std::string::npos);
        QVERIFY(named.find(",\"keystone, left\",") != std::string::npos);
        QCOMPARE(test::runCli("verify '" + place("named.csv") + "'").code, 0);
        on.viewer.rocks.exportTo(QString::fromStdString(place("window.xls")));
        QCOMPARE(on.viewer.notice.kind(), NoticeBar::Kind::Error);
    }

    void theReportEqualsThatOfTheCommandLine() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        click(on, 2);
        QTest::keyClick(&on.window, Qt::Key_N);
        QVERIFY(settled(on));
        on.viewer.targets.removeAll(); // nothing keeps them here, and the command line knows them from their file alone
        const std::string page = (folder_ / "window.html").string();
        QSignalSpy ended(&on.viewer.report, &ScanReport::ended);
        on.viewer.report.writeTo(QString::fromStdString(page));
        QVERIFY(on.viewer.report.working());
        QVERIFY(ended.wait(kPatienceMs));
        QVERIFY2(on.viewer.notice.kind() == NoticeBar::Kind::Done, qPrintable(on.viewer.notice.text()));
        const QString text = QString::fromStdString(test::fileText(page));
        QVERIFY(text.contains(QString("%1 rocks, each a ").arg(picture(on).study.rocks.size()) + rockCaveat()));
        // Its command makes the same page again, except for the time.
        const QRegularExpressionMatch command = QRegularExpression("<pre id=\"command\">edgescan-cli ([^<]*)</pre>").match(text);
        QVERIFY(command.hasMatch());
        std::filesystem::rename(page, folder_ / "before.html");
        QVERIFY(eventually([&] { return std::filesystem::exists(rocks::rockPresetPath(bell_)); }));
        const QString started = QDir::currentPath(); // the command has names without folders
        QVERIFY(QDir::setCurrent(QString::fromStdString(folder_.path().string())));
        const auto run = test::runCli(command.captured(1).replace("&#39;", "'").toStdString());
        QVERIFY(QDir::setCurrent(started));
        QVERIFY2(run.code == 0, (run.err + command.captured(1).toStdString()).c_str());
        const QRegularExpression made("<dt>Made</dt><dd>[^<]*</dd>");
        const auto plain = [&](QString html) { return html.remove(made).replace("&#39;default&#39;", "default"); };
        const QString one = plain(text), other = plain(QString::fromStdString(test::fileText(page)));
        const auto differ = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
        const auto from = std::max<qsizetype>(0, differ.first - one.begin() - 60);
        QVERIFY2(one == other,
                 qPrintable("here: " + one.mid(static_cast<int>(from), 160) + "\nthere: " + other.mid(static_cast<int>(from), 160)));
    }

    void filesThatNeedRocksWaitForThem() {
        WindowFixture on;
        const auto place = [&](const char* name) { return QString::fromStdString((folder_ / name).string()); };
        on.viewer.rocks.setShown(true); // of no scan
        on.viewer.rocks.exportTo(place("none.csv"));
        QVERIFY2(on.viewer.notice.text().contains(place("none.csv")), qPrintable(on.viewer.notice.text()));
        on.viewer.rocks.setShown(false);
        QVERIFY(on.open(bell_));
        QSignalSpy saved(&on.viewer.engine, &Engine::saved), ended(&on.viewer.report, &ScanReport::ended);
        on.viewer.rocks.setShown(true);
        QVERIFY(on.viewer.rocks.behind());
        on.viewer.rocks.exportTo(place("waited.csv"));
        on.viewer.report.writeTo(place("waited.html"));
        QVERIFY(saved.isEmpty() && ended.isEmpty());
        QVERIFY(on.viewer.engine.works().newest() != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!saved.isEmpty() && !ended.isEmpty(), kPatienceMs);
        QVERIFY(test::fileText((folder_ / "waited.html").string()).find(" rocks, each a ") != std::string::npos);
        QVERIFY(settled(on));
        const auto lines = test::fileText((folder_ / "waited.csv").string());
        QCOMPARE(static_cast<std::size_t>(std::ranges::count(lines, '\n')), picture(on).study.rocks.size() + 1);
        // Those that were shown only for a report go when it has them.
        ended.clear();
        on.viewer.report.writeTo(place("alone.html"), {}, false);
        QVERIFY(!on.viewer.rocks.shown());
        QTRY_VERIFY_WITH_TIMEOUT(!ended.isEmpty(), kPatienceMs);
        QVERIFY(test::fileText((folder_ / "alone.html").string()).find(" rocks, each a ") != std::string::npos);
        on.viewer.rocks.setShown(true);
        QVERIFY(settled(on));
        // Cancelled, and without rocks.
        rocks::RockSettings settings = on.viewer.rocks.settings();
        settings.minimumCells += 10;
        on.viewer.rocks.useSettings(settings);
        QVERIFY(on.viewer.rocks.behind());
        on.viewer.rocks.exportTo(place("cancelled.csv"));
        QVERIFY(on.viewer.engine.works().cancel());
        on.viewer.rocks.exportTo(place("refused.csv"));
        on.viewer.rocks.setShown(false);
        QVERIFY2(on.viewer.notice.text().contains(place("refused.csv")), qPrintable(on.viewer.notice.text()));
        QVERIFY(eventually([&] { return !on.viewer.engine.behind(); }));
        QVERIFY(!QFile::exists(place("refused.csv")) && !QFile::exists(place("cancelled.csv")));
    }

    void anotherScanHasRocksOfItsOwn() {
        WindowFixture on;
        QVERIFY(showRocks(on));
        click(on, 2);
        QTest::keyClick(&on.window, Qt::Key_N);
        QVERIFY(settled(on));
        QCOMPARE(on.viewer.rocks.edits().size(), std::size_t{1});
        const std::string other = (folder_ / "other.json").string();
        QVERIFY(files::saveScan(scan_, other));
        QVERIFY(on.open(other));
        QVERIFY(settled(on));
        QVERIFY(on.viewer.rocks.edits().empty());
        QVERIFY(on.viewer.rocks.selected().empty());
        QVERIFY(on.activate());
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier); // a step of the closed scan: no effect
        QVERIFY(settled(on));
        QVERIFY(on.viewer.rocks.edits().empty());
    }

    // A scan that is read again keeps the steps of its rocks.
    void undoAfterReadingAgainIsOfThisScan() {
        WindowFixture on;
        const std::string other = (folder_ / "undone.json").string();
        QVERIFY(files::saveScan(scan_, other));
        QVERIFY(showRocks(on));
        QVERIFY(on.open(other));
        on.viewer.tuning.setParameter("sensitivity", 1.4);
        QVERIFY(on.settled());
        on.viewer.tuning.reset({});
        QVERIFY(on.settled() && on.viewer.undo.canUndo());
        QVERIFY(on.open(bell_));
        QVERIFY(eventually([&] { return !on.viewer.rocks.behind() && on.viewer.rocks.picture() != nullptr; }));
        click(on, 2);
        QTest::keyClick(&on.window, Qt::Key_N);
        QTRY_COMPARE(static_cast<int>(on.viewer.rocks.edits().size()), 1);
        const QString step = on.viewer.undo.undoText();
        on.viewer.files.reload();
        QVERIFY(on.settled() && eventually([&] { return !on.viewer.rocks.behind(); }));
        QApplication::processEvents();
        QCOMPARE(static_cast<int>(on.viewer.rocks.edits().size()), 1);
        QCOMPARE(on.viewer.undo.undoText(), step);
        on.viewer.undo.undo();
        QVERIFY(on.viewer.rocks.edits().empty());
    }

    // The rocks were hidden before the next scan was opened.
    void theEditsOfAClosedScanStayInTheirFile() {
        const std::filesystem::path sidecar = rocks::rockPresetPath(bell_);
        std::string written;
        {
            WindowFixture on;
            QVERIFY(showRocks(on));
            click(on, 2);
            QTest::keyClick(&on.window, Qt::Key_N);
            QVERIFY(eventually([&] { return std::filesystem::exists(sidecar); }));
            written = test::fileText(sidecar);
            on.viewer.rocks.setShown(false);
            const std::string other = (folder_ / "next.json").string();
            QVERIFY(files::saveScan(scan_, other));
            QVERIFY(on.open(other));
            rocks::RockSettings others = on.viewer.rocks.settings();
            others.minimumCells += 50;
            on.viewer.rocks.change(others);
        }
        QVERIFY(std::filesystem::exists(sidecar));
        QCOMPARE(test::fileText(sidecar), written);
    }

    // A sweep may begin far at a side: its first lines are in the view at once, and the whole of it later, after one move of the camera.
    void theFirstLinesOfASweepAreInTheView() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.show());
        const std::uint64_t stream = Engine::newStream();
        const CloudView& cloud = on.viewer.views.cloud();
        std::vector<CameraPose> poses;
        for (const int count : {2, 5, 10, 20, 35, 60, 100, 200, 300, scan_.lines()}) {
            on.viewer.engine.follow(std::make_shared<const Scan>(firstLines(count)), {stream, {0, count < scan_.lines(), scan_.lines()}});
            QVERIFY(on.settled());
            QTRY_VERIFY(cloud.scan() && cloud.scan()->lines() == count);
            std::size_t valid = 0, inView = 0;
            for (std::size_t k = 0; k < cloud.scan()->cells(); k += 7) {
                if (cloud.scan()->state[k] != CellState::Valid) continue;
                const auto at = cloud.pixelOf(static_cast<std::uint32_t>(k));
                ++valid;
                inView += at && QRectF(cloud.rect()).contains(*at) ? 1 : 0;
            }
            QVERIFY2(valid > 0 && 10 * inView >= valid, qPrintable(QString("%1: %2 of %3").arg(count).arg(inView).arg(valid)));
            if (poses.empty() || !(poses.back() == cloud.camera())) poses.push_back(cloud.camera());
        }
        QVERIFY2(poses.size() <= 10, qPrintable(QString::number(poses.size())));
    }

    void rocksFollowASweepThatGrows() {
        WindowFixture on;
        on.window.resize(1600, 950);
        QVERIFY(on.show());
        on.viewer.rocks.setShown(true);
        const std::uint64_t stream = Engine::newStream();
        std::vector<int> lines;
        QObject::connect(&on.viewer.rocks, &Rocks::rocksShown, &on.window, [&] { lines.push_back(picture(on).labels.lines); });
        for (int count = 200; count <= scan_.lines(); count += 40) {
            on.viewer.engine.follow(std::make_shared<const Scan>(firstLines(count)), {stream, {0, count < scan_.lines(), scan_.lines()}});
            QVERIFY(on.settled());
            QTRY_VERIFY(on.viewer.rocks.picture()); // rocks of the first lines, perhaps not yet of these
            const QString title = on.viewer.rocksPanel.text();
            const QString upTo = QString("of the first %1 lines").arg(picture(on).labels.lines); // not those of the strip
            if (count < scan_.lines()) QVERIFY2(title.contains(upTo), qPrintable(title));
            if (picture(on).labels.lines < count) QVERIFY(on.viewer.views.gray().facesFaded());
        }
        QVERIFY(settled(on));
        QCOMPARE(picture(on).labels.lines, scan_.lines());
        QVERIFY(!on.viewer.views.gray().facesFaded());
        QVERIFY(!on.viewer.rocksPanel.text().contains("of the first"));
        QVERIFY2(lines.size() >= 2 && lines.front() < scan_.lines(), "there were rocks before the sweep was whole");
    }

private:
    // An unfinished sweep.
    [[nodiscard]] Scan firstLines(int lines) const {
        Scan scan = scan_;
        const auto cut = [&](auto& grid) {
            if (grid.size() == 0) return;
            grid.cells.resize(static_cast<std::size_t>(lines) * static_cast<std::size_t>(grid.beams));
            grid.lines = lines;
        };
        cut(scan.rangeMm);
        cut(scan.state);
        std::get<PolarGeometry>(scan.geometry).lineDeg.resize(static_cast<std::size_t>(lines));
        return scan;
    }
};

int rocks_window_test(int argc, char** argv) { return runWindowTest<RocksWindowTest>(argc, argv); }

#include "rocks_window_test.moc"
