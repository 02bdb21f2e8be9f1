// Pointing, clicking, boxes and menus in the three views, and undo.
#include "core/edges/settings/presets.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/reading_dialog.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/tuning/edges_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"
#include "ui/window/tool_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTimer>

using namespace edgescan;
using namespace edgescan::ui;

class PointingTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string boxes_, interlaced_;
    std::unique_ptr<WindowFixture> on_;
    MainWindow* window_ = nullptr;

    static void move(QWidget& view, QPoint at, Qt::MouseButtons buttons = Qt::NoButton, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, modifiers);
        QApplication::sendEvent(&view, &event);
    }
    [[nodiscard]] static QPoint pixelOf(const ImageView& view, int line, int beam) {
        return view.viewPort()->toPixel(QPointF(beam + 0.5, line + 0.5), view.size()).toPoint();
    }
    void escape() {
        window_->viewer().notice.hide();
        QVERIFY(on_->activate());
        window_->viewer().views.cloud().setFocus();
        QTest::keyClick(window_, Qt::Key_Escape);
    }
    // Chooses an entry of the menu that a right click opens.
    bool chooseInMenu(QWidget& view, QPoint at, const QString& words) {
        bool found = false;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (menu == nullptr) return;
            look.stop();
            for (QAction* action : menu->actions()) {
                if (!action->text().remove('&').contains(words)) continue;
                found = true;
                return QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(action).center());
            }
            QTest::keyClick(menu, Qt::Key_Escape);
        });
        look.start(30);
        QTest::mouseClick(&view, Qt::RightButton, Qt::NoModifier, at);
        return found;
    }

