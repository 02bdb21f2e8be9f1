// The operator's work in the real window, with real events: targets and their card, measuring, selecting, the source of the picture.
#include "core/base/whole_file.h"
#include "core/exports/verify.h"
#include "core/inspect/measure/cell_sets.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/mouse_wheel.h"
#include "tests/ui/pictures.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/command_palette.h"
#include "ui/panels/dialogs/export_dialog.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/keys/commands.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/section/section_card.h"
#include "ui/panels/section/section_plot.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/target_words.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/views/cloud/point_pick.h"
#include "ui/window/tool_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDir>
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>

#include <cmath>
#include <fstream>
#include <set>

using namespace edgescan;
using namespace edgescan::ui;

class TargetsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string boxes_, placed_, plate_;

    static void move(QWidget& view, QPoint at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, modifiers);
        QApplication::sendEvent(&view, &event);
    }
    static QPoint pixelOf(const ImageView& view, QPointF corner) { return view.viewPort()->toPixel(corner, view.size()).toPoint(); }
    static QPoint pixelOf(const ImageView& view, int line, int beam) { return pixelOf(view, QPointF(beam + 0.5, line + 0.5)); }
    static void click(ImageView& view, int line, int beam, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mouseClick(&view, Qt::LeftButton, modifiers, pixelOf(view, line, beam));
    }
    static void drag(QWidget& view, const QVector<QPoint>& way, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, way.front());
        for (const QPoint& at : way.mid(1)) move(view, at, Qt::LeftButton, modifiers);
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, way.back());
    }
    static bool known(WindowFixture& on) {
        return on.settled() && eventually([&] { return on.viewer.targets.settled(); });
    }
    static bool showWith(WindowFixture& on, const std::string& path) {
        on.window.resize(1400, 900);
        return on.showWith(path) && on.activate();
    }
    static const std::vector<inspect::PinnedTarget>& targets(WindowFixture& on) { return on.viewer.targets.notebook().targets; }
    // A cell that the image view shows under its own pixel.
    static std::uint32_t cellUnder(WindowFixture& on, int line, int beam) {
        const auto at = on.viewer.views.gray().cellAt(pixelOf(on.viewer.views.gray(), line, beam));
        return static_cast<std::uint32_t>(*on.viewer.views.cellAt(at->y(), at->x()));
    }
    // The cell that a click there means.
    static std::uint32_t nearSideUnder(WindowFixture& on, int line, int beam) {
        return on.viewer.views.nearSideCell(cellUnder(on, line, beam)).cell;
    }
    // The label of a measurement without the sign that an end is behind the surface under its line.
    static QString lengthIn(QString label) { return label.remove(QRegularExpression(QString::fromUtf8("^(▲ )?M\\d+ "))); }
    // A plate 50 mm in front of a wall, 10 m away.
    static Scan plateScan() {
        Scan scan = test::makeScan(41, 41, [](int, int) { return 1000.0F; });
        auto& polar = std::get<PolarGeometry>(scan.geometry);
        for (std::size_t n = 0; n < 41; ++n) {
            polar.beamDeg[n] = 90.0 + (static_cast<double>(n) - 20) / 6;
            polar.lineDeg[n] = (static_cast<double>(n) - 20) / 6;
        }
        for (int i = 0; i < 41; ++i) {
            for (int j = 0; j < 41; ++j) scan.rangeMm.at(i, j) = (i == 20 || i == 21) && (j == 20 || j == 21) ? 10000.0F : 10300.0F;
        }
        return scan;
    }

