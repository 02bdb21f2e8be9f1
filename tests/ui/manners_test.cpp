// General behaviour of the window: plain labels, numbers with a decimal point, warnings that stay, settings that are visible and can be
// restored.
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/exports/verify.h"
#include "tests/support/placements.h"
#include "tests/support/scans.h"
#include "tests/ui/sized_window.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/base/shown_text.h"
#include "ui/base/themes.h"
#include "ui/panels/live/state_badge.h"
#include "ui/panels/tuning/status_line.h"
#include "ui/panels/tuning/warning_button.h"
#include "ui/window/tool_bar.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTextBrowser>
#include <QTimer>
#include <QToolTip>
#include <QtTest>

#include <clocale>
#include <locale>
#include <map>

using namespace edgescan;
using namespace edgescan::ui;

namespace {

const std::string kMarkup = "<img src=x> <b>bold</b> & \x1b[31m \u202e";

bool plain(const QString& text) {
    for (const QChar c : text) {
        if (c != '\n' && (c.category() == QChar::Other_Control || c.category() == QChar::Other_Format)) return false;
    }
    return true;
}

} // namespace

class MannersTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string hostile_, placed_;

private slots:
    void initTestCase() {
        qRegisterMetaType<exports::ExportContent>("edgescan::ExportContent");
        Scan scan = test::boxesScan(60, 80, 3, 0.05);
        scan.note = kMarkup;
        Placement placement = *test::randomPlacement(3, 1, true);
        placement.originEnhM = {498700, 6200000, 250};
        scan.placement = std::make_shared<const Placement>(placement);
        placed_ = (folder_ / "placed.json").string();
        QVERIFY(files::saveScan(scan, placed_));
        placement.grid = kMarkup;
        placement.source = kMarkup;
        placement.warnings = {kMarkup, std::string(100000, 'x'), "one\ntwo"};
        scan.placement = std::make_shared<const Placement>(placement);
        hostile_ = (folder_ / "<h1>name & \x1b[31m\n\u202e.json").string();
        QVERIFY(files::saveScan(scan, hostile_));
    }

    // "Not a Rock" got the keyboard focus when Merge was switched off, and the next Space marked a rock; "Smallest rock" got it when "Not a
    // Rock" was switched off, and the next 7 changed the number.
    void aWidgetThatIsSwitchedOffPassesTheFocusToNoOther() {
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        QWidget pair(&on.window);
        QPushButton first("first", &pair);
        QSpinBox second(&pair), third(&pair);
        QPushButton fourth("fourth", &pair);
        pair.show();
        for (QWidget* each : std::initializer_list<QWidget*>{&first, &second, &third, &fourth}) {
            for (const bool hides : {false, true}) {
                each->setEnabled(true);
                each->show();
                each->setFocus();
                QTRY_VERIFY(each->hasFocus());
                hides ? each->hide() : each->setEnabled(false);
                const QWidget* now = QApplication::focusWidget();
                QVERIFY2(now == nullptr || qobject_cast<const ImageView*>(now) != nullptr || qobject_cast<const CloudView*>(now) != nullptr,
                         now == nullptr ? "" : now->metaObject()->className());
            }
        }
    }

    // If two commands have the same key, Qt runs neither and shows no message.
    void noTwoCommandsShareAKey() {
        WindowFixture on;
        QVERIFY(on.show());
        std::map<QString, QString> owner;
        for (const QAction* action : on.window.findChildren<QAction*>()) {
            for (const QKeySequence& keys : action->shortcuts()) {
                const QString key = keys.toString(QKeySequence::PortableText);
                if (key.isEmpty()) continue;
                const auto [other, isNew] = owner.emplace(key, action->text());
                QVERIFY2(isNew, qPrintable(key + ": " + other->second + " and " + action->text()));
            }
        }
        QVERIFY(owner.size() > 30);
    }

    void noLabelTakesForeignTextForMarkup() {
        WindowFixture on;
        QVERIFY(on.showWith(hostile_));
        QApplication::processEvents();
        int withMarkup = 0;
        for (QWidget* widget : QApplication::allWidgets()) {
            QVERIFY2(plain(widget->toolTip()), qPrintable(widget->toolTip()));
            QVERIFY2(widget->toolTip().size() < 30000, qPrintable(widget->objectName()));
            const auto* label = qobject_cast<QLabel*>(widget);
            if (label == nullptr || !label->isVisible()) continue;
            QVERIFY2(label->textFormat() != Qt::AutoText, qPrintable(label->text()));
            QVERIFY2(plain(label->text()), qPrintable(label->text()));
            QVERIFY2(label->text().size() < 30000, qPrintable(label->objectName()));
            withMarkup += label->text().contains("<b>") && label->textFormat() == Qt::PlainText ? 1 : 0;
        }
        QVERIFY(withMarkup >= 2); // the grid's name below, the warnings above
        QVERIFY2(plain(on.window.windowTitle()), qPrintable(on.window.windowTitle()));
        QVERIFY(on.window.windowTitle().contains("<h1>name"));
        for (const QAction* action : on.window.findChildren<QAction*>()) QVERIFY2(plain(action->text()), qPrintable(action->text()));
    }

    void toolTipsAndMessagesArePlainToo() {
        WindowFixture on;
        QVERIFY(on.show());
        QToolTip::showText(on.window.mapToGlobal(QPoint(100, 100)), "<b>tip</b>", &on.window);
        QTRY_VERIFY(QToolTip::isVisible());
        int tips = 0, messages = 0;
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (!widget->inherits("QTipLabel")) continue;
            ++tips;
            QCOMPARE(qobject_cast<QLabel*>(widget)->textFormat(), Qt::PlainText);
        }
        QVERIFY(tips > 0);
        QToolTip::hideText();
        QMessageBox box;
        box.setText("<b>message</b>");
        box.show();
        QVERIFY(QTest::qWaitForWindowExposed(&box, kPatienceMs));
        for (const QLabel* label : box.findChildren<QLabel*>()) {
            if (!label->text().contains("message")) continue;
            ++messages;
            QCOMPARE(label->textFormat(), Qt::PlainText);
        }
        QVERIFY(messages > 0);
    }

    void whatFailsIsToldInPlainAndShortWords() {
        WindowFixture on;
        QVERIFY(on.show());
        QSignalSpy failed(&on.viewer.engine, &Engine::failed);
        on.viewer.files.open({exactText((folder_ / ("none\x1b[31m" + std::string(150, 'x'))).string())});
        QVERIFY(failed.wait(kPatienceMs));
        QVERIFY(plain(on.viewer.notice.text()));
        on.viewer.notice.showNotice(NoticeBar::Kind::Error, QString(100000, 'x') + QString("\n").repeated(5000));
        QVERIFY(on.viewer.notice.text().size() < 25000);
        QVERIFY(on.viewer.notice.text().count('\n') < 25);
    }

    // The locale of the environment (./test uses two of them) must not matter.
    // A letter that was typed for a dialog which did not open is not a command.
    void keysForADialogThatWasRefusedDoNothing() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_) && on.activate());
        on.viewer.notice.hide();
        const auto fired = std::make_shared<QStringList>();
        for (QAction* action : on.window.actions()) {
            const QKeySequence key = action->shortcut();
            if (key.count() == 1 && key.toString().size() == 1)
                connect(action, &QAction::triggered, &on.window, [fired, key] { *fired << key.toString(); });
        }
        for (QAction* action : on.window.actions()) {
            if (action->text().remove('&') == QStringLiteral("Export Rocks…")) action->setShortcut(QKeySequence("Ctrl+J"));
        }
        QTest::keyClick(&on.window, Qt::Key_J, Qt::ControlModifier); // no rocks are shown
        QApplication::processEvents();
        for (const char each : std::string("report3tkqe")) QTest::keyClick(&on.window, each);
        QVERIFY2(fired->isEmpty(), qPrintable(fired->join(' ')));
        QTest::mouseClick(&on.window, Qt::LeftButton, Qt::NoModifier, QPoint(5, on.window.height() - 5));
        QTest::keyClick(&on.window, 't');
        QCOMPARE(*fired, QStringList("T"));
    }

    void propertiesAreWords() {
        const std::string bare = (folder_ / "bare.json").string();
        QVERIFY(files::saveScan(test::boxesScan(60, 80, 3, 0.05), bare));
        WindowFixture on;
        QVERIFY(on.showWith(bare));
        QString text;
        const Meanwhile hand([&] {
            auto* sheet = on.window.findChild<QTextBrowser*>("scan-properties");
            if (sheet == nullptr || !sheet->isVisible()) return false;
            text = sheet->toPlainText();
            sheet->window()->close();
            return true;
        });
        for (QAction* action : on.window.actions()) {
            if (action->text().remove('&') == QStringLiteral("Properties…")) action->trigger();
        }
        QVERIFY2(text.contains("Scan lines") && text.contains("no return"), qPrintable(text));
        QVERIFY2(text.contains(QRegularExpression("Ranges \\[m\\]\\s+smallest\\s+[0-9]+\\.[0-9]{2}\\s")), qPrintable(text)); // as in titles
        QVERIFY2(!text.contains(QRegularExpression("[{}\"]")) && !text.contains("no_return"), qPrintable(text));
    }

    void numbersHaveAPointInEveryCountry() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        QCOMPARE(QString(std::localeconv()->decimal_point), QString("."));
        QCOMPARE(QLocale().decimalPoint(), QLocale::c().decimalPoint());
        for (const auto* box : on.window.findChildren<QAbstractSpinBox*>()) QVERIFY2(!box->text().contains(','), qPrintable(box->text()));
        for (const auto* label : {"meaning", "upper", "probe"}) {
            const auto* found = on.window.findChild<QLabel*>(label);
            QVERIFY2(found != nullptr, label);
            QVERIFY2(!QRegularExpression("[0-9],[0-9]{1,2}([^0-9]|$)").match(found->text()).hasMatch(), qPrintable(found->text()));
        }
    }

    void whatTheWindowExportsVerifies() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        for (const char* name : {"e.pcd", "e.ply", "e.csv", "e.xyz", "e.las", "e.dxf", "e.obj", "e.ptx"}) {
            QSignalSpy saved(&on.viewer.engine, &Engine::saved);
            const std::string path = (folder_ / name).string();
            on.viewer.engine.save(exports::ExportContent::EdgeCloud, exactText(path),
                                  exports::ExportOptions{.frame = CoordinateFrame::MineLocal, .ascii = true});
            QVERIFY2(saved.wait(kPatienceMs), name);
            const auto verified = exports::verifyExport(path);
            QVERIFY2(bool(verified), name);
            QVERIFY2(verified->identical, exports::verificationText(*verified).c_str());
            if (std::string(name) == "e.ply")
                QVERIFY2(test::fileText(path).find("origin E 498700.000 N 6200000.000 El 250.000") != std::string::npos, name);
        }
    }

    void warningsAreAcknowledgedAndStay() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        WarningButton& warnings = on.viewer.warnings;
        QVERIFY(warnings.isVisible());
        QVERIFY(!warnings.acknowledged());
        QCOMPARE(warnings.warnings().size(), 1);
        QVERIFY2(warnings.warnings().first().contains("The pose carries no time"), qPrintable(warnings.warnings().first()));
        on.viewer.notice.hide();
        QVERIFY(warnings.isVisible());
        QTest::mouseClick(&warnings, Qt::LeftButton);
        QVERIFY(warnings.acknowledged());
        QVERIFY(warnings.isVisible());
        QVERIFY(on.viewer.notice.isVisible());
        QVERIFY(on.viewer.notice.text().contains("The pose carries no time"));
        on.viewer.notice.hide();
        // Another setting does not show it as new again, another scan does.
        QVERIFY(on.use(edges::cannySettings()));
        QVERIFY(warnings.acknowledged() && warnings.isVisible());
        QVERIFY(on.open(hostile_));
        QVERIFY(!warnings.acknowledged());
        QCOMPARE(warnings.warnings().size(), 3);
        QVERIFY(on.open(placed_)); // whose warning was read
        QVERIFY(warnings.acknowledged() && warnings.isVisible());
    }

    // The unit is never cut, at the font of the desktop and at 150 % of it, in every language and for every method.
    void everyNumberOfTheEdgesPanelHasItsUnit() {
        const QFont usual = QApplication::font();
        for (const double factor : {1.0, 1.5}) {
            QFont letters = usual;
            letters.setPointSizeF(factor * usual.pointSizeF());
            QApplication::setFont(letters);
            for (const Language& language : kLanguages) {
                QVERIFY(useLanguage(language.code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
                WindowFixture on;
                QVERIFY(on.showWith(placed_));
                resizeTo(on.window, {1280, 800});
                for (const edges::Choice& method : edges::findParameter("method")->choices) {
                    edges::Settings settings = on.viewer.engine.settings();
                    settings.method = static_cast<edges::Method>(static_cast<int>(method.value));
                    QVERIFY(on.use(settings));
                    QApplication::processEvents();
                    for (const auto* box : on.viewer.panel.findChildren<QDoubleSpinBox*>()) {
                        if (!box->isVisible()) continue;
                        const auto* line = box->findChild<QLineEdit*>();
                        // The panel gets its place again when its numbers have changed.
                        QVERIFY2(eventually([&] { return line->fontMetrics().horizontalAdvance(line->text()) + 2 <= line->width(); }),
                                 qPrintable(QString("%1, %2: %3").arg(language.code, method.name, line->text())));
                    }
                }
            }
        }
        QApplication::setFont(usual);
        useLanguage("en");
    }

    // What the badge says moves no button of the tool bar.
    void theBadgeMovesNoToolButton() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        resizeTo(on.window, {1280, 800});
        const auto places = [&] {
            QApplication::processEvents();
            QVector<QRect> all;
            for (const auto* each : on.viewer.tools.findChildren<QToolButton*>()) all << (each->isVisible() ? each->geometry() : QRect());
            return all;
        };
        const std::string brief = (folder_ / "b.json").string();
        const std::string named = (folder_ / "draw bell 14 east after the second blast.json").string();
        for (const std::string& path : {brief, named})
            std::filesystem::copy_file(placed_, path, std::filesystem::copy_options::overwrite_existing);
        for (const int width : {853, 1024, 1280, 1920}) {
            resizeTo(on.window, {width, 800});
            QVERIFY(on.open(brief));
            const QVector<QRect> before = places();
            QVERIFY(on.open(named));
            QCOMPARE(places(), before);
            QVERIFY(on.open(brief));
            QCOMPARE(places(), before);
            // The time is whole at each width, also with a state in front of it.
            on.viewer.origin.showState(StateBadge::Sign::Waiting, "OLD PICTURE · FILE draw bell 14 east · 2026-11-19 08:12:05 UTC");
            QCOMPARE(places(), before);
            const QStringList shown = on.viewer.origin.lines();
            QVERIFY2(shown.front().startsWith("OLD") && shown.back().endsWith(width < 1000 ? " 08:12:05 UTC" : "2026-11-19 08:12:05 UTC"),
                     qPrintable(shown.join('\n')));
            if (shown.size() == 2) QVERIFY2(shown.front() == "OLD PICTURE" || shown.front().endsWith("14 east"), qPrintable(shown.front()));
            QVERIFY(on.viewer.origin.geometry().right() <= on.viewer.origin.parentWidget()->width());
        }
    }

    void aSmallFileHasItsOwnSize() {
        WindowFixture on;
        QVERIFY(on.show());
        const QString path = QString::fromStdString((folder_ / "small.csv").string());
        for (const auto& [bytes, words] : {std::pair{1234, "1.2 kB."}, {40, "0.1 kB."}, {123456, "123 kB."}}) {
            QFile file(path);
            QVERIFY(file.open(QFile::WriteOnly) && file.write(QByteArray(bytes, 'a')) == bytes);
            file.close();
            on.viewer.notice.showSaved(path);
            QVERIFY2(on.viewer.notice.text().endsWith(words), qPrintable(on.viewer.notice.text()));
        }
    }

    // Qt would show a long one as wide as the screen.
    void aLongToolTipHasSeveralLines() {
        WindowFixture on;
        QVERIFY(on.show() && on.activate());
        QWidget& asked = on.viewer.origin;
        asked.setToolTip(QString("a word of a tip ").repeated(30).trimmed());
        QHelpEvent help(QEvent::ToolTip, QPoint(4, 4), asked.mapToGlobal(QPoint(4, 4)));
        QApplication::sendEvent(&asked, &help);
        QTRY_VERIFY(QToolTip::isVisible());
        QVERIFY2(QToolTip::text().contains('\n') && QToolTip::text().simplified() == asked.toolTip(), qPrintable(QToolTip::text()));
        for (const QWidget* each : QApplication::topLevelWidgets())
            QVERIFY(!each->inherits("QTipLabel") || !each->isVisible() || each->width() < 520);
        QToolTip::hideText();
    }

    void aScreenshotCarriesTheWarnings() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        on.viewer.warnings.click();
        on.viewer.notice.hide();
        const QImage with = on.window.screenshot();
        const int strip = with.height() - static_cast<int>(on.window.height() * with.devicePixelRatio());
        QVERIFY2(strip >= 20, qPrintable(QString::number(strip)));
        // The strip contains text, nearly in the colour of the pen.
        const QImage below = with.copy(0, with.height() - strip, with.width(), strip);
        QVERIFY(countPixels(below, [](QRgb p) { return qRed(p) > 220 && qGreen(p) > 220 && qBlue(p) > 200; }) > 100);
        Scan bare = test::boxesScan(60, 80, 3, 0.05);
        const std::string quiet = (folder_ / "quiet.json").string();
        QVERIFY(files::saveScan(bare, quiet));
        QVERIFY(on.open(quiet));
        if (on.picture().detection->scan->warnings.empty()) {
            QVERIFY(!on.viewer.warnings.isVisible());
            QCOMPARE(on.window.screenshot().height(), static_cast<int>(on.window.height() * with.devicePixelRatio()));
        }
    }

    void aScreenshotThatIsNotWrittenIsTold() {
        const std::string picture = (folder_ / "picture.png").string();
        const auto early = test::runProgram("edgescan", "--no-settings --demo --quit-after 0.01 --screenshot " + picture);
        QCOMPARE(early.code, 1);
        QVERIFY2(early.err.find("no picture was written") != std::string::npos, early.err.c_str());
        QVERIFY(!std::filesystem::exists(picture));
        const auto few =
            test::runProgram("edgescan", "--no-settings --quit-after 60 --screenshot-lines 5000 --screenshot " + picture + " " + placed_);
        QCOMPARE(few.code, 1);
        QVERIFY2(few.err.find("60 lines") != std::string::npos, few.err.c_str());
        const auto missing = test::runProgram("edgescan", "--no-settings --quit-after 60 --screenshot " + picture + " 'no\xff.json'");
        QCOMPARE(missing.code, 1);
        QVERIFY2(missing.err.find("no\\xff.json") != std::string::npos, missing.err.c_str());
        const std::string odd = (folder_ / "odd\xff.pcd").string(), oddPicture = (folder_ / "odd\xff.png").string();
        QVERIFY(files::saveScan(test::boxesScan(30, 40, 8), odd));
        const auto bytes = test::runProgram("edgescan", "--no-settings --quit-after 60 --screenshot '" + oddPicture + "' '" + odd + "'");
        QVERIFY2(bytes.code == 0, bytes.err.c_str());
        QVERIFY(std::filesystem::exists(oddPicture));
        for (const char* flag : {"--quit-after", "--expected-lines", "--ticks-per-degree", "--screenshot-lines", "--beam-step"}) {
            const auto wrong = test::runProgram("edgescan", std::string(flag) + " nan");
            QCOMPARE(wrong.code, 2);
            QVERIFY2(wrong.err.find(flag) != std::string::npos && wrong.err.find(" to ") != std::string::npos, wrong.err.c_str());
        }
        const auto done = test::runProgram("edgescan", "--no-settings --quit-after 60 --screenshot " + picture + " " + placed_);
        QVERIFY2(done.code == 0, done.err.c_str());
        QVERIFY(QImage(exactText(picture)).height() > 100);
    }

    // Work that begins or ends does not push the views.
    void workInTheStatusLineMovesNothing() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        on.viewer.views.pin(on.picture().detection->edges->front());
        for (const int wide : {1024, 1280, 1366, 1920}) {
            QTRY_VERIFY((on.window.resize(wide, 800), on.window.width() == wide));
            QApplication::processEvents();
            const int high = on.viewer.statusLine.height();
            on.viewer.statusLine.showWork("Comparing with A", "reading the file", 0.4);
            QTRY_VERIFY(on.viewer.statusLine.findChild<QPushButton*>("cancel-work")->isVisible());
            QApplication::processEvents();
            QCOMPARE(on.viewer.statusLine.height(), high);
            on.viewer.statusLine.endWork();
        }
    }

    void changedSettingsAreToldAndOneKeyRestoresThem() {
        WindowFixture on;
        QVERIFY(on.showWith(placed_));
        QVERIFY(on.activate());
        const QString usual = "default settings", changed = "settings: 2 changed ▾";
        const QString set = QString("Set of default settings: %1 %2").arg(edges::kDefaultSet.name).arg(edges::kDefaultSet.version);
        auto* label = on.window.findChild<QLabel*>("settings");
        QVERIFY(on.use(edges::Settings{}));
        QCOMPARE(on.viewer.statusLine.settingsShown(), usual);
        edges::Settings turned;
        turned.creaseDeg += 7;
        turned.growthPercent += 1;
        QVERIFY(on.use(turned));
        QCOMPARE(on.viewer.statusLine.settingsShown(), changed);
        QVERIFY2(label->toolTip().startsWith(set) && label->toolTip().contains("Crease angle: 37 instead of 30"),
                 qPrintable(label->toolTip()));
        // Also if a preset with these settings is chosen.
        on.viewer.tuning.usePreset({"mine", "", turned, {}});
        QCOMPARE(on.viewer.statusLine.settingsShown(), changed);
        // A click lists them; each can be reset alone.
        auto* list = on.window.findChild<QMenu*>("settings-changed");
        QTest::mouseClick(label, Qt::LeftButton);
        QVERIFY(list->isVisible());
        QVERIFY2(list->actions().front()->text().startsWith("Reset Crease angle: 37 instead of 30") ||
                     list->actions().front()->text().startsWith("Reset Jump growth: 2 instead of 1"),
                 qPrintable(list->actions().front()->text()));
        QCOMPARE(list->actions().size(), 4); // two, a line, all
        list->close();
        list->actions().front()->trigger();
        QCOMPARE(on.viewer.statusLine.settingsShown(), QString("settings: 1 changed ▾"));
        on.viewer.undo.undo();
        QCOMPARE(on.viewer.statusLine.settingsShown(), changed);
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(on.viewer.statusLine.settingsShown(), usual);
        QVERIFY(on.viewer.engine.settings() == edges::Settings{});
        QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(on.viewer.engine.settings() == turned);
        // While rocks are shown their settings count, too: they go on to the next scan.
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ControlModifier);
        QTest::keyClick(&on.window, Qt::Key_Period);
        QCOMPARE(on.viewer.statusLine.settingsShown(), usual);
        QTest::keyClick(&on.window, Qt::Key_K);
        QCOMPARE(on.viewer.statusLine.settingsShown(), QString("settings: 1 changed ▾"));
        QVERIFY2(label->toolTip().contains("Fine to coarse: 0.5 instead of 0.0"), qPrintable(label->toolTip()));
        QTest::keyClick(&on.window, Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(on.viewer.statusLine.settingsShown(), usual);
        QCOMPARE(on.viewer.rocks.settings().level, 0.0);
    }
};

int manners_test(int argc, char** argv) { return runWindowTest<MannersTest>(argc, argv); }
#include "manners_test.moc"
