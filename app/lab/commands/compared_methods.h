// Flags of `benchmark` and `repeatability`: which methods run, and how long PCL's may take.
#pragma once

#include "app/lab/peers/comparison.h"
#include "app/shared/options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace edgescan::cli {

struct ComparedFlags {
    lab::ComparisonSettings settings;
    bool slow = false, noPeers = false;
    std::string json; ///< file, "-" or empty
    ReadFlags read;
};

/// `flags` must live until the command has run.
void addComparedFlags(CLI::App& command, ComparedFlags& flags);

/// The first key of --only that no method has.
[[nodiscard]] std::optional<Error> unknownKey(const ComparedFlags& flags);

/// The settings as typed: without peers, or with peers that may take any time.
[[nodiscard]] lab::ComparisonSettings comparisonSettings(const ComparedFlags& flags);

/// At a terminal, or with --progress.
[[nodiscard]] bool showsProgress(const ComparedFlags& flags);

/// Prints a line on stderr before each method where progress is shown.
[[nodiscard]] lab::ComparisonProgress shownProgress(const ComparedFlags& flags);

} // namespace edgescan::cli
