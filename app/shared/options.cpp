// Flags of several commands.
#include "app/shared/options.h"

#include "core/base/foreign_text.h"
#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/shell_quoted.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/placed_points.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace edgescan::cli {
namespace {

// The limits and the default, for --help: "x, 1 to 10, default 3".
std::string hint(const edges::Parameter& p) {
    std::string text = p.help;
    if (std::string_view(p.key) == "lower")
        text += " A depth (0.5m), or with logarithmic gray levels a share of the range (5%), is turned into levels.";
    text += " [";
    if (p.choices.empty()) {
        if (*p.unit != '\0') text += std::string(p.unit) + ", ";
        text += shortestText(p.minimum) + " to " + shortestText(p.maximum);
        if (p.automatic != nullptr) text += " or auto";
    } else {
        for (const edges::Choice& choice : p.choices) text += (&choice == &p.choices.front() ? "" : "|") + std::string(choice.name);
    }
    return text + "; default " + edges::formatValue(p, p.get(edges::Settings{})) + "]";
}

// One line per stage on stderr, overwritten in place.
bool showStage(const char* stage, double fraction) {
    std::string line = stage;
    line.resize(std::max<std::size_t>(24, line.size()), ' ');
    showProgress(line + " " + rightAligned(fixedText(fraction * 100, 0), 3) + " %", fraction >= 1.0);
    return true;
}

} // namespace

void addRockFlags(CLI::App& command, RockFlags& flags, bool ofOneScan) {
    const char* group = "Rocks";
    for (const rocks::RockParameter& p : rocks::rockParameters()) {
        const std::string flag = std::string("--") + p.key;
        const NumberLimits limits = p.limits();
        const auto parse = [&flags, flag, limits, &p](const std::string& text) {
            flags.typed.emplace_back(&p, numberTyped(flag, text, limits, p.decimals == 0, p.unit));
        };
        const std::string unit = *p.unit == '\0' ? "" : std::string(" [") + p.unit + "]";
        command.add_option_function<std::string>(flag, parse, p.help + unit)
            ->type_name(rangeName(limits))
            ->default_str(shortestText(p.get(rocks::RockSettings{})))
            ->group(group);
    }
    command.add_option("--region", flags.region, "Region of interest: two opposite cells, or the corners of a polygon")
        ->type_name("\"LINE,BEAM LINE,BEAM...\"")
        ->group(group);
    if (!ofOneScan) return;
    command
        .add_option("--edits", flags.edits,
                    "Edits by hand, with settings where it has some: SCAN.EXT.rocks.json of the viewer (docs/method/rocks.md)")
        ->type_name("FILE")
        ->group(group);
}

bool anyTyped(const RockFlags& flags) { return !flags.typed.empty() || !flags.region.empty() || !flags.edits.empty(); }

Result<Done> checkRocks(RockFlags& flags) {
    if (!flags.region.empty()) {
        const auto region = rocks::parseRegion(flags.region);
        if (!region) return region.error();
        flags.corners = *region;
    }
    if (!flags.edits.empty()) claimInput(flags.edits);
    return Done{};
}

std::string typedFlags(const RockFlags& flags) {
    std::string text;
    const auto add = [&](const std::string& flag, const std::string& value) { text += (text.empty() ? "--" : " --") + flag + " " + value; };
    for (const auto& [parameter, value] : flags.typed) add(parameter->key, shortestText(value));
    if (!flags.region.empty()) add("region", shellQuoted(flags.region));
    if (!flags.edits.empty()) add("edits", shellQuoted(flags.edits));
    return text;
}

Result<rocks::Preset> presetOf(const RockFlags& flags, const Scan& scan) {
    rocks::Preset preset;
    if (!flags.edits.empty()) {
        auto read = rocks::readRockPreset(flags.edits, scan);
        if (!read) return read.error();
        preset = std::move(*read);
    }
    rocks::RockSettings settings = preset.settings.value_or(rocks::RockSettings{});
    for (const auto& [parameter, value] : flags.typed) parameter->set(settings, value);
    if (!flags.corners.empty()) {
        const auto inside = rocks::isRegionInside(flags.corners, scan.lines(), scan.beams());
        if (!inside) return inside.error();
        if (!*inside) printError(printable(scan.name) + ": a part of the --region is outside of the scan; the rest counts.");
        settings.region = flags.corners;
    }
    preset.settings = settings;
    return preset;
}

void addMountingFlags(CLI::App& command, Mounting& mounting, const std::string& group) {
    addNumber(command, "--expected-lines", mounting.expectedLines, {0, 20000}, "Lines of a whole sweep; 0 = not known").group(group);
    addNumber(command, "--ticks-per-degree", mounting.ticksPerDeg, {-1e9, 1e9}, "Encoder counts per degree, where there is an encoder")
        .group(group);
    command.add_flag("--stop-and-go", mounting.stopAndGo, "The stepper stops while a line is measured; without this flag it turns on")
        ->group(group);
}

