// The texts around the flags of a program: groups and examples in the help, man pages, shell completion.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace edgescan::cli {

/// A name, a path or an exit code, and its meaning.
struct Term {
    std::string name, meaning;
};

/// What the help and the man page of a command say besides its flags.
struct CommandText {
    std::string name;
    std::string group;                 ///< heading of the command in the list of commands
    std::vector<std::string> examples; ///< command lines
    std::vector<Term> exits;           ///< exit codes besides 0, 1 and 2
};

struct PageText {
    std::string name;                  ///< of the program
    std::string purpose;               ///< for the section NAME: a few words
    std::vector<std::string> examples; ///< command lines that work in this order in an empty folder
    std::vector<Term> files;           ///< what the program reads and writes where no flag names it
    std::vector<CommandText> commands; ///< in the order of the help
};

/// Sorts the commands into groups and adds examples and exit codes to each help. Also adds the hidden option --pages FOLDER. It writes
/// man1/NAME.1 and one page per command, bash/NAME, zsh/_NAME and fish/NAME.fish into the folder, and ends the program. `app` must have all
/// its options when it parses.
void addPages(CLI::App& app, const PageText& text);

} // namespace edgescan::cli
