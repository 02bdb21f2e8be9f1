// "Does this look right?" in the real window: a file read in the wrong unit is told of, another reading is looked at, adopted and undone.
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/dialogs/opening_card.h"

#include <QAction>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

#include <fstream>

using namespace edgescan;
using namespace edgescan::ui;

class OpeningWindowTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string metres_;

    // Whole numbers that are tenths of a metre: taken as millimetres, ten to twenty times too near.
    static void writeTable(const std::string& path) {
        const Scan scan = test::boxesScan(40, 1141, 3, 0.0);
        std::ofstream file(path);
        for (int i = 0; i < scan.lines(); ++i) {
            for (int j = 0; j < scan.beams(); ++j)
                file << (j > 0 ? "," : "") << (scan.state.at(i, j) == CellState::Valid ? static_cast<int>(scan.rangeMm.at(i, j) / 10) : 0);
            file << "\n";
        }
    }
    static double medianM(WindowFixture& on) {
        const Scan& scan = *on.picture().detection->scan;
        std::vector<float> ranges;
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (scan.state[k] == CellState::Valid) ranges.push_back(scan.rangeMm[k]);
        }
        std::sort(ranges.begin(), ranges.end());
        return static_cast<double>(ranges[ranges.size() / 2]) / 1000.0;
    }
    // A click on the reading whose words begin so.
    static bool choose(OpeningCard& card, const QString& words) {
        QTreeWidget* list = card.list();
        for (int n = 0; n < list->topLevelItemCount(); ++n) {
            for (int m = 0; m < list->topLevelItem(n)->childCount(); ++m) {
                QTreeWidgetItem* row = list->topLevelItem(n)->child(m);
                if (!row->text(1).startsWith(words)) continue;
                list->scrollToItem(row);
                QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(row).center());
                return true;
            }
        }
        return false;
    }
    static bool checked(WindowFixture& on) {
        return on.settled() && QTest::qWaitFor([&] { return on.window.opening().points().has_value(); }, 20000);
    }

private slots:
    void initTestCase() {
        metres_ = (folder_ / "table.csv").string();
        writeTable(metres_);
    }

    void aWrongUnitIsToldLookedAtAdoptedAndUndone() {
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(metres_) && on.activate());
        QVERIFY(checked(on));
        const double asOpened = medianM(on);
        QVERIFY2(asOpened < 1.0, "the table was not taken as millimetres");
        auto* offer = on.window.notice().findChild<QToolButton*>("notice-action");
        QVERIFY2(offer->isVisible(), qPrintable(on.window.notice().text()));
        QTest::mouseClick(offer, Qt::LeftButton);
        OpeningCard* card = on.window.opening().card();
        QVERIFY(card != nullptr && QTest::qWaitForWindowExposed(card));
        QVERIFY(!card->isModal());
        // Looked at: the scan is ten times larger, and no step of undo was made.
        QVERIFY(choose(*card, "centimetres"));
        QVERIFY(QTest::qWaitFor([&] { return on.settled() && medianM(on) > 5 * asOpened; }, 20000));
        QVERIFY(!on.window.undoStack().canUndo());
        // Closed: as it was.
        card->reject();
        QVERIFY(QTest::qWaitFor([&] { return on.settled() && std::abs(medianM(on) - asOpened) < 0.01; }, 20000));
        QVERIFY(!on.window.files().options().unitMm);
        // Adopted: it stays, is one step, and undo brings back what was there.
        QVERIFY(checked(on));
        on.window.opening().show();
        QVERIFY(choose(*card, "centimetres"));
        QTest::mouseClick(card->adopt(), Qt::LeftButton);
        QVERIFY(QTest::qWaitFor([&] { return on.settled() && on.window.undoStack().count() == 1; }, 20000));
        card->reject();
        QVERIFY(QTest::qWaitFor([&] { return on.settled() && medianM(on) > 5 * asOpened; }, 20000));
        QCOMPARE(on.window.files().options().unitMm.value_or(0.0), 10.0);
        on.window.undoStack().undo();
        QVERIFY(QTest::qWaitFor([&] { return on.settled() && std::abs(medianM(on) - asOpened) < 0.01; }, 20000));
        QVERIFY(!on.window.files().options().unitMm);
    }

    void aFileThatSaysItselfAsksNothing() {
        WindowFixture on;
        const std::string path = (folder_ / "grid.json").string();
        QVERIFY(bool(saveScan(test::boxesScan(60, 80, 3, 0.0), path)));
        QVERIFY(on.showWith(path));
        QVERIFY(checked(on));
        QVERIFY2(!looksWrong(*on.window.opening().points()), "something speaks against a sweep that was simulated");
        QVERIFY(!on.window.notice().isVisible());
    }

    void theCardGoesWithItsScan() {
        WindowFixture on;
        QVERIFY(on.showWith(metres_) && on.activate());
        QVERIFY(checked(on));
        on.window.opening().show();
        QVERIFY(choose(*on.window.opening().card(), "metres"));
        const std::string path = (folder_ / "other.json").string();
        QVERIFY(bool(saveScan(test::boxesScan(60, 80, 3, 0.0), path)));
        QVERIFY(on.settled());
        QVERIFY(on.open(path));
        QVERIFY(!on.window.opening().card()->isVisible());
        QVERIFY(!on.window.files().options().unitMm);
        QCOMPARE(on.window.files().path(), QString::fromStdString(path));
    }

    void withoutAFileItSaysSo() {
        WindowFixture on;
        QVERIFY(on.show());
        on.window.opening().show();
        QVERIFY(on.window.notice().isVisible() && on.window.opening().card() == nullptr);
    }
};

int main(int argc, char** argv) { return runWindowTest<OpeningWindowTest>(argc, argv); }
#include "opening_window_test.moc"