private slots:
    void initTestCase() {
        boxes_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(120, 160, 3, 0.02), boxes_)));
        sim::SimulationSettings settings;
        settings.lines = 250;
        settings.beams = 286;
        settings.seed = 3;
        settings.interlaceDeg = 0.36;
        interlaced_ = (folder_ / "interlaced.json").string();
        QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, interlaced_)));
    }
    void init() {
        on_ = std::make_unique<WindowFixture>();
        window_ = &on_->window;
        window_->resize(1400, 850);
        QVERIFY(on_->showWith(boxes_));
    }
    void cleanup() { on_.reset(); }

    // The crosshair stays at the pin. Status bar, ring and Why follow the pointer while it is over a view, and the card says which cell it
    // explains.
    void aClickPinsTheCellUntilItIsLetGo() {
        ImageView& gray = window_->viewer().views.gray();
        ImageView& edges = window_->viewer().views.edges();
        CloudView& cloud = window_->viewer().views.cloud();
        const std::uint32_t k = on_->picture().detection->edges->at(5);
        const int line = static_cast<int>(k) / 160, beam = static_cast<int>(k) % 160;
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::NoModifier, pixelOf(gray, line, beam));
        QVERIFY(window_->viewer().views.pinned().has_value());
        const std::size_t pinned = *window_->viewer().views.pinned();
        const auto explained = [&] {
            QVERIFY(on_->activate());
            QTest::keyClick(window_, Qt::Key_W);
            QTRY_VERIFY(window_->viewer().explanation.card() != nullptr && window_->viewer().explanation.card()->isVisible());
        };
        const auto isAt = [&](std::size_t cell, const QString& subject) {
            const QString status = window_->viewer().statusLine.probeShown();
            const auto beams = std::size_t{160};
            QVERIFY2(status.contains(QString("line %1  beam %2").arg(cell / beams).arg(cell % beams)), qPrintable(status));
            QCOMPARE(status.startsWith("Pinned: "), cell == pinned);
            QCOMPARE(static_cast<std::size_t>(*cloud.markedCell()), cell);
            for (ImageView* view : {&gray, &edges}) QCOMPARE(*view->crosshair(), window_->viewer().views.placeOf(pinned));
            explained();
            const WhyCard& card = *window_->viewer().explanation.card();
            QTRY_VERIFY2(card.text().startsWith(QString("line %1, beam %2:").arg(cell / beams).arg(cell % beams)), qPrintable(card.text()));
            QCOMPARE(card.cell(), QString("Cell: line %1, beam %2 (%3)").arg(cell / beams).arg(cell % beams).arg(subject));
        };
        emit gray.hoverLeft();
        isAt(pinned, "the pinned target");
        if (QTest::currentTestFailed()) return;
        for (ImageView* view : {&gray, &edges}) {
            move(*view, pixelOf(*view, 100, 20));
            move(*view, pixelOf(*view, 10, 150));
            isAt(10 * 160 + 150, "under the pointer, not the pinned target");
            if (QTest::currentTestFailed()) return;
            emit view->hoverLeft();
        }
        isAt(pinned, "the pinned target");
        if (QTest::currentTestFailed()) return;
        // A change of another setting does not move it either.
        edges::Settings other;
        other.creaseDeg = 50;
        QVERIFY(on_->use(other));
        QCOMPARE(*window_->viewer().views.pinned(), pinned);
        escape(); // the topmost item first
        QVERIFY(!window_->viewer().explanation.card()->isVisible());
        QCOMPARE(*window_->viewer().views.pinned(), pinned);
        escape();
        QVERIFY(!window_->viewer().views.pinned());
        move(gray, pixelOf(gray, 100, 20));
        QVERIFY(window_->viewer().statusLine.probeShown().contains("line 100  beam 20"));
        explained();
        QCOMPARE(window_->viewer().explanation.card()->cell(), QString("Cell: line 100, beam 20 (under the pointer)"));
    }

    // On the desk and in a cab, of every size, the card is next to the cell that it explains.
    void whyDoesNotCoverItsCell() {
        WindowFixture on;
        QVERIFY(on.showWith(boxes_) && on.activate());
        for (const bool cab : {false, true}) {
            on.window.cab().set(cab);
            for (const QSize size : {QSize(853, 533), QSize(1024, 768), QSize(1280, 775)}) {
                if (cab && size.width() == 853) continue; // the card has no room next to the middle of the cloud
                on.window.resize(size);
                QTRY_COMPARE(on.window.size(), size);
                on.viewer.cloud.viewFromScanner();
                QVERIFY(on.settled());
                for (const auto& [line, beam] : {std::pair{60, 80}, {30, 40}, {90, 120}, {30, 120}, {90, 40}}) {
                    on.viewer.views.pin(on.viewer.views.cellAt(line, beam));
                    on.viewer.views.pointAt(std::nullopt);
                    on.viewer.explanation.explainMarked();
                    const auto place = on.viewer.cloud.pixelOf(static_cast<std::uint32_t>(*on.viewer.views.pinned()));
                    const auto shown = [&] {
                        const WhyCard* card = on.viewer.explanation.card();
                        return card != nullptr && card->isVisible() && !card->picture().profile().points.empty();
                    };
                    QTRY_VERIFY(shown());
                    if (!place || !on.viewer.cloud.rect().contains(place->toPoint())) continue;
                    const QRect card(on.viewer.explanation.card()->frameGeometry());
                    const QString where = QString("cab %1, %2: %3, %4").arg(cab).arg(size.width()).arg(line).arg(beam);
                    QVERIFY2(!card.contains(on.viewer.cloud.mapToGlobal(place->toPoint())), qPrintable(where));
                    for (const ImageView* image : {&on.viewer.gray, &on.viewer.edges}) {
                        if (cab || size.width() < 1280 || !image->isVisible()) continue;
                        QVERIFY2(!card.contains(image->mapToGlobal(pixelOf(*image, line, beam))), qPrintable(where + " in an image"));
                    }
                    const auto* panel = on.window.findChild<EdgesPanel*>(); // the operator tunes while he reads
                    const QRect tuning(panel->mapToGlobal(QPoint(0, 0)), panel->size());
                    QVERIFY2(size.width() < 1024 || !panel->isVisible() || panel->visibleRegion().isEmpty() || !card.intersects(tuning),
                             qPrintable(where));
                    if (beam == 40) on.viewer.explanation.closeCard(); // for the next one it is where it was, or comes again
                }
                on.viewer.explanation.closeCard();
            }
        }
        on.window.cab().set(false);
    }

    // Edges are drawn wider than a cell: Why means the edge that is drawn under the pointer, and the very cell once zoomed in.
    void whyMeansTheEdgeDrawnUnderThePointer() {
        ImageView& gray = window_->viewer().views.gray();
        const Grid<std::uint8_t>& mask = *on_->picture().detection->mask;
        const auto isBare = [&](int line, int beam) { return mask.contains(line, beam) && mask.at(line, beam) == 0; };
        const auto edges = *on_->picture().detection->edges;
        const auto found = std::ranges::find_if(edges, [&](std::uint32_t k) {
            return isBare(static_cast<int>(k) / 160, static_cast<int>(k) % 160 + 1) && static_cast<int>(k) % 160 > 20;
        });
        QVERIFY(found != edges.end());
        const int line = static_cast<int>(*found) / 160, beam = static_cast<int>(*found) % 160 + 1;
        const auto subject = [&] {
            move(gray, pixelOf(gray, line, beam));
            QTest::keyClick(window_, Qt::Key_W);
            const WhyCard* card = window_->viewer().explanation.card();
            return card == nullptr ? QString() : card->cell();
        };
        QVERIFY(on_->activate());
        gray.viewPort()->fit();
        if (gray.viewPort()->cellSize().width() > 1.0)
            gray.viewPort()->zoomAt(QPointF(beam, line), 1.0 / gray.viewPort()->cellSize().width());
        QVERIFY2(subject().endsWith("(the nearest edge)"), qPrintable(subject()));
        gray.viewPort()->zoomAt(QPointF(beam, line), 20.0 / gray.viewPort()->cellSize().width());
        QCOMPARE(subject(), QString("Cell: line %1, beam %2 (under the pointer)").arg(line).arg(beam));
        // While the card is open, a click asks about its cell.
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::ShiftModifier, pixelOf(gray, line, beam + 1));
        QVERIFY2(window_->viewer().explanation.card()->cell().contains(QString("beam %1").arg(beam + 1)),
                 qPrintable(window_->viewer().explanation.card()->cell()));
        // That of a target is about its very cell, also where the image is small.
        gray.viewPort()->zoomAt(QPointF(beam, line), 1.0 / gray.viewPort()->cellSize().width());
        window_->viewer().views.pinByClick(inspect::exactly(static_cast<std::size_t>(line * 160 + beam)));
        emit gray.hoverLeft();
        window_->viewer().explanation.explainMarked();
        QCOMPARE(window_->viewer().explanation.card()->cell(), QString("Cell: line %1, beam %2 (the pinned target)").arg(line).arg(beam));
        window_->viewer().targets.removeAll();
        window_->viewer().views.clearPin();
    }

    // The button of the tool bar leaves no cell under the pointer: the next click says which one, and pins nothing until the card is
    // closed.
    // A pixel of a small edge map shows several cells: what is light there is an edge for the status bar and for a click.
    void aPixelOfASmallEdgeMapIsItsEdge() {
        ImageView& edges = window_->viewer().views.edges();
        const auto& mask = *on_->picture().detection->mask;
        window_->viewer().views.clearPin();
        window_->places().setShare(Share::Cloud);
        QTRY_VERIFY(edges.width() < 350);
        edges.viewPort()->fit();
        edges.viewPort()->zoomAt(edges.viewPort()->centre(), 0.3 / edges.viewPort()->cellSize(edges.size()).height());
        QVERIFY(edges.viewPort()->cellSize(edges.size()).height() < 0.5);
        int tried = 0;
        for (std::size_t n = 0; n < on_->picture().detection->edges->size(); n += 11) {
            const std::uint32_t k = (*on_->picture().detection->edges)[n];
            const auto [line, beam] = std::pair(static_cast<int>(k) / 160, static_cast<int>(k) % 160);
            const QPoint at = pixelOf(edges, line, beam);
            move(edges, at + QPoint(9, 9)); // leaves the cell before
            move(edges, at);
            const auto hovered = window_->viewer().views.hovered();
            QVERIFY(hovered && mask[*hovered] != 0);
            ++tried;
        }
        QVERIFY(tried > 10);
        window_->places().setShare(Share::Balanced);
        edges.viewPort()->fit();
    }

    void whyWaitsForAClickThatPinsNothing() {
        ImageView& gray = window_->viewer().views.gray();
        const auto targets = [&] { return window_->viewer().targets.notebook().targets.size(); };
        const auto press = [&] {
            QToolButton* button = nullptr;
            for (auto* each : window_->viewer().tools.findChildren<QToolButton*>()) {
                if (each->defaultAction() != nullptr && each->defaultAction()->text().remove('&').startsWith("Why Is")) button = each;
            }
            emit gray.hoverLeft();
            QTest::mouseClick(button, Qt::LeftButton);
            return button;
        };
        const QToolButton* button = press();
        QVERIFY(button->isChecked() && window_->viewer().tools.shown() == "Why: click a cell");
        press();
        QVERIFY2(!button->isChecked() && window_->viewer().tools.shown().isEmpty(), "a second press ends it");
        press();
        for (const auto& [line, beam] : {std::pair{60, 80}, {30, 40}}) {
            QTest::mouseClick(&gray, Qt::LeftButton, Qt::ShiftModifier, pixelOf(gray, line, beam));
            const WhyCard* card = window_->viewer().explanation.card();
            QVERIFY(card != nullptr && card->isVisible());
            QVERIFY2(card->cell().contains(QString("line %1, beam %2").arg(line).arg(beam)), qPrintable(card->cell()));
            QVERIFY(!window_->viewer().views.pinned() && targets() == 0);
        }
        escape();
        QVERIFY(!window_->viewer().explanation.card()->isVisible() && !button->isChecked());
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::NoModifier, pixelOf(gray, 60, 80));
        QCOMPARE(targets(), std::size_t{1});
        QVERIFY(!window_->viewer().explanation.card()->isVisible());
        // With a pin it explains that, and the next clicks pin no other.
        press();
        QTRY_VERIFY(window_->viewer().explanation.card()->isVisible());
        QVERIFY2(window_->viewer().explanation.card()->cell().endsWith("(the pinned target)"),
                 qPrintable(window_->viewer().explanation.card()->cell()));
        // In the ring of a target, the centre means the target, and the rest what is there.
        const WhyCard& card = *window_->viewer().explanation.card();
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::ShiftModifier, pixelOf(gray, 60, 80));
        QVERIFY2(card.cell().endsWith("(the target that you clicked)"), qPrintable(card.cell()));
        const QPoint inRing = pixelOf(gray, 60, 80) + QPoint(0, 7);
        const QPoint there = *gray.cellAt(inRing);
        QVERIFY(there != QPoint(80, 60));
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::ShiftModifier, inRing);
        QCOMPARE(card.cell(), QString("Cell: line %1, beam %2 (the cell that you clicked)").arg(there.y()).arg(there.x()));
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::NoModifier, pixelOf(gray, 30, 40));
        QCOMPARE(targets(), std::size_t{1});
        QTest::keyClick(window_, Qt::Key_P);
        QTest::mouseClick(&gray, Qt::LeftButton, Qt::NoModifier, pixelOf(gray, 30, 40));
        QCOMPARE(targets(), std::size_t{2});
    }

    void theMenuOfACellIsTheSameInEveryView() {
        CloudView& cloud = window_->viewer().views.cloud();
        std::uint32_t cell = 0;
        const auto pixel = [&] { // docks and cards that open move it
            const auto at = cloud.pixelOf(cell);
            return at && cloud.rect().adjusted(250, 50, -50, -250).contains(at->toPoint()) && cloud.cellAt(at->toPoint()) == cell
                       ? std::optional(at->toPoint())
                       : std::nullopt;
        };
        for (const std::uint32_t k : *on_->picture().detection->edges) {
            cell = k;
            if (!window_->viewer().views.nearSideCell(k).moved() && pixel()) break;
        }
        QVERIFY(pixel());
        QVERIFY(chooseInMenu(cloud, *pixel(), "Why"));
        QTRY_VERIFY(window_->viewer().explanation.card() != nullptr && window_->viewer().explanation.card()->isVisible());
        QTRY_VERIFY(window_->viewer().explanation.card()->text().startsWith(QString("line %1, beam %2:").arg(cell / 160).arg(cell % 160)));
        QVERIFY(!window_->viewer().views.pinned()); // asking for an explanation sets no target
        QTRY_VERIFY(pixel());
        QVERIFY(chooseInMenu(cloud, *pixel(), "Pin"));
        QCOMPARE(*window_->viewer().views.pinned(), std::size_t{cell});
        QTRY_VERIFY(pixel());
        QVERIFY(chooseInMenu(cloud, *pixel(), "Remove Target 1"));
        QVERIFY(!window_->viewer().views.pinned());
        ImageView& gray = window_->viewer().views.gray();
        const CameraPose before = cloud.camera();
        QVERIFY(chooseInMenu(gray, pixelOf(gray, 60, 80), "Fly to this point"));
        QVERIFY(!(cloud.camera() == before));
    }

    void aBoxBringsAllViewsCloser() {
        ImageView& gray = window_->viewer().views.gray();
        const double zoom = gray.viewPort()->zoom();
        const CameraPose before = window_->viewer().views.cloud().camera();
        const QPoint from = pixelOf(gray, 40, 50), to = pixelOf(gray, 70, 100);
        QTest::mousePress(&gray, Qt::LeftButton, Qt::ShiftModifier, from);
        for (int i = 1; i <= 5; ++i) move(gray, from + (to - from) * i / 5, Qt::LeftButton, Qt::ShiftModifier);
        QTest::mouseRelease(&gray, Qt::LeftButton, Qt::ShiftModifier, to);
        QVERIFY(window_->viewer().views.edges().box().has_value());
        QCOMPARE(*window_->viewer().views.edges().box(), *gray.box());
        QVERIFY(gray.viewPort()->zoom() > 1.5 * zoom);
        QVERIFY(!(window_->viewer().views.cloud().camera() == before));
        const auto* boxLabel = window_->findChild<QLabel*>("box");
        window_->resize(1900, 850);
        QTRY_VERIFY(boxLabel->isVisible());
        std::size_t edges = 0;
        const QRect box = *gray.box();
        for (const std::uint32_t k : *on_->picture().detection->edges)
            edges += box.contains(static_cast<int>(k) % 160, static_cast<int>(k) / 160) ? 1 : 0;
        QVERIFY2(boxLabel->text().contains(QString(", %1 edge cells").arg(edges)), qPrintable(boxLabel->text()));
        escape();
        QVERIFY(!gray.box() && !window_->viewer().views.edges().box() && !boxLabel->isVisible());
        QVERIFY(gray.viewPort()->zoom() > 1.5 * zoom);
        QVERIFY(chooseInMenu(gray, pixelOf(gray, 60, 80), "Fit the images"));
        QVERIFY(gray.viewPort()->fitted());
        QVERIFY(!chooseInMenu(gray, pixelOf(gray, 60, 80), "Fit the images")); // nothing is left to show
    }

    void edgesOverTheRangeImageHaveTheColoursOfTheirClasses() {
        QVERIFY(on_->activate());
        QTest::keyClick(window_, Qt::Key_O);
        const edges::Detection& detection = *on_->picture().detection;
        const auto colourOfClass = [&](edges::DepthEdge kind) -> std::optional<QRgb> {
            for (const std::uint32_t k : *detection.edges) {
                if ((*detection.classes)[k] == kind)
                    return window_->viewer().views.gray().overlay()->pixel(static_cast<int>(k) % 160, static_cast<int>(k) / 160);
            }
            return std::nullopt;
        };
        const QRgb jump = *colourOfClass(edges::DepthEdge::Jump); // as strong as it is likely to be the border of a rock
        QVERIFY(qGreen(jump) > 0 && qRed(jump) == 0 && qBlue(jump) == 0);
        QTest::keyClick(window_, Qt::Key_C);
        int classes = 0;
        for (int n = 0; n < kEdgeClasses; ++n) {
            const auto colour = colourOfClass(static_cast<edges::DepthEdge>(n + 1));
            if (!colour) continue;
            ++classes;
            QCOMPARE(*colour, kUsualColours[static_cast<std::size_t>(n)].rgb());
        }
        QVERIFY(classes >= 2);
        QTest::keyClick(window_, Qt::Key_C, Qt::ShiftModifier); // the colour-blind palette
        QCOMPARE(*colourOfClass(edges::DepthEdge::Jump), kColourBlindColours.front().rgb());
        edges::Settings other;
        other.creaseDeg = 40; // a new picture keeps them
        QVERIFY(on_->use(other));
        QCOMPARE(
            window_->viewer().views.gray().overlay()->pixel(static_cast<int>(on_->picture().detection->edges->front()) % 160,
                                                            static_cast<int>(on_->picture().detection->edges->front()) / 160),
            kColourBlindColours[static_cast<std::size_t>((*on_->picture().detection->classes)[on_->picture().detection->edges->front()]) -
                                1]
                .rgb());
        QTest::keyClick(window_, Qt::Key_C);
        QCOMPARE(window_->viewer().views.gray().overlay()->pixel(static_cast<int>(on_->picture().detection->edges->front()) % 160,
                                                                 static_cast<int>(on_->picture().detection->edges->front()) / 160),
                 kColourBlindColours.front().rgb());
    }

    void aMethodThatIsVisitedLeavesTheThresholdAsItWas() {
        const auto choose = [&](const char* label) {
            window_->viewer().panel.row("method")->choice()->setCurrentText(label);
            QVERIFY(on_->settled());
        };
        for (const double lower : {1.0, 2.3, 6.0, 33.0}) {
            edges::Settings canny = edges::cannySettings();
            canny.lower = lower;
            QVERIFY(on_->use(canny));
            for (const char* visited : {"Laplacian (LoG)", "Marr-Hildreth", "Roberts", "Kirsch", "EdgeScan+", "Laplacian (LoG)"})
                choose(visited);
            choose("Canny (thesis)");
            QCOMPARE(window_->viewer().engine.settings().lower, lower);
            // Also after a change of another setting there, undone and redone.
            choose("Laplacian (LoG)");
            window_->viewer().panel.row("kernel")->choice()->setCurrentIndex(2);
            choose("Canny (thesis)");
            QCOMPARE(window_->viewer().engine.settings().lower, lower);
            window_->viewer().undo.undo();
            window_->viewer().undo.undo();
            window_->viewer().undo.undo();
            window_->viewer().undo.redo();
            choose("Canny (thesis)");
            QCOMPARE(window_->viewer().engine.settings().lower, lower);
        }
        // A threshold chosen in that method is used again.
        choose("Laplacian (LoG)");
        window_->viewer().panel.row("lower")->number()->setValue(40);
        choose("Canny (thesis)");
        QVERIFY(window_->viewer().engine.settings().lower != 33.0);
    }

    void straighteningIsAStepOfUndo() {
        QVERIFY(on_->open(interlaced_));
        edges::Settings before;
        before.creaseDeg = 41;
        window_->viewer().panel.row("crease")->number()->setValue(41);
        QVERIFY(on_->settled());
        auto* straighten = window_->findChild<QAction*>("straighten");
        const auto straight = [&] {
            const auto& skew = std::get<PolarGeometry>(on_->picture().detection->scan->geometry).lineSkewDeg;
            return !skew.empty() && std::abs(skew[1] - skew[0]) > 0.2;
        };
        straighten->trigger();
        QVERIFY(eventually([&] { return straight(); }));
        QVERIFY(on_->activate());
        QTest::keyClick(window_, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(eventually([&] { return !straight(); }));
        QVERIFY(!straighten->isChecked());
        QCOMPARE(window_->viewer().engine.settings().creaseDeg, 41.0);
        QTest::keyClick(window_, Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(eventually([&] { return straight(); }));
        QVERIFY(straighten->isChecked());
        // The step of a closed file is obsolete: undo takes the step before it.
        QVERIFY(on_->open(boxes_));
        QTest::keyClick(window_, Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(window_->viewer().engine.settings().creaseDeg, 30.0);
        QCOMPARE(on_->picture().detection->scan->path, boxes_);
    }

    void howAScanIsReadIsPutRight() {
        const auto axis = [&] { return std::get<PolarGeometry>(on_->picture().detection->scan->geometry).axis; };
        sim::SimulationSettings settings;
        settings.lines = 60;
        settings.beams = 100;
        Scan scan = sim::simulate(settings)->scan;
        std::get<PolarGeometry>(scan.geometry).axis = Axis::Spin;
        const std::string path = (folder_ / "mounting.json").string();
        QVERIFY(bool(files::saveScan(scan, path)));
        QVERIFY(on_->open(path));
        QVERIFY(axis() == Axis::Spin);
        const auto answer = [&](const char* key, const QString& text, bool refused = false) {
            QTimer look;
            bool shown = false;
            connect(&look, &QTimer::timeout, this, [&] {
                auto* dialog = window_->findChild<ReadingDialog*>();
                if (dialog == nullptr || !dialog->isVisible()) return;
                if (auto* list = dialog->findChild<QComboBox*>(key)) list->setCurrentText(text);
                if (auto* edit = dialog->findChild<QLineEdit*>(key)) edit->setText(text);
                QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
                shown = dialog->findChild<QLabel*>("refusal")->isVisible();
                if (dialog->isVisible()) dialog->reject();
            });
            look.start(30);
            window_->viewer().files.askReading();
            QCOMPARE(shown, refused);
        };
        answer("axis", "sweep");
        QTRY_VERIFY(axis() == Axis::Sweep);
        QVERIFY(on_->settled());
        answer("line-step", "nonsense", true);
        answer("line-start", "12.5");
        QTRY_COMPARE(std::get<PolarGeometry>(on_->picture().detection->scan->geometry).lineDeg.front(), 12.5);
        QVERIFY(axis() == Axis::Sweep);
        QVERIFY(on_->settled());
        window_->viewer().undo.undo();
        QVERIFY(on_->settled());
        window_->viewer().undo.undo();
        QTRY_VERIFY(axis() == Axis::Spin);
        // A unit may be a number: it stays where another field changes, and can be typed.
        ReadingOptions inCounts = window_->viewer().files.options();
        inCounts.unitMm = 2.5;
        window_->viewer().files.readAgain(inCounts, "unit");
        QVERIFY(on_->settled());
        answer("line-start", "3");
        QVERIFY(on_->settled());
        QCOMPARE(window_->viewer().files.options().unitMm.value_or(0), 2.5);
        answer("unit", "nonsense", true);
        answer("unit", "1.5");
        QVERIFY(on_->settled());
        QCOMPARE(window_->viewer().files.options().unitMm.value_or(0), 1.5);
        // A refused option leaves scan and options unchanged.
        answer("pose", "/no/such/pose.json");
        QTRY_VERIFY(window_->viewer().notice.isVisible() && window_->viewer().notice.kind() == NoticeBar::Kind::Error);
        QVERIFY(on_->settled());
        QVERIFY(window_->viewer().files.options().pose.empty());
    }
};

int pointing_test(int argc, char** argv) { return runWindowTest<PointingTest>(argc, argv); }

#include "pointing_test.moc"
