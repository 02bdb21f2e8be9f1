// A command line read, or refused in a sentence.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace edgescan::cli {

/// Empty when the program is to go on; else its exit code: 0 after help and version, 2 where the command line is wrong.
[[nodiscard]] std::optional<int> parsed(CLI::App& app, int argc, char** argv);

} // namespace edgescan::cli
