// Commands and the pages of the manual, in the real window with real keys.
#include "tests/support/folders.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/language/languages.h"
#include "ui/base/notice_bar.h"
#include "ui/panels/dialogs/command_palette.h"
#include "ui/panels/keys/shortcuts.h"
#include "ui/window/manual.h"

#include <QAction>
#include <QDesktopServices>
#include <QListWidget>
#include <QTableWidget>
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

private slots:
    void everyCommandIsInTheTableAndHasANameOfItsOwn() {
        WindowFixture on;
        QVERIFY(on.show());
        const QList<KeyedCommand> all = keyedCommands(on.window.actions());
        int named = 0;
        for (const QAction* action : on.window.actions()) named += action->isSeparator() ? 0 : 1;
        QCOMPARE(all.size(), named); // two commands of the same name would be one row
        QVERIFY(all.size() > 60);
        QCOMPARE(commandOf(on.window, "View/Look from/From Scanner").action->shortcuts(), QList<QKeySequence>{QKeySequence("0")});
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
        QDesktopServices::unsetUrlHandler("file");
        QVERIFY2(edges.contains("guide/tune"), qPrintable(edges));
        QVERIFY2(image.contains("index"), qPrintable(image));
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
