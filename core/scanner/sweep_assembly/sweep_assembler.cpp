// Sweep assembly.
#include "core/scanner/sweep_assembly/sweep_assembler.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace edgescan::scanner {
namespace {

constexpr std::size_t kFinishedKept = 4;
constexpr double kUsPerSecond = 1e6;
constexpr std::int64_t kLongAgo = 1'000'000; // lines lost by a longer gap are not counted

/// Counts of an encoder from one position to another, across its wrap.
std::int64_t countsBetween(std::uint32_t from, std::uint32_t to) { return static_cast<std::int32_t>(to - from); }

} // namespace

SweepAssembler::SweepAssembler(const SweepSettings& settings) : settings_(settings), counter_(settings.outputInterval) {}

void SweepAssembler::push(SweepLine line, std::int64_t hostNs) {
    ++ended_.telegrams;
    LineStamp stamp = counter_.stamp(line.count, hostNs);
    if (line.otherLayer) {
        changed_ = true;
        note(Irregularity::Misfit);
        return;
    }
    line.facts.hostNs = hostNs;
    if (stamp.step == LineStep::Duplicate && !isNew(line, hostNs, stamp)) return;
    repeats_ = 0;
    changed_ = true;
    device_ = line.device;
    const bool restarted = stamp.step == LineStep::Restart;
    const double deviceSeconds = static_cast<double>(stamp.deviceUs) / kUsPerSecond;
    std::int64_t lost = stamp.lost;
    if (restarted) {
        ++restarts_;
        if (last_) restartSeconds_ = last_->seconds + std::max(0.0, secondsBetween(last_->hostNs, hostNs)) - deviceSeconds;
        lost = lostInRestart(line);
    } else if (last_ && (stamp.clock == ClockStep::Jumped || stamp.clock == ClockStep::Stopped)) {
        const double lines = static_cast<double>((lost + 1) * std::max(1, settings_.outputInterval));
        restartSeconds_ = last_->seconds + lines * std::abs(line.facts.secondsPerTurn) - deviceSeconds;
    }
    if (restarted || stamp.clock == ClockStep::Jumped || stamp.clock == ClockStep::Stopped) clock_.restart();
    line.facts.seconds = deviceSeconds + restartSeconds_;
    clock_.line(stamp.transmittedUs, hostNs);
    line.facts.stampNs = clock_.hostNs(stamp.deviceUs);
    followEncoder(line, lost, restarted);
    stepper_.line(line.facts);
    last_ = line.facts;
    ended_.lost += lost;
    note(line, stamp);
    addLine(std::move(line), lost);
    splitAtReversal();
}

/// For a telegram whose counters and clock name a line that already arrived: decides whether it is a different line; if so, sets `stamp`. A
/// line that was missing is put into its place. A line that is already there is dropped.
bool SweepAssembler::isNew(SweepLine& line, std::int64_t hostNs, LineStamp& stamp) {
    constexpr int kFewBehind = 8;  // such a line is late or was sent twice, whatever it measured
    constexpr int kFewRepeats = 3; // number of such lines with other measurements
    constexpr int kManyRepeats = 64;
    constexpr double kHalf = 0.5;
    using enum GrowingSweep::Repeat;
    line.facts.seconds = static_cast<double>(stamp.deviceUs) / kUsPerSecond + restartSeconds_;
    line.facts.stampNs = clock_.hostNs(stamp.deviceUs);
    if (encoderAt_ && line.encoderPosition) line.facts.encoder = encoderCount_ + countsBetween(*encoderAt_, *line.encoderPosition);
    stepper_.line(line.facts);
    const bool comparable = sweep_ && !misfit_ && line.beams.beams > 0;
    const auto repeat = comparable ? sweep_->repeat(line, stamp.linesBehind - lostSince_) : Outside;
    ++repeats_;
    if (repeat == Filled) {
        repeats_ = 0;
        changed_ = true;
        note(Irregularity::Late);
        --ended_.lost; // it arrived after all
        return false;
    }
    const double later = last_ ? secondsBetween(last_->hostNs, hostNs) : 0.0;
    if (repeat == Other && stamp.linesBehind == 0 && (!counter_.moves() || later >= kHalf * line.facts.secondsPerTurn)) {
        stamp = counter_.next(line.count, hostNs);
        return true;
    }
    const bool odd = repeat == Other || repeat == Outside;
    const bool isNewLine = odd && stamp.linesBehind > kFewBehind;
    if (comparable && (isNewLine || (repeat == Other && repeats_ >= kFewRepeats) || repeats_ >= kManyRepeats)) {
        stamp = counter_.restart(line.count, hostNs);
        return true;
    }
    if (comparable && repeat == Outside && stamp.linesBehind > 0)
        note(Irregularity::TooLate);
    else
        note(Irregularity::Duplicate);
    return false;
}

