// Reads the flags and checks their combinations.
#include "app/viewer/wanted.h"

#include "app/shared/exits.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/file_address.h"
#include "core/base/number_text.h"
#include "core/base/whole_file.h"
#include "core/scan/grid/reading_options.h"
#include "core/scanner/cola/host_port.h"
#include "ui/base/language/languages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace edgescan::viewer {
namespace {

cli::Mounting mountingOf(const CommandLine& wanted) {
    const ReadingOptions options = cli::readingOptions(wanted.read);
    cli::Mounting mounting = wanted.mounting;
    mounting.axis = options.axis;
    mounting.lineStepDeg = options.lineStepDeg;
    mounting.firstLineDeg = options.lineStartDeg;
    mounting.calibration = options.calibration;
    return mounting;
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

/// Finds the second of two scans that are asked for: it would not be shown.
std::optional<Error> secondStart(const CommandLine& wanted) {
    const std::string file = wanted.files.empty() ? "" : wanted.files.front();
    std::string first;
    for (const std::string& start :
         {std::string(wanted.demo ? "--demo" : ""), std::string(wanted.session.empty() ? "" : "--session"),
          std::string(wanted.goOn ? "--continue" : ""), std::string(wanted.live.empty() ? "" : "--live"), file}) {
        if (!first.empty() && !start.empty())
            return Error{first + " shows a scan of its own and no other", start, "leave out one of the two"};
        if (first.empty()) first = start;
    }
    return std::nullopt;
}

/// Finds a flag without effect.
std::optional<Error> idleFlag(const CommandLine& wanted) {
    const bool live = !wanted.live.empty(), restores = !wanted.session.empty() || wanted.goOn, file = !wanted.files.empty();
    const bool shows = file || live || restores || wanted.demo;
    ReadingOptions ofFiles = wanted.read.options;
    if (live) { // a live scanner uses the others
        ofFiles.axis.reset();
        ofFiles.lineStartDeg.reset();
        ofFiles.lineStepDeg.reset();
        ofFiles.calibration.clear();
        if (wanted.live.starts_with("ws://")) {
            ofFiles.topic.clear();
            ofFiles.joint.clear();
            ofFiles.keepRepeated = false;
        }
    }
    const auto firstOf = [](const std::string& flags) { return flags.substr(0, flags.find(' ')); };
    struct Flag {
        std::string typed;
        bool used;
        const char *why, *hint;
    };
    const char *const noScan = "there is no scan to show", *const anyScan = "give a file, --demo or --live";
    const char *const noScanner = "this is of a live scanner", *const scanner = "give --live ADDRESS too, or leave it out";
    const std::array flags{Flag{wanted.screenshot.empty() ? "" : "--screenshot", shows, noScan, anyScan},
                           Flag{wanted.pins.empty() ? "" : "--pin", shows, noScan, anyScan},
                           Flag{wanted.compare.empty() ? "" : "--compare", shows, noScan, anyScan},
                           Flag{wanted.screenshotLines == 1 ? "" : "--screenshot-lines", !wanted.screenshot.empty(),
                                "no screenshot is asked for", "give --screenshot FILE.png too, or leave it out"},
                           Flag{wanted.mounting.expectedLines == 0 ? "" : "--expected-lines", live, noScanner, scanner},
                           Flag{wanted.mounting.ticksPerDeg ? "--ticks-per-degree" : "", live, noScanner, scanner},
                           Flag{wanted.mounting.stopAndGo ? "--stop-and-go" : "", live, noScanner, scanner},
                           Flag{firstOf(cli::typedFlags(wanted.method)), !restores, "the session has settings of its own", "leave it out"},
                           Flag{firstOf(readingFlags(ofFiles)), file,
                                restores ? "the session says how its scan is read"
                                : live   ? "this is of a file or of a robot's bridge"
                                         : "this is of a file, and none is named",
                                "leave it out"}};
    const auto* idle = std::ranges::find_if(flags, [](const Flag& flag) { return !flag.typed.empty() && !flag.used; });
    return idle == flags.end() ? std::nullopt : std::optional(Error{idle->why, idle->typed, idle->hint});
}

/// Of all files but the first, which the window opens at once and reports itself.
std::optional<Error> missingFile(const CommandLine& wanted) {
    std::error_code none;
    for (std::size_t n = 1; n < wanted.files.size(); ++n) {
        if (!std::filesystem::exists(wanted.files[n], none))
            return addressElsewhere(wanted.files[n])
                .value_or(Error{"there is no such file", wanted.files[n], "check the spelling and the folder"});
    }
    return std::nullopt;
}

std::optional<Refusal> understandScanner(const CommandLine& wanted, ParsedCommandLine& understood) {
    if (wanted.live.empty()) return std::nullopt;
    const Result<scanner::HostPort> scanner = scanner::hostPort(wanted.live);
    if (!scanner) return Refusal{scanner.error(), cli::kWrongUsage};
    understood.scanner = *scanner;
    understood.mounting = mountingOf(wanted);
    if (const auto right = cli::checkMounting(understood.mounting); !right) return Refusal{right.error(), cli::kWrongUsage};
    const int expected = wanted.mounting.expectedLines;
    if (expected > 0 && wanted.screenshotLines > expected)
        return Refusal{Error{"a sweep of " + std::to_string(expected) + " lines never has so many",
                             "--screenshot-lines " + std::to_string(wanted.screenshotLines), "give fewer, or more --expected-lines"},
                       cli::kWrongUsage};
    const Result<scanner::SweepSettings> sweep = cli::sweepOf(understood.mounting);
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
    if (!wanted.screenshot.empty() && !isDevice(wanted.screenshot) && !asciiLower(wanted.screenshot).ends_with(".png"))
        return Refusal{Error{"the picture is a PNG", wanted.screenshot, "give a name that ends with .png"}, cli::kWrongUsage};
    std::error_code none;
    if (std::filesystem::equivalent(wanted.screenshot, wanted.session, none))
        return Refusal{Error{"the session is read from this file", wanted.screenshot, "give --screenshot another name"}, cli::kWrongUsage};
    if (const auto second = secondStart(wanted)) return Refusal{*second, cli::kWrongUsage};
    if (const auto idle = idleFlag(wanted)) return Refusal{*idle, cli::kWrongUsage};
    if (const auto missing = missingFile(wanted)) return Refusal{*missing, cli::kRefused};
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
