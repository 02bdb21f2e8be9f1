// What about a scanner's telegrams was not as it should be: counted by kind, and told in words.
// (docs/protocol.md, "Counters and clocks", docs/operator.md, "S1", "S2".)
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace edgescan {

enum class Irregularity : std::uint8_t {
    Duplicate,     ///< came twice; dropped
    Late,          ///< came after a later one; is in its line
    TooLate,       ///< the same, and its sweep had ended: in no line
    LeftOut,       ///< half of a line that began before the sweep did: in no line
    Misfit,        ///< other beams than the sweep's: in no line
    NoRanges,      ///< no channel with ranges: in no line
    CounterJump,   ///< a counter ran further than any clock allows
    CounterReset,  ///< a counter went back while the clock ran on
    CountersStand, ///< neither counter moved from one line to the next
    ClockJump,     ///< the device clock went back, or far ahead, while the counters ran on
    ClockStands,   ///< the device clock did not move from one line to the next
    Pause,         ///< more than a second without a line that the counters know of
    Restart,       ///< the scanner's counters and clock began anew
    OtherEchoes,   ///< other range channels than the sweep's first telegram, or channels of unlike beams
    OtherScanner,  ///< another serial number than the line before
    Gap,           ///< so many lines were lost in one go that a new sweep began
};
inline constexpr int kIrregularities = 16;

/// "duplicates", "counter_jumps" ...: keys in reports.
[[nodiscard]] const char* irregularityKey(Irregularity kind);

/// A value.
class Irregularities {
public:
    /// `line`: of the sweep, where it was noticed; -1: none. `times`: telegrams, or lines for a Gap.
    void note(Irregularity kind, int line, std::int64_t times = 1);

    [[nodiscard]] std::int64_t count(Irregularity kind) const { return counts_[static_cast<std::size_t>(kind)]; }
    /// Lines that counters named and no clock allows.
    [[nodiscard]] std::int64_t claimed() const { return claimed_; }
    void claim(std::int64_t lines) { claimed_ += lines; }
    /// Whether lines are missing cannot be told from the counters.
    [[nodiscard]] bool countersInDoubt() const;
    /// A sentence for each kind that says something of the sweep; duplicates and what came before its first line do it no harm.
    [[nodiscard]] std::vector<std::string> sentences() const;

    bool operator==(const Irregularities&) const = default;

private:
    std::array<std::int64_t, kIrregularities> counts_{};
    std::array<int, kIrregularities> first_{};
    std::int64_t claimed_ = 0;
};

/// Where every scan telegram since the start went. Lines and cells: of all sweeps, the growing one included.
struct TelegramAccount {
    std::int64_t telegrams = 0;  ///< that arrived and could be decoded
    std::int64_t placed = 0;     ///< in a line of a sweep
    std::int64_t duplicates = 0; ///< dropped: their line was there
    std::int64_t unusable = 0;   ///< in no line: misfits, without ranges, too late, before the first whole line
    std::int64_t lost = 0;       ///< that the counters say were sent and that never came
    std::int64_t lines = 0, linesLost = 0, cells = 0, cellsLost = 0;
    int sweeps = 0;

    /// Nothing vanished in between.
    [[nodiscard]] bool addsUp() const { return telegrams == placed + duplicates + unusable; }
    bool operator==(const TelegramAccount&) const = default;
};

} // namespace edgescan
