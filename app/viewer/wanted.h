// The viewer's command line.
#pragma once

#include "app/shared/numbers.h"
#include "app/shared/options.h"
#include "core/scanner/cola/host_port.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::viewer {

/// The flags as typed.
struct CommandLine {
    std::vector<std::string> files;
    cli::MethodFlags method;
    cli::ReadFlags read;
    bool demo = false;
    bool cab = false;
    std::string live;
    cli::Mounting mounting;
    bool noSettings = false;
    std::string language;
    std::vector<std::string> pins; // "LINE,BEAM"
    std::string compare;
    std::string session;
    bool goOn = false;
    std::string screenshot;
    int screenshotLines = 1;
    double quitAfter = 0.0;
};

void addFlags(CLI::App& app, CommandLine& wanted);

/// The parsed and checked flags.
struct ParsedCommandLine {
    std::vector<cli::TypedCell> pins; ///< cells of the first picture
    std::optional<edges::Settings> settings;
    std::optional<scanner::HostPort> scanner;
    cli::Mounting mounting;       ///< of the live scanner
    scanner::SweepSettings sweep; ///< likewise
};

/// The reason why the viewer does not start, and the exit code.
struct Refusal {
    Error error;
    int code;
};

/// If the first word is a command of edgescan-cli and not a file: what to type instead.
[[nodiscard]] std::optional<Refusal> commandOfOtherProgram(int argc, char** argv);

/// Empty if the flags are valid. Opens nothing.
[[nodiscard]] std::optional<Refusal> parse(const CommandLine& wanted, ParsedCommandLine& understood);

} // namespace edgescan::viewer
