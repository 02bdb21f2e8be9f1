// edgescan-cli: edge detection without a display.
#include "app/cli/commands.h"
#include "app/shared/exits.h"
#include "app/shared/interrupt.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/inputs.h"
#include "core/base/version.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

using namespace edgescan;

namespace {

struct Command {
    std::string_view name;
    void (*add)(CLI::App& app, int& code);
};
constexpr std::array kCommands = std::to_array<Command>({
    {"info", cli::addInfo},
    {"detect", cli::addDetect},
    {"batch", cli::addBatch},
    {"report", cli::addReport},
    {"convert", cli::addConvert},
    {"simulate", cli::addSimulate},
    {"verify", cli::addVerify},
    {"audit", cli::addAudit},
    {"serve", cli::addServe},
    {"record", cli::addRecord},
    {"replay", cli::addReplay},
    {"why", cli::addWhy},
    {"rocks", cli::addRocks},
    {"change", cli::addChange},
    {"calibrate", cli::addCalibrate},
    {"thumbnail", cli::addThumbnail},
});

/// Commands of edgescan-lab, as edgescan-cli called them.
struct MovedCommand {
    std::string_view name;
    const char* now;
};
constexpr std::array kMoved = std::to_array<MovedCommand>({
    {"compare", "edgescan-lab benchmark SCAN, or edgescan-lab repeatability A B"},
    {"evaluate", "edgescan-lab evaluate"},
});

/// Setting up all commands with their flags takes longer than many commands run. Therefore only the commands that the arguments can mean
/// are set up.
std::span<const Command> commandsFor(int argc, char** argv) {
    const std::span all(kCommands);
    const auto named = [](const char* word) { return std::ranges::find(kCommands, std::string_view(word), &Command::name); };
    if (argc == 2 && std::string_view(argv[1]) == "--version") return {};
    if (argc < 2 || named(argv[1]) == kCommands.end()) return all;
    const bool another = std::any_of(argv + 2, argv + argc, [&](const char* word) { return named(word) != kCommands.end(); });
    return another ? all : all.subspan(static_cast<std::size_t>(named(argv[1]) - kCommands.begin()), 1);
}

} // namespace

int main(int argc, char** argv) {
    if (const auto moved = std::ranges::find(kMoved, std::string_view(argc > 1 ? argv[1] : ""), &MovedCommand::name);
        moved != kMoved.end()) {
        cli::printError({"the command is in another program now", std::string(moved->name), "use " + std::string(moved->now)});
        return cli::kWrongUsage;
    }
    CLI::App app{"EdgeScan: the edges of rocks in a laser range scan"};
    app.set_version_flag("--version", version());
    app.require_subcommand(1);
    int code = cli::kDone;
    cli::surviveFileLimit();
    const BindInputs inputs; // no input file can be overwritten
    for (const Command& command : commandsFor(argc, argv)) command.add(app, code);
    cli::addPages(app, {"edgescan-cli",
                        "edges of rocks in laser range scans",
                        {"edgescan-cli simulate -o BELL.json --truth TRUTH --seed 7 --lines 300 --beams 381",
                         "edgescan-cli detect BELL.json", "edgescan-cli detect BELL.json -o RESULTS --jump 40",
                         "edgescan-cli convert BELL.json BELL.pcd", "edgescan-cli verify RESULTS/BELL_edges.png --scans ."}});
    return cli::exitCodeOf([&] { return cli::parsed(app, argc, argv).value_or(code); });
}
