// Shortcuts that the operator changes: in the real window, with real keys; the palette and the sheet show the current ones.
#include "tests/support/folders.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/command_palette.h"
#include "ui/panels/dialogs/shortcut_editor.h"
#include "ui/panels/keys/key_editing.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/window/manual.h"

#include <QAction>
#include <QDesktopServices>
#include <QDialog>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QUrl>

using namespace edgescan;
using namespace edgescan::ui;

/// In place of the browser.
class UrlCatcher : public QObject {
    Q_OBJECT
public:
    explicit UrlCatcher(QStringList& opened) : opened_(opened) {}
public slots:
    void take(const QUrl& url) { opened_ << url.toString(); }

private:
    QStringList& opened_;
};

class ShortcutsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;

    static KeyedCommand commandOf(MainWindow& window, const QString& id) {
        const QList<KeyedCommand> all = keyedCommands(window.actions());
        const auto found = std::find_if(all.begin(), all.end(), [&](const KeyedCommand& each) { return each.id == id; });
        if (found == all.end()) qFatal("there is no %s", qPrintable(id));
        return *found;
    }
    // Opens Help > Change Keys, lets `work` use it, and closes it.
    static void inEditor(MainWindow& window, const std::function<void(ShortcutEditor&)>& work) {
        bool done = false;
        QTimer looks;
        connect(&looks, &QTimer::timeout, &window, [&] {
            auto* editor = qobject_cast<ShortcutEditor*>(QApplication::activeModalWidget());
            if (editor == nullptr || done) return;
            done = true;
            looks.stop();
            work(*editor);
            editor->reject();
        });
        looks.start(20);
        commandOf(window, "Help/Change Keys").action->trigger();
        QVERIFY(done);
    }
    static void choose(ShortcutEditor& editor, const QString& words) {
        editor.words()->clear();
        QTest::keyClicks(editor.words(), words);
        int seen = 0;
        for (int n = 0; n < editor.table()->rowCount(); ++n) seen += editor.table()->isRowHidden(n) ? 0 : 1;
        QCOMPARE(seen, 1);
        QVERIFY(!editor.table()->isRowHidden(editor.table()->currentRow()));
    }
    static void press(ShortcutEditor& editor, Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(editor.keyField(), key, with);
        QTRY_VERIFY(editor.keyField()->keySequence().isEmpty()); // the field waits a second for further keys
    }

