// The contact sheet in the real window: pictures appear one after the other, a click adopts the value and can be undone, closing cancels.
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/controllers/contact_sheets.h"
#include "ui/panels/dialogs/contact_card.h"

#include <QAction>
#include <QToolButton>

using namespace edgescan;
using namespace edgescan::ui;

class ContactSheetTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;

private slots:
    void initTestCase() {
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(150, 170, 3, 0.02), scan_)));
    }

    void aClickTakesAValueAndUndoBringsTheOldOneBack() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        auto* sheets = on.window.findChild<ContactSheets*>();
        on.viewer.views.cloud().setFocus();
        QTest::keyClick(&on.window, Qt::Key_S, Qt::ShiftModifier);
        QTRY_VERIFY(sheets->card() != nullptr && sheets->card()->isVisible());
        QTRY_VERIFY(!sheets->card()->working());
        const std::vector<QToolButton*> pictures = sheets->card()->pictures();
        QVERIFY(pictures.size() >= 6);
        QCOMPARE(sheets->entries().size(), pictures.size());
        const double before = on.viewer.engine.settings().sensitivity;
        int inUse = 0, steady = 0;
        for (std::size_t n = 0; n < pictures.size(); ++n) {
            inUse += pictures[n]->text().contains("now") ? 1 : 0;
            steady += pictures[n]->text().contains("steady") ? 1 : 0;
            QCOMPARE(pictures[n]->text().contains("steady"), sheets->entries()[n].steady);
        }
        QCOMPARE(inUse, 1);
        QVERIFY(steady != 1);
        // The picture of a value equals the window after adopting this value.
        const std::size_t last = pictures.size() - 1;
        QTest::mouseClick(pictures[last], Qt::LeftButton);
        QCOMPARE(on.viewer.engine.settings().sensitivity, sheets->entries()[last].value);
        QVERIFY(on.settled());
        QCOMPARE(on.picture().detection->edges->size(), sheets->entries()[last].edges);
        on.viewer.undo.undo();
        QCOMPARE(on.viewer.engine.settings().sensitivity, before);
    }

    void theSliderThatWasTurnedLastIsTheOneOfTheSheet() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.viewer.tuning.setParameter("crease", 40);
        QVERIFY(on.settled());
        QCOMPARE(QString(on.viewer.tuning.lastChanged().key), QString("crease"));
        auto* sheets = on.window.findChild<ContactSheets*>();
        sheets->show();
        QTRY_VERIFY(!sheets->card()->working());
        QTest::mouseClick(sheets->card()->pictures().front(), Qt::LeftButton);
        QVERIFY(on.viewer.engine.settings().creaseDeg < 40);
    }

    // On a screen of 1280 x 720 (1920 x 1080 at 150 %) the sheet is completely visible.
    void itIsNoLargerThanItsWindow() {
        WindowFixture on;
        on.window.resize(900, 620);
        QVERIFY(on.showWith(scan_));
        auto* sheets = on.window.findChild<ContactSheets*>();
        sheets->show();
        QTRY_VERIFY(sheets->card() != nullptr && !sheets->card()->working());
        QVERIFY2(sheets->card()->height() < on.window.height() && sheets->card()->width() <= on.window.width(),
                 qPrintable(QString("%1 x %2").arg(sheets->card()->width()).arg(sheets->card()->height())));
    }

    void closingItGivesUp() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        auto* sheets = on.window.findChild<ContactSheets*>();
        sheets->show();
        sheets->card()->close();
        sheets->show(); // immediately again
        QTRY_VERIFY(!sheets->card()->working());
        QCOMPARE(sheets->entries().size(), sheets->card()->pictures().size());
    }
};

int contact_sheet_test(int argc, char** argv) { return runWindowTest<ContactSheetTest>(argc, argv); }
#include "contact_sheet_test.moc"
