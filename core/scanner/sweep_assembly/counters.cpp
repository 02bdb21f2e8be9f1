// Unwraps the scanner's counters and clocks.
#include "core/scanner/sweep_assembly/counters.h"

#include "core/base/utc_time.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace edgescan::scanner {

namespace {

constexpr std::int64_t kCounterTurn = std::int64_t{1} << 16U;
constexpr std::int64_t kClockTurn = std::int64_t{1} << 32U;
constexpr std::int64_t kLate = 8;                ///< a line this far behind is late, whatever the clock shows
constexpr std::int64_t kOldest = 20000;          ///< an older line is not of this sequence
constexpr double kPauseUs = 1e6;                 ///< without a line that the counters account for
constexpr std::int64_t kHostSlackUs = 5'000'000; ///< allowed delay of the host

/// The value that equals `residue` modulo `turn` and is nearest to `expected`.
std::int64_t nearest(std::int64_t residue, std::int64_t turn, double expected) {
    return residue + turn * std::llround((expected - static_cast<double>(residue)) / static_cast<double>(turn));
}

/// The advance of a 16-bit counter while the clock shows an advance of `byClock`. More than one wrap is accepted only if it fits the clock
/// closely: a paused scanner does not count.
std::int64_t advanced(std::uint16_t now, std::uint16_t before, double byClock) {
    const std::int64_t residue = static_cast<std::uint16_t>(now - before);
    const std::int64_t lifted = nearest(residue, kCounterTurn, byClock);
    const bool fits = std::abs(static_cast<double>(lifted) - byClock) <= 3.0 + 0.02 * byClock;
    return lifted < kCounterTurn || fits ? lifted : residue;
}

/// A counter may run slower than the clock, never faster. Without a running clock only the direction is known.
bool plausible(std::int64_t count, double byClock) {
    if (count < 1) return false;
    return byClock == 0.0 ? count < kCounterTurn / 2 : static_cast<double>(count) <= 3.0 + 1.25 * byClock;
}

bool near(std::int64_t count, double byClock) { return std::abs(static_cast<double>(count) - byClock) <= 3.0 + 0.02 * std::abs(byClock); }

constexpr std::int64_t kWindowLines = 250; // 10 s at 25 Hz
constexpr std::int64_t kNsPerUs = 1000;

std::int64_t bounded(std::int64_t ns) { return std::clamp(ns, kEarliestNs, kLatestNs); }
std::int64_t nsOf(std::int64_t us) { return std::clamp(us, kEarliestNs / kNsPerUs, kLatestNs / kNsPerUs) * kNsPerUs; }

} // namespace

LineStamp LineCounter::stamp(const LineCount& count, std::int64_t hostNs) {
    if (!last_) return keep(count, hostNs, {});
    Advance advance = advanceTo(count, hostNs);
    LineStamp stamp = last_->stamp;
    stamp.step = judge(advance, count);
    stamp.lost = stamp.lostTelegrams = stamp.lostScans = stamp.implausible = stamp.linesBehind = 0;
    stamp.clock = ClockStep::Ran;
    stamp.counters = CounterStep::Ran;
    reconnected_ = false;
    if (stamp.step == LineStep::Restart) {
        ++stamp.epoch;
        return keep(count, hostNs, stamp);
    }
    stamp.telegram += advance.telegrams;
    stamp.scan += advance.scans;
    stamp.deviceUs += advance.us;
    if (stamp.step == LineStep::Next) {
        learnInterval(advance);
        follow(stamp, advance);
        moves_ = true;
    } else {
        stamp.linesBehind = advance.telegrams != 0 ? -advance.telegrams : -advance.scans / steps();
    }
    return keep(count, hostNs, stamp);
}

LineStamp LineCounter::restart(const LineCount& count, std::int64_t hostNs) {
    LineStamp stamp = last_ ? last_->stamp : LineStamp{};
    stamp = {LineStep::Restart, stamp.telegram, stamp.scan, stamp.deviceUs, stamp.transmittedUs, 0, 0, 0, 0, 0, {}, {}, stamp.epoch + 1};
    return keep(count, hostNs, stamp);
}

