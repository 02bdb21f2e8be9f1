// Unwraps the scanner's counters and clocks, and finds for each line what was lost before it or came twice (docs/developer/protocol.md,
// "Counters and clocks").
#pragma once

#include "core/scanner/scan_line/scan_line.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace edgescan::scanner {

enum class LineStep : std::uint8_t {
    First,     ///< the first line of all
    Next,      ///< follows the line before it, after `lost` lost lines
    Duplicate, ///< according to counters and clock it arrived already, `behind` lines ago; its measurements decide whether it really did
    Restart,   ///< the scanner's counters started again (power, another device); lines missing before it cannot be counted
};

/// The device clock's advance since the line before.
enum class ClockStep : std::uint8_t {
    Ran,
    Paused, ///< advanced by over a second more than the counters account for
    Stopped,
    Jumped, ///< went back, or far ahead of the host's clock, while the counters continued
};

/// Irregularities of the counters.
enum class CounterStep : std::uint8_t {
    Ran,
    Jumped,  ///< one of them advanced further than a clock allows
    Reset,   ///< one of them went back
    Stopped, ///< neither advanced
};

/// A line's position in the scanner's history.
struct LineStamp {
    LineStep step = LineStep::First;
    std::int64_t telegram = 0;      ///< telegram counter, unwrapped: the first value as sent, then without wrapping
    std::int64_t scan = 0;          ///< scan counter, unwrapped
    std::int64_t deviceUs = 0;      ///< device clock of the line, unwrapped, microseconds
    std::int64_t transmittedUs = 0; ///< device clock of the transmission, on the same scale
    std::int64_t lost = 0;          ///< lines missing before this one: the larger of the next two
    std::int64_t lostTelegrams = 0; ///< by the telegram counter
    std::int64_t lostScans = 0;     ///< by the scan counter, divided by the output interval
    std::int64_t implausible = 0;   ///< lines that a counter claims but the clocks do not allow; not in `lost`
    std::int64_t linesBehind = 0;   ///< of a Duplicate: number of lines before the newest
    ClockStep clock = ClockStep::Ran;
    CounterStep counters = CounterStep::Ran;
    int epoch = 0; ///< grows by one with every Restart

    bool operator==(const LineStamp&) const = default;
};

/// Receives every line of one scanner in order of arrival; a value type. If a counter alone leaves open whether it ran far ahead or was set
/// back, the device clock decides. The host clock shows how often the device clock itself wrapped (every 71.6 minutes).
class LineCounter {
public:
    /// `outputInterval`: number of scans per telegram (LMDscandatacfg); 0: learn it.
    explicit LineCounter(int outputInterval = 0) : interval_(outputInterval), learning_(outputInterval <= 0) {}

    /// `hostNs`: monotonic host time of the line. Only differences are used; always 0 is allowed if silences are shorter than an hour. A
    /// Duplicate gets the stamp of the line that it repeats, and changes nothing.
    LineStamp stamp(const LineCount& count, std::int64_t hostNs);

    /// The same for a line that stamp() took for a Duplicate, but which is a different line under an old number: a Restart.
    LineStamp restart(const LineCount& count, std::int64_t hostNs);
    /// The same for a line with the newest line's stamp but other measurements: it follows the newest line, and the counters are ignored.
    LineStamp next(const LineCount& count, std::int64_t hostNs);

    /// Whether any counter or clock of this scanner has advanced.
    [[nodiscard]] bool moves() const { return moves_; }

    /// The connection was made again: counters that go back now mean a Restart, not a late duplicate.
    void reconnected() { reconnected_ = true; }

private:
    struct Last {
        LineCount count;
        std::int64_t hostNs = 0;
        LineStamp stamp;
    };
    struct Advance {
        std::int64_t us = 0, hostUs = 0, telegrams = 0, scans = 0;
        double scansByClock = 0.0; ///< by the device clock, or by the host's if the device clock is not plausible
        double scansByHost = 0.0;
        double periodUs = 0.0;
        bool clockJumped = false;
    };

    [[nodiscard]] std::int64_t steps() const { return interval_ > 0 ? interval_ : 1; }
    [[nodiscard]] Advance advanceTo(const LineCount& count, std::int64_t hostNs) const;
    void advanceCounters(Advance& advance, const LineCount& count) const;
    [[nodiscard]] bool possible(const Advance& advance, std::int64_t scans) const;
    [[nodiscard]] LineStep judge(Advance& advance, const LineCount& count) const;
    [[nodiscard]] bool wasThere(const Advance& advance) const;
    void follow(LineStamp& stamp, const Advance& advance) const;
    void learnInterval(const Advance& advance);
    LineStamp keep(const LineCount& count, std::int64_t hostNs, LineStamp stamp);

    std::int64_t interval_; ///< scans per telegram, 0: unknown
    bool learning_;
    bool reconnected_ = false;
    bool moves_ = false;
    std::optional<Last> last_;
};

/// Converts times of the device's clock to host times (docs/developer/protocol.md, "Time of a beam"). A telegram cannot be received before
/// it was sent. So over many lines the shortest delay is the delay of the wire, and the rest is jitter of the host. Only the last lines
/// count, so that drift between the clocks (tens of ppm) is followed.
class DeviceClock {
public:
    /// `transmittedUs`: the unwrapped device time of transmission of a line that was received at `hostNs`.
    void line(std::int64_t transmittedUs, std::int64_t hostNs);
    /// Host time of a device time; the device time itself before the first line.
    [[nodiscard]] std::int64_t hostNs(std::int64_t deviceUs) const;
    /// The device restarted.
    void restart() { delays_.clear(); }

private:
    struct Delay {
        std::int64_t ns = 0; // host minus device
        std::int64_t line = 0;
    };
    std::deque<Delay> delays_; // increasing; the first one is the shortest of the last lines
    std::int64_t lines_ = 0;
};

} // namespace edgescan::scanner
