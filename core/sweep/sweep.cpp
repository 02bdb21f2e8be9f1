// Sweep assembly.
#include "core/sweep/sweep.h"

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

constexpr std::size_t kFinishedKept = 4;
constexpr double kUsPerSecond = 1e6;
constexpr std::int64_t kLongAgo = 1'000'000; // lost lines that nobody counts any more

} // namespace

SweepAssembler::SweepAssembler(const SweepSettings& settings) : settings_(settings), counter_(settings.outputInterval) {}

void SweepAssembler::push(const ScanTelegram& telegram, std::int64_t hostNs) {
    const LineStamp stamp = counter_.stamp(telegram, hostNs);
    if (stamp.step == LineStep::Duplicate) {
        ++duplicates_;
        return;
    }
    changed_ = true;
    SweepLine line = sweepLine(telegram, settings_.echo);
    device_ = line.device;
    line.facts.hostNs = hostNs;
    const bool restarted = stamp.step == LineStep::Restart;
    const double deviceSeconds = static_cast<double>(stamp.deviceUs) / kUsPerSecond;
    std::int64_t lost = stamp.lost;
    if (restarted) {
        ++restarts_;
        clock_.restart();
        if (last_) restartSeconds_ = last_->seconds + std::max(0.0, secondsBetween(last_->hostNs, hostNs)) - deviceSeconds;
        lost = lostInRestart(line);
    }
    line.facts.seconds = deviceSeconds + restartSeconds_;
    clock_.line(stamp.transmittedUs, hostNs);
    line.facts.stampNs = clock_.hostNs(stamp.deviceUs);
    followEncoder(telegram, line.facts, lost, restarted);
    stepper_.line(line.facts);
    last_ = line.facts;
    take(std::move(line), lost);
    splitAtReversal();
}

void SweepAssembler::push(const StepperReading& reading) {
    stepper_.reading(reading, sweep_ ? sweep_->facts() : std::span<LineFacts>{});
    changed_ = true;
    splitAtReversal();
}

/// Lines that a scanner that started anew would have sent meanwhile, by the host's clock.
std::int64_t SweepAssembler::lostInRestart(const SweepLine& line) const {
    if (!last_) return 0;
    const double period = line.facts.secondsPerTurn * std::max(1, settings_.outputInterval);
    const double lines = secondsBetween(last_->hostNs, line.facts.hostNs) / period;
    return std::isfinite(lines) && lines > 1.0 ? std::min(kLongAgo, static_cast<std::int64_t>(std::llround(lines)) - 1) : 0;
}

void SweepAssembler::followEncoder(const ScanTelegram& telegram, LineFacts& facts, std::int64_t lost, bool restarted) {
    if (telegram.encoders.empty()) return;
    const std::uint32_t position = telegram.encoders.front().position;
    if (!settings_.ticksPerDeg) {
        encoderWithoutScale_ = true;
        return;
    }
    const auto differenceFrom = [&](std::uint32_t from) { return static_cast<std::int64_t>(static_cast<std::int32_t>(position - from)); };
    if (!encoderAt_) {
        encoderCount_ = settings_.encoderZero ? differenceFrom(*settings_.encoderZero) : 0;
    } else {
        std::int64_t moved = differenceFrom(*encoderAt_);
        const double expected = settings_.degPerLine.value_or(0.0) * *settings_.ticksPerDeg * static_cast<double>(lost + 1);
        const double allowed = 2.0 * std::abs(expected) + 5.0 * std::abs(*settings_.ticksPerDeg);
        if (restarted && std::abs(static_cast<double>(moved) - expected) > allowed) {
            // The count was lost with the scanner's power: the stepper is taken to have moved on as it did.
            moved = std::llround(std::clamp(expected, -1e12, 1e12));
            encoderWasReset_ = true;
        }
        encoderCount_ += moved;
    }
    encoderAt_ = position;
    facts.encoder = encoderCount_;
}

void SweepAssembler::take(SweepLine line, std::int64_t lost) {
    if (line.beams.beams == 0) {
        ++misfits_;
        lostSince_ += lost + 1;
        return;
    }
    const std::int64_t between = lost;
    lost += lostSince_;
    lostSince_ = 0;
    if (sweep_ && lost > settings_.longestGap) finishSweep();
    if (!sweep_) return start(line);
    switch (sweep_->push(line, lost, settings_)) {
    case GrowingSweep::Place::Taken:
        if (misfit_) ++misfits_;
        misfit_.reset();
        return;
    case GrowingSweep::Place::Full:
        if (misfit_) ++misfits_;
        if (settings_.expectedLines > 0) sweep_->loseRest(settings_.expectedLines);
        finishSweep();
        return start(line);
    case GrowingSweep::Place::Misfit:
        break;
    }
    if (!misfit_) { // one odd line is a fault; two are another way of scanning
        lostSince_ = lost + 1;
        misfit_ = std::move(line);
        return;
    }
    const SweepLine first = std::move(*misfit_);
    finishSweep();
    start(first);
    if (sweep_->push(line, between, settings_) == GrowingSweep::Place::Misfit) {
        ++misfits_;
        start(line);
    }
}

void SweepAssembler::start(const SweepLine& line) {
    sweep_.emplace();
    misfit_.reset();
    lostSince_ = 0;
    static_cast<void>(sweep_->push(line, 0, settings_));
}

void SweepAssembler::splitAtReversal() {
    while (sweep_) {
        const auto row = sweep_->reversal(settings_);
        if (!row) return;
        GrowingSweep next = sweep_->cutFrom(*row);
        const std::int64_t lostSince = lostSince_;
        finishSweep();
        lostSince_ = lostSince;
        sweep_ = std::move(next);
        changed_ = true;
    }
}

void SweepAssembler::finishSweep() {
    if (!sweep_) return;
    sweep_->finish();
    changed_ = true;
    if (auto scan = snapshot()) {
        finished_.push_back({std::move(scan), progress()});
        finished_.back().progress.growing = false;
        if (finished_.size() > kFinishedKept) finished_.pop_front();
        ++number_;
    }
    finishedProgress_ = finished_.empty() ? SweepProgress{} : finished_.back().progress;
    sweep_.reset();
    misfit_.reset();
    lostSince_ = 0;
}

void SweepAssembler::finish() { finishSweep(); }

std::vector<FinishedSweep> SweepAssembler::takeFinished() {
    std::vector<FinishedSweep> taken(std::make_move_iterator(finished_.begin()), std::make_move_iterator(finished_.end()));
    finished_.clear();
    return taken;
}

} // namespace edgescan