LineStamp LineCounter::next(const LineCount& count, std::int64_t hostNs) {
    LineStamp stamp = last_ ? last_->stamp : LineStamp{};
    stamp.step = LineStep::Next;
    stamp.lost = stamp.lostTelegrams = stamp.lostScans = stamp.implausible = stamp.linesBehind = 0;
    stamp.clock = ClockStep::Stopped;
    stamp.counters = CounterStep::Stopped;
    return keep(count, hostNs, stamp);
}

LineCounter::Advance LineCounter::advanceTo(const LineCount& count, std::int64_t hostNs) const {
    Advance advance;
    advance.hostUs = hostNs / 1000 - last_->hostNs / 1000;
    const std::uint32_t ahead = count.sinceStartUs - last_->count.sinceStartUs;
    advance.us = nearest(ahead, kClockTurn, static_cast<double>(advance.hostUs));
    advance.periodUs = count.periodS * 1e6;
    advance.scansByClock = static_cast<double>(advance.us) / advance.periodUs;
    advance.scansByHost = static_cast<double>(std::max<std::int64_t>(advance.hostUs, 0)) / advance.periodUs;
    advanceCounters(advance, count);
    return advance;
}

void LineCounter::advanceCounters(Advance& advance, const LineCount& count) const {
    advance.telegrams = advanced(count.telegrams, last_->count.telegrams, advance.scansByClock / static_cast<double>(steps()));
    advance.scans = advanced(count.scans, last_->count.scans, advance.scansByClock);
}

/// Whether either clock allows so many scans.
bool LineCounter::possible(const Advance& advance, std::int64_t scans) const {
    return plausible(scans, advance.scansByClock) || (advance.scansByHost > 0 && plausible(scans, advance.scansByHost));
}

/// Whether counters and clock all have values of some lines ago.
bool LineCounter::wasThere(const Advance& advance) const {
    if (reconnected_ || advance.us > 0 || advance.telegrams > 0 || advance.scans > 0) return false;
    const double latest = -2.0 * static_cast<double>(kLate * steps());
    if (advance.telegrams >= -kLate && advance.scansByClock >= latest) return true;
    const bool together = near(advance.telegrams * steps(), advance.scansByClock) && near(advance.scans, advance.scansByClock);
    return together && advance.telegrams >= -kOldest;
}

LineStep LineCounter::judge(Advance& advance, const LineCount& count) const {
    if (advance.telegrams == 0 && advance.scans == 0 && advance.us == 0) return LineStep::Duplicate;
    if (wasThere(advance)) return LineStep::Duplicate;
    // If the device clock ran ahead of the host's while the connection was lost, the clock was set.
    if (reconnected_ && advance.hostUs > 0 && advance.us > 2 * advance.hostUs + kHostSlackUs) return LineStep::Restart;
    if (advance.us < 0) {
        // Was the clock alone set back, or the counters too? After a restart of the scanner its counters start again, and its clock shows a
        // short time.
        const bool young = static_cast<double>(count.sinceStartUs) <= static_cast<double>(advance.hostUs) + kPauseUs;
        advance.clockJumped = true;
        advance.scansByClock = advance.scansByHost;
        advanceCounters(advance, count);
        const auto steady = [&](std::int64_t scans) { return scans >= 1 && scans <= 3 * steps(); };
        if (steady(advance.telegrams * steps()) && steady(advance.scans)) return LineStep::Next;
        const bool follows = possible(advance, advance.telegrams * steps()) || possible(advance, advance.scans);
        return follows && !young && !reconnected_ ? LineStep::Next : LineStep::Restart;
    }
    // With a new measurement one counter may start again while the other continues. Some devices do not count at all.
    const bool counts = advance.telegrams != 0 || advance.scans != 0;
    const bool follows = possible(advance, advance.telegrams * steps()) || possible(advance, advance.scans);
    // If the clock continued normally, the scanner was not switched off: the counters are wrong.
    const bool ranOn = !reconnected_ && advance.us > 0 && (advance.hostUs <= 0 || advance.us <= 2 * advance.hostUs + kHostSlackUs);
    return follows || !counts || ranOn ? LineStep::Next : LineStep::Restart;
}

