// Man pages and shell completion, made of the options that a program has.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace edgescan::cli {

struct PageText {
    std::string name;                  ///< of the program
    std::string purpose;               ///< for NAME: a few words
    std::vector<std::string> examples; ///< command lines that work one after the other in an empty folder
};

/// Adds the option --pages FOLDER, which no help shows: writes man1/NAME.1 and one page per command, bash/NAME, zsh/_NAME and
/// fish/NAME.fish into the folder, and ends. `app` must have all its options by the time it parses.
void addPages(CLI::App& app, const PageText& text);

} // namespace edgescan::cli