Result<Done> checkMounting(const Mounting& mounting) {
    if (mounting.lineStepDeg == 0.0)
        return Error{"all lines would have one angle", "--line-step", "give the angle from line to line, such as 0.3"};
    if (mounting.ticksPerDeg == 0.0)
        return Error{"an encoder without counts gives no angle", "--ticks-per-degree", "give its counts per degree, or leave it out"};
    return Done{};
}

std::vector<std::string> idleMounting(const Mounting& mounting, const std::string& joint, const files::LiveStatus& status) {
    const bool lines = !status.wholeClouds, measured = status.sweep.angleSource == scanner::AngleSource::Stepper;
    const char* const ofLines = "the bridge gives the angle of each line";
    struct Flag {
        const char* name;
        bool isTyped, isUsed;
        const char* why;
    };
    const std::array flags{
        Flag{"--axis", mounting.axis.has_value(), lines && mounting.axis == status.sweep.axis, "the bridge says how the laser turns"},
        Flag{"--line-step", mounting.lineStepDeg.has_value(), lines && !measured, ofLines},
        Flag{"--line-start", mounting.firstLineDeg.has_value(), lines && !measured, ofLines},
        Flag{"--ticks-per-degree", mounting.ticksPerDeg.has_value(), false, "a bridge sends no counts of an encoder"},
        Flag{"--stop-and-go", mounting.stopAndGo, false, "the bridge gives the time of each line"},
        Flag{"--expected-lines", mounting.expectedLines > 0, lines, ofLines},
        Flag{"--joint", !joint.empty(), lines, ofLines}};
    std::vector<std::string> idle;
    for (const Flag& flag : flags) {
        if (flag.isTyped && !flag.isUsed)
            idle.push_back(std::string(flag.name) + " has no effect: " + (lines ? flag.why : "the topic gives whole clouds") +
                           "; leave it out.");
    }
    return idle;
}

Result<scanner::SweepSettings> sweepOf(const Mounting& mounting) {
    scanner::SweepSettings sweep = scanner::assumedSweep();
    if (!mounting.calibration.empty()) {
        const auto calibration = openCalibration(mounting.calibration);
        if (!calibration) return calibration.error();
        sweep.axis = std::abs(calibration->axis.z()) >= std::abs(calibration->axis.x()) ? Axis::Spin : Axis::Sweep;
        sweep.degPerLine = calibration->degPerStep; // its first angle and direction are applied with the pose of the scanner
        sweep.indexDeg = calibration->mirrorIndexDeg;
        sweep.axisAssumed = sweep.stepAssumed = false;
        if (mounting.axis && *mounting.axis != sweep.axis)
            return Error{std::string("the stepper of ") + mounting.calibration + " turns about the other axis, " +
                             (sweep.axis == Axis::Spin ? "spin" : "sweep"),
                         "--axis", "leave --axis out, or correct \"stepper.axis\" of the calibration"};
    }
    if (mounting.axis) {
        sweep.axis = *mounting.axis;
        sweep.axisAssumed = false;
    }
    if (mounting.lineStepDeg) {
        sweep.degPerLine = mounting.lineStepDeg;
        sweep.stepAssumed = false;
    }
    sweep.firstLineDeg = mounting.firstLineDeg.value_or(sweep.firstLineDeg);
    const bool calibrated = !mounting.calibration.empty(); // its first angle is applied with the pose
    sweep.firstAssumed = !mounting.firstLineDeg && !calibrated && scanner::guessesFirst(sweep);
    sweep.ticksPerDeg = mounting.ticksPerDeg;
    sweep.expectedLines = mounting.expectedLines;
    if (sweep.stepAssumed) sweep.degPerLine = scanner::assumedStepDeg(sweep.expectedLines);
    sweep.continuous = !mounting.stopAndGo;
    return sweep;
}

namespace {

void addReadingFlag(CLI::App& command, const ReadingOption& option, ReadingOptions& options, const char* group) {
    const std::string name = std::string("--") + option.key;
    const auto parse = [&option, &options](const std::string& text) {
        if (const auto fits = checked(option, text); !fits)
            throw CLI::ValidationError(fits.error().where, fits.error().what + "; " + fits.error().hint);
        option.set(options, text);
    };
    CLI::Option* added = nullptr;
    if (option.kind == ReadingOption::Kind::Switch)
        added = command.add_flag_callback(
            name, [parse] { parse("on"); }, option.help);
    else if (option.kind == ReadingOption::Kind::ThreeNumbers)
        added = command
                    .add_option_function<std::vector<std::string>>(
                        name, [parse](const std::vector<std::string>& xyz) { parse(CLI::detail::join(xyz, ",")); }, option.help)
                    ->delimiter(',')
                    ->expected(3);
    else
        added = command.add_option_function<std::string>(name, parse, option.help);
    if (!option.words.empty() && option.limit == nullptr) added->check(CLI::IsMember(option.words));
    if (!option.words.empty() && option.limit != nullptr)
        added->type_name(CLI::detail::join(option.words, "|") + "|NUMBER of mm");
    else if (option.limit != nullptr)
        added->type_name(rangeName(option.limit->limits));
    if (option.kind == ReadingOption::Kind::Path) added->type_name("FILE");
    if (option.kind == ReadingOption::Kind::Name) added->type_name("NAME");
    added->group(group);
}

} // namespace

