// Cab mode with gloves and without a keyboard: whole rows in Tune, keys on the screen, what can be removed, what waits for a scan.
#include "tests/support/folders.h"
#include "tests/ui/sized_window.h"
#include "tests/ui/whole_widgets.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/cab/corner_picture.h"
#include "ui/panels/cab/glove_buttons.h"
#include "ui/panels/cab/keypad.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/dialogs/report_form.h"
#include "ui/panels/dialogs/why_card.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/targets/target_card.h"
#include "ui/panels/targets/targets_panel.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/window/cab_mode.h"
#include "ui/window/theme.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStyle>
#include <QStyleOption>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

using namespace edgescan;
using namespace edgescan::ui;

class CabHandsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string scan_;

    static constexpr int kGuardedMs = 800; // longer than a second tap is ignored

    static void tap(Keypad& pad, const QString& key) {
        QToolButton* found = pad.key(key);
        if (found == nullptr) qFatal("the keypad has no key %s", qPrintable(key));
        QTest::mouseClick(found, Qt::LeftButton);
    }
    static QRect onScreen(const QWidget& widget) { return {widget.mapToGlobal(QPoint()), widget.size()}; }

private slots:
    void initTestCase() {
        useTheme(*qApp);
        scan_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(200, 240, 3, 0.02), scan_)));
    }
    void cleanup() {
        useLanguage("en");
        useTheme(*qApp, false);
    }

    // No text of Tune is cut, and each button is large enough, for the settings of all methods.
    void everyRowOfTuneIsWhole() {
        for (const Language& language : kLanguages) {
            QVERIFY(useTexts(language.code));
            WindowFixture on;
            QVERIFY(on.showWith(scan_));
            on.window.cab().set(true);
            QTest::mouseClick(tool(on.window, "cab-tune"), Qt::LeftButton);
            on.viewer.cloud.hide(); // it would be drawn at each size
            const QWidget& panels = on.window.cab().frame().panels();
            for (const edges::Method method : {edges::Method::EdgeScanPlus, edges::Method::Canny, edges::Method::LogRange}) {
                edges::Settings settings = on.viewer.engine.settings();
                settings.method = method;
                QVERIFY(on.use(settings));
                for (const QSize size : {QSize(853, 480), QSize(1024, 768), QSize(1280, 700), QSize(1920, 700)}) {
                    on.window.resize(size);
                    const QString where = QString("%1 at %2 x %3: ").arg(language.code).arg(size.width()).arg(size.height());
                    QTRY_VERIFY2(faultsIn(panels).isEmpty(), qPrintable(where + faultsIn(panels).join('\n')));
                    const QToolButton* leave = tool(on.window, "cab-leave");
                    QVERIFY2(leave->width() >= leave->sizeHint().width(), qPrintable(where));
                    for (const auto* each : panels.findChildren<QToolButton*>())
                        QVERIFY2(!each->isVisible() || (each->width() >= kGlovePx && each->height() >= kGlovePx),
                                 qPrintable(where + each->text()));
                }
            }
            on.window.cab().set(false);
        }
    }

    // The keys are at the bottom of the screen. The dialog moves: its field and its buttons stay in sight.
    void theKeysCoverNeitherFieldNorButtons() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        Keypad& pad = on.window.cab().keypad();
        ReportForm form({}, &on.window);
        form.show();
        form.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&form));
        form.move(300, form.screen()->availableGeometry().bottom() - form.height());
        auto* site = form.findChild<QLineEdit*>("report-site");
        auto* remark = form.findChild<QPlainTextEdit*>("report-remark");
        for (QWidget* field : {static_cast<QWidget*>(site), static_cast<QWidget*>(remark)}) {
            QTest::mouseClick(field == remark ? remark->viewport() : field, Qt::LeftButton);
            field->setFocus();
            QTRY_VERIFY2(pad.isVisible(), qPrintable(field->objectName()));
            QCOMPARE(pad.field(), field);
            QTRY_VERIFY(!pad.place().intersects(onScreen(*field)));
            for (const QPushButton* each : form.findChild<QDialogButtonBox*>()->findChildren<QPushButton*>())
                QVERIFY2(!pad.place().intersects(onScreen(*each)), qPrintable(each->text()));
            QVERIFY(form.screen()->availableGeometry().contains(pad.place()));
        }
        for (const char* key : {"⇧", "R", "o", "c", "k", "␣", "⇧", "B"}) tap(pad, key);
        tap(pad, "↵");
        tap(pad, "a");
        QCOMPARE(remark->toPlainText(), QString("Rock B\na"));
        // Enter in a field of one line goes to the next one, and does not press the button of the dialog.
        QTest::mouseClick(site, Qt::LeftButton);
        site->setFocus();
        QTRY_COMPARE(pad.field(), static_cast<QWidget*>(site));
        tap(pad, "123");
        tap(pad, "7");
        tap(pad, "↵");
        QCOMPARE(site->text(), QString("7"));
        QVERIFY(form.isVisible() && pad.isVisible() && pad.field() != site && pad.field()->hasFocus());
        QTest::mouseClick(site, Qt::LeftButton);
        site->setFocus();
        QTRY_COMPARE(pad.field(), static_cast<QWidget*>(site));
        tap(pad, "▼");
        QVERIFY(!pad.isVisible() && form.isVisible());
        QTest::qWait(kGuardedMs);
        QTest::mouseClick(site, Qt::LeftButton); // the field still has the focus
        QTRY_VERIFY(pad.isVisible());
        form.reject();
        QTRY_VERIFY2(!pad.isVisible(), "the keys close with the dialog");
        on.window.cab().set(false);
    }

    // Enter goes from field to field and closes the keys in the last one; a second tap there presses nothing of the dialog, which has the
    // room of the keys then.
    void enterGoesFromFieldToField() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        Keypad& pad = on.window.cab().keypad();
        QDialog dialog(&on.window);
        auto* column = new QVBoxLayout(&dialog);
        std::vector<QLineEdit*> fields;
        for (const char* words : {"1", "", "3"}) {
            fields.push_back(new QLineEdit(words));
            column->addWidget(fields.back());
        }
        auto* number = new QSpinBox;
        column->insertWidget(2, number);
        QWidget::setTabOrder(fields[1], number);
        QWidget::setTabOrder(number, fields[2]);
        fields[1]->setReadOnly(true); // takes no letters
        auto* cancel = new QPushButton("Cancel");
        cancel->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding); // below the keys
        connect(cancel, &QPushButton::clicked, &dialog, &QDialog::reject);
        column->addWidget(cancel);
        dialog.resize(on.window.screen()->availableGeometry().size() - QSize(20, 20));
        dialog.show();
        dialog.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        fields[0]->setFocus();
        QTRY_COMPARE(pad.field(), static_cast<QWidget*>(fields[0]));
        const QList<QWidget*> inOrder{fields[0], number->findChild<QLineEdit*>(), fields[2]};
        for (QWidget* each : inOrder) {
            QTRY_COMPARE(pad.field(), each);
            const QPoint key = onScreen(*pad.key("↵")).center();
            tap(pad, "↵");
            if (each != inOrder.back()) continue;
            QVERIFY(!pad.isVisible());
            QTRY_VERIFY(onScreen(*cancel).contains(key));
            const auto tapThere = [&] { QTest::mouseClick(cancel, Qt::LeftButton, Qt::NoModifier, cancel->mapFromGlobal(key)); };
            tapThere();
            QVERIFY2(dialog.isVisible(), "the second tap pressed what came under the finger");
            for (int again = 0; again < 5 && dialog.isVisible(); ++again) { // a slow machine lays the dialog out later
                QTest::qWait(kGuardedMs);
                tapThere();
            }
            QVERIFY(!dialog.isVisible());
        }
        on.window.cab().set(false);
    }

    // A dialog for a file opens without keys: they come by a tap into its name, and no button moves under the finger then.
    void theKeysOfAFileComeByATap() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        Keypad& pad = on.window.cab().keypad();
        for (const auto mode : {QFileDialog::AcceptSave, QFileDialog::AcceptOpen}) {
            QFileDialog dialog(&on.window);
            dialog.setOption(QFileDialog::DontUseNativeDialog);
            dialog.setAcceptMode(mode);
            dialog.resize(600, on.window.screen()->availableGeometry().height() - 60); // over the place of the keys
            dialog.show();
            dialog.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&dialog));
            auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
            name->setFocus();
            QTest::qWait(100);
            QVERIFY(!pad.isVisible());
            const QRect opened = dialog.geometry();
            QTest::mouseClick(name, Qt::LeftButton);
            QTRY_VERIFY(pad.isVisible());
            QCOMPARE(dialog.geometry(), opened);
            QVERIFY(!dialog.frameGeometry().intersects(pad.place()));
            tap(pad, "▼");
            QCOMPARE(dialog.geometry(), opened);
        }
    }

    // A dialog as high as the screen stays on it, and the keys are where its field is not.
    void noDialogLeavesTheScreenForTheKeys() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        const Keypad& pad = on.window.cab().keypad();
        const QRect room = on.window.screen()->availableGeometry();
        for (const int at : {20, room.height() / 2, room.height() - 120}) {
            QDialog dialog(&on.window);
            dialog.setFixedSize(400, room.height() - 40);
            auto* name = new QLineEdit(&dialog);
            name->setGeometry(20, at, 200, 40);
            dialog.show();
            dialog.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&dialog));
            dialog.move(300, 20);
            QTest::mouseClick(name, Qt::LeftButton);
            name->setFocus();
            QTRY_VERIFY(pad.isVisible());
            QTRY_VERIFY2(room.contains(dialog.frameGeometry()), qPrintable(QString::number(at)));
            QVERIFY2(!pad.place().intersects(onScreen(*name)) && room.contains(pad.place()), qPrintable(QString::number(at)));
        }
    }

    // After their key closed them, a dialog that made room for the keys has its place and size again.
    void aDialogIsAsLargeAsBeforeTheKeys() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        Keypad& pad = on.window.cab().keypad();
        QDialog dialog(&on.window);
        auto* name = new QLineEdit(&dialog);
        name->setGeometry(20, 20, 200, 40);
        name->setFocusPolicy(Qt::ClickFocus); // not from the start
        dialog.resize(400, on.window.screen()->availableGeometry().height() - 60);
        dialog.show();
        dialog.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        dialog.move(300, 30);
        QApplication::processEvents();
        const QRect usual = dialog.geometry();
        QTest::mouseClick(name, Qt::LeftButton);
        name->setFocus();
        QTRY_VERIFY(pad.isVisible());
        QTRY_VERIFY(dialog.height() < usual.height());
        tap(pad, "▼");
        QTRY_COMPARE(dialog.geometry(), usual);
        on.window.cab().set(false);
    }

    void escapeClosesTheKeys() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        Keypad& pad = on.window.cab().keypad();
        QTest::mouseClick(tool(on.window, "cab-connect"), Qt::LeftButton);
        QTRY_VERIFY(pad.isVisible());
        QVERIFY(!pad.place().intersects(onScreen(*pad.field())));
        QVERIFY2(pad.key("7") != nullptr, "an address has more digits than letters");
        QTest::keyClick(pad.field(), Qt::Key_Escape);
        QVERIFY(!pad.isVisible());
    }

    void aTargetAndAMeasurementAreRemovedAndComeBack() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        const auto cell = [&](int line, int beam) { return static_cast<std::uint32_t>(line * 240 + beam); };
        on.viewer.views.pin(cell(100, 120));
        inspect::StoredMeasure measure;
        measure.cells = {cell(60, 60), cell(100, 120)};
        on.viewer.targets.keepMeasure(measure);
        QPushButton& remove = *on.viewer.targetsPanel.removeMeasure();
        QTRY_VERIFY(remove.isVisible() && remove.isEnabled() && remove.height() >= kGlovePx && on.viewer.targets.settled());
        QTest::mouseClick(&remove, Qt::LeftButton);
        QTRY_VERIFY(on.viewer.targets.notebook().measures.empty());
        QVERIFY(on.viewer.notice.isVisible() && on.viewer.notice.text().contains("Removed: M1 Distance"));
        on.viewer.views.pin(cell(100, 120));
        QToolButton& close = *on.viewer.targetsPanel.card().close();
        QTRY_VERIFY(close.isVisible() && close.width() >= kGlovePx && close.height() >= kGlovePx);
        QTest::mouseClick(&close, Qt::LeftButton);
        QTRY_VERIFY(on.viewer.targets.notebook().targets.empty());
        QTest::mouseClick(tool(on.window, "cab-undo"), Qt::LeftButton);
        QVERIFY2(on.viewer.targets.active() != nullptr, "what came back is chosen");
        QTest::mouseClick(tool(on.window, "cab-undo"), Qt::LeftButton);
        QCOMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        QCOMPARE(on.viewer.targets.notebook().measures.size(), std::size_t(1));
        QVERIFY(on.viewer.targets.chosenMeasure() == std::size_t(0) && on.viewer.targets.active() == nullptr);
    }

    // A locked one is not removed.
    void aTargetIsLockedOnItsCard() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        on.viewer.views.pin(100 * 240 + 120);
        const TargetCard& card = on.viewer.targetsPanel.card();
        QTRY_VERIFY(on.viewer.targets.settled() && card.lock()->isVisible() && card.lock()->height() >= kGlovePx);
        QTest::mouseClick(card.lock(), Qt::LeftButton);
        QTRY_VERIFY(on.viewer.targets.active()->locked && !card.close()->isEnabled());
        QTest::mouseClick(card.lock(), Qt::LeftButton);
        QTRY_VERIFY(!on.viewer.targets.active()->locked && card.close()->isEnabled());
    }

    // The form opens each time at its top and as high as at first, also after it was closed while the keys were open.
    void theFormOfThePoseOpensAsAtFirst() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        const Keypad& pad = on.window.cab().keypad();
        emit on.viewer.statusLine.poseRequested();
        auto* dialog = on.window.findChild<QDialog*>("place-dialog");
        QVERIFY(dialog != nullptr && QTest::qWaitForWindowActive(dialog));
        dialog->resize(dialog->width(), on.window.screen()->availableGeometry().height() - 60);
        dialog->move(300, 30);
        QApplication::processEvents();
        const QRect usual = dialog->geometry();
        auto* field = dialog->findChild<QLineEdit*>("inclinometer-tilt_y_deg");
        QVERIFY(field != nullptr);
        field->setFocus();
        QTest::mouseClick(field, Qt::LeftButton);
        QTRY_VERIFY(pad.isVisible() && dialog->height() < usual.height());
        auto* area = dialog->findChild<QScrollArea*>();
        area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
        dialog->reject();
        QTRY_VERIFY(!dialog->isVisible() && !pad.isVisible());
        emit on.viewer.statusLine.poseRequested();
        QVERIFY(QTest::qWaitForWindowActive(dialog));
        QTRY_COMPARE(dialog->geometry(), usual);
        QCOMPARE(area->verticalScrollBar()->value(), 0);
        QVERIFY(!pad.isVisible() && !field->hasFocus());
        dialog->reject();
        on.window.cab().set(false);
    }

    // Above the keys of a screen of 1280 x 800, position, heading and tilt are whole.
    void thePoseIsInSightAboveTheKeys() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        emit on.viewer.statusLine.poseRequested();
        auto* dialog = on.window.findChild<QDialog*>("place-dialog");
        QVERIFY(dialog != nullptr && QTest::qWaitForWindowActive(dialog));
        const QSize least = dialog->layout()->totalMinimumSize(); // on a low screen its buttons are in sight
        QVERIFY2(least.width() < 833 && least.height() < 420, qPrintable(QString("%1 x %2").arg(least.width()).arg(least.height())));
        auto* first = dialog->findChild<QLineEdit*>("talin-easting_m");
        first->setFocus();
        QTest::mouseClick(first, Qt::LeftButton);
        const Keypad& pad = on.window.cab().keypad();
        QTRY_VERIFY(pad.isVisible());
        dialog->resize(dialog->width(), 800 - pad.place().height());
        for (const char* name : {"talin-easting_m", "talin-northing_m", "talin-elevation_m", "talin-heading_deg", "inclinometer-tilt_x_deg",
                                 "inclinometer-tilt_y_deg"}) {
            const auto* field = dialog->findChild<QWidget*>(name);
            QTRY_VERIFY2(field->visibleRegion().boundingRect() == field->rect(), name);
        }
        dialog->reject();
        on.window.cab().set(false);
    }

    void rocksEndMeasuring() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        on.viewer.measures.start(inspect::MeasureKind::Distance);
        QVERIFY(tool(on.window, "cab-measure")->isChecked());
        QTest::mouseClick(tool(on.window, "cab-rocks"), Qt::LeftButton);
        QTRY_VERIFY(on.viewer.rocks.shown());
        QVERIFY(!on.viewer.measures.kind() && !tool(on.window, "cab-measure")->isChecked());
    }

    // Arrows of number fields are too small for gloves: the number has the whole field.
    void aNumberFieldHasNoSmallArrows() {
        QSpinBox box;
        const auto arrow = [&box] {
            QStyleOptionSpinBox option;
            option.initFrom(&box);
            option.buttonSymbols = box.buttonSymbols();
            option.frame = true;
            return box.style()->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxUp, &box);
        };
        box.resize(120, 48);
        QVERIFY(!arrow().isEmpty());
        useTheme(*qApp, true);
        QVERIFY(arrow().isEmpty());
    }

    // A cab may have no window manager: the dialog draws its border.
    void aDialogHasABorder() {
        useTheme(*qApp, true);
        QDialog dialog;
        dialog.resize(200, 100);
        const QImage shown = dialog.grab().toImage();
        for (const QPoint at : {QPoint(0, 50), QPoint(199, 50), QPoint(100, 0), QPoint(100, 99)})
            QVERIFY(shown.pixelColor(at) != shown.pixelColor(100, 50));
    }

    void whatNeedsAScanWaitsForIt() {
        WindowFixture on;
        QVERIFY(on.show());
        on.window.cab().set(true);
        for (const char* name : {"cab-tune", "cab-report", "cab-export", "cab-measure", "cab-why"})
            QVERIFY2(!tool(on.window, name)->isEnabled(), name);
        for (const char* name : {"cab-menu", "cab-open", "cab-connect", "cab-leave"}) QVERIFY2(tool(on.window, name)->isEnabled(), name);
        QVERIFY(on.open(scan_));
        for (const char* name : {"cab-tune", "cab-report", "cab-export", "cab-measure", "cab-why"})
            QTRY_VERIFY2(tool(on.window, name)->isEnabled(), name);
    }

    // One column where it fits, else columns of equal length: no lone button next to a full column.
    void theToolsAreInEvenColumns() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        for (const QSize size : {QSize(853, 533), QSize(1024, 748), QSize(1280, 700), QSize(1366, 748), QSize(1920, 1040)}) {
            resizeTo(on.window, size);
            QMap<int, int> columns; // buttons by x
            for (const auto* each : on.window.cab().frame().tools().findChildren<QToolButton*>()) ++columns[each->x()];
            const auto [least, most] = std::minmax_element(columns.begin(), columns.end());
            QVERIFY2(*most - *least <= 1, qPrintable(QString("%1 and %2 at %3").arg(*least).arg(*most).arg(size.height())));
            if (size.height() >= 700) QCOMPARE(columns.size(), 1);
        }
    }

    void quittingAsksInACab() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        bool asked = false;
        const auto answer = [&](const char* button) {
            QTimer::singleShot(0, &on.window, [&asked, button, &on] {
                auto* box = on.window.findChild<QMessageBox*>("close-question");
                asked = box != nullptr;
                if (box == nullptr) return;
                if (*button == '\0')
                    box->reject();
                else
                    box->findChild<QPushButton*>(button)->click();
            });
        };
        answer("");
        QTest::keyClick(&on.window, Qt::Key_Q, Qt::ControlModifier);
        QVERIFY(asked && on.window.isVisible());
        answer("end-and-close");
        QTest::keyClick(&on.window, Qt::Key_Q, Qt::ControlModifier);
        QTRY_VERIFY(!on.window.isVisible());
    }

    // As pressed on the screen: a press outside of a menu would close it.
    void theFieldsOfASweepStayOpenUnderTheKeys() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_) && on.activate());
        on.window.cab().set(true);
        on.viewer.livePanel.askSweep();
        auto* fields = on.window.findChild<QDialog*>("sweep-dialog");
        QVERIFY(fields != nullptr && QTest::qWaitForWindowActive(fields, kPatienceMs));
        Keypad& pad = on.window.cab().keypad();
        QTRY_VERIFY(pad.isVisible() && pad.key("7") != nullptr);
        const auto tapOnScreen = [](QWidget& widget) {
            QTest::mouseClick(widget.window()->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                              widget.mapTo(widget.window(), widget.rect().center()));
        };
        tapOnScreen(*pad.key("7"));
        QTRY_COMPARE(on.viewer.livePanel.sweep().expectedLines, 7);
        // A tap selects what a field shows: the next key replaces it, also "not known".
        for (auto* box : fields->findChildren<QAbstractSpinBox*>()) {
            auto* line = box->findChild<QLineEdit*>();
            for (const char* digit : {"8", "9"}) {
                tapOnScreen(*line);
                QTRY_VERIFY(pad.field() == line && pad.key(digit) != nullptr && line->hasSelectedText());
                tapOnScreen(*pad.key(digit));
                QTRY_COMPARE(line->text().remove(QString::fromUtf8("°")), QString(digit));
            }
        }
        QVERIFY(fields->isVisible());
        fields->close();
        // So are port and address of the scanner.
        QVERIFY(on.activate());
        on.viewer.livePanel.askAddress();
        auto* port = on.window.findChild<QSpinBox*>("live-port");
        tapOnScreen(*port->findChild<QLineEdit*>());
        QTRY_VERIFY(pad.field() == port->findChild<QLineEdit*>() && pad.key("2") != nullptr);
        for (const char* digit : {"2", "1", "1", "1"}) tapOnScreen(*pad.key(digit));
        QTRY_COMPARE(port->value(), 2111);
        auto* host = on.window.findChild<QLineEdit*>("live-host");
        host->setText("10.0.0.7");
        for (const char* digit : {"8", "9"}) {
            tapOnScreen(*host);
            QTRY_VERIFY(pad.field() == host && pad.key(digit) != nullptr && host->hasSelectedText());
            tapOnScreen(*pad.key(digit));
            QTRY_COMPARE(host->text(), QString(digit));
        }
        on.window.cab().set(false);
    }

    // A tap opens the menu in a menu of Menu, and it stays open, though the finger never was over the first one.
    void aMenuInAMenuOfMenuOpensByATap() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        resizeTo(on.window, {1280, 800});
        on.window.cab().set(true);
        const auto tapEntry = [](QMenu& menu, const QString& name) {
            for (QAction* each : menu.actions()) {
                if (each->text().remove('&') == name)
                    QTest::mouseClick(menu.windowHandle(), Qt::LeftButton, Qt::NoModifier, menu.actionGeometry(each).center());
            }
            const bool opens = eventually([&] { return QApplication::activePopupWidget() != &menu; });
            return opens ? qobject_cast<QMenu*>(QApplication::activePopupWidget()) : nullptr;
        };
        QTest::mouseClick(on.window.findChild<QToolButton*>("cab-menu"), Qt::LeftButton);
        QPointer<QMenu> first = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(first);
        QPointer<QMenu> file = tapEntry(*first, "File");
        QVERIFY(file && file != first);
        QPointer<QMenu> inner = tapEntry(*file, "Export");
        QVERIFY(inner && inner != file);
        // As long as a menu waits for a pointer that left it.
        QTest::qWait(QApplication::style()->styleHint(QStyle::SH_Menu_SubMenuSloppyCloseTimeout) + 200);
        QVERIFY(inner->isVisible() && file->isVisible() && first->isVisible());
        while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        on.window.cab().set(false);
    }

    // Of a menu whose entry opened another one.
    void aTapOnTheArrowOfTheFirstMenuScrollsIt() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QMenu menu;
        auto* inner = menu.addMenu("inner");
        inner->addAction("one");
        for (int n = 0; n < 60; ++n) menu.addAction(QString("entry %1").arg(n));
        menu.popup({40, 0});
        QTRY_VERIFY(menu.isVisible());
        QTest::qWait(300); // as a finger
        QTest::mouseClick(menu.windowHandle(), Qt::LeftButton, Qt::NoModifier, menu.actionGeometry(inner->menuAction()).center());
        QVERIFY(QTest::qWaitFor([&] { return inner->isVisible(); }, 4000));
        QTest::qWait(300);
        const QPoint arrow(menu.width() / 2, menu.height() - 10);
        const int first = menu.actionGeometry(menu.actions().front()).top();
        QTest::mouseClick(menu.windowHandle(), Qt::LeftButton, Qt::NoModifier, arrow);
        QVERIFY2(QTest::qWaitFor([&] { return menu.actionGeometry(menu.actions().front()).top() < first; }, 4000),
                 qPrintable(QString("%1 %2 %3").arg(menu.isVisible()).arg(inner->isVisible()).arg(first)));
        QTest::qWait(600);
        QVERIFY(menu.isVisible() && !inner->isVisible());
        const int then = menu.actionGeometry(menu.actions().front()).top();
        QTest::qWait(300);
        QCOMPARE(menu.actionGeometry(menu.actions().front()).top(), then); // one tap scrolls a part
        menu.close();
        on.window.cab().set(false);
    }

    // A swipe scrolls a long menu and carries out no entry; in a short one it does nothing. A tap that slips a little is a tap.
    void aSwipeOverAMenuScrollsIt() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        for (const int entries : {60, 4}) {
            QMenu menu;
            for (int n = 0; n < entries; ++n) menu.addAction(QString("entry %1").arg(n));
            QSignalSpy chosen(&menu, &QMenu::triggered);
            menu.popup({40, 0});
            QTRY_VERIFY(menu.isVisible());
            const auto top = [&] { return menu.actionGeometry(menu.actions().front()).top(); };
            const auto send = [&](QEvent::Type type, const QPoint& at) {
                QMouseEvent event(type, at, menu.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                                  type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
                QApplication::sendEvent(&menu, &event);
            };
            const auto swipe = [&](int from, int to) {
                send(QEvent::MouseButtonPress, {60, from});
                for (int y = from; y != to; y += to > from ? 2 : -2) send(QEvent::MouseMove, {60, y});
                send(QEvent::MouseButtonRelease, {60, to});
            };
            const int low = std::min(menu.height() - 60, 600), first = top();
            swipe(low, 60);
            QVERIFY(menu.isVisible() && chosen.isEmpty());
            QVERIFY2(entries == 4 ? top() == first : std::abs(first - top() - (low - 60)) <= 48,
                     qPrintable(QString("%1 %2").arg(first).arg(top())));
            swipe(60, low);
            QVERIFY(menu.isVisible() && chosen.isEmpty());
            QVERIFY2(std::abs(top() - first) <= 48, qPrintable(QString("%1 %2").arg(first).arg(top())));
            swipe(100, 110);
            QTRY_COMPARE(chosen.count(), 1);
            QVERIFY(!menu.isVisible());
        }
        on.window.cab().set(false);
    }

    // A long menu has one column, which scrolls by its arrows: columns would leave a low screen at its right.
    void aMenuHasOneColumn() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        QCOMPARE(QApplication::style()->pixelMetric(QStyle::PM_MenuScrollerHeight), 48);
        int seen = 0;
        for (QMenu* menu : on.window.menuBar()->findChildren<QMenu*>()) {
            QSet<int> lefts;
            for (QAction* each : menu->actions()) {
                if (each->isVisible() && !each->isSeparator()) lefts << menu->actionGeometry(each).left();
            }
            QVERIFY2(lefts.size() <= 1, qPrintable(menu->title()));
            seen += static_cast<int>(lefts.size());
        }
        QVERIFY2(seen >= 6, qPrintable(QString::number(seen)));
        on.window.cab().set(false);
    }

    // The plate of a comparison names a way for fingers, not a key, and leaves out rows that count nothing.
    void theComparisonIsForFingers() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        resizeTo(on.window, {1366, 748});
        on.viewer.comparing.keep();
        edges::Settings other = on.viewer.engine.settings();
        other.sensitivity *= 2.0;
        QVERIFY(on.use(other));
        ChangeLegend& legend = on.viewer.changeLegend;
        QTRY_VERIFY(!legend.counted(ChangeRow::Unchanged).isEmpty());
        auto* choice = legend.findChild<QToolButton*>("change-shown-0");
        QVERIFY(choice->isVisible() && choice->toolTip().contains('\\'));
        on.window.cab().set(true);
        QTRY_VERIFY(choice->isVisible() && choice->height() >= 48);
        for (const ChangeRow row : {ChangeRow::Gained, ChangeRow::Lost, ChangeRow::Unchanged})
            QCOMPARE(legend.row(row)->isVisibleTo(&legend), legend.counted(row) != "0");
        // While A is shown, the numbers of a target say that they are of B.
        on.viewer.views.pin(on.viewer.views.cellAt(20, 30));
        const auto& ofB = *on.window.findChild<QLabel*>("cab-of-b");
        QVERIFY(!ofB.isVisible());
        on.viewer.comparing.flip(true);
        QVERIFY2(ofB.isVisible() && ofB.text().endsWith("· B"), qPrintable(ofB.text()));
        QVERIFY2(on.window.cab().corner().image() == on.viewer.views.gray().image(), "the small picture is not of A");
        on.viewer.comparing.flip(false);
        QVERIFY(!ofB.isVisible());
    }

    // All text is in sight, or there is a bar to scroll it with.
    void noLineOfWhyIsCut() {
        WindowFixture on;
        QVERIFY(on.showWith(scan_));
        on.window.cab().set(true);
        resizeTo(on.window, {1280, 780});
        for (const int lines : {3, 30, 90}) {
            WhyCard card(&on.window);
            card.showExplanation("No edge.", {}, QString("line 153, beam 534 next to it is stronger\n").repeated(lines));
            QVERIFY(QTest::qWaitForWindowExposed(&card));
            QApplication::processEvents();
            const auto* area = card.findChild<QScrollArea*>();
            QVERIFY(area != nullptr);
            QVERIFY(card.screen()->availableGeometry().contains(card.geometry()));
            for (const QLabel* each : card.findChildren<QLabel*>())
                QVERIFY2(!each->isVisible() || each->height() >= each->heightForWidth(each->width()), qPrintable(each->text().left(40)));
            const bool whole = area->widget()->height() <= area->viewport()->height();
            // The text ends with a whole line, and has the room down to the buttons.
            const auto* numbers = card.findChild<QLabel*>("why-numbers");
            const int line = numbers->fontMetrics().lineSpacing(), shown = area->viewport()->height() - numbers->y();
            const auto rest = [&] { return (area->viewport()->height() - numbers->y()) % line; };
            if (!whole && shown > 0) QTRY_COMPARE(rest(), 0);
            const auto* close = card.findChild<QDialogButtonBox*>();
            const auto below = [&] { return close->y() - area->geometry().bottom(); };
            if (!whole) QTRY_VERIFY2(below() > 0 && below() < 2 * line, qPrintable(QString::number(below())));
            card.offerNearestEdge(4);
            QTRY_VERIFY(card.findChild<QPushButton*>("why-nearest-edge")->isVisible() &&
                        area->geometry().bottom() < card.findChild<QPushButton*>("why-nearest-edge")->y());
            QVERIFY(card.screen()->availableGeometry().contains(card.geometry()));
            QVERIFY2(whole || area->verticalScrollBar()->isVisible(), qPrintable(QString::number(lines)));
            if (lines < 30) QVERIFY(whole);
        }
    }
};

int cab_hands_test(int argc, char** argv) { return runWindowTest<CabHandsTest>(argc, argv); }
#include "cab_hands_test.moc"