private slots:
    void everyCommandIsInTheTableAndHasANameOfItsOwn() {
        WindowFixture on;
        QVERIFY(on.show());
        const QList<KeyedCommand> all = keyedCommands(on.window.actions());
        int named = 0;
        for (const QAction* action : on.window.actions()) named += action->isSeparator() ? 0 : 1;
        QCOMPARE(all.size(), named); // two commands of the same name would be one row
        QVERIFY(all.size() > 60);
        QCOMPARE(commandOf(on.window, "View/Look from/From Scanner").usual, QList<QKeySequence>{QKeySequence("0")});
    }

    void aChangedKeyDoesWhatItSaysAndIsRemembered() {
        const QString ini = QString::fromStdString((folder_ / "keys.ini").string());
        {
            WindowFixture on(ini);
            QVERIFY(on.show() && on.activate());
            QAction* edges = commandOf(on.window, "View/Edge Points").action;
            QVERIFY(edges->isChecked());
            inEditor(on.window, [](ShortcutEditor& editor) {
                choose(editor, "edge points");
                press(editor, Qt::Key_F8);
                QVERIFY2(editor.message().startsWith("✓"), qPrintable(editor.message()));
                QVERIFY(editor.table()->item(editor.table()->currentRow(), 1)->text().contains("changed"));
            });
            QVERIFY(on.activate()); // the dialog had the keyboard focus
            on.viewer.views.cloud().setFocus();
            QTest::keyClick(&on.window, Qt::Key_E);
            QVERIFY2(edges->isChecked(), "the old key does nothing");
            QTest::keyClick(&on.window, Qt::Key_F8);
            QVERIFY(!edges->isChecked());
            // The palette shows the current shortcut.
            CommandPalette palette(on.window.actions(), &on.window);
            QTest::keyClicks(palette.words(), "edge points");
            QVERIFY2(palette.list()->item(0)->text().endsWith("F8"), qPrintable(palette.list()->item(0)->text()));
        }
        WindowFixture again(ini);
        QVERIFY(again.show());
        const KeyedCommand edges = commandOf(again.window, "View/Edge Points");
        QCOMPARE(edges.action->shortcuts(), QList<QKeySequence>{QKeySequence("F8")});
        inEditor(again.window, [](ShortcutEditor& editor) {
            choose(editor, "edge points");
            QTest::mouseClick(editor.findChild<QPushButton*>("shortcut-reset"), Qt::LeftButton);
        });
        QCOMPARE(edges.action->shortcuts(), edges.usual);
        WindowFixture third(ini);
        QCOMPARE(commandOf(third.window, "View/Edge Points").action->shortcuts(), QList<QKeySequence>{QKeySequence("E")});
    }

    void aKeyThatIsTakenIsRefusedByName() {
        WindowFixture on;
        QVERIFY(on.show());
        const KeyedCommand edges = commandOf(on.window, "View/Edge Points");
        inEditor(on.window, [](ShortcutEditor& editor) {
            choose(editor, "edge points");
            press(editor, Qt::Key_K);
            QVERIFY2(editor.message().contains("Rocks > Show Rocks"), qPrintable(editor.message()));
            press(editor, Qt::Key_Backslash); // a fixed key of the window, not a command
            QVERIFY2(editor.message().startsWith("▲"), qPrintable(editor.message()));
        });
        QCOMPARE(edges.action->shortcuts(), edges.usual);
        // Free once its owner has no shortcut.
        inEditor(on.window, [](ShortcutEditor& editor) {
            choose(editor, "show rocks");
            QTest::mouseClick(editor.findChild<QPushButton*>("shortcut-none"), Qt::LeftButton);
            choose(editor, "edge points");
            press(editor, Qt::Key_K);
            QVERIFY2(editor.message().startsWith("✓"), qPrintable(editor.message()));
            choose(editor, "show rocks");
            QTest::mouseClick(editor.findChild<QPushButton*>("shortcut-reset"), Qt::LeftButton);
            QVERIFY2(editor.message().startsWith("▲"), qPrintable(editor.message())); // otherwise the key would have two owners
            QTest::mouseClick(editor.findChild<QPushButton*>("shortcut-reset-all"), Qt::LeftButton);
        });
        for (const KeyedCommand& each : keyedCommands(on.window.actions())) QCOMPARE(each.action->shortcuts(), each.usual);
    }

    void twoThatChangedKeysWithEachOtherKeepThem() {
        const QString ini = QString::fromStdString((folder_ / "swap.ini").string());
        {
            WindowFixture on(ini);
            const QList<KeyedCommand> all = keyedCommands(on.window.actions());
            const KeyedCommand top = commandOf(on.window, "View/Look from/Top (from Above)");
            const KeyedCommand front = commandOf(on.window, "View/Look from/Front");
            QVERIFY(changeKey(top, QKeySequence(), all, on.preferences));
            QVERIFY(changeKey(front, QKeySequence("7"), all, on.preferences));
            QVERIFY(changeKey(top, QKeySequence("1"), all, on.preferences));
        }
        WindowFixture again(ini);
        QCOMPARE(commandOf(again.window, "View/Look from/Top (from Above)").action->shortcut(), QKeySequence("1"));
        QCOMPARE(commandOf(again.window, "View/Look from/Front").action->shortcut(), QKeySequence("7"));
    }

    // F1 opens the page of the manual in the browser, or says where it is if no manual is installed; both name the page.
    void f1OpensThePageOfWhatHasTheFocus() {
        WindowFixture on;
        QVERIFY(on.showWith(usualScan(folder_)));
        QVERIFY(on.activate());
        QStringList opened;
        UrlCatcher catcher{opened};
        QDesktopServices::setUrlHandler("file", &catcher, "take");
        const auto pageOpened = [&](QWidget* at) {
            opened.clear();
            on.viewer.notice.hide();
            at->setFocus();
            QTest::keyClick(at, Qt::Key_F1);
            return opened.isEmpty() ? on.viewer.notice.text() : opened.join(' ');
        };
        const QString edges = pageOpened(on.slider("sensitivity")), image = pageOpened(&on.viewer.gray);
        ShortcutEditor editor(
            {}, [] {}, &on.window);
        static_cast<QDialog&>(editor).show();
        QVERIFY(QTest::qWaitForWindowExposed(&editor));
        editor.activateWindow();                                                    // not every desktop does it
        QTRY_COMPARE(QApplication::activeWindow(), static_cast<QWidget*>(&editor)); // Qt calls it active while its parent is
        const QString keys = pageOpened(editor.findChild<QLineEdit*>());
        QDesktopServices::unsetUrlHandler("file");
        QVERIFY2(edges.contains("guide/tune"), qPrintable(edges));
        QVERIFY2(image.contains("index"), qPrintable(image));
        QVERIFY2(keys.contains("guide/keys"), qPrintable(keys));
    }
    // In another language, too, F1 opens a page of this language where there is one; without a focus that is the quick start.
    void f1OpensThePageOfTheLanguage() {
        for (const char* code : {"fr", "es", "pt"}) {
            QVERIFY(useLanguage(code, QString::fromStdString(test::sourceFolder()) + "/resources/languages"));
            for (const char* page : {"index", "guide/quick-start", "guide/reading-the-picture", "guide/cab", "guide/troubleshooting"}) {
                const QString first = manualNames(page).front();
                QVERIFY2(first.contains(QString("/%1/").arg(code)), qPrintable(first));
                QVERIFY2(QFile::exists(QString::fromStdString(test::sourceFolder()) + "/docs/" + first + ".md"), qPrintable(first));
            }
            QCOMPARE(manualNames("guide/tune").back(), QString("guide/tune"));
        }
        useLanguage("en");
        QCOMPARE(manualNames("index"), QStringList{"index"});
    }
    void everyPageThatAPlaceHasIsInTheManual() {
        WindowFixture on;
        int known = 0;
        for (const QWidget* each : on.window.findChildren<QWidget*>()) {
            const QString page = manualPageOf(each);
            if (page == "index") continue;
            ++known;
            QVERIFY2(QFile::exists(QString::fromStdString(test::sourceFolder()) + "/docs/" + page + ".md"), qPrintable(page));
        }
        QVERIFY(known > 20);
        for (const char* name : {"dock-edges", "dock-rocks", "dock-rock-table", "dock-targets", "live-panel"})
            QVERIFY2(manualPageOf(on.window.findChild<QWidget*>(name)) != "index", name);
    }
};

int shortcuts_test(int argc, char** argv) { return runWindowTest<ShortcutsTest>(argc, argv); }
#include "shortcuts_test.moc"
