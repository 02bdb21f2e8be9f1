// Turns typed texts into settings and options.
#include "app/shared/typed_settings.h"

#include "core/base/inputs.h"
#include "core/base/number_text.h"
#include "core/base/shell_quoted.h"
#include "core/edges/gray/gray.h"
#include "core/edges/pipeline/step_meaning.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"
#include "core/files/formats/formats.h"
#include "core/files/open_save/save_scan.h"

#include <algorithm>
#include <optional>

namespace edgescan::cli {
namespace {

const std::string kLower = "lower";

} // namespace

MethodFlags noFlags() {
    MethodFlags flags;
    for (const edges::Parameter& p : edges::parameters()) flags.typed[p.key] = kNotTyped;
    return flags;
}

bool anyTyped(const MethodFlags& flags) {
    if (!flags.preset.empty()) return true;
    return std::ranges::any_of(flags.typed, [](const auto& flag) { return flag.second != kNotTyped; });
}

std::string typedFlags(const MethodFlags& flags) {
    std::string text = flags.preset.empty() ? "" : "--preset " + shellQuoted(flags.preset);
    for (const edges::Parameter& p : edges::parameters()) {
        const std::string& value = flags.typed.at(p.key);
        if (value != kNotTyped) text += (text.empty() ? "" : " ") + edges::flagOf(p) + " " + shellQuoted(value);
    }
    return text;
}

namespace {

/// A typed flag of gray levels, where no method and no preset is: it selects Canny, because otherwise it would have no effect.
const edges::Parameter* grayFlag(const MethodFlags& flags) {
    if (!flags.preset.empty() || flags.typed.at("method") != kNotTyped) return nullptr;
    const auto found = std::ranges::find_if(edges::parameters(), [&](const edges::Parameter& p) {
        return flags.typed.at(p.key) != kNotTyped && !p.usedBy(edges::Settings{}) && p.usedBy(edges::cannySettings());
    });
    return found == edges::parameters().end() ? nullptr : &*found;
}

} // namespace

Result<edges::Preset> presetOf(const MethodFlags& flags) {
    if (!flags.preset.empty()) return edges::findPreset(flags.preset);
    return edges::findPreset(grayFlag(flags) != nullptr ? "log" : edges::builtInPresets().front().name);
}

namespace {

/// The flag of the same method with which it would use `parameter`: "--rock-borders on"; empty: there is none.
std::string neededFor(const edges::Parameter& parameter, const edges::Settings& settings) {
    for (const edges::Parameter& other : edges::parameters()) {
        if (std::string_view(other.key) == "method" || &other == &parameter || !other.usedBy(settings)) continue;
        std::vector<double> values; // the smallest choice that will do
        for (const edges::Choice& choice : other.choices) values.push_back(choice.value);
        values.insert(values.end(), {1.0, other.minimum, other.maximum});
        for (const double value : values) {
            edges::Settings tried = settings;
            other.set(tried, std::clamp(value, other.minimum, other.maximum));
            if (parameter.usedBy(tried)) return edges::flagOf(other) + " " + edges::formatValue(other, other.get(tried));
        }
    }
    return {};
}

// All settings that need no scan. A lower threshold typed as a depth is not converted here.
Result<edges::Settings> settingsBut(const MethodFlags& flags) {
    const Result<edges::Preset> preset = presetOf(flags);
    if (!preset) return preset.error();
    edges::Settings settings = preset->settings;
    for (const auto& [key, text] : flags.typed) {
        if (text == kNotTyped) continue;
        if (key == kLower && edges::typedStep(text)) continue;
        const edges::Parameter& parameter = *edges::findParameter(key);
        const Result<double> value = edges::parseValue(parameter, text);
        if (!value) return value.error();
        parameter.set(settings, *value);
    }
    if (flags.typed.at(kLower) == kNotTyped) {
        edges::Settings before = preset->settings;
        if (edges::stepGain(before).straight <= 0) before = edges::cannySettings();
        settings.lower = edges::lowerWithSameStep(before, settings);
    }
    if (const auto checked = edges::checkSettings(settings); !checked) return checked.error();
    for (const auto& [key, text] : flags.typed) {
        const edges::Parameter& parameter = *edges::findParameter(key);
        if (text == kNotTyped || parameter.usedBy(settings)) continue;
        const edges::Parameter& method = *edges::findParameter("method");
        const std::string needed = neededFor(parameter, settings);
        const edges::Parameter* gray = grayFlag(flags);
        return Error{"the method " + edges::formatValue(method, method.get(settings)) +
                         (gray != nullptr ? ", which " + edges::flagOf(*gray) + " chooses," : "") + " does not use this flag" +
                         (needed.empty() ? "" : " with the other settings"),
                     edges::flagOf(parameter),
                     "leave it out, or " + (needed.empty() ? "name a --method or --preset that uses it" : "give " + needed + " too")};
    }
    return settings;
}

} // namespace

Result<edges::Settings> settingsOf(const MethodFlags& flags) {
    if (edges::typedStep(flags.typed.at(kLower)))
        return Error{"a depth becomes a threshold only once there is a scan", "--lower", "give the threshold in gray levels here"};
    return settingsBut(flags);
}

Result<Done> checkMethod(const MethodFlags& flags) {
    claimInput(flags.preset); // if it is a file
    const Result<edges::Settings> settings = settingsBut(flags);
    if (!settings) return settings.error();
    const auto step = edges::typedStep(flags.typed.at(kLower));
    if (!step || !step->percent) return Done{};
    const edges::GrayScale usual{1000.0, 20000.0, settings->scaling == edges::Scaling::Log}; // whether a share is possible at all
    const Result<double> lower = edges::lowerOfStep(*step, *settings, usual);
    if (!lower) return lower.error();
    return Done{};
}

std::vector<std::string> methodNotes(const MethodFlags& flags) {
    const auto preset = presetOf(flags);
    const auto settings = settingsBut(flags);
    if (!preset || !settings) return {};
    const std::string method = edges::traitsOf(settings->method).key;
    std::vector<std::string> notes;
    if (const edges::Parameter* gray = grayFlag(flags))
        notes.push_back(edges::flagOf(*gray) + " is of gray levels: the method is " + method + "; give --method to choose.");
    edges::Settings kept = preset->settings; // by another method
    kept.method = settings->method;
    const bool nothingKept = std::ranges::all_of(edges::changedFromDefault(kept), [](const std::string& key) { return key == "method"; });
    if (nothingKept && preset->keys.empty() && preset->settings.method != settings->method && preset->settings != edges::Settings{})
        notes.push_back("--preset " + flags.preset + " has no effect: the method " + method + " uses no setting of it; leave one out.");
    if (preset->keys.empty()) return notes;
    if (std::ranges::find(preset->keys, "method") == preset->keys.end() && flags.typed.at("method") == kNotTyped)
        notes.push_back("--preset " + flags.preset + " names no method: it is " + method + "; give --method to choose.");
    std::string idle;
    for (const std::string& key : preset->keys) {
        if (!edges::findParameter(key)->usedBy(*settings)) idle += (idle.empty() ? "" : ", ") + key;
    }
    if (!idle.empty()) notes.push_back("--preset " + flags.preset + ": the method " + method + " does not use " + idle + ".");
    return notes;
}

Result<edges::Settings> settingsFor(const MethodFlags& flags, const Scan& scan) {
    Result<edges::Settings> settings = settingsBut(flags);
    const auto step = edges::typedStep(flags.typed.at(kLower));
    if (!settings || !step) return settings;
    const Result<double> lower = edges::lowerOfStep(*step, *settings, edges::grayScale(scan, *settings));
    if (!lower) return lower.error();
    settings->lower = *lower;
    return settings;
}

const char* idleWriting(const WriteFlags& flags, std::span<const WantedExport> wanted) {
    using Holds = exports::ExportKind::Holds;
    const auto changesNone = [&](const auto& changes) { return std::ranges::none_of(wanted, changes); };
    const auto extensionOf = [](const WantedExport& one) { return asciiLower(std::filesystem::path(one.path).extension().string()); };
    const auto holdsPoints = [](const WantedExport& one) {
        const files::Format* format = one.kind->holds == Holds::Scan ? files::writtenFormat(one.path) : nullptr;
        return one.kind->holds == Holds::Points || (format != nullptr && format->write != nullptr);
    };
    const auto isText = [&](const WantedExport& one) {
        return holdsPoints(one) && (extensionOf(one) == ".pcd" || extensionOf(one) == ".ply");
    };
    const auto holdsCoordinates = [&](const WantedExport& one) {
        using File = exports::ExportFile;
        if (one.kind->holds == Holds::Scan && !holdsPoints(one)) return false; // a grid or a recording holds ranges
        if (extensionOf(one).empty())                                          // standard output
            return std::ranges::any_of(one.kind->files, [](const File& file) { return file.coordinates != File::Coordinates::None; });
        return exports::frameOfFile(one.kind->content, one.path, {.frame = CoordinateFrame::Mine}).has_value();
    };
    if (flags.frame != "auto" && changesNone(holdsCoordinates)) return "frame";
    if (!flags.operatorName.empty() && wanted.empty()) return "operator";
    if (!flags.role.empty() && wanted.empty()) return "role";
    if (flags.ascii && changesNone(isText)) return "ascii";
    if (flags.includeAttached && changesNone(holdsPoints)) return "include-attached";
    for (const files::WritingChoice& choice : files::kWritingChoices) {
        const auto changes = [&](const WantedExport& one) {
            const bool hasEdges = one.kind->holds == Holds::Points || one.kind->holds == Holds::Shapes;
            return (hasEdges || (holdsPoints(one) && !choice.needsEdges)) && choice.changes(extensionOf(one));
        };
        if (flags.choices.*choice.member && changesNone(changes)) return choice.key;
    }
    return nullptr;
}

exports::ExportOptions exportOptions(const WriteFlags& flags, const Scan& scan, const std::filesystem::path& file) {
    exports::ExportOptions options;
    options.frame = flags.frame == "scanner" ? CoordinateFrame::Scanner
                    : flags.frame == "local" ? CoordinateFrame::MineLocal
                    : flags.frame == "mine"  ? CoordinateFrame::Mine
                                             : files::usualFrame(scan, file);
    options.ascii = flags.ascii;
    options.includeAttached = flags.includeAttached;
    options.choices = flags.choices;
    options.operatorName = flags.operatorName;
    options.role = flags.role;
    return options;
}

} // namespace edgescan::cli
