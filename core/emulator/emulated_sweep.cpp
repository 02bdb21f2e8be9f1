// The order, counters and mishaps of an emulated scanner's telegrams.
#include "core/emulator/emulated_sweep.h"

#include "core/emulator/emulated_telegram.h"

#include <algorithm>
#include <cmath>

namespace edgescan::sim {

EmulatedSweep::EmulatedSweep(std::shared_ptr<const std::vector<ScanTelegram>> telegrams, const EmulatedScannerSettings& settings)
    : contaminationWarning(settings.contaminationWarning), contaminationError(settings.contaminationError),
      telegrams_(std::move(telegrams)), atEnd_(settings.atEnd), faults_(settings.faults), random_(settings.faults.seed) {}

bool EmulatedSweep::finished() const { return atEnd_ == AtEnd::Stop && inList_ >= telegrams_->size(); }

bool EmulatedSweep::happens(int every) {
    if (every <= 0) return false;
    if (faults_.byChance) return random_() % static_cast<unsigned>(every) == 0;
    return told_ % static_cast<std::uint64_t>(every) == static_cast<std::uint64_t>(every) - 1;
}

std::size_t EmulatedSweep::listIndex() const {
    const std::uint64_t size = telegrams_->size();
    if (atEnd_ != AtEnd::Reverse || size < 2) return static_cast<std::size_t>(inList_ % size);
    const std::uint64_t turn = inList_ % (2 * size);
    return static_cast<std::size_t>(turn < size ? turn : 2 * size - 1 - turn);
}

/// A telegram of the list with counters, clocks and status of now. A list with gaps keeps them in the first pass.
ScanTelegram EmulatedSweep::stamped(const EmulatedDevice& device) const {
    const ScanTelegram& first = telegrams_->front();
    ScanTelegram telegram = (*telegrams_)[listIndex()];
    const std::uint32_t transmission = telegram.transmittedUs - telegram.sinceStartUs;
    telegram.telegramCounter = static_cast<std::uint16_t>(first.telegramCounter + told_);
    telegram.scanCounter = static_cast<std::uint16_t>(first.scanCounter + scans_);
    telegram.sinceStartUs = static_cast<std::uint32_t>(first.sinceStartUs + static_cast<std::uint64_t>(std::llround(clockUs_)));
    telegram.transmittedUs = telegram.sinceStartUs + transmission;
    telegram.scanFrequency = device.scan.frequency;
    telegram.status[0] =
        static_cast<std::uint8_t>((telegram.status[0] & 1U) | (contaminationWarning ? 2U : 0U) | (contaminationError ? 4U : 0U));
    if (device.content.time) {
        const auto seconds = static_cast<std::uint32_t>((first.sinceStartUs + clockUs_) / 1e6);
        telegram.clock = ScanClock{1970,
                                   1,
                                   static_cast<std::uint8_t>(1 + seconds / 86400 % 28),
                                   static_cast<std::uint8_t>(seconds / 3600 % 24),
                                   static_cast<std::uint8_t>(seconds / 60 % 60),
                                   static_cast<std::uint8_t>(seconds % 60),
                                   static_cast<std::uint32_t>(std::fmod(first.sinceStartUs + clockUs_, 1e6))};
    } else {
        telegram.clock.reset();
    }
    return trimmedTelegram(std::move(telegram), device.range, device.content);
}

std::optional<SweepStep> EmulatedSweep::next(const EmulatedDevice& device) {
    if (finished()) return std::nullopt;
    SweepStep step;
    step.telegram = stamped(device);
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
    const int interval = std::max<int>(device.content.everyNth, 1);
    ++told_;
    scans_ += static_cast<std::uint64_t>(interval);
    inList_ += static_cast<std::uint64_t>(interval);
    clockUs_ += interval * 1e8 / std::max<std::uint32_t>(device.scan.frequency, 1);
    // Lines that the list leaves out were measured all the same.
    if (inList_ < telegrams_->size()) {
        const auto gap = [&](std::uint16_t ScanTelegram::*counter) {
            return static_cast<std::uint16_t>((*telegrams_)[inList_].*counter - (*telegrams_)[inList_ - 1].*counter) - 1;
        };
        const int missing = interval == 1 ? std::clamp(gap(&ScanTelegram::telegramCounter), 0, 60000) : 0;
        told_ += static_cast<std::uint64_t>(missing);
        scans_ += static_cast<std::uint64_t>(missing);
        clockUs_ += missing * 1e8 / std::max<std::uint32_t>(device.scan.frequency, 1);
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

} // namespace edgescan::sim
