// Parses a command line, or refuses it with one sentence.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>

namespace edgescan::cli {

/// Empty if the program continues; else its exit code: 0 after help and version, 2 for a wrong command line or a wrong EDGESCAN_LOOPS.
/// Addresses of files (file:///...) become their paths. Every switch takes true, false or no value. `addOthers` adds the commands that
/// `app` does not have yet; it is called for an unknown flag, which may be one of theirs.
[[nodiscard]] std::optional<int> parsed(
    CLI::App& app, int argc, char** argv, const std::function<void()>& addOthers = [] {});

} // namespace edgescan::cli
