// Waits for a condition that does not send a signal.
#pragma once

#include <chrono>
#include <thread>

namespace edgescan::test {

/// No test passes or fails by the time that something takes: this only ends a test that waits for what never comes.
constexpr std::chrono::seconds kPatience{120};

/// Looks every few milliseconds. True as soon as `done` is, false if it never is.
template <class Condition>
[[nodiscard]] bool waitUntil(Condition done) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

} // namespace edgescan::test
