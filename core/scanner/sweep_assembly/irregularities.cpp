// Sentences about irregularities: one row per kind.
#include "core/scanner/sweep_assembly/irregularities.h"
#include "core/base/translated_text.h"

namespace edgescan::scanner {
namespace {

struct Words {
    const char* key;
    const char* one;  ///< text for a single one; empty: not reported
    const char* many; ///< text behind the number
    const char* so;   ///< the consequence, with its punctuation
    bool doubt;       ///< true: losses cannot be counted
};

constexpr std::array<Words, kIrregularities> kWords{{
    {"duplicates", "", "", "", false},
    {"late", "A telegram came late and was put into its line", "telegrams came late and were put into their lines", "", false},
    {"too_late", "A telegram came after its sweep had ended", "telegrams came after their sweep had ended", ": not used", false},
    {"left_out", "", "", "", false},
    {"misfits", "A telegram had other beams than the sweep, or was of another layer of the scanner",
     "telegrams had other beams than the sweep, or were of another layer of the scanner", ": no lines of this sweep", false},
    {"without_ranges", "A telegram held no ranges", "telegrams held no ranges", ": their lines are lost", false},
    {"counter_jumps", "The scanner's counters jumped ahead once", "times the scanner's counters jumped ahead",
     ", by more lines than its clock allows: whether lines were lost there is not known", true},
    {"counter_resets", "One of the scanner's counters was set back", "times one of the scanner's counters was set back",
     ": lost lines there are counted by the other one and the clock", false},
    {"counters_stand", "The scanner's counters stood still for a line", "times the scanner's counters stood still from line to line",
     ": lost lines cannot be counted there", true},
    {"clock_jumps", "The scanner's clock was set while its counters ran on", "times the scanner's clock was set while its counters ran on",
     ": the times of lines there are reckoned", false},
    {"clock_stands", "The scanner's clock stood still for a line", "times the scanner's clock stood still from line to line",
     ": the times of lines there are reckoned", false},
    {"pauses", "The scanner paused for more than a second", "times the scanner paused for more than a second",
     ", and its counters know of no lost line", false},
    {"restarts", "The scanner restarted", "times the scanner restarted", ": lines lost meanwhile are counted by this computer's clock",
     false},
    {"other_echoes", "A telegram brought other echoes than the first one", "telegrams brought other echoes than the first one",
     ": their ranges may be of another echo", false},
    {"other_scanner", "The telegrams come from another scanner", "times the telegrams came from another scanner",
     ": the sweep is not of one device", true},
    {"lost_between_sweeps", "A line was lost between two sweeps", "lines were lost between two sweeps", "", false},
}};

} // namespace

const char* irregularityKey(Irregularity kind) { return kWords[static_cast<std::size_t>(kind)].key; }

void Irregularities::note(Irregularity kind, int line, std::int64_t times) {
    if (times <= 0) return;
    const auto k = static_cast<std::size_t>(kind);
    if (counts_[k] == 0) first_[k] = line;
    counts_[k] += times;
}

bool Irregularities::countersInDoubt() const {
    for (std::size_t k = 0; k < kWords.size(); ++k) {
        if (kWords[k].doubt && counts_[k] > 0) return true;
    }
    return false;
}

std::vector<std::string> Irregularities::sentences() const {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < kWords.size(); ++k) {
        const Words& words = kWords[k];
        if (counts_[k] == 0 || *words.one == '\0') continue;
        std::string sentence = counts_[k] == 1 ? words.one : std::to_string(counts_[k]) + ' ' + words.many;
        if (first_[k] >= 0) sentence += (counts_[k] == 1 ? " (line " : " (first at line ") + std::to_string(first_[k]) + ')';
        sentence += words.so;
        if (k == static_cast<std::size_t>(Irregularity::CounterJump)) sentence += withValues(" (%1 by the counters)", {claimed_});
        all.push_back(sentence + '.');
    }
    return all;
}

} // namespace edgescan::scanner
