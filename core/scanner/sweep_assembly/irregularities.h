// Irregularities in a scanner's telegrams, counted by kind and reported as sentences (docs/developer/protocol.md, "Counters and clocks",
// docs/reference/rules.md, "S1", "S2").
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace edgescan::scanner {

enum class Irregularity : std::uint8_t {
    Duplicate,       ///< came twice; dropped
    Late,            ///< came after a later one; is in its line
    TooLate,         ///< the same, but its sweep had ended: not in any line
    LeftOut,         ///< half of a line that began before the sweep: not in any line
    Misfit,          ///< other beams than those of the sweep: not in any line
    NoRanges,        ///< without a range channel: not in any line
    CounterJump,     ///< a counter advanced further than the clocks allow
    CounterReset,    ///< a counter went back while the clock continued
    CountersStopped, ///< neither counter advanced from one line to the next
    ClockJump,       ///< the device clock went back, or far ahead, while the counters continued
    ClockStopped,    ///< the device clock did not advance from one line to the next
    Pause,           ///< more than a second without a line that the counters account for
    Restart,         ///< the scanner's counters and clock started again
    OtherEchoes,     ///< other range channels than those of the sweep's first telegram, or channels with different beams
    OtherScanner,    ///< another serial number than that of the line before
    Gap,             ///< so many lines were lost that a new sweep began
};
inline constexpr int kIrregularities = 16;

/// "duplicates", "counter_jumps" ...: keys in reports.
[[nodiscard]] const char* irregularityKey(Irregularity kind);

/// A value type.
class Irregularities {
public:
    /// `line`: the line of the sweep where it was noticed; -1: unknown. `times`: telegrams, or lines for a Gap.
    void note(Irregularity kind, int line, std::int64_t times = 1);

    [[nodiscard]] std::int64_t count(Irregularity kind) const { return counts_[static_cast<std::size_t>(kind)]; }
    /// Lines that counters claim but the clocks do not allow.
    [[nodiscard]] std::int64_t implausibleLines() const { return claimed_; }
    void noteImplausible(std::int64_t lines) { claimed_ += lines; }
    /// True if the counters do not show whether lines are missing.
    [[nodiscard]] bool countersInDoubt() const;
    /// A sentence for each kind that affects the sweep. Duplicates and telegrams before its first line do not affect it.
    [[nodiscard]] std::vector<std::string> sentences() const;

    bool operator==(const Irregularities&) const = default;

private:
    std::array<std::int64_t, kIrregularities> counts_{};
    std::array<int, kIrregularities> first_{};
    std::int64_t claimed_ = 0;
};

/// The account of all scan telegrams since the start. Lines and cells: of all sweeps, including the growing one.
struct TelegramAccount {
    std::int64_t telegrams = 0;  ///< telegrams that arrived and were decoded
    std::int64_t placed = 0;     ///< in a line of a sweep
    std::int64_t duplicates = 0; ///< dropped, because their line was there already
    std::int64_t unusable = 0;   ///< not in any line: misfits, without ranges, too late, before the first whole line
    std::int64_t lost = 0;       ///< sent according to the counters, but never received
    std::int64_t lines = 0, linesLost = 0, cells = 0, cellsLost = 0;
    int sweeps = 0;

    /// Whether every telegram is accounted for.
    [[nodiscard]] bool addsUp() const { return telegrams == placed + duplicates + unusable; }
    bool operator==(const TelegramAccount&) const = default;
};

} // namespace edgescan::scanner
