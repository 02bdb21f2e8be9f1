// What the viewer's command line asks for.
#pragma once

#include "app/shared/host_port.h"
#include "app/shared/mounting.h"
#include "app/shared/options.h"
#include "app/viewer/when_shown.h"

#include <optional>
#include <string>
#include <vector>

namespace edgescan::viewer {

/// As typed.
struct Wanted {
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

void addFlags(CLI::App& app, Wanted& wanted);

/// What was typed, understood.
struct Understood {
    std::vector<PinnedPlace> pins;
    std::optional<Settings> settings;
    std::optional<cli::HostPort> scanner;
    SweepSettings sweep; ///< of the scanner
};

/// Why nothing is shown, and the code that the program ends with.
struct Refusal {
    Error error;
    int code;
};

/// Empty where everything was understood. Nothing is opened.
[[nodiscard]] std::optional<Refusal> understand(const Wanted& wanted, Understood& understood);

} // namespace edgescan::viewer
