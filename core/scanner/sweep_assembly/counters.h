// Makes the scanner's wrapping counters and clocks run on, and says per line what was lost or came twice.
// (docs/protocol.md, "Counters and clocks".)
#pragma once

#include "core/scanner/sick_lms/scan_telegram.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace edgescan {

enum class LineStep : std::uint8_t {
    First,     ///< nothing came before
    Next,      ///< follows the line before it, after `lost` lost ones
    Duplicate, ///< by counters and clock it was there already, `behind` lines ago; whether it really was, what it measured tells
    Restart,   ///< the scanner's counters began anew (power, another device); what is missing in between cannot be counted
};

/// What the device clock did since the line before.
enum class ClockStep : std::uint8_t {
    Ran,
    Paused, ///< ran on for more than a second longer than the counters account for
    Stood,
    Jumped, ///< went back, or far ahead of the host's clock, while the counters ran on
};

/// What the counters did beside counting.
enum class CounterStep : std::uint8_t {
    Ran,
    Jumped, ///< one of them ran further than a clock allows
    Reset,  ///< one of them went back
    Stood,  ///< neither moved
};

/// A line's place in the scanner's history.
struct LineStamp {
    LineStep step = LineStep::First;
    std::int64_t telegram = 0;      ///< telegram counter, unwrapped: first value as sent, then without wrapping
    std::int64_t scan = 0;          ///< scan counter, unwrapped
    std::int64_t deviceUs = 0;      ///< device clock of the line, unwrapped, microseconds
    std::int64_t transmittedUs = 0; ///< device clock of the transmission, on the same scale
    std::int64_t lost = 0;          ///< lines missing before this one: the greater of the next two
    std::int64_t lostTelegrams = 0; ///< by the telegram counter
    std::int64_t lostScans = 0;     ///< by the scan counter, after the output interval is taken out
    std::int64_t claimed = 0;       ///< lines that a counter named and no clock allows; not in `lost`
    std::int64_t behind = 0;        ///< of a Duplicate: lines before the newest
    ClockStep clock = ClockStep::Ran;
    CounterStep counters = CounterStep::Ran;
    int epoch = 0; ///< grows by one with every Restart

    bool operator==(const LineStamp&) const = default;
};

/// Give it every line of one scanner in order of arrival; a value. The device clock is the referee where a counter alone leaves open
/// whether it ran far ahead or was set back; the host clock tells how often the device clock itself wrapped (every 71.6 minutes).
class LineCounter {
public:
    /// `outputInterval`: every how many scans a telegram is sent (LMDscandatacfg); 0: learn it.
    explicit LineCounter(int outputInterval = 0) : interval_(outputInterval), learning_(outputInterval <= 0) {}

    /// `hostNs`: monotonic host time of the line; only differences are used, and 0 throughout is fine when no silence of an hour is
    /// to be bridged. A Duplicate is stamped as the line it repeats and changes nothing.
    LineStamp stamp(const ScanTelegram& telegram, std::int64_t hostNs);

    /// The same for a line that stamp() took for a Duplicate and that is another line under an old number: a Restart.
    LineStamp restart(const ScanTelegram& telegram, std::int64_t hostNs);
    /// The same for a line that measured something else than the newest under the newest one's stamp: it follows, and nothing counts.
    LineStamp next(const ScanTelegram& telegram, std::int64_t hostNs);

    /// Some counter or clock of this scanner has moved.
    [[nodiscard]] bool moves() const { return moves_; }

    /// The connection was made anew: counters that are set back now are a Restart, never a late duplicate.
    void reconnected() { reconnected_ = true; }

private:
    struct Last {
        std::uint16_t telegramCounter = 0, scanCounter = 0;
        std::uint32_t sinceStartUs = 0;
        std::int64_t hostNs = 0;
        LineStamp stamp;
    };
    struct Advance {
        std::int64_t us = 0, hostUs = 0, telegrams = 0, scans = 0;
        double scansByClock = 0.0; ///< by the device clock, or by the host's where that one is not to be believed
        double scansByHost = 0.0;
        double periodUs = 0.0;
        bool clockJumped = false;
    };

    [[nodiscard]] std::int64_t steps() const { return interval_ > 0 ? interval_ : 1; }
    [[nodiscard]] Advance advanceTo(const ScanTelegram& telegram, std::int64_t hostNs) const;
    void count(Advance& advance, const ScanTelegram& telegram) const;
    [[nodiscard]] bool possible(const Advance& advance, std::int64_t scans) const;
    [[nodiscard]] LineStep judge(Advance& advance, const ScanTelegram& telegram) const;
    [[nodiscard]] bool wasThere(const Advance& advance) const;
    void follow(LineStamp& stamp, const Advance& advance) const;
    void learnInterval(const Advance& advance);
    LineStamp keep(const ScanTelegram& telegram, std::int64_t hostNs, LineStamp stamp);

    std::int64_t interval_; ///< scans per telegram, 0 while unknown
    bool learning_;
    bool reconnected_ = false;
    bool moves_ = false;
    std::optional<Last> last_;
};

/// When something happened by the host's clock, from the device's own clock (docs/protocol.md, "Time of a beam").
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
