// A walk of random events over the real window: every action, slider, list, key and view, in whatever order. Nothing may crash, hang or
// leak. EDGESCAN_WALK: how many events (10000 for a long one), EDGESCAN_WALK_SEED: another walk.
#include "tests/support/scans.h"
#include "tests/ui/window_fixture.h"

#include <QAbstractSlider>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>

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
    static double megabytes() {
        std::ifstream file("/proc/self/statm");
        std::size_t all = 0, resident = 0;
        file >> all >> resident;
        return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
    }
    // What would end the walk, leave the machine or take long for its own good reasons.
    static bool isLeftOut(const QAction& action) {
        const QString text = QString(action.text()).remove('&');
        static const QStringList left{"Quit", "Open Demo", "Connect", "Record", "Keep Last Minute", "Full Screen"};
        const bool named = std::any_of(left.begin(), left.end(), [&](const QString& one) { return text.startsWith(one); });
        return named || text.isEmpty() || action.menu() != nullptr || action.isSeparator() || !action.isEnabled();
    }
    static void closeDialogs() {
        while (QWidget* popup = QApplication::activePopupWidget()) {
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
        LinkedViews& views = on.window.views();
        const std::array<QWidget*, 3> all{&views.gray(), &views.edges(), &views.cloud()};
        return *all[below(3)];
    }

    void trigger(WindowFixture& on) {
        QList<QAction*> actions;
        for (QAction* action : on.window.findChildren<QAction*>()) {
            if (!isLeftOut(*action)) actions << action;
        }
        if (QAction* action = anyOf(actions)) {
            last_ = "action " + action->text();
            action->trigger();
        }
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
        const auto seen = [](const QWidget* widget) { return widget->isVisible() && widget->isEnabled(); };
        if (auto* slider = anyOf(on.window.findChildren<QAbstractSlider*>()); below(3) == 0 && slider != nullptr && seen(slider)) {
            last_ = "slider " + slider->objectName();
            slider->setValue(slider->minimum() +
                             static_cast<int>(below(static_cast<std::size_t>(slider->maximum() - slider->minimum()) + 1)));
        } else if (auto* list = anyOf(on.window.findChildren<QComboBox*>()); below(2) == 0 && list != nullptr && seen(list)) {
            last_ = "list " + list->objectName();
            if (list->count() > 0) list->setCurrentIndex(static_cast<int>(below(static_cast<std::size_t>(list->count()))));
        } else if (auto* box = anyOf(on.window.findChildren<QCheckBox*>()); box != nullptr && seen(box)) {
            last_ = "switch " + box->text();
            box->click();
        }
    }
    void step(WindowFixture& on) {
        const std::size_t what = below(100);
        if (what < 30)
            trigger(on);
        else if (what < 60)
            useMouse(on);
        else if (what < 80)
            useKey(on);
        else if (what < 96)
            useWidget(on);
        else {
            last_ = "open";
            on.window.files().open({QString::fromStdString(scans_[below(scans_.size())])});
        }
        closeDialogs();
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    }

    QString last_;

private slots:
    void initTestCase() {
        SimulationSettings settings;
        settings.lines = 90;
        settings.beams = 120;
        for (const bool after : {false, true}) {
            settings.afterBlast = after;
            scans_.push_back((folder_ / (after ? "after.json" : "before.json")).string());
            QVERIFY(bool(saveScan(simulate(settings)->scan, scans_.back())));
        }
        scans_.push_back((folder_ / "boxes.json").string());
        QVERIFY(bool(saveScan(test::boxesScan(60, 80, 3, 0.02), scans_.back())));
        std::ofstream(folder_ / "broken.json") << "{";
        scans_.push_back((folder_ / "broken.json").string());
    }

    void nothingFallsOver() {
        const int asked = qEnvironmentVariableIntValue("EDGESCAN_WALK");
        const int events = asked > 0 ? asked : 400;
        dice_.seed(static_cast<unsigned>(std::max(1, qEnvironmentVariableIntValue("EDGESCAN_WALK_SEED"))));
        QApplication::setQuitOnLastWindowClosed(false);
        WindowFixture on;
        on.window.resize(1280, 800);
        QVERIFY(on.showWith(scans_.front()) && on.activate());
        // Menus and dialogs run loops of their own: closed from within.
        QTimer closer;
        QObject::connect(&closer, &QTimer::timeout, this, [] { closeDialogs(); });
        closer.start(30);
        std::vector<double> memory, slowest;
        for (int n = 0; n < events; ++n) {
            QElapsedTimer timer;
            timer.start();
            step(on);
            slowest.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
            QVERIFY2(on.window.isVisible(), qPrintable("the window is gone after: " + last_));
            if (n % std::max(1, events / 20) == 0) memory.push_back(megabytes());
        }
        closer.stop();
        closeDialogs();
        // It still does what it is told.
        for (QDialog* dialog : on.window.findChildren<QDialog*>()) dialog->close();
        QVERIFY(QTest::qWaitFor([&] { return !on.window.session().working(); }, 30000));
        QVERIFY(on.open(scans_.front()));
        QVERIFY(!on.picture().detection->scan->rangeMm.cells.empty());
        std::ranges::sort(slowest);
        QString curve;
        for (const double mb : memory) curve += QString(" %1").arg(mb, 0, 'f', 0);
        qInfo("%d events; a step: median %.1f ms, 99 of 100 below %.1f ms; memory, MB:%s", events, slowest[slowest.size() / 2],
              slowest[slowest.size() * 99 / 100], qPrintable(curve));
        if (events < 4000) return; // too few to tell growth from what is built once
        const double middle = memory[memory.size() / 2];
        QVERIFY2(memory.back() < 1.15 * middle + 20, qPrintable("memory grows:" + curve));
    }
};

int main(int argc, char** argv) { return runWindowTest<RandomWalkTest>(argc, argv); }
#include "random_walk_test.moc"
