// The order, counters and mishaps of an emulated scanner's telegrams: everything about them that needs no socket.
#pragma once

#include "core/scanner/emulator/emulator.h"

#include <memory>
#include <random>
#include <vector>

namespace edgescan::sim {

/// What happens at one tick of the emulated scanner.
struct SweepStep {
    bool lost = false;      ///< nothing is sent
    bool duplicate = false; ///< the telegram is sent twice
    bool garbage = false;   ///< rubbish is sent before it
    bool corrupt = false;   ///< one bit of it is wrong
    bool stall = false;     ///< silence follows
    bool drop = false;      ///< the connections are closed afterwards
    bool narrow = false;    ///< half of the beams are left out, in the telegram below already
    ScanTelegram telegram;
};

class EmulatedSweep {
public:
    EmulatedSweep(std::shared_ptr<const std::vector<ScanTelegram>> telegrams, const EmulatedScannerSettings& settings);

    /// The next line, or nothing at the end (AtEnd::Stop).
    [[nodiscard]] std::optional<SweepStep> next();
    [[nodiscard]] bool finished() const;

    /// Bytes as they might come from a bad cable.
    [[nodiscard]] Bytes garbage();
    /// `bytes` with one bit turned over, not in the first one.
    [[nodiscard]] Bytes corrupted(Bytes bytes);
    /// A piece length from 1 to `most`.
    [[nodiscard]] std::size_t pieceLength(std::size_t most);

    bool contaminationWarning = false;
    bool contaminationError = false;

private:
    [[nodiscard]] bool happens(int every);
    [[nodiscard]] std::size_t listIndex() const;
    [[nodiscard]] ScanTelegram stamped() const;

    std::shared_ptr<const std::vector<ScanTelegram>> telegrams_;
    double periodUs_;
    AtEnd atEnd_;
    ScannerFaults faults_;
    std::mt19937 random_;
    std::uint64_t told_ = 0;   ///< telegrams counted so far, lost ones included
    std::uint64_t inList_ = 0; ///< lines taken from the list so far
    double clockUs_ = 0.0;     ///< since the first line
    int burstLeft_ = 0;
};

} // namespace edgescan::sim
