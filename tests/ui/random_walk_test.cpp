// Random events in the real window: every action, button, menu, table, slider, list, key and view, in random order, with a file and with a
// scanner. The program must not crash, hang or leak. EDGESCAN_WALK: number of events (10000 for a long walk), EDGESCAN_WALK_SEED: another
// walk.
#include "app/lab/emulator/emulator.h"
#include "app/lab/emulator/telegram.h"
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"
#include "ui/window/cab_mode.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QMenu>
#include <QRegularExpression>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <random>
#include <set>

#include <unistd.h>

using namespace edgescan;
using namespace edgescan::ui;

class RandomWalkTest : public QObject {
    Q_OBJECT
    test::TemporaryFolder folder_;
    std::vector<std::string> scans_;
    std::mt19937 dice_;

    std::size_t below(std::size_t n) { return n == 0 ? 0 : dice_() % n; }
    template <class T>
    T* anyOf(const QList<T*>& all) {
        return all.isEmpty() ? nullptr : all[static_cast<int>(below(static_cast<std::size_t>(all.size())))];
    }
    // A random element; every second time one that was not used yet. Counts available and used elements by kind and name.
    template <class T, class Name>
    T* freshOf(const QString& kind, const QList<T*>& all, Name name) {
        QList<T*> fresh;
        for (T* one : all) {
            met_[kind].insert(name(*one));
            if (used_[kind].count(name(*one)) == 0) fresh << one;
        }
        T* const chosen = below(2) == 0 && !fresh.isEmpty() ? anyOf(fresh) : anyOf(all);
        if (chosen != nullptr) {
            used_[kind].insert(name(*chosen));
            last_ = kind + " " + name(*chosen);
        }
        return chosen;
    }
    template <class T>
    static QList<T*> usableOf(const WindowFixture& on) {
        QList<T*> usable;
        for (T* widget : on.window.template findChildren<T*>()) {
            if (widget->isVisible() && widget->isEnabled()) usable << widget;
        }
        return usable;
    }
    // A name that is the same each time the widget is built: its own, or that of the nearest named parent.
    static QString nameOf(const QWidget& widget) {
        QString name = widget.objectName().isEmpty() ? widget.accessibleName() : widget.objectName();
        for (const QWidget* parent = widget.parentWidget(); name.isEmpty() && parent != nullptr; parent = parent->parentWidget()) {
            if (!parent->objectName().isEmpty()) name = QString("%1 in %2").arg(widget.metaObject()->className(), parent->objectName());
        }
        return name.remove(QRegularExpression("-\\d+$")); // one kind of button per rock or region
    }
    static double megabytes() {
        std::ifstream file("/proc/self/statm");
        std::size_t all = 0, resident = 0;
        file >> all >> resident;
        return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
    }
    // Actions that would end the walk, affect the machine or rightly take long.
    static bool isLeftOut(const QAction& action) {
        const QString text = QString(action.text()).remove('&');
        return isLeftOut(text) || text.isEmpty() || action.menu() != nullptr || action.isSeparator() || !action.isEnabled();
    }
    static bool isLeftOut(const QString& text) {
        static const QStringList left{"Quit", "Close EdgeScan", "Open Demo", "Connect", "Record", "Keep Last Minute", "Full Screen"};
        return std::any_of(left.begin(), left.end(), [&](const QString& one) { return text.startsWith(one); });
    }
    // Every second time an entry of an open menu is chosen first. Entries open dialogs, which are closed without an answer.
    void closeDialogs() {
        while (QWidget* popup = QApplication::activePopupWidget()) {
            auto* menu = qobject_cast<QMenu*>(popup);
            QList<QAction*> entries;
            if (menu != nullptr && below(2) == 0) {
                for (QAction* action : menu->actions()) {
                    if (!isLeftOut(*action)) entries << action;
                }
            }
            if (QAction* entry = anyOf(entries)) { // after the event that closes the menu, because it may open a dialog
                last_ = "entry " + entry->text();
                QMetaObject::invokeMethod(entry, &QAction::trigger, Qt::QueuedConnection);
            }
            if (!popup->close()) break;
        }
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->reject();
    }
    static void move(QWidget& view, QPoint at, Qt::MouseButtons buttons) {
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, Qt::NoModifier);
        QApplication::sendEvent(&view, &event);
    }
    QPoint placeIn(const QWidget& view) {
        return {static_cast<int>(below(static_cast<std::size_t>(std::max(1, view.width())))),
                static_cast<int>(below(static_cast<std::size_t>(std::max(1, view.height()))))};
    }
    QWidget& anyView(WindowFixture& on) {
        LinkedViews& views = on.viewer.views;
        const std::array<QWidget*, 3> all{&views.gray(), &views.edges(), &views.cloud()};
        return *all[below(3)];
    }

    void trigger(WindowFixture& on) {
        QList<QAction*> actions;
        for (QAction* action : on.window.findChildren<QAction*>()) {
            if (!isLeftOut(*action)) actions << action;
        }
        if (QAction* action = freshOf("action", actions, [](const QAction& one) {
                return one.objectName().isEmpty() ? one.text().section(':', 0, 0) : one.objectName();
            }))
            action->trigger();
    }
    void useMouse(WindowFixture& on) {
        QWidget& view = anyView(on);
        const std::array<Qt::MouseButton, 3> buttons{Qt::LeftButton, Qt::RightButton, Qt::MiddleButton};
        const std::array<Qt::KeyboardModifiers, 3> modifiers{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
        const Qt::MouseButton button = buttons[below(8) < 6 ? 0 : below(3)];
        last_ = "mouse on " + view.objectName();
        QTest::mousePress(&view, button, modifiers[below(8) < 6 ? 0 : below(3)], placeIn(view));
        for (std::size_t n = below(4); n > 0; --n) move(view, placeIn(view), button);
        QTest::mouseRelease(&view, button, Qt::NoModifier, placeIn(view));
        if (below(4) == 0) move(view, placeIn(view), Qt::NoButton);
    }
    void useKey(WindowFixture& on) {
        static const std::array<int, 22> keys{Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Left, Qt::Key_Right,    Qt::Key_Up, Qt::Key_Down,
                                              Qt::Key_Return, Qt::Key_Space,  Qt::Key_K,    Qt::Key_U,        Qt::Key_B,  Qt::Key_L,
                                              Qt::Key_P,      Qt::Key_I,      Qt::Key_E,    Qt::Key_X,        Qt::Key_G,  Qt::Key_W,
                                              Qt::Key_Tab,    Qt::Key_A,      Qt::Key_Z,    Qt::Key_Backslash};
        const auto key = static_cast<Qt::Key>(keys[below(keys.size())]);
        last_ = QString("key %1").arg(key);
        QTest::keyClick(&anyView(on), key, below(3) == 0 ? Qt::ShiftModifier : Qt::NoModifier);
    }
    void useWidget(WindowFixture& on) {
        const auto name = [](const QWidget& widget) { return nameOf(widget); };
        const std::size_t what = below(5);
        if (auto* button = what == 3 ? freshOf("button", buttonsOf(on), name) : nullptr) {
            QTest::mouseClick(button, Qt::LeftButton);
        } else if (auto* table = what == 4 ? freshOf("table", usableOf<QAbstractItemView>(on), name) : nullptr) {
            QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, placeIn(*table->viewport()));
        } else if (auto* slider = what == 0 ? freshOf("slider", usableOf<QAbstractSlider>(on), name) : nullptr) {
            slider->setValue(slider->minimum() +
                             static_cast<int>(below(static_cast<std::size_t>(slider->maximum() - slider->minimum()) + 1)));
        } else if (auto* list = what == 1 ? freshOf("list", usableOf<QComboBox>(on), name) : nullptr) {
            if (list->count() > 0) list->setCurrentIndex(static_cast<int>(below(static_cast<std::size_t>(list->count()))));
        } else if (auto* box =
                       freshOf("switch", usableOf<QCheckBox>(on), [](const QCheckBox& one) { return one.text().section("  ", 0, 0); })) {
            box->click();
        }
    }
    static QList<QAbstractButton*> buttonsOf(const WindowFixture& on) {
        QList<QAbstractButton*> buttons;
        for (QAbstractButton* button : usableOf<QAbstractButton>(on)) {
            if (qobject_cast<QCheckBox*>(button) == nullptr && !isLeftOut(QString(button->text()).remove('&'))) buttons << button;
        }
        return buttons;
    }
    // Connects to the scanner, or records from it; a button of the window stops both.
    void useScanner(WindowFixture& on) {
        Live& live = on.viewer.live;
        if (live.scanner().connected()) {
            last_ = "record";
            live.record(!live.scanner().recording());
            return;
        }
        last_ = "connect";
        scanner::SweepSettings sweep;
        sweep.expectedLines = below(2) == 0 ? 0 : 60;
        sweep.degPerLine = 3;
        live.connectTo("127.0.0.1", emulated_->port(), sweep);
    }
    void step(WindowFixture& on) {
        const std::size_t what = below(100);
        if (emulated_ && below(20) == 0)
            useScanner(on);
        else if (what < 30)
            trigger(on);
        else if (what < 60)
            useMouse(on);
        else if (what < 80)
            useKey(on);
        else if (what < 96)
            useWidget(on);
        else {
            last_ = "open";
            on.viewer.files.open({QString::fromStdString(scans_[below(scans_.size())])});
        }
        closeDialogs();
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    }

    // Used elements of each kind, with the names of used and unused ones.
    QString whatWasUsed() const {
        QString text;
        for (const auto& [kind, met] : met_) {
            const std::set<QString>& used = used_.at(kind);
            text += QString("; %1s %2 of %3").arg(kind).arg(used.size()).arg(met.size());
            for (const QString& one : met) {
                if (used.count(one) == 0) text += " [" + one + "]";
            }
        }
        return text.mid(2);
    }

    std::unique_ptr<scanner::EmulatedScanner> emulated_;
    QString last_;
    std::map<QString, std::set<QString>> met_, used_;

    // A small sweep again and again, two a second.
    bool serve() {
        sim::SimulationSettings settings;
        settings.lines = 60;
        settings.beams = 120;
        auto telegrams = scanner::telegramsOf(sim::simulate(settings)->scan);
        if (!telegrams) return false;
        scanner::EmulatedScannerSettings speed;
        speed.linesPerSecond = 120;
        auto emulated = scanner::serveTelegrams(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), speed);
        if (emulated) emulated_ = std::move(*emulated);
        return bool(emulated);
    }

