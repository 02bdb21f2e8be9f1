// Writes the command line that computes the same edges.
#include "core/edges/settings/command_text.h"

#include "core/base/shell_quoted.h"
#include "core/edges/settings/parameters.h"
#include "core/edges/settings/presets.h"

#include <vector>

namespace edgescan::edges {
namespace {

std::vector<std::string> differences(const Settings& from, const Settings& to) {
    std::vector<std::string> flags;
    for (const Parameter& p : parameters()) {
        if (!p.usedBy(to)) continue; // it would be refused
        const std::string value = formatValue(p, p.get(to));
        if (formatValue(p, p.get(from)) != value) flags.push_back(std::string("--") + p.key + " " + value);
    }
    return flags;
}

} // namespace

std::string settingsFlags(const Settings& settings) {
    const auto presets = builtInPresets();
    std::string nearest = presets.front().name;
    std::vector<std::string> fewest = differences(presets.front().settings, settings);
    for (const Preset& preset : presets.subspan(1)) {
        std::vector<std::string> flags = differences(preset.settings, settings);
        if (flags.size() >= fewest.size()) continue;
        nearest = preset.name;
        fewest = std::move(flags);
    }
    std::string text = "--preset " + nearest;
    for (const std::string& flag : fewest) text += " " + flag;
    return text;
}

std::string detectCommand(const std::string& program, const std::string& path, const std::string& readFlags, const Settings& settings) {
    return program + " detect " + shellQuoted(path) + (readFlags.empty() ? "" : " " + readFlags) + " " + settingsFlags(settings) +
           " --json -";
}

} // namespace edgescan::edges
