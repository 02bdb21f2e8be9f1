// Makes the scanner's wrapping counters and clocks run on.
#include "core/sweep/counters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace edgescan {

namespace {

constexpr std::int64_t kCounterTurn = std::int64_t{1} << 16U;
constexpr std::int64_t kClockTurn = std::int64_t{1} << 32U;
constexpr std::int64_t kLateDuplicates = 8; ///< a line repeated later than this many lines behind is a restart
constexpr double kUsualPeriodUs = 40000.0;

/// The value that is `residue` modulo `turn` and nearest to `expected`.
std::int64_t nearest(std::int64_t residue, std::int64_t turn, double expected) {
    return residue + turn * std::llround((expected - static_cast<double>(residue)) / static_cast<double>(turn));
}

/// How far a 16-bit counter went while the clock says `byClock`. More than one turn is believed only when it fits the clock closely:
/// a scanner that was paused does not count.
std::int64_t counted(std::uint16_t now, std::uint16_t before, double byClock) {
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

double periodUs(const ScanTelegram& telegram) { return telegram.scanFrequency > 0 ? 1e8 / telegram.scanFrequency : kUsualPeriodUs; }

constexpr std::int64_t kWindowLines = 250; // 10 s at 25 Hz
constexpr std::int64_t kNsPerUs = 1000;
constexpr std::int64_t kLatestNs = std::int64_t{1} << 61; // 73 years; beyond, differences would overflow

std::int64_t bounded(std::int64_t ns) { return std::clamp(ns, -kLatestNs, kLatestNs); }
std::int64_t nsOf(std::int64_t us) { return bounded(std::clamp(us, -kLatestNs / kNsPerUs, kLatestNs / kNsPerUs) * kNsPerUs); }

} // namespace

LineStamp LineCounter::stamp(const ScanTelegram& telegram, std::int64_t hostNs) {
    if (!last_) return keep(telegram, hostNs, {});
    const Advance advance = advanceTo(telegram, hostNs);
    LineStamp stamp = last_->stamp;
    stamp.step = judge(advance);
    stamp.lost = stamp.lostTelegrams = stamp.lostScans = 0;
    reconnected_ = false;
    if (stamp.step == LineStep::Restart) {
        ++stamp.epoch;
        return keep(telegram, hostNs, stamp);
    }
    stamp.telegram += advance.telegrams;
    stamp.scan += advance.scans;
    stamp.deviceUs += advance.us;
    if (stamp.step == LineStep::Next) {
        learnInterval(advance);
        if (plausible(advance.telegrams * steps(), advance.scansByClock)) stamp.lostTelegrams = advance.telegrams - 1;
        if (plausible(advance.scans, advance.scansByClock))
            stamp.lostScans = std::max<std::int64_t>((advance.scans + steps() / 2) / steps() - 1, 0);
        stamp.lost = std::max(stamp.lostTelegrams, stamp.lostScans);
    }
    return keep(telegram, hostNs, stamp);
}

LineCounter::Advance LineCounter::advanceTo(const ScanTelegram& telegram, std::int64_t hostNs) const {
    Advance advance;
    advance.hostUs = (hostNs - last_->hostNs) / 1000;
    const std::uint32_t ahead = telegram.sinceStartUs - last_->sinceStartUs;
    advance.us = nearest(ahead, kClockTurn, static_cast<double>(advance.hostUs));
    advance.scansByClock = static_cast<double>(advance.us) / periodUs(telegram);
    advance.telegrams = counted(telegram.telegramCounter, last_->telegramCounter, advance.scansByClock / static_cast<double>(steps()));
    advance.scans = counted(telegram.scanCounter, last_->scanCounter, advance.scansByClock);
    return advance;
}

LineStep LineCounter::judge(const Advance& advance) const {
    if (advance.telegrams == 0 && advance.scans == 0 && advance.us == 0) return LineStep::Duplicate;
    const bool behind = advance.us <= 0 && advance.telegrams <= 0 && advance.scans <= 0;
    const auto late = static_cast<double>(kLateDuplicates);
    if (behind && !reconnected_ && advance.telegrams >= -kLateDuplicates &&
        advance.scansByClock >= -2.0 * late * static_cast<double>(steps()))
        return LineStep::Duplicate;
    if (advance.us < 0) return LineStep::Restart;
    // A clock that ran ahead of ours while nobody listened was set, not waited for.
    if (reconnected_ && advance.hostUs > 0 && advance.us > 2 * advance.hostUs + 5'000'000) return LineStep::Restart;
    // One counter may begin anew with a measurement while the other runs on, and some devices do not count at all.
    const bool counts = advance.telegrams != 0 || advance.scans != 0;
    const bool follows = plausible(advance.telegrams * steps(), advance.scansByClock) || plausible(advance.scans, advance.scansByClock);
    return follows || !counts ? LineStep::Next : LineStep::Restart;
}

/// Every how many scans a telegram is sent shows in two neighbours; a smaller step seen later corrects it.
void LineCounter::learnInterval(const Advance& advance) {
    if (!learning_ || advance.telegrams < 1 || advance.scans % advance.telegrams != 0 || !plausible(advance.scans, advance.scansByClock))
        return;
    const std::int64_t interval = advance.scans / advance.telegrams;
    if (interval >= 1 && (interval_ == 0 || interval < interval_)) interval_ = interval;
}

LineStamp LineCounter::keep(const ScanTelegram& telegram, std::int64_t hostNs, LineStamp stamp) {
    if (stamp.step == LineStep::First || stamp.step == LineStep::Restart) {
        stamp.telegram = telegram.telegramCounter;
        stamp.scan = telegram.scanCounter;
        stamp.deviceUs = telegram.sinceStartUs;
    }
    stamp.transmittedUs = stamp.deviceUs + static_cast<std::int32_t>(telegram.transmittedUs - telegram.sinceStartUs);
    if (stamp.step == LineStep::Duplicate) return stamp;
    last_ = Last{telegram.telegramCounter, telegram.scanCounter, telegram.sinceStartUs, hostNs, stamp};
    return stamp;
}

void DeviceClock::line(std::int64_t transmittedUs, std::int64_t hostNs) {
    const std::int64_t ns = bounded(hostNs) - nsOf(transmittedUs);
    while (!delays_.empty() && delays_.back().ns >= ns) delays_.pop_back();
    delays_.push_back({ns, lines_++});
    while (delays_.front().line + kWindowLines < lines_) delays_.pop_front();
}

std::int64_t DeviceClock::hostNs(std::int64_t deviceUs) const { return nsOf(deviceUs) + (delays_.empty() ? 0 : delays_.front().ns); }

} // namespace edgescan