private slots:
    void initTestCase() {
        qRegisterMetaType<exports::ExportContent>("edgescan::ExportContent");
        Scan scan = test::boxesScan(120, 160, 3, 0.02);
        boxes_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(scan, boxes_)));
        scan.placement = std::make_shared<const Placement>(*test::randomPlacement(3, 1, true));
        placed_ = (folder_ / "placed.json").string();
        QVERIFY(bool(files::saveScan(scan, placed_)));
        plate_ = (folder_ / "plate.json").string();
        QVERIFY(bool(files::saveScan(plateScan(), plate_)));
    }

    void twoWindowsOnOneScanLoseNoTarget() {
        const QString ini = QString::fromStdString((folder_ / "two" / "viewer.ini").string());
        std::uint32_t theirs = 0;
        {
            WindowFixture one(ini);
            QVERIFY(showWith(one, boxes_));
            {
                WindowFixture two(ini);
                QVERIFY(!one.viewer.notice.text().contains("Another window"));
                QVERIFY(showWith(two, boxes_));
                QVERIFY2(two.viewer.notice.text().contains("Another window has this scan open"), qPrintable(two.viewer.notice.text()));
                click(two.viewer.views.gray(), 60, 80);
                QVERIFY(known(two));
                theirs = targets(two).front().cell;
            }
            QVERIFY(one.activate());
            click(one.viewer.views.gray(), 20, 30);
            QTRY_COMPARE(static_cast<int>(targets(one).size()), 2); // that of the other window came with the write
            QVERIFY2(one.viewer.notice.text().contains("Another window"), qPrintable(one.viewer.notice.text()));
            QTest::keyClick(&one.window, Qt::Key_Z, Qt::ControlModifier); // takes back its own target only
            QVERIFY(known(one));
            QCOMPARE(static_cast<int>(targets(one).size()), 1);
            QCOMPARE(targets(one).front().cell, theirs);
            QTest::keyClick(&one.window, Qt::Key_Y, Qt::ControlModifier);
            QVERIFY(known(one));
            QCOMPARE(static_cast<int>(targets(one).size()), 2);
        }
        WindowFixture again(ini);
        QVERIFY(showWith(again, boxes_));
        QCOMPARE(static_cast<int>(targets(again).size()), 2);
    }

    // What the disk refused is asked about before the window closes, and is stored as soon as there is room.
    void targetsThatAreNotStoredAreAskedAbout() {
        const std::filesystem::path place = folder_ / "refused";
        std::filesystem::create_directories(place);
        std::ofstream(place / "targets") << "a file in place of the folder";
        const QString ini = QString::fromStdString((place / "viewer.ini").string());
        int questions = 0;
        QTimer answering;
        connect(&answering, &QTimer::timeout, &answering, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr || box->objectName() != "close-question") return;
            questions += box->text() == "Your targets are not stored." ? 1 : 0;
            box->button(QMessageBox::Cancel)->click();
        });
        answering.start(20);
        {
            WindowFixture on(ini);
            QVERIFY(showWith(on, boxes_));
            click(on.viewer.views.gray(), 60, 80);
            QVERIFY(known(on));
            QTRY_VERIFY(on.viewer.targets.unsaved());
            QVERIFY2(on.viewer.notice.text().startsWith("Your targets are not stored: "), qPrintable(on.viewer.notice.text()));
            on.window.close();
            QCOMPARE(questions, 1);
            QVERIFY(on.window.isVisible());
            std::filesystem::remove(place / "targets");
            click(on.viewer.views.gray(), 20, 30);
            QVERIFY(known(on));
            QTRY_VERIFY(!on.viewer.targets.unsaved());
            on.window.close();
            QCOMPARE(questions, 1);
        }
        WindowFixture again(ini);
        QVERIFY(showWith(again, boxes_));
        QCOMPARE(static_cast<int>(targets(again).size()), 2);
    }

    void everyClickPinsUntilItIsLetGo() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        ImageView& gray = on.viewer.views.gray();
        ImageView& edges = on.viewer.views.edges();
        std::vector<std::uint32_t> cells{nearSideUnder(on, 20, 30), nearSideUnder(on, 60, 80), nearSideUnder(on, 100, 140)};
        click(gray, 20, 30);
        click(edges, 60, 80);
        click(gray, 100, 140);
        QVERIFY(known(on));
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
        for (int n = 0; n < 3; ++n) {
            QCOMPARE(targets(on)[static_cast<std::size_t>(n)].number, n + 1);
            QCOMPARE(targets(on)[static_cast<std::size_t>(n)].cell, cells[static_cast<std::size_t>(n)]);
        }
        // The same marks in all three views; the card shows the last one.
        QCOMPARE(static_cast<int>(gray.marks().targets.size()), 3);
        QVERIFY(gray.marks() == edges.marks() && gray.marks() == on.viewer.views.cloud().marks());
        QCOMPARE(on.viewer.targets.active()->number, 3);
        QVERIFY2(gray.marks().targets[2].active && gray.marks().targets[2].tag.startsWith("3 · "), qPrintable(gray.marks().targets[2].tag));
        QTRY_VERIFY(on.window.findChild<QDockWidget*>("dock-targets")->isVisible());
        QTRY_VERIFY(on.viewer.targetsPanel.card().isVisible());
        const QString card = on.viewer.targetsPanel.card().text();
        for (QWidget* view : {static_cast<QWidget*>(&gray), static_cast<QWidget*>(&on.viewer.views.cloud())}) {
            move(*view, QPoint(view->width() / 2, view->height() / 2), Qt::NoButton);
            move(*view, QPoint(view->width() / 3, view->height() / 2), Qt::NoButton);
        }
        QCOMPARE(on.viewer.targetsPanel.card().text(), card);
        // A click on a target shows its card again, and makes no other target.
        click(edges, 20, 30);
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
        QCOMPARE(on.viewer.targets.active()->number, 1);
        // So does a click in the list.
        auto* list = on.viewer.targetsPanel.targets();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(1)).center());
        QCOMPARE(on.viewer.targets.active()->number, 2);
        // Del removes it, unless it is locked. Esc only hides the card.
        QTest::mouseClick(on.viewer.targetsPanel.card().lock(), Qt::LeftButton);
        QVERIFY(on.viewer.targets.active()->locked);
        QVERIFY(!on.viewer.targetsPanel.card().close()->isEnabled());
        QVERIFY(list->item(0)->icon().isNull() && !list->item(1)->icon().isNull());
        QVERIFY2(list->item(1)->toolTip().contains("locked"), qPrintable(list->item(1)->toolTip()));
        QCOMPARE(list->visualItemRect(list->item(1)).height(), list->visualItemRect(list->item(0)).height());
        QTest::keyClick(&on.window, Qt::Key_Delete);
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
        on.viewer.notice.hide();
        on.viewer.views.cloud().setFocus();
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(on.viewer.targets.active() == nullptr && on.viewer.targetsPanel.card().isHidden());
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
        click(gray, 100, 140);
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(on.viewer.targets.active() == nullptr);
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
        click(gray, 100, 140);
        QTest::keyClick(&on.window, Qt::Key_Delete);
        QCOMPARE(static_cast<int>(targets(on).size()), 2);
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
        QCOMPARE(targets(on)[2].cell, cells[2]);
        // All except the locked one.
        QTest::mouseClick(on.viewer.targetsPanel.removeAllButton(), Qt::LeftButton);
        QCOMPARE(static_cast<int>(targets(on).size()), 1);
        QVERIFY(targets(on)[0].locked);
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(static_cast<int>(targets(on).size()), 3);
    }

    // A note, a name and one more target move no row and no button under the pointer.
    void nothingMovesUnderThePointerWhenTargetsGetMore() {
        for (const std::string& path : {boxes_, placed_}) {
            WindowFixture on;
            QVERIFY(showWith(on, path));
            QListWidget& list = *on.viewer.targetsPanel.targets();
            QWidget& remove = *on.viewer.targetsPanel.card().close();
            const auto at = [&](QWidget& part) { return part.mapTo(&on.window, QPoint(0, 0)); };
            const auto same = [&](const std::function<void()>& step) {
                QCoreApplication::processEvents();
                const QPoint button = at(remove), rows = at(*list.viewport());
                const QRect first = list.visualItemRect(list.item(0));
                step();
                QVERIFY(known(on));
                QCoreApplication::processEvents();
                QCOMPARE(at(remove), button);
                QCOMPARE(at(*list.viewport()), rows);
                QCOMPARE(list.visualItemRect(list.item(0)), first);
            };
            click(on.viewer.views.gray(), 20, 30);
            QVERIFY(known(on));
            QTRY_VERIFY(remove.isVisible());
            same([&] { on.viewer.targets.setNote(1, QString("a note that has no room in one row ").repeated(3)); });
            same([&] { on.viewer.targets.rename(1, "a long name of a large rock"); });
            same([&] { click(on.viewer.views.gray(), 60, 80); });
            same([&] { click(on.viewer.views.gray(), 100, 140); });
            same([&] { on.viewer.targets.setNote(3, "a note"); });
            // A row that is chosen in a list that was scrolled stays where it is.
            for (const int line : {30, 40, 50, 70}) click(on.viewer.views.gray(), line, 60);
            QVERIFY(known(on) && list.count() == 7);
            QCoreApplication::processEvents();
            list.scrollToItem(list.item(2), QAbstractItemView::PositionAtTop);
            const QRect third = list.visualItemRect(list.item(2));
            QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, third.center());
            QCOMPARE(on.viewer.targets.active()->number, 3);
            QVERIFY(known(on));
            QCOMPARE(list.visualItemRect(list.item(2)), third);
        }
    }

    // A double-click, Return or F2 on a target: the next letters are its name.
    void theNameOfATargetIsTypedAfterADoubleClickReturnOrF2() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        click(on.viewer.views.gray(), 20, 30);
        click(on.viewer.views.gray(), 60, 80);
        on.viewer.targets.rename(1, "old");
        QVERIFY(known(on));
        QListWidget& list = *on.viewer.targetsPanel.targets();
        QLineEdit& name = *on.viewer.targetsPanel.card().name();
        const auto typed = [&](const char* words) {
            QTRY_VERIFY(name.hasFocus());
            QTest::keyClicks(&name, words);
            QTest::keyClick(&name, Qt::Key_Return);
            QVERIFY2(!name.hasFocus(), "the next key is a command");
            QCOMPARE(targets(on)[0].name, std::string(words));
        };
        const QPoint first = list.visualItemRect(list.item(0)).center();
        QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, first);
        QTest::mouseDClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, first);
        typed("keystone");
        QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, first);
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Return);
        typed("dome");
        on.viewer.cloud.setFocus();
        QTest::keyClick(&on.window, Qt::Key_F2);
        typed("left shoulder");
    }

    // Letters of a name that miss its field are keys: what they changed is reported, one letter alone is meant.
    void aNameTypedIntoAViewReportsWhatItChanged() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        on.viewer.cloud.setFocus();
        QTest::keyClick(&on.window, Qt::Key_D);
        QCoreApplication::processEvents();
        QVERIFY2(!on.viewer.notice.text().contains("keys"), qPrintable(on.viewer.notice.text()));
        QTest::keyClick(&on.window, Qt::Key_R); // ends with the view
        QTest::keyClick(&on.window, Qt::Key_T);
        QTest::keyClick(&on.window, Qt::Key_E);
        QTRY_COMPARE(on.viewer.notice.text(),
                     QString("Letters outside a field are keys; these changed: Edge Points off, Turntable off, Dim Cloud under Edges off, "
                             "view of the cloud."));
        QTest::keyClick(&on.window, Qt::Key_E);
        QTRY_COMPARE(on.viewer.notice.text(),
                     QString("Letters outside a field are keys; these changed: Turntable off, Dim Cloud under Edges off, "
                             "view of the cloud."));
    }

    // All of a text: also signs between its letters, tools and the view; one button takes it back.
    void whatATextChangedIsTakenBackByOneButton() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        on.viewer.cloud.setFocus();
        QTest::keyClick(&on.window, Qt::Key_K);
        QTRY_VERIFY(on.viewer.rocks.picture() && !on.viewer.rocks.behind());
        auto* keys = on.window.findChild<KeysOfFocus*>();
        QTRY_VERIFY(!keys->hears());
        const CameraPose before = on.viewer.cloud.camera();
        const int steps = on.viewer.undo.index();
        for (const int key : {Qt::Key_Period, Qt::Key_C, Qt::Key_7, Qt::Key_S}) QTest::keyClick(&on.window, static_cast<Qt::Key>(key));
        QTRY_VERIFY2(on.viewer.notice.text().contains("Coarser"), qPrintable(on.viewer.notice.text()));
        QVERIFY2(on.viewer.notice.text().contains("Split a Rock on"), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.rocks.settings().level > 0 && on.viewer.undo.index() > steps);
        QTest::mouseClick(on.viewer.notice.findChild<QToolButton*>("notice-action"), Qt::LeftButton);
        QCOMPARE(on.viewer.rocks.settings().level, 0.0);
        QCOMPARE(on.viewer.rocks.tool(), RockTool::None);
        QCOMPARE(on.viewer.undo.index(), steps);
        QTRY_VERIFY(on.viewer.cloud.camera() == before);
        QVERIFY(!on.viewer.notice.text().contains("keys"));
    }

    // What is removed is named as in the list, and the notice brings it back; the next step takes the notice away.
    void whatIsRemovedIsNamedAndComesBackByItsNotice() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        click(on.viewer.views.gray(), 20, 30);
        click(on.viewer.views.gray(), 60, 80);
        on.viewer.targets.rename(2, "Big & old");
        inspect::StoredMeasure measure;
        measure.cells = {targets(on)[0].cell, targets(on)[1].cell};
        on.viewer.targets.keepMeasure(measure);
        QVERIFY(known(on));
        const inspect::Notebook before = on.viewer.targets.notebook();
        auto& undo = *on.viewer.notice.findChild<QToolButton*>("notice-action");
        const auto comesBack = [&](const QStringList& names) {
            const QString text = on.viewer.notice.text();
            for (const QString& name : names) {
                if (!text.contains(name)) return qWarning("%s is not in \"%s\"", qPrintable(name), qPrintable(text)), false;
            }
            if (!on.viewer.notice.isVisible() || !undo.isVisible() || undo.text() != "Undo") return false;
            if (on.viewer.targets.notebook() == before) return false;
            QTest::mouseClick(&undo, Qt::LeftButton);
            return on.viewer.targets.notebook() == before && on.viewer.notice.isHidden();
        };
        const QString place = on.viewer.targetsPanel.targets()->item(1)->text().section('\n', 1).simplified();
        QVERIFY2(place.startsWith("x "), qPrintable(place));
        const QString distance = distanceText(on.viewer.targets.known().targets.at(targets(on)[1].cell));
        on.viewer.views.pin(targets(on)[1].cell);
        QTest::keyClick(&on.window, Qt::Key_Delete);
        QVERIFY(comesBack({"Target 2", "Big & old", distance, place}));
        QTest::mouseClick(on.viewer.targetsPanel.removeAllButton(), Qt::LeftButton);
        QVERIFY(comesBack({"Targets 1, 2  Big & old"}));
        const QString words = on.viewer.targets.measuresInWords().front().simplified();
        on.viewer.targetsPanel.measures()->setCurrentRow(0);
        QTest::mouseClick(on.viewer.targetsPanel.removeMeasure(), Qt::LeftButton);
        QVERIFY(comesBack({words}));
        on.viewer.targets.chooseMeasure(0);
        QTest::keyClick(&on.window, Qt::Key_Delete);
        QVERIFY(comesBack({words}));
        // The notice is about the newest step only.
        on.viewer.targets.remove(1);
        QVERIFY(undo.isVisible());
        on.viewer.targets.rename(2, "B");
        QVERIFY(on.viewer.notice.isHidden());
        on.viewer.targets.lock(2, true);
        on.viewer.targets.remove(2);
        QVERIFY2(on.viewer.notice.text().contains("Target 2 is locked") && !undo.isVisible(), qPrintable(on.viewer.notice.text()));
    }

    // The label of the last measurement may be over the opening: the click is about what is behind it.
    void aClickOnALabelOverAHoleMeasuresTheHole() {
        const std::string path = (folder_ / "hole.json").string();
        QVERIFY(bool(
            files::saveScan(test::makeScan(60, 60, [](int i, int j) { return std::hypot(i - 30, j - 30) < 12 ? 0.0 : 5000.0; }), path)));
        WindowFixture on;
        QVERIFY(showWith(on, path));
        CloudView& cloud = on.viewer.cloud;
        QTRY_VERIFY(cloud.atRest());
        std::vector<QPointF> inHole;
        for (int y = 0; y < cloud.height(); y += 7) {
            for (int x = 0; x < cloud.width(); x += 7) {
                if (cloud.holeAt(QPointF(x, y))) inHole.emplace_back(x, y);
            }
        }
        QVERIFY(!inHole.empty());
        const auto& measures = on.viewer.targets.notebook().measures;
        const auto openings = [&measures] {
            return std::ranges::count_if(measures, [](const auto& each) { return each.kind == inspect::MeasureKind::Throat; });
        };
        on.viewer.measures.start(inspect::MeasureKind::Throat);
        emit cloud.markClicked({.isMeasure = true, .byLabel = true}, -1, inHole[inHole.size() / 2]);
        QTRY_COMPARE(openings(), 1);
        // Why says that nothing was measured there.
        on.viewer.views.setTool(Tool::Why);
        QToolTip::hideText();
        emit cloud.markClicked({.isMeasure = true, .byLabel = true}, -1, inHole[inHole.size() / 2]);
        QTRY_VERIFY2(QToolTip::text().contains("did not measure"), qPrintable(QToolTip::text()));
        QCOMPARE(openings(), 1);
    }

    // A void with a wall 13 m behind it: clicks just inside its rim mean the rim, in every tool.
    void aClickBehindAnEdgeMeansItsNearSide() {
        const std::string path = (folder_ / "void.json").string();
        QVERIFY(bool(files::saveScan(
            test::makeScan(60, 60, [](int i, int j) { return std::hypot(i - 30, j - 30) < 12 ? 18000.0 : 5000.0; }), path)));
        WindowFixture on;
        QVERIFY(showWith(on, path));
        const Scan& scan = *on.picture().detection->scan;
        ImageView& gray = on.viewer.views.gray();
        const std::uint32_t clicked = cellUnder(on, 30, 19);
        QCOMPARE(scan.rangeMm[clicked], 18000.0F);
        click(gray, 30, 19);
        QVERIFY(known(on));
        QCOMPARE(static_cast<int>(targets(on).size()), 1);
        QCOMPARE(scan.rangeMm[targets(on)[0].cell], 5000.0F);
        QVERIFY(targets(on)[0].clicked == clicked);
        QVERIFY(gray.marks().targets[0].clicked == std::size_t{clicked});
        QTRY_VERIFY2(on.viewer.targetsPanel.card().text().contains("Clicked: 13.00 m behind an edge"),
                     qPrintable(on.viewer.targetsPanel.card().text()));
        // A jump that no edge marks is said to be one: here the settings find none, and a slip of the stepper looks the same.
        edges::Settings none;
        none.minimumLength = 50;
        none.classes = edges::kClassConvex;
        QVERIFY(on.use(none));
        QTRY_VERIFY2(on.viewer.targetsPanel.card().text().contains("Clicked: 13.00 m behind a jump where no edge is drawn"),
                     qPrintable(on.viewer.targetsPanel.card().text()));
        QVERIFY(on.use({}));
        // With Shift the very cell is meant.
        click(gray, 30, 20, Qt::ShiftModifier);
        QCOMPARE(static_cast<int>(targets(on).size()), 2);
        QCOMPARE(scan.rangeMm[targets(on)[1].cell], 18000.0F);
        // The throat: the clicks are on the wall behind, the length is that of the opening.
        on.viewer.measures.start(inspect::MeasureKind::Throat);
        QSignalSpy words(&on.viewer.measures, &Measures::asked);
        const std::size_t atFirst = on.viewer.targets.notebook().measures.size();
        const auto isAcross = [&](const inspect::StoredMeasure& throat) {
            const auto measured = inspect::measureCells(scan, {}, throat.kind, throat.cells);
            return measured && measured->lengths[0].valueM < 0.6 &&
                   std::ranges::all_of(throat.cells, [&](std::uint32_t k) { return scan.rangeMm[k] == 5000.0F; });
        };
        // One click on the wall that is seen through the void measures it.
        click(gray, 30, 30);
        QTRY_COMPARE(on.viewer.targets.notebook().measures.size(), atFirst + 1);
        QVERIFY(on.viewer.targets.notebook().measures.back().isByOneClick());
        QVERIFY(isAcross(on.viewer.targets.notebook().measures.back()));
        QVERIFY(on.viewer.measures.picked().empty());
        QTRY_VERIFY2(words.last().front().toString().contains("click into the opening, or the near rock at one side"),
                     qPrintable(words.last().front().toString()));
        on.viewer.notice.hide();
        // Just behind the side of the opening, the near side is meant: one of two clicks.
        click(gray, 30, 41);
        QVERIFY2(words.last().front().toString().contains("click the rock at the other side"), // "rim" is the class void rim
                 qPrintable(words.last().front().toString()));
        QVERIFY2(!on.viewer.notice.isVisible(), qPrintable(on.viewer.notice.text()));
        const auto* asked = on.window.findChild<QLabel*>("tool-words"); // cut in a narrow window, not gone
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.width() == 1280 && asked->isVisible() && asked->width() > 100));
        QVERIFY(on.viewer.measures.removeLastPick());
        click(gray, 5, 5);
        click(gray, 5, 7);
        QTRY_VERIFY2(on.viewer.notice.isVisible() && on.viewer.notice.text().contains("No opening"), qPrintable(on.viewer.notice.text()));
        const std::size_t before = on.viewer.targets.notebook().measures.size();
        click(gray, 30, 41);
        click(gray, 30, 19);
        QVERIFY2(words.last().front().toString().contains("searched"), qPrintable(words.last().front().toString()));
        click(gray, 10, 10); // while it is searched, a click is not the first of the next one
        QTRY_COMPARE(on.viewer.targets.notebook().measures.size(), before + 1);
        QVERIFY(on.viewer.measures.picked().empty());
        // The second try is good: its second click is behind the side, and so in the opening.
        QVERIFY2(on.viewer.notice.text().startsWith("The last click is in an opening"), qPrintable(on.viewer.notice.text()));
        const auto& throat = on.viewer.targets.notebook().measures.back();
        QVERIFY(isAcross(throat));
        QVERIFY(known(on));
        // A click on the ring of a target takes its cell: the prompt and the card say so, and a ring is where the length begins.
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        click(gray, static_cast<int>(targets(on)[0].cell) / scan.beams(), static_cast<int>(targets(on)[0].cell) % scan.beams());
        QCOMPARE(on.viewer.measures.picked().front().cell, targets(on)[0].cell);
        QVERIFY2(words.last().front().toString().contains("the last click took target 1, at 5.00 m"),
                 qPrintable(words.last().front().toString()));
        QVERIFY(gray.marks().measures.back().active);
        click(gray, 10, 10);
        QTRY_VERIFY2(on.viewer.targets.wordsOf(on.viewer.targets.notebook().measures.back()).remarks.contains("end 1 is target 1"),
                     qPrintable(on.viewer.targets.wordsOf(on.viewer.targets.notebook().measures.back()).remarks.join("; ")));
        // A length from the near side to the wall is marked and warned about.
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        click(gray, 30, 10);
        click(gray, 30, 30);
        QVERIFY2(on.viewer.notice.text().contains("13.00 m behind the surface under its line"), qPrintable(on.viewer.notice.text()));
        QVERIFY2(on.viewer.targets.measuresInWords().back().endsWith("…"), "a length that is not known yet is not one without a range");
        QVERIFY(known(on));
        QTRY_VERIFY(gray.marks().measures.back().label.startsWith(QString::fromUtf8("▲ ")));
        on.viewer.measures.stop();
        // A section through the ends of this measurement, in true scale; the mouse over it points in the views. Why makes room for it.
        on.viewer.explanation.explain(inspect::exactly(on.viewer.targets.notebook().measures.back().cells.front()),
                                      Explanation::Subject::Pin);
        QTRY_VERIFY(on.viewer.explanation.card() != nullptr && on.viewer.explanation.card()->isVisible());
        on.viewer.sections.throughMeasurement();
        QTRY_VERIFY(on.viewer.sections.card() != nullptr && on.viewer.sections.card()->isVisible());
        QVERIFY(!on.viewer.explanation.card()->isVisible());
        SectionPlot& plot = on.viewer.sections.card()->plot();
        QTRY_VERIFY(plot.section() != nullptr);
        QVERIFY(plot.section()->lines.size() >= 2);
        // Each view shows where it is, until it is closed.
        QCOMPARE(gray.marks().cut.size(), plot.section()->lines.size());
        QCOMPARE(on.viewer.cloud.marks().cut, gray.marks().cut);
        for (std::size_t n = 0; n < plot.section()->lines.size(); ++n) {
            for (const inspect::SectionVertex& vertex : plot.section()->lines[n])
                QVERIFY(std::ranges::count(gray.marks().cut[n], vertex.cell) > 0);
        }
        const auto isDrawn = [](QWidget& view) {
            return countPixels(view.grab().toImage(), [](QRgb pixel) { return pixel == QColor(255, 220, 110).rgb(); }) > 0;
        };
        QVERIFY(isDrawn(gray));
        const QPointF one = plot.placeOf({1.0, 0.0}) - plot.placeOf({0.0, 0.0}),
                      other = plot.placeOf({0.0, 1.0}) - plot.placeOf({0.0, 0.0});
        QVERIFY(std::abs(one.x() + other.y()) < 1e-6 && one.x() > 0);
        // The measured line is in the plot, with its ends, its length and a margin.
        QCOMPARE(plot.ends().size(), std::size_t{2});
        QCOMPARE(plot.lengthShown(), gray.marks().measures.back().label);
        for (const auto* end : plot.ends()) QVERIFY(QRectF(plot.rect()).adjusted(5, 5, -5, -5).contains(plot.placeOf(end->atM)));
        const inspect::SectionVertex vertex = plot.section()->lines[0].front();
        QSignalSpy pointed(&plot, &SectionPlot::hovered);
        move(plot, plot.placeOf(vertex.atM).toPoint(), Qt::NoButton);
        QCOMPARE(pointed.count(), 1);
        QSignalSpy measuredIn(&plot, &SectionPlot::measured);
        QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier, plot.placeOf(vertex.atM).toPoint());
        QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier, plot.placeOf(plot.section()->lines[0].back().atM).toPoint());
        QCOMPARE(measuredIn.count(), 1);
        // The length is in the list of measurements with the number of the plot, also after the file was read again.
        const inspect::StoredMeasure& inSection = on.viewer.targets.notebook().measures.back();
        QVERIFY(inSection.kind == inspect::MeasureKind::Section);
        const auto length =
            inspect::measureCells(scan, inspect::noiseOf(*on.picture().detection), inSection.kind, inSection.cells, inSection.shares);
        QVERIFY(length.has_value());
        QCOMPARE(plot.lengthShown(), QString::fromStdString(inspect::measureText(*length)));
        QVERIFY(known(on));
        const QString listed = on.viewer.targetsPanel.measures()->item(on.viewer.targetsPanel.measures()->count() - 1)->text();
        QVERIFY2(listed.contains("  " + plot.lengthShown() + "\nLength in a Section"), qPrintable(listed));
        // Its buttons zoom and close it; so does Esc in the main window.
        const auto perM = [&plot] { return plot.placeOf({1.0, 0.0}).x() - plot.placeOf({0.0, 0.0}).x(); };
        const auto press = [&](const char* name) {
            QTest::mouseClick(on.viewer.sections.card()->findChild<QPushButton*>(name), Qt::LeftButton);
        };
        const double fitted = perM();
        press("section-zoom-out");
        QVERIFY(perM() < fitted);
        press("section-zoom-in");
        press("section-zoom-in");
        QVERIFY(perM() > fitted);
        press("section-all");
        QCOMPARE(plot.outside(), std::size_t(0));
        press("section-fit");
        QCOMPARE(perM(), fitted);
        press("section-close");
        QVERIFY(!on.viewer.sections.card()->isVisible());
        QVERIFY(gray.marks().cut.empty() && on.viewer.cloud.marks().cut.empty() && !isDrawn(gray));
        on.viewer.sections.throughMeasurement();
        QTRY_VERIFY(on.viewer.sections.card()->isVisible());
        on.viewer.notice.hide();
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(!on.viewer.sections.card()->isVisible());
        // An older measurement that is chosen in the list has its section by the button over the list.
        QVERIFY(on.viewer.targets.notebook().measures.front().cells != on.viewer.targets.notebook().measures.back().cells);
        on.viewer.targets.chooseMeasure(0);
        QTest::mouseClick(on.viewer.targetsPanel.section(), Qt::LeftButton);
        QTRY_VERIFY(on.viewer.sections.card()->isVisible());
        QCOMPARE(plot.lengthShown(), gray.marks().measures.front().label);
    }

    // A key marked another row, and Del removed the target that was chosen before.
    void theRowThatAKeyMarksIsChosen() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_) && on.activate());
        ImageView& gray = on.viewer.views.gray();
        for (const auto& [line, beam] : {std::pair{20, 30}, {60, 80}, {90, 30}}) click(gray, line, beam);
        QVERIFY(known(on));
        for (const std::size_t n : {0, 1})
            on.viewer.targets.keepMeasure({inspect::MeasureKind::Distance, {targets(on)[n].cell, targets(on)[n + 1].cell}});
        QListWidget& list = *on.viewer.targetsPanel.targets();
        const auto press = [&](QListWidget& in, Qt::Key key) {
            in.setFocus();
            QTest::keyClick(&in, key);
        };
        QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, list.visualItemRect(list.item(2)).center());
        for (const auto& [key, row] : {std::pair{Qt::Key_Up, 1}, {Qt::Key_Up, 0}, {Qt::Key_End, 2}, {Qt::Key_Up, 1}}) {
            press(list, key);
            QTRY_COMPARE(on.viewer.targets.active()->number, row + 1);
            QCOMPARE(list.currentRow(), row);
            QCOMPARE(*on.viewer.views.pinned(), std::size_t{targets(on)[static_cast<std::size_t>(row)].cell});
        }
        press(list, Qt::Key_Delete);
        QTRY_COMPARE(targets(on).size(), std::size_t{2});
        QVERIFY(targets(on)[0].number == 1 && targets(on)[1].number == 3);
        QListWidget& measures = *on.viewer.targetsPanel.measures();
        on.viewer.targets.chooseMeasure(0);
        press(measures, Qt::Key_Down);
        QTRY_VERIFY(on.viewer.targets.chosenMeasure() == std::size_t{1});
        QVERIFY(gray.marks().measures[1].active && !gray.marks().measures[0].active);
    }

    void aFarWallDoesNotShrinkASection() {
        auto section = std::make_shared<inspect::Section>();
        inspect::SectionLine near, far;
        for (int n = 0; n <= 100; ++n) near.push_back({{0.02 * n, 0.3 * std::sin(0.1 * n)}, {}, static_cast<std::uint32_t>(n)});
        for (int n = 0; n <= 100; ++n) far.push_back({{-40.0 + 0.8 * n, 60.0}, {}, static_cast<std::uint32_t>(1000 + n)});
        section->lines = {near, far};
        SectionPlot plot;
        plot.resize(640, 420);
        plot.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&plot));
        const auto perM = [&plot] { return plot.placeOf({1.0, 0.0}).x() - plot.placeOf({0.0, 0.0}).x(); };
        plot.show(section);
        QCOMPARE(plot.outside(), std::size_t{0});
        QVERIFY(perM() < 10);
        plot.show(section, Eigen::AlignedBox2d(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(2.0, 0.0)));
        QVERIFY(perM() > 100);
        QCOMPARE(plot.outside(), far.size());
        // No words of the scale are cut at the top: its highest row of pixels has lines only.
        for (int high = 400; high < 440; ++high) {
            plot.resize(640, high);
            const QImage picture = plot.grab().toImage();
            const int words = countPixels(picture.copy(0, 0, 60, 1), [](QRgb pixel) { return qRed(pixel) > 140; });
            QCOMPARE(words, 0);
        }
        for (int n = 0; n < 30; ++n) wheel(plot, plot.rect().center(), -1);
        QCOMPARE(plot.outside(), std::size_t{0});
    }

    // Points outside and edges in the plot are counted only while there are some.
    void theWordsOfASectionFollowItsView() {
        auto section = std::make_shared<inspect::Section>();
        inspect::SectionLine near, far;
        for (int n = 0; n <= 100; ++n) near.push_back({{0.02 * n, 0.3 * std::sin(0.1 * n)}, {}, static_cast<std::uint32_t>(n)});
        for (int n = 0; n <= 100; ++n) far.push_back({{-40.0 + 0.8 * n, 60.0}, {}, static_cast<std::uint32_t>(1000 + n)});
        far.front().edge = true;
        section->lines = {near, far};
        QWidget window;
        SectionCard card(&window);
        card.resize(700, 420);
        card.plot().show(section, Eigen::AlignedBox2d(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(2.0, 0.0)));
        card.setWords("Vertical plane.");
        card.QDialog::show();
        QVERIFY(QTest::qWaitForWindowExposed(&card));
        QTRY_COMPARE(card.words(), QString::fromUtf8("▲ 101 points are outside: All shows them. Vertical plane."));
        const int high = card.plot().height();
        QTest::mouseClick(card.findChild<QPushButton*>("section-all"), Qt::LeftButton);
        QTRY_COMPARE(card.words(), QString("Edge points, green: 1. Vertical plane."));
        QCOMPARE(card.plot().height(), high); // it does not move
        // The words above the plot follow the clicks.
        const auto asked = [&card] { return card.findChild<QLabel*>("section-asked")->text(); };
        const auto click = [&card](const QPointF& at) { QTest::mouseClick(&card.plot(), Qt::LeftButton, Qt::NoModifier, at.toPoint()); };
        QCOMPARE(asked(), QString("Two clicks on the lines measure a length."));
        click({card.plot().width() - 30.0, card.plot().height() / 2.0});
        QCOMPARE(asked(), QString::fromUtf8("▲ This click is not on a line: click nearer to one."));
        click(card.plot().placeOf(near.front().atM));
        QCOMPARE(asked(), QString("Click on the other end of the length."));
        click(card.plot().placeOf(far.back().atM));
        QCOMPARE(asked(), QString("This length is stored with the measurements. Two more clicks measure another."));
        QCOMPARE(card.plot().height(), high);
    }

    // Neither the label of a length nor the number of a rock is on a line, and they are not on each other.
    void theLabelsOfASectionAreOffItsLines() {
        auto section = std::make_shared<inspect::Section>();
        inspect::SectionLine line, over;
        for (int n = 0; n <= 200; ++n) {
            line.push_back({{0.01 * n, 0.2 * std::sin(0.03 * n)}, {}, static_cast<std::uint32_t>(n)});
            line.back().rock = n > 40 && n < 70 ? 1 : 0;
        }
        for (int n = 0; n <= 200; ++n) over.push_back({{0.01 * n, 0.25}, {}, static_cast<std::uint32_t>(1000 + n)});
        section->lines = {line, over};
        SectionPlot plot;
        plot.resize(640, 420);
        plot.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&plot));
        plot.show(section, {}, {}, {{0, 0}, 1});
        const auto covers = [&](const QRectF& box, const inspect::SectionLine& of) {
            return std::ranges::any_of(of, [&](const inspect::SectionVertex& each) { return box.contains(plot.placeOf(each.atM)); });
        };
        const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lengths{{{0.5, 0.2}, {0.56, 0.2}},
                                                                               {{0.0, 0.0}, {2.0, 0.0}},
                                                                               {{0.45, 0.2}, {0.65, 0.2}},
                                                                               {{1.9, 0.25}, {2.0, 0.25}},
                                                                               {{1.5, 0.25}, {1.5, -0.2}}};
        for (const auto& [from, to] : lengths) {
            plot.setEnds(from, to);
            plot.setLength("1.234 m ± 0.012 m");
            plot.grab();
            QCOMPARE(plot.tags().size(), std::size_t{1});
            const QRectF label = plot.tags().front(), number = plot.numberPlace();
            QVERIFY(!number.isNull() && !covers(number, line) && !covers(number, over) && !label.intersects(number));
            QVERIFY(QRectF(plot.rect()).contains(label) && QRectF(plot.rect()).contains(number));
            const QLineF drawn(plot.placeOf(plot.ends()[0]->atM), plot.placeOf(plot.ends()[1]->atM));
            for (double along = 0.0; along <= 1.0; along += 0.01) QVERIFY(!label.contains(drawn.pointAt(along)));
        }
    }

    void theCardSaysWhatIsKnownAndWhatItWas() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        const edges::Detection& detection = *on.picture().detection;
        std::optional<std::uint32_t> jump;
        for (const std::uint32_t k : *detection.edges) {
            if ((*detection.classes)[k] == edges::DepthEdge::Jump && k / 160 > 10 && !jump) jump = k;
        }
        QVERIFY(jump.has_value());
        on.viewer.views.pin(*jump);
        QVERIFY(known(on));
        TargetCard& card = on.viewer.targetsPanel.card();
        const double range = static_cast<double>(detection.scan->rangeMm[*jump]) / 1000.0;
        QCOMPARE(card.findChild<QLabel*>("target-distance")->text(), QString("%1 m").arg(range, 0, 'f', 3));
        QVERIFY(card.findChild<QLabel*>("target-distance")->font().pointSizeF() > 1.8 * card.font().pointSizeF());
        QStringList names;
        for (const QString& line : card.text().split('\n')) names << line.section(": ", 0, 0);
        const QStringList wanted{"from", "X, Y, Z [m]", "E, N, RL", "Resolves", "Surface", "Dip / direction", "Cell", "Edge", "Picture"};
        int place = 0;
        for (const QString& name : wanted) {
            QVERIFY2(names.indexOf(name) > place, qPrintable(card.text()));
            place = names.indexOf(name);
        }
        QVERIFY2(card.text().contains("E, N, RL: ▲ no pose") && card.text().contains("Dip / direction"), qPrintable(card.text()));
        QVERIFY2(card.text().contains("Edge: jump, strength "), qPrintable(card.text()));
        QTRY_VERIFY(on.viewer.targetsPanel.targets()->item(0)->text().section('\n', 0, 0).endsWith("jump"));
        QVERIFY2(card.text().contains("Picture: FILE boxes · no time"), qPrintable(card.text()));
        QVERIFY2(card.text().contains(QString::fromUtf8(rocks::kRockCaveat)), qPrintable(card.text()));
        QVERIFY(!card.text().contains("was "));
        // A slider removes the edge: the card shows it, with the former value. The distance does not change.
        const QString distance = card.text().split('\n').at(1);
        edges::Settings other;
        other.classes = edges::kClassConvex;
        QVERIFY(on.use(other));
        QVERIFY(known(on));
        const auto* list = on.viewer.targetsPanel.targets();
        QTRY_VERIFY2(list->item(0)->text().section('\n', 0, 0).endsWith("no edge"), qPrintable(list->item(0)->text()));
        on.viewer.targets.copyAll();
        QVERIFY(QGuiApplication::clipboard()->text().contains("\tEdge\tNote\n") &&
                QGuiApplication::clipboard()->text().trimmed().endsWith("\tno edge"));
        QTRY_VERIFY2(card.text().contains("Edge: no edge") && card.text().contains("was jump, strength "), qPrintable(card.text()));
        QCOMPARE(card.text().split('\n').at(1), distance);
        QCOMPARE(on.viewer.targets.active()->cell, *jump);
        QVERIFY(on.use(edges::Settings{}));
        QVERIFY(known(on));
        QTRY_VERIFY2(!card.text().contains("was "), qPrintable(card.text()));
        // The former value of the distance, as of a live sweep, does not widen the panel.
        const auto* targetsDock = on.window.findChild<QDockWidget*>("dock-targets");
        const int least = targetsDock->minimumSizeHint().width();
        auto* tolerance = card.findChild<QLabel*>("target-tolerance");
        tolerance->setText("± 0.012 m\nwas 14.944 m ± 0.035 m, which is longer than any panel is wide at all");
        QApplication::processEvents();
        QCOMPARE(targetsDock->minimumSizeHint().width(), least);
        // The buttons of the card.
        QTest::mouseClick(card.copy(), Qt::LeftButton);
        QCOMPARE(QGuiApplication::clipboard()->text(), card.text());
        QTest::mouseClick(card.why(), Qt::LeftButton);
        QTRY_VERIFY(on.viewer.explanation.card() != nullptr && on.viewer.explanation.card()->isVisible());
    }

    // From the sixth target on the list took the place of the card: the distance was below the window.
    void theDistanceIsInSightWithManyTargets() {
        for (const QSize& size : {QSize(1280, 800), QSize(1366, 768)}) {
            WindowFixture on;
            QVERIFY(showWith(on, placed_));
            QTRY_VERIFY((on.window.resize(size), on.window.size() == size));
            const auto* distance = on.viewer.targetsPanel.findChild<QLabel*>("target-distance");
            const auto* list = on.viewer.targetsPanel.targets();
            const Scan& scan = *on.picture().detection->scan;
            int count = 0;
            for (std::uint32_t k = 0; k < scan.cells() && count < 20; k += 97) {
                if (scan.state[k] != CellState::Valid) continue;
                on.viewer.views.pin(k);
                QVERIFY(known(on));
                if (static_cast<int>(targets(on).size()) == count) continue;
                ++count;
                const auto seen = [&] {
                    const QRect chosen = list->visualItemRect(list->currentItem());
                    return list->currentItem() != nullptr && list->viewport()->rect().contains(QPoint(1, chosen.center().y())) &&
                           distance->visibleRegion().boundingRect().height() == distance->height();
                };
                QVERIFY2(eventually(seen), qPrintable(QString("%1 targets at %2 x %3").arg(count).arg(size.width()).arg(size.height())));
            }
            QCOMPARE(count, 20);
            // With a pose too, several targets are in sight.
            int rows = 0;
            for (int n = 0; n < list->count(); ++n) rows += list->viewport()->rect().contains(list->visualItemRect(list->item(n))) ? 1 : 0;
            QVERIFY2(rows >= 4, qPrintable(QString::number(rows)));
        }
    }

    // Each pin made the list higher twice: once by its number, and when its place was known.
    void theCardStaysWhereItIsWhileATargetIsMeasured() {
        WindowFixture on;
        QVERIFY(showWith(on, placed_));
        TargetCard& card = on.viewer.targetsPanel.card();
        QList<int> tops;
        const auto note = [&] {
            const int top = card.mapTo(&on.viewer.targetsPanel, QPoint()).y();
            if (card.isVisible() && (tops.isEmpty() || tops.back() != top)) tops << top;
        };
        for (const std::uint32_t cell : {60U * 160 + 80, 60U * 160 + 20}) {
            on.viewer.views.pin(cell);
            for (int n = 0; n < 40; ++n) {
                QTest::qWait(5);
                note();
            }
            QVERIFY(known(on));
            QTest::qWait(50);
            note();
        }
        QVERIFY2(tops.size() == 1, qPrintable(QString("%1 places, the last %2").arg(tops.size()).arg(tops.back())));
    }

    // The list of measurements was below the card, out of sight. A long note was cut by its field.
    void measurementsAndALongNoteAreInSight() {
        for (const QSize& size : {QSize(1280, 800), QSize(1366, 768)}) {
            WindowFixture on;
            QVERIFY(showWith(on, placed_));
            QTRY_VERIFY((on.window.resize(size), on.window.size() == size));
            const QListWidget& list = *on.viewer.targetsPanel.measures();
            for (std::uint32_t n = 0; n < 3; ++n)
                on.viewer.targets.keepMeasure({inspect::MeasureKind::Distance, {60 * 160 + 20 + n, 60 * 160 + 120}, {}});
            on.viewer.views.pin(60 * 160 + 80);
            QVERIFY(known(on));
            const auto* distance = on.viewer.targetsPanel.findChild<QLabel*>("target-distance");
            QTRY_VERIFY(distance->isVisible() && distance->visibleRegion().boundingRect().height() == distance->height());
            const auto rowsInSight = [&] {
                int rows = 0;
                for (int n = 0; n < list.count(); ++n)
                    rows += list.viewport()->visibleRegion().boundingRect().contains(list.visualItemRect(list.item(n))) ? 1 : 0;
                return rows;
            };
            QTRY_VERIFY2(rowsInSight() >= 1, qPrintable(QString::number(rowsInSight())));
            // Without the card there are more of them, and the buttons above them stay where they are, but for a row of a long position:
            // the scroll bar makes it two.
            const QWidget& above = *on.viewer.targetsPanel.section();
            const int place = above.y();
            on.viewer.targets.chooseMeasure(0);
            QTRY_VERIFY2(rowsInSight() >= 2, qPrintable(QString::number(rowsInSight())));
            QVERIFY2(std::abs(above.y() - place) <= list.fontMetrics().height(), qPrintable(QString::number(above.y() - place)));
            on.viewer.views.pin(60 * 160 + 80);
            QTRY_VERIFY(distance->isVisible() && distance->visibleRegion().boundingRect().height() == distance->height());
            QVERIFY2(std::abs(above.y() - place) <= list.fontMetrics().height(), qPrintable(QString::number(above.y() - place)));
            const QString note = "watch the left shoulder, it moved since the last shift and the second shot may free it";
            on.viewer.targets.setNote(1, note);
            const auto* whole = on.viewer.targetsPanel.findChild<QLabel*>("target-whole-note");
            QTRY_VERIFY(whole->isVisible() && whole->text() == note && whole->height() >= whole->heightForWidth(whole->width()));
            on.viewer.targets.setNote(1, "loose");
            QTRY_VERIFY(!whole->isVisible());
        }
    }

    void withAPoseTheCardHasMineCoordinatesAndDip() {
        WindowFixture on;
        QVERIFY(showWith(on, placed_));
        const Scan& scan = *on.picture().detection->scan;
        click(on.viewer.views.gray(), 90, 20);
        QVERIFY(known(on));
        const std::uint32_t k = targets(on).front().cell;
        QVERIFY(scan.state[k] == CellState::Valid);
        const Eigen::Vector3d mine = minePoint(scan, k).enhM;
        const QString text = on.viewer.targetsPanel.card().text();
        QVERIFY2(
            text.contains(QString("E, N, RL [m]: %1, %2, %3").arg(mine.x(), 0, 'f', 3).arg(mine.y(), 0, 'f', 3).arg(mine.z(), 0, 'f', 3)),
            qPrintable(text));
        QVERIFY2(!text.contains("no pose"), qPrintable(text));
        const inspect::CellTarget target = inspect::targetAt(*on.picture().detection, inspect::noiseOf(*on.picture().detection), k);
        QVERIFY(target.boom.has_value());
        QVERIFY2(text.contains(QString("From the boom: %1 m").arg(target.boom->distanceM, 0, 'f', 2)), qPrintable(text));
    }

    void targetsAreKeptWithTheirScan() {
        const QString ini = QString::fromStdString((folder_ / "kept" / "viewer.ini").string());
        QDir().mkpath(QString::fromStdString((folder_ / "kept").string()));
        inspect::Notebook before;
        {
            WindowFixture on(ini);
            QVERIFY(showWith(on, boxes_));
            click(on.viewer.views.gray(), 20, 30);
            click(on.viewer.views.gray(), 60, 80);
            QVERIFY(known(on));
            QLineEdit* name = on.viewer.targetsPanel.card().name();
            name->setFocus();
            QTest::keyClicks(name, "keystone");
            QTest::keyClick(name, Qt::Key_Return);
            QCOMPARE(targets(on)[1].name, std::string("keystone"));
            QVERIFY(on.viewer.views.gray().marks().targets[1].tag.startsWith("2 keystone"));
            on.viewer.targets.keepMeasure({inspect::MeasureKind::Distance, {targets(on)[0].cell, targets(on)[1].cell}});
            // Another scan has its own targets; back on this scan they are restored.
            QVERIFY(on.open(plate_));
            QVERIFY(targets(on).empty());
            const auto says = [&](const QString& words) {
                const auto labels = on.viewer.targetsPanel.findChildren<QLabel*>();
                return std::ranges::any_of(labels, [&](QLabel* each) { return each->isVisible() && each->text().contains(words); });
            };
            QVERIFY(says("Targets and measurements of the previous scan: 3."));
            QVERIFY2(on.viewer.notice.isVisible() && on.viewer.notice.text().contains("open it again"),
                     qPrintable(on.viewer.notice.text()));
            QVERIFY(on.open(boxes_));
            QVERIFY(!says("of the previous scan"));
            QCOMPARE(static_cast<int>(targets(on).size()), 2);
            QVERIFY(known(on));
            before = on.viewer.targets.notebook();
            QVERIFY(!before.targets[0].asPinned.empty());
        }
        const QDir kept(QString::fromStdString((folder_ / "kept" / "targets").string()));
        QCOMPARE(kept.entryList(QDir::Files).size(), 1);
        const std::string file = kept.filePath(kept.entryList(QDir::Files).front()).toStdString();
        {
            WindowFixture again(ini);
            QVERIFY(showWith(again, boxes_));
            QVERIFY(again.window.viewer().targets.notebook() == before);
            QTRY_COMPARE(static_cast<int>(again.window.viewer().views.cloud().marks().targets.size()), 2);
        }
        // A damaged file is refused with a sentence. It is not changed, whatever targets are set then.
        const std::string damaged = "{\"format\": \"edgescan-targets/1\", \"targets\": [{\"cell\": [9999, 0]}]}";
        QVERIFY(bool(writeWholeFile(file, damaged)));
        {
            WindowFixture third(ini);
            QVERIFY(showWith(third, boxes_));
            QVERIFY(third.window.viewer().notice.isVisible() && third.window.viewer().notice.kind() == NoticeBar::Kind::Error);
            QVERIFY2(third.window.viewer().notice.text().contains("move the file away"), qPrintable(third.window.viewer().notice.text()));
            QVERIFY(targets(third).empty());
            click(third.window.viewer().views.gray(), 60, 80);
            QVERIFY(known(third));
        }
        QCOMPARE(test::fileText(file), damaged);
    }

    void measuringHangsOnCells() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        ImageView& gray = on.viewer.views.gray();
        QTest::keyClick(&on.window, Qt::Key_U);
        QVERIFY2(on.viewer.tools.shown().contains("click one end"), qPrintable(on.viewer.tools.shown()));
        const std::vector<std::uint32_t> ends{nearSideUnder(on, 20, 30), nearSideUnder(on, 90, 120)};
        click(gray, 20, 30);
        QVERIFY(targets(on).empty()); // no target
        QVERIFY2(on.viewer.tools.shown().contains("click the other end"), qPrintable(on.viewer.tools.shown()));
        // The empty panel does not ask for a pin while a tool waits for another click.
        QCOMPARE(on.viewer.targetsPanel.findChild<QLabel*>("targets-asked")->text(), on.viewer.tools.shown());
        click(on.viewer.views.edges(), 90, 120);
        QVERIFY(known(on));
        QCOMPARE(static_cast<int>(on.viewer.targets.notebook().measures.size()), 1);
        QVERIFY(on.viewer.targets.notebook().measures[0].cells == ends);
        const CloudGeometry& cloud = *on.viewer.views.cloud().geometryOfCloud();
        const double between = static_cast<double>((cloud.point(ends[0]) - cloud.point(ends[1])).norm());
        const QString label = gray.marks().measures[0].label;
        QVERIFY2(lengthIn(label).startsWith(QString("%1 m ± 0.").arg(between, 0, 'f', 3)), qPrintable(label));
        QVERIFY(gray.marks() == on.viewer.views.cloud().marks() && gray.marks() == on.viewer.views.edges().marks());
        // The list has the value and the first warning; the rest is below it, for the chosen measurement.
        const auto* remarks = on.viewer.targetsPanel.findChild<QLabel*>("measure-remarks");
        QVERIFY(remarks->isVisible() && remarks->text().contains("ranges ") && remarks->text().contains(" / "));
        QVERIFY(on.viewer.targetsPanel.measures()->item(0)->text().count('\n') <= 1);
        // An end that is not on an edge is named.
        const edges::Detection& detection = *on.picture().detection;
        const auto isOff = [&](std::uint32_t end) { return (*detection.mask)[end] == 0; }; // as in the status bar
        const bool first = isOff(ends[0]), second = isOff(ends[1]);
        QVERIFY(first || second);
        const QString off = first && second ? "2 ends not on an edge" : QString("end %1 not on an edge").arg(first ? 1 : 2);
        QVERIFY2(remarks->text().contains(off), qPrintable(remarks->text()));
        // The lines and the label are on the screen, in the cloud too.
        const auto blue = [](QRgb p) {
            return std::abs(qRed(p) - 120) < 12 && std::abs(qGreen(p) - 190) < 12 && std::abs(qBlue(p) - 255) < 12;
        };
        QVERIFY(countPixels(gray.grab().toImage(), blue) > 60);
        QTRY_VERIFY(countPixels(on.window.screenshot(), blue) > 300);
        // An angle takes three clicks; Backspace takes the last one back, Esc leaves the tool.
        QTest::keyClick(&on.window, Qt::Key_A);
        click(gray, 20, 30);
        click(gray, 60, 100);
        QTest::keyClick(&on.window, Qt::Key_Backspace);
        QCOMPARE(static_cast<int>(on.viewer.measures.picked().size()), 1);
        click(gray, 60, 100);
        click(gray, 100, 20);
        QVERIFY(known(on));
        QCOMPARE(static_cast<int>(on.viewer.targets.notebook().measures.size()), 2);
        QVERIFY(gray.marks().measures[1].label.contains("°"));
        on.viewer.notice.hide();
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(!on.viewer.measures.kind() && on.viewer.views.tool() == Tool::Pin);
        // A row of the list is chosen by a click, and a target or Esc ends that.
        QListWidget& rows = *on.viewer.targetsPanel.measures();
        QVERIFY(gray.marks().measures[1].active && rows.currentRow() == 1);
        QTest::mouseClick(rows.viewport(), Qt::LeftButton, Qt::NoModifier, rows.visualItemRect(rows.item(0)).center());
        QVERIFY(gray.marks().measures[0].active && !gray.marks().measures[1].active && rows.currentRow() == 0);
        on.viewer.views.pin(ends[0]);
        QVERIFY(!gray.marks().measures[0].active && gray.marks().targets[0].active && rows.currentRow() == -1);
        QVERIFY(!on.viewer.targetsPanel.removeMeasure()->isEnabled());
        on.viewer.targets.remove(1);
        on.viewer.targets.chooseMeasure(0);
        on.viewer.notice.hide();
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(!on.viewer.targets.chosenMeasure());
        // A slider does not change them; undo removes them.
        edges::Settings other;
        other.creaseDeg = 50;
        QVERIFY(on.use(other));
        QVERIFY(known(on));
        QCOMPARE(gray.marks().measures[0].label, label);
        on.viewer.targetsPanel.measures()->setCurrentRow(0);
        QTest::mouseClick(on.viewer.targetsPanel.removeMeasure(), Qt::LeftButton);
        QCOMPARE(static_cast<int>(gray.marks().measures.size()), 1);
        on.viewer.undo.undo();
        QCOMPARE(static_cast<int>(gray.marks().measures.size()), 2);
    }

    // Below the long card of a target, on the smallest desk.
    void whatWasJustMeasuredIsInSightInThePanel() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        on.window.resize(1280, 800);
        ImageView& gray = on.viewer.views.gray();
        click(gray, 60, 80);
        QVERIFY(known(on));
        const QListWidget& list = *on.viewer.targetsPanel.measures();
        QTest::keyClick(&on.window, Qt::Key_U);
        click(gray, 20, 30);
        click(gray, 90, 120);
        QVERIFY(known(on));
        QCOMPARE(list.count(), 1);
        QTRY_VERIFY(list.visibleRegion().boundingRect().contains(list.viewport()->geometry().topLeft() +
                                                                 list.visualItemRect(list.item(0)).center()));
    }

    // Each has two rows, the list scrolls by itself, and the card of a target stays in sight above it.
    void sixMeasurementsLeaveTheCardItsPlace() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        on.window.resize(1280, 800);
        ImageView& gray = on.viewer.views.gray();
        for (const std::uint32_t n : {0U, 1U, 2U, 3U, 4U, 5U})
            on.viewer.targets.keepMeasure({inspect::MeasureKind::Distance, {20 * 160 + 30 + n, 90 * 160 + 100}, {}});
        click(gray, 60, 80);
        QVERIFY(known(on));
        const QListWidget& list = *on.viewer.targetsPanel.measures();
        QCOMPARE(list.count(), 6);
        QVERIFY2(list.item(1)->text().remove(QString::fromUtf8("▲ ")).startsWith("M2  "), qPrintable(list.item(1)->text()));
        const int row = list.fontMetrics().lineSpacing();
        for (int n = 0; n < list.count(); ++n) QVERIFY(list.visualItemRect(list.item(n)).height() < 3 * row);
        QVERIFY2(list.height() < 8 * row && list.verticalScrollBar()->maximum() > 0, qPrintable(QString::number(list.height())));
        const QWidget& card = on.viewer.targetsPanel.card();
        QTRY_VERIFY2(card.visibleRegion().boundingRect().height() > 6 * row,
                     qPrintable(QString::number(card.visibleRegion().boundingRect().height())));
    }

    // Each of the other kinds by its key and clicks; the shown value equals the core's value for these cells.
    void everyKindIsMeasuredByClicks() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        ImageView& gray = on.viewer.views.gray();
        const std::vector<QPoint> places{{30, 20}, {120, 90}, {40, 95}, {130, 30}}; // beam, line
        int made = 0;
        for (const auto& [kind, key, modifier, clicks] : {std::tuple{inspect::MeasureKind::Vertical, Qt::Key_V, Qt::NoModifier, 2},
                                                          {inspect::MeasureKind::Angle, Qt::Key_A, Qt::NoModifier, 3},
                                                          {inspect::MeasureKind::Spans, Qt::Key_Y, Qt::NoModifier, 4},
                                                          {inspect::MeasureKind::Path, Qt::Key_U, Qt::ShiftModifier, 2}}) {
            QTest::keyClick(&on.window, key, modifier);
            std::vector<std::uint32_t> cells;
            for (int n = 0; n < clicks; ++n) {
                const QPoint at = places[static_cast<std::size_t>(n)];
                cells.push_back(nearSideUnder(on, at.y(), at.x()));
                click(gray, at.y(), at.x());
            }
            QVERIFY(eventually([&] { return known(on) && static_cast<int>(on.viewer.targets.notebook().measures.size()) == made + 1; }));
            const inspect::StoredMeasure& kept = on.viewer.targets.notebook().measures.back();
            QVERIFY(kept.kind == kind && kept.cells == cells);
            const auto measured = inspect::measureCells(*on.picture().detection->scan, {}, kind, cells);
            QVERIFY(bool(measured));
            const QString label = gray.marks().measures.back().label;
            // The noise measured by the window differs from this one: only the values are equal.
            const double value = kind == inspect::MeasureKind::Angle ? measured->angleDeg : measured->lengths.front().valueM;
            const double shown = lengthIn(label).replace(QChar(0xb0), ' ').section(' ', 0, 0).toDouble();
            QVERIFY2(std::abs(shown - value) < (kind == inspect::MeasureKind::Angle ? 0.06 : 0.006), qPrintable(label));
            QVERIFY2(label.contains("±"), qPrintable(label));
            QCOMPARE(label.endsWith("up is assumed"), kind == inspect::MeasureKind::Vertical); // the scan has no pose
            QVERIFY(gray.marks() == on.viewer.views.cloud().marks());
            ++made;
        }
    }

    void whatIsNotResolvedIsNoNumber() {
        WindowFixture on;
        QVERIFY(showWith(on, plate_));
        QTest::keyClick(&on.window, Qt::Key_U);
        click(on.viewer.views.gray(), 20, 20);
        click(on.viewer.views.gray(), 20, 21);
        QVERIFY(known(on));
        QCOMPARE(on.viewer.views.gray().marks().measures[0].label, QString("M1 < 89 mm"));
        QVERIFY2(on.viewer.targetsPanel.measures()->item(0)->text().contains("< 89 mm"),
                 qPrintable(on.viewer.targetsPanel.measures()->item(0)->text()));
    }

    void oneSelectionEverywhere() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        ImageView& gray = on.viewer.views.gray();
        CloudView& cloud = on.viewer.views.cloud();
        Selection& selection = on.viewer.selection;
        QTest::keyClick(&on.window, Qt::Key_B);
        const QVector<QPoint> box{pixelOf(gray, 40, 50), pixelOf(gray, 45, 70), pixelOf(gray, 69, 99)};
        drag(gray, box);
        inspect::CellSet wanted;
        const QPoint from = *gray.cellAt(box.front()), to = *gray.cellAt(box.back());
        for (int i = from.y(); i <= to.y(); ++i) {
            for (int j = from.x(); j <= to.x(); ++j) wanted.push_back(static_cast<std::uint32_t>(i * 160 + j));
        }
        QVERIFY(selection.cells() == wanted);
        QVERIFY(cloud.selection() && *cloud.selection() == wanted);
        QVERIFY(gray.selection() && gray.selection() == on.viewer.views.edges().selection());
        QVERIFY(qAlpha(gray.selection()->pixel(60, 50)) > 0 && qAlpha(gray.selection()->pixel(20, 50)) == 0);
        QVERIFY(targets(on).empty());
        QVERIFY2(on.viewer.tools.shown().contains("cells selected"), qPrintable(on.viewer.tools.shown()));
        // Shift adds, Ctrl removes; a lasso follows the mouse.
        QTest::keyClick(&on.window, Qt::Key_L);
        const QVector<QPoint> lasso{pixelOf(gray, 90, 20), pixelOf(gray, 90, 60), pixelOf(gray, 110, 40), pixelOf(gray, 100, 25)};
        drag(gray, lasso, Qt::ShiftModifier);
        QVERIFY(selection.cells().size() > wanted.size() + 100);
        QVERIFY(inspect::without(wanted, selection.cells()).empty());
        QVERIFY(std::ranges::binary_search(selection.cells(), 95U * 160 + 40) &&
                !std::ranges::binary_search(selection.cells(), 108U * 160 + 22));
        drag(gray, lasso, Qt::ControlModifier);
        QVERIFY(selection.cells() == wanted);
        // Hidden cells are dark in the images and absent from the cloud; showing all restores them.
        const std::size_t points = cloud.geometryOfCloud()->validCount;
        QTest::keyClick(&on.window, Qt::Key_I, Qt::ShiftModifier);
        QVERIFY(selection.cells().empty() && selection.hidden() == wanted);
        QVERIFY(cloud.geometryOfCloud()->validCount < points && !cloud.geometryOfCloud()->drawable(wanted[5]));
        QVERIFY(qAlpha(gray.selection()->pixel(60, 50)) > 200);
        QVERIFY(on.viewer.tools.shown().contains("hidden"));
        on.viewer.undo.undo();
        QVERIFY(selection.cells() == wanted && cloud.geometryOfCloud()->validCount == points);
        QTest::keyClick(&on.window, Qt::Key_I);
        std::size_t left = 0;
        for (const std::uint32_t k : wanted) left += on.picture().detection->scan->state[k] == CellState::Valid ? 1 : 0;
        QCOMPARE(cloud.geometryOfCloud()->validCount, left);
        // A slider does not change it.
        edges::Settings other;
        other.creaseDeg = 50;
        QVERIFY(on.use(other));
        QCOMPARE(cloud.geometryOfCloud()->validCount, left);
        QVERIFY(selection.cells() == wanted && !cloud.selection()); // if only the selection is visible it needs no colour
        QTest::keyClick(&on.window, Qt::Key_I, Qt::ControlModifier);
        QCOMPARE(cloud.geometryOfCloud()->validCount, points);
        QVERIFY(cloud.selection() && *cloud.selection() == wanted);
        // Another scan has no selection.
        QVERIFY(on.open(plate_));
        QVERIFY(selection.cells().empty() && selection.hidden().empty() && !gray.selection() && !cloud.selection());
    }

    void theCloudSelectsWhatIsSeen() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        CloudView& cloud = on.viewer.views.cloud();
        QTest::keyClick(&on.window, Qt::Key_B);
        const CameraPose before = cloud.camera();
        const QPoint middle = cloud.rect().center();
        drag(cloud, {middle - QPoint(60, 50), middle, middle + QPoint(60, 50)});
        QTRY_VERIFY(!on.viewer.selection.cells().empty());
        QVERIFY(cloud.camera() == before);
        const ScreenView view = cloud.screenView();
        const double dpr = cloud.devicePixelRatioF();
        const QRectF box = QRectF(QPointF(middle - QPoint(60, 50)) * dpr, QPointF(middle + QPoint(60, 50)) * dpr).adjusted(-1, -1, 1, 1);
        const CloudGeometry& points = *cloud.geometryOfCloud();
        std::size_t seen = 0;
        for (std::uint32_t k = 0; k < points.cells(); ++k) {
            if (!points.drawable(k)) continue;
            const ScreenPoint at = toScreen(view, points.point(k));
            const bool chosen = std::ranges::binary_search(on.viewer.selection.cells(), k);
            if (chosen) QVERIFY(box.contains(at.x, at.y) && !isPointHidden(points, view, k));
            seen += at.inside && box.adjusted(2, 2, -2, -2).contains(at.x, at.y) && !isPointHidden(points, view, k) ? 1 : 0;
        }
        QVERIFY(seen > 50 && on.viewer.selection.cells().size() >= seen);
        // Esc: the tool first, then the selection.
        on.viewer.notice.hide();
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(!on.viewer.selection.cells().empty() && on.viewer.views.tool() == Tool::Pin);
        QTest::keyClick(&on.window, Qt::Key_Escape);
        QVERIFY(on.viewer.selection.cells().empty());
    }

    void aClickSelectsTheChainOfAnEdge() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        const edges::Detection& detection = *on.picture().detection;
        QTest::keyClick(&on.window, Qt::Key_L);
        const std::uint32_t k = detection.edges->at(detection.edges->size() / 2);
        emit on.viewer.views.gray().clicked(static_cast<int>(k / 160), static_cast<int>(k % 160));
        const inspect::CellSet chain = inspect::chainAt(*detection.mask, k);
        QVERIFY(chain.size() > 4 && on.viewer.selection.cells() == chain);
        // A click outside edges and rocks selects nothing, and gives the reason.
        std::uint32_t none = 0;
        while ((*detection.mask)[none] != 0) ++none;
        emit on.viewer.views.gray().clicked(static_cast<int>(none / 160), static_cast<int>(none % 160));
        QVERIFY(on.viewer.selection.cells() == chain);
        QVERIFY2(on.viewer.notice.text().contains("show them first"), qPrintable(on.viewer.notice.text()));
    }

    void aRockIsSelectedAndStandsOnTheCard() {
        sim::SimulationSettings settings;
        settings.seed = 4711;
        settings.lines = 250;
        settings.beams = 286;
        const std::string bell = (folder_ / "bell.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, bell)));
        WindowFixture on;
        QVERIFY(showWith(on, bell));
        QTest::keyClick(&on.window, Qt::Key_K);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() && !on.viewer.rocks.behind(); }));
        const RockPicture& rocks = *on.viewer.rocks.picture();
        const rocks::Rock& largest = rocks.study.rocks.front();
        on.viewer.views.pin(largest.cell);
        QVERIFY(known(on));
        const QString spans = QString("%1 × %2 ± ").arg(largest.longestCaliperM, 0, 'f', 2).arg(largest.shortestCaliperM, 0, 'f', 2);
        QVERIFY2(on.viewer.targetsPanel.card().text().contains("Rock, visible: " + spans),
                 qPrintable(on.viewer.targetsPanel.card().text()));
        // A click with the tool selects all its cells; the selection of rocks does not change.
        QTest::keyClick(&on.window, Qt::Key_B);
        std::uint32_t inside = largest.cell;
        while (rocks.labelAt(inside) == 1 && (*on.picture().detection->mask)[inside] != 0) ++inside;
        QCOMPARE(rocks.labelAt(inside), 1U);
        emit on.viewer.views.gray().clicked(static_cast<int>(inside / 286), static_cast<int>(inside % 286));
        inspect::CellSet wanted;
        for (std::size_t k = 0; k < rocks.labels.size(); ++k) {
            if (rocks.labels[k] == 1) wanted.push_back(static_cast<std::uint32_t>(k));
        }
        QVERIFY(on.viewer.selection.cells() == wanted);
        QVERIFY(on.viewer.rocks.selected() == std::vector<std::size_t>{largest.cell});
        // Isolated: only this rock is in the cloud; its face keeps its colour.
        QTest::keyClick(&on.window, Qt::Key_I);
        QVERIFY(on.viewer.views.cloud().geometryOfCloud()->validCount <= wanted.size());
        QVERIFY(on.viewer.views.cloud().faces() != nullptr);
    }

    void anExportOfTheSelectionCarriesItsRecord() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        inspect::CellSet cells;
        for (std::uint32_t k = 0; k < 120U * 160; k += 1 + k % 7) cells.push_back(k);
        on.viewer.selection.select(cells);
        ExportDialog dialog(on.picture().detection, exports::ExportContent::FullCloud,
                            {std::make_shared<const inspect::CellSet>(on.viewer.selection.cells()), true});
        auto* only = dialog.findChild<QCheckBox*>("onlySelected");
        QVERIFY(only->isChecked());
        std::size_t valid = 0;
        for (const std::uint32_t k : cells) valid += on.picture().detection->scan->state[k] == CellState::Valid ? 1 : 0;
        QCOMPARE(dialog.count(), valid);
        QVERIFY(dialog.options().selection != nullptr);
        const std::string path = (folder_ / "selected.pcd").string();
        QSignalSpy saved(&on.viewer.engine, &Engine::saved);
        on.viewer.engine.save(dialog.content(), QString::fromStdString(path), dialog.options());
        QTRY_COMPARE(saved.count(), 1);
        QCOMPARE(saved.front().at(2).toLongLong(), static_cast<qint64>(valid));
        const auto verified = exports::verifyExport(path);
        QVERIFY(bool(verified));
        QVERIFY2(verified->identical, exports::verificationText(*verified).c_str());
        only->setChecked(false);
        QVERIFY(dialog.options().selection == nullptr && dialog.count() > valid);
    }

    // Keys alone zoom images and cloud in and out.
    void plusAndMinusZoomWhatHasTheFocus() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        ImageView& gray = on.viewer.views.gray();
        CloudView& cloud = on.viewer.views.cloud();
        gray.setFocus();
        const double zoom = gray.viewPort()->zoom();
        click(gray, 20, 30);
        QVERIFY(on.settled()); // the card makes the cloud narrower, and the view from the scanner fits it
        const double distance = cloud.camera().distance();
        for (int n = 0; n < 8; ++n) QTest::keyClick(&gray, Qt::Key_Plus);
        QVERIFY(gray.viewPort()->zoom() > 4 * zoom && cloud.camera().distance() == distance);
        const QPointF now = gray.viewPort()->toPixel(QPointF(30.5, 20.5), gray.size());
        QVERIFY2(gray.rect().contains(now.toPoint()), "the pinned cell stays in sight");
        for (int n = 0; n < 8; ++n) QTest::keyClick(&gray, Qt::Key_Minus);
        QVERIFY(gray.viewPort()->zoom() < 1.3 * zoom);
        cloud.setFocus();
        QTest::keyClick(&cloud, Qt::Key_Plus);
        QVERIFY(cloud.camera().distance() < 0.85 * distance);
        QTest::keyClick(&cloud, Qt::Key_Minus);
        QVERIFY(std::abs(cloud.camera().distance() - distance) < 1e-6);
    }

    void arrowsPointAndReturnClicks() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        ImageView& gray = on.viewer.views.gray();
        gray.setFocus();
        QTest::keyClick(&gray, Qt::Key_Right);
        QCOMPARE(*gray.markedCell(), QPoint(81, 60)); // from the middle
        QTest::keyClick(&gray, Qt::Key_Up);
        QTest::keyClick(&gray, Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(*gray.markedCell(), QPoint(71, 59));
        QCOMPARE(*on.viewer.views.edges().markedCell(), QPoint(71, 59));
        QVERIFY2(on.viewer.statusLine.probeShown().contains("line 59  beam 71"), qPrintable(on.viewer.statusLine.probeShown()));
        QTest::keyClick(&gray, Qt::Key_Return);
        QCOMPARE(static_cast<int>(targets(on).size()), 1);
        QCOMPARE(targets(on).front().cell, 59U * 160 + 71);
        // With a cell pinned the cursor moves on, in all views, and does not change the pin; it never leaves the grid.
        for (int n = 0; n < 30; ++n) QTest::keyClick(&gray, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(*gray.markedCell(), QPoint(71, 119));
        QCOMPARE(*on.viewer.views.edges().markedCell(), QPoint(71, 119));
        QCOMPARE(*on.viewer.views.edges().crosshair(), QPoint(71, 59));
        QTest::keyClick(&gray, Qt::Key_Return);
        QCOMPARE(targets(on).back().cell, 119U * 160 + 71);
        // When zoomed in, the view follows the cursor.
        gray.viewPort()->fitTo(QRectF(60, 100, 10, 10));
        for (int n = 0; n < 5; ++n) QTest::keyClick(&gray, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(gray.rect().contains(pixelOf(gray, 119, 121)));
    }

    void everyCommandIsFoundByItsName() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        QStringList seen;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            auto* palette = on.window.findChild<CommandPalette*>();
            if (palette == nullptr || !palette->isVisible()) return;
            look.stop();
            const int all = palette->list()->count();
            QTest::keyClicks(palette->words(), "vert meas");
            seen << QString::number(all) << QString::number(palette->list()->count()) << palette->list()->item(0)->text();
            QTest::keyClick(palette->words(), Qt::Key_Return);
        });
        look.start(30);
        QTest::keyClick(&on.window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(static_cast<int>(seen.size()), 3);
        QVERIFY2(seen[0].toInt() > 60 && seen[1] == "1" && seen[2].startsWith("Measure > Vertical"), qPrintable(seen.join(' ')));
        QVERIFY(on.viewer.measures.kind() == inspect::MeasureKind::Vertical);
    }

    void thePaletteSaysThatNothingWasFound() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_));
        CommandPalette palette(on.window.actions(), &on.window);
        palette.show();
        const auto* none = palette.findChild<QLabel*>("palette-none");
        QVERIFY(!none->isVisible());
        QTest::keyClicks(palette.words(), "zzz");
        QVERIFY(none->isVisible() && none->text().startsWith("No command has these words"));
        QVERIFY(palette.list()->viewport()->rect().contains(none->geometry()));
        // Everyday words find commands too.
        for (const char* typed : {"rock borders", "export csv", "edge list", "measure", "pdf", "boulders", "oversize", "before after"}) {
            palette.words()->setText(typed);
            QVERIFY2(none->isHidden(), typed);
        }
        palette.words()->setText("zzz");
        QTest::keyClick(palette.words(), Qt::Key_Return);
        QVERIFY(palette.isVisible() && palette.chosen() == nullptr);
        palette.words()->clear();
        QVERIFY(!none->isVisible());
        QTest::mouseClick(palette.findChild<QPushButton*>("palette-close"), Qt::LeftButton); // a cab has no Escape key
        QVERIFY(!palette.isVisible() && palette.chosen() == nullptr);
    }

    // From the menu, the tool bar and the palette; off, with its reason, while there are no targets.
    void targetsAreExportedAsFiles() {
        WindowFixture on;
        QVERIFY(showWith(on, placed_));
        QAction* command = nullptr;
        for (const KeyedCommand& each : keyedCommands(on.window.actions())) {
            if (each.id == "File/Export/Targets") command = each.action;
        }
        QVERIFY(command != nullptr && !command->isEnabled());
        QVERIFY2(command->toolTip().startsWith("There are no targets yet"), qPrintable(command->toolTip()));
        QVERIFY(on.window.findChild<QToolButton*>("tool-export")->menu()->actions().contains(command));
        on.viewer.views.pin(cellUnder(on, 60, 80));
        on.viewer.views.pin(cellUnder(on, 20, 30));
        QVERIFY(known(on) && command->isEnabled());
        on.viewer.targets.rename(1, "keystone");
        on.viewer.targets.setNote(2, "loose");
        for (const QString name : {"targets.csv", "targets.dxf"}) {
            const QString path = QString::fromStdString((folder_ / name.toStdString()).string());
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            exports::ExportOptions options;
            options.frame = CoordinateFrame::Mine;
            options.targets = std::make_shared<const std::vector<inspect::PinnedTarget>>(targets(on));
            on.viewer.engine.save(exports::ExportContent::Targets, path, options);
            QVERIFY(eventually([&] { return saved.count() == 1 && !on.viewer.engine.working(); }));
            const QString said = on.viewer.notice.text();
            QVERIFY2(said.contains("2 targets") && said.contains("Mine grid: E "), qPrintable(said));
            const auto same = exports::verifyExport(exactBytes(path));
            QVERIFY(same && same->identical);
            const std::string text = test::fileText(path.toStdString());
            QVERIFY(text.find("keystone") != text.npos && text.find("loose") != text.npos);
        }
        on.viewer.undo.undo(); // the note
        QVERIFY(targets(on)[1].note.empty());
        on.viewer.targets.removeAll();
        QVERIFY(!command->isEnabled());
    }

    // The list takes the free height of its dock, in whole rows, before it scrolls.
    void theListOfTargetsTakesTheFreeHeight() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_) && on.activate());
        QTRY_VERIFY((on.window.resize(1900, 1040), on.window.width() == 1900));
        for (const auto& [line, beam] : {std::pair{60, 80}, {30, 40}, {90, 120}, {30, 120}, {90, 40}, {60, 40}}) {
            click(on.viewer.views.gray(), line, beam);
            QVERIFY(known(on));
        }
        QListWidget& list = *on.viewer.targetsPanel.targets();
        const auto isWhole = [&] {
            const QRect last = list.visualItemRect(list.item(list.count() - 1));
            return list.count() == 6 && last.bottom() <= list.viewport()->height() && list.visualItemRect(list.item(0)).top() >= 0;
        };
        auto* dock = on.window.findChild<QDockWidget*>("dock-targets");
        on.window.resizeDocks({on.window.findChild<QDockWidget*>("dock-edges"), dock}, {100, 900}, Qt::Vertical);
        QTRY_VERIFY2(isWhole(), qPrintable(QString("%1 px of %2").arg(list.height()).arg(dock->height())));
        on.window.resizeDocks({on.window.findChild<QDockWidget*>("dock-edges"), dock}, {900, 300}, Qt::Vertical);
        QTRY_VERIFY2(!isWhole() && list.verticalScrollBar()->isVisible(), "without room it scrolls");
        const int rows = list.viewport()->height() / list.visualItemRect(list.item(0)).height();
        QVERIFY2(rows >= 3, qPrintable(QString::number(rows)));
    }

    // What follows from the scan is read in a narrow list: the note and the name lose letters.
    void aRowOfTheListKeepsTheClassOfItsEdge() {
        WindowFixture on;
        QVERIFY(showWith(on, boxes_) && on.activate());
        QTRY_VERIFY((on.window.resize(1280, 800), on.window.width() == 1280));
        on.viewer.views.pin(on.picture().detection->edges->front());
        QVERIFY(known(on));
        const QString edge = on.viewer.targetsPanel.targets()->item(0)->text().section('\n', 0, 0).section("   ", -1);
        QTest::keyClicks(on.viewer.targetsPanel.card().note(), "look at it again after the next blast");
        QTest::keyClick(on.viewer.targetsPanel.card().note(), Qt::Key_Return);
        on.viewer.targets.rename(1, "the keystone at the left");
        const QListWidget& list = *on.viewer.targetsPanel.targets();
        QTRY_VERIFY(list.item(0)->text().contains("keystone") && list.item(0)->text().contains("blast"));
        struct Peek : QStyledItemDelegate {
            using QStyledItemDelegate::initStyleOption;
        };
        QStyleOptionViewItem option;
        option.widget = &list;
        option.font = list.font();
        option.fontMetrics = list.fontMetrics();
        const auto* rows = static_cast<const QStyledItemDelegate*>(list.itemDelegate());
        (rows->*(&Peek::initStyleOption))(&option, list.model()->index(0, 0));
        const QString shown = option.text.section(QChar(QChar::LineSeparator), 0, 0);
        QVERIFY2(shown.startsWith("1  the keys") && shown.contains(" m ") && shown.contains("   " + edge.left(4)), qPrintable(shown));
        QVERIFY2(!shown.contains("blast"), qPrintable(shown));
        // The name comes before the sign of the lock, and the tool tip has all of it.
        on.viewer.targets.lock(1, true);
        QTRY_VERIFY(!list.item(0)->icon().isNull());
        (rows->*(&Peek::initStyleOption))(&option, list.model()->index(0, 0));
        const QString locked = option.text.section(QChar(QChar::LineSeparator), 0, 0);
        QVERIFY2(locked.startsWith("1  the keys") && locked.contains(" m ") && locked.contains("   " + edge.left(4)), qPrintable(locked));
        for (const QString& all : {QString("the keystone at the left"), QString("locked"), edge, QString("blast")})
            QVERIFY2(list.item(0)->toolTip().contains(all), qPrintable(list.item(0)->toolTip()));
    }

    void aTargetHasANote() {
        const QString ini = QString::fromStdString((folder_ / "notes" / "viewer.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(showWith(on, boxes_));
            click(on.viewer.views.gray(), 60, 80);
            QVERIFY(known(on));
            QLineEdit* note = on.viewer.targetsPanel.card().note();
            QTest::keyClicks(note, "watch it");
            QTest::keyClick(note, Qt::Key_Return);
            QCOMPARE(targets(on)[0].note, std::string("watch it"));
            QVERIFY(on.viewer.targetsPanel.targets()->item(0)->text().section('\n', 0, 0).endsWith("watch it"));
            QVERIFY(on.viewer.targetsPanel.card().text().contains("Note: watch it"));
            on.viewer.targets.copyAll();
            QVERIFY(QGuiApplication::clipboard()->text().trimmed().endsWith("\twatch it"));
            on.viewer.undo.undo();
            QVERIFY(targets(on)[0].note.empty() && note->text().isEmpty());
            on.viewer.undo.redo();
            // The menu of its row, and of its pin, which is larger than its cell.
            QListWidget* list = on.viewer.targetsPanel.targets();
            const QStringList wanted{"Name of Target 1…", "Note on Target 1…", "Remove Target 1"};
            const auto hasAll = [&](QWidget* view, QPoint at) {
                QStringList entries;
                QTimer look;
                connect(&look, &QTimer::timeout, this, [&] {
                    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
                    if (menu == nullptr) return;
                    for (const QAction* each : menu->actions()) entries << each->text().remove('&');
                    QTest::keyClick(menu, Qt::Key_Escape);
                });
                look.start(30);
                if (view == list->viewport()) {
                    QContextMenuEvent event(QContextMenuEvent::Mouse, at, view->mapToGlobal(at));
                    QApplication::sendEvent(view, &event);
                } else {
                    QTest::mouseClick(view, Qt::RightButton, Qt::NoModifier, at);
                }
                return std::ranges::all_of(wanted, [&](const QString& each) { return entries.contains(each); });
            };
            QVERIFY(hasAll(list->viewport(), list->visualItemRect(list->item(0)).center()));
            ImageView& gray = on.viewer.views.gray();
            const QPoint cell = on.viewer.views.placeOf(targets(on)[0].cell);
            QVERIFY(hasAll(&gray, pixelOf(gray, cell.y(), cell.x()) + QPoint(5, 0)));
            QVERIFY(!hasAll(&gray, pixelOf(gray, cell.y(), cell.x()) + QPoint(25, 0)));
            const auto answer = [&](const QString& text, const std::function<void()>& ask) {
                QTimer look;
                connect(&look, &QTimer::timeout, this, [&] {
                    auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
                    if (dialog == nullptr) return;
                    dialog->setTextValue(text);
                    dialog->accept();
                });
                look.start(30);
                ask();
            };
            answer("blast first", [&] { on.viewer.targets.askNote(1); });
            answer("keystone", [&] { on.viewer.targets.askNameOf(1); });
            QVERIFY(targets(on)[0].note == "blast first" && targets(on)[0].name == "keystone");
        }
        WindowFixture again(ini);
        QVERIFY(showWith(again, boxes_));
        QCOMPARE(targets(again)[0].note, std::string("blast first"));
    }

    void pageDownGoesThroughTheFolder() {
        const std::filesystem::path folder = folder_ / "series";
        std::filesystem::create_directories(folder);
        for (const int lines : {20, 30, 40})
            QVERIFY(bool(files::saveScan(test::boxesScan(lines, 60, 3), folder / ("scan" + std::to_string(lines) + ".json"))));
        QVERIFY(bool(writeWholeFile((folder / "scan30.pcd.provenance.json").string(), std::string("{}"))));
        WindowFixture on;
        QVERIFY(showWith(on, (folder / "scan20.json").string()));
        const auto lines = [&] { return on.picture().detection->scan->lines(); };
        QTest::keyClick(&on.window, Qt::Key_PageDown);
        QTRY_COMPARE(lines(), 30);
        QVERIFY(on.settled());
        QTest::keyClick(&on.window, Qt::Key_PageDown);
        QTRY_COMPARE(lines(), 40);
        QVERIFY(on.settled());
        QTest::keyClick(&on.window, Qt::Key_PageDown);
        QVERIFY2(on.viewer.notice.text().contains("last scan"), qPrintable(on.viewer.notice.text()));
        QTest::keyClick(&on.window, Qt::Key_PageUp);
        QTRY_COMPARE(lines(), 30);
        QVERIFY(on.settled());
    }

    void theBadgeSaysWhereThePictureComesFrom() {
        Scan scan = test::boxesScan(120, 160, 3);
        Acquisition measured;
        measured.startUtc = "2026-03-04T05:06:07.000Z";
        measured.clockSource = "the robot's clock";
        scan.acquisition = std::make_shared<const Acquisition>(measured);
        const std::string timed = (folder_ / "timed.json").string(), recording = (folder_ / "recorded.mcap").string();
        QVERIFY(bool(files::saveScan(scan, timed)));
        QVERIFY(bool(files::saveScan(scan, recording)));
        WindowFixture on;
        QVERIFY(on.show());
        QCOMPARE(on.viewer.origin.text(), QString("NO PICTURE"));
        QVERIFY(on.open(boxes_));
        QCOMPARE(on.viewer.origin.text(), QString("FILE boxes · no time"));
        QVERIFY(on.viewer.origin.sign() == StateBadge::Sign::File);
        QVERIFY(on.open(recording));
        QVERIFY2(on.viewer.origin.text().startsWith("RECORDED "), qPrintable(on.viewer.origin.text()));
        QVERIFY(on.viewer.origin.sign() == StateBadge::Sign::Recorded);
        QVERIFY(on.open(timed));
        const std::string start = on.picture().detection->scan->acquisition ? on.picture().detection->scan->acquisition->startUtc : "";
        const QString time = start.empty() ? QString("no time") : QString("2026-03-04 05:06:07 UTC");
        QCOMPARE(on.viewer.origin.text(), "FILE timed · " + time);
        // Visible at every size, and in a screenshot; in a narrow window shortened, and the tool tip has all of it.
        for (const QSize size : {QSize(853, 533), QSize(1280, 800), QSize(1900, 1000)}) {
            QTRY_VERIFY((on.window.resize(size), on.window.size() == size)); // the timeline of the recording closes first
            QApplication::processEvents();
            const StateBadge& badge = on.viewer.origin;
            const QRect place(badge.mapTo(&on.window, QPoint()), badge.size());
            QVERIFY(badge.isVisible() && on.window.rect().contains(place));
            QVERIFY(badge.toolTip().contains(badge.text()));
            QVERIFY2(badge.width() >= (size.width() < 1280 ? badge.minimumSizeHint().width() : badge.sizeHint().width()),
                     qPrintable(QString("%1 of %2").arg(badge.width()).arg(badge.sizeHint().width())));
            const QImage shot = on.window.screenshot();
            const auto ground = [](QRgb p) { return p == qRgb(77, 83, 90); };
            QVERIFY(countPixels(shot.copy(place), ground) > place.width() * place.height() / 3);
        }
    }
};

int targets_test(int argc, char** argv) { return runWindowTest<TargetsTest>(argc, argv); }

#include "targets_test.moc"