/// The lines missing before a following line, and the irregularities of counters and clock.
void LineCounter::follow(LineStamp& stamp, const Advance& advance) const {
    const std::int64_t turn = steps();
    const bool byTelegrams = possible(advance, advance.telegrams * turn);
    const bool byScans = possible(advance, advance.scans);
    if (byTelegrams) stamp.lostTelegrams = advance.telegrams - 1;
    if (byScans) stamp.lostScans = std::max<std::int64_t>((advance.scans + turn / 2) / turn - 1, 0);
    stamp.lost = std::max(stamp.lostTelegrams, stamp.lostScans);
    const bool countersStopped = advance.telegrams == 0 && advance.scans == 0;
    // Only the clock is left, if the number of scans per telegram is known.
    if (!byTelegrams && !byScans && interval_ > 0 && !advance.clockJumped) {
        const double lines = advance.scansByClock / static_cast<double>(turn);
        if (lines > 1.5 && lines < 1e6 && 2.0 * advance.scansByHost >= advance.scansByClock) stamp.lost = std::llround(lines) - 1;
    }
    for (const auto& [known, moved, scans] :
         {std::tuple(byTelegrams, advance.telegrams, turn), std::tuple(byScans, advance.scans, std::int64_t{1})}) {
        if (known || moved == 0) continue;
        const bool back = static_cast<std::uint16_t>(moved) >= kCounterTurn / 2;
        if (stamp.counters != CounterStep::Jumped) stamp.counters = back ? CounterStep::Reset : CounterStep::Jumped;
        if (!back) stamp.implausible = std::max(stamp.implausible, moved * scans / turn - 1 - stamp.lost);
    }
    if (countersStopped) stamp.counters = CounterStep::Stopped;
    const double unaccounted = static_cast<double>(advance.us) - static_cast<double>((stamp.lost + 1) * turn) * advance.periodUs;
    if (advance.clockJumped)
        stamp.clock = ClockStep::Jumped;
    else if (advance.us == 0)
        stamp.clock = ClockStep::Stopped;
    else if (unaccounted > kPauseUs && !countersStopped)
        stamp.clock =
            advance.hostUs == 0 || 2.0 * static_cast<double>(advance.hostUs) >= unaccounted ? ClockStep::Paused : ClockStep::Jumped;
}

/// Learns the number of scans per telegram from two neighbouring lines; a smaller step seen later corrects it.
void LineCounter::learnInterval(const Advance& advance) {
    if (!learning_ || advance.clockJumped || advance.telegrams < 1 || advance.scans % advance.telegrams != 0 ||
        !plausible(advance.scans, advance.scansByClock))
        return;
    const std::int64_t interval = advance.scans / advance.telegrams;
    if (interval >= 1 && (interval_ == 0 || interval < interval_)) interval_ = interval;
}

LineStamp LineCounter::keep(const LineCount& count, std::int64_t hostNs, LineStamp stamp) {
    if (stamp.step == LineStep::First || stamp.step == LineStep::Restart) {
        stamp.telegram = count.telegrams;
        stamp.scan = count.scans;
        stamp.deviceUs = count.sinceStartUs;
    }
    stamp.transmittedUs = stamp.deviceUs + static_cast<std::int32_t>(count.transmittedUs - count.sinceStartUs);
    if (stamp.step == LineStep::Duplicate) return stamp;
    last_ = Last{count, hostNs, stamp};
    return stamp;
}

void DeviceClock::line(std::int64_t transmittedUs, std::int64_t hostNs) {
    const std::int64_t ns = bounded(hostNs) - nsOf(transmittedUs);
    while (!delays_.empty() && delays_.back().ns >= ns) delays_.pop_back();
    delays_.push_back({ns, lines_++});
    while (delays_.front().line + kWindowLines < lines_) delays_.pop_front();
}

std::int64_t DeviceClock::hostNs(std::int64_t deviceUs) const {
    const std::int64_t delay = delays_.empty() ? 0 : delays_.front().ns;
    std::int64_t ns = 0;
    if (__builtin_add_overflow(nsOf(deviceUs), delay, &ns)) return delay < 0 ? kEarliestNs : kLatestNs;
    return bounded(ns);
}

} // namespace edgescan::scanner
