// A moment on both clocks of this computer: for example when a telegram arrived.
#pragma once

#include <chrono>
#include <cstdint>

namespace edgescan::scanner {

struct HostTime {
    std::int64_t monotonicNs = 0; ///< never set back; only differences have a meaning
    std::int64_t utcNs = 0;       ///< since 1970-01-01 UTC; may jump when the clock is set

    bool operator==(const HostTime&) const = default;
};

[[nodiscard]] inline HostTime hostNow() {
    using std::chrono::duration_cast;
    using std::chrono::nanoseconds;
    return {duration_cast<nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            duration_cast<nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count()};
}

} // namespace edgescan::scanner