/// `ahead`: number of telegrams behind the newest line of the sweep.
void SweepAssembler::note(Irregularity kind, std::int64_t times, std::int64_t ahead) {
    const std::int64_t line = sweep_ ? sweep_->newestRow() + ahead / sweep_->beams().parts : 0;
    irregular_.note(kind, static_cast<int>(std::clamp<std::int64_t>(line, 0, settings_.mostLines)), times);
    irregularEver_.note(kind, -1, times);
}

void SweepAssembler::note(const SweepLine& line, const LineStamp& stamp) {
    const auto here = [&](bool occurred, Irregularity kind) {
        if (occurred) note(kind, 1, stamp.lost + 1);
    };
    here(stamp.step == LineStep::Restart, Irregularity::Restart);
    here(stamp.counters == CounterStep::Jumped, Irregularity::CounterJump);
    here(stamp.counters == CounterStep::Reset, Irregularity::CounterReset);
    here(stamp.counters == CounterStep::Stopped, Irregularity::CountersStopped);
    here(stamp.clock == ClockStep::Jumped, Irregularity::ClockJump);
    here(stamp.clock == ClockStep::Stopped, Irregularity::ClockStopped);
    here(stamp.clock == ClockStep::Paused, Irregularity::Pause);
    irregular_.noteImplausible(stamp.implausible);
    irregularEver_.noteImplausible(stamp.implausible);
    here(sweep_ && line.beams.beams > 0 && line.echoes != echoes_, Irregularity::OtherEchoes);
    if (line.serialNumber == 0) return;
    here(serial_ != 0 && serial_ != line.serialNumber, Irregularity::OtherScanner);
    serial_ = line.serialNumber;
}

void SweepAssembler::push(const StepperReading& reading) {
    stepper_.reading(reading, sweep_ ? sweep_->facts() : std::span<LineTiming>{});
    changed_ = true;
    splitAtReversal();
}

/// Number of lines that a restarted scanner would have sent meanwhile, according to the host's clock.
std::int64_t SweepAssembler::lostInRestart(const SweepLine& line) const {
    if (!last_) return 0;
    const double period = line.facts.secondsPerTurn * std::max(1, settings_.outputInterval);
    const double lines = secondsBetween(last_->hostNs, line.facts.hostNs) / period;
    return std::isfinite(lines) && lines > 1.0 ? std::min(kLongAgo, static_cast<std::int64_t>(std::llround(lines)) - 1) : 0;
}

void SweepAssembler::followEncoder(SweepLine& line, std::int64_t lost, bool restarted) {
    if (!line.encoderPosition) return;
    const std::uint32_t position = *line.encoderPosition;
    if (!settings_.ticksPerDeg) {
        encoderWithoutScale_ = true;
        if (!encoderLeapsBack(position, lost, restarted)) return;
        finishSweep();
        startIsKnown_ = true;
        return;
    }
    if (!encoderAt_) {
        encoderCount_ = settings_.encoderZero ? countsBetween(*settings_.encoderZero, position) : 0;
    } else {
        std::int64_t moved = countsBetween(*encoderAt_, position);
        const double expected = settings_.degPerLine.value_or(0.0) * *settings_.ticksPerDeg * static_cast<double>(lost + 1);
        const double allowed = 2.0 * std::abs(expected) + 5.0 * std::abs(*settings_.ticksPerDeg);
        if (restarted && std::abs(static_cast<double>(moved) - expected) > allowed) {
            // The count was lost with the scanner's power: EdgeScan assumes that the stepper moved on as before.
            moved = std::llround(std::clamp(expected, -1e12, 1e12));
            encoderWasReset_ = true;
        }
        encoderCount_ += moved;
    }
    encoderAt_ = position;
    line.facts.encoder = encoderCount_;
}

/// True where the stepper was taken back to the start: the next line belongs to another sweep. Of an encoder whose scale is not known, only
/// its direction and the size of its usual step count. A turn in small steps is not a leap.
bool SweepAssembler::encoderLeapsBack(std::uint32_t position, std::int64_t lost, bool restarted) {
    constexpr std::int64_t kLeap = 8; // usual steps
    const auto from = std::exchange(encoderAt_, position);
    if (!from || restarted) return false;
    const std::int64_t moved = countsBetween(*from, position), usual = encoderStep_;
    if (usual != 0 && moved * usual < 0 && std::abs(moved) > kLeap * std::abs(usual) * (lost + 1)) return true;
    encoderStep_ = moved / (lost + 1);
    return false;
}

