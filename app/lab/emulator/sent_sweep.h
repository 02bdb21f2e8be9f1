// The order, counters and faults of an emulated scanner's telegrams: the part that does not need a socket.
#pragma once

#include "app/lab/emulator/emulator.h"

#include <memory>
#include <random>
#include <vector>

namespace edgescan::scanner {

/// The events at one tick of the emulated scanner.
struct SweepStep {
    bool lost = false;      ///< nothing is sent
    bool duplicate = false; ///< the telegram is sent twice
    bool garbage = false;   ///< random bytes are sent before it
    bool corrupt = false;   ///< one bit of it is wrong
    bool stall = false;     ///< silence follows
    bool drop = false;      ///< the connections are closed afterwards
    bool narrow = false;    ///< half of the beams are left out; already done in `telegram`
    ScanTelegram telegram;
};

class EmulatedSweep {
public:
    EmulatedSweep(std::shared_ptr<const std::vector<ScanTelegram>> telegrams, const EmulatedScannerSettings& settings);

    /// The next line; empty at the end (AtEnd::Stop).
    [[nodiscard]] std::optional<SweepStep> next();
    [[nodiscard]] bool finished() const;

    /// Random bytes, as from a bad cable.
    [[nodiscard]] Bytes garbage();
    /// `bytes` with one bit inverted, not in the first byte.
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
    std::uint32_t frequency_; ///< 1/100 Hz, in each telegram
    double periodUs_;         ///< the time of a line by the device clock
    AtEnd atEnd_;
    ScannerFaults faults_;
    std::mt19937 random_;
    std::uint64_t counted_ = 0; ///< telegrams counted so far, including lost ones
    std::uint64_t inList_ = 0;  ///< lines taken from the list so far
    double clockUs_ = 0.0;      ///< microseconds since the first line
    int burstLeft_ = 0;
};

} // namespace edgescan::scanner
