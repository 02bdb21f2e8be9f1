// The tables of edgescan-bench: ratios with their goals, and the times that they come from.
#pragma once

#include "core/base/instruction_set.h"
#include "core/scan/grid/scan.h"
#include "tests/bench/timing.h"

#include <cstdint>
#include <cstdio>
#include <vector>

namespace edgescan::bench {

enum class Good : std::uint8_t { AtMost, AtLeast };

/// One row of the table. `measured`: the ratio on record, which `--short` guards with a third of play. `withoutAvx512`: the one on record
/// where the loops use a narrower instruction set; 0: the same.
struct Goal {
    const char* what;
    Good direction;
    double goal, measured, withoutAvx512 = 0;

    [[nodiscard]] bool isReached(double ratio) const { return direction == Good::AtMost ? ratio <= goal : ratio >= goal; }
    [[nodiscard]] double onRecord() const {
        return withoutAvx512 > 0 && instructionSet() != InstructionSet::Avx512 ? withoutAvx512 : measured;
    }
    [[nodiscard]] double limit() const { return direction == Good::AtMost ? onRecord() / 0.75 : onRecord() * 0.75; }
    [[nodiscard]] bool isHeld(double ratio) const { return direction == Good::AtMost ? ratio <= limit() : ratio >= limit(); }
    [[nodiscard]] const char* words() const { return direction == Good::AtMost ? "at most" : "at least"; }
};

/// Prints rows and remembers whether no ratio became worse than the one on record.
class Table {
public:
    void begin(const char* title) const { std::printf("\n## %s\n\n| ratio | measured | goal | reached |\n|---|---|---|---|\n", title); }
    /// A ratio of 0 could not be measured and has no row.
    void row(const Goal& goal, double ratio) {
        if (ratio <= 0) return;
        std::printf("| %s | %.2f | %s %g | %s |\n", goal.what, ratio, goal.words(), goal.goal, goal.isReached(ratio) ? "yes" : "no");
        if (goal.isHeld(ratio)) return;
        held_ = false;
        std::fprintf(stderr, "edgescan-bench: %s: %.2f, and %s %.2f is demanded\n", goal.what, ratio, goal.words(), goal.limit());
    }
    [[nodiscard]] bool areAllHeld() const { return held_; }

private:
    bool held_ = true;
};

/// The times of candidates that have run on a scan.
void printCandidates(const std::vector<Candidate>& runs, const Scan& scan);

} // namespace edgescan::bench
