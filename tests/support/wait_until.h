// Waits for a condition that does not send a signal.
#pragma once

#include <chrono>
#include <thread>

namespace edgescan::test {

/// Checks every few milliseconds. True as soon as `done` is true, false at the timeout.
template <class Condition>
[[nodiscard]] bool waitUntil(Condition done, std::chrono::milliseconds timeout = std::chrono::seconds(20)) {
    const auto end = std::chrono::steady_clock::now() + timeout;
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

} // namespace edgescan::test
