// Reads the flags and checks their combinations.
#include "app/viewer/wanted.h"

#include "app/shared/exits.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/scanner/cola/host_port.h"
#include "ui/base/language/languages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace edgescan::viewer {
namespace {

Result<scanner::SweepSettings> sweepOf(const CommandLine& wanted) {
    const ReadingOptions options = cli::readingOptions(wanted.read);
    cli::Mounting mounting = wanted.mounting;
    mounting.axis = options.axis;
    mounting.lineStepDeg = options.lineStepDeg;
    mounting.firstLineDeg = options.lineStartDeg;
    mounting.calibration = options.calibration;
    return cli::sweepOf(mounting);
}

Result<std::vector<cli::TypedCell>> pinsOf(const std::vector<std::string>& typed) {
    std::vector<cli::TypedCell> places;
    for (const std::string& text : typed) {
        const auto cell = cli::typedCell(text, "--pin");
        if (!cell) return cell.error();
        places.push_back(*cell);
    }
    return places;
}

/// Finds flags that contradict each other.
std::optional<Error> contradiction(const CommandLine& wanted) {
    if (!wanted.screenshot.empty() && wanted.files.empty() && !wanted.demo && wanted.live.empty() && wanted.session.empty() && !wanted.goOn)
        return Error{"there is no scan to show", "--screenshot", "give a file, --demo or --live"};
    if (wanted.demo && !wanted.files.empty())
        return Error{"the demo is a scan of its own and takes no file or folder", wanted.files.front(),
                     "leave out --demo to open it, or the name to open the demo"};
    return std::nullopt;
}

std::optional<Refusal> understandScanner(const CommandLine& wanted, ParsedCommandLine& understood) {
    if (wanted.live.empty()) return std::nullopt;
    const Result<scanner::HostPort> scanner = scanner::hostPort(wanted.live);
    if (!scanner) return Refusal{scanner.error(), cli::kWrongUsage};
    understood.scanner = *scanner;
    const Result<scanner::SweepSettings> sweep = sweepOf(wanted);
    if (!sweep) return Refusal{sweep.error(), cli::kRefused};
    understood.sweep = *sweep;
    return std::nullopt;
}

} // namespace

void addFlags(CLI::App& app, CommandLine& wanted) {
    app.set_version_flag("--version", cli::versionText());
    app.add_option("FILE", wanted.files, "Scans; the first is shown, Page Down goes to the next");
    app.add_flag("--demo", wanted.demo, "Open the demo draw-bell");
    app.add_option("--live", wanted.live,
                   "Connect to a live scanner, HOST or HOST:PORT, or to a robot's Foxglove bridge, ws://HOST or ws://HOST:PORT; the viewer "
                   "only reads and subscribes")
        ->type_name("ADDRESS");
    cli::addMountingFlags(app, wanted.mounting, "Live sweep (with --line-start, --line-step, --axis and --calibration)");
    app.add_flag("--no-settings", wanted.noSettings, "Neither read nor write the settings of the window");
    std::vector<std::string> languages;
    for (const ui::Language& language : ui::kLanguages) languages.emplace_back(language.code);
    app.add_option("--language", wanted.language, "Language of the window; else the one chosen in it, or that of the system")
        ->check(CLI::IsMember(languages));
    app.add_flag("--cab", wanted.cab,
                 "Start in cab mode, with large tools and numbers for gloves; hold the button at the top right to leave it");
    app.add_option("--pin", wanted.pins, "Place a target at this cell of the first scan; may be given several times")
        ->take_all()
        ->type_name("LINE,BEAM");
    app.add_option("--compare", wanted.compare, "Compare the first scan with this earlier one")->type_name("SCAN");
    app.add_option("--session", wanted.session, "Open this session, or a screenshot that carries one")->type_name("FILE");
    app.add_flag("--continue", wanted.goOn, "Restore the last state of the viewer, after a crash too");
    app.add_option("--screenshot", wanted.screenshot, "Write the window to this PNG once the scan is on screen, and quit")
        ->type_name("FILE");
    cli::addNumber(app, "--screenshot-lines", wanted.screenshotLines, {1, 1e6},
                   "Take the screenshot only when this number of lines is there");
    cli::addNumber(app, "--quit-after", wanted.quitAfter, {0, 1e6}, "Quit after this time [s]");
    cli::addMethodFlags(app, wanted.method);
    cli::addReadFlags(app, wanted.read);
    cli::addPages(app, {"edgescan",
                        "shows the edges of rocks in a laser scan",
                        {"edgescan --demo"},
                        {{"~/.config/edgescan/viewer.ini", "settings of the window"},
                         {"~/.config/edgescan/audit.jsonl", "audit log"},
                         {"~/.config/edgescan/targets", "targets and measurements, a file per scan"},
                         {"~/.config/edgescan/sessions", "sessions that are restored after a crash"},
                         {"SCAN.EXT.rocks.json", "settings and edits of rocks, next to the scan"},
                         {"SCAN.EXT.pose.json", "pose of the scan, next to it"}},
                        {}});
}

std::optional<Refusal> commandOfOtherProgram(int argc, char** argv) {
    constexpr std::array<std::string_view, 16> kCommands{"info",    "why",       "thumbnail", "detect", "rocks", "report",
                                                         "convert", "batch",     "compare",   "verify", "audit", "record",
                                                         "replay",  "calibrate", "simulate",  "emulate"};
    if (argc < 2 || std::ranges::find(kCommands, std::string_view(argv[1])) == kCommands.end()) return std::nullopt;
    std::error_code none;
    if (std::filesystem::exists(argv[1], none)) return std::nullopt;
    const std::string command = std::string("edgescan-cli ") + argv[1];
    return Refusal{Error{"this is a command of edgescan-cli", argv[1], "type " + command + " --help"}, cli::kWrongUsage};
}

std::optional<Refusal> parse(const CommandLine& wanted, ParsedCommandLine& understood) {
    if (const auto wrong = contradiction(wanted)) return Refusal{*wrong, cli::kWrongUsage};
    if (auto refused = understandScanner(wanted, understood)) return refused;
    const auto pins = pinsOf(wanted.pins);
    if (!pins) return Refusal{pins.error(), cli::kWrongUsage};
    understood.pins = *pins;
    if (!cli::anyTyped(wanted.method)) return std::nullopt;
    const Result<edges::Settings> settings = cli::settingsOf(wanted.method);
    if (!settings) return Refusal{settings.error(), cli::kWrongUsage};
    understood.settings = *settings;
    return std::nullopt;
}

} // namespace edgescan::viewer
