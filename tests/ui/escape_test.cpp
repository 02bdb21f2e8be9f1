// One press of Esc ends one thing, in the order of docs/guide/keys.md, whichever view has the keyboard focus, on the desk and in a cab.
#include "tests/ui/sized_window.h"
#include "ui/base/notice_bar.h"
#include "ui/base/pane.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/start/tour.h"
#include "ui/window/cab_mode.h"
#include "ui/window/pane_places.h"
#include "ui/window/start.h"
#include "ui/window/theme.h"
#include "ui/window/tool_bar.h"

#include <QDialog>
#include <QLineEdit>
#include <QSpinBox>

#include <algorithm>
#include <functional>
#include <vector>

using namespace edgescan;
using namespace edgescan::ui;

class EscapeTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string boxes_;

    static std::vector<QWidget*> viewsOf(WindowFixture& on) { return {&on.viewer.gray, &on.viewer.edges, &on.viewer.cloud}; }
    static bool pinned(WindowFixture& on) {
        on.viewer.views.pin(on.picture().detection->edges->at(on.picture().detection->edges->size() / 2));
        return eventually([&] { return on.viewer.targets.settled() && on.viewer.targets.active() != nullptr; });
    }
    static void press(QWidget& widget, Qt::Key key = Qt::Key_Escape) { QTest::keyClick(&widget, key); }
    static bool inTool(WindowFixture& on) {
        return on.viewer.measures.kind() || on.viewer.views.tool() != Tool::Pin || on.viewer.rocks.tool() != RockTool::None;
    }
    static void clickOnRange(WindowFixture& on, int line, int beam) { emit on.viewer.gray.clicked(line, beam); }
    void showRocks(WindowFixture& on, bool cab) {
        QVERIFY(on.showWith(boxes_) && on.activate());
        on.window.cab().set(cab);
        on.viewer.rocks.setShown(true);
        QVERIFY(eventually([&] { return on.viewer.rocks.picture() != nullptr && !on.viewer.rocks.behind(); }));
    }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        boxes_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(boxesToShow(), boxes_)));
    }
    void cleanup() { useTheme(*qApp); }

    void onePressLeavesATool_data() {
        QTest::addColumn<bool>("cab");
        QTest::newRow("desk") << false;
        QTest::newRow("cab") << true;
    }
    void onePressLeavesATool() {
        QFETCH(bool, cab);
        WindowFixture on;
        showRocks(on, cab);
        QVERIFY(pinned(on));
        const auto target = on.viewer.targets.active()->number;
        const auto left = [&](QWidget& view, const QString& what) {
            on.viewer.notice.showHint("a hint of the tool");
            QVERIFY2(inTool(on), qPrintable(what));
            press(view);
            QVERIFY2(!inTool(on), qPrintable(what + " in " + view.objectName()));
            QVERIFY2(on.viewer.measures.picked().empty() && !on.viewer.notice.isVisible(), qPrintable(what));
            QVERIFY2(on.viewer.targets.active() != nullptr && on.viewer.targets.active()->number == target, qPrintable(what));
        };
        for (QWidget* view : viewsOf(on)) {
            if (!view->isVisible()) continue; // a cab shows the cloud alone
            for (const inspect::MeasureTraits& each : inspect::measureTraits()) {
                if (!each.inViews) continue;
                for (std::size_t clicks = 0; clicks < each.cells; ++clicks) {
                    on.viewer.measures.start(each.kind);
                    for (std::size_t n = 0; n < clicks; ++n) clickOnRange(on, 20 + 30 * static_cast<int>(n), 40);
                    QCOMPARE(on.viewer.measures.picked().size(), clicks);
                    left(*view, QString("%1 after %2 clicks").arg(each.label).arg(clicks));
                }
            }
            for (const Tool tool : {Tool::Box, Tool::Lasso}) {
                on.viewer.views.setTool(tool);
                left(*view, "selection");
            }
            for (const RockTool tool : {RockTool::Split, RockTool::Join, RockTool::Cut, RockTool::Region}) {
                on.viewer.rocks.useTool(tool);
                left(*view, "rock tool");
            }
        }
    }

    // Whatever opened it closes it again; then letters are for the view.
    // After a number was typed the next letter is a command.
    void lettersAreKeysAgainAfterANumber() {
        WindowFixture on;
        showRocks(on, false);
        int fields = 0;
        for (auto* field : on.window.findChildren<QAbstractSpinBox*>()) {
            if (!field->isVisible() || !field->isEnabled()) continue;
            ++fields;
            for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
                field->setFocus();
                QTRY_VERIFY(field->hasFocus());
                press(*field, key);
                QVERIFY2(!field->hasFocus(), qPrintable(field->objectName()));
                QVERIFY(on.viewer.rocks.shown());
            }
        }
        QVERIFY2(fields > 3, qPrintable(QString::number(fields)));
        press(on.window, Qt::Key_K);
        QTRY_VERIFY(!on.viewer.rocks.shown());
    }

    void theRowOfTheAddressClosesAsItOpened() {
        WindowFixture on;
        QVERIFY(on.showWith(boxes_) && on.activate());
        LivePanel& panel = on.viewer.livePanel;
        auto* host = panel.findChild<QLineEdit*>("live-host");
        auto* port = panel.findChild<QSpinBox*>("live-port");
        QToolButton* connect = nullptr;
        for (auto* each : on.viewer.tools.findChildren<QToolButton*>()) {
            if (each->accessibleName() == "Connect") connect = each;
        }
        QVERIFY(connect != nullptr);
        const auto byKey = [&] { QTest::keyClick(&on.window, Qt::Key_L, Qt::ControlModifier); };
        const auto byButton = [&] { QTest::mouseClick(connect, Qt::LeftButton); };
        const std::vector<std::function<void()>> ways{
            byKey,
            byButton,
            [&] { press(*host); },
            [&] {
                port->setFocus();
                press(*port);
            },
            [&] {
                QTest::mouseClick(&on.viewer.gray, Qt::LeftButton);
                QVERIFY(on.viewer.gray.hasFocus());
                press(on.viewer.gray);
            },
            [&] { QTest::mouseClick(panel.findChild<QToolButton*>("live-close"), Qt::LeftButton); }};
        for (std::size_t n = 0; n < ways.size(); ++n) {
            n % 2 == 0 ? byKey() : byButton();
            QVERIFY(panel.isVisible() && host->hasFocus());
            on.viewer.notice.hide();
            ways[n]();
            QVERIFY2(!panel.isVisible(), qPrintable(QString::number(n)));
            QVERIFY(on.viewer.cloud.hasFocus() || on.viewer.gray.hasFocus());
        }
        byKey();
        host->setText("127.0.0.1");
        port->setValue(9); // nothing answers
        QTest::keyClick(host, Qt::Key_Return);
        QVERIFY(on.viewer.live.scanner().connected() && on.viewer.cloud.hasFocus());
        on.viewer.live.scanner().disconnectScanner();
    }

    void backspaceTakesOneClickBack() {
        WindowFixture on;
        QVERIFY(on.showWith(boxes_) && on.activate());
        on.viewer.measures.start(inspect::MeasureKind::Angle);
        clickOnRange(on, 20, 40);
        clickOnRange(on, 50, 40);
        press(on.viewer.gray, Qt::Key_Backspace);
        QCOMPARE(on.viewer.measures.picked().size(), std::size_t{1});
        press(on.viewer.cloud, Qt::Key_Backspace);
        press(on.viewer.cloud, Qt::Key_Backspace);
        QVERIFY(on.viewer.measures.picked().empty() && on.viewer.measures.kind());
    }

    // Note, view shown alone, tour, selection, card of the target: each takes one press, in images first too, which stays.
    void theOthersEndInTheirOrder() {
        for (const Share share : {Share::Balanced, Share::Images}) {
            for (int n = 0; n < 3; ++n) {
                WindowFixture on;
                on.window.resize(1600, 900);
                QVERIFY(on.showWith(boxes_) && on.activate());
                on.window.places().setShare(share);
                QVERIFY(pinned(on));
                on.viewer.selection.select({1, 2, 3});
                startTour(on.window);
                const auto& tour = *on.window.findChild<Tour*>("tour");
                on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "a note");
                QTest::keyClick(&on.window, Qt::Key_W);
                const auto card = [&] {
                    const auto* why = on.window.findChild<QDialog*>("why-card");
                    return why != nullptr && why->isVisible();
                };
                QTRY_VERIFY(card());
                QVERIFY(on.activate());
                QWidget& view = *viewsOf(on)[static_cast<std::size_t>(n)];
                press(view);
                QVERIFY(!card() && on.viewer.notice.isVisible());
                const auto panes = on.window.findChildren<Pane*>();
                Pane& pane = **std::ranges::find_if(panes, [&](const Pane* each) { return each->isAncestorOf(&view); });
                emit pane.maximiseRequested();
                const auto isAlone = [&] { return std::ranges::count_if(panes, &Pane::isVisible) == 1; };
                QVERIFY(isAlone());
                press(view);
                QVERIFY(!on.viewer.notice.isVisible() && isAlone());
                press(view);
                QVERIFY(!isAlone() && tour.isVisible());
                press(view);
                QVERIFY(!tour.isVisible() && on.viewer.notice.text().startsWith("The tour has ended"));
                press(view);
                QVERIFY(!on.viewer.notice.isVisible() && !on.viewer.selection.cells().empty());
                press(view);
                QVERIFY(on.viewer.selection.cells().empty() && on.viewer.targets.active() != nullptr);
                press(view);
                QVERIFY(on.viewer.targets.active() == nullptr && on.window.places().share() == share);
                QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t{1});
            }
        }
    }
};

int escape_test(int argc, char** argv) { return runWindowTest<EscapeTest>(argc, argv); }

#include "escape_test.moc"