private slots:
    void initTestCase() {
        sim::SimulationSettings settings;
        settings.lines = 90;
        settings.beams = 120;
        for (const bool after : {false, true}) {
            settings.afterBlast = after;
            scans_.push_back((folder_ / (after ? "after.json" : "before.json")).string());
            QVERIFY(bool(files::saveScan(sim::simulate(settings)->scan, scans_.back())));
        }
        scans_.push_back((folder_ / "boxes.json").string());
        QVERIFY(bool(files::saveScan(test::boxesScan(60, 80, 3, 0.02), scans_.back())));
        std::ofstream(folder_ / "broken.json") << "{";
        scans_.push_back((folder_ / "broken.json").string());
    }

    void nothingFallsOver_data() {
        QTest::addColumn<bool>("live");
        QTest::newRow("file") << false;
        QTest::newRow("scanner") << true;
    }
    void nothingFallsOver() {
        QFETCH(bool, live);
        met_.clear();
        used_.clear();
        const int asked = qEnvironmentVariableIntValue("EDGESCAN_WALK");
        const int events = asked > 0 ? asked : 400;
        dice_.seed(static_cast<unsigned>(std::max(1, qEnvironmentVariableIntValue("EDGESCAN_WALK_SEED"))));
        QApplication::setQuitOnLastWindowClosed(false);
        WindowFixture on;
        on.window.resize(1280, 800);
        on.viewer.live.setRecordingFolder(QString::fromStdString((folder_ / "recordings").string()));
        if (live) QVERIFY(serve());
        QVERIFY(on.showWith(scans_.front()) && on.activate());
        // Menus and dialogs have their own event loops: closed by a timer.
        QTimer closer;
        QObject::connect(&closer, &QTimer::timeout, this, [this] { closeDialogs(); });
        closer.start(30);
        std::vector<double> memory, slowest;
        double before = megabytes();
        for (int n = 0; n < events; ++n) {
            QElapsedTimer timer;
            timer.start();
            step(on);
            slowest.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
            // Leaves cab mode, which hides most panels, as holding its button does.
            if (n % 200 == 199 && on.window.cab().on()) emit on.window.cab().leaveRequested();
            if (slowest.back() > 2000) qInfo("event %d took %.0f ms: %s", n, slowest.back(), qPrintable(last_));
            QVERIFY2(on.window.isVisible(), qPrintable("the window is gone after: " + last_));
            const double now = megabytes();
            if (now > before + 50) qInfo("event %d: %.0f MB more, %.0f MB: %s", n, now - before, now, qPrintable(last_));
            before = now;
            if (n % std::max(1, events / 20) != 0) continue;
            memory.push_back(megabytes());
            if (events >= 8000) qInfo("event %d: %.0f MB", n, memory.back());
        }
        closer.stop();
        closeDialogs();
        if (on.viewer.live.scanner().connected()) on.viewer.live.scanner().disconnectScanner();
        emulated_.reset();
        // The window still works.
        for (QDialog* dialog : on.window.findChildren<QDialog*>()) dialog->close();
        QVERIFY2(eventually([&] { return !on.viewer.engine.working(); }),
                 on.viewer.engine.saving() ? "it saves for ever" : "it opens for ever");
        QVERIFY(on.open(scans_.front()));
        QVERIFY(!on.picture().detection->scan->rangeMm.cells.empty());
        std::ranges::sort(slowest);
        QString curve;
        for (const double mb : memory) curve += QString(" %1").arg(mb, 0, 'f', 0);
        qInfo("%d events; a step: median %.1f ms, 99 of 100 below %.1f ms; memory, MB:%s", events, slowest[slowest.size() / 2],
              slowest[slowest.size() * 99 / 100], qPrintable(curve));
        qInfo("used: %s", qPrintable(whatWasUsed()));
        if (events < 8000) return; // too few to separate growth from what is constructed once
        std::size_t all = 0, used = 0;
        for (const auto& [kind, met] : met_) {
            all += met.size();
            used += used_[kind].size();
        }
        QVERIFY2(10 * used >= 9 * all, qPrintable(whatWasUsed()));
#if !defined(__SANITIZE_ADDRESS__) // which holds freed memory back
        const double middle = memory[memory.size() / 2];
        QVERIFY2(memory.back() < 1.15 * middle + 20, qPrintable("memory grows:" + curve));
#endif
    }
};

int random_walk_test(int argc, char** argv) { return runWindowTest<RandomWalkTest>(argc, argv); }
#include "random_walk_test.moc"
