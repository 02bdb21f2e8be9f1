// Man pages and shell completion, generated from the options of a program.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace edgescan::cli {

struct PageText {
    std::string name;                  ///< of the program
    std::string purpose;               ///< for the section NAME: a few words
    std::vector<std::string> examples; ///< command lines that work in this order in an empty folder
};

/// Adds the hidden option --pages FOLDER. It writes man1/NAME.1 and one page per command, bash/NAME, zsh/_NAME and fish/NAME.fish into the
/// folder, and ends the program. `app` must have all its options when it parses.
void addPages(CLI::App& app, const PageText& text);

} // namespace edgescan::cli