void SweepAssembler::addLine(SweepLine line, std::int64_t lost) {
    if (line.beams.beams == 0) {
        note(Irregularity::NoRanges);
        lostSince_ += lost + 1;
        return;
    }
    const std::int64_t between = lost;
    lost += lostSince_;
    if (sweep_ && lost > 0 && lost > std::min<std::int64_t>(settings_.longestGap, sweep_->mayBeLost())) {
        lostSince_ = 0;
        note(Irregularity::Gap, lost);
        finishSweep();
        startIsKnown_ = false;
    }
    lostSince_ = 0;
    if (!sweep_) return start(line);
    switch (sweep_->push(line, lost, settings_)) {
    case GrowingSweep::Place::Added:
        if (std::exchange(misfit_, std::nullopt)) note(Irregularity::Misfit);
        return;
    case GrowingSweep::Place::Full:
        if (std::exchange(misfit_, std::nullopt)) note(Irregularity::Misfit);
        if (settings_.expectedLines > 0) sweep_->markRestLost(settings_.expectedLines);
        finishSweep();
        return start(line);
    case GrowingSweep::Place::Misfit:
        break;
    }
    if (misfit_) return startAtMisfit(line, between);
    lostSince_ = lost + 1; // one line with other beams is a fault; two mean another scan mode
    misfit_ = std::move(line);
}

/// The second such line in a row: the sweep ends before the first of them.
void SweepAssembler::startAtMisfit(const SweepLine& line, std::int64_t between) {
    const SweepLine first = *std::exchange(misfit_, std::nullopt);
    finishSweep();
    start(first);
    if (between <= settings_.longestGap && sweep_->push(line, between, settings_) == GrowingSweep::Place::Added) return;
    finishSweep(); // the first line fits neither sweep: it becomes a sweep of its own
    start(line);
}

void SweepAssembler::start(const SweepLine& line) {
    sweep_.emplace();
    echoes_ = line.echoes;
    misfit_.reset();
    lostSince_ = 0;
    static_cast<void>(sweep_->push(line, 0, settings_));
}

void SweepAssembler::splitAtReversal() {
    while (sweep_) {
        const auto row = sweep_->reversal(settings_);
        if (!row) return;
        GrowingSweep next = sweep_->cutFrom(*row);
        const std::int64_t lostSince = std::exchange(lostSince_, 0);
        std::optional<SweepLine> misfit = std::exchange(misfit_, std::nullopt);
        finishSweep();
        lostSince_ = lostSince;
        misfit_ = std::move(misfit);
        sweep_ = std::move(next);
        startIsKnown_ = true;
        changed_ = true;
    }
}

void SweepAssembler::finishSweep() {
    if (!sweep_) return;
    if (std::exchange(misfit_, std::nullopt)) note(Irregularity::Misfit);
    sweep_->markNextLost(std::exchange(lostSince_, 0), settings_);
    sweep_->finish();
    changed_ = true;
    if (auto scan = snapshot()) {
        finished_.push_back({std::move(scan), progress()});
        finished_.back().progress.growing = false;
        if (finished_.size() > kFinishedKept) finished_.pop_front();
        ++number_;
    }
    axisBefore_ = axisFound_;
    finishedProgress_ = finished_.empty() ? SweepProgress{} : finished_.back().progress;
    ended_ = account();
    note(Irregularity::LeftOut, sweep_->leftOut());
    irregular_ = {};
    sweep_.reset();
}

/// The account of all sweeps, including the growing one.
TelegramAccount SweepAssembler::account() const {
    TelegramAccount all = ended_;
    const auto ever = [&](Irregularity kind) { return irregularEver_.count(kind); };
    all.duplicates = ever(Irregularity::Duplicate);
    all.unusable = ever(Irregularity::Misfit) + ever(Irregularity::NoRanges) + ever(Irregularity::TooLate) + ever(Irregularity::LeftOut) +
                   (misfit_ ? 1 : 0);
    if (!sweep_) return all;
    all.placed += sweep_->placed();
    all.unusable += sweep_->leftOut();
    const int rows = sweep_->wholeRows();
    if (rows == 0) return all;
    ++all.sweeps;
    all.lines += rows;
    for (int row = 0; row < rows; ++row) {
        all.linesLost += sweep_->isIncomplete(row) ? 1 : 0;
        all.cellsLost += sweep_->grid().lostIn(row);
    }
    all.cells += static_cast<std::int64_t>(rows) * sweep_->grid().beams();
    return all;
}

void SweepAssembler::finish() { finishSweep(); }

std::vector<FinishedSweep> SweepAssembler::popFinished() {
    std::vector<FinishedSweep> taken(std::make_move_iterator(finished_.begin()), std::make_move_iterator(finished_.end()));
    finished_.clear();
    return taken;
}

} // namespace edgescan::scanner
