// How a test of the window waits for a condition.
#pragma once

#include <QTimer>
#include <QtTest>

#include <functional>
#include <utility>

namespace edgescan::ui {

/// No test passes or fails by the time that something takes: this only ends a test that waits for what never comes.
inline const int kPatienceMs =
    qEnvironmentVariableIsSet("EDGESCAN_PATIENCE_MS") ? qEnvironmentVariableIntValue("EDGESCAN_PATIENCE_MS") : 120000;

/// The window works until `done` holds; false if it never does.
template <class Condition>
[[nodiscard]] bool eventually(Condition done) {
    return QTest::qWaitFor(done, kPatienceMs);
}

/// For what runs an event loop of its own, a menu or a modal dialog: tries `act` again and again until it returns true.
class Meanwhile {
public:
    explicit Meanwhile(std::function<bool()> act) : act_(std::move(act)) {
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] {
            if (std::exchange(acting_, true)) return; // from a loop inside of it
            if (act_()) timer_.stop();
            acting_ = false;
        });
        timer_.start(10);
    }
    [[nodiscard]] bool done() const { return !timer_.isActive(); }

private:
    std::function<bool()> act_;
    bool acting_ = false;
    QTimer timer_;
};

} // namespace edgescan::ui

// Qt's own give up after five seconds, which a busy machine needs now and then.
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(holds) QTRY_VERIFY_WITH_TIMEOUT((holds), edgescan::ui::kPatienceMs)
#define QTRY_VERIFY2(holds, words) QTRY_VERIFY2_WITH_TIMEOUT((holds), (words), edgescan::ui::kPatienceMs)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT((actual), (expected), edgescan::ui::kPatienceMs)
