// The order, counters and faults of an emulated scanner's telegrams.
#include "app/lab/emulator/sent_sweep.h"

#include <algorithm>
#include <cmath>

namespace edgescan::scanner {

namespace {

std::uint32_t frequencyOf(const ScanTelegram& telegram) { return telegram.scanFrequency > 0 ? telegram.scanFrequency : 2500; }

constexpr double kFastestHz = 100.0; // of an LMS511

/// 1/100 Hz: the scanner turns as often as it sends lines. At a rate that no scanner has, or as fast as the client reads, it is a replay at
/// the telegrams' own frequency.
std::uint32_t sentFrequency(const ScanTelegram& first, double linesPerSecond) {
    if (linesPerSecond <= 0.0 || linesPerSecond > kFastestHz) return frequencyOf(first);
    return static_cast<std::uint32_t>(std::max(1LL, std::llround(100.0 * linesPerSecond)));
}

} // namespace

EmulatedSweep::EmulatedSweep(std::shared_ptr<const std::vector<ScanTelegram>> telegrams, const EmulatedScannerSettings& settings)
    : contaminationWarning(settings.contaminationWarning), contaminationError(settings.contaminationError),
      telegrams_(std::move(telegrams)), frequency_(sentFrequency(telegrams_->front(), settings.linesPerSecond)),
      periodUs_(1e8 / frequency_), atEnd_(settings.atEnd), faults_(settings.faults), random_(settings.faults.seed) {}

bool EmulatedSweep::finished() const { return atEnd_ == AtEnd::Stop && inList_ >= telegrams_->size(); }

bool EmulatedSweep::happens(int every) {
    if (every <= 0) return false;
    if (faults_.byChance) return random_() % static_cast<unsigned>(every) == 0;
    return counted_ % static_cast<std::uint64_t>(every) == static_cast<std::uint64_t>(every) - 1;
}

std::size_t EmulatedSweep::listIndex() const {
    const std::uint64_t size = telegrams_->size();
    if (atEnd_ != AtEnd::Reverse || size < 2) return static_cast<std::size_t>(inList_ % size);
    const std::uint64_t turn = inList_ % (2 * size);
    return static_cast<std::size_t>(turn < size ? turn : 2 * size - 1 - turn);
}

/// A telegram of the list with the current counters, clocks and status. Gaps in the list appear as gaps in the first pass.
ScanTelegram EmulatedSweep::stamped() const {
    const ScanTelegram& first = telegrams_->front();
    ScanTelegram telegram = (*telegrams_)[listIndex()];
    // A line is sent after its last beam: a scanner that turns more slowly sends it later.
    const auto transmission = static_cast<std::uint32_t>(
        std::llround(static_cast<double>(telegram.transmittedUs - telegram.sinceStartUs) * frequencyOf(telegram) / frequency_));
    telegram.scanFrequency = frequency_;
    const std::uint64_t counted = counted_ * static_cast<std::uint64_t>(faults_.counterStep);
    telegram.telegramCounter = static_cast<std::uint16_t>(first.telegramCounter + counted);
    telegram.scanCounter = static_cast<std::uint16_t>(first.scanCounter + counted);
    const std::int64_t passedUs = std::llround(clockUs_ * faults_.clockRate);
    telegram.sinceStartUs = static_cast<std::uint32_t>(first.sinceStartUs + static_cast<std::uint64_t>(passedUs));
    telegram.transmittedUs = telegram.sinceStartUs + transmission;
    telegram.status[0] =
        static_cast<std::uint8_t>((telegram.status[0] & 1U) | (contaminationWarning ? 2U : 0U) | (contaminationError ? 4U : 0U));
    return telegram;
}

std::optional<SweepStep> EmulatedSweep::next() {
    if (finished()) return std::nullopt;
    SweepStep step;
    step.telegram = stamped();
    if (burstLeft_ > 0) {
        --burstLeft_;
        step.lost = true;
    } else if (happens(faults_.loseEvery)) {
        burstLeft_ = std::max(faults_.loseBurst, 1) - 1;
        step.lost = true;
    }
    step.duplicate = happens(faults_.duplicateEvery);
    step.garbage = happens(faults_.garbageEvery);
    step.corrupt = happens(faults_.corruptEvery);
    step.stall = happens(faults_.stallEvery);
    step.drop = happens(faults_.dropEvery);
    step.narrow = happens(faults_.narrowEvery);
    for (auto* channels : {&step.telegram.channels16, &step.telegram.channels8}) {
        for (ScanChannel& channel : *channels) {
            if (step.narrow) channel.values.resize((channel.values.size() + 1) / 2);
        }
    }
    ++counted_;
    ++inList_;
    clockUs_ += periodUs_;
    // Lines that the list leaves out were measured nevertheless.
    if (inList_ < telegrams_->size()) {
        const auto counted =
            static_cast<std::uint16_t>((*telegrams_)[inList_].telegramCounter - (*telegrams_)[inList_ - 1].telegramCounter);
        const int missing = std::clamp(counted - 1, 0, 60000);
        counted_ += static_cast<std::uint64_t>(missing);
        clockUs_ += missing * periodUs_;
    }
    return step;
}

Bytes EmulatedSweep::garbage() {
    Bytes bytes(1 + random_() % 30);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random_());
    return bytes;
}

Bytes EmulatedSweep::corrupted(Bytes bytes) {
    bytes[1 + random_() % (bytes.size() - 1)] ^= static_cast<std::uint8_t>(1U << (random_() % 8));
    return bytes;
}

std::size_t EmulatedSweep::pieceLength(std::size_t most) { return 1 + random_() % std::max<std::size_t>(most, 1); }

} // namespace edgescan::scanner
