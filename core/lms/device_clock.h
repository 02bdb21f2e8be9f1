// When something happened by the host's clock, from the device's own clock (docs/protocol.md, "Time of a beam").
#pragma once

#include <cstdint>
#include <deque>

namespace edgescan {

/// A telegram is never received before it was sent: over many lines the shortest delay seen is the delay of the wire, and the rest is
/// jitter of the host. Drift between the clocks (tens of ppm) is followed because only the last lines count.
class DeviceClock {
public:
    /// `transmittedUs`: the unwrapped device time of transmission of a line that was received at `hostNs`.
    void line(std::int64_t transmittedUs, std::int64_t hostNs);
    /// Host time of a device time; nothing but the device time when no line came yet.
    [[nodiscard]] std::int64_t hostNs(std::int64_t deviceUs) const;
    /// The device started anew.
    void restart() { delays_.clear(); }

private:
    struct Delay {
        std::int64_t ns = 0; // host minus device
        std::int64_t line = 0;
    };
    std::deque<Delay> delays_; // rising; the first is the shortest of the last lines
    std::int64_t lines_ = 0;
};

} // namespace edgescan
