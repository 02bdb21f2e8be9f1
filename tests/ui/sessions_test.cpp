// Sessions in the real window and the real program: saved as they change, restored after kill -9, embedded in screenshots.
#include "core/base/whole_file.h"
#include "core/inspect/session_file/session_file.h"
#include "tests/support/folders.h"
#include "tests/support/point_lists.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/notice_bar.h"
#include "ui/controllers/scan_look.h"
#include "ui/controllers/sessions/session_in_picture.h"
#include "ui/controllers/sessions/sessions.h"
#include "ui/panels/cab/cab_frame.h"
#include "ui/panels/change/change_legend.h"
#include "ui/panels/live/live_panel.h"
#include "ui/panels/start/start_page.h"
#include "ui/panels/tuning/range_window.h"
#include "ui/window/cab_mode.h"
#include "ui/window/start.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QDropEvent>
#include <QLabel>
#include <QListWidget>
#include <QLockFile>
#include <QMimeData>
#include <QProcess>
#include <QRegularExpression>
#include <QToolButton>

#include <csignal>
#include <memory>

using namespace edgescan;
using namespace edgescan::ui;

class SessionsTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::string boxes_, other_;

    [[nodiscard]] QString inFolder(const char* name) const { return QString::fromStdString((folder_ / name).string()); }
    static bool atRest(WindowFixture& on) {
        return eventually([&] {
            MainWindow& w = on.window;
            return w.viewer().engine.picture() != nullptr && !w.viewer().engine.behind() && !w.viewer().engine.working() &&
                   !w.viewer().rocks.behind() && w.viewer().comparing.settled() && w.viewer().targets.settled() && w.sessions().settled();
        });
    }
    static void drop(MainWindow& window, const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &event);
    }
    /// Changes display settings, by keys and mouse if possible.
    static void setLooks(WindowFixture& on) {
        MainWindow& w = on.window;
        QTest::keyClick(&w, Qt::Key_J, Qt::ShiftModifier); // colours by range
        RangeHandles& handles = w.viewer().rangeWindow.handles();
        for (int n = 0; n < 9; ++n) QTest::keyClick(&handles, Qt::Key_Left);
        QTest::keyClick(&handles, Qt::Key_Right, Qt::ShiftModifier);
        auto* lock = w.findChild<QToolButton*>("range-lock");
        QTest::mouseClick(lock, Qt::LeftButton);
        QVERIFY(lock->isChecked());
        for (int n = 0; n < 2; ++n) QTest::keyClick(&w, Qt::Key_BracketRight); // larger points
        w.viewer().views.cloud().setClip({0.1, 0.02});
        w.viewer().confidence.setLeast(40);
        QTest::mouseClick(w.viewer().changeLegend.row(ChangeRow::Lost), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
        QVERIFY(!w.viewer().comparing.rows()[static_cast<std::size_t>(ChangeRow::Lost)]);
    }
    /// Changes every kind of state.
    static void work(WindowFixture& on) {
        MainWindow& w = on.window;
        QTest::keyClick(&w, Qt::Key_A, Qt::ShiftModifier); // keep as A
        QTest::keyClick(&w, Qt::Key_K);                    // rocks
        QTest::keyClick(&w, Qt::Key_O);                    // edges over the range image
        edges::Settings other = w.viewer().engine.settings();
        other.classes = edges::kClassConvex;
        w.viewer().tuning.useSettings(other);
        QVERIFY(atRest(on));
        w.viewer().views.pin(w.viewer().views.cellAt(20, 30));
        w.viewer().views.pin(w.viewer().views.cellAt(60, 80));
        w.viewer().targets.rename(2, "keystone");
        w.viewer().targets.lock(1, true);
        w.viewer().targets.keepMeasure({inspect::MeasureKind::Distance, {20 * 160 + 30, 60 * 160 + 80}});
        w.viewer().selection.select({100, 101, 102, 5000});
        w.viewer().selection.hideSelected();
        w.viewer().selection.select({200, 201});
        w.viewer().markedEdges.mark(w.viewer().views.cellAt(30, 40), true);
        w.viewer().markedEdges.mark(w.viewer().views.cellAt(31, 90), false);
        rocks::RockSettings rocks = w.viewer().rocks.settings();
        rocks.level = 1.5;
        w.viewer().rocks.change(rocks);
        w.viewer().rocks.setOperatorEdits({{{rocks::EditKind::NotRock, {3000}}}, {}});
        setLooks(on);
        w.viewer().views.cloud().viewTop();
        w.viewer().views.gray().viewPort()->zoomAt(QPointF(80, 60), 3.0);
        QVERIFY(atRest(on));
    }
    /// The session text of the window, without its time.
    static std::string state(WindowFixture& on) {
        auto read = inspect::sessionFromText(on.window.sessions().textFor("/"), "/", "test");
        return read ? inspect::sessionText(read->state, "/", "") : std::string();
    }

    /// The first line that differs, as both have it; empty: none does.
    static QString differenceOf(const std::string& one, const std::string& other) {
        const QStringList a = QString::fromStdString(one).split('\n'), b = QString::fromStdString(other).split('\n');
        for (int n = 0; n < std::max(a.size(), b.size()); ++n) {
            if (a.value(n) != b.value(n)) return QString("line %1: %2 | %3").arg(n + 1).arg(a.value(n), b.value(n));
        }
        return {};
    }

private slots:
    void initTestCase() {
        qRegisterMetaType<exports::ExportContent>("edgescan::ExportContent");
        boxes_ = (folder_ / "boxes.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(120, 160, 3, 0.02), boxes_)));
        other_ = (folder_ / "other.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(120, 160, 9, 0.02), other_)));
    }

    void init() { QFile::remove(QString::fromStdString(boxes_ + ".rocks.json")); }

    void everythingIsBackFromItsFile() {
        const QString file = inFolder("day.edgescan-session.json");
        std::string before;
        {
            WindowFixture on;
            on.window.resize(1300, 850);
            QVERIFY(on.showWith(boxes_) && on.activate());
            on.window.sessions().saveAs(file);
            // Reported when it is on the disk, with its size.
            QTRY_VERIFY2(QRegularExpression("day.*changes, [0-9.]+ kB").match(on.viewer.notice.text()).hasMatch(),
                         qPrintable(on.viewer.notice.text()));
            work(on);
            before = state(on);
            // It is saved as it changes.
            QTRY_VERIFY(QFile::exists(file));
            const auto saved = inspect::readSession(file.toStdString());
            QVERIFY(bool(saved));
            QCOMPARE(differenceOf(inspect::sessionText(saved->state, "/", ""), before), QString());
            QCOMPARE(int(saved->state.targets.notebook.targets.size()), 2);
            QVERIFY(saved->state.earlier && saved->state.rocks && saved->state.view.camera && saved->state.view.images);
        }
        WindowFixture on;
        on.window.resize(1300, 850);
        QVERIFY(on.show());
        drop(on.window, file);
        QVERIFY(eventually([&] { return on.window.sessions().path() == file; }));
        QVERIFY(atRest(on));
        QTRY_VERIFY(on.viewer.comparing.pictureA() != nullptr);
        QVERIFY(on.viewer.comparing.pictureA()->detection->scan == on.picture().detection->scan); // the scan was read only once
        QCOMPARE(differenceOf(state(on), before), QString());
        QVERIFY(on.viewer.rocks.shown() && on.viewer.rocks.picture() != nullptr);
        QVERIFY(on.viewer.look.colourBy() == ColourBy::Range && on.window.findChild<QAction*>("colour-range")->isChecked());
        QVERIFY(on.viewer.views.rangeWindow() && on.viewer.look.rangeLocked());
        QCOMPARE(on.viewer.views.cloud().clip().nearShare, 0.1);
        QCOMPARE(on.viewer.confidence.least(), 40);
        // Another scan does not change the file.
        QVERIFY(on.open(other_));
        QVERIFY(atRest(on));
        QVERIFY(on.window.sessions().path().isEmpty());
        const auto left = inspect::readSession(file.toStdString());
        QCOMPARE(QString::fromStdString(left->state.scan.path.string()), QString::fromStdString(boxes_));
    }

    // Dropped, by File > Open and by --session alike; a damaged one is refused as what it is.
    void aSessionIsRecognisedByItsContentWhateverItsNameIs() {
        const QString file = inFolder("notes of monday.txt");
        {
            WindowFixture on;
            QVERIFY(on.showWith(boxes_));
            on.viewer.views.pin(on.viewer.views.cellAt(20, 30));
            on.window.sessions().saveAs(file);
            QVERIFY(atRest(on));
            QTRY_VERIFY(QFile::exists(file));
        }
        QVERIFY(inspect::isSession(file.toStdString()));
        QVERIFY(!inspect::isSession(boxes_));
        const std::vector<std::function<void(WindowFixture&)>> ways{
            [&](WindowFixture& on) { drop(on.window, file); },
            [&](WindowFixture& on) { emit on.viewer.files.chosen({file}); },
            [&](WindowFixture& on) { on.window.sessions().openSession(file); },
        };
        for (const auto& open : ways) {
            WindowFixture on;
            QVERIFY(on.show());
            open(on);
            QVERIFY(eventually([&] { return on.window.sessions().path() == file; }));
            QCOMPARE(int(on.viewer.targets.notebook().targets.size()), 1);
        }
        const std::string whole = std::string(textOf(*readWholeFile(file.toStdString())));
        test::writeText(file.toStdString(), whole.substr(0, whole.size() / 2));
        WindowFixture on;
        QVERIFY(on.show());
        drop(on.window, file);
        QTRY_VERIFY(on.viewer.notice.kind() == NoticeBar::Kind::Error);
        QVERIFY2(on.viewer.notice.text().contains("JSON"), qPrintable(on.viewer.notice.text()));
    }

    void aSessionChangesNoHabitAndComesBackFromACab() {
        const QString file = inFolder("habits.edgescan-session.json");
        const auto named = [](WindowFixture& on, const char* name) {
            for (QAction* action : on.window.actions()) {
                if (action->text() == name) return action;
            }
            qFatal("there is no command %s", name);
        };
        {
            WindowFixture on;
            on.window.resize(1300, 850);
            QVERIFY(on.showWith(boxes_) && on.activate());
            named(on, "&Wheel the other way")->trigger();
            QVERIFY(named(on, "&Wheel the other way")->isChecked());
            auto* alone = on.viewer.views.edges().parentWidget()->findChild<QToolButton*>("pane-alone");
            QTest::mouseClick(alone, Qt::LeftButton);
            QVERIFY(!on.viewer.views.cloud().isVisible());
            on.window.sessions().saveAs(file);
            QVERIFY(atRest(on));
            QTRY_VERIFY(QFile::exists(file));
        }
        WindowFixture on;
        on.window.resize(1300, 850);
        QVERIFY(on.show());
        on.window.sessions().openSession(file);
        QVERIFY(eventually([&] { return on.window.sessions().path() == file; }));
        QVERIFY(atRest(on));
        QVERIFY(!named(on, "&Wheel the other way")->isChecked());
        QVERIFY(!on.viewer.views.cloud().isVisible() && on.viewer.views.edges().isVisible());
        // A session saved in cab mode does not change docks: outside cab mode they have their former places.
        on.window.cab().set(true);
        QCOMPARE(on.window.layoutKept().size(), std::size_t(1)); // which view is large in the cab
        on.window.useLayout({{"docks", "AAAA"}});
        QVERIFY(on.window.cab().on() && on.viewer.views.cloud().isVisible());
        on.window.cab().set(false);
    }

    void aScanThatMovedOrChangedIsSaid() {
        const std::string scan = (folder_ / "moves.json").string();
        QVERIFY(bool(files::saveScan(test::boxesScan(120, 160, 3, 0.02), scan)));
        const QString file = inFolder("moves.edgescan-session.json");
        {
            WindowFixture on;
            QVERIFY(on.showWith(scan));
            on.viewer.views.pin(on.viewer.views.cellAt(20, 30));
            on.window.sessions().saveAs(file);
            QVERIFY(atRest(on));
        }
        const std::string before = std::string(textOf(*readWholeFile(file.toStdString())));
        QDir().mkpath(inFolder("elsewhere"));
        for (const char* name : {"moves.json", "moves.u16"}) QVERIFY(QFile::rename(inFolder(name), inFolder("elsewhere") + "/" + name));
        WindowFixture on;
        QVERIFY(on.show());
        on.window.sessions().openSession(file);
        QTRY_VERIFY2(on.viewer.notice.isVisible() && on.viewer.notice.text().contains("was not found"),
                     qPrintable(on.viewer.notice.text()));
        auto* locate = on.window.findChild<QToolButton*>("notice-action");
        QVERIFY(locate->isVisible());
        QCOMPARE(locate->text(), QString("Locate…"));
        // Another scan is refused.
        on.window.sessions().locate(QString::fromStdString(other_));
        QVERIFY(on.settled());
        QTRY_VERIFY2(on.viewer.notice.text().contains("is not the scan of this session"), qPrintable(on.viewer.notice.text()));
        QVERIFY(on.viewer.targets.notebook().empty());
        QCOMPARE(QString::fromStdString(std::string(textOf(*readWholeFile(file.toStdString())))), QString::fromStdString(before));
        on.window.sessions().locate(inFolder("elsewhere/moves.json"));
        QTRY_COMPARE(int(on.viewer.targets.notebook().targets.size()), 1);
        QTRY_COMPARE(on.window.sessions().path(), file);
        // A damaged file gives one sentence, and the window does not change.
        const QString damaged = inFolder("damaged.edgescan-session.json"); // the window may store the other one at any time
        test::writeText(damaged.toStdString(), before.substr(0, before.size() / 2));
        on.window.sessions().openSession(damaged);
        QTRY_VERIFY(on.viewer.notice.kind() == NoticeBar::Kind::Error);
        QCOMPARE(int(on.viewer.targets.notebook().targets.size()), 1);
    }

    void aScreenshotCarriesTheSession() {
        const QString picture = inFolder("shot.png");
        std::string before;
        {
            WindowFixture on;
            on.window.resize(1300, 850);
            QVERIFY(on.showWith(boxes_) && on.activate());
            work(on);
            before = state(on);
            QVERIFY(bool(on.viewer.exports.saveScreenshot(on.window.screenshot(), picture)));
            QFile::remove(QString::fromStdString(boxes_ + ".rocks.json"));
        }
        QVERIFY(!QImage(picture).isNull());
        QVERIFY(!sessionIn(picture).empty());
        WindowFixture on;
        on.window.resize(1300, 850);
        QVERIFY(on.show());
        drop(on.window, picture);
        QTRY_COMPARE(int(on.viewer.targets.notebook().targets.size()), 2);
        QVERIFY(atRest(on));
        QTRY_VERIFY(on.viewer.comparing.pictureA() != nullptr && on.window.sessions().settled());
        QCOMPARE(differenceOf(state(on), before), QString());
        QVERIFY(on.window.sessions().path().isEmpty());
        // A picture of ranges is still a scan.
        const QString ranges = inFolder("plain.png");
        QImage plain(30, 20, QImage::Format_Grayscale16);
        plain.fill(3000);
        QVERIFY(plain.save(ranges));
        QVERIFY(sessionIn(ranges).empty());
    }

    void afterAKillTheNextStartGoesOn() {
        const QString home = inFolder("home");
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_CONFIG_HOME", home + "/config");
        environment.insert("XDG_CACHE_HOME", home + "/cache");
        const QString sessions = home + "/config/edgescan/sessions";
        const QString program = QString::fromStdString(test::programFolder()) + "/edgescan";
        const auto saved = [&](qint64 process) {
            const QString path = sessions + "/running-" + QString::number(process) + "-0" + inspect::kSessionEnding;
            const auto read = QFile::exists(path) ? inspect::readSession(path.toStdString()) : Result<inspect::ReadSession>(Error{});
            return read ? std::optional(*read) : std::nullopt;
        };
        const auto isWhole = [](const std::optional<inspect::ReadSession>& read) {
            return read && read->state.targets.notebook.targets.size() == 2 && read->state.earlier &&
                   !read->state.targets.notebook.targets[1].asPinned.empty();
        };
        const auto textOfAll = [](const std::optional<inspect::ReadSession>& read) {
            return read ? QString::fromStdString(inspect::sessionText(read->state, "/", "")) : QString();
        };
        QString before;
        {
            QProcess viewer;
            viewer.setProcessEnvironment(environment);
            viewer.start(program, {QString::fromStdString(boxes_), "--method", "canny", "--lower", "7", "--pin", "20,30", "--pin", "60,80",
                                   "--compare", QString::fromStdString(other_), "--unit", "mm"});
            QVERIFY(viewer.waitForStarted(kPatienceMs));
            const qint64 process = viewer.processId();
            QVERIFY(eventually([&] { return isWhole(saved(process)); }));
            QCOMPARE(::kill(static_cast<pid_t>(process), SIGKILL), 0);
            QVERIFY(viewer.waitForFinished(kPatienceMs));
            before = textOfAll(saved(process));
        }
        // The targets are in the session too, not only in the viewer's folder of targets.
        QDir(home + "/config/edgescan/targets").removeRecursively();
        {
            QProcess viewer;
            viewer.setProcessEnvironment(environment);
            viewer.start(program, {"--continue"});
            QVERIFY(viewer.waitForStarted(kPatienceMs));
            QVERIFY(eventually([&] { return isWhole(saved(viewer.processId())); }));
            QTRY_COMPARE(textOfAll(saved(viewer.processId())), before);
            const qint64 process = viewer.processId();
            ::kill(static_cast<pid_t>(process), SIGKILL);
            QVERIFY(viewer.waitForFinished(kPatienceMs));
            // As if the images had been zoomed to a changed region.
            auto zoomed = saved(process);
            zoomed->state.view.images = inspect::SessionImages{80.0, 60.0, 12.0};
            const QString path = sessions + "/running-" + QString::number(process) + "-0" + inspect::kSessionEnding;
            QVERIFY(bool(writeWholeFile(path.toStdString(), inspect::sessionText(zoomed->state, sessions.toStdString(), ""))));
            QVERIFY(saved(process)->state.view.images.has_value());
        }
        // The window reports it, and its button continues the session, with whole images.
        WindowFixture on(home + "/config/edgescan/viewer.ini");
        QVERIFY(on.show());
        on.window.sessions().offerToContinue();
        auto* button = on.window.findChild<QToolButton*>("notice-action");
        QTRY_VERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(int(on.viewer.targets.notebook().targets.size()), 2);
        QVERIFY(atRest(on));
        QVERIFY(on.viewer.gray.viewPort()->fitted());
        QVERIFY(on.window.sessions().autosaves().afterCrash().size() <= 1); // the first one; the second was continued
    }

    // After a crash the newest session is the last one, whether it was closed or not.
    void whatWasClosedAfterACrashIsTheLastSession() {
        QDir().mkpath(inFolder("later/sessions"));
        const auto write = [&](const char* name, int secondsAgo) {
            QFile file(inFolder("later/sessions/") + name + inspect::kSessionEnding);
            return file.open(QIODevice::WriteOnly) && file.write("{}") == 2 && file.flush() &&
                   file.setFileTime(QDateTime::currentDateTime().addSecs(-secondsAgo), QFileDevice::FileModificationTime);
        };
        QVERIFY(write("running-999999-0", 3600));
        QVERIFY(write("running-999998-0", 5400)); // of an earlier crash
        auto first = std::make_unique<WindowFixture>(inFolder("later/viewer.ini"));
        WindowFixture& on = *first;
        QVERIFY(on.window.sessions().toGoOn().contains("running-999999-0"));
        QVERIFY(write("last", 60));
        QVERIFY(on.window.sessions().toGoOn().contains("/last"));
        QVERIFY(write("last", 7200));
        QVERIFY(on.window.sessions().toGoOn().contains("running-999999-0"));
        on.window.sessions().offerToContinue();
        const QString at = QDateTime::currentDateTime().addSecs(-3600).toString("yyyy-MM-dd HH:mm");
        QVERIFY2(on.viewer.notice.text().contains(at), qPrintable(on.viewer.notice.text()));
        // A viewer that is closed has offered it, and with it the older one. The next one offers none again, and Go On still finds it.
        first.reset();
        WindowFixture next(inFolder("later/viewer.ini"));
        next.window.sessions().offerToContinue();
        QVERIFY(!next.viewer.notice.isVisible());
        QVERIFY(next.window.sessions().toGoOn().contains("crashed-999999-0"));
    }

    // A process that was just killed holds its session for a moment.
    void theStartPageFindsALateSession() {
        QDir().mkpath(inFolder("late/sessions"));
        WindowFixture on(inFolder("late/viewer.ini"));
        on.preferences.keep("tour-ended", true);
        const QString path = inFolder("late/sessions/running-999999-0") + inspect::kSessionEnding;
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{}") == 2);
        file.close();
        QLockFile held(path + ".lock");
        QVERIFY(held.tryLock(0));
        QVERIFY(on.show());
        QVERIFY(on.window.sessions().toGoOn().isEmpty());
        StartPage* page = showStart(on.window, on.preferences);
        const auto* button = page->findChild<QAbstractButton*>("start-session");
        QVERIFY(!button->isEnabled());
        struct Watch : QObject {
            int seen = 0;
            bool eventFilter(QObject*, QEvent* event) override {
                seen += event->type() == QEvent::EnabledChange ? 1 : 0;
                return false;
            }
        } watch;
        page->findChild<QAbstractButton*>("start-session")->installEventFilter(&watch);
        held.unlock();
        QTRY_VERIFY(watch.seen > 0);
    }

    void theStartPageIsUsedByKeys() {
        QDir().mkpath(inFolder("start"));
        const QString gone = inFolder("start/gone.json");
        qputenv("XDG_CACHE_HOME", inFolder("start/cache").toUtf8());
        WindowFixture on(inFolder("start/viewer.ini"));
        on.preferences.keep("tour-ended", true); // the tour would cover the page
        on.preferences.keepRecentFile(gone);
        on.preferences.keepRecentFile(QString::fromStdString(other_));
        on.preferences.keepRecentFile(QString::fromStdString(boxes_));
        on.window.resize(1280, 800);
        QVERIFY(on.show() && on.activate());
        StartPage* page = showStart(on.window, on.preferences);
        QTRY_VERIFY(page->isVisible() && page->settled());
        QListWidget& list = page->list();
        QCOMPARE(list.count(), 3);
        QVERIFY2(list.item(0)->text().contains("boxes.json\n120 × 160 · FILE"), qPrintable(list.item(0)->text()));
        QVERIFY(!list.item(0)->icon().isNull() && list.item(2)->icon().isNull());
        QVERIFY2(list.item(2)->text().contains("not found") && list.item(2)->text().contains("Locate"), qPrintable(list.item(2)->text()));
        // No part of the window shows below it.
        QVERIFY(page->geometry().contains(on.window.centralWidget()->geometry()));
        // Its pictures are stored: the second time no scan is read.
        const QStringList kept = QDir(inFolder("start/cache/edgescan/recent")).entryList({"*.png"});
        QCOMPARE(kept.size(), 2);
        QVERIFY(recentScan(QString::fromStdString(boxes_), inFolder("start/cache/edgescan/recent"), [] {
                    return false;
                }).words.contains("120"));
        QVERIFY(!recentScan(QString::fromStdString(boxes_), QString(), [] { return false; }).words.contains("120"));
        trimThumbnails(inFolder("start/cache/edgescan/recent"), 1);
        QCOMPARE(QDir(inFolder("start/cache/edgescan/recent")).entryList({"*.png"}).size(), 1);
        // Only with keys: to the list, down, and open.
        QTRY_COMPARE(QApplication::focusWidget()->objectName(), QString("start-open"));
        for (int n = 0; n < 10 && QApplication::focusWidget() != &list; ++n) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(&list));
        QTest::keyClick(&list, Qt::Key_Home);
        QTest::keyClick(&list, Qt::Key_Down);
        QTest::keyClick(&list, Qt::Key_Return);
        QVERIFY(on.settled());
        QTRY_VERIFY(page->isHidden());
        QCOMPARE(QString::fromStdString(on.picture().detection->scan->path), QString::fromStdString(other_));
        // Connecting a scanner closes it too.
        on.preferences.keepRecentFile(gone);
        page->show();
        on.viewer.live.panel().hide();
        QTest::mouseClick(page->findChild<QAbstractButton*>("start-connect"), Qt::LeftButton);
        QVERIFY(page->isHidden() && on.viewer.live.panel().isVisible());
        qunsetenv("XDG_CACHE_HOME");
        page->show(); // a window that is closed while its page is shown
    }

    // The first half of a double click on the list opens the scan, the second half would pin a cell of the view that appears below it.
    void theSecondHalfOfADoubleClickOnTheListPinsNothing() {
        WindowFixture on(inFolder("twice.ini"));
        on.preferences.keep("tour-ended", true); // the tour would cover the page
        on.preferences.keepRecentFile(QString::fromStdString(boxes_));
        on.window.resize(1280, 800);
        QVERIFY(on.show() && on.activate());
        on.window.cab().set(true); // there the mouse is a finger
        QTRY_VERIFY(on.window.cab().on());
        StartPage* page = showStart(on.window, on.preferences);
        QTRY_VERIFY(page->isVisible() && page->settled());
        // A note above the page leaves nothing of the views uncovered next to it.
        const QWidget& head = on.window.cab().frame().head();
        on.viewer.notice.showNotice(NoticeBar::Kind::Warning, "EdgeScan ended without being closed.");
        QTRY_COMPARE(page->geometry().top(), head.mapTo(&on.window, QPoint(0, head.height())).y());
        const auto isIn = [&on](const QWidget& whole, QPoint at) {
            const QWidget* found = on.window.childAt(at);
            return found == &whole || whole.isAncestorOf(found);
        };
        QTRY_VERIFY(isIn(on.viewer.notice, on.viewer.notice.mapTo(&on.window, on.viewer.notice.rect().center())));
        for (const int x : {20, on.window.width() - 20}) QTRY_VERIFY(isIn(*page, QPoint(x, page->geometry().top() + 10)));
        on.viewer.notice.hide();
        QListWidget& list = page->list();
        const QRect row = list.visualItemRect(list.item(0));
        const QRect onWindow(list.viewport()->mapTo(&on.window, row.topLeft()), row.size());
        QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, row.center());
        QTRY_VERIFY(page->isHidden());
        QVERIFY(atRest(on));
        QPoint at;
        for (int x = onWindow.left() + 5; at.isNull() && x < onWindow.right() - 5; x += 5) {
            const QPoint here(x, onWindow.bottom() - 8);
            const auto* image = qobject_cast<const ImageView*>(on.window.childAt(here));
            const auto* cloud = qobject_cast<const CloudView*>(on.window.childAt(here));
            const bool hasCell = (image != nullptr && image->cellAt(image->mapFrom(&on.window, here))) ||
                                 (cloud != nullptr && cloud->cellAt(cloud->mapFrom(&on.window, here)));
            if (hasCell) at = here;
        }
        QVERIFY(!at.isNull());
        const auto click = [&] { QTest::mouseClick(on.window.windowHandle(), Qt::LeftButton, Qt::NoModifier, at); };
        page->show();
        QTRY_VERIFY(page->settled());
        const int usual = QApplication::doubleClickInterval();
        QApplication::setDoubleClickInterval(10000);
        click();
        QTRY_VERIFY(page->isHidden());
        click();
        QVERIFY(atRest(on));
        QVERIFY(on.viewer.targets.notebook().targets.empty());
        QApplication::setDoubleClickInterval(usual);
        click();
        QTRY_VERIFY(!on.viewer.targets.notebook().targets.empty());
        on.window.cab().set(false); // its style is that of the whole program
        QTRY_VERIFY(!on.window.cab().on());
    }

    void everyActIsTakenBackAndDoneAgain() {
        WindowFixture on;
        on.window.resize(1300, 850);
        QVERIFY(on.showWith(boxes_) && on.activate());
        on.viewer.undo.clear();
        work(on);
        const std::string after = state(on);
        QVERIFY(on.viewer.undo.count() >= 9);
        while (on.viewer.undo.canUndo()) QTest::keyClick(&on.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(atRest(on));
        MainWindow& w = on.window;
        QVERIFY(w.viewer().targets.notebook().empty() && w.viewer().selection.cells().empty() && w.viewer().selection.hidden().empty());
        QVERIFY(w.viewer().markedEdges.part().empty() && w.viewer().comparing.pictureA() == nullptr);
        QCOMPARE(w.viewer().rocks.settings().level, 0.0);
        while (on.viewer.undo.canRedo()) QTest::keyClick(&on.window, Qt::Key_Y, Qt::ControlModifier);
        QTRY_VERIFY(w.viewer().comparing.pictureA() != nullptr);
        QVERIFY(atRest(on));
        // The cell under the mouse is not part of the state.
        auto again = inspect::sessionFromText(state(on), "/", "test"), first = inspect::sessionFromText(after, "/", "test");
        again->state.targets.active = first->state.targets.active;
        QCOMPARE(differenceOf(inspect::sessionText(again->state, "/", ""), inspect::sessionText(first->state, "/", "")), QString());
        // The log uses the language of the sources, whatever the language of the window.
        QCOMPARE(w.viewer().undo.text(0), QString("Keep as A"));
    }

    // In a cab the large view is part of the session; after a crash a line names what is there again, and Undo has nothing.
    void theLargeViewOfACabComesBackAfterACrash() {
        QDir().mkpath(inFolder("cab/sessions"));
        const QString path = inFolder("cab/sessions/running-999999-0") + inspect::kSessionEnding;
        {
            WindowFixture on;
            QVERIFY(on.showWith(boxes_));
            on.window.cab().set(true);
            on.viewer.views.pin(100);
            QVERIFY(eventually([&] { return on.viewer.targets.settled(); }));
            on.viewer.rocks.setShown(true);
            QTRY_VERIFY(on.viewer.rocks.picture() && !on.viewer.rocks.behind());
            on.viewer.rocks.setOperatorEdits({{{rocks::EditKind::NotRock, {3000}}}, {}});
            QTRY_VERIFY(!on.viewer.rocks.behind());
            on.window.cab().useViews("edges edges");
            QVERIFY(on.viewer.views.edges().isVisible());
            QFile file(path);
            const std::string text = on.window.sessions().textFor(inFolder("cab/sessions"));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text.data(), static_cast<qint64>(text.size())) > 0);
            on.window.cab().set(false);
        }
        WindowFixture on(inFolder("cab/viewer.ini"));
        QVERIFY(on.show());
        on.window.cab().set(true);
        on.window.sessions().offerToContinue();
        auto* button = on.viewer.notice.findChild<QToolButton*>("notice-action");
        QTRY_VERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(on.viewer.targets.notebook().targets.size(), std::size_t(1));
        QTRY_VERIFY(on.viewer.views.edges().isVisible() && !on.viewer.views.cloud().isVisible());
        QCOMPARE(on.window.cab().viewsKept(), std::string("edges edges"));
        QVERIFY2(on.viewer.notice.text().startsWith("Restored: 1 target, edits of rocks: 1, settings, view."),
                 qPrintable(on.viewer.notice.text()));
        QVERIFY(!on.viewer.undo.canUndo() && on.viewer.targets.active() != nullptr);
        on.window.cab().set(false);
        QVERIFY(on.viewer.views.cloud().isVisible());
    }
};

int sessions_test(int argc, char** argv) { return runWindowTest<SessionsTest>(argc, argv); }
#include "sessions_test.moc"
