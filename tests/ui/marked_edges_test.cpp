// "This is an edge, this is not" in the real window: marks by keys, proposals previewed and adopted; range gate, tape and throat.
#include "core/inspect/measure/throat.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/proposals_card.h"
#include "ui/window/tool_bar.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>

#include <algorithm>

using namespace edgescan;
using namespace edgescan::ui;

class MarkedEdgesTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string bell_, slot_;

    static bool showWith(WindowFixture& on, const std::string& path) {
        on.window.resize(1400, 900);
        return on.showWith(path) && on.activate();
    }
    static QAction* action(WindowFixture& on, const QString& text) {
        for (QAction* each : on.window.findChildren<QAction*>()) {
            if (each->text().remove('&') == text) return each;
        }
        return nullptr;
    }
    static void click(ImageView& view, int line, int beam) {
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier,
                          view.viewPort()->toPixel(QPointF(beam + 0.5, line + 0.5), view.size()).toPoint());
    }
    // The controller pins the cell, so that it is exact; the key marks it.
    static void markByKey(WindowFixture& on, std::size_t cell, Qt::Key key) {
        on.viewer.views.pin(cell);
        QTest::keyClick(&on.window, key, Qt::ShiftModifier);
    }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = 150;
        settings.beams = 190;
        bell_ = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, bell_)));
        settings.scene = "wall";
        settings.hole = sim::WallHole::Square;
        settings.holeM = 1.5;
        settings.distanceM = 5.0;
        settings.noise = 0.0;
        settings.dropouts = settings.dust = 0.0;
        settings.absorbingPatches = 0;
        settings.lines = settings.beams = 400;
        slot_ = (folder_ / "slot.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, slot_)));
    }

    void removedMarksAreNamedAndComeBackByTheirNotice() {
        WindowFixture on;
        QVERIFY(showWith(on, bell_));
        const std::size_t cell = 20 * 190 + 30;
        on.viewer.markedEdges.mark(cell, true);
        on.viewer.markedEdges.mark(cell + 1, false);
        const edges::EdgeMarks before = on.viewer.markedEdges.part();
        auto& undo = *on.viewer.notice.findChild<QToolButton*>("notice-action");
        on.viewer.markedEdges.mark(cell, true); // once more: no mark
        QVERIFY2(on.viewer.notice.text().contains("line 20, beam 30"), qPrintable(on.viewer.notice.text()));
        QTest::mouseClick(&undo, Qt::LeftButton);
        QVERIFY(on.viewer.markedEdges.part() == before && on.viewer.notice.isHidden());
        on.viewer.markedEdges.clear();
        QVERIFY2(on.viewer.notice.text().contains("1 “edge” and 1 “not an edge”"), qPrintable(on.viewer.notice.text()));
        QTest::mouseClick(&undo, Qt::LeftButton);
        QVERIFY(on.viewer.markedEdges.part() == before);
    }

    void marksBecomeSettingsThatAgree() {
        WindowFixture on;
        QVERIFY(showWith(on, bell_));
        edges::Settings loose = on.viewer.engine.settings();
        loose.sensitivity = 0.4;
        const Grid<std::uint8_t> usual = *on.picture().detection->mask;
        QVERIFY(on.use(loose));
        const Grid<std::uint8_t> more = *on.picture().detection->mask;
        const auto near = [](const Grid<std::uint8_t>& mask, std::size_t k) {
            const int line = static_cast<int>(k) / mask.beams, beam = static_cast<int>(k) % mask.beams;
            for (int i = line - 2; i <= line + 2; ++i) {
                for (int j = beam - 2; j <= beam + 2; ++j) {
                    if (mask.contains(i, j) && mask.at(i, j) != 0) return true;
                }
            }
            return false;
        };
        std::vector<std::size_t> wanted, unwanted;
        for (std::size_t k = 5000; k < usual.size(); k += 37) {
            if (wanted.size() < 3 && usual[k] != 0) wanted.push_back(k);
            if (unwanted.size() < 2 && more[k] != 0 && !near(usual, k)) unwanted.push_back(k);
        }
        QVERIFY(wanted.size() == 3 && unwanted.size() == 2);
        action(on, "Settings for These Marks…")->trigger();
        QVERIFY2(on.viewer.notice.text().contains("Nothing is marked"), qPrintable(on.viewer.notice.text()));
        for (const std::size_t k : wanted) markByKey(on, k, Qt::Key_E);
        for (const std::size_t k : unwanted) markByKey(on, k, Qt::Key_X);
        markByKey(on, wanted.front(), Qt::Key_X); // wrong at first, then corrected
        markByKey(on, wanted.front(), Qt::Key_E);
        QCOMPARE(on.viewer.markedEdges.part().wanted.size(), std::size_t{3});
        QCOMPARE(on.viewer.markedEdges.part().unwanted.size(), std::size_t{2});
        // The marks appear at their cells in all views, with different icons and words.
        const auto& tags = on.viewer.views.cloud().marks().targets;
        QCOMPARE(std::ranges::count_if(tags, [](const TargetMark& mark) { return mark.tag == "✓ edge"; }), 3);
        QCOMPARE(std::ranges::count_if(tags, [](const TargetMark& mark) { return mark.tag == "✕ not an edge"; }), 2);
        action(on, "Settings for These Marks…")->trigger();
        ProposalsCard* card = on.viewer.markedEdges.card();
        // Running work is visible at once, and Esc cancels it.
        QVERIFY(card != nullptr && card->isVisible() && card->working());
        QVERIFY2(card->verdict().contains("method 1 of"), qPrintable(card->verdict()));
        QTest::keyClick(card, Qt::Key_Escape);
        QVERIFY(eventually([&] { return on.viewer.markedEdges.settled(); }));
        QVERIFY(!card->isVisible() && card->list()->count() == 0);
        action(on, "Settings for These Marks…")->trigger();
        QVERIFY(eventually([&] { return on.viewer.markedEdges.settled(); }));
        QVERIFY(card != nullptr && card->isVisible());
        QVERIFY2(card->verdict().contains("agree with all marks"), qPrintable(card->verdict()));
        QVERIFY2(card->list()->item(0)->text().contains("all 5 marks"), qPrintable(card->list()->item(0)->text()));
        // A click previews; closing restores the former settings.
        const auto choose = [&](int row) {
            QTest::mouseClick(card->list()->viewport(), Qt::LeftButton, Qt::NoModifier,
                              card->list()->visualItemRect(card->list()->item(row)).center());
            return on.settled();
        };
        QVERIFY(choose(0));
        QVERIFY(!(on.viewer.engine.settings() == loose));
        for (const std::size_t k : wanted) QVERIFY(near(*on.picture().detection->mask, k));
        for (const std::size_t k : unwanted) QVERIFY(!near(*on.picture().detection->mask, k));
        QVERIFY(choose(1));
        QTest::keyClick(card, Qt::Key_Escape);
        QVERIFY(on.settled());
        QVERIFY(on.viewer.engine.settings() == loose);
        // Adoption is one undo step.
        action(on, "Settings for These Marks…")->trigger();
        QVERIFY(eventually([&] { return on.viewer.markedEdges.settled() && card->isVisible(); }));
        QVERIFY(choose(0));
        const edges::Settings previewed = on.viewer.engine.settings();
        QTest::mouseClick(card->adopt(), Qt::LeftButton);
        QVERIFY(on.settled() && on.viewer.engine.settings() == previewed && !card->isVisible());
        on.viewer.undo.undo();
        QVERIFY(on.settled() && on.viewer.engine.settings() == loose);
        // Marks of another scan are not shown on this one.
        QVERIFY(on.open(slot_));
        QVERIFY(on.viewer.markedEdges.part().empty());
    }

    void theRangeGateHidesInAllViewsAndCanBeTakenBack() {
        WindowFixture on;
        QVERIFY(showWith(on, bell_));
        const Scan& scan = *on.picture().detection->scan;
        const inspect::CellSet beyond = inspect::cellsBeyond(scan, 4.0, 6.0);
        QVERIFY(beyond.size() > 100);
        const auto edges = on.picture().detection->edges->size();
        const Meanwhile hand([] {
            auto* dialog = QApplication::activeModalWidget();
            if (dialog == nullptr || !dialog->isVisible()) return false;
            dialog->findChild<QDoubleSpinBox*>("gate-near")->setValue(4.0);
            dialog->findChild<QDoubleSpinBox*>("gate-far")->setValue(6.0);
            QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
            return true;
        });
        QTest::keyClick(&on.window, Qt::Key_G, Qt::ShiftModifier);
        QVERIFY(on.activate()); // without a window manager the closed dialog leaves no window active
        QVERIFY(on.viewer.selection.hidden() == beyond);
        for (const std::uint32_t k : beyond) QVERIFY(!on.viewer.views.cloud().geometryOfCloud()->drawable(k));
        QVERIFY(on.viewer.views.gray().selection() != nullptr);
        QVERIFY2(on.viewer.tools.shown().contains("hidden"), qPrintable(on.viewer.tools.shown()));
        QCOMPARE(on.picture().detection->edges->size(), edges);
        on.viewer.undo.undo();
        QVERIFY(on.viewer.selection.hidden().empty());
        // The box around the selection.
        const inspect::CellSet some{14000, 14010, 15900};
        on.viewer.selection.select(some);
        action(on, "Clip to Box round Selected")->trigger();
        QVERIFY(on.viewer.selection.hidden() == inspect::cellsOutsideBoxOf(scan, some));
        QVERIFY(!on.viewer.selection.hidden().empty());
        QTest::keyClick(&on.window, Qt::Key_I, Qt::ControlModifier);
        QVERIFY(on.viewer.selection.hidden().empty());
        on.viewer.views.pin(14000);
        action(on, "Hide Farther than This Cell")->trigger();
        QVERIFY(on.viewer.selection.hidden() == inspect::cellsBeyond(scan, 0.0, static_cast<double>(scan.rangeMm[14000]) / 1000.0));
    }

    void tapeAndThroatAreMeasuredByClicks() {
        WindowFixture on;
        QVERIFY(showWith(on, slot_));
        const Scan& scan = *on.picture().detection->scan;
        const int line = scan.lines() / 2;
        int first = scan.beams() / 2, last = first; // of the hole, along the middle line
        while (scan.state.at(line, first - 1) != CellState::Valid) --first;
        while (scan.state.at(line, last + 1) != CellState::Valid) ++last;
        QVERIFY(last > first);
        on.viewer.views.gray().viewPort()->fitTo(QRectF(first - 70, line - 60, last - first + 140, 120)); // so that a click meets its cell
        QTest::keyClick(&on.window, Qt::Key_Y, Qt::ShiftModifier);
        click(on.viewer.views.gray(), line, first - 3);
        click(on.viewer.views.gray(), line, last + 3);
        QVERIFY(eventually([&] { return on.viewer.targets.settled() && on.viewer.targets.notebook().measures.size() == 1; }));
        const inspect::StoredMeasure& throat = on.viewer.targets.notebook().measures.front();
        QVERIFY(throat.kind == inspect::MeasureKind::Throat);
        const auto measured = inspect::measureCells(scan, {}, inspect::MeasureKind::Throat, throat.cells);
        const CartesianTables tables(scan);
        const double spacing = (tables.point(line, first - 1) - tables.point(line, first - 2)).norm();
        QVERIFY2(std::abs(measured->lengths.front().valueM - 1.5) < 2.5 * spacing + 0.04,
                 qPrintable(QString::number(measured->lengths.front().valueM)));
        QTest::keyClick(&on.window, Qt::Key_U, Qt::ShiftModifier);
        click(on.viewer.views.gray(), line, first - 60);
        click(on.viewer.views.gray(), line, first - 10);
        QVERIFY(eventually([&] { return on.viewer.targets.settled() && on.viewer.targets.notebook().measures.size() == 2; }));
        QVERIFY(on.viewer.targets.notebook().measures.back().kind == inspect::MeasureKind::Path);
        // Two cells of the plain wall enclose no throat.
        QTest::keyClick(&on.window, Qt::Key_Y, Qt::ShiftModifier);
        click(on.viewer.views.gray(), line, first - 60);
        click(on.viewer.views.gray(), line, first - 30);
        QTRY_VERIFY2(on.viewer.notice.text().contains("No opening"), qPrintable(on.viewer.notice.text()));
        QCOMPARE(on.viewer.targets.notebook().measures.size(), std::size_t{2});
    }
};

int marked_edges_test(int argc, char** argv) { return runWindowTest<MarkedEdgesTest>(argc, argv); }
#include "marked_edges_test.moc"