void addReadFlags(CLI::App& command, ReadFlags& flags) {
    for (const ReadingOption& option : readingOptionTable()) {
        if ((option.uses & ReadingOption::kFlag) != 0 && option.kind != ReadingOption::Kind::Path)
            addReadingFlag(command, option, flags.options, "Reading");
    }
    command.add_flag("--progress", flags.progress, "Show the progress on stderr, also where that is not a terminal")->group("Reading");
    addPlaceFlags(command, flags.options);
}

void addPlaceFlags(CLI::App& command, ReadingOptions& options) {
    for (const ReadingOption& option : readingOptionTable()) {
        if (option.kind == ReadingOption::Kind::Path)
            addReadingFlag(command, option, options, "Place in the mine (docs/reference/coordinates.md)");
    }
}

void addPosesFlag(CLI::App& command, std::vector<std::string>& poses) {
    command
        .add_option("--poses-3dtk", poses,
                    "The .pose files of 3DTK of both scans, in their order; without them the scans are placed by their places in the mine")
        ->expected(2)
        ->type_name("FILE");
}

void addWriteFlags(CLI::App& command, WriteFlags& flags) {
    const char* group = "Writing";
    command
        .add_option("--frame", flags.frame,
                    "Coordinates of clouds: mine (Easting, Northing, RL), local (metres from an origin in the header), scanner, "
                    "or auto: mine if the scan has a place, else scanner")
        ->check(CLI::IsMember({"auto", "scanner", "local", "mine"}))
        ->group(group);
    command.add_flag("--ascii", flags.ascii, "PCD and PLY as text")->group(group);
    command
        .add_flag("--include-attached", flags.includeAttached,
                  "Of a cloud that was projected: also the points behind the nearest of their cell")
        ->group(group);
    for (const files::WritingChoice& choice : files::kWritingChoices)
        command.add_flag(std::string("--") + choice.key, flags.choices.*choice.member, choice.help)->group(group);
    command.add_option("--operator", flags.operatorName, "Name of the operator, stored in the record")->type_name("NAME")->group(group);
    command.add_option("--role", flags.role, "Role of the operator, stored in the record")->type_name("NAME")->group(group);
}

void warnOfIdleWriting(const WriteFlags& flags, const Scan& scan) {
    if (flags.includeAttached && scan.attached.empty())
        printError(printable(scan.name) + ": --include-attached has no effect: no cell of the scan has several points; leave it out.");
    if (flags.choices.doubles && exportOptions(flags, scan).frame != CoordinateFrame::Mine)
        printError(printable(scan.name) + ": --doubles has no effect: the coordinates are not those of the mine; leave it out.");
}

ReadingOptions readingOptions(const ReadFlags& flags) {
    ReadingOptions options = flags.options;
    if (flags.progress || isatty(STDERR_FILENO) != 0) options.progress = showStage;
    return options;
}

Result<Done> checkOnePose(const std::vector<std::string>& files, const ReadFlags& flags) {
    if (files.size() < 2 || flags.options.pose.empty()) return Done{};
    return Error{"one pose file cannot be that of several scans", "--pose", "give one scan, or call each pose SCAN.EXT.pose.json"};
}

Result<Scan> openAndWarn(const std::string& file, const ReadFlags& flags) {
    Result<Scan> scan = files::openAsAsked(file, readingOptions(flags));
    if (!scan) {
        Error error = scan.error();
        if (error.where.starts_with("--")) error.where.insert(0, printable(file) + ": ");
        return error;
    }
    for (const auto& sentences : {scan->warnings, placeWarnings(*scan)}) {
        for (const std::string& sentence : sentences) printError(printable(file) + ": " + sentence);
    }
    return scan;
}

Result<Done> checkMethodAndWarn(const MethodFlags& flags) {
    auto checked = checkMethod(flags);
    for (const std::string& note : checked ? methodNotes(flags) : std::vector<std::string>()) printError(note);
    return checked;
}

void addMethodFlags(CLI::App& command, MethodFlags& flags) {
    const char* group = "Method";
    std::string names;
    for (const edges::Preset& preset : edges::builtInPresets()) names += (names.empty() ? "" : "|") + preset.name;
    command
        .add_option("--preset", flags.preset,
                    "Settings to start from: " + names +
                        " or a preset file; without one, default, or log where flags of gray levels are given")
        ->type_name("NAME")
        ->group(group);
    flags = noFlags();
    for (const edges::Parameter& p : edges::parameters()) {
        const std::string older = p.name != nullptr ? std::string(",--") + p.key : std::string();
        command.add_option(edges::flagOf(p) + older, flags.typed[p.key], hint(p))->group(group);
    }
}

} // namespace edgescan::cli
