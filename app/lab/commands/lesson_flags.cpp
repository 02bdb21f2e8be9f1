// Numbers of the simulated scans, as flags and as text.
#include "app/lab/commands/lesson_flags.h"

namespace edgescan::cli {

void addLessonFlags(CLI::App& command, LessonFlags& flags, const std::string& finer) {
    command.add_option("--seed", flags.firstSeed, "The first seed; each scan has the next one")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    command.add_option("--lines", flags.lines, "Scan lines; " + finer + " twice as many")
        ->check(CLI::Range(20, 1000))
        ->capture_default_str();
    command.add_option("--beams", flags.beams, "Beams; " + finer + " twice as many")->check(CLI::Range(20, 1141))->capture_default_str();
}

std::string madeBy(const std::string& command, const LessonFlags& flags, const std::string& more) {
    return "edgescan-lab " + command + " --seed " + std::to_string(flags.firstSeed) + more + " --lines " + std::to_string(flags.lines) +
           " --beams " + std::to_string(flags.beams);
}

} // namespace edgescan::cli
