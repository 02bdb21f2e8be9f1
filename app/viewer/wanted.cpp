// Reads the flags and checks their combinations.
#include "app/viewer/wanted.h"

#include "app/shared/exits.h"
#include "app/shared/pages.h"
#include "app/shared/usage.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "ui/base/language/languages.h"

#include <CLI/CLI.hpp>

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

Result<std::vector<PinnedPlace>> pinsOf(const std::vector<std::string>& typed) {
    std::vector<PinnedPlace> places;
    for (const std::string& text : typed) {
        const std::size_t comma = text.find(',');
        const double line = numberOf(text.substr(0, comma)).value_or(-1.0);
        const double beam = comma == std::string::npos ? -1.0 : numberOf(text.substr(comma + 1)).value_or(-1.0);
        const auto isIndex = [](double n) { return n >= 0 && n < 1e9 && n == static_cast<int>(n); };
        if (!isIndex(line) || !isIndex(beam)) return Error{"\"" + text + "\" is not a cell", "--pin", "give LINE,BEAM such as 525,593"};
        places.push_back({static_cast<int>(line), static_cast<int>(beam)});
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
    const Result<cli::HostPort> scanner = cli::hostPort(wanted.live);
    if (!scanner) return Refusal{scanner.error(), cli::kWrongUsage};
    understood.scanner = *scanner;
    const Result<scanner::SweepSettings> sweep = sweepOf(wanted);
    if (!sweep) return Refusal{sweep.error(), cli::kRefused};
    understood.sweep = *sweep;
    return std::nullopt;
}

} // namespace

void addFlags(CLI::App& app, CommandLine& wanted) {
    app.set_version_flag("--version", version());
    app.add_option("FILE", wanted.files, "Scans; the first is shown, Page Down goes to the next");
    app.add_flag("--demo", wanted.demo, "Open the demo draw-bell");
    app.add_option(
        "--live", wanted.live,
        "Connect to a live scanner, HOST or HOST:PORT, or to a robot's Foxglove bridge, ws://HOST or ws://HOST:PORT; nothing but reads "
        "and a subscription is sent");
    cli::addMountingFlags(app, wanted.mounting, "Live sweep (with --line-start, --line-step, --axis and --calibration)");
    app.add_flag("--no-settings", wanted.noSettings, "Neither read nor write what the viewer remembers");
    std::vector<std::string> languages;
    for (const ui::Language& language : ui::kLanguages) languages.emplace_back(language.code);
    app.add_option("--language", wanted.language, "Language of the window; else the one chosen in it, or that of the system")
        ->check(CLI::IsMember(languages));
    app.add_flag("--cab", wanted.cab, "Start in cab mode: large tools and numbers, for gloves; hold Locked to leave it");
    app.add_option("--pin", wanted.pins, "Pin this cell of the first scan, LINE,BEAM; may be given several times")->take_all();
    app.add_option("--compare", wanted.compare, "Compare the first scan with this earlier one");
    app.add_option("--session", wanted.session, "Open this session, or the picture of the window that carries one");
    app.add_flag("--continue", wanted.goOn, "Go on where the viewer was, after a crash too");
    app.add_option("--screenshot", wanted.screenshot, "Write the window to this PNG once the scan is on screen, and quit");
    cli::addNumber(app, "--screenshot-lines", wanted.screenshotLines, {1, 1e6}, "Only once so many lines are there");
    cli::addNumber(app, "--quit-after", wanted.quitAfter, {0, 1e6}, "Quit after so many seconds");
    cli::addMethodFlags(app, wanted.method);
    cli::addReadFlags(app, wanted.read);
    cli::addPages(app, {"edgescan", "shows the edges of rocks in a laser scan", {"edgescan --demo"}});
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
