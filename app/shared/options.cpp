// Flags that several commands share.
#include "app/shared/options.h"

#include "core/base/number_text.h"
#include "core/method/step_meaning.h"
#include "core/settings/parameters.h"
#include "core/settings/presets.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <memory>

namespace edgescan::cli {
namespace {

const std::string kNotTyped = "\n"; // no flag can hold it
const std::string kLower = "lower";

// The limits and the default, for --help: "x, 1 to 10, default 3".
std::string hint(const Parameter& p) {
    std::string text = p.help;
    if (p.key == kLower) text += " A depth (0.5m), or with logarithmic gray levels a share of the range (5%), is turned into levels.";
    text += " [";
    if (p.choices.empty()) {
        if (*p.unit != '\0') text += std::string(p.unit) + ", ";
        text += shortestText(p.minimum) + " to " + shortestText(p.maximum);
        if (p.automatic != nullptr) text += " or auto";
    } else {
        for (const Choice& choice : p.choices) text += (&choice == &p.choices.front() ? "" : "|") + std::string(choice.name);
    }
    return text + "; default " + formatValue(p, p.get(Settings{})) + "]";
}

std::atomic<bool> progressLineOpen{false}; // an error must start on a line of its own

// One line per stage on stderr, redrawn in place.
bool tellProgress(const char* stage, double fraction) {
    std::fprintf(stderr, "\r%-24s %3.0f %%", stage, fraction * 100);
    progressLineOpen = fraction < 1.0;
    if (!progressLineOpen) std::fputc('\n', stderr);
    return true;
}

} // namespace

namespace {

void addReadingFlag(CLI::App& command, const ReadingOption& option, ReadingOptions& options, const char* group) {
    const std::string name = std::string("--") + option.key;
    const auto take = [&option, &options](const std::string& text) {
        if (const auto fits = checked(option, text); !fits) throw CLI::ValidationError(fits.error().where, fits.error().what);
        option.set(options, text);
    };
    CLI::Option* added = nullptr;
    if (option.kind == ReadingOption::Kind::Switch)
        added = command.add_flag_function(
            name, [take](std::int64_t) { take("on"); }, option.help);
    else if (option.kind == ReadingOption::Kind::ThreeNumbers)
        added = command
                    .add_option_function<std::vector<std::string>>(
                        name, [take](const std::vector<std::string>& xyz) { take(CLI::detail::join(xyz, ",")); }, option.help)
                    ->delimiter(',')
                    ->expected(3);
    else
        added = command.add_option_function<std::string>(name, take, option.help);
    if (!option.words.empty()) added->check(CLI::IsMember(option.words));
    if (option.kind == ReadingOption::Kind::Number || option.kind == ReadingOption::Kind::ThreeNumbers) added->type_name("NUMBER");
    added->group(group);
}

} // namespace

void addReadFlags(CLI::App& command, ReadFlags& flags) {
    for (const ReadingOption& option : readingOptionTable()) {
        if ((option.uses & ReadingOption::kFlag) != 0 && option.kind != ReadingOption::Kind::Path)
            addReadingFlag(command, option, flags.options, "Reading");
    }
    command.add_flag("--progress", flags.progress, "Tell the progress on stderr also where that is no terminal")->group("Reading");
    addPlaceFlags(command, flags.options);
}

void addPlaceFlags(CLI::App& command, ReadingOptions& options) {
    for (const ReadingOption& option : readingOptionTable()) {
        if (option.kind == ReadingOption::Kind::Path) addReadingFlag(command, option, options, "Place in the mine (docs/coordinates.md)");
    }
}

void addWriteFlags(CLI::App& command, WriteFlags& flags) {
    const char* group = "Writing";
    command
        .add_option("--frame", flags.frame,
                    "Coordinates of clouds: mine (Easting, Northing, Elevation), local (metres from an origin in the header), scanner, "
                    "or auto: the usual one")
        ->check(CLI::IsMember({"auto", "scanner", "local", "mine"}))
        ->group(group);
    command.add_flag("--ascii", flags.ascii, "PCD and PLY as text")->group(group);
    command
        .add_flag("--include-attached", flags.includeAttached,
                  "Of a cloud that was projected: also the points that lie behind the nearest of their cell")
        ->group(group);
    command.add_option("--operator", flags.operatorName, "Who exports, for the record")->group(group);
    command.add_option("--role", flags.role, "As what, for the record")->group(group);
}

ExportOptions exportOptions(const WriteFlags& flags, CoordinateFrame usual) {
    ExportOptions options;
    options.frame = flags.frame == "scanner" ? CoordinateFrame::Scanner
                    : flags.frame == "local" ? CoordinateFrame::MineLocal
                    : flags.frame == "mine"  ? CoordinateFrame::Mine
                                             : usual;
    options.ascii = flags.ascii;
    options.includeAttached = flags.includeAttached;
    options.operatorName = flags.operatorName;
    options.role = flags.role;
    return options;
}

ReadingOptions readingOptions(const ReadFlags& flags) {
    ReadingOptions options = flags.options;
    if (flags.progress || isatty(STDERR_FILENO) != 0) options.progress = tellProgress;
    return options;
}

void addMethodFlags(CLI::App& command, MethodFlags& flags) {
    const char* group = "Method";
    std::string names;
    for (const Preset& preset : builtInPresets()) names += (names.empty() ? "" : "|") + preset.name;
    command
        .add_option("--preset", flags.preset,
                    "Settings to start from: " + names +
                        " or a preset file; without one, default, or log where flags of gray levels are given")
        ->group(group);
    for (const Parameter& p : parameters()) {
        flags.typed[p.key] = kNotTyped;
        command.add_option(std::string("--") + p.key, flags.typed[p.key], hint(p))->group(group);
    }
}

bool anyTyped(const MethodFlags& flags) {
    if (!flags.preset.empty()) return true;
    return std::ranges::any_of(flags.typed, [](const auto& flag) { return flag.second != kNotTyped; });
}

Result<Preset> presetOf(const MethodFlags& flags) {
    if (!flags.preset.empty()) return findPreset(flags.preset);
    // Flags of gray levels alone ask for Canny on them: a threshold that somebody types must do something.
    const bool gray = flags.typed.at("method") == kNotTyped && std::ranges::any_of(flags.typed, [](const auto& flag) {
                          const Parameter& parameter = *findParameter(flag.first);
                          return flag.second != kNotTyped && !parameter.usedBy(Settings{}) && parameter.usedBy(cannySettings());
                      });
    return findPreset(gray ? "log" : builtInPresets().front().name);
}

namespace {

// All that can be known without a scan: a lower threshold typed as a depth is left as it is.
Result<Settings> settingsBut(const MethodFlags& flags) {
    const Result<Preset> preset = presetOf(flags);
    if (!preset) return preset.error();
    Settings settings = preset->settings;
    for (const auto& [key, text] : flags.typed) {
        if (text == kNotTyped) continue;
        if (key == kLower && typedStep(text)) continue;
        const Parameter& parameter = *findParameter(key);
        const Result<double> value = parseValue(parameter, text);
        if (!value) return value.error();
        parameter.set(settings, *value);
    }
    if (flags.typed.at(kLower) == kNotTyped) {
        Settings before = preset->settings;
        if (stepGain(before).straight <= 0) before = cannySettings();
        settings.lower = lowerWithSameStep(before, settings);
    }
    if (const auto checked = checkSettings(settings); !checked) return checked.error();
    // Who names a method or a preset may type every parameter there is; who does not should hear that a flag changes nothing.
    const bool chosen = !flags.preset.empty() || flags.typed.at("method") != kNotTyped;
    for (const auto& [key, text] : flags.typed) {
        if (chosen || text == kNotTyped || findParameter(key)->usedBy(settings)) continue;
        const Parameter& method = *findParameter("method");
        return Error{"the method " + formatValue(method, method.get(settings)) + " takes no notice of this flag", "--" + key,
                     "leave it out, or name a --method or --preset that uses it"};
    }
    return settings;
}

} // namespace

Result<Settings> settingsOf(const MethodFlags& flags) {
    if (typedStep(flags.typed.at(kLower)))
        return Error{"a depth becomes a threshold only once there is a scan", "--lower", "give the threshold in gray levels here"};
    return settingsBut(flags);
}

Result<Done> checkMethod(const MethodFlags& flags) {
    const Result<Settings> settings = settingsBut(flags);
    if (!settings) return settings.error();
    return Done{};
}

Result<Settings> settingsFor(const MethodFlags& flags, const Scan& scan) {
    Result<Settings> settings = settingsBut(flags);
    const auto step = typedStep(flags.typed.at(kLower));
    if (!settings || !step) return settings;
    const Result<double> lower = lowerOfStep(*step, *settings, grayScale(scan, *settings));
    if (!lower) return lower.error();
    settings->lower = *lower;
    return settings;
}

void complain(const Error& error) {
    if (progressLineOpen) std::cerr << '\n';
    progressLineOpen = false;
    std::cerr << "edgescan-cli: " << error.sentence() << '\n';
}

} // namespace edgescan::cli
