// Flags of `learn-borders` and `learn-confidence`: the simulated scans to learn from.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace edgescan::cli {

struct LessonFlags {
    int firstSeed;
    int lines = 500, beams = 571; ///< of most of the scans
};

/// `finer`: which scans have twice as many lines and beams. `flags` must live until the command has run.
void addLessonFlags(CLI::App& command, LessonFlags& flags, const std::string& finer);

/// The command that makes the same weights again. `more`: its other flags.
[[nodiscard]] std::string madeBy(const std::string& command, const LessonFlags& flags, const std::string& more = "");

} // namespace edgescan::cli
